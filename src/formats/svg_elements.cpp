#include "formats/svg_elements.h"

#include <algorithm>
#include <cstddef>

#include "formats/svg_values.h"
#include "formats/xml.h"

namespace filigree {

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_container(std::string_view name) { return name == "g" || name == "a"; }

bool is_passive(std::string_view name) {
    return is_one_of(name, {"defs",           "symbol",
                            "metadata",       "title",
                            "desc",           "style",
                            "script",         "linearGradient",
                            "radialGradient", "meshgradient",
                            "pattern",        "hatch",
                            "marker",         "clipPath",
                            "mask",           "filter",
                            "font",           "font-face",
                            "cursor",         "view",
                            "color-profile",  "solidcolor",
                            "animate",        "set",
                            "animateMotion",  "animateTransform",
                            "animateColor",   "discard"});
}

bool is_text(std::string_view name) {
    return is_one_of(name, {"text", "tspan", "textPath", "tref", "flowRoot", "altGlyph"});
}

bool is_layer(pugi::xml_node element) {
    return std::string_view(element.attribute("inkscape:groupmode").value()) == "layer";
}

bool is_foreign_content(std::string_view name) {
    return is_one_of(name, {"image", "foreignObject", "video", "audio", "iframe", "canvas"});
}

bool names_svg(std::string_view uri) { return uri == svg_namespace || uri.empty() || uri.starts_with('&'); }

bool meets_conditions(pugi::xml_node element) {
    if (!element.attribute("requiredExtensions").empty()) return false;
    const pugi::xml_attribute language = element.attribute("systemLanguage");
    if (!language) return true;
    std::string_view rest = language.value();
    while (!rest.empty()) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        const std::string_view one = trimmed(rest.substr(0, comma));
        if (one == "en" || one.starts_with("en-")) return true;
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    return false;
}

std::string_view reference_of(pugi::xml_node element) {
    if (const pugi::xml_attribute href = element.attribute("href")) return trimmed(href.value());
    for (const pugi::xml_attribute attribute : element.attributes()) {
        if (local_name(attribute.name()) == "href") return trimmed(attribute.value());
    }
    return {};
}

std::vector<std::string> names_of_group(pugi::xml_node element) {
    const std::string id = element.attribute("id").value(), label = element.attribute("inkscape:label").value();
    std::vector<std::string> names;
    if (!label.empty() && (is_layer(element) || id.empty())) names.push_back(label);
    if (!id.empty() && id != label) names.push_back(id);
    return names;
}

}  // namespace filigree
