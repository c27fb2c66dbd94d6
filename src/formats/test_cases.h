// For this layer's tests: how many random cases to run.
#pragma once

#include <cstdlib>

namespace filigree {

inline int case_count(int usual = 1000) {
    const char* wanted = std::getenv("FILIGREE_CASES");
    const int count = wanted == nullptr ? 0 : std::atoi(wanted);
    return count > 0 ? count : usual;
}

}  // namespace filigree
