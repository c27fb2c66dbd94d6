// What SVG's elements are: which hold others, which are never drawn, under which conditions, what they are called.
#pragma once

#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace filigree {

constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";
// Whether a namespace is, or stands for, SVG's: missing ones too, and entities, which are never expanded here and
// by which some programs write it.
bool names_svg(std::string_view uri);

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names);
bool is_container(std::string_view local_name);  // g, a
bool is_passive(std::string_view local_name);    // never drawn where it stands, and nothing to warn of
bool is_text(std::string_view local_name);
bool is_layer(pugi::xml_node element);                 // of Inkscape
bool is_foreign_content(std::string_view local_name);  // pictures, films, other languages

// Whether requiredExtensions and systemLanguage let the element be drawn; English is what is read.
bool meets_conditions(pugi::xml_node element);

// The value of `href` in whatever namespace; empty for none.
std::string_view reference_of(pugi::xml_node element);

// An Inkscape layer: its label, then its id; any other group: its id, else its label.
std::vector<std::string> names_of_group(pugi::xml_node element);

}  // namespace filigree
