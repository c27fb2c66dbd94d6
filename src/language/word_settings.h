// What a rewriting document says of its words in one form, NAME and values; `mask`, `sleep` and `loop`
// begin with symbols instead.
// The closed table that the parser, its messages and the reference read.
#pragma once

#include <span>
#include <string_view>

namespace filigree {

struct WordSetting {
    std::string_view name;
    std::string_view example;  // as a document writes it
    std::string_view help;     // one line, lower case, no full stop
    bool is_of_drawing = false;
    bool is_map = false;         // of what pictures and tables say where a symbol stands
    bool is_of_systems = false;  // of drawing, but a subsystem may have its own
};

std::span<const WordSetting> word_settings();
const WordSetting* find_word_setting(std::string_view name);

}  // namespace filigree
