// What an SVG text says, and which of its elements places it.
#pragma once

#include <cstddef>
#include <pugixml.hpp>
#include <string>

namespace filigree {

struct SvgText {
    std::string
        content;  // of all its tspans; runs of white space, and the ends of lines, are one blank, none at the ends
    // Of the text and the tspans around its first letter the innermost that says where it is.
    pugi::xml_node placed_x, placed_y;
    std::size_t element_count = 0, byte_count = 0;  // what was read for it
};
SvgText read_text(pugi::xml_node text);

}  // namespace filigree
