#include "formats/svg_attributes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace filigree {

std::string described(pugi::xml_node element) {
    std::string text(local_name(element.name()).substr(0, 60));
    if (const std::string_view id = element.attribute("id").value(); !id.empty()) {
        text += " '";
        text += id.substr(0, 60);
        text += "'";
    }
    return text;
}

void SvgAttributes::refuse(const char* name, std::string code, std::string_view wrong) {
    diagnostics_.push_back(error(std::move(code),
                                 "the " + std::string(name) + " of " + described(element_) + " " + std::string(wrong),
                                 span(name)));
}

double SvgAttributes::in_px(SvgLength length, Axis axis) const {
    if (!length.is_percentage) return length.value;
    const double whole = axis == Axis::x   ? viewport_.x
                         : axis == Axis::y ? viewport_.y
                                           : std::sqrt((viewport_.x * viewport_.x + viewport_.y * viewport_.y) / 2);
    return length.value / 100 * whole;
}

std::optional<double> SvgAttributes::length(const char* name, Axis axis) {
    return length_said(name, trimmed(text(name)), axis);
}

std::optional<double> SvgAttributes::first_length(const char* name, Axis axis) {
    const std::string_view all = trimmed(text(name));
    return length_said(name, all.substr(0, all.find_first_of(" \t\n\r\f,")), axis);
}

std::optional<double> SvgAttributes::length_said(const char* name, std::string_view said, Axis axis) {
    if (said.empty() || said == "auto") return std::nullopt;
    const std::optional<SvgLength> length = parse_length(said);
    if (!length) {
        refuse(name, "svg.bad-length", "is no length: '" + std::string(said.substr(0, 40)) + "'");
        return std::nullopt;
    }
    return in_px(*length, axis);
}

std::optional<double> SvgAttributes::size(const char* name, Axis axis) {
    const std::optional<double> value = length(name, axis);
    if (value && *value < 0) {
        refuse(name, "svg.negative-size", "is below 0");
        return std::nullopt;
    }
    return value;
}

std::vector<double> SvgAttributes::numbers(const char* name) {
    if (auto list = parse_number_list(text(name))) return *std::move(list);
    refuse(name, "svg.bad-number", "is no list of numbers");
    return {};
}

Transform SvgAttributes::transform() {
    if (!has("transform")) return {};
    if (const std::optional<Transform> transform = parse_transform_list(text("transform"))) return *transform;
    refuse("transform", "svg.bad-transform",
           "is no list of matrix, translate, scale, rotate, skewX and skewY with their numbers");
    return {};
}

std::optional<ViewBox> SvgAttributes::view_box() {
    if (!has("viewBox") || trimmed(text("viewBox")) == "none") return std::nullopt;
    std::optional<ViewBox> box = parse_view_box(text("viewBox"));
    if (!box) refuse("viewBox", "svg.bad-view-box", "is not four numbers with a width and height above 0");
    return box;
}

AspectRatio SvgAttributes::aspect_ratio() {
    if (!has("preserveAspectRatio")) return {};
    if (const std::optional<AspectRatio> ratio = parse_aspect_ratio(text("preserveAspectRatio"))) return *ratio;
    refuse("preserveAspectRatio", "svg.bad-aspect-ratio", "is not understood");
    return {};
}

Path SvgAttributes::path_data() {
    const std::string_view data = text("d");
    if (trimmed(data) == "none") return {};
    Result<Path> path = parse_path_data(data);
    if (path) return *std::move(path);
    for (Diagnostic reason : path.diagnostics()) {
        const SourceSpan all = span("d");
        reason.message = "in the path data of " + described(element_) + ": " + reason.message;
        if (all.begin + reason.span.begin <= all.end) {
            reason.span = {all.file, all.begin + reason.span.begin, std::min(all.begin + reason.span.end, all.end)};
        } else {
            reason.span = all;
        }
        diagnostics_.push_back(std::move(reason));
    }
    return {};
}

}  // namespace filigree
