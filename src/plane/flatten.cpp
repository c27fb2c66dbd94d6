// Curves to polylines.
#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "plane/arc.h"
#include "plane/path.h"

namespace filigree {

namespace {

constexpr double most_pieces = 1e6;

std::uint32_t piece_count(double wanted) {
    if (!(wanted > 1)) return 1;  // NaN too
    return static_cast<std::uint32_t>(std::ceil(std::min(wanted, most_pieces)));
}

class Flattener {
public:
    explicit Flattener(double tolerance) : tolerance_(std::max(1 / grid_per_px, tolerance)) {}

    std::vector<Polyline> flatten(const Path& path) {
        std::size_t at = 0;
        for (const Verb verb : path.verbs) {
            const std::size_t count = point_count(verb);
            if (path.points.size() - at < count) break;
            draw(verb, path.points.data() + at);
            at += count;
        }
        return std::move(lines_);
    }

private:
    void draw(Verb verb, const Vec* points) {
        if (verb == Verb::move) {
            start_ = here_ = points[0];
            is_open_ = false;
            return;
        }
        if (!is_open_) {
            lines_.push_back({{here_}, false});
            is_open_ = true;
        }
        switch (verb) {
            case Verb::move:
                break;
            case Verb::line:
                add(points[0]);
                break;
            case Verb::quadratic:
                add_quadratic(points[0], points[1]);
                break;
            case Verb::cubic:
                add_cubic(points[0], points[1], points[2]);
                break;
            case Verb::arc:
                add_arc(points, points[2]);
                break;
            case Verb::close:
                close();
                break;
        }
    }

    void add(Vec p) {
        std::vector<Vec>& line = lines_.back().points;
        if (!(line.back() == p)) line.push_back(p);
        here_ = p;
    }

    void close() {
        Polyline& line = lines_.back();
        line.closed = true;
        while (line.points.size() > 1 && line.points.back() == line.points.front()) line.points.pop_back();
        here_ = start_;
        is_open_ = false;
    }

    // A chord over 1/n of a Bezier's parameter lies within |second derivative| / (8 n^2) of it. The sums are
    // such that the reverse of a curve takes the same values.
    void add_quadratic(Vec control, Vec to) {
        const Vec from = here_;
        const double bend = length((from + to) - 2 * control);
        const bool on_plane = is_on_plane(from) && is_on_plane(control) && is_on_plane(to);
        const std::uint32_t count = on_plane ? piece_count(std::sqrt(bend / (4 * tolerance_))) : 1;
        for (std::uint32_t i = 1; i < count; ++i) {
            const double t = static_cast<double>(i) / count, s = static_cast<double>(count - i) / count;
            add(((s * s) * from + (t * t) * to) + (2 * (s * t)) * control);
        }
        add(to);
    }

    void add_cubic(Vec first, Vec second, Vec to) {
        const Vec from = here_;
        const double bend = std::max(length((from + second) - 2 * first), length((first + to) - 2 * second));
        const bool on_plane = is_on_plane(from) && is_on_plane(first) && is_on_plane(second) && is_on_plane(to);
        const std::uint32_t count = on_plane ? piece_count(std::sqrt(0.75 * bend / tolerance_)) : 1;
        for (std::uint32_t i = 1; i < count; ++i) {
            const double t = static_cast<double>(i) / count, s = static_cast<double>(count - i) / count;
            add(((s * s * s) * from + (t * t * t) * to) + ((3 * (s * s * t)) * first + (3 * (t * t * s)) * second));
        }
        add(to);
    }

    // A chord over the angle a of a circle lies within r a^2 / 8 of it; of an ellipse with r the larger radius.
    void add_arc(const Vec shape[2], Vec to) {
        const CentreArc arc = centre_arc(here_, shape, to);
        if (!arc.is_line && is_on_plane(here_) && is_on_plane(point_at(arc, 0.5)) && is_on_plane(to)) {
            const double turn = std::fabs(arc.turn);
            const double least = turn / (elementary::pi / 2);
            const std::uint32_t count =
                piece_count(std::max(least, turn * std::sqrt(arc.largest_radius / (8 * tolerance_))));
            for (std::uint32_t i = 1; i < count; ++i) add(point_at(arc, static_cast<double>(i) / count));
        }
        add(to);
    }

    double tolerance_;
    std::vector<Polyline> lines_;
    Vec start_, here_;
    bool is_open_ = false;
};

}  // namespace

std::vector<Polyline> flatten(const Path& path, double tolerance) { return Flattener(tolerance).flatten(path); }

}  // namespace filigree
