// Where the curves of a split go: levels at distances that cycle, and the families of curves that they make about a
// shape. Used by regular_split and radial.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

#include "engines/tangle/operator.h"
#include "plane/curve_families.h"
#include "plane/level_cut.h"

namespace filigree::tangle {

struct SplitLevels {
    std::vector<double> at;        // px
    std::int32_t first_strip = 0;  // index of the strip below the first
    bool too_many = false;
};

// Where a family is laid out, and the part of it that a shape can meet.
struct SplitLayout {
    LevelRange whole;            // the cuts are centred in it, or fitted to it
    LevelRange visible;          // only cuts inside it are made
    bool from_zero = false;      // not centred: one cut lies at level 0
    bool fit = false;            // stretched so that a whole number of strips fills the whole
    bool keeps_slivers = false;  // strips at the ends may be as thin as they come
};

// Cuts by `offsets` in turn. Kept exactly they lie around the middle, so that both end strips come out equal; fitted
// they fill the range.
SplitLevels levels_in(const SplitLayout& layout, const std::vector<double>& offsets);

// What a split about a point goes by.
struct PolarLayout {
    Vec centre;
    LevelRange reach;          // px from the centre: of the shape, or of its whole group
    LevelRange visible;        // of the shape alone
    double first_degrees = 0;  // of the first ray
    bool fit = false;
    bool keeps_slivers = false;
    double tolerance = 0.1;  // px
};
SplitLevels ring_levels(const PolarLayout& layout, const std::vector<double>& offsets);
Circles rings_of(const PolarLayout& layout, SplitLevels levels);
// An even number of rays, about as far apart as the offsets say at a distance from the centre.
Rays rays_of(const PolarLayout& layout, const std::vector<double>& offsets, double at_distance);
// Arms with the offsets between them, two where there is one offset: one alone would not part a shape.
Rays spiral_of(const PolarLayout& layout, const std::vector<double>& offsets);

// The parameter `centre`: (x, y), or the word that leaves it to the operator.
ParameterDescription centre_parameter();
Vec centre_of(const Value& centre, Vec otherwise);

// The curves that forms of a step's parameter draw, each read once.
class DrawnCurves {
public:
    struct Drawn {
        DrawnCurve curve;
        std::optional<Profile> profile;  // where it is a graph over its chord
    };
    // An error where a form cannot be read or draws nothing.
    static Result<DrawnCurves> of(const OperatorInput& input, std::string_view form);

    // Of a shape; null where its value is a word.
    const Drawn* at(std::size_t shape) const { return curves_.size() == 1 ? curves_[0].get() : curves_[shape].get(); }

private:
    std::vector<std::shared_ptr<const Drawn>> curves_;  // one where all shapes have the same
};

// The curve words `wave` and `zigzag` over one wavelength, close enough to the resolution.
Profile wave_profile(double amplitude, double wavelength, double resolution);
Profile zigzag_profile(double amplitude, double wavelength);

}  // namespace filigree::tangle
