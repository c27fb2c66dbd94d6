// Addressed randomness: a random value is a hash of where and what it is for, never "the next number".
//
// Guarantee: the same (seed, key, name) gives the same value on every machine, in every order, on any
// thread; the only generator is `mix` (the finaliser of splitmix64). Nothing here is from std::'s
// distributions, which differ between standard libraries.
//
//   Key step = child(group_key, rule_key);
//   double width = 5 + 4 * to_unit(random_bits(seed, step, "width"));
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace filigree {

// Where in the derivation: a chain of hashes from the start downwards. Not dependent on the seed.
struct Key {
    std::uint64_t value = 0;

    auto operator<=>(const Key&) const = default;
};

constexpr std::uint64_t mix(std::uint64_t z) {
    z += 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
}

// One more field of an address: h' = mix(h ^ mix(field)).
constexpr std::uint64_t fold(std::uint64_t hash, std::uint64_t field) { return mix(hash ^ mix(field)); }

// A text as one field: its bytes eight at a time, then its length.
std::uint64_t hash_text(std::string_view text);

constexpr Key child(Key parent, std::uint64_t local) { return Key{fold(parent.value, local)}; }
inline Key child(Key parent, std::string_view local) { return child(parent, hash_text(local)); }

// 64 random bits at an address. `draw` numbers further values under the same name.
constexpr std::uint64_t random_bits(std::uint64_t seed, Key key, std::uint64_t name, std::uint64_t draw = 0) {
    return fold(fold(fold(seed, key.value), name), draw);
}
inline std::uint64_t random_bits(std::uint64_t seed, Key key, std::string_view name, std::uint64_t draw = 0) {
    return random_bits(seed, key, hash_text(name), draw);
}

// Bits to values. Each is monotonic in the bits, so narrowing a range moves a value without redrawing it.
constexpr double to_unit(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }  // in [0, 1)
constexpr std::uint64_t to_whole(std::uint64_t bits, std::uint32_t count) {                         // in [0, count)
    return ((bits >> 32) * count) >> 32;
}
double to_normal(std::uint64_t bits);  // standard normal by the inverse distribution; within about +-8.2, to 1e-13

// The race: each candidate runs with its own bits and the least time wins, so that one more candidate
// changes only the draws that it wins. -log(u) / weight with u in (0, 1]; infinite for weights <= 0.
double race_time(std::uint64_t bits, double weight);

// The winner of the race among candidates with their own keys and weights: its index, or candidates.size() where
// no weight is above zero. Each runs with the bits of its own key below `key`, so their order does not matter;
// equal times go to the earlier candidate.
std::size_t race(std::uint64_t seed, Key key, std::string_view name, std::span<const Key> candidates,
                 std::span<const double> weights);

// A uniform permutation of 0..count-1: indices ordered by their own addressed bits.
std::vector<std::uint32_t> permutation(std::uint64_t seed, Key key, std::string_view name, std::uint32_t count);

}  // namespace filigree
