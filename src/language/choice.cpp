#include "language/choice.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/elementary.h"
#include "base/number_text.h"
#include "language/quantity.h"

namespace filigree {

std::string choice_name(std::string_view name, std::uint32_t k) {
    std::string out(name);
    if (k > 1) out += "~" + to_text(std::uint64_t{k});
    return out;
}

double draw_between(double low, double high, std::uint64_t bits) {
    return std::clamp(low + (high - low) * to_unit(bits), low, high);
}

double draw_whole(double low, double high, std::uint64_t bits) {
    const double count = high - low + 1;
    if (count < 0x1p32) return low + static_cast<double>(to_whole(bits, static_cast<std::uint32_t>(count)));
    return std::clamp(low + std::floor(to_unit(bits) * count), low, high);
}

namespace {

constexpr double half_log_two_pi = 0.91893853320467274178;

// The share above z > 0, by Laplace's continued fraction: accurate to the last digits from z = 3 on.
double share_above(double z) {
    double tail = 0;
    for (int k = 120; k >= 1; --k) tail = k / (z + tail);
    return elementary::exp(-0.5 * z * z - half_log_two_pi) / (z + tail);
}

// The z below which lies the share p in [0, 1].
double z_of_share(double p) {
    const double scaled = std::clamp(p, 0.0, 1 - 0x1p-53) * 0x1p64;
    return to_normal(static_cast<std::uint64_t>(scaled));
}

// In the tail from low >= 8 deviations on, where the distribution is as good as exponential.
double draw_far_tail(double low, double high, double unit) {
    if (low > 1e8) return low;
    const double share = 1 - elementary::exp(-low * (high - low));
    return low - elementary::log(1 - unit * share) / low;
}

// For 0 <= low: in upper shares, which are small and therefore precise. `unit` runs upwards.
double draw_above_mean(double low, double high, double unit) {
    const double from = normal_share_below(-low), to = normal_share_below(-high);
    return -z_of_share(from - (from - to) * unit);
}

}  // namespace

double normal_share_below(double z) {
    if (!(z < 40)) return 1;
    if (!(z > -40)) return 0;
    if (z < -3) return share_above(-z);
    if (z > 3) return 1 - share_above(z);
    // Marsaglia's series: 1/2 + density(z) * (z + z^3/3 + z^5/(3*5) + ...).
    double term = z, sum = z, previous = 0;
    for (double divisor = 3; sum != previous; divisor += 2) {
        previous = sum;
        term *= z * z / divisor;
        sum += term;
    }
    return 0.5 + sum * elementary::exp(-0.5 * z * z - half_log_two_pi);
}

double draw_normal_between(double mean, double deviation, double low, double high, std::uint64_t bits) {
    if (!(deviation > 0)) return std::clamp(mean, low, high);
    const double from = (low - mean) / deviation, to = (high - mean) / deviation;
    const double unit = to_unit(bits);
    double z = 0;
    if (from >= 8) {
        z = draw_far_tail(from, to, unit);
    } else if (to <= -8) {
        z = -draw_far_tail(-to, -from, 1 - unit);
    } else if (from >= 0) {
        z = draw_above_mean(from, to, unit);
    } else {
        const double share = normal_share_below(from);
        z = z_of_share(share + (normal_share_below(to) - share) * unit);
    }
    return std::clamp(mean + deviation * z, low, high);
}

std::vector<Key> candidate_keys(std::span<const Value> candidates) {
    constexpr std::uint64_t unnamed = 1;
    std::map<std::string_view, std::uint64_t> named;
    std::uint64_t nameless = 0;
    std::vector<Key> keys;
    keys.reserve(candidates.size());
    for (const Value& candidate : candidates) {
        std::string_view name;
        if (const Symbol* symbol = std::get_if<Symbol>(&candidate.data)) name = symbol->name;
        if (const std::string* text = std::get_if<std::string>(&candidate.data)) name = *text;
        keys.push_back(name.empty() ? child(Key{unnamed}, nameless++) : child(child(Key{}, name), named[name]++));
    }
    return keys;
}

namespace {

// Rounded, but within the ends.
double to_whole_within(double value, double low, double high) {
    return std::min(std::max(std::round(value), std::ceil(low)), std::floor(high));
}

double draw_normal(const ChoiceDomain& domain, std::uint64_t bits) {
    const bool has_range = std::isfinite(domain.low);
    const double value = has_range ? draw_normal_between(domain.mean, domain.deviation, domain.low, domain.high, bits)
                                   : domain.mean + domain.deviation * to_normal(bits);
    return domain.whole ? to_whole_within(value, domain.low, domain.high) : value;
}

}  // namespace

double draw_from(const ChoiceDomain& domain, std::uint64_t seed, Key key, std::string_view name) {
    switch (domain.kind) {
        case ChoiceDomain::Kind::range: {
            const std::uint64_t bits = random_bits(seed, key, name);
            return domain.whole ? draw_whole(domain.low, domain.high, bits)
                                : draw_between(domain.low, domain.high, bits);
        }
        case ChoiceDomain::Kind::normal:
            return draw_normal(domain, random_bits(seed, key, name));
        case ChoiceDomain::Kind::alternatives:
            return static_cast<double>(race(seed, key, name, candidate_keys(domain.alternatives), domain.weights));
        case ChoiceDomain::Kind::fixed:
        case ChoiceDomain::Kind::worded:
            break;
    }
    return 0;
}

double middle_of(const ChoiceDomain& domain) {
    switch (domain.kind) {
        case ChoiceDomain::Kind::range: {
            const double half = (domain.high - domain.low) / 2;
            return domain.low + (domain.whole ? std::floor(half) : half);
        }
        case ChoiceDomain::Kind::normal: {
            const double mean = std::clamp(domain.mean, domain.low, domain.high);
            return domain.whole ? to_whole_within(mean, domain.low, domain.high) : mean;
        }
        case ChoiceDomain::Kind::alternatives: {
            const auto heaviest = std::max_element(domain.weights.begin(), domain.weights.end());
            return static_cast<double>(heaviest - domain.weights.begin());
        }
        case ChoiceDomain::Kind::fixed:
        case ChoiceDomain::Kind::worded:
            break;
    }
    return 0;
}

std::optional<double> place_in(const ChoiceDomain& domain, const Value& value) {
    if (domain.kind == ChoiceDomain::Kind::range || domain.kind == ChoiceDomain::Kind::normal) {
        const Quantity* quantity = std::get_if<Quantity>(&value.data);
        if (quantity == nullptr || !(is_bare(*quantity) || same_dimension(*quantity, domain.dimension))) {
            return std::nullopt;
        }
        const double number = quantity->value;
        const bool fits = std::isfinite(number) && number >= domain.low && number <= domain.high &&
                          (!domain.whole || number == std::round(number));
        return fits ? std::optional(number) : std::nullopt;
    }
    const auto index_of = [&](auto is_it) -> std::optional<double> {
        const auto found = std::find_if(domain.alternatives.begin(), domain.alternatives.end(), is_it);
        if (found == domain.alternatives.end()) return std::nullopt;
        return static_cast<double>(found - domain.alternatives.begin());
    };
    if (const auto equal = index_of([&](const Value& one) { return one == value; })) return equal;
    const std::string text = plain_text(value);
    return index_of([&](const Value& one) { return plain_text(one) == text; });
}

}  // namespace filigree
