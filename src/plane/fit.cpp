#include "plane/fit.h"

#include <algorithm>
#include <cmath>

#include "plane/near_points.h"

namespace filigree {

namespace {

constexpr int halvings = 7;      // of a bisection: sizes come out to 1 %
constexpr int most_rounds = 12;  // of shrinking neighbours

struct Outline {  // of one object
    std::vector<Edge> edges;
    std::vector<Vec> starts;  // a point of every ring
    VecBox box;
};

Outline outline_of(const Motif& motif, const Pose& pose) {
    Outline outline;
    outline.edges.reserve(motif.points.size());
    const Vec along = pose.direction * pose.radius, aside = perpendicular(along);
    const auto placed = [&](std::size_t i) { return pose.at + along * motif.points[i].x + aside * motif.points[i].y; };
    outline.box = {pose.at, pose.at};
    std::uint32_t first = 0;
    for (const std::uint32_t end : motif.ring_ends) {
        Vec from = placed(end - 1);
        outline.starts.push_back(from);
        for (std::uint32_t i = first; i < end; ++i) {
            const Vec to = placed(i);
            outline.edges.push_back({from, to});
            outline.box.min = {std::min(outline.box.min.x, to.x), std::min(outline.box.min.y, to.y)};
            outline.box.max = {std::max(outline.box.max.x, to.x), std::max(outline.box.max.y, to.y)};
            from = to;
        }
        first = end;
    }
    return outline;
}

VecBox widened(const VecBox& box, double by) {
    return {{box.min.x - by, box.min.y - by}, {box.max.x + by, box.max.y + by}};
}

bool cross_each_other(const Edge& a, const Edge& b) {
    const Vec along_a = a.to - a.from, along_b = b.to - b.from;
    return (cross(along_a, b.from - a.from) > 0) != (cross(along_a, b.to - a.from) > 0) &&
           (cross(along_b, a.from - b.from) > 0) != (cross(along_b, a.to - b.from) > 0);
}

bool come_near(const Edge& a, const Edge& b, double gap) {
    if (!overlaps(around(a, gap), around(b, 0))) return false;
    const double gap2 = gap * gap;
    return is_nearer(a, b.from, gap2) || is_nearer(a, b.to, gap2) || is_nearer(b, a.from, gap2) ||
           is_nearer(b, a.to, gap2) || cross_each_other(a, b);
}

bool is_inside(const Outline& outline, Vec p) {
    if (!overlaps(outline.box, around(p, 0))) return false;
    bool inside = false;
    for (const Edge& e : outline.edges) {
        if ((e.from.y <= p.y) == (e.to.y <= p.y)) continue;
        const bool rises = e.from.y < e.to.y;
        const Vec low = rises ? e.from : e.to, high = rises ? e.to : e.from;
        if (cross(high - low, p - low) > 0) inside = !inside;
    }
    return inside;
}

bool overlap(const Outline& a, const Outline& b, double gap) {
    const VecBox box = widened(a.box, gap);
    if (!overlaps(box, b.box)) return false;
    for (const Edge& of_b : b.edges) {
        if (!overlaps(box, around(of_b, 0))) continue;
        for (const Edge& of_a : a.edges) {
            if (come_near(of_a, of_b, gap)) return true;
        }
    }
    return std::any_of(a.starts.begin(), a.starts.end(), [&](Vec p) { return is_inside(b, p); }) ||
           std::any_of(b.starts.begin(), b.starts.end(), [&](Vec p) { return is_inside(a, p); });
}

// The largest part of 1 that does, to 1 %, given that it does not do whole; 0 where not even `least` does.
template <class Fits>
double largest_part(double least, Fits fits) {
    double low = least, high = 1;
    if (low > 0 && !fits(low)) return 0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

Pose scaled(const Pose& pose, double by) { return {pose.at, pose.direction, pose.radius * by}; }

class Fitting {
public:
    Fitting(std::span<Pose> objects, const Motif& motif, const EdgeTree& border, const FitOptions& options)
        : objects_(objects), motif_(motif), border_(border), options_(options) {}

    void run() {
        std::vector<double> wanted;
        wanted.reserve(objects_.size());
        double largest = 0;
        for (Pose& pose : objects_) {
            wanted.push_back(pose.radius);
            if (options_.border_counts) keep_inside(pose);
            largest = std::max(largest, pose.radius);
        }
        std::vector<Vec> places;
        places.reserve(objects_.size());
        for (const Pose& pose : objects_) places.push_back(pose.at);
        if (shrink_neighbours(NearPoints(places, 2 * largest + options_.gap))) {
            for (std::size_t i = 0; i < objects_.size(); ++i) {
                if (objects_[i].radius < options_.neighbour_least * wanted[i]) objects_[i].radius = 0;
            }
        }
    }

private:
    void keep_inside(Pose& pose) const {
        const double reach = pose.radius + options_.border_gap;
        if (!border_.is_any_nearer(pose.at, reach)) return;
        if (motif_.is_round) {
            const double distance = border_.place(pose.at, reach, reach).distance;
            const double most = distance - options_.border_gap;
            pose.radius = most >= options_.border_least * pose.radius ? std::max(most, 0.0) : 0;
            return;
        }
        const auto lies_inside = [&](double part) {
            const Outline outline = outline_of(motif_, scaled(pose, part));
            return !border_.any(widened(outline.box, options_.border_gap), [&](std::uint32_t e) {
                const Edge& edge = border_.edges()[e];
                if (!overlaps(widened(outline.box, options_.border_gap), around(edge, 0))) return false;
                return is_inside(outline, edge.from) ||
                       std::any_of(outline.edges.begin(), outline.edges.end(),
                                   [&](const Edge& own) { return come_near(own, edge, options_.border_gap); });
            });
        };
        // A ring does not hold its own place: what it encloses must be inside the region, too, so all is well
        // where no border is near its outline and none starts inside it.
        if (!lies_inside(1)) pose.radius *= largest_part(std::max(options_.border_least, 1e-3), lies_inside);
    }

    // Pair by pair, both by the same part, all at once; again while that leaves some overlapping. Those that still do
    // give way to the ones before them.
    bool shrink_neighbours(const NearPoints& near) {
        bool any = false;
        std::vector<std::uint8_t> is_new(objects_.size(), 1);
        outlines_.resize(motif_.is_round ? 0 : objects_.size());
        for (int round = 0; round < most_rounds; ++round) {
            std::vector<double> parts(objects_.size(), 1);
            for (std::size_t i = 0; i < objects_.size(); ++i) {
                for (const std::uint32_t j : near.of(i)) {
                    if (j > i || (!is_new[i] && !is_new[j])) continue;
                    const double part = part_of_pair(i, j);
                    parts[i] = std::min(parts[i], part);
                    parts[j] = std::min(parts[j], part);
                }
            }
            bool any_now = false;
            for (std::size_t i = 0; i < objects_.size(); ++i) {
                is_new[i] = parts[i] < 1;
                if (!is_new[i]) continue;
                objects_[i].radius *= parts[i];
                if (!motif_.is_round) outlines_[i] = {};
                any_now = true;
            }
            any = any || any_now;
            if (!any_now || motif_.is_round) return any;
        }
        for (std::size_t i = 0; i < objects_.size(); ++i) {
            for (const std::uint32_t j : near.of(i)) {
                if (j < i && part_of_pair(i, j) < 1) objects_[i].radius = 0;
            }
        }
        return any;
    }

    double part_of_pair(std::size_t i, std::size_t j) {
        const Pose &a = objects_[i], &b = objects_[j];
        if (a.radius == 0 || b.radius == 0) return 1;
        const double together = a.radius + b.radius;
        const double apart = std::max(length(a.at - b.at) - options_.gap, 0.0);
        if (together <= apart) return 1;
        if (motif_.is_round) return apart / together * (1 - 1e-12);
        if (!overlap(outline(i), outline(j), options_.gap)) return 1;
        // Where the circles are apart there is nothing to ask.
        return largest_part(apart / together * (1 - 1e-12), [&](double part) {
            return part * together <= apart ||
                   !overlap(outline_of(motif_, scaled(a, part)), outline_of(motif_, scaled(b, part)), options_.gap);
        });
    }
    const Outline& outline(std::size_t i) {
        if (outlines_[i].edges.empty()) outlines_[i] = outline_of(motif_, objects_[i]);
        return outlines_[i];
    }

    std::span<Pose> objects_;
    const Motif& motif_;
    const EdgeTree& border_;
    const FitOptions& options_;
    std::vector<Outline> outlines_;
};

}  // namespace

void fit(std::span<Pose> objects, const Motif& motif, const EdgeTree& border, const FitOptions& options) {
    Fitting(objects, motif, border, options).run();
}

}  // namespace filigree
