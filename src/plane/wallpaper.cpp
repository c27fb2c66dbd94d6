#include "plane/wallpaper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

#include "base/number_text.h"

namespace filigree {
namespace {

constexpr double root_of_3 = 1.7320508075688772;
constexpr double kept_stretch = 0.01;

// The linear parts of operations, by what they do to a tile of the right shape.
constexpr TileOperation one{}, half_turn{-2, 0, 0, -2, 0, 0};
constexpr TileOperation flip_x{-2, 0, 0, 2, 0, 0}, flip_y{2, 0, 0, -2, 0, 0};
constexpr TileOperation quarter_turn{0, -2, 2, 0, 0, 0}, sixth_turn{1, -3, 1, 1, 0, 0};

constexpr TileOperation moved(TileOperation op, int dx, int dy) {
    op.dx += dx;
    op.dy += dy;
    return op;
}

// A group by what generates it beside the tile's translations.
struct Row {
    std::string_view name;
    std::array<std::string_view, 3> other_names;   // empty: none
    std::array<std::string_view, 3> turned_names;  // of the setting with x and y exchanged
    Lattice lattice;
    std::array<TileOperation, 4> generators;
    std::array<TilePoint, 4> domain;  // a triangle repeats its last corner
};

constexpr TileOperation centred{2, 0, 0, 2, 6, 6};
constexpr std::array<TilePoint, 4> half{{{0, -6}, {6, -6}, {6, 6}, {0, 6}}};
constexpr std::array<TilePoint, 4> quarter{{{0, 0}, {6, 0}, {6, 6}, {0, 6}}};

constexpr Row rows[] = {
    {"p1", {}, {}, Lattice::rectangular, {}, {{{-6, -6}, {6, -6}, {6, 6}, {-6, 6}}}},
    {"p2", {"p211"}, {}, Lattice::rectangular, {half_turn}, half},
    {"pm", {"p1m1"}, {"p11m"}, Lattice::rectangular, {flip_x}, half},
    {"pg", {"p1g1"}, {"p11g"}, Lattice::rectangular, {moved(flip_x, 0, 6)}, half},
    {"cm", {"c1m1"}, {"c11m"}, Lattice::rectangular, {flip_x, centred}, quarter},
    {"pmm", {"p2mm", "pmm2"}, {}, Lattice::rectangular, {flip_x, flip_y}, quarter},
    {"pmg",
     {"p2mg", "pmg2"},
     {"pgm", "p2gm", "pgm2"},
     Lattice::rectangular,
     {half_turn, moved(flip_x, 6, 0)},
     {{{-3, 0}, {3, 0}, {3, 6}, {-3, 6}}}},
    {"pgg", {"p2gg", "pgg2"}, {}, Lattice::rectangular, {half_turn, moved(flip_x, 6, 6)}, quarter},
    {"cmm", {"c2mm", "cmm2"}, {}, Lattice::rectangular, {flip_x, flip_y, centred}, {{{0, 0}, {3, 0}, {3, 6}, {0, 6}}}},
    {"p4", {}, {}, Lattice::square, {quarter_turn}, quarter},
    {"p4m", {"p4mm"}, {}, Lattice::square, {quarter_turn, flip_x}, {{{0, 0}, {6, 0}, {6, 6}, {6, 6}}}},
    {"p4g", {"p4gm"}, {}, Lattice::square, {quarter_turn, moved(flip_x, 6, 6)}, {{{0, 0}, {6, 0}, {0, 6}, {0, 6}}}},
    {"p3", {}, {}, Lattice::hexagonal, {compose(sixth_turn, sixth_turn), centred}, {{{0, 0}, {6, 2}, {0, 4}, {-6, 2}}}},
    {"p3m1",
     {},
     {},
     Lattice::hexagonal,
     {compose(sixth_turn, sixth_turn), flip_x, centred},
     {{{0, 0}, {6, -2}, {6, 2}, {6, 2}}}},
    {"p31m",
     {},
     {},
     Lattice::hexagonal,
     {compose(sixth_turn, sixth_turn), flip_y, centred},
     {{{0, 0}, {12, 0}, {6, 2}, {6, 2}}}},
    {"p6", {}, {}, Lattice::hexagonal, {sixth_turn, centred}, {{{0, 0}, {6, 0}, {6, 2}, {3, 3}}}},
    {"p6m", {"p6mm"}, {}, Lattice::hexagonal, {sixth_turn, flip_x, centred}, {{{0, 0}, {6, 0}, {6, 2}, {6, 2}}}},
};

constexpr int within_tile(int twelfths) { return (twelfths % 12 + 12) % 12; }

// All that the generators make, in an order that only they decide.
std::vector<TileOperation> closure(std::span<const TileOperation> generators) {
    std::vector<TileOperation> all{one};
    for (std::size_t done = 0; done < all.size(); ++done) {
        for (const TileOperation& generator : generators) {
            TileOperation op = compose(generator, all[done]);
            op.dx = within_tile(op.dx);
            op.dy = within_tile(op.dy);
            if (std::find(all.begin(), all.end(), op) == all.end()) all.push_back(op);
        }
    }
    return all;
}

SymmetryGroup group_of(const Row& row, bool is_turned) {
    SymmetryGroup group;
    group.name = row.name;
    group.lattice = row.lattice;
    group.operations = closure(row.generators);
    const bool is_triangle = row.domain[3].x == row.domain[2].x && row.domain[3].y == row.domain[2].y;
    group.domain.assign(row.domain.begin(), row.domain.end() - (is_triangle ? 1 : 0));
    if (!is_turned) return group;
    group.name = row.turned_names[0];
    for (TileOperation& op : group.operations) op = {op.yy, op.yx, op.xy, op.xx, op.dy, op.dx};
    for (TilePoint& corner : group.domain) std::swap(corner.x, corner.y);
    std::reverse(group.domain.begin(), group.domain.end());
    return group;
}

bool holds(const std::array<std::string_view, 3>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

Diagnostic unknown_symmetry(std::string_view name, SourceSpan span) {
    std::vector<std::string_view> known = wallpaper_names();
    for (const Row& row : rows) {
        for (const auto& names : {row.other_names, row.turned_names}) {
            std::copy_if(names.begin(), names.end(), std::back_inserter(known),
                         [](std::string_view other) { return !other.empty(); });
        }
    }
    std::vector<std::string> hints = did_you_mean(name, known);
    std::string all = "the groups are";
    for (const std::string_view group : wallpaper_names()) all += (group == "p1" ? " " : ", ") + std::string(group);
    hints.push_back(all + ", and c1, c2, ..., d1, d2, ... for rosettes");
    return error("symmetry.unknown-group", "there is no symmetry group '" + std::string(name) + "'", span, hints);
}

// "c12": a letter, and a number without leading zeros.
bool is_rosette_name(std::string_view name) {
    return name.size() > 1 && (name[0] == 'c' || name[0] == 'd') && name[1] != '0' &&
           std::all_of(name.begin() + 1, name.end(), [](char digit) { return digit >= '0' && digit <= '9'; });
}

// Of what sides must be multiples, in grid units.
Point steps_of(const SymmetryGroup& group) {
    if (group.lattice == Lattice::hexagonal) return {16, 48};
    int x = 6, y = 6;
    for (const TilePoint& corner : group.domain) {
        x = std::gcd(x, corner.x);
        y = std::gcd(y, corner.y);
    }
    return {12 / x, 12 / y};
}

Point in_steps(const SymmetryGroup& group, Vec px) {
    const Point step = steps_of(group);
    const auto side = [](double length, std::int64_t by) {
        return std::max<std::int64_t>(1, std::llround(length * grid_per_px / static_cast<double>(by))) * by;
    };
    return {side(px.x, step.x), side(px.y, step.y)};
}

// The height of a tile that is so wide; of rectangular ones the one that is wanted.
double true_height(const SymmetryGroup& group, Vec px) {
    return group.lattice == Lattice::square ? px.x : group.lattice == Lattice::hexagonal ? px.x * root_of_3 : px.y;
}

}  // namespace

const std::vector<std::string_view>& wallpaper_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const Row& row : rows) all.push_back(row.name);
        return all;
    }();
    return names;
}

Result<SymmetryGroup> find_symmetry(std::string_view name, SourceSpan span) {
    if (!name.empty()) {
        for (const Row& row : rows) {
            if (row.name == name || holds(row.other_names, name)) return group_of(row, false);
            if (holds(row.turned_names, name)) return group_of(row, true);
        }
    }
    if (!is_rosette_name(name)) return unknown_symmetry(name, span);
    const double turns = parse_number(name.substr(1)).value_or(1e9);
    if (turns > most_turns) {
        return error("symmetry.too-many-turns",
                     "a rosette may turn up to " + to_text(std::uint64_t{most_turns}) + " times", span);
    }
    SymmetryGroup group;
    group.name = name;
    group.turns = static_cast<std::uint32_t>(turns);
    group.has_mirrors = name[0] == 'd';
    return group;
}

Result<Point> fit_tile(const SymmetryGroup& group, Vec px, SourceSpan span) {
    if (!(px.x >= 1 && px.y >= 1 && is_on_plane(2 * px))) {
        return error("symmetry.tile-size", "the sides of a tile must be from 1 px to 2^29 px", span);
    }
    const double height = true_height(group, px);
    if (std::fabs(px.y - height) <= kept_stretch * height) return in_steps(group, px);
    const std::string shape = group.lattice == Lattice::square ? "as high as wide" : "sqrt(3) times as high as wide";
    const std::string size = to_text(px.x) + "px x " + to_text(std::round(height * 1000) / 1000) + "px";
    return {in_steps(group, {px.x, height}),
            {warning("symmetry.tile-height", "a tile of " + group.name + " is " + shape + ", so it becomes " + size,
                     span, {"heights that are off by less than a hundredth are kept"})}};
}

Point tile_around(const SymmetryGroup& group, const Box& box) {
    const Vec low = is_empty(box) ? Vec{} : to_px(box.min), high = is_empty(box) ? Vec{} : to_px(box.max);
    Vec px{2 * std::max({std::fabs(low.x), std::fabs(high.x), 0.5}),
           2 * std::max({std::fabs(low.y), std::fabs(high.y), 0.5})};
    if (group.lattice == Lattice::square) px.x = std::max(px.x, px.y);
    if (group.lattice == Lattice::hexagonal) px.x = std::max(px.x, px.y / root_of_3);
    return in_steps(group, {px.x, true_height(group, px)});
}

}  // namespace filigree
