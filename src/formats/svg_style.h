// The part of CSS that decides which shapes of an SVG are there and how they are filled and stroked.
//
// Understood: attributes, style="" and sheets whose selectors are compounds of a type or `*`, classes and ids,
// with specificity and `!important`. Other selectors and at-rules are left out and named.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/colour.h"
#include "formats/svg_values.h"
#include "plane/clean.h"

namespace filigree {

enum class CssProperty : std::uint8_t {
    fill,
    fill_rule,
    stroke,
    stroke_width,
    colour,
    display,
    visibility,
    clip_path,
    mask,
    filter,
    transform
};
constexpr std::size_t css_property_count = 11;

// The value of each property that is said at an element; empty where nothing is said.
struct CssValues {
    std::array<std::string_view, css_property_count> of{};

    std::string_view operator[](CssProperty property) const { return of[static_cast<std::size_t>(property)]; }
};

class CssSheets {
public:
    // Adds the rules of one <style>.
    void add(std::string css);

    // What attributes, sheets and style="" say together. The views live as long as the document and the sheets.
    CssValues values_at(pugi::xml_node element) const;

    // What was left out, as it stands in the sheets: selectors and at-rules, each once, in order. Selectors of rules
    // about nothing but strokes apart: to who only fills they mean nothing.
    const std::vector<std::string>& left_out() const { return left_out_; }
    const std::vector<std::string>& strokes_left_out() const { return strokes_left_out_; }
    std::size_t rule_count() const { return rules_.size(); }

private:
    struct Declaration {
        CssProperty property;
        std::string_view value;
        bool is_important;
    };
    struct Rule {
        std::string_view type;  // empty for any
        std::vector<std::string_view> classes, ids;
        std::uint32_t first_declaration, end_declaration;
    };
    using RulesByName = std::unordered_map<std::string_view, std::vector<std::uint32_t>>;

    void add_rule(std::string_view selector, std::string_view declarations);
    static void leave_out(std::string_view what, std::vector<std::string>& to);
    bool matches(const Rule& rule, pugi::xml_node element, const std::vector<std::string_view>& classes) const;
    static void parse_declarations(std::string_view text, std::vector<Declaration>& to);

    std::deque<std::string> texts_;  // what the views look into
    std::vector<Declaration> declarations_;
    std::vector<Rule> rules_;
    RulesByName by_id_, by_class_, by_type_;  // each rule once: by its most telling part
    std::vector<std::uint32_t> of_all_;
    std::vector<std::string> left_out_, strokes_left_out_;
};

// What a shape's painting comes to; all of it is inherited.
struct SvgPaint {
    bool filled = true;
    FillRule fill_rule = FillRule::nonzero;
    bool visible = true;
    std::optional<Colour> stroke;  // none where it is `none` or wholly transparent; of a gradient the colour beside it
    SvgLength stroke_width{1, false};
    Colour current;  // what `currentColor` stands for

    bool operator==(const SvgPaint&) const = default;
};
SvgPaint inherited(const SvgPaint& parent, const CssValues& said);
bool is_displayed(const CssValues& said);  // with all that is inside

}  // namespace filigree
