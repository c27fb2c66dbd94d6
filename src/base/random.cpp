#include "base/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/elementary.h"

namespace filigree {

std::uint64_t hash_text(std::string_view text) {
    std::uint64_t hash = 0;
    for (std::size_t i = 0; i < text.size(); i += 8) {
        const std::size_t count = std::min<std::size_t>(8, text.size() - i);
        std::uint64_t word = 0;  // little-endian on every machine
        for (std::size_t k = 0; k < count; ++k) {
            word |= static_cast<std::uint64_t>(static_cast<unsigned char>(text[i + k])) << (8 * k);
        }
        hash = fold(hash, word);
    }
    return fold(hash, text.size());
}

double race_time(std::uint64_t bits, double weight) {
    if (!(weight > 0)) return std::numeric_limits<double>::infinity();
    const double u = static_cast<double>((bits >> 11) + 1) * 0x1p-53;  // in (0, 1]
    return (0.0 - elementary::log(u)) / weight;
}

std::size_t race(std::uint64_t seed, Key key, std::string_view name, std::span<const Key> candidates,
                 std::span<const double> weights) {
    const std::uint64_t hashed_name = hash_text(name);
    std::size_t winner = candidates.size();
    double least = 0;
    for (std::size_t i = 0; i < candidates.size() && i < weights.size(); ++i) {
        if (!(weights[i] > 0)) continue;
        const double time = race_time(random_bits(seed, child(key, candidates[i].value), hashed_name), weights[i]);
        if (winner == candidates.size() || time < least) {
            winner = i;
            least = time;
        }
    }
    return winner;
}

std::vector<std::uint32_t> permutation(std::uint64_t seed, Key key, std::string_view name, std::uint32_t count) {
    const std::uint64_t hashed_name = hash_text(name);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> drawn(count);
    for (std::uint32_t i = 0; i < count; ++i) drawn[i] = {random_bits(seed, key, hashed_name, i), i};
    std::sort(drawn.begin(), drawn.end());
    std::vector<std::uint32_t> order(count);
    for (std::uint32_t i = 0; i < count; ++i) order[i] = drawn[i].second;
    return order;
}

}  // namespace filigree
