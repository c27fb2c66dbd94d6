#include "plane/winding_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace filigree {
namespace {

struct Edge {
    FinePoint a, b;
};

// On which side of an edge a place lies, never 0: a place counts as moved by (e, e^2) for an infinitely small
// e, and is compared with straight lines in that sense everywhere below.
int side(const Edge& edge, FinePoint p) {
    const std::int64_t dx = edge.b.x - edge.a.x, dy = edge.b.y - edge.a.y;
    const Int128 turn = static_cast<Int128>(dx) * (p.y - edge.a.y) - static_cast<Int128>(dy) * (p.x - edge.a.x);
    if (turn != 0) return turn > 0 ? 1 : -1;
    if (dy != 0) return dy < 0 ? 1 : -1;
    return dx > 0 ? 1 : -1;
}
bool spans_x(const Edge& edge, std::int64_t x) { return (edge.a.x <= x) != (edge.b.x <= x); }
bool spans_y(const Edge& edge, std::int64_t y) { return (edge.a.y <= y) != (edge.b.y <= y); }

// What the winding number gains on the way from p straight to q, which share a coordinate.
int gain_along_y(const Edge& edge, FinePoint p, FinePoint q) {
    return spans_x(edge, p.x) ? (side(edge, q) - side(edge, p)) / 2 : 0;
}
int gain_along_x(const Edge& edge, FinePoint p, FinePoint q) {
    return spans_y(edge, p.y) ? (side(edge, q) - side(edge, p)) / 2 : 0;
}

struct FineBox {
    FinePoint min, max;
};

struct Interval {
    double low = 0, high = 0;
};

// An edge as seen from the corner of a small box.
struct LocalEdge {
    Vec a, b;
};

class Search {
public:
    Search(std::span<const DirectedEdge> edges, const WindingRange& range) : range_(range) {
        edges_.reserve(edges.size());
        for (const DirectedEdge& edge : edges) {
            if (edge.from != edge.to) edges_.push_back({to_fine(edge.from), to_fine(edge.to)});
        }
    }

    std::optional<WindingFlaw> run() {
        if (edges_.empty()) return std::nullopt;
        FineBox box{edges_[0].a, edges_[0].a};
        for (const Edge& edge : edges_) {
            for (const FinePoint p : {edge.a, edge.b}) {
                box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
                box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
            }
        }
        const double extent = static_cast<double>(std::max(box.max.x - box.min.x, box.max.y - box.min.y));
        const double per_px = grid_per_px * static_cast<double>(fine_per_grid);
        const double least_tolerance = std::max(2.0, extent * 0x1p-43);
        double tolerance = range_.tolerance * per_px;
        if (!(tolerance > least_tolerance)) tolerance = least_tolerance;  // also for NaN
        if (tolerance > extent) return std::nullopt;                      // nothing has room for the disc
        radius_ = tolerance / 2;
        blocking_radius_ = radius_ * (1 - 0x1p-6);
        margin_ = static_cast<std::int64_t>(2.25 * radius_) + 2;  // no farther does a leaf look around its box
        longest_run_ = std::max(range_.longest_run.value_or(INFINITY) * per_px, tolerance);

        // The corner where all counting starts lies outside of everything.
        box.min = {box.min.x - margin_, box.min.y - margin_};
        box.max = {box.max.x + margin_, box.max.y + margin_};
        std::vector<std::uint32_t> all(edges_.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
        visit(box, 0, all);
        return flaw_;
    }

private:
    static constexpr std::size_t few = 14;  // edges in one box; measured

    bool reaches(const Edge& edge, const FineBox& box) const {
        if (std::max(edge.a.x, edge.b.x) < box.min.x - margin_) return false;
        if (std::min(edge.a.x, edge.b.x) > box.max.x + margin_) return false;
        if (std::max(edge.a.y, edge.b.y) < box.min.y - margin_) return false;
        if (std::min(edge.a.y, edge.b.y) > box.max.y + margin_) return false;
        // The box lies wholly on one side of the edge's line.
        const double half_width = static_cast<double>((box.max.x - box.min.x) / 2 + 1 + margin_);
        const double half_height = static_cast<double>((box.max.y - box.min.y) / 2 + 1 + margin_);
        const double to_x = static_cast<double>(box.min.x + (box.max.x - box.min.x) / 2 - edge.a.x);
        const double to_y = static_cast<double>(box.min.y + (box.max.y - box.min.y) / 2 - edge.a.y);
        const double dx = static_cast<double>(edge.b.x - edge.a.x), dy = static_cast<double>(edge.b.y - edge.a.y);
        return std::fabs(dx * to_y - dy * to_x) <= std::fabs(dx) * half_height + std::fabs(dy) * half_width;
    }

    static double squared(std::size_t n) { return static_cast<double>(n) * static_cast<double>(n); }

    struct Halves {
        FineBox low, high;
        std::vector<std::uint32_t> low_ids, high_ids;

        double leaf_cost() const { return squared(low_ids.size()) + squared(high_ids.size()); }
    };
    Halves halve(const FineBox& box, const std::vector<std::uint32_t>& ids, bool along_x) const {
        Halves halves{box, box, {}, {}};
        if (along_x) {
            halves.low.max.x = halves.high.min.x = box.min.x + (box.max.x - box.min.x) / 2;
        } else {
            halves.low.max.y = halves.high.min.y = box.min.y + (box.max.y - box.min.y) / 2;
        }
        for (const std::uint32_t id : ids) {
            if (reaches(edges_[id], halves.low)) halves.low_ids.push_back(id);
            if (reaches(edges_[id], halves.high)) halves.high_ids.push_back(id);
        }
        return halves;
    }

    // `count` is the winding number at the box's least corner; `ids` are all edges that reach the box.
    void visit(const FineBox& box, int count, const std::vector<std::uint32_t>& ids) {
        if (ids.empty()) return;
        const std::int64_t width = box.max.x - box.min.x, height = box.max.y - box.min.y;
        if (ids.size() <= few || std::max(width, height) <= 8 * margin_) return visit_leaf(box, count, ids);

        // A leaf costs its edges squared. A halving may cost a little, as across parallel edges aslant, where two
        // halvings cost nothing; more, alone and together with the next one, is not worth it (a fan's apex).
        const double worth = 1.2 * squared(ids.size());
        bool along_x = width >= height;
        Halves halves = halve(box, ids, along_x);
        if (halves.leaf_cost() > worth) {
            Halves others = halve(box, ids, !along_x);
            if (others.leaf_cost() <= worth) {
                halves = std::move(others);
                along_x = !along_x;
            } else if (halve(halves.low, halves.low_ids, !along_x).leaf_cost() +
                           halve(halves.high, halves.high_ids, !along_x).leaf_cost() >
                       worth) {
                return visit_leaf(box, count, ids);
            }
        }

        int high_count = count;
        for (const std::uint32_t id : ids) {
            high_count += along_x ? gain_along_x(edges_[id], box.min, halves.high.min)
                                  : gain_along_y(edges_[id], box.min, halves.high.min);
        }
        visit(halves.low, count, halves.low_ids);
        std::vector<std::uint32_t>().swap(halves.low_ids);
        if (!flaw_) visit(halves.high, high_count, halves.high_ids);
    }

    void visit_leaf(const FineBox& box, int count, const std::vector<std::uint32_t>& ids) {
        const auto local = [&](FinePoint p) {
            return Vec{static_cast<double>(p.x - box.min.x), static_cast<double>(p.y - box.min.y)};
        };
        local_.clear();
        for (const std::uint32_t id : ids) local_.push_back({local(edges_[id].a), local(edges_[id].b)});
        const Vec size = local(box.max);
        for (std::size_t i = 0; i < ids.size() && !flaw_; ++i) roll_along(i, box, size, count, ids);
    }

    // The part of an edge inside the box, by its distance from the edge's start.
    static Interval clip(const LocalEdge& edge, Vec direction, double edge_length, Vec size) {
        Interval part{0, edge_length};
        const auto clip_by = [&](double start, double slope, double high) {
            if (slope == 0) {
                if (start < 0 || start > high) part.high = -1;
                return;
            }
            const double at_low = -start / slope, at_high = (high - start) / slope;
            part.low = std::max(part.low, std::min(at_low, at_high));
            part.high = std::min(part.high, std::max(at_low, at_high));
        };
        clip_by(edge.a.x, direction.x, size.x);
        clip_by(edge.a.y, direction.y, size.y);
        return part;
    }

    // Where a disc that rolls at `height` over the axis would touch the segment p to q, widened by its radius.
    void block(Vec p, Vec q, double height, std::vector<Interval>& blocked) const {
        const double r = blocking_radius_;
        if (std::min(p.y, q.y) - height >= r || height - std::max(p.y, q.y) >= r) return;
        Interval reach{INFINITY, -INFINITY};
        const auto take = [&](double u) {
            reach.low = std::min(reach.low, u);
            reach.high = std::max(reach.high, u);
        };
        for (const Vec end : {p, q}) {
            const double off = end.y - height;
            if (std::fabs(off) >= r) continue;
            const double half_chord = std::sqrt(r * r - off * off);
            take(end.x - half_chord);
            take(end.x + half_chord);
        }
        const Vec along = q - p;
        const double along_length = length(along);
        if (along_length > 0) {
            const Vec across = perpendicular(along) * (r / along_length);
            for (const Vec offset : {across, -across}) {
                const double start = p.y + offset.y - height, end = q.y + offset.y - height;
                if ((start < 0) != (end < 0)) take(p.x + offset.x + along.x * (start / (start - end)));
            }
        }
        if (!(reach.low < reach.high)) return;
        // Many edges that meet at a vertex block the same stretch.
        if (!blocked.empty() && reach.low <= blocked.back().high && blocked.back().low <= reach.high) {
            blocked.back() = {std::min(reach.low, blocked.back().low), std::max(reach.high, blocked.back().high)};
        } else {
            blocked.push_back(reach);
        }
    }

    void roll_along(std::size_t i, const FineBox& box, Vec size, int count, const std::vector<std::uint32_t>& ids) {
        const LocalEdge& edge = local_[i];
        const double edge_length = length(edge.b - edge.a);
        const Vec direction = (edge.b - edge.a) * (1 / edge_length);
        const Interval part = clip(edge, direction, edge_length, size);
        if (!(part.low < part.high)) return;

        for (auto& side_blocked : blocked_) side_blocked.clear();
        for (std::size_t k = 0; k < local_.size(); ++k) {
            if (k == i) continue;
            const Vec to_a = local_[k].a - edge.a, to_b = local_[k].b - edge.a;
            const Vec p{dot(to_a, direction), cross(direction, to_a)}, q{dot(to_b, direction), cross(direction, to_b)};
            if (std::min(p.y, q.y) > 2 * radius_ || std::max(p.y, q.y) < -2 * radius_) continue;
            if (std::max(p.x, q.x) < part.low - radius_ || std::min(p.x, q.x) > part.high + radius_) continue;
            const double run_low = std::max(0.0, std::min(p.x, q.x));
            const double run_high = std::min(edge_length, std::max(p.x, q.x));
            if (run_high - run_low > longest_run_ && lie_on_one_line(edges_[ids[i]], edges_[ids[k]])) {
                flaw_ = {place(box, edge.a + direction * ((run_low + run_high) / 2)), true};
                return;
            }
            block(p, q, radius_, blocked_[0]);
            block(p, q, -radius_, blocked_[1]);
        }
        for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {
            std::vector<Interval>& blocked = blocked_[s];
            std::sort(blocked.begin(), blocked.end(), [](const Interval& x, const Interval& y) {
                return x.low != y.low ? x.low < y.low : x.high < y.high;
            });
            const Vec off = perpendicular(direction) * (s == 0 ? radius_ : -radius_);
            double free_from = part.low;
            const auto count_before = [&](double free_to) {
                if (!(free_from < free_to)) return;
                const FinePoint at = place(box, edge.a + direction * ((free_from + free_to) / 2) + off);
                const int there = count_at(at, box.min, count, ids);
                if (there < range_.least || there > range_.most) flaw_ = {at, false};
            };
            for (const Interval& interval : blocked) {
                count_before(std::min(interval.low, part.high));
                if (flaw_) return;
                free_from = std::max(free_from, interval.high);
            }
            count_before(part.high);
            if (flaw_) return;
        }
    }

    static FinePoint place(const FineBox& box, Vec local) {
        return {box.min.x + std::llround(local.x), box.min.y + std::llround(local.y)};
    }
    static bool lie_on_one_line(const Edge& e, const Edge& f) {
        const auto turn = [&](FinePoint p) {
            return static_cast<Int128>(e.b.x - e.a.x) * (p.y - e.a.y) -
                   static_cast<Int128>(e.b.y - e.a.y) * (p.x - e.a.x);
        };
        return turn(f.a) == 0 && turn(f.b) == 0;
    }

    int count_at(FinePoint at, FinePoint corner, int count, const std::vector<std::uint32_t>& ids) const {
        const FinePoint turn{corner.x, at.y};
        for (const std::uint32_t id : ids) {
            count += gain_along_y(edges_[id], corner, turn) + gain_along_x(edges_[id], turn, at);
        }
        return count;
    }

    const WindingRange range_;
    std::vector<Edge> edges_;
    double radius_ = 1, blocking_radius_ = 1, longest_run_ = INFINITY;  // fine units
    std::int64_t margin_ = 1;
    std::optional<WindingFlaw> flaw_;
    std::vector<LocalEdge> local_;
    std::array<std::vector<Interval>, 2> blocked_;
};

}  // namespace

Vec to_px(FinePoint p) {
    const double per_px = grid_per_px * static_cast<double>(fine_per_grid);
    return {static_cast<double>(p.x) / per_px, static_cast<double>(p.y) / per_px};
}

std::optional<WindingFlaw> find_wrong_winding(std::span<const DirectedEdge> edges, const WindingRange& range) {
    return Search(edges, range).run();
}

int winding(RingView ring, FinePoint at) {
    int count = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Edge edge{to_fine(ring[i]), to_fine(ring[i + 1 == ring.size() ? 0 : i + 1])};
        // Edges that a way from far on the left to the place would cross.
        if (!spans_y(edge, at.y)) continue;
        const int there = side(edge, at);
        const int far_left = edge.a.y < edge.b.y ? 1 : -1;
        count += (there - far_left) / 2;
    }
    return count;
}

}  // namespace filigree
