#include "language/page_sizes.h"

namespace filigree {

namespace {

constexpr PageSize sizes[] = {
    {"a0", 841, 1189}, {"a1", 594, 841}, {"a2", 420, 594},         {"a3", 297, 420},        {"a4", 210, 297},
    {"a5", 148, 210},  {"a6", 105, 148}, {"letter", 215.9, 279.4}, {"legal", 215.9, 355.6}, {"tabloid", 279.4, 431.8},
};

}  // namespace

const PageSize* find_page_size(std::string_view name) {
    for (const PageSize& size : sizes) {
        if (size.name == name) return &size;
    }
    return nullptr;
}

std::vector<std::string_view> page_size_names() {
    std::vector<std::string_view> names;
    for (const PageSize& size : sizes) names.push_back(size.name);
    return names;
}

}  // namespace filigree
