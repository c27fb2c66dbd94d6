// From a ring that follows pixels to the outline that they stand for.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <utility>

#include "plane/silhouette_rings.h"

namespace filigree {
namespace {

constexpr double tolerance = 0.5;  // px, of a straight stretch
// What a squared px of misfit costs against one more stretch. More gives shorter stretches along curves.
constexpr double misfit_cost = 0.1;
constexpr std::size_t blurred_points = 2;  // at each end of a stretch, where the blur bent the ring
constexpr double longest_chamfer = 5;      // px
constexpr double farthest_vertex = 0.75;   // px beside a straight joint; more at sharp ones, as the blur takes more off
constexpr double gentle_cut = 0.5;         // px that a curve may cut off a joint
constexpr double parallel = 0.1;           // sine of the turn below which lines do not say where they meet

struct Stretch {
    std::size_t from = 0, to = 0;  // points of the ring, both included
    Vec centre, direction;         // its line; a unit vector, along the ring
};

// Sums over the first points of a ring, for fits to any stretch of it.
struct Moments {
    double count = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};
Moments operator-(const Moments& a, const Moments& b) {
    return {a.count - b.count, a.x - b.x, a.y - b.y, a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
}

class RingFit {
public:
    explicit RingFit(std::vector<Vec> ring) : ring_(std::move(ring)) {
        start_at_a_corner();
        const std::size_t n = ring_.size();
        sums_.resize(n + 1);
        for (std::size_t i = 0; i < n; ++i) {
            const Vec p = ring_[i] - ring_[0];
            const Moments& s = sums_[i];
            sums_[i + 1] = {s.count + 1, s.x + p.x, s.y + p.y, s.xx + p.x * p.x, s.xy + p.x * p.y, s.yy + p.y * p.y};
        }
    }

    Path outline() && {
        find_stretches();
        if (stretches_.size() < 3) return as_it_is();
        fit_lines();
        drop_chamfers();
        find_vertices();
        if (bend_lines()) find_vertices();
        return drawn();
    }

private:
    Vec at(std::size_t i) const { return ring_[i % ring_.size()]; }

    // The point farthest from the middle lies at a corner if there is one, and stretches should end there.
    void start_at_a_corner() {
        Vec sum;
        for (const Vec p : ring_) sum = sum + p;
        const Vec middle = sum * (1 / static_cast<double>(ring_.size()));
        const auto farther = [&](Vec a, Vec b) { return dot(a - middle, a - middle) < dot(b - middle, b - middle); };
        std::rotate(ring_.begin(), std::max_element(ring_.begin(), ring_.end(), farther), ring_.end());
    }

    // The sum of squared distances of points [from, to] from the line that fits them best.
    double misfit(std::size_t from, std::size_t to) const {
        const Moments m = sums_[std::min(to + 1, ring_.size())] - sums_[from];
        const double xx = m.xx - m.x * m.x / m.count, yy = m.yy - m.y * m.y / m.count, xy = m.xy - m.x * m.y / m.count;
        const double half = (xx - yy) / 2;
        return std::max(0.0, (xx + yy) / 2 - std::sqrt(half * half + xy * xy));
    }

    // The directions from a point that pass within the tolerance of all points seen so far.
    struct Cone {
        Vec low, high;
        bool is_whole = true;

        // Whether any direction is left.
        bool narrow(Vec to) {
            const double far = dot(to, to);
            if (far <= tolerance * tolerance) return true;
            if (!is_whole && dot(to, low + high) <= 0) return false;
            const double along = std::sqrt(far - tolerance * tolerance);
            const Vec least = along * to - tolerance * perpendicular(to),
                      most = along * to + tolerance * perpendicular(to);
            if (is_whole || cross(low, least) > 0) low = least;
            if (is_whole || cross(high, most) < 0) high = most;
            is_whole = false;
            return cross(low, high) >= 0;
        }
        bool holds(Vec to) const {
            return is_whole || (cross(low, to) >= 0 && cross(to, high) >= 0 && dot(to, low + high) > 0);
        }
    };

    // The cheapest way around in stretches within the tolerance.
    void find_stretches() {
        const std::size_t n = ring_.size();
        std::vector<double> cost(n + 1, HUGE_VAL);
        std::vector<std::size_t> before(n + 1, 0);
        cost[0] = 0;
        for (std::size_t i = 0; i < n; ++i) {
            Cone cone;
            for (std::size_t j = i + 1; j <= n; ++j) {
                const Vec to = at(j) - at(i);
                if (cone.holds(to)) {
                    const double total = cost[i] + 1 + misfit_cost * misfit(i, j);
                    if (total < cost[j]) {
                        cost[j] = total;
                        before[j] = i;
                    }
                }
                if (!cone.narrow(to)) break;
            }
        }
        for (std::size_t i = n; i > 0; i = before[i]) stretches_.push_back({before[i], i, {}, {}});
        std::reverse(stretches_.begin(), stretches_.end());
    }

    // Points of a stretch that say where it lies.
    static std::pair<std::size_t, std::size_t> inner_points(const Stretch& s) {
        return s.to - s.from >= 2 * blurred_points + 3 ? std::pair{s.from + blurred_points, s.to - blurred_points}
                                                       : std::pair{s.from, s.to};
    }

    void fit_lines() {
        for (Stretch& stretch : stretches_) {
            const auto [from, to] = inner_points(stretch);
            Vec sum;
            for (std::size_t i = from; i <= to; ++i) sum = sum + at(i);
            stretch.centre = sum * (1 / static_cast<double>(to - from + 1));
            double xx = 0, xy = 0, yy = 0;
            for (std::size_t i = from; i <= to; ++i) {
                const Vec p = at(i) - stretch.centre;
                xx += p.x * p.x, xy += p.x * p.y, yy += p.y * p.y;
            }
            // The main axis of the points, of the two forms the one that is no small difference.
            const double half = (xx - yy) / 2, root = std::sqrt(half * half + xy * xy);
            Vec direction = half >= 0 ? Vec{half + root, xy} : Vec{xy, root - half};
            const Vec along = chord(stretch);
            if (!(length(direction) > 0)) direction = along;
            if (dot(direction, along) < 0) direction = -direction;
            stretch.direction = direction * (1 / length(direction));
        }
    }

    Vec chord(const Stretch& s) const { return at(s.to) - at(s.from); }

    // Where the lines of two stretches meet; none where they hardly turn.
    static std::optional<Vec> meeting(const Stretch& a, const Stretch& b) {
        const double sine = cross(a.direction, b.direction);
        if (std::fabs(sine) < parallel) return {};
        return a.centre + (cross(b.centre - a.centre, b.direction) / sine) * a.direction;
    }

    // How far from the ring two lines may meet: the sharper the joint, the more the blur took off. Half of the angle
    // inside is what counts: its sine is that of half of what the turn leaves of half a circle.
    static double reach(const Stretch& a, const Stretch& b) {
        const double half_sine = std::sqrt(std::max(0.0, (1 + dot(a.direction, b.direction)) / 2));
        return farthest_vertex / std::max(half_sine, 0.3);
    }

    // The point of the ring from the end of one stretch to the start of another that is nearest to a place.
    Vec nearest(const Stretch& a, const Stretch& b, Vec to) const {
        const std::size_t end = b.from < a.to ? b.from + ring_.size() : b.from;
        Vec best = at(a.to);
        for (std::size_t i = a.to + 1; i <= end; ++i) {
            if (length(at(i) - to) < length(best - to)) best = at(i);
        }
        return best;
    }

    static double distance(const Stretch& s, Vec p) { return std::fabs(cross(s.direction, p - s.centre)); }

    // A short stretch across a corner is the blur's work where the lines beside it pass close by and meet close by.
    bool is_chamfer(const Stretch& a, const Stretch& s, const Stretch& b) const {
        const double size = length(chord(s));
        if (size > longest_chamfer || std::min(length(chord(a)), length(chord(b))) < 3 * size) return false;
        if (cross(a.direction, s.direction) * cross(s.direction, b.direction) <= 0) return false;
        const std::optional<Vec> corner = meeting(a, b);
        if (!corner || length(*corner - nearest(a, b, *corner)) > reach(a, b)) return false;
        for (std::size_t i = s.from; i <= s.to; ++i) {
            if (std::min(distance(a, at(i)), distance(b, at(i))) > farthest_vertex) return false;
        }
        return true;
    }

    void drop_chamfers() {
        for (std::size_t k = 0; k < stretches_.size() && stretches_.size() > 3;) {
            const std::size_t count = stretches_.size();
            if (is_chamfer(stretches_[(k + count - 1) % count], stretches_[k], stretches_[(k + 1) % count])) {
                stretches_.erase(stretches_.begin() + static_cast<std::ptrdiff_t>(k));
            } else {
                ++k;
            }
        }
    }

    void find_vertices() {
        const std::size_t count = stretches_.size();
        vertices_.resize(count);
        for (std::size_t k = 0; k < count; ++k) {
            const Stretch& a = stretches_[(k + count - 1) % count];
            const Stretch& b = stretches_[k];
            const Vec joint = (at(a.to) + at(b.from)) * 0.5;
            const auto onto = [&](const Stretch& s) {
                return s.centre + dot(joint - s.centre, s.direction) * s.direction;
            };
            const Vec wanted = meeting(a, b).value_or((onto(a) + onto(b)) * 0.5);
            const Vec from = nearest(a, b, wanted);
            const double apart = length(wanted - from), most = reach(a, b);
            vertices_[k] = apart <= most ? wanted : from + (wanted - from) * (most / apart);
        }
    }

    // A joint: where it starts to leave its first line, where it is back on its second, and how far apart.
    struct Joint {
        Vec from, to;
        double depth = 0;  // of the vertex over the chord
        double pull() const { return depth > 0 ? 4.0 / 3 * (depth - gentle_cut) / depth : 0; }
        bool is_corner() const { return pull() >= 1; }
    };

    Vec middle(std::size_t k) const {
        const Vec from = vertices_[k], to = vertices_[(k + 1) % vertices_.size()];
        const double whole = dot(to - from, stretches_[k].direction),
                     part = dot(stretches_[k].centre - from, stretches_[k].direction);
        const bool is_within = part > 0.25 * whole && part < 0.75 * whole;
        return is_within ? from + (part / whole) * (to - from) : (from + to) * 0.5;
    }

    // Between stretches of very different length a curve keeps near the shorter.
    Joint joint(std::size_t k) const {
        const std::size_t count = vertices_.size();
        const Vec v = vertices_[k], back = middle((k + count - 1) % count) - v, on = middle(k) - v;
        const double before = length(back), after = length(on);
        Joint joint{v, v, 0};
        if (!(before > 0) || !(after > 0)) return joint;
        joint.from = v + back * std::min(1.0, 1.5 * after / before);
        joint.to = v + on * std::min(1.0, 1.5 * before / after);
        const Vec chord = joint.to - joint.from;
        joint.depth = length(chord) > 0 ? std::fabs(cross(chord, v - joint.from)) / length(chord) : HUGE_VAL;
        return joint;
    }

    // Stretches between two curves are arcs: the line becomes the tangent in the middle of the parabola through
    // their points, as the best line lies inside. Whether any did.
    bool bend_lines() {
        const std::size_t count = stretches_.size();
        std::vector<char> is_gentle(count);
        for (std::size_t k = 0; k < count; ++k) is_gentle[k] = joint(k).is_corner() ? 0 : 1;
        bool any = false;
        for (std::size_t k = 0; k < count; ++k) {
            if (is_gentle[k] == 0 || is_gentle[(k + 1) % count] == 0) continue;
            bend(stretches_[k]);
            any = true;
        }
        return any;
    }

    void bend(Stretch& line) {
        const auto [from, to] = inner_points(line);
        const Vec across = perpendicular(line.direction);
        const double count = static_cast<double>(to - from + 1);
        double second = 0, third = 0;
        for (std::size_t i = from; i <= to; ++i) {
            const double u = dot(at(i) - line.centre, line.direction);
            second += u * u / count, third += u * u * u / count;
        }
        if (!(second > 0)) return;
        double top = 0, bottom = 0;
        for (std::size_t i = from; i <= to; ++i) {
            const double u = dot(at(i) - line.centre, line.direction), v = dot(at(i) - line.centre, across);
            const double square = u * u - second - third / second * u;  // what a square adds to a line
            top += square * v, bottom += square * square;
        }
        if (!(bottom > 0)) return;
        const double bow = top / bottom, rise = -bow * third / second;
        const Vec direction = line.direction + rise * across;
        line.centre = line.centre - (bow * second) * across;
        line.direction = direction * (1 / length(direction));
    }

    Path drawn() const {
        Path path;
        const auto add = [&](Verb verb, std::initializer_list<Vec> points) {
            path.verbs.push_back(verb);
            path.points.insert(path.points.end(), points);
        };
        for (std::size_t k = 0; k < vertices_.size(); ++k) {
            const Joint at_joint = joint(k);
            const Verb first = k == 0 ? Verb::move : Verb::line;
            const Vec v = vertices_[k];
            if (at_joint.is_corner()) {
                add(first, {v});
                continue;
            }
            const double pull = std::max(at_joint.pull(), 2.0 / 3);  // two thirds make it a parabola
            add(first, {at_joint.from});
            add(Verb::cubic,
                {at_joint.from + pull * (v - at_joint.from), at_joint.to + pull * (v - at_joint.to), at_joint.to});
        }
        path.verbs.push_back(Verb::close);
        return path;
    }

    Path as_it_is() const {
        Path path;
        for (const Vec p : ring_) {
            path.verbs.push_back(path.verbs.empty() ? Verb::move : Verb::line);
            path.points.push_back(p);
        }
        path.verbs.push_back(Verb::close);
        return path;
    }

    std::vector<Vec> ring_;
    std::vector<Moments> sums_;  // before each point
    std::vector<Stretch> stretches_;
    std::vector<Vec> vertices_;  // where they begin
};

}  // namespace

Path fitted_outline(std::vector<Vec> ring) { return RingFit(std::move(ring)).outline(); }

}  // namespace filigree
