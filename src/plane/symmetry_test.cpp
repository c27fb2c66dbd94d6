#include "plane/symmetry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "plane/verify.h"

namespace filigree {
namespace {

Symmetry symmetry_of(std::string_view name, Vec tile) {
    SymmetryGroup group = *find_symmetry(name);
    const Point fitted = is_rosette(group) ? Point{} : *fit_tile(group, tile);
    return Symmetry(std::move(group), fitted);
}

std::vector<std::string_view> wallpapers() {
    std::vector<std::string_view> names = wallpaper_names();
    for (const std::string_view turned : {"p11m", "p11g", "c11m", "pgm"}) names.push_back(turned);
    return names;
}
std::vector<std::string_view> everything() {
    std::vector<std::string_view> names = wallpapers();
    for (const std::string_view rosette : {"c1", "c2", "c3", "c7", "d1", "d2", "d4", "d5", "d12"}) {
        names.push_back(rosette);
    }
    return names;
}

double turn_degrees(const Transform& t) { return elementary::atan2(t.b, t.a) * (180 / elementary::pi); }

// Which of the 17 groups some isometries are, from rotations, mirrors and glides alone, by the crystallographers'
// questions. The isometries: operations, moved by tiles about the origin.
std::string classify(const Symmetry& symmetry) {
    struct Line {
        Vec at;  // a point on it
        Vec along;
    };
    struct Centre {
        Vec at;
        int order;
    };
    std::vector<Line> mirrors, glides;
    std::vector<Centre> centres;
    const double near = 1e-6;
    for (std::uint32_t k = 0; k < symmetry.operation_count(); ++k) {
        for (int column = -2; column <= 2; ++column) {
            for (int row = -2; row <= 2; ++row) {
                const Transform t = symmetry.transform({k, column, row});
                const Vec shift{t.e, t.f};
                if (determinant(t) < 0) {
                    const double angle = turn_degrees(t) / 2;
                    const elementary::CosSin to = elementary::cos_sin_degrees(angle);
                    const Vec along{to.cos, to.sin};
                    const double glide = dot(shift, along);
                    const Line line{0.5 * (shift - glide * along), along};
                    (std::fabs(glide) < near ? mirrors : glides).push_back(line);
                } else if (length({t.a - 1, t.b}) > near) {
                    const double angle = std::fabs(turn_degrees(t));
                    const int order = static_cast<int>(std::lround(360 / angle));
                    if (std::fabs(360.0 / order - angle) > 1e-4) continue;  // another turn of that centre
                    // The point that stays: (1 - M) p = shift.
                    const double d = (1 - t.a) * (1 - t.d) - t.b * t.c;
                    centres.push_back(
                        {{((1 - t.d) * shift.x + t.c * shift.y) / d, ((1 - t.a) * shift.y + t.b * shift.x) / d},
                         order});
                }
            }
        }
    }
    const auto is_on = [&](Vec p, const Line& line) { return std::fabs(cross(p - line.at, line.along)) < 1e-4; };
    const auto is_parallel = [&](const Line& a, const Line& b) { return std::fabs(cross(a.along, b.along)) < 1e-4; };
    const auto is_close = [&](Vec p) {
        return std::fabs(p.x) < 1.01 * to_px(symmetry.tile()).x && std::fabs(p.y) < 1.01 * to_px(symmetry.tile()).y;
    };
    int order = 1;
    for (const Centre& centre : centres) order = std::max(order, centre.order);
    bool all_on_mirrors = true;  // the centres of the highest order
    bool any_centre_off = false;
    for (const Centre& centre : centres) {
        if (!is_close(centre.at)) continue;
        const bool on =
            std::any_of(mirrors.begin(), mirrors.end(), [&](const Line& mirror) { return is_on(centre.at, mirror); });
        if (centre.order == order) all_on_mirrors = all_on_mirrors && on;
        any_centre_off = any_centre_off || !on;
    }
    bool glide_off_mirrors = false;
    for (const Line& glide : glides) {
        if (!is_close(glide.at)) continue;
        glide_off_mirrors = glide_off_mirrors || std::none_of(mirrors.begin(), mirrors.end(), [&](const Line& mirror) {
                                return is_parallel(mirror, glide) && is_on(glide.at, mirror);
                            });
    }
    const bool has_mirrors = !mirrors.empty();
    const bool mirrors_cross = std::any_of(mirrors.begin(), mirrors.end(),
                                           [&](const Line& mirror) { return !is_parallel(mirror, mirrors.front()); });
    switch (order) {
        case 1:
            if (!has_mirrors) return glides.empty() ? "p1" : "pg";
            return glide_off_mirrors ? "cm" : "pm";
        case 2:
            if (!has_mirrors) return glides.empty() ? "p2" : "pgg";
            if (!mirrors_cross) return "pmg";
            return any_centre_off ? "cmm" : "pmm";
        case 3:
            if (!has_mirrors) return "p3";
            return all_on_mirrors ? "p3m1" : "p31m";
        case 4:
            if (!has_mirrors) return "p4";
            return all_on_mirrors ? "p4m" : "p4g";
        case 6:
            return has_mirrors ? "p6m" : "p6";
        default:
            return "none";
    }
}

TEST(Symmetry, EachGroupIsTheOneItIsCalled) {
    for (const std::string_view name : wallpaper_names()) {
        const bool is_free = find_symmetry(name)->lattice == Lattice::rectangular;
        const bool is_square = find_symmetry(name)->lattice == Lattice::square;
        EXPECT_EQ(classify(symmetry_of(name, {100, is_free ? 70 : is_square ? 100 : 100 * std::sqrt(3.0)})), name);
    }
    EXPECT_EQ(classify(symmetry_of("p11m", {100, 70})), "pm");
    EXPECT_EQ(classify(symmetry_of("p11g", {100, 70})), "pg");
    EXPECT_EQ(classify(symmetry_of("c11m", {100, 70})), "cm");
    EXPECT_EQ(classify(symmetry_of("pgm", {100, 70})), "pmg");
}

TEST(Symmetry, SettingsDifferInTheirMirrors) {
    const auto mirror_of = [](std::string_view name) {
        const Symmetry symmetry = symmetry_of(name, {100, 70});
        return symmetry.transform({1, 0, 0});
    };
    EXPECT_EQ(mirror_of("p1m1"), (Transform{-1, 0, 0, 1, 0, 0}));
    EXPECT_EQ(mirror_of("p11m"), (Transform{1, 0, 0, -1, 0, 0}));
    EXPECT_EQ(mirror_of("p1g1"), (Transform{-1, 0, 0, 1, 0, 35}));
    EXPECT_EQ(mirror_of("p11g"), (Transform{1, 0, 0, -1, 50, 0}));
}

TEST(Symmetry, CompositionsAreThoseOfTheTransforms) {
    for (const std::string_view name : everything()) {
        const Symmetry symmetry = symmetry_of(name, {100, 60});
        const auto some = [&](CaseRandom& random) {
            Copy copy{random.below(symmetry.operation_count()), 0, 0};
            if (symmetry.has_tile()) copy.column = random.whole(-3, 3), copy.row = random.whole(-3, 3);
            return copy;
        };
        for (std::uint64_t n = 0; n < case_count(100); ++n) {
            CaseRandom random(n);
            const Copy a = some(random), b = some(random), both = symmetry.composed(a, b);
            ASSERT_LT(both.operation, symmetry.operation_count());
            const Vec p{random.between(-200, 200), random.between(-200, 200)};
            const Vec one = apply(symmetry.transform(a), apply(symmetry.transform(b), p));
            EXPECT_LT(length(one - apply(symmetry.transform(both), p)), 1e-9) << name;
        }
    }
}

// The domain's copies: their areas add up to the tile's to the last unit, none overlap, and a point lies in one.
TEST(Symmetry, CopiesOfTheDomainCoverATileOnce) {
    for (const std::string_view name : wallpapers()) {
        for (std::uint64_t n = 0; n < case_count(20); ++n) {
            CaseRandom random(n);
            const Symmetry symmetry = symmetry_of(name, {random.between(20, 900), random.between(20, 900)});
            const Polygons domain = domain_of(symmetry, 0, 0.1);
            ASSERT_EQ(find_flaw(domain[0]), std::nullopt) << name;
            const SymmetryImages images(symmetry, domain);
            Polygons around;
            Int128 doubled = 0;
            const Point tile = symmetry.tile();
            for (std::uint32_t k = 0; k < symmetry.operation_count(); ++k) {
                Polygons image = images.under(k);
                ASSERT_EQ(image[0].point_count(), domain[0].point_count());
                doubled += doubled_area(image[0].outer());
                for (int column = -2; column <= 2; ++column) {
                    for (int row = -2; row <= 2; ++row) {
                        Polygons copy = image;
                        for (Point& p : copy.points) p = {p.x + column * tile.x, p.y + row * tile.y};
                        around.add_all(copy);
                    }
                }
            }
            EXPECT_TRUE(doubled == static_cast<Int128>(2) * tile.x * tile.y) << name;
            EXPECT_EQ(find_overlap(around), std::nullopt) << name;
            for (int i = 0; i < 20; ++i) {
                const Point p{random.whole(-tile.x / 2, tile.x / 2), random.whole(-tile.y / 2, tile.y / 2)};
                int inside = 0, on = 0;
                for (std::size_t c = 0; c < around.size(); ++c) {
                    const int at = locate(around[c], p);
                    inside += at > 0 ? 1 : 0;
                    on += at == 0 ? 1 : 0;
                }
                EXPECT_TRUE(on > 0 ? inside == 0 : inside == 1) << name;
            }
        }
    }
}

TEST(Symmetry, CopiesOfASectorMakeADisc) {
    for (const std::string_view name : {"c1", "c2", "c3", "c5", "c12", "d1", "d2", "d3", "d7", "d24"}) {
        const Symmetry symmetry = symmetry_of(name, {});
        const Polygons domain = domain_of(symmetry, 100, 0.01);
        ASSERT_EQ(find_flaw(domain[0]), std::nullopt) << name;
        const SymmetryImages images(symmetry, domain);
        Polygons all;
        for (std::uint32_t k = 0; k < symmetry.operation_count(); ++k) all.add_all(images.under(k));
        EXPECT_EQ(all.size(), symmetry.operation_count());
        EXPECT_EQ(find_overlap(all), std::nullopt) << name;
        EXPECT_NEAR(area(all), area(domain) * symmetry.operation_count(), 1e-5) << name;
        EXPECT_NEAR(area(all), elementary::pi * 10000, 8) << name;
        EXPECT_LE(area(all), elementary::pi * 10000 + 1e-4) << name;
    }
}

// Points on a mirror, and those that rounding puts beside it, are where their neighbours' are: found here by the
// transforms alone.
TEST(Symmetry, CopiesThatMeetAtAMirrorShareItsPoints) {
    for (const std::string_view name : everything()) {
        std::size_t shared = 0;
        for (std::uint64_t n = 0; n < case_count(30); ++n) {
            CaseRandom random(n);
            const Symmetry symmetry = symmetry_of(name, {random.between(20, 900), random.between(20, 900)});
            const Polygons domain = domain_of(symmetry, 100, 1);
            const RingView ring = domain[0].outer();
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Vec from = to_px(ring[i]), to = to_px(ring[(i + 1) % ring.size()]);
                const Point p = random.below(4) == 0 ? ring[i] : snap(from + random.unit() * (to - from));
                const std::vector<Copy> here = symmetry.copies_here(p);
                for (const Copy& other : here) {
                    EXPECT_LT(length(apply(symmetry.transform(other), to_px(p)) - to_px(p)), 1e-6) << name;
                }
                for (std::uint32_t m = 0; m < symmetry.operation_count(); ++m) {
                    if (!symmetry.reflects(m)) continue;
                    for (int column = -1; column <= 1; ++column) {
                        for (int row = -1; row <= 1; ++row) {
                            if (!symmetry.has_tile() && (column != 0 || row != 0)) continue;
                            const Copy mirror{m, column, row};
                            if (length(apply(symmetry.transform(mirror), to_px(p)) - to_px(p)) > 3e-8) continue;
                            ++shared;
                            for (std::uint32_t k = 0; k < symmetry.operation_count(); ++k) {
                                const Point one = symmetry.image(k, p, here);
                                const Copy beside = symmetry.composed({k, 0, 0}, mirror);
                                Point two = symmetry.image(beside.operation, p, here);
                                two.x += beside.column * symmetry.tile().x;
                                two.y += beside.row * symmetry.tile().y;
                                EXPECT_EQ(one, two) << name;
                                const Vec straight = apply(symmetry.transform({k, 0, 0}), to_px(p));
                                EXPECT_LT(length(to_px(one) - straight), 2e-7) << name;
                            }
                        }
                    }
                }
            }
        }
        const std::string group = find_symmetry(name)->name;
        const bool has_mirrors = group.find('m') != std::string::npos || group[0] == 'd' || group == "p4g";
        EXPECT_EQ(shared > 0, has_mirrors) << name;
    }
}

TEST(Symmetry, PointsOffAllMirrorsHaveNoOtherCopiesHere) {
    for (const std::string_view name : everything()) {
        const Symmetry symmetry = symmetry_of(name, {100, 100});
        for (std::uint64_t n = 0; n < case_count(100); ++n) {
            CaseRandom random(n);
            const Point p = snap({random.between(-300, 300), random.between(-300, 300)});
            EXPECT_TRUE(symmetry.copies_here(p).empty()) << name;
        }
    }
}

// What collapses or leaves the plane keeps its place, without rings.
TEST(Symmetry, ImagesStayInTheirPlaces) {
    const Symmetry symmetry = symmetry_of("c4", {});
    Polygons motif;
    motif.add_ring(std::vector<Point>{{grid_limit - 10, 0}, {grid_limit, 0}, {grid_limit, 10}});
    motif.end_polygon();
    motif.add_ring(std::vector<Point>{{0, 0}, {100, 0}, {0, 100}});
    motif.end_polygon();
    const SymmetryImages images(symmetry, motif);
    const Polygons turned = images.under(1);
    ASSERT_EQ(turned.size(), 2U);
    EXPECT_EQ(turned[1].outer()[1], (Point{0, 100}));
    const Symmetry shifted = symmetry_of("p11g", {100, 100});
    const Polygons moved = SymmetryImages(shifted, motif).under(1);
    ASSERT_EQ(moved.size(), 2U);
    EXPECT_EQ(moved[0].ring_count(), 0U);
    EXPECT_EQ(moved[1].ring_count(), 1U);
    EXPECT_GT(doubled_area(moved[1].outer()), 0);
}

}  // namespace
}  // namespace filigree
