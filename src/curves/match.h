// What a search for subshapes is asked, and a match that it finds, as plain data.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/job.h"
#include "curves/element.h"
#include "plane/transform.h"

namespace filigree::curves {

enum class MatchGroup : std::uint8_t { translation, isometry, similarity, affine };
enum class WeightRule : std::uint8_t { at_least, equal };  // a design's element beside the left one

struct MatchOptions {
    MatchGroup group = MatchGroup::similarity;
    bool with_reflections = true;
    WeightRule weights = WeightRule::at_least;
    double tolerance = 1e-6;  // px, in the design
    double min_scale = 0, max_scale = std::numeric_limits<double>::infinity();
    std::size_t limit = 1000000;  // the search ends with so many matches
    Job job;
    double visual_tolerance = 0;  // px; how far look-alikes may lie off (visual.h)
};

inline bool allows_reflections(const MatchOptions& options) {
    return options.with_reflections && options.group != MatchGroup::translation;
}
inline bool keeps_lengths(const MatchOptions& options) {
    return options.group == MatchGroup::isometry || options.group == MatchGroup::translation;
}

// One way in which a left side lies on a design.
struct Match {
    Transform by;  // carries the left side onto the design
    bool is_reflected = false;
    double scale = 1;                     // of lengths; affine: the square root of the determinant's size
    double angle_degrees = 0;             // in [0, 360): where +x is turned to, after a reflection across the x axis
    Vec centroid;                         // of the left side, carried
    std::vector<std::uint32_t> carriers;  // the slot of the design on which each left element lies
    double misfit = 0;                    // of the element that fits worst, in tolerances
    bool is_ambiguous = false;            // it holds, but would not at a tenth of the tolerance
    bool is_visual = false;               // by looks alone: descriptors differ (visual.h)

    bool operator==(const Match&) const = default;
};

}  // namespace filigree::curves
