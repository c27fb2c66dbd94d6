// What a shape grammar says as a whole in one form, NAME and values. The closed table that the parser, its messages
// and the reference read.
#pragma once

#include <span>
#include <string_view>

namespace filigree {

struct ShapeSetting {
    std::string_view name;
    std::string_view example;  // as a document writes it
    std::string_view help;     // one line, lower case, no full stop
    bool is_list = false;      // takes several values
};

std::span<const ShapeSetting> shape_settings();
const ShapeSetting* find_shape_setting(std::string_view name);

}  // namespace filigree
