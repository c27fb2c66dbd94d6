// Choices: random bits to values, each monotonic in the bits.
//
// Narrowing a range therefore moves a value but keeps its quantile, and never draws it anew. One of several
// is drawn as a race (base/random.h) in which every candidate runs under a key of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.h"
#include "language/choices.h"
#include "language/value.h"

namespace filigree {

// The name that the k-th choice of an expression is drawn under: name, name~2, name~3, ...
std::string choice_name(std::string_view name, std::uint32_t k);

// Uniform in low..high, low <= high, high - low finite.
double draw_between(double low, double high, std::uint64_t bits);
// Uniform among the whole numbers low..high, both ends included; both must be whole, low <= high.
double draw_whole(double low, double high, std::uint64_t bits);
// The normal distribution restricted to low..high: its inverse distribution function over the share of it
// that lies inside. A range far from the mean gives its thin tail there. deviation >= 0; 0 gives the mean.
double draw_normal_between(double mean, double deviation, double low, double high, std::uint64_t bits);

// The share of the standard normal distribution below z; accurate relative to itself for z < 0.
double normal_share_below(double z);

// The keys that candidates race under. Words and texts run under their own name, so they can be reordered;
// all else under its place among what has no name. Repeats of a name are numbered.
std::vector<Key> candidate_keys(std::span<const Value> candidates);

// Of a whole domain, as a row holds it: a number, or the index of an alternative. One alternative must have a weight
// above zero.
double draw_from(const ChoiceDomain& domain, std::uint64_t seed, Key key, std::string_view name);
// Where nothing is random: the middle of a range (below it, where that is not whole), the mean, the first of the
// heaviest alternatives.
double middle_of(const ChoiceDomain& domain);
// The value as a row holds it, where it lies in the domain; none where it does not. A bare number counts in the
// domain's dimension. Among alternatives it is the one that is equal, else the first that is written alike.
std::optional<double> place_in(const ChoiceDomain& domain, const Value& value);

}  // namespace filigree
