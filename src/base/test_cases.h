// For tests alone: how many random cases a property test runs, and the random values of a case.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <type_traits>

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

// Where the seeds begin: FILIGREE_FIRST_SEED, so that long runs try others.
inline std::uint64_t first_seed() {
    const char* wanted = std::getenv("FILIGREE_FIRST_SEED");
    return wanted == nullptr ? 1 : std::strtoull(wanted, nullptr, 10);
}

// Random values for one case, one after another. The benchmark of insets records hashes of what these numbers give.
class CaseRandom {
public:
    explicit CaseRandom(std::uint64_t seed) : seed_(seed) {}

    std::uint64_t bits() { return random_bits(seed_, Key{7}, 11, drawn_++); }
    double unit() { return to_unit(bits()); }  // in [0, 1)
    double between(double low, double high) { return low + (high - low) * unit(); }
    bool coin() { return below(2) == 1; }
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(to_whole(bits(), count)); }
    std::size_t index(std::size_t count) { return static_cast<std::size_t>(bits() % count); }  // in [0, count)

    // In [low, high], both included; all but the whole range of 64 bits.
    template <std::integral Low, std::integral High>
    std::common_type_t<Low, High> whole(Low low, High high) {
        const std::uint64_t count = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
        return static_cast<std::common_type_t<Low, High>>(static_cast<std::uint64_t>(low) + bits() % count);
    }

private:
    std::uint64_t seed_;
    std::uint64_t drawn_ = 0;
};

}  // namespace filigree
