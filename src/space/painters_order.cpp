#include "space/painters_order.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/number_text.h"

namespace filigree {
namespace {

// The same bits from whichever side the edge is seen, so that neighbours stay neighbours.
Vec3 crossing(Vec3 a, double a_distance, Vec3 b, double b_distance) {
    const bool is_swapped = b.x < a.x || (b.x == a.x && (b.y < a.y || (b.y == a.y && b.z < a.z)));
    if (is_swapped) {
        std::swap(a, b);
        std::swap(a_distance, b_distance);
    }
    return a + (b - a) * (a_distance / (a_distance - b_distance));
}

double distance(const Plane3& plane, Vec3 p) { return dot(plane.normal, p) - plane.offset; }

enum class Side : std::uint8_t { in_plane = 0, before = 1, behind = 2, across = 3 };

Side side_of(const Pieces& pieces, std::uint32_t piece, const Plane3& plane, double tolerance) {
    unsigned sides = 0;
    for (const PieceCorner& corner : corners_of(pieces, piece)) {
        const double d = distance(plane, corner.at);
        sides |= d > tolerance ? 1U : d < -tolerance ? 2U : 0U;
    }
    return static_cast<Side>(sides);
}

// Cuts pieces at a plane that they lie across.
class Cutter {
public:
    Cutter(Pieces& pieces, const Plane3& plane, double tolerance)
        : pieces_(pieces), plane_(plane), tolerance_(tolerance) {}

    // The numbers of the parts behind and before the plane.
    std::array<std::uint32_t, 2> cut(std::uint32_t number) {
        const Piece piece = pieces_.pieces[number];
        for (std::vector<PieceCorner>& part : parts_) part.clear();
        const std::span<const PieceCorner> corners = corners_of(pieces_, number);
        const std::size_t edges = piece.is_line ? corners.size() - 1 : corners.size();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const PieceCorner& from = corners[i];
            const double d = snapped(from.at);
            if (i == edges) {
                for (const std::size_t side : {0U, 1U}) {
                    if (is_on(side, d)) parts_[side].push_back(from);
                }
                break;
            }
            const PieceCorner& to = corners[i + 1 < corners.size() ? i + 1 : 0];
            const double to_d = snapped(to.at);
            // An edge goes on where it does so on this side; where it leaves the cut begins.
            for (const std::size_t side : {0U, 1U}) {
                if (!is_on(side, d)) continue;
                const bool leaves = d == 0 && !is_on(side, to_d);
                parts_[side].push_back({from.at, leaves ? no_edge : from.edge});
            }
            if (d * to_d < 0) {
                const Vec3 at = crossing(from.at, d, to.at, to_d);
                const std::size_t left = d < 0 ? 0 : 1;
                parts_[left].push_back({at, no_edge});
                parts_[1 - left].push_back({at, piece.is_line ? no_edge : from.edge});
            }
        }
        return {add(piece, number, parts_[0]), add(piece, number, parts_[1])};
    }

private:
    double snapped(Vec3 p) const {
        const double d = distance(plane_, p);
        return std::fabs(d) <= tolerance_ ? 0 : d;
    }
    static bool is_on(std::size_t side, double d) { return side == 0 ? d <= 0 : d >= 0; }

    std::uint32_t add(Piece piece, std::uint32_t parent, const std::vector<PieceCorner>& corners) {
        piece.first = static_cast<std::uint32_t>(pieces_.corners.size());
        piece.count = static_cast<std::uint32_t>(corners.size());
        piece.parent = parent;
        pieces_.corners.insert(pieces_.corners.end(), corners.begin(), corners.end());
        pieces_.pieces.push_back(piece);
        return static_cast<std::uint32_t>(pieces_.pieces.size() - 1);
    }

    Pieces& pieces_;
    const Plane3& plane_;
    const double tolerance_;
    std::array<std::vector<PieceCorner>, 2> parts_;  // behind, before
};

// Every so-many-th of a set, from the middle of the first stretch on.
template <class Visit>
void visit_sample(std::span<const std::uint32_t> set, std::size_t most, const Visit& visit) {
    const std::size_t count = std::min(set.size(), most);
    for (std::size_t i = 0; i < count; ++i) visit(set[(2 * i + 1) * set.size() / (2 * count)]);
}

struct ChosenPlane {
    Plane3 plane;
    std::uint32_t number = UINT32_MAX;  // of Pieces::planes
};

class PlaneChooser {
public:
    PlaneChooser(const Pieces& pieces, double tolerance) : pieces_(pieces), tolerance_(tolerance) {}

    // Of the set's own planes, or one across an axis that leaves out some pieces on either side.
    ChosenPlane choose(std::span<const std::uint32_t> set) {
        sample_.clear();
        visit_sample(set, most_sampled, [&](std::uint32_t piece) { sample_.push_back(piece); });
        best_cost_ = SIZE_MAX;
        visit_sample(set, most_own, [&](std::uint32_t piece) {
            const std::uint32_t number = pieces_.pieces[piece].plane;
            weigh({pieces_.planes[number], number});
        });
        if (set.size() >= least_for_axes) {
            for (const double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) weigh({across(axis), UINT32_MAX});
        }
        return best_;
    }

private:
    static constexpr std::size_t most_sampled = 64, most_own = 12, least_for_axes = 16;
    static constexpr std::size_t cost_of_cut = 6;  // as many pieces more on the fuller side

    void weigh(const ChosenPlane& chosen) {
        std::array<std::size_t, 4> counts{};
        for (const std::uint32_t piece : sample_) {
            ++counts[static_cast<std::size_t>(side_of(pieces_, piece, chosen.plane, tolerance_))];
        }
        const auto [in_plane, before, behind, cut] = counts;
        if (chosen.number == UINT32_MAX && (before == 0 || behind == 0 || 3 * cut > sample_.size())) return;
        const std::size_t cost = std::max(before, behind) + (cost_of_cut + 1) * cut;
        if (cost >= best_cost_) return;
        best_cost_ = cost;
        best_ = chosen;
    }

    // Where half of the sampled pieces begin below.
    Plane3 across(const double Vec3::*axis) {
        starts_.clear();
        for (const std::uint32_t piece : sample_) {
            double least = corners_of(pieces_, piece)[0].at.*axis;
            for (const PieceCorner& corner : corners_of(pieces_, piece)) least = std::min(least, corner.at.*axis);
            starts_.push_back(least);
        }
        const auto middle = starts_.begin() + static_cast<std::ptrdiff_t>(starts_.size() / 2);
        std::nth_element(starts_.begin(), middle, starts_.end());
        Plane3 plane;
        plane.normal = {axis == &Vec3::x ? 1.0 : 0.0, axis == &Vec3::y ? 1.0 : 0.0, axis == &Vec3::z ? 1.0 : 0.0};
        plane.offset = *middle;
        return plane;
    }

    const Pieces& pieces_;
    const double tolerance_;
    std::vector<std::uint32_t> sample_;
    std::vector<double> starts_;
    ChosenPlane best_;
    std::size_t best_cost_ = SIZE_MAX;
};

double extent_of(const Pieces& pieces, std::span<const std::uint32_t> which) {
    double extent = 0;
    for (const std::uint32_t piece : which) {
        for (const PieceCorner& corner : corners_of(pieces, piece)) {
            extent = std::max({extent, std::fabs(corner.at.x), std::fabs(corner.at.y), std::fabs(corner.at.z)});
        }
    }
    return extent;
}

double mean_nearness(const Pieces& pieces, const std::vector<std::uint32_t>& which, const Viewer& viewer) {
    double sum = 0;
    for (const std::uint32_t piece : which) {
        const Vec3 at = corners_of(pieces, piece)[0].at;
        sum += viewer.eye ? -length(*viewer.eye - at) : dot(viewer.towards, at);
    }
    return which.empty() ? 0 : sum / static_cast<double>(which.size());
}

}  // namespace

double side_of(const Viewer& viewer, const Plane3& plane) {
    const double side = viewer.eye ? distance(plane, *viewer.eye) / length(*viewer.eye - plane.normal * plane.offset)
                                   : dot(plane.normal, viewer.towards);
    return std::fabs(side) <= 0x1p-40 ? 0 : side;
}

Plane3 plane_facing(const Viewer& viewer, Vec3 from, Vec3 to) {
    const Vec3 along = to - from;
    const Vec3 towards = viewer.eye ? *viewer.eye - from : viewer.towards;
    const double squared = dot(along, along);
    Vec3 normal = squared > 0 ? towards - along * (dot(towards, along) / squared) : towards;
    if (!(length(normal) > 0x1p-30 * length(towards))) {  // seen as a point: any plane through it
        normal = std::fabs(along.x) < std::fabs(along.y) ? cross(along, {1, 0, 0}) : cross(along, {0, 1, 0});
    }
    normal = unit(normal);
    return {normal, dot(normal, from)};
}

void part(Pieces& pieces, std::span<const std::uint32_t> which, const Plane3& plane, double tolerance,
          PlaneSides& sides, std::uint32_t own) {
    Cutter cutter(pieces, plane, tolerance);
    for (const std::uint32_t piece : which) {
        const bool is_own = pieces.pieces[piece].plane == own;
        switch (is_own ? Side::in_plane : side_of(pieces, piece, plane, tolerance)) {
            case Side::in_plane:
                sides.in_plane.push_back(piece);
                break;
            case Side::before:
                sides.before.push_back(piece);
                break;
            case Side::behind:
                sides.behind.push_back(piece);
                break;
            case Side::across: {
                const auto [behind, before] = cutter.cut(piece);
                sides.behind.push_back(behind);
                sides.before.push_back(before);
                break;
            }
        }
    }
}

Result<std::vector<std::uint32_t>> painters_order(Pieces& pieces, std::span<const std::uint32_t> which,
                                                  const Viewer& viewer, std::uint64_t most_pieces, const Job& job) {
    struct Task {
        std::size_t first;  // of what is left to do, up to where the next task's begins
        bool is_ordered;
    };
    const double tolerance = extent_of(pieces, which) * 0x1p-30;
    std::vector<std::uint32_t> order, left(which.begin(), which.end()), set;
    std::vector<Task> tasks = {{0, false}};
    PlaneChooser chooser(pieces, tolerance);
    PlaneSides sides;
    while (!tasks.empty()) {
        if (is_cancelled(job)) return cancelled_diagnostic();
        const Task task = tasks.back();
        tasks.pop_back();
        set.assign(left.begin() + static_cast<std::ptrdiff_t>(task.first), left.end());
        left.resize(task.first);
        if (task.is_ordered || set.size() <= 1) {
            order.insert(order.end(), set.begin(), set.end());
            continue;
        }
        const auto [plane, number] = chooser.choose(set);
        for (std::vector<std::uint32_t>* side : {&sides.behind, &sides.in_plane, &sides.before}) side->clear();
        part(pieces, set, plane, tolerance, sides, number);
        if (pieces.pieces.size() > most_pieces) {
            return fault(Fault::limit, "limit.elements",
                         "this view falls into more pieces than the limit of " + to_text(most_pieces));
        }
        double viewer_side = side_of(viewer, plane);
        // Neither side hides anything of the other; but strokes are wider than what they go round.
        if (viewer_side == 0) {
            viewer_side = mean_nearness(pieces, sides.before, viewer) - mean_nearness(pieces, sides.behind, viewer);
        }
        const auto add_task = [&](const std::vector<std::uint32_t>& side, bool is_ordered) {
            if (side.empty()) return;
            tasks.push_back({left.size(), is_ordered});
            left.insert(left.end(), side.begin(), side.end());
        };
        add_task(viewer_side < 0 ? sides.behind : sides.before, false);
        add_task(sides.in_plane, true);
        add_task(viewer_side < 0 ? sides.before : sides.behind, false);
    }
    return order;
}

}  // namespace filigree
