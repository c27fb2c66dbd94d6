#include "plane/offset_corner.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace filigree {

namespace {

constexpr double longest_mitre = 1000;  // of the distance; keeps far corners countable

}  // namespace

JoinRule join_rule(const InsetOptions& options, double distance) {
    JoinRule rule;
    if (options.join == Join::round) {
        const double tolerance = options.tolerance > 0 ? options.tolerance : 0;
        // A tangent polyline that turns by 2 b leaves the arc by distance (1 / cos b - 1). Some 1,500 edges a
        // full circle are the most.
        const double cosine = std::clamp(distance / (distance + tolerance), 0.5, 1 - 0x1p-17);
        rule.most_turn = 2 * elementary::acos(cosine);
        return rule;
    }
    const double limit = options.mitre_limit >= 1 ? std::min(options.mitre_limit, longest_mitre) : 1;
    rule.least_mitre_sum2 = 4 / (limit * limit);  // the mitre is 2 / |n1 + n2| distances long
    return rule;
}

void append_fill(Vec in, Vec out, const JoinRule& rule, std::vector<Vec>& normals) {
    if (!opens_gap(in, out)) return;
    const double cosine = dot(in, out);
    const Vec start = perpendicular(in);
    if (rule.most_turn > 0) {
        const double angle = elementary::atan2(std::fabs(cross(in, out)), cosine);
        const double steps = std::ceil(angle / rule.most_turn - 1e-9);
        for (double i = 1; i < steps; ++i) {
            const elementary::CosSin by = elementary::cos_sin(angle * i / steps);
            normals.push_back({start.x * by.cos + start.y * by.sin, start.y * by.cos - start.x * by.sin});
        }
        return;
    }
    const Vec sum = start + perpendicular(out);
    if (dot(sum, sum) >= rule.least_mitre_sum2) return;
    // The bisector, from the difference of the directions where the sum of the normals is small.
    const Vec middle = cosine > 0 ? sum : in - out;
    normals.push_back(middle * (1 / length(middle)));
}

}  // namespace filigree
