#include "scene/drawn_pen.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "plane/clean.h"
#include "plane/crossings.h"
#include "plane/noise.h"

namespace filigree {
namespace {

// Lengths in pens unless said otherwise.
constexpr double pressure = 0.2;            // how much wider or narrower a stroke becomes on the way, of its width
constexpr double pressure_wave = 22;        // from one place that is pressed to the next
constexpr double least_pressure_wave = 14;  // px
constexpr double start_blob = 0.12;         // how much wider it starts, of its width
constexpr double end_taper = 0.35;          // how much narrower it ends
constexpr double blob_length = 2.5, taper_length = 5;
constexpr double least_over = -0.15, most_over = 0.8;  // how far an open stroke goes past its ends
constexpr double least_lap = -1.6, most_lap = 2.4;     // how far a closed one goes past its start
constexpr double drift = 0.45, drift_length = 12;      // how far aside it comes back, and from where on
constexpr double longest_step = 4;                     // between points of the outline
constexpr double least_step = 4;                       // px
constexpr double longest_mitre = 1.25;
constexpr double round_turn_cos = 0.8;  // 37 degrees: sharper corners are rounded outside

struct Sample {
    Vec at;
    double along = 0;  // px from the start
};

class Stroke {
public:
    Stroke(std::span<const Point> line, bool is_closed, double pen, Key key)
        : is_closed_(is_closed), pen_(pen), key_(key), origin_(line[0]) {
        std::vector<Vec> points;
        for (const Point p : line) {
            const Vec v = to_px(Point{p.x - origin_.x, p.y - origin_.y});
            if (points.empty() || points.back() != v) points.push_back(v);
        }
        if (is_closed_ && points.size() > 1) points.push_back(points[0]);
        double along = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) along += length(points[i] - points[i - 1]);
            line_.push_back({points[i], along});
        }
    }

    Polygons outline() {
        if (line_.size() < 2) return {};
        length_ = line_.back().along;
        if (is_closed_) {
            lap();
        } else {
            lengthen();
        }
        divide();
        add_sides();
        return clean_outline();
    }

private:
    double chance(std::string_view name, double low, double high) const {
        return low + (high - low) * to_unit(random_bits(0, key_, name));
    }

    // Short strokes are drawn with less play.
    double play() const { return std::min(1.0, length_ / (12 * pen_)); }

    void lengthen() {
        const double at_start = chance("start", least_over, most_over) * pen_ * play(),
                     at_end = chance("end", least_over, most_over) * pen_ * play();
        shorten(std::max(-at_start, 0.0), std::max(-at_end, 0.0));
        const auto past = [](Vec end, Vec before, double by) {
            const Vec d = end - before;
            return end + d * (by / std::max(length(d), 1e-9));
        };
        if (at_start > 0) line_.front().at = past(line_.front().at, line_[1].at, at_start);
        if (at_end > 0) line_.back().at = past(line_.back().at, line_[line_.size() - 2].at, at_end);
    }

    void lap() {
        const double past = chance("lap", least_lap, most_lap) * pen_ * play();
        if (past < 0) {
            shorten(0, -past);
        } else {
            for (std::size_t i = 1; i + 1 < line_.size(); ++i) {
                const Sample before = line_[i - 1], next = line_[i];
                if (before.along >= past) break;
                const double share = std::min(1.0, (past - before.along) / (next.along - before.along));
                line_.push_back({before.at + share * (next.at - before.at),
                                 length_ + before.along + share * (next.along - before.along)});
            }
        }
        const double total = line_.back().along, aside = chance("drift", -drift, drift) * pen_ * play();
        const double from = total - std::min(drift_length * pen_, total / 3);
        std::vector<Vec> moved;
        for (std::size_t i = 0; i < line_.size(); ++i) {
            const double t = std::clamp((line_[i].along - from) / (total - from), 0.0, 1.0);
            moved.push_back(line_[i].at + (aside * t * t * (3 - 2 * t)) * normal_at(i));
        }
        for (std::size_t i = 0; i < line_.size(); ++i) line_[i].at = moved[i];
    }

    void shorten(double at_start, double at_end) {
        const auto cut_end = [this](double by) {
            if (!(by > 0)) return;
            const double until = line_.back().along - by;
            while (line_.size() > 2 && line_[line_.size() - 2].along >= until) line_.pop_back();
            const Sample before = line_[line_.size() - 2], last = line_.back();
            const double share = std::clamp((until - before.along) / (last.along - before.along), 0.1, 1.0);
            line_.back() = {before.at + share * (last.at - before.at),
                            before.along + share * (last.along - before.along)};
        };
        const auto turn = [this] {
            const double total = line_.back().along + line_.front().along;
            std::reverse(line_.begin(), line_.end());
            for (Sample& sample : line_) sample.along = total - sample.along;
        };
        cut_end(at_end);
        if (!(at_start > 0)) return;
        turn();
        cut_end(at_start);
        turn();
    }

    void divide() {
        const double step = std::max(longest_step * pen_, least_step);
        std::vector<Sample> divided;
        for (std::size_t i = 0; i < line_.size(); ++i) {
            if (i > 0) {
                const Sample from = line_[i - 1], to = line_[i];
                const double pieces = std::min(std::ceil((to.along - from.along) / step), 1e6);
                for (double k = 1; k < pieces; ++k) {
                    divided.push_back({from.at + (k / pieces) * (to.at - from.at),
                                       from.along + (k / pieces) * (to.along - from.along)});
                }
            }
            divided.push_back(line_[i]);
        }
        line_ = std::move(divided);
    }

    Vec direction(std::size_t segment) const {
        const Vec d = line_[segment + 1].at - line_[segment].at;
        const double l = length(d);
        return l > 0 ? d * (1 / l) : Vec{1, 0};
    }
    // To the right of the way, where y grows downwards.
    Vec normal_at(std::size_t i) const {
        const Vec before = direction(i > 0 ? i - 1 : 0), after = direction(std::min(i, line_.size() - 2));
        const Vec sum = perpendicular(before) + perpendicular(after);
        const double l = length(sum);
        return l > 1e-3 ? sum * (1 / l) : perpendicular(before);
    }

    double half_width(double along) const {
        const double total = line_.back().along, wave = std::max(pressure_wave * pen_, least_pressure_wave);
        const auto bump = [](double t) { return t < 1 ? (1 - t) * (1 - t) * (1 + 2 * t) : 0; };
        const double pressed = pressure * noise_along(key_.value, along / wave);
        const double blob = start_blob * bump(along / (blob_length * pen_)) * play();
        const double taper = end_taper * bump((total - along) / (taper_length * pen_)) * play();
        return 0.5 * pen_ * (1 + pressed + blob - taper);
    }

    void add(Vec p) {
        const Point by = snap(p);
        const Point q{origin_.x + by.x, origin_.y + by.y};
        if (ring_.empty() || ring_.back() != q) ring_.push_back(q);
    }

    // One side there, a round end, the other side back, another round end.
    void add_sides() {
        const std::size_t count = line_.size();
        for (std::size_t i = 0; i < count; ++i) add_corner(i, 1);
        add_cap(line_[count - 1], direction(count - 2));
        for (std::size_t i = count; i > 0; --i) add_corner(i - 1, -1);
        add_cap(line_[0], -direction(0));
        while (ring_.size() > 1 && ring_.back() == ring_.front()) ring_.pop_back();
    }

    void add_corner(std::size_t i, double side) {
        const Vec normal = normal_at(i), at = line_[i].at;
        const double wide = side * half_width(line_[i].along);
        if (i == 0 || i + 1 == line_.size()) return add(at + wide * normal);
        const Vec before = direction(i - 1), after = direction(i);
        const double turn_cos = dot(before, after);
        const bool is_outside = cross(before, after) * side < 0;
        if (turn_cos < round_turn_cos && is_outside) {
            const Vec first = perpendicular(side > 0 ? before : after), last = perpendicular(side > 0 ? after : before);
            add(at + wide * first);
            add(at + wide * normal);
            add(at + wide * last);
            return;
        }
        const double half_cos = std::sqrt(std::max(0.0, (1 + turn_cos) / 2));
        add(at + (wide * std::min(longest_mitre, 1 / std::max(half_cos, 1e-3))) * normal);
    }

    void add_cap(const Sample& end, Vec ahead) {
        const double wide = half_width(end.along);
        for (const double degrees : {60.0, 30.0, 0.0, -30.0, -60.0}) {
            const elementary::CosSin turn = elementary::cos_sin_degrees(degrees);
            add(end.at + wide * (turn.cos * ahead + turn.sin * perpendicular(ahead)));
        }
    }

    Polygons clean_outline() {
        if (ring_.size() < 3) return {};
        std::vector<DirectedLink> links;
        for (std::uint32_t i = 0; i < ring_.size(); ++i) {
            links.push_back({i, i + 1 < ring_.size() ? i + 1 : 0});
        }
        std::vector<std::uint32_t> found;
        CrossingFinder().find(links, ring_, found);
        const Int128 doubled = doubled_area(ring_);
        std::vector<Point> sorted = ring_;
        std::sort(sorted.begin(), sorted.end());
        const bool is_simple =
            found.empty() && doubled != 0 && std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
        if (!is_simple) return clean(std::vector<std::vector<Point>>{ring_}, FillRule::nonzero);
        if (doubled < 0) std::reverse(ring_.begin(), ring_.end());
        Polygons outline;
        outline.add_ring(ring_);
        outline.end_polygon();
        return outline;
    }

    const bool is_closed_;
    const double pen_;
    const Key key_;
    const Point origin_;
    std::vector<Sample> line_;
    double length_ = 0;  // of the line as given
    std::vector<Point> ring_;
};

}  // namespace

Polygons drawn_stroke(std::span<const Point> line, bool is_closed, double pen, Key key) {
    if (line.size() < 2 || !(pen > 0) || !std::isfinite(pen)) return {};
    return Stroke(line, is_closed, pen, key).outline();
}

}  // namespace filigree
