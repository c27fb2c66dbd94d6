// What is placed, stippled and parted into cells, through whole documents.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/test_cases.h"
#include "engines/tangle/verify.h"
#include "plane/verify.h"
#include "tests/grown.h"

namespace filigree {
namespace {

using tangle::Group;
using tangle::Shape;
using tangle::Tangle;

struct Grown : GrownDocument {
    std::vector<Shape> shapes(std::string_view tag) const {
        std::vector<Shape> found;
        for (const Group& group : tangle.groups) {
            if (checked.grammar->tags[group.tag] != tag) continue;
            found.insert(found.end(), group.shapes.begin(), group.shapes.end());
        }
        return found;
    }
    double area_of(std::string_view tag) const {
        double sum = 0;
        for (const Shape& shape : shapes(tag)) sum += area(tangle.polygon(shape));
        return sum;
    }
    double largest_diameter(const Shape& shape) const {
        const RingView ring = tangle.polygon(shape).outer();
        double largest = 0;
        for (const Point a : ring) {
            for (const Point b : ring) largest = std::max(largest, length(to_px(a) - to_px(b)));
        }
        return largest;
    }
};

std::unique_ptr<Grown> grow(const std::string& rules) { return grown_document<Grown>(rules); }

void expect_sound(const Grown& grown) {
    EXPECT_EQ(tangle::broken_invariants(grown.tangle), std::vector<std::string>{});
}

const std::vector<std::string> all_shapes = {"blob",
                                             "disc",
                                             "circ",
                                             "square",
                                             "star(5, 20, 8)",
                                             "polygon(3, 10)",
                                             "rectangle(30, 8)",
                                             "path(\"M0 0H10V10H0Z M2 2V8H8V2Z M4 4H6V6H4Z\")",
                                             "ellipse(20, 9)"};

TEST(Placement, PartitionsWhateverIsPlaced) {
    const std::uint64_t count = case_count(60);
    for (std::uint64_t seed = 0; seed < count && !::testing::Test::HasFailure(); ++seed) {
        CaseRandom random(seed);
        const std::string shape = all_shapes[random.index(all_shapes.size())];
        const std::string border = std::vector<std::string>{"inside", "touch", "clip"}[random.index(3)];
        const std::string rotation = std::vector<std::string>{"keep", "axis",   "random",         "along",
                                                              "30",   "0..180", "towards((0, 0))"}[random.index(7)];
        const double size = random.between(6, 40), spacing = size * random.between(0.6, 1.6);
        const std::string text =
            "seed " + std::to_string(seed) + "\nstart a = " + (random.coin() ? "circle(70)" : "star(7, 90, 40)") +
            "\nplace(" + shape + ", " + std::to_string(size) + ", " + std::to_string(spacing) + ", border: " + border +
            ", rotation: " + rotation + ", variation: " + (random.coin() ? "0" : "0.4") +
            ", relax: " + (random.coin() ? "yes" : "no") +
            ") : a -> placed, rest\nplace(disc, 5, 8) : rest -> small, rest_of_rest\n";
        SCOPED_TRACE(text);
        const auto grown = grow(text);
        expect_sound(*grown);
        for (const Shape& placed : grown->shapes("placed")) EXPECT_LE(grown->largest_diameter(placed), size + 1e-6);
        std::set<std::uint64_t> keys;
        for (const char* tag : {"placed", "rest", "small", "rest_of_rest"}) {
            for (const Shape& one : grown->shapes(tag)) EXPECT_TRUE(keys.insert(one.key.value).second);
        }
    }
}

TEST(Placement, FillsARegionEvenly) {
    const auto grown = grow("start a = rectangle(300, 200)\nplace(disc, 20, 25) : a -> disc, rest\n");
    const std::vector<Shape> discs = grown->shapes("disc");
    EXPECT_GT(discs.size(), 65U);
    std::size_t whole = 0;
    for (const Shape& disc : discs) {
        const double diameter = grown->largest_diameter(disc);
        EXPECT_LE(diameter, 20);
        EXPECT_GE(diameter, 9.9);
        whole += diameter > 19.8;
    }
    EXPECT_GE(whole + 2, discs.size());
    EXPECT_EQ(grown->shapes("rest").size(), 1U);
}

TEST(Placement, FillsABandOfItsOwnWidth) {
    const auto grown = grow("start a = circle(100)\noutline(10) : a -> b, band\nplace(10, 15) : band -> blob, rest\n");
    EXPECT_GT(grown->shapes("blob").size(), 32U);
    expect_sound(*grown);
}

TEST(Placement, OneInASmallFieldLiesInItsMiddle) {
    const auto grown = grow("start a = rectangle(20, 14, at: (31, 7))\nplace(disc, 8, 15) : a -> disc, rest\n");
    const std::vector<Shape> discs = grown->shapes("disc");
    ASSERT_EQ(discs.size(), 1U);
    const Vec centre = centroid(grown->tangle.polygon(discs[0]));
    EXPECT_NEAR(centre.x, 31, 1e-6);
    EXPECT_NEAR(centre.y, 7, 1e-6);
}

TEST(Placement, AnObjectHandsDownWhichWayItLies) {
    const auto grown = grow(
        "start a = rectangle(200, 200)\nplace(rectangle(30, 8), 20, 25, rotation: 30) : a -> bar, rest\n"
        "regular_split(5, angle: across) : bar -> slice\n");
    for (const Shape& bar : grown->shapes("bar")) {
        EXPECT_NEAR(bar.direction.x, std::sqrt(0.75), 1e-9);
        EXPECT_NEAR(bar.direction.y, 0.5, 1e-9);
    }
    expect_sound(*grown);
}

TEST(Placement, AlongTheBorderOfADiscIsAroundIt) {
    const auto grown =
        grow("start a = circle(100)\nplace(rectangle(30, 8), 16, 18, rotation: along) : a -> bar, rest\n");
    std::size_t across = 0;
    for (const Shape& bar : grown->shapes("bar")) {
        const Vec centre = centroid(grown->tangle.polygon(bar));
        const double distance = length(centre);
        if (distance > 30) across += std::fabs(dot(centre, bar.direction)) > 0.1 * distance;
    }
    EXPECT_EQ(across, 0U);
    EXPECT_GT(grown->shapes("bar").size(), 60U);
}

TEST(Placement, CountersOfLettersRemain) {
    const auto grown =
        grow("start a = rectangle(200, 120)\nplace(path(\"M0 0H10V10H0Z M3 3V7H7V3Z\"), 20, 25) : a -> frame, rest\n");
    EXPECT_EQ(grown->shapes("rest").size(), grown->shapes("frame").size() + 1);
    expect_sound(*grown);
}

TEST(Placement, ClippedObjectsReachTheBorder) {
    const auto grown = grow("start a = rectangle(200, 200)\nplace(disc, 30, 30, border: clip) : a -> disc, rest\n");
    expect_sound(*grown);
    std::size_t cut = 0;
    for (const Shape& disc : grown->shapes("disc")) {
        const Box box = bounds(grown->tangle.polygon(disc));
        cut += to_px(box.max).x > 100 - 1e-9;
    }
    EXPECT_GT(cut, 4U);
}

TEST(Placement, AFormThatEnclosesNothingIsToldOf) {
    const OpenedDocument opened =
        open_text("a.fil", "grammar tangle\nstart a = circle(50)\nplace(path(\"M0 0H10\"), 20, 25) : a -> b, c\n", {});
    const CheckedDocument checked = check_document(opened);
    if (has_errors(checked.diagnostics)) return;
    SerialExecutor executor;
    const Result<Tangle> derived = derive_document(opened, checked, {}, executor, {});
    ASSERT_FALSE(derived);
    EXPECT_EQ(derived.diagnostics().front().code, "tangle.empty-form");
}

TEST(Placement, TooManyAreRefused) {
    const OpenedDocument opened =
        open_text("a.fil", "grammar tangle\nlimit elements 1000\nstart a = circle(500)\nplace(1, 2) : a -> b, c\n", {});
    const CheckedDocument checked = check_document(opened);
    ASSERT_FALSE(has_errors(checked.diagnostics));
    SerialExecutor executor;
    EXPECT_FALSE(derive_document(opened, checked, {}, executor, {}));
}

TEST(Stippling, MarksKeepApartAndOffTheBorder) {
    const std::uint64_t count = case_count(40);
    for (std::uint64_t seed = 0; seed < count && !::testing::Test::HasFailure(); ++seed) {
        CaseRandom random(seed);
        const std::string mark =
            std::vector<std::string>{"dot", "dash", "curve", "circle", "star(5, 20, 8)"}[random.index(5)];
        const std::string density = std::vector<std::string>{"1", "0.3", "gradient(1, 0.1)", "gradient(0, 1, 30)",
                                                             "radial(0.05, 1)"}[random.index(5)];
        const double spacing = random.between(3, 9), size = spacing * random.between(0.2, 1.4);
        const double margin = random.between(0.1, 3);
        const std::string text = "seed " + std::to_string(seed) + "\nstart a = star(7, 50, 25)\nstipple(" +
                                 std::to_string(spacing) + ", " + std::to_string(size) +
                                 ", margin: " + std::to_string(margin) + ", mark: " + mark + ", density: " + density +
                                 ", rotation: " + (random.coin() ? "random" : "along") +
                                 ", grow: " + (random.coin() ? "yes" : "no") + ") : a -> ground, dots\n";
        SCOPED_TRACE(text);
        const auto grown = grow(text);
        expect_sound(*grown);
        ASSERT_EQ(grown->shapes("ground").size(), 1U);
        const PolygonView ground = grown->tangle.polygon(grown->shapes("ground")[0]);
        const RingView ring = ground.outer();
        Polygons marks;
        std::set<std::uint64_t> keys;
        for (const Shape& dot : grown->shapes("dots")) {
            EXPECT_TRUE(dot.is_mark);
            EXPECT_TRUE(dot.inked);
            EXPECT_TRUE(keys.insert(dot.key.value).second);
            EXPECT_LE(grown->largest_diameter(dot), size + 1e-6);
            marks.add(grown->tangle.polygon(dot));
        }
        EXPECT_EQ(find_overlap(marks), std::nullopt);
        for (const Point p : marks.points) {
            EXPECT_EQ(locate(ground, p), 1);
            double least = 1e300;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Vec a = to_px(ring[i]), along = to_px(ring[(i + 1) % ring.size()]) - a, to = to_px(p) - a;
                const double t = std::clamp(dot(to, along) / dot(along, along), 0.0, 1.0);
                least = std::min(least, length(to - along * t));
            }
            EXPECT_GE(least, margin - 1e-6);
        }
    }
}

TEST(Stippling, IsDenserWhereItIsDarker) {
    const auto grown = grow(
        "start a = rectangle(300, 100)\nstipple(4, density: gradient(1, 0.1, 0), grow: yes) : a -> ground, dots\n");
    std::size_t left = 0, right = 0;
    double left_area = 0, right_area = 0;
    for (const Shape& dot : grown->shapes("dots")) {
        const bool is_left = centroid(grown->tangle.polygon(dot)).x < 0;
        ++(is_left ? left : right);
        (is_left ? left_area : right_area) += area(grown->tangle.polygon(dot));
    }
    EXPECT_NEAR(static_cast<double>(left) / static_cast<double>(right), 0.775 / 0.325, 0.35);
    EXPECT_GT(left_area / static_cast<double>(left), 1.3 * right_area / static_cast<double>(right));
}

TEST(Stippling, AGroupMayShareADensity) {
    const std::string start = "start a = rectangle(200, 60)\nregular_split(20, angle: 90, fit: yes) : a -> strip\n";
    const auto shared = grow(start + "stipple(3, density: gradient(1, 0, 0), over: group) : strip -> ground, dots\n");
    const auto own = grow(start + "stipple(3, density: gradient(1, 0, 0)) : strip -> ground, dots\n");
    const auto in_the_left_half = [](const Grown& grown) {
        std::size_t count = 0;
        for (const Shape& dot : grown.shapes("dots")) count += centroid(grown.tangle.polygon(dot)).x < 0;
        return static_cast<double>(count) / static_cast<double>(grown.shapes("dots").size());
    };
    EXPECT_GT(in_the_left_half(*shared), 0.68);
    EXPECT_NEAR(in_the_left_half(*own), 0.5, 0.06);
}

TEST(Voronoi, PartitionsIntoCellsOfTheSpacing) {
    for (const char* sites : {"relaxed", "random", "lattice"}) {
        const auto grown = grow("start a = star(7, 90, 50)\nvoronoi(14, " + std::string(sites) + ") : a -> cell\n");
        expect_sound(*grown);
        const std::vector<Shape> cells = grown->shapes("cell");
        EXPECT_NEAR(static_cast<double>(cells.size()), grown->area_of("a") / (14 * 14 * 0.95), 40) << sites;
        std::set<std::uint64_t> keys;
        for (const Shape& cell : cells) EXPECT_TRUE(keys.insert(cell.key.value).second);
    }
}

TEST(Voronoi, RelaxedCellsAreMoreAlike) {
    const auto deviation = [](const std::string& arguments) {
        const auto grown = grow("start a = rectangle(300, 300)\nvoronoi(" + arguments + ") : a -> cell\n");
        double sum = 0, squares = 0, count = 0;
        for (const Shape& cell : grown->shapes("cell")) {
            const double own = area(grown->tangle.polygon(cell));
            sum += own;
            squares += own * own;
            ++count;
        }
        const double mean = sum / count;
        return std::sqrt(squares / count - mean * mean) / mean;
    };
    EXPECT_LT(deviation("12"), 0.75 * deviation("12, random"));
}

TEST(Voronoi, AHoneycombRunsOnThroughNeighbours) {
    const auto grown = grow(
        "start a = rectangle(100, 100, at: (0, 0))\nstart a = rectangle(100, 100, at: (100, 0))\n"
        "voronoi(15, lattice) : a -> cell\n");
    // Cells on both sides of the common border share its points.
    std::map<std::int64_t, int> met;
    for (const Shape& cell : grown->shapes("cell")) {
        for (const Point p : grown->tangle.polygon(cell).outer()) {
            if (to_px(p).x == 50) ++met[p.y];
        }
    }
    EXPECT_GT(met.size(), 8U);
    for (const auto& [y, count] : met) EXPECT_GE(count, 2) << y;
}

}  // namespace
}  // namespace filigree
