// An SVG element's attributes as numbers, with diagnostics that name the element and point at the value.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/svg_values.h"
#include "formats/xml.h"
#include "plane/path.h"

namespace filigree {

// What a percentage is of: the viewport's width, its height, or its diagonal / sqrt 2.
enum class Axis { x, y, both };

class SvgAttributes {
public:
    SvgAttributes(const Xml& xml, pugi::xml_node element, Vec viewport)
        : xml_(xml), element_(element), viewport_(viewport) {}

    pugi::xml_node element() const { return element_; }
    Vec viewport() const { return viewport_; }
    double in_px(SvgLength length, Axis axis) const;
    bool has(const char* name) const { return !element_.attribute(name).empty(); }
    std::string_view text(const char* name) const { return element_.attribute(name).value(); }

    // px. None where the attribute is missing or `auto`, and, with a diagnostic, where it is no length.
    std::optional<double> length(const char* name, Axis axis);
    double length_or(const char* name, Axis axis, double otherwise) { return length(name, axis).value_or(otherwise); }
    // The first of a list of lengths, as texts have them; else as `length`.
    std::optional<double> first_length(const char* name, Axis axis);
    // A length that may not be below 0.
    std::optional<double> size(const char* name, Axis axis);
    std::vector<double> numbers(const char* name);  // empty, with a diagnostic, where it is no list of numbers
    Transform transform();                          // of the attribute of that name
    std::optional<ViewBox> view_box();
    AspectRatio aspect_ratio();
    Path path_data();  // of the attribute `d`

    // An error at an attribute's value: "the <what> of rect 'a' <wrong>".
    void refuse(const char* name, std::string code, std::string_view wrong);
    SourceSpan span(const char* name) const { return xml_.span_of(element_, element_.attribute(name)); }
    Diagnostics take_diagnostics() { return std::move(diagnostics_); }

private:
    std::optional<double> length_said(const char* name, std::string_view said, Axis axis);

    const Xml& xml_;
    pugi::xml_node element_;
    Vec viewport_;
    Diagnostics diagnostics_;
};

// "rect 'head'", or "rect" without an id.
std::string described(pugi::xml_node element);

}  // namespace filigree
