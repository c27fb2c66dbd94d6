// Random shapes and families for the tests of level cuts.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "plane/level_cut.h"

namespace filigree::level_cut_shapes {

using Outline = std::vector<Vec>;

inline Vec turn(Vec p, double degrees) {
    const elementary::CosSin by = elementary::cos_sin_degrees(degrees);
    return {p.x * by.cos - p.y * by.sin, p.x * by.sin + p.y * by.cos};
}

inline Polygons polygon_of(const std::vector<Outline>& outlines, double degrees = 0) {
    Polygons polygons;
    for (const Outline& outline : outlines) {
        for (const Vec p : outline) polygons.points.push_back(snap(turn(p, degrees)));
        polygons.end_ring();
    }
    polygons.end_polygon();
    return polygons;
}

inline Outline wobbly(CaseRandom& random, Vec centre, double radius, int count, double wobble, bool hole) {
    Outline outline;
    const double phase = random.between(0, 6);
    const int lobes = random.whole(2, 6);
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * elementary::pi * (hole ? count - i : i) / count;
        const double r =
            radius * (1 - wobble + wobble * elementary::cos_sin(lobes * angle + phase).sin * random.between(0.6, 1));
        const elementary::CosSin at = elementary::cos_sin(angle);
        outline.push_back(centre + r * Vec{at.cos, at.sin});
    }
    return outline;
}

// A wobbly disc of some 200 px with up to nine holes.
inline std::vector<Outline> wobbly_shape(CaseRandom& random) {
    const Vec centre{random.between(-500, 500), random.between(-500, 500)};
    const double size = 100;
    std::vector<Outline> outlines{wobbly(random, centre, size, random.whole(3, 150), 0.2, false)};
    // The outer ring's edges stay outside half its radius where it has enough of them.
    if (outlines[0].size() < 12) return outlines;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            if (random.coin()) continue;
            outlines.push_back(
                wobbly(random, centre + Vec{20.0 * x, 20.0 * y}, random.between(1, 9), random.whole(3, 30), 0.3, true));
        }
    }
    return outlines;
}

// The outline of a connected set of cells of side `side`: every vertex on one lattice, touching rings among
// them. `pinched`: where two cells meet at a corner the ring comes there twice instead of touching another.
inline std::vector<Outline> cell_shape(CaseRandom& random, int size, double side, bool pinched) {
    std::vector<std::vector<int>> cell(static_cast<std::size_t>(size + 2),
                                       std::vector<int>(static_cast<std::size_t>(size + 2), 0));
    const auto at = [&](int x, int y) -> int& {
        return cell[static_cast<std::size_t>(x + 1)][static_cast<std::size_t>(y + 1)];
    };
    for (int x = 0; x < size; ++x) {
        for (int y = 0; y < size; ++y) at(x, y) = random.unit() < 0.65 ? 1 : 0;
    }
    at(size / 2, size / 2) = 1;
    std::vector<std::pair<int, int>> stack{{size / 2, size / 2}};
    at(size / 2, size / 2) = 2;
    while (!stack.empty()) {
        const auto [x, y] = stack.back();
        stack.pop_back();
        const int dx[] = {1, -1, 0, 0}, dy[] = {0, 0, 1, -1};
        for (int i = 0; i < 4; ++i) {
            if (at(x + dx[i], y + dy[i]) != 1) continue;
            at(x + dx[i], y + dy[i]) = 2;
            stack.emplace_back(x + dx[i], y + dy[i]);
        }
    }
    struct Side {  // of a cell, with the cell on its left
        int x = 0, y = 0, dx = 0, dy = 0;
        bool used = false;
    };
    std::vector<Side> sides;
    for (int x = 0; x < size; ++x) {
        for (int y = 0; y < size; ++y) {
            if (at(x, y) != 2) continue;
            if (at(x, y - 1) != 2) sides.push_back({x, y, 1, 0});
            if (at(x + 1, y) != 2) sides.push_back({x + 1, y, 0, 1});
            if (at(x, y + 1) != 2) sides.push_back({x + 1, y + 1, -1, 0});
            if (at(x - 1, y) != 2) sides.push_back({x, y + 1, 0, -1});
        }
    }
    std::map<std::pair<int, int>, std::vector<std::size_t>> from;
    for (std::size_t i = 0; i < sides.size(); ++i) from[{sides[i].x, sides[i].y}].push_back(i);
    std::vector<Outline> outlines;
    for (std::size_t start = 0; start < sides.size(); ++start) {
        if (sides[start].used) continue;
        Outline outline;
        for (std::size_t i = start; !sides[i].used;) {
            Side& here = sides[i];
            here.used = true;
            outline.push_back({side * here.x, side * here.y});
            const std::vector<std::size_t>& next = from[{here.x + here.dx, here.y + here.dy}];
            i = next[0];
            if (next.size() == 2) {
                const int turned = here.dx * sides[i].dy - here.dy * sides[i].dx;
                if ((turned > 0) != pinched) i = next[1];
            }
        }
        outlines.push_back(outline);
    }
    const auto twice_area = [](const Outline& o) {
        double sum = 0;
        for (std::size_t i = 0; i < o.size(); ++i) sum += cross(o[i], o[(i + 1) % o.size()]);
        return sum;
    };
    std::iter_swap(outlines.begin(),
                   std::max_element(outlines.begin(), outlines.end(),
                                    [&](const Outline& o, const Outline& p) { return twice_area(o) < twice_area(p); }));
    return outlines;
}

inline Profile random_profile(CaseRandom& random) {
    Profile profile;
    switch (random.whole(0, 3)) {
        case 0:
            break;
        case 1: {
            profile.step = random.between(0.5, 6);
            const int count = random.whole(5, 90);
            const double size = random.between(0, 12);
            for (int i = 0; i < count; ++i) {
                const double angle = 2 * elementary::pi * i / count;
                profile.samples.push_back(size * elementary::cos_sin(angle).sin +
                                          size * 0.4 * elementary::cos_sin(3 * angle).cos);
            }
            break;
        }
        case 2: {
            profile.step = random.between(2, 20);
            profile.samples = {0, random.between(0, 20)};
            break;
        }
        case 3: {
            profile.step = random.between(0.3, 30);
            const int count = random.whole(1, 30);
            for (int i = 0; i < count; ++i) profile.samples.push_back(random.between(-8, 8));
            break;
        }
    }
    return profile;
}

inline void add_levels(CaseRandom& random, LevelFamily& family, LevelRange range) {
    const double width = range.high - range.low;
    const int count = random.whole(0, 30);
    double level = range.low - 0.3 * width * random.unit();
    const double uniform = random.coin() ? 1.5 * width / (count + 1) : 0;
    for (int i = 0; i < count; ++i) {
        level += uniform > 0 ? uniform : random.between(0.001, 3) * width / (count + 1);
        family.levels.push_back(level);
    }
    family.first_strip = random.whole(-5, 5);
}

inline LevelFamily random_family(CaseRandom& random, PolygonView shape) {
    LevelFamily family;
    const Box box = bounds(shape);
    const Vec low = to_px(box.min), high = to_px(box.max);
    family.frame.origin = {random.between(low.x, high.x), random.between(low.y, high.y)};
    family.frame.direction = turn({1, 0}, random.whole(0, 3) == 0 ? 45 * random.whole(0, 7) : random.between(0, 360));
    family.profile = random_profile(random);
    add_levels(random, family, level_range(shape, family.frame, family.profile));
    return family;
}

}  // namespace filigree::level_cut_shapes
