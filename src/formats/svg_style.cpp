#include "formats/svg_style.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

#include "formats/svg_colour.h"
#include "formats/xml.h"

namespace filigree {
namespace {

constexpr std::array<std::pair<std::string_view, CssProperty>, css_property_count> property_names = {{
    {"fill", CssProperty::fill},
    {"fill-rule", CssProperty::fill_rule},
    {"stroke", CssProperty::stroke},
    {"stroke-width", CssProperty::stroke_width},
    {"color", CssProperty::colour},
    {"display", CssProperty::display},
    {"visibility", CssProperty::visibility},
    {"clip-path", CssProperty::clip_path},
    {"mask", CssProperty::mask},
    {"filter", CssProperty::filter},
    {"transform", CssProperty::transform},
}};

std::optional<CssProperty> property_named(std::string_view name) {
    for (const auto& [known, property] : property_names) {
        if (known == name) return property;
    }
    return std::nullopt;
}

// Where the first of `ends` stands outside of strings, brackets and what a backslash protects; the size for none.
std::size_t find_outside(std::string_view text, std::size_t from, std::string_view ends) {
    int depth = 0;
    for (std::size_t i = from; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\\') {
            ++i;
        } else if (c == '"' || c == '\'') {
            const std::size_t close = text.find(c, i + 1);
            if (close == std::string_view::npos) return text.size();
            i = close;
        } else if (depth == 0 && ends.find(c) != std::string_view::npos) {
            return i;
        } else if (c == '(' || c == '[') {
            ++depth;
        } else if ((c == ')' || c == ']') && depth > 0) {
            --depth;
        }
    }
    return text.size();
}

// One past the `}` that closes the block whose `{` stands at `open`.
std::size_t block_end(std::string_view text, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        i = find_outside(text, i, "{}");
        if (i == text.size()) break;
        depth += text[i] == '{' ? 1 : -1;
        if (depth == 0) return i + 1;
    }
    return text.size();
}

// Comments become a space each; the marks that hide a sheet from very old browsers go too.
std::string without_comments(std::string_view css) {
    std::string out;
    out.reserve(css.size());
    for (std::size_t i = 0; i < css.size();) {
        const std::string_view rest = css.substr(i);
        if (rest.starts_with("/*")) {
            const std::size_t end = css.find("*/", i + 2);
            i = end == std::string_view::npos ? css.size() : end + 2;
            out += ' ';
        } else if (rest.starts_with("<!--") || rest.starts_with("-->")) {
            i += rest[0] == '<' ? 4 : 3;
        } else if (css[i] == '"' || css[i] == '\'') {
            const std::size_t end = std::min(css.find(css[i], i + 1), css.size() - 1);
            out += css.substr(i, end + 1 - i);
            i = end + 1;
        } else {
            out += css[i++];
        }
    }
    return out;
}

// Without white space and comments at its ends.
std::string_view bare(std::string_view text) {
    for (text = trimmed(text); text.starts_with("/*"); text = trimmed(text)) {
        const std::size_t end = text.find("*/", 2);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    }
    while (text.ends_with("*/") && text.rfind("/*") != std::string_view::npos) {
        text = trimmed(text.substr(0, text.rfind("/*")));
    }
    return text;
}

bool is_name_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> found;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::size_t end = std::min(text.find_first_of(" \t\n\r\f"), text.size());
        found.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return found;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

// `current` is what currentColor stands for. What CSS does not know is as if it were not said.
std::optional<Colour> stroke_said(std::string_view value, const std::optional<Colour>& parent, Colour current) {
    const std::string stroke = lower_case(value);
    if (stroke.empty()) return parent;
    if (stroke == "none" || stroke == "initial" || stroke == "transparent") return std::nullopt;
    if (stroke == "currentcolor") return current;
    if (stroke.starts_with("url(")) {
        const std::size_t close = stroke.find(')');
        const std::string beside = close == std::string::npos ? "" : stroke.substr(close + 1);
        return parse_css_colour(beside).value_or(Colour{});
    }
    const std::optional<Colour> colour = parse_css_colour(stroke);
    if (colour && colour->alpha == 0) return std::nullopt;
    return colour ? colour : parent;
}

}  // namespace

void CssSheets::parse_declarations(std::string_view text, std::vector<Declaration>& to) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = find_outside(text, at, ";");
        const std::string_view one = text.substr(at, end - at);
        at = end + 1;
        const std::size_t colon = one.find(':');
        if (colon == std::string_view::npos) continue;
        const std::optional<CssProperty> property = property_named(lower_case(bare(one.substr(0, colon))));
        if (!property) continue;
        std::string_view value = bare(one.substr(colon + 1));
        bool is_important = false;
        if (const std::size_t mark = value.rfind('!');
            mark != std::string_view::npos && lower_case(trimmed(value.substr(mark + 1))) == "important") {
            is_important = true;
            value = trimmed(value.substr(0, mark));
        }
        if (!value.empty()) to.push_back({*property, value, is_important});
    }
}

void CssSheets::leave_out(std::string_view what, std::vector<std::string>& to) {
    std::string text(trimmed(what).substr(0, 80));
    if (std::find(to.begin(), to.end(), text) == to.end() && to.size() < 20) to.push_back(std::move(text));
}

void CssSheets::add(std::string css) {
    texts_.push_back(without_comments(css));
    const std::string_view text = texts_.back();
    for (std::size_t at = 0; at < text.size();) {
        at = std::min(text.find_first_not_of(" \t\n\r\f;}", at), text.size());
        if (at == text.size()) break;
        if (text[at] == '@') {
            const std::size_t end = find_outside(text, at, "{;");
            const std::string_view head = text.substr(at, end - at);
            // These never decide which shapes there are.
            const bool is_harmless = head.starts_with("@font-face") || head.starts_with("@charset") ||
                                     head.starts_with("@namespace") || head.starts_with("@keyframes");
            if (!is_harmless) leave_out(head, left_out_);
            at = end < text.size() && text[end] == '{' ? block_end(text, end) : end + 1;
            continue;
        }
        const std::size_t open = find_outside(text, at, "{");
        if (open == text.size()) break;
        const std::size_t end = block_end(text, open);
        const bool is_closed = text[end - 1] == '}' && end - 1 > open;
        add_rule(text.substr(at, open - at), text.substr(open + 1, end - open - 1 - (is_closed ? 1 : 0)));
        at = end;
    }
}

void CssSheets::add_rule(std::string_view selectors, std::string_view declarations) {
    const auto first = static_cast<std::uint32_t>(declarations_.size());
    parse_declarations(declarations, declarations_);
    const auto end = static_cast<std::uint32_t>(declarations_.size());
    if (first == end) return;
    const bool is_of_strokes =
        std::all_of(declarations_.begin() + first, declarations_.end(), [](const Declaration& declaration) {
            return declaration.property == CssProperty::stroke || declaration.property == CssProperty::stroke_width ||
                   declaration.property == CssProperty::colour;
        });
    for (std::size_t at = 0; at <= selectors.size();) {
        const std::size_t comma = find_outside(selectors, at, ",");
        const std::string_view selector = trimmed(selectors.substr(at, comma - at));
        at = comma + 1;

        Rule rule{{}, {}, {}, first, end};
        bool is_understood = !selector.empty();
        std::size_t i = 0;
        const auto take_name = [&] {
            const std::size_t begin = i;
            while (i < selector.size() && is_name_character(selector[i])) ++i;
            return selector.substr(begin, i - begin);
        };
        if (selector.starts_with('*')) {
            i = 1;
        } else {
            rule.type = take_name();
        }
        while (is_understood && i < selector.size()) {
            const char kind = selector[i++];
            const std::string_view name = take_name();
            is_understood = !name.empty() && (kind == '.' || kind == '#');
            (kind == '.' ? rule.classes : rule.ids).push_back(name);
        }
        if (!is_understood) {
            leave_out(selector, is_of_strokes ? strokes_left_out_ : left_out_);
            continue;
        }
        const auto index = static_cast<std::uint32_t>(rules_.size());
        if (!rule.ids.empty()) {
            by_id_[rule.ids[0]].push_back(index);
        } else if (!rule.classes.empty()) {
            by_class_[rule.classes[0]].push_back(index);
        } else if (!rule.type.empty()) {
            by_type_[rule.type].push_back(index);
        } else {
            of_all_.push_back(index);
        }
        rules_.push_back(std::move(rule));
    }
}

bool CssSheets::matches(const Rule& rule, pugi::xml_node element, const std::vector<std::string_view>& classes) const {
    if (!rule.type.empty() && rule.type != local_name(element.name())) return false;
    for (const std::string_view id : rule.ids) {
        if (id != element.attribute("id").value()) return false;
    }
    return std::all_of(rule.classes.begin(), rule.classes.end(), [&](std::string_view name) {
        return std::find(classes.begin(), classes.end(), name) != classes.end();
    });
}

CssValues CssSheets::values_at(pugi::xml_node element) const {
    // How strongly a value is said: importance, then attribute, sheet or style="", then specificity, then order.
    using Strength = std::tuple<bool, int, std::size_t, std::size_t, bool, std::uint32_t>;
    CssValues values;
    std::array<Strength, css_property_count> strengths{};
    const auto say = [&](const Declaration& declaration, const Strength& strength) {
        const auto p = static_cast<std::size_t>(declaration.property);
        if (strength < strengths[p]) return;
        strengths[p] = strength;
        values.of[p] = declaration.value;
    };

    for (const auto& [name, property] : property_names) {
        if (property == CssProperty::transform) continue;  // the attribute is no presentation of the CSS kind
        const std::string_view value = trimmed(element.attribute(name.data()).value());
        if (!value.empty()) say({property, value, false}, {false, 0, 0, 0, false, 0});
    }
    if (!rules_.empty()) {
        const std::vector<std::string_view> classes = words(element.attribute("class").value());
        const auto say_rules = [&](const std::vector<std::uint32_t>& rules) {
            for (const std::uint32_t r : rules) {
                const Rule& rule = rules_[r];
                if (!matches(rule, element, classes)) continue;
                for (std::uint32_t d = rule.first_declaration; d < rule.end_declaration; ++d) {
                    say(declarations_[d], {declarations_[d].is_important, 1, rule.ids.size(), rule.classes.size(),
                                           !rule.type.empty(), r});
                }
            }
        };
        const auto say_named = [&](const RulesByName& rules, std::string_view name) {
            if (const auto found = rules.find(name); found != rules.end()) say_rules(found->second);
        };
        say_rules(of_all_);
        say_named(by_type_, local_name(element.name()));
        for (const std::string_view name : classes) say_named(by_class_, name);
        say_named(by_id_, element.attribute("id").value());
    }
    if (const std::string_view style = element.attribute("style").value(); !style.empty()) {
        std::vector<Declaration> own;
        parse_declarations(style, own);
        for (const Declaration& declaration : own) say(declaration, {declaration.is_important, 2, 0, 0, false, 0});
    }
    return values;
}

SvgPaint inherited(const SvgPaint& parent, const CssValues& said) {
    SvgPaint paint = parent;
    if (const std::string fill = lower_case(said[CssProperty::fill]); fill == "initial") {
        paint.filled = true;
    } else if (!fill.empty() && fill != "inherit" && fill != "unset") {
        paint.filled = fill != "none" && fill != "transparent";
    }
    const std::string rule = lower_case(said[CssProperty::fill_rule]);
    if (rule == "evenodd") paint.fill_rule = FillRule::even_odd;
    if (rule == "nonzero" || rule == "initial") paint.fill_rule = FillRule::nonzero;
    if (const auto colour = parse_css_colour(said[CssProperty::colour])) paint.current = *colour;
    paint.stroke = stroke_said(said[CssProperty::stroke], parent.stroke, paint.current);
    if (const std::string_view width = said[CssProperty::stroke_width]; width == "initial") {
        paint.stroke_width = {1, false};
    } else if (const auto wide = parse_length(width); wide && wide->value >= 0) {
        paint.stroke_width = *wide;
    }
    const std::string visibility = lower_case(said[CssProperty::visibility]);
    if (visibility == "hidden" || visibility == "collapse") paint.visible = false;
    if (visibility == "visible" || visibility == "initial") paint.visible = true;
    return paint;
}

bool is_displayed(const CssValues& said) { return lower_case(said[CssProperty::display]) != "none"; }

}  // namespace filigree
