// Recognising equal designs: by a few numbers that equal designs share to within rounding, then by a comparison.
//
// A fingerprint rules most designs out and decides nothing: a number that lies where two buckets meet may come out on
// either side, so who looks a design up asks the buckets around it, too (DesignSet), and then compares.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "curves/shape.h"
#include "plane/transform.h"

namespace filigree::curves {

// What equal designs may differ by; the last two include reflections unless these are ruled out.
enum class UpTo : std::uint8_t { nothing, translation, isometry, similarity };

struct Fingerprint {
    std::uint64_t kinds = 0;         // a hash of how many elements of which kind and layer there are
    std::array<double, 3> values{};  // px, or of one px across where sizes do not matter
};
Fingerprint fingerprint(const Shape& shape, UpTo up_to);

// Whether some map of the kind carries one onto the other, to within four tolerances. Both maximal, with as many
// elements of each kind.
bool are_same_design(const Shape& a, const Shape& b, UpTo up_to, double tolerance, bool with_reflections = true);

// The isometries that carry a design onto itself, to within four tolerances, the identity first. Where all lies round
// about one place, as circles do, the identity stands for all turns. Unlike symmetries() it takes about as long as a
// comparison for each of them, however large the design is.
std::vector<Transform> maps_onto_itself(const Shape& shape, double tolerance);

// Designs, each once, under numbers.
class DesignSet {
public:
    DesignSet(UpTo up_to, double tolerance, bool with_reflections = true)
        : up_to_(up_to), tolerance_(tolerance), with_reflections_(with_reflections) {}

    // The number of an equal design; else none, and the design is added under its own.
    std::optional<std::uint32_t> find_or_add(const Shape& design, std::uint32_t number);

private:
    struct Entry {
        Shape design;
        std::uint32_t number = 0;
    };
    using Bucket = std::array<std::int64_t, 4>;

    UpTo up_to_;
    double tolerance_;
    bool with_reflections_;
    std::map<Bucket, std::vector<Entry>> buckets_;  // looked up only
};

}  // namespace filigree::curves
