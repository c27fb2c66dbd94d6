#include "plane/scatter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.h"
#include "plane/scatter_cells.h"

namespace filigree {

namespace {

// Passes: cells, then their halves, quarters, ... What is left in the end is less than 2^-12 of a cell wide.
constexpr unsigned last_level = 12;
// From here on, squares are also tested against all discs about them together.
constexpr unsigned first_joint_test = 2;
// From here on, darts that miss the allowed region are moved to its border: parts of it that are much thinner
// than the squares would hardly ever be hit.
constexpr unsigned first_moved = 2;

// Cells take turns in so many classes, drawn at random for each by itself; those of a class in the order in
// which their squares were found, which is the same for every region and keeps neighbours in the cache.
constexpr std::uint64_t class_bits = 6;

struct Square {  // in px
    Vec min;
    double side;
};

struct Neighbours {
    std::array<Vec, 20> at;
    std::size_t count = 0;
};

bool covers(Vec point, const Square& square, double spacing2) {
    const double x = std::max(point.x - square.min.x, square.min.x + square.side - point.x);
    const double y = std::max(point.y - square.min.y, square.min.y + square.side - point.y);
    return x * x + y * y < spacing2;
}

// Whether the discs about the points cover the square together: then they cover its corners, each circle's
// crossings with its sides, and each two circles' crossings inside it; and the other way round.
class JointCover {
public:
    JointCover(const Neighbours& points, const Square& square, double spacing)
        : square_(square), radius2_(spacing * spacing), covered2_(spacing * spacing * (1 + 1e-9)) {
        for (std::size_t i = 0; i < points.count; ++i) {
            const Vec p = points.at[i];
            const double x = std::max({square.min.x - p.x, p.x - square.min.x - square.side, 0.0});
            const double y = std::max({square.min.y - p.y, p.y - square.min.y - square.side, 0.0});
            if (x * x + y * y < radius2_) discs_[count_++] = p;
        }
    }

    bool holds() const {
        if (count_ < 2) return false;
        const double far = square_.side;
        for (const Vec corner : {Vec{0, 0}, Vec{far, 0}, Vec{0, far}, Vec{far, far}}) {
            if (!is_covered(square_.min + corner, count_, count_)) return false;
        }
        for (std::size_t i = 0; i < count_; ++i) {
            if (!sides_hold(i)) return false;
            for (std::size_t j = i + 1; j < count_; ++j) {
                if (!crossings_hold(i, j)) return false;
            }
        }
        return true;
    }

private:
    bool is_covered(Vec p, std::size_t but, std::size_t nor) const {
        for (std::size_t k = 0; k < count_; ++k) {
            if (k != but && k != nor && dot(p - discs_[k], p - discs_[k]) < covered2_) return true;
        }
        return false;
    }
    bool sides_hold(std::size_t i) const {
        const Vec c = discs_[i];
        for (int side = 0; side < 2; ++side) {
            const double x = square_.min.x + side * square_.side;
            const double y = square_.min.y + side * square_.side;
            const double rise2 = radius2_ - (x - c.x) * (x - c.x);
            const double run2 = radius2_ - (y - c.y) * (y - c.y);
            for (const double sign : {-1.0, 1.0}) {
                if (rise2 > 0) {
                    const Vec p{x, c.y + sign * std::sqrt(rise2)};
                    if (is_within(p.y, square_.min.y) && !is_covered(p, i, i)) return false;
                }
                if (run2 > 0) {
                    const Vec p{c.x + sign * std::sqrt(run2), y};
                    if (is_within(p.x, square_.min.x) && !is_covered(p, i, i)) return false;
                }
            }
        }
        return true;
    }
    bool crossings_hold(std::size_t i, std::size_t j) const {
        const Vec between = discs_[j] - discs_[i];
        const double half2 = dot(between, between) / 4;
        if (!(half2 < radius2_)) return true;
        const Vec middle = discs_[i] + between * 0.5;
        const Vec aside = perpendicular(between) * (std::sqrt((radius2_ - half2) / half2) / 2);
        for (const Vec p : {middle + aside, middle - aside}) {
            const bool is_inside = is_within(p.x, square_.min.x) && is_within(p.y, square_.min.y);
            if (is_inside && !is_covered(p, i, j)) return false;
        }
        return true;
    }
    bool is_within(double v, double least) const { return v >= least && v <= least + square_.side; }

    Square square_;
    double radius2_, covered2_;
    std::array<Vec, 20> discs_;
    std::size_t count_ = 0;
};

class Scatter {
public:
    Scatter(const AllowedRegion& region, ScatterCells& cells, const ScatterOptions& options, double spacing)
        : region_(region),
          cells_(cells),
          seed_(options.seed),
          limit_(options.limit),
          spacing_(spacing),
          spacing2_(spacing * spacing * (1 + 1e-12)),
          place_name_(hash_text("place")),
          order_name_(hash_text("order")) {}

    void run() {
        std::vector<ScatterSquare> active = cells_.squares();
        const std::size_t most = 4 * active.size() + 65536;
        for (unsigned level = 0; level <= last_level && !active.empty() && count_ < limit_; ++level) {
            throw_darts(active, level);
            if (level == last_level) break;
            active = halved(active, level);
            // Squares grow fewer. Only along a border where nothing quite fits they may grow without end.
            if (active.size() > most) std::erase_if(active, [](const ScatterSquare& s) { return !s.is_free; });
        }
    }

private:
    static std::uint64_t draw_of(const ScatterSquare& s, unsigned level) {
        return static_cast<std::uint64_t>(level) << 32 | static_cast<std::uint64_t>(s.y) << 16 | s.x;
    }

    void sort_into_turns(const std::vector<ScatterSquare>& active, unsigned level) {
        std::array<std::size_t, (1U << class_bits) + 1> starts{};
        classes_.resize(active.size());
        for (std::size_t i = 0; i < active.size(); ++i) {
            const std::uint64_t bits =
                random_bits(seed_, Key{cells_.key(active[i])}, order_name_, draw_of(active[i], level));
            classes_[i] = static_cast<std::uint8_t>(bits >> (64 - class_bits));
            ++starts[classes_[i] + 1U];
        }
        for (std::size_t c = 1; c < starts.size(); ++c) starts[c] += starts[c - 1];
        turns_.resize(active.size());
        for (std::uint32_t i = 0; i < active.size(); ++i) turns_[starts[classes_[i]]++] = i;
    }

    void throw_darts(const std::vector<ScatterSquare>& active, unsigned level) {
        sort_into_turns(active, level);
        const double half = cells_.cell_side() / static_cast<double>(2U << level);
        for (const std::uint32_t i : turns_) {
            const ScatterSquare& s = active[i];
            if (cells_.is_filled(s.tile, s.cell)) continue;
            const std::uint64_t bits = random_bits(seed_, Key{cells_.key(s)}, place_name_, draw_of(s, level));
            const Vec within{static_cast<double>(bits >> 32) * 0x1p-32,
                             static_cast<double>(bits & 0xFFFFFFFFU) * 0x1p-32};
            Vec at = corner(s, level, within);
            if (!is_clear(s, at)) continue;
            if (!s.is_free && !region_.holds(at, half)) {
                if (level < first_moved) continue;
                at = region_.moved_to_allowed(at, half);
                const Vec low = corner(s, level, {0, 0});
                if (!(at.x >= low.x && at.x < low.x + 2 * half && at.y >= low.y && at.y < low.y + 2 * half)) continue;
                if (!is_clear(s, at) || !region_.holds(at, half)) continue;
            }
            cells_.fill(s, at);
            if (++count_ == limit_) return;
        }
    }

    bool is_clear(const ScatterSquare& s, Vec at) const {
        return !cells_.any_neighbour(s, [&](Vec p) { return dot(p - at, p - at) < spacing2_; });
    }

    // A place in the square, with `within` from 0 to 1; exact in the same way for every square that has it.
    Vec corner(const ScatterSquare& s, unsigned level, Vec within) const {
        const double part = 1.0 / static_cast<double>(1U << level);
        return {(static_cast<double>(cells_.column(s)) + (s.x + within.x) * part) * cells_.cell_side(),
                (static_cast<double>(cells_.row(s)) + (s.y + within.y) * part) * cells_.cell_side()};
    }

    // The quarters of all squares where a point may still fit.
    std::vector<ScatterSquare> halved(const std::vector<ScatterSquare>& active, unsigned level) const {
        std::vector<ScatterSquare> next;
        Neighbours near;
        const ScatterSquare* last = nullptr;
        for (const ScatterSquare& parent : active) {
            if (cells_.is_filled(parent.tile, parent.cell)) continue;
            if (last == nullptr || last->tile != parent.tile || last->cell != parent.cell) {
                near.count = 0;
                cells_.any_neighbour(parent, [&](Vec p) {
                    near.at[near.count++] = p;
                    return false;
                });
            }
            last = &parent;
            for (int quarter = 0; quarter < 4; ++quarter) {
                ScatterSquare s = parent;
                s.x = static_cast<std::uint16_t>(2 * parent.x + quarter % 2);
                s.y = static_cast<std::uint16_t>(2 * parent.y + quarter / 2);
                if (may_take(s, level + 1, near)) next.push_back(s);
            }
        }
        return next;
    }

    bool may_take(ScatterSquare& s, unsigned level, const Neighbours& near) const {
        const Square square{corner(s, level, {0, 0}), cells_.cell_side() / static_cast<double>(1U << level)};
        for (std::size_t i = 0; i < near.count; ++i) {
            if (covers(near.at[i], square, spacing2_)) return false;
        }
        if (level >= first_joint_test && JointCover(near, square, spacing_).holds()) return false;
        if (s.is_free) return true;
        const double half = square.side / 2;
        const AllowedRegion::Part part = region_.part_of_square(square.min + Vec{half, half}, half);
        s.is_free = part == AllowedRegion::Part::all;
        return part != AllowedRegion::Part::none;
    }

    const AllowedRegion& region_;
    ScatterCells& cells_;
    std::uint64_t seed_, limit_;
    double spacing_, spacing2_;
    std::uint64_t place_name_, order_name_;
    std::uint64_t count_ = 0;
    std::vector<std::uint8_t> classes_;
    std::vector<std::uint32_t> turns_;
};

std::vector<ScatteredPoint> gathered(const ScatterCells& cells) {
    struct Found {
        std::int64_t row, column;
        Vec at;
    };
    std::vector<Found> found;
    for (std::uint32_t t = 0; t < cells.tile_count(); ++t) {
        for (unsigned c = 0; c < 256; ++c) {
            if (!cells.is_filled(t, c)) continue;
            ScatterSquare s;
            s.tile = t;
            s.cell = static_cast<std::uint8_t>(c);
            found.push_back({cells.row(s), cells.column(s), cells.point(t, c)});
        }
    }
    std::sort(found.begin(), found.end(),
              [](const Found& a, const Found& b) { return a.row != b.row ? a.row < b.row : a.column < b.column; });
    std::vector<ScatteredPoint> points;
    points.reserve(found.size());
    for (const Found& f : found) points.push_back({f.at, ScatterCells::pack(f.column, f.row)});
    return points;
}

}  // namespace

std::vector<ScatteredPoint> scatter(PolygonView region, const ScatterOptions& options) {
    if (!(options.spacing > 0) || options.limit == 0 || region.ring_count() == 0 || region.outer().size() < 3)
        return {};
    const AllowedRegion allowed(region, options.clearance);
    // Where the region is smaller than the spacing there is one point, whatever the spacing.
    const VecBox box = allowed.box();
    const double widest = 2 * length(box.max - box.min);
    const double spacing = std::clamp(options.spacing, 0x1p-20, std::max(widest, 0x1p-20));
    // A point keeps others out of cells worth 2 pi cells, and out of no more than 25: so many cells are enough
    // to tell that there are more points than the limit, whatever the size of the region.
    const std::uint64_t limit = std::min<std::uint64_t>(options.limit, std::uint64_t{1} << 26);
    ScatterOptions capped = options;
    capped.limit = limit;
    for (std::uint64_t most = 8 * limit + 64;; most *= 2) {
        ScatterCells cells(allowed, spacing, most);
        Scatter(allowed, cells, capped, spacing).run();
        std::vector<ScatteredPoint> points = gathered(cells);
        if (!cells.was_cut_short() || points.size() >= limit || most > 25 * limit) return points;
    }
}

}  // namespace filigree
