// For tests alone: how many random cases a property test runs.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "base/number_text.h"
#include "base/random.h"

namespace filigree {

// The environment variable FILIGREE_CASES where it is a number, else `normal`.
inline std::uint64_t case_count(std::uint64_t normal = 1000) {
    const char* const text = std::getenv("FILIGREE_CASES");
    if (text == nullptr) return normal;
    const auto count = parse_number(text);
    return count && *count >= 1 && *count < 1e12 ? static_cast<std::uint64_t>(*count) : normal;
}

// Random numbers for one case, one after another.
class CaseRandom {
public:
    explicit CaseRandom(std::uint64_t seed) : seed_(seed) {}

    std::uint64_t bits() { return random_bits(seed_, Key{}, std::uint64_t{0}, ++drawn_); }
    double between(double low, double high) { return low + (high - low) * to_unit(bits()); }
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(to_whole(bits(), count)); }

private:
    std::uint64_t seed_;
    std::uint64_t drawn_ = 0;
};

}  // namespace filigree
