// Sizes of paper by name, upright.
#pragma once

#include <string_view>
#include <vector>

namespace filigree {

struct PageSize {
    std::string_view name;
    double width_mm = 0, height_mm = 0;
};
const PageSize* find_page_size(std::string_view name);  // null where there is none
std::vector<std::string_view> page_size_names();

}  // namespace filigree
