#include "curves/refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "curves/along.h"
#include "curves/similarity.h"

namespace filigree::curves {
namespace {

// Small changes of a transform, in the design: translations along x and y, then by the group a turn, an even growth,
// and two shears about a centre. Lengths are measured in `size`, so that all are alike.
constexpr std::size_t most_ways = 6;
using Row = std::array<double, most_ways>;

std::size_t ways_of(MatchGroup group) {
    switch (group) {
        case MatchGroup::translation:
            return 2;
        case MatchGroup::isometry:
            return 3;
        case MatchGroup::similarity:
            return 4;
        case MatchGroup::affine:
            return 6;
    }
    return 0;
}

// How far each way moves a point along a direction.
Row moves_of(Vec off, Vec along) {
    return {along.x,
            along.y,
            dot(along, perpendicular(off)),
            dot(along, off),
            dot(along, {off.x, -off.y}),
            dot(along, {off.y, off.x})};
}

class LeastSquares {
public:
    explicit LeastSquares(std::size_t ways) : ways_(ways) {}

    // One equation: what the ways do along a direction shall undo the residual.
    void add(const Row& moves, double residual) {
        for (std::size_t i = 0; i < ways_; ++i) {
            for (std::size_t j = 0; j <= i; ++j) normal_[i][j] += moves[i] * moves[j];
            right_[i] -= moves[i] * residual;
        }
    }
    // By Cholesky's method. A trace of damping keeps what no equation speaks of at zero.
    Row solved() {
        double trace = 0;
        for (std::size_t i = 0; i < ways_; ++i) trace += normal_[i][i];
        Row x{};
        for (std::size_t i = 0; i < ways_; ++i) {
            normal_[i][i] += 1e-14 * trace + std::numeric_limits<double>::min();
            for (std::size_t j = 0; j <= i; ++j) {
                double sum = normal_[i][j];
                for (std::size_t k = 0; k < j; ++k) sum -= normal_[i][k] * normal_[j][k];
                if (i == j) {
                    normal_[i][i] = std::sqrt(std::max(sum, 1e-16 * trace));
                } else {
                    normal_[i][j] = sum / normal_[j][j];
                }
            }
            x[i] = right_[i];
            for (std::size_t k = 0; k < i; ++k) x[i] -= normal_[i][k] * x[k];
            x[i] /= normal_[i][i];
        }
        for (std::size_t i = ways_; i-- > 0;) {
            for (std::size_t k = i + 1; k < ways_; ++k) x[i] -= normal_[k][i] * x[k];
            x[i] /= normal_[i][i];
        }
        return x;
    }

private:
    std::size_t ways_;
    std::array<Row, most_ways> normal_{};
    Row right_{};
};

struct Frame {
    Vec centre;
    double size = 1;
};

// The change by some of each way, as a transform.
Transform change_of(const Row& x, MatchGroup group, const Frame& frame) {
    Transform linear;
    if (group == MatchGroup::isometry) {
        const Vec unit = Vec{1, x[2]} * (1 / length(Vec{1, x[2]}));
        linear = {unit.x, unit.y, -unit.y, unit.x, 0, 0};
    } else if (group != MatchGroup::translation) {
        linear = {1 + x[3] + x[4], x[2] + x[5], x[5] - x[2], 1 + x[3] - x[4], 0, 0};
    }
    const Vec to = frame.centre + Vec{x[0], x[1]} * frame.size - apply(linear, frame.centre);
    linear.e = to.x;
    linear.f = to.y;
    return linear;
}

// The equations of one part that lies along its carrier.
void add_equations(LeastSquares& equations, const Element& carrier, const Element& part, const Frame& frame) {
    const auto add = [&](Vec at, Vec target, Vec along) {
        equations.add(moves_of((at - frame.centre) * (1 / frame.size), along),
                      dot(at - target, along) * (1 / frame.size));
    };
    if (carrier.kind == ElementKind::point) {
        add(part.at[0], carrier.at[0], {1, 0});
        add(part.at[0], carrier.at[0], {0, 1});
        return;
    }
    const auto found = along(carrier, part, std::numeric_limits<double>::infinity());
    if (!found) return;
    const Interval of = interval_of(part), own = interval_of(carrier);
    const int steps = carrier.kind == ElementKind::line ? 1 : 4;
    for (int i = 0; i <= steps; ++i) {
        const double f = static_cast<double>(i) / steps, g = found->is_reversed ? 1 - f : f;
        const Vec at = point_at(part, of.from * (1 - f) + of.to * f);
        const double on = found->on.from * (1 - g) + found->on.to * g;
        const Vec way = velocity_at(carrier, on);
        const double speed = length(way);
        if (!(speed > 0)) continue;
        add(at, point_at(carrier, on), perpendicular(way * (1 / speed)));
        const bool is_beyond = (g == 0 && on < own.from) || (g == 1 && on > own.to);
        if (is_beyond && !is_closed(carrier)) {
            add(at, point_at(carrier, g == 0 ? own.from : own.to), way * (1 / speed));
        }
    }
}

}  // namespace

Transform refined(const Transform& start, MatchGroup group, std::span<const Pairing> pairs) {
    Bounds box;
    for (const Pairing& pair : pairs) extend(box, bounds_of(transformed(*pair.part, start)));
    Frame frame{(box.min + box.max) * 0.5, length(box.max - box.min)};
    if (!(frame.size > 0)) frame.size = 1;
    Transform by = start;
    for (int round = 0; round < 4; ++round) {
        LeastSquares equations(ways_of(group));
        for (const Pairing& pair : pairs) {
            add_equations(equations, *pair.carrier, transformed(*pair.part, by), frame);
        }
        const Row x = equations.solved();
        by = compose(change_of(x, group, frame), by);
        double most = 0;
        for (const double way : x) most = std::max(most, std::fabs(way));
        if (most < 1e-15) break;
    }
    return by;
}

}  // namespace filigree::curves
