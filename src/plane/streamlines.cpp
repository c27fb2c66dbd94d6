#include "plane/streamlines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace filigree {
namespace {

// All in separations.
constexpr double step_length = 1.0 / 3;
constexpr double nearest = 0.5;         // of two lines
constexpr double free_of_lines = 0.97;  // what a seed keeps
constexpr double own_way = 3;           // along a line, its own points do not hinder it
constexpr double shortest = 1.5;        // a line that is kept
constexpr double shortest_ring = 2.5;   // all round
constexpr double shortest_tie = 3;      // a line that merges at both ends
constexpr double nearest_border = 0.2;  // where lines follow the border
constexpr double apart_from_failure = 0.6;
constexpr double whole_turn = 5.5;  // in sums of sines, from step to step
// Slopes, where lines climb.
constexpr double flat = 0.5, steep = 0.75;
constexpr double lead = 1.1;  // how far along its neighbour a line bends into it

struct Sample {
    Vec at;
    std::uint32_t line = 0, index = 0;  // of the line's samples
    double way = 0;                     // along the line from its seed
};

// The samples of all lines by cells of one separation.
class SampleGrid {
public:
    SampleGrid(Vec low, Vec high, double cell) : low_(low), cell_(cell) {
        columns_ = static_cast<std::int64_t>((high.x - low.x) / cell) + 3;
        rows_ = static_cast<std::int64_t>((high.y - low.y) / cell) + 3;
        cells_.resize(static_cast<std::size_t>(columns_ * rows_));
    }
    void add(const Sample& sample) { cells_[cell_of(column(sample.at), row(sample.at))].push_back(sample); }
    void remove_line(std::uint32_t line, Vec near) {
        std::erase_if(cells_[cell_of(column(near), row(near))], [&](const Sample& s) { return s.line == line; });
    }
    // The nearest sample within `reach` (at most one cell) that counts.
    template <class Counts>
    const Sample* find(Vec p, double reach, const Counts& counts) const {
        const Sample* best = nullptr;
        double best2 = reach * reach;
        const std::int64_t x0 = column(p - Vec{reach, reach}), x1 = column(p + Vec{reach, reach});
        const std::int64_t y0 = row(p - Vec{reach, reach}), y1 = row(p + Vec{reach, reach});
        for (std::int64_t y = y0; y <= y1; ++y) {
            for (std::int64_t x = x0; x <= x1; ++x) {
                for (const Sample& sample : cells_[cell_of(x, y)]) {
                    const double d2 = dot(sample.at - p, sample.at - p);
                    if (d2 < best2 && counts(sample)) {
                        best2 = d2;
                        best = &sample;
                    }
                }
            }
        }
        return best;
    }

private:
    std::int64_t column(Vec p) const { return place(p.x - low_.x, columns_); }
    std::int64_t row(Vec p) const { return place(p.y - low_.y, rows_); }
    std::int64_t place(double x, std::int64_t count) const {
        return std::clamp(static_cast<std::int64_t>(std::floor(x / cell_)) + 1, std::int64_t{0}, count - 1);
    }
    std::size_t cell_of(std::int64_t x, std::int64_t y) const { return static_cast<std::size_t>(y * columns_ + x); }

    Vec low_;
    double cell_ = 1;
    std::int64_t columns_ = 0, rows_ = 0;
    std::vector<std::vector<Sample>> cells_;
};

enum class End { at_border, at_line, at_itself, closed, nowhere };

struct Line {
    std::vector<Vec> points;
    bool is_closed = false;
};

class Tracer {
public:
    Tracer(const std::function<Vec(Vec)>& direction, const GridField& distances, const StreamlineOptions& options)
        : direction_(direction),
          distances_(distances),
          options_(options),
          d_(options.separation),
          step_(options.separation * step_length),
          samples_(distances.grid.low, distances.grid.node(distances.grid.columns - 1, distances.grid.rows - 1),
                   options.separation),
          failures_(samples_) {}

    std::vector<Line> run(const std::vector<Vec>& first_seeds) {
        for (const Vec seed : first_seeds) try_seed(seed);
        const Grid& grid = distances_.grid;
        std::size_t done = 0;
        const auto grow_beside = [&] {
            for (; done < lines_.size(); ++done) seeds_beside(done);
        };
        grow_beside();
        // Places that no line led to.
        const double least = options_.follows_border ? free_of_lines * d_ : 0.25 * d_;
        for (std::uint32_t row = 0; row < grid.rows; ++row) {
            for (std::uint32_t column = 0; column < grid.columns; ++column) {
                const Vec p = grid.node(column, row);
                if (distances_.at(p) < least) continue;
                try_seed(p);
                grow_beside();
            }
        }
        return std::move(lines_);
    }

private:
    // The direction at a place, turned to go on from `from`; 0 where there is none.
    Vec unit(Vec p, Vec from) const {
        const Vec v = direction_(p);
        const double norm = length(v);
        if (options_.climbs && norm < flat) {
            const Vec aside = (0.7 * d_) * perpendicular(from);
            const bool is_summit = length(direction_(p + aside)) > steep && length(direction_(p - aside)) > steep;
            return is_summit ? Vec{} : from;
        }
        if (!(norm > 1e-9)) return {};
        return (dot(v, from) < 0 ? -1 / norm : 1 / norm) * v;
    }
    Vec advanced(Vec p, Vec heading, double by) const {  // Runge-Kutta of fourth order
        const Vec a = unit(p, heading);
        const Vec b = unit(p + (by / 2) * a, heading);
        const Vec c = unit(p + (by / 2) * b, heading);
        const Vec e = unit(p + by * c, heading);
        return p + (by / 6) * (a + 2 * b + 2 * c + e);
    }

    struct Half {
        std::vector<Vec> points;  // without the seed
        End end = End::nowhere;
        Sample met;  // of the line that it came near
    };
    // From the seed to where the line ends, one way. `sign` is that of the way along the line.
    Half trace(Vec seed, Vec heading, double sign, std::uint32_t line) {
        Half half;
        Vec at = seed;
        double way = 0, turning = 0;
        std::size_t entered = 0;  // samples that are in the grid
        const Vec first_heading = heading;
        const std::size_t most_steps = 100'000;
        for (std::size_t n = 0; n < most_steps && steps_ < options_.limit; ++n, ++steps_) {
            const Vec next = advanced(at, heading, step_);
            const Vec moved = next - at;
            const double distance = length(moved);
            if (distance < 0.5 * step_) return half;  // the field vanishes or turns on the spot
            const Vec turned = (1 / distance) * moved;
            if (n > 0 && dot(turned, heading) < 0.2) return half;
            if (n > 0) turning += cross(heading, turned);
            if (std::fabs(turning) > whole_turn && way < own_way * d_) return {};  // too tight to meet itself
            heading = turned;
            at = next;
            way += distance;
            const double inside = distances_.at(at);
            if (inside < 0) {
                half.points.push_back(at);
                half.points.push_back(at + step_ * heading);
                half.end = End::at_border;
                return half;
            }
            const Sample* const met = samples_.find(at, nearest * d_, [&](const Sample& sample) {
                return sample.line != line || std::fabs(sample.way - sign * way) > own_way * d_;
            });
            if (met != nullptr) {
                half.met = *met;
                half.end = met->line == line ? End::at_itself : End::at_line;
                half.points.push_back(at);
                const bool comes_home = met->line == line && std::fabs(met->way) < 1.5 * d_;
                if (comes_home && dot(heading, first_heading) > -0.3) {
                    half.end = End::closed;
                    for (int more = 0; more < 4 && dot(at - seed, first_heading) < 0; ++more) {
                        at = advanced(at, heading, step_);
                        half.points.push_back(at);
                    }
                }
                return half;
            }
            half.points.push_back(at);
            if (options_.follows_border && inside < nearest_border * d_ && way > d_) {
                const Vec inwards = distances_.jet(at).gradient;
                if (std::fabs(dot(heading, inwards)) < 0.5 * length(inwards)) return half;  // it runs along the border
            }
            // Its own points hinder it once it has left them behind.
            for (; entered < half.points.size() && static_cast<double>(half.points.size() - entered) * step_ > d_;
                 ++entered) {
                add_sample(half.points[entered], line, 0, sign * static_cast<double>(entered + 1) * step_);
            }
        }
        return half;
    }
    void add_sample(Vec at, std::uint32_t line, std::size_t index, double way) {
        samples_.add({at, line, static_cast<std::uint32_t>(index), way});
    }

    bool is_free(Vec p) const {
        return samples_.find(p, free_of_lines * d_, [](const Sample&) { return true; }) == nullptr;
    }

    // The end of a line, bent into the line that it met, or led straight on until something is met.
    void finish(Half& half, Vec seed, std::uint32_t line, const Line& own, std::size_t own_index) const {
        if (half.end == End::at_border || half.end == End::closed || !options_.merges) return;
        const auto heading_of = [&] {
            const Vec last = half.points.empty() ? seed : half.points.back();
            const Vec before = half.points.size() >= 2 ? half.points[half.points.size() - 2] : seed;
            const double norm = length(last - before);
            return norm > 0 ? (1 / norm) * (last - before) : Vec{};
        };
        if (half.end == End::nowhere) {
            const Vec heading = heading_of();
            if (heading == Vec{}) return;
            Vec at = half.points.back();
            for (int n = 0; n < 12; ++n) {
                const Sample* const met =
                    samples_.find(at, nearest * d_, [&](const Sample& sample) { return sample.line != line; });
                if (met != nullptr) {
                    half.met = *met;
                    half.end = End::at_line;
                    break;
                }
                // A line along the border that comes too near to it turns to it.
                const GridField::Jet border = distances_.jet(at);
                Vec on = heading;
                if (options_.follows_border && border.value < d_ && length(border.gradient) > 0) {
                    on = heading - (1 / length(border.gradient)) * border.gradient;
                    on = length(on) > 0 ? (1 / length(on)) * on : heading;
                }
                at = at + step_ * on;
                half.points.push_back(at);
                if (distances_.at(at) < 0) {
                    half.points.push_back(at + step_ * on);
                    half.end = End::at_border;
                    return;
                }
            }
        }
        if (half.end == End::at_line) bend_into(half, heading_of(), lines_[half.met.line], half.met.index);
        if (half.end == End::at_itself) bend_into(half, heading_of(), own, own_index);
    }
    void bend_into(Half& half, Vec heading, const Line& other, std::size_t index) const {
        const auto count = static_cast<std::int64_t>(other.points.size());
        const auto point = [&](std::int64_t i) {
            return other.points[static_cast<std::size_t>(other.is_closed ? ((i % count) + count) % count
                                                                         : std::clamp(i, std::int64_t{0}, count - 1))];
        };
        const auto met = static_cast<std::int64_t>(index);
        const Vec along = point(met + 1) - point(met - 1);
        const std::int64_t way = dot(along, heading) < 0 ? -1 : 1;
        // Steps of the other line that make up the lead, fewer where the two meet head on.
        const double slant = length(along) > 0 ? std::fabs(dot(along, heading)) / length(along) : 0;
        const auto ahead = static_cast<std::int64_t>(std::llround(lead * slant / step_length));
        const Vec from = half.points.back(), to = point(met + way * ahead);
        const Vec chord = to - from;
        const Vec control = from + (0.5 * length(chord)) * heading;
        constexpr int parts = 5;
        for (int i = 1; i < parts; ++i) {
            const double t = static_cast<double>(i) / parts;
            half.points.push_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * control + t * t * to);
        }
        half.points.push_back(to);
    }

    void try_seed(Vec seed) {
        const double inside = distances_.at(seed);
        if (inside < (options_.follows_border ? free_of_lines * d_ : 0)) return;
        if (steps_ >= options_.limit || !is_free(seed)) return;
        if (failures_.find(seed, apart_from_failure * d_, [](const Sample&) { return true; }) != nullptr) return;
        const Vec v = direction_(seed);
        const double norm = length(v);
        if (!(norm > 1e-9)) return;
        const Vec heading = (1 / norm) * v;
        // Not on a centre, where the field points every way.
        for (const double side : {-0.3, 0.3}) {
            if (dot(unit(seed + (side * d_) * heading, heading), heading) < 0.5) return;
        }
        const auto line = static_cast<std::uint32_t>(lines_.size());
        add_sample(seed, line, 0, 0);
        Half forth = trace(seed, heading, 1, line);
        Half back;
        if (forth.end != End::closed) back = trace(seed, -heading, -1, line);
        forget(seed, forth, back, line);
        Line made;
        if (forth.end == End::closed || back.end == End::closed) {
            made = closed_line(seed, forth.end == End::closed ? forth : back);
        } else {
            // A spiral may end on its own earlier turn.
            Line own;
            own.points.assign(back.points.rbegin(), back.points.rend());
            own.points.push_back(seed);
            own.points.insert(own.points.end(), forth.points.begin(), forth.points.end());
            const auto index_of = [&](const Half& half) {
                const double at = static_cast<double>(back.points.size()) + half.met.way / step_;
                return static_cast<std::size_t>(std::clamp(at + 0.5, 0.0, static_cast<double>(own.points.size() - 1)));
            };
            const std::size_t forth_index = index_of(forth), back_index = index_of(back);
            finish(forth, seed, line, own, forth_index);
            finish(back, seed, line, own, back_index);
            const bool is_cut_off = options_.merges && (is_loose(forth.end) || is_loose(back.end));
            made.points.assign(back.points.rbegin(), back.points.rend());
            made.points.push_back(seed);
            made.points.insert(made.points.end(), forth.points.begin(), forth.points.end());
            const auto merges = [](End end) { return end == End::at_line || end == End::at_itself; };
            const bool is_tie = merges(forth.end) && merges(back.end);
            if (is_cut_off || size_of(made) < (is_tie ? shortest_tie : shortest) * d_) made.points.clear();
        }
        if (made.is_closed && size_of(made) < shortest_ring * d_) made.points.clear();
        if (made.points.size() < 3) {
            failures_.add({seed, 0, 0, 0});
            return;
        }
        for (std::size_t i = 0; i < made.points.size(); ++i) add_sample(made.points[i], line, i, 0);
        lines_.push_back(std::move(made));
    }
    double size_of(const Line& line) const { return static_cast<double>(line.points.size()) * step_; }
    static bool is_loose(End end) { return end == End::nowhere; }

    void forget(Vec seed, const Half& forth, const Half& back, std::uint32_t line) {
        samples_.remove_line(line, seed);
        for (const Vec p : forth.points) samples_.remove_line(line, p);
        for (const Vec p : back.points) samples_.remove_line(line, p);
    }

    // A line that came home beside its seed: what it is off by is spread over its whole length.
    Line closed_line(Vec seed, const Half& half) const {
        Line line{{seed}, true};
        const std::vector<Vec>& points = half.points;
        if (points.size() < 3) return {};
        const Vec heading = points[0] - seed;
        // Without what lies beyond the seed, seen along the line.
        std::size_t count = points.size();
        while (count > 2 && dot(points[count - 1] - seed, heading) >= 0 &&
               length(points[count - 1] - seed) < 1.5 * d_) {
            --count;
        }
        // Where it passes the seed.
        const Vec last = points[count - 1];
        const Vec on = count < points.size() ? points[count] - last : last - points[count - 2];
        const double rate = dot(on, heading);
        const double part = rate > 0 ? std::clamp(dot(seed - last, heading) / rate, 0.0, 1.5) : 0;
        const Vec miss = seed - (last + part * on);
        for (std::size_t i = 0; i < count; ++i) {
            const double share = static_cast<double>(i + 1) / (static_cast<double>(count) + part);
            line.points.push_back(points[i] + (share * share * (3 - 2 * share) - 0.5) * miss);
        }
        line.points[0] = seed - 0.5 * miss;
        if (length(line.points.back() - line.points[0]) < 0.3 * step_) line.points.pop_back();
        return line;
    }

    void seeds_beside(std::size_t number) {
        const std::vector<Vec> points = lines_[number].points;
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            const Vec along = points[i + 1] - points[i - 1];
            const double norm = length(along);
            if (!(norm > 0)) continue;
            const Vec across = (d_ / norm) * perpendicular(along);
            try_seed(points[i] + across);
            try_seed(points[i] - across);
        }
    }

    const std::function<Vec(Vec)>& direction_;
    const GridField& distances_;
    const StreamlineOptions& options_;
    double d_ = 1, step_ = 1;
    SampleGrid samples_, failures_;
    std::vector<Line> lines_;
    std::size_t steps_ = 0;
};

// More points between each two, on the curve through them, as the tolerance asks for.
Polyline smoothed(const Line& line, double tolerance) {
    Polyline out{{}, line.is_closed};
    const auto count = static_cast<std::int64_t>(line.points.size());
    const auto point = [&](std::int64_t i) {
        return line.points[static_cast<std::size_t>(line.is_closed ? ((i % count) + count) % count
                                                                   : std::clamp(i, std::int64_t{0}, count - 1))];
    };
    for (std::int64_t i = 0; i < count; ++i) {
        out.points.push_back(point(i));
        if (!line.is_closed && i + 1 == count) break;
        const Vec a = point(i - 1), b = point(i), c = point(i + 1), e = point(i + 2);
        const Vec in = 0.5 * (c - a), on = 0.5 * (e - b);
        const double bend = length(in - on) / 8;  // how far the curve's middle lies off its chord
        const double parts = std::clamp(std::ceil(std::sqrt(bend / tolerance)), 1.0, 6.0);
        for (double k = 1; k < parts; ++k) {
            const double t = k / parts, u = 1 - t;
            out.points.push_back((u * u * (1 + 2 * t)) * b + (t * t * (3 - 2 * t)) * c + (t * u * u) * in -
                                 (t * t * u) * on);
        }
    }
    return out;
}

}  // namespace

std::vector<Polyline> streamlines(const std::function<Vec(Vec)>& direction, const GridField& distances,
                                  const std::vector<Vec>& first_seeds, const StreamlineOptions& options) {
    std::vector<Polyline> lines;
    if (distances.grid.size() == 0 || !(options.separation > 0)) return lines;
    for (const Line& line : Tracer(direction, distances, options).run(first_seeds)) {
        lines.push_back(smoothed(line, std::max(options.tolerance, 1e-6)));
    }
    return lines;
}

}  // namespace filigree
