// The runs of a line of text: stretches of one script and direction, in the order in which they are drawn.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <hb.h>

namespace filigree {

struct TextRun {
    std::size_t begin = 0, end = 0;  // bytes of the line
    hb_script_t script = HB_SCRIPT_COMMON;
    bool is_right_to_left = false;
};

// From left to right, by the Unicode bidirectional algorithm. The line is valid UTF-8. A character that belongs to
// no script goes with the one before it; at the start of a line, with the first that does belong to one.
std::vector<TextRun> text_runs(std::string_view line);

}  // namespace filigree
