// The nearest name, for "did you mean".
#include <algorithm>
#include <cstddef>
#include <string>

#include "base/diagnostic.h"
#include "base/unicode.h"

namespace filigree {

namespace {

// Longer names are compared only as equal or not: nobody types them, and the distance takes quadratic time.
constexpr std::size_t longest_measured = 200;

std::u32string folded(std::string_view name) {
    const std::string normal = unicode::normalise(name);
    std::u32string out;
    for (std::size_t i = 0; i < normal.size();) {
        const unicode::Decoded decoded = unicode::decode(normal, i);
        out += unicode::to_lower(decoded.code_point);
        i += decoded.length;
    }
    return out;
}

std::u32string without_underscores(std::u32string name) {
    std::erase(name, U'_');
    return name;
}

// Insertions, deletions, substitutions and swaps of neighbours from one to the other; limit + 1 where more
// than `limit` are needed.
std::size_t edit_distance(const std::u32string& a, const std::u32string& b, std::size_t limit) {
    if (a == b) return 0;
    const std::size_t difference = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
    if (difference > limit || std::max(a.size(), b.size()) > longest_measured) return limit + 1;
    std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(before_last, last);
        std::swap(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, substituted});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
        }
    }
    return std::min(row[b.size()], limit + 1);
}

}  // namespace

std::string_view nearest_name(std::string_view wanted, const std::vector<std::string_view>& candidates) {
    const std::u32string name = folded(wanted);
    const std::u32string bare_name = without_underscores(name);
    const std::size_t limit = std::max<std::size_t>(1, name.size() / 3);
    std::string_view nearest;
    std::size_t least = limit + 1;
    for (const std::string_view candidate : candidates) {
        const std::u32string other = folded(candidate);
        std::size_t distance = edit_distance(name, other, limit);
        // All differences in underscores together count as one.
        if (distance > 1) {
            const std::u32string bare_other = without_underscores(other);
            if (!bare_other.empty()) distance = std::min(distance, edit_distance(bare_name, bare_other, limit) + 1);
        }
        // A name of which no character is left was not meant.
        if (distance >= std::max(name.size(), other.size())) continue;
        if (distance < least) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::vector<std::string> did_you_mean(std::string_view wanted, const std::vector<std::string_view>& candidates) {
    const std::string_view nearest = nearest_name(wanted, candidates);
    if (nearest.empty()) return {};
    return {"did you mean '" + std::string(nearest) + "'?"};
}

}  // namespace filigree
