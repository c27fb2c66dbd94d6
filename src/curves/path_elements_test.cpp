#include "curves/path_elements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "curves/along.h"

namespace filigree::curves {
namespace {

using elementary::pi;

Path path_of(const std::string& data) {
    Result<Path> path = parse_path_data(data);
    EXPECT_TRUE(path) << data;
    return path ? *std::move(path) : Path{};
}
std::vector<Element> elements_of_data(const std::string& data) { return elements_of(path_of(data)); }

// Each path's data and elements: "M0 0L1 0: 0".
std::vector<std::string> texts_of(const std::vector<JoinedPath>& paths) {
    std::vector<std::string> texts;
    for (const JoinedPath& one : paths) {
        std::string text = to_path_data(one.path) + ":";
        for (const std::uint32_t e : one.joined) text += " " + std::to_string(e);
        texts.push_back(text);
    }
    return texts;
}
using Texts = std::vector<std::string>;

double apart(Vec a, Vec b) { return length(a - b); }

TEST(PathElements, EveryVerb) {
    const Path path = path_of("M1 2L3 4Q5 6 7 8C9 10 11 12 13 14Z");
    std::vector<Element> expected{line_element({1, 2}, {3, 4}), parabola_element({3, 4}, {5, 6}, {7, 8}),
                                  cubic_element({7, 8}, {9, 10}, {11, 12}, {13, 14}), line_element({13, 14}, {1, 2})};
    for (Element& e : expected) {
        e.layer = 3;
        e.weight = 0.5;
    }
    EXPECT_EQ(elements_of(path, 3, 0.5), expected);
}

TEST(PathElements, LinesWithoutLengthAreNone) {
    EXPECT_TRUE(elements_of_data("M1 2L1 2Z").empty());
    EXPECT_EQ(elements_of_data("M0 0L4 0L4 3L0 0Z").size(), 3U);
    EXPECT_TRUE(elements_of_data("M1 2A5 5 0 0 1 1 2").empty());
}

TEST(PathElements, SubpathsBeginWhereTheLastOneDid) {
    const std::vector<Element> elements = elements_of_data("M1 1H5V4ZL9 9M0 0L2 0");
    ASSERT_EQ(elements.size(), 5U);
    EXPECT_EQ(elements[3], line_element({1, 1}, {9, 9}));
    EXPECT_EQ(elements[4], line_element({0, 0}, {2, 0}));
}

TEST(PathElements, Arcs) {
    const auto circle = elements_of_data("M-2 1A3 3 0 0 1 4 1A3 3 0 0 1 -2 1Z");
    ASSERT_EQ(circle.size(), 2U);
    for (const Element& half : circle) {
        ASSERT_EQ(half.kind, ElementKind::arc);
        EXPECT_TRUE(is_circular(half));
        EXPECT_LT(apart(half.at[0], {1, 1}), 1e-14);
        EXPECT_NEAR(half.to - half.from, pi, 1e-14);
    }
    // Either way round, and of an ellipse that leans.
    for (const char* data :
         {"M0 0A50 20 30 0 1 40 30", "M0 0A50 20 30 1 1 40 30", "M0 0A50 20 30 0 0 40 30", "M0 0A50 20 30 1 0 40 30"}) {
        const auto arc = elements_of_data(data);
        ASSERT_EQ(arc.size(), 1U);
        const auto [from, to] = ends_of(arc[0]);
        EXPECT_LT(std::min(apart(from, {0, 0}), apart(to, {0, 0})), 1e-12) << data;
        EXPECT_LT(std::min(apart(from, {40, 30}), apart(to, {40, 30})), 1e-12) << data;
        EXPECT_NEAR(length(arc[0].at[1]), 50, 1e-12) << data;
        EXPECT_NEAR(length(arc[0].at[2]), 20, 1e-12) << data;
        EXPECT_EQ(arc[0].to - arc[0].from > pi, data[14] == '1') << data;
    }
    EXPECT_EQ(elements_of_data("M0 0A0 5 0 0 1 4 0"), std::vector{line_element({0, 0}, {4, 0})});
}

TEST(PathElements, Joins) {
    const std::vector<Element> open{line_element({1, 0}, {2, 0}), line_element({0, 0}, {1, 0}),
                                    parabola_element({3, 1}, {3, 0}, {2, 0}), line_element({7, 7}, {8, 8})};
    EXPECT_EQ(texts_of(paths_of(open, 0)), (Texts{"M0 0L1 0L2 0Q3 0 3 1: 1 0 2", "M7 7L8 8: 3"}));
    const std::vector<Element> closed{cubic_element({0, 0}, {0, 1}, {1, 1}, {2, 0}), line_element({0, 0}, {2, 0})};
    EXPECT_EQ(texts_of(paths_of(closed, 0)), (Texts{"M0 0C0 1 1 1 2 0Z: 0 1"}));
    // The lowest-numbered element gives the direction.
    const std::vector<Element> turned{line_element({2, 0}, {0, 0}), cubic_element({0, 0}, {0, 1}, {1, 1}, {2, 0})};
    EXPECT_EQ(texts_of(paths_of(turned, 0)), (Texts{"M2 0L0 0C0 1 1 1 2 0Z: 0 1"}));
    // A curve that meets itself; points are in no path.
    const std::vector<Element> drop{point_element({5, 5}), cubic_element({0, 0}, {4, 4}, {-4, 4}, {0, 0})};
    EXPECT_EQ(texts_of(paths_of(drop, 0)), (Texts{"M0 0C4 4-4 4 0 0Z: 1"}));
    EXPECT_TRUE(paths_of({}, 1).empty());
}

TEST(PathElements, Tolerance) {
    const std::vector<Element> elements{line_element({0, 0}, {1, 0}), line_element({1.01, 0}, {2, 0})};
    EXPECT_EQ(texts_of(paths_of(elements, 0.02)), (Texts{"M0 0L1 0L2 0: 0 1"}));
    EXPECT_EQ(paths_of(elements, 0.009).size(), 2U);
    EXPECT_EQ(paths_of(elements, 0).size(), 2U);
    // Ends on either side of a cell's border, in every direction.
    for (int i = 0; i < 360; ++i) {
        const Vec place{3.7 + i, -2.1 * i}, ahead = unit_at_degrees(i);
        const Vec near = place + ahead * 0.0099, far = place + ahead * 0.0101;
        const std::vector<Element> two{line_element(place, place - ahead), line_element(near, near + ahead)};
        EXPECT_EQ(paths_of(two, 0.01).size(), 1U) << i;
        const std::vector<Element> more{line_element(place, place - ahead), line_element(far, far + ahead)};
        EXPECT_EQ(paths_of(more, 0.01).size(), 2U) << i;
    }
    // A dot is not joined to itself.
    EXPECT_EQ(texts_of(paths_of(std::vector{line_element({0, 0}, {0.001, 0})}, 0.01)), (Texts{"M0 0L0.001 0: 0"}));
}

TEST(PathElements, GoesStraightAhead) {
    // Three lines that cross in one point, each in two halves.
    std::vector<Element> star;
    for (int i = 0; i < 6; ++i) star.push_back(line_element({0, 0}, unit_at_degrees(60 * i + 7) * (1.0 + i)));
    const auto paths = paths_of(star, 1e-9);
    ASSERT_EQ(paths.size(), 3U);
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(paths[i].joined, (std::vector<std::uint32_t>{i + 3, i}));
    // Of three ends the sharpest stays alone.
    const std::vector<Element> fork{line_element({0, 0}, {5, 0}), line_element({5, 0}, {9, 3}),
                                    parabola_element({9, -2}, {7, 0}, {5, 0})};
    EXPECT_EQ(texts_of(paths_of(fork, 0)), (Texts{"M0 0L5 0Q7 0 9-2: 0 2", "M5 0L9 3: 1"}));
    // Curves whose first control point lies on the end go by the next.
    const std::vector<Element> blunt{line_element({0, 0}, {5, 0}), line_element({5, 0}, {9, 3}),
                                     cubic_element({5, 0}, {5, 0}, {7, 0}, {9, -2})};
    EXPECT_EQ(paths_of(blunt, 0)[0].joined, (std::vector<std::uint32_t>{0, 2}));
    // Equal turns: by number.
    const std::vector<Element> equal{line_element({0, 0}, {5, 0}), line_element({5, 0}, {9, 3}),
                                     line_element({5, 0}, {9, -3})};
    EXPECT_EQ(paths_of(equal, 0)[0].joined, (std::vector<std::uint32_t>{0, 1}));
}

TEST(PathElements, ManyEndsInOnePlace) {
    std::vector<Element> rays;
    for (int i = 0; i < 20'000; ++i) rays.push_back(line_element({3, 3}, Vec{3, 3} + unit_at_degrees(0.018 * i) * 50));
    const auto paths = paths_of(rays, 1e-6);
    ASSERT_EQ(paths.size(), 10'000U);
    for (const JoinedPath& path : paths) EXPECT_EQ(path.joined[0] - path.joined[1], 10'000U);
}

TEST(PathElements, GroupsStayApart) {
    std::vector<Element> elements{line_element({0, 0}, {1, 0}), line_element({1, 0}, {2, 0}),
                                  line_element({2, 0}, {3, 0}), line_element({3, 0}, {4, 0})};
    elements[1].layer = 1;
    elements[2].layer = 1;
    elements[3].weight = 2;
    EXPECT_EQ(texts_of(paths_of(elements, 0)), (Texts{"M0 0L1 0: 0", "M1 0L2 0L3 0: 1 2", "M3 0L4 0: 3"}));
    EXPECT_EQ(paths_of(elements, 0.1).size(), 3U);
    EXPECT_EQ(texts_of(paths_of(elements, 0.1, std::vector<std::uint32_t>{7, 7, 2, 2})),
              (Texts{"M0 0L1 0L2 0: 0 1", "M2 0L3 0L4 0: 2 3"}));
}

TEST(PathElements, ArcsAsSvgDrawsThem) {
    const auto data_of = [](const Element& e) { return texts_of(paths_of(std::vector{e}, 0)).at(0); };
    EXPECT_EQ(data_of(arc_element({0, 0}, {2, 0}, {0, 2}, -pi / 2, 0)), "M1.2246467991473532e-16-2A2 2 0 0 1 2 0: 0");
    // A whole ellipse is two arcs, and back.
    const auto halves = elements_of(paths_of(std::vector{arc_element({5, 6}, {4, 3}, {-1, 2}, -pi, pi)}, 0)[0].path);
    EXPECT_EQ(halves.size(), 2U);
    const auto circle = paths_of(std::vector{circle_element({1, 2}, 3)}, 0);
    EXPECT_EQ(circle[0].path.verbs, (std::vector{Verb::move, Verb::arc, Verb::arc, Verb::close}));
    EXPECT_EQ(elements_of(circle[0].path).size(), 2U);
    // Of every length, with their centres.
    for (int i = 1; i < 2000; ++i) {
        const double turn = 2 * pi * i / 2000;
        const Element arc = arc_element({30, -20}, {50, 0}, {0, 50}, 1, 1 + turn);
        double seen = 0;
        for (const Element& part : elements_of(paths_of(std::vector{arc}, 0)[0].path)) {
            EXPECT_LT(apart(part.at[0], arc.at[0]), 1e-11) << i;
            EXPECT_NEAR(length(part.at[1]), 50, 1e-11) << i;
            seen += part.to - part.from;
        }
        EXPECT_NEAR(seen, turn, 1e-12) << i;
    }
}

// --- properties

// Lines and curves between the points of a small lattice, so that many meet.
std::vector<Element> random_elements(CaseRandom& random) {
    std::vector<Element> elements;
    const auto place = [&] { return Vec{1.0 * random.whole(0, 3), 1.0 * random.whole(0, 3)}; };
    const auto anywhere = [&] { return Vec{random.between(-2, 5), random.between(-2, 5)}; };
    for (std::uint32_t count = random.below(25); elements.size() < count;) {
        const Vec from = place(), to = place();
        Element e;
        switch (random.below(6)) {
            case 0:
                e = parabola_element(from, anywhere(), to);
                break;
            case 1:
                e = cubic_element(from, anywhere(), anywhere(), to);
                break;
            case 2:
                e = arc_element(from, {random.between(0.1, 3), random.between(-3, 3)},
                                {random.between(-3, 3), random.between(0.1, 3)}, random.between(-9, 9),
                                random.between(-9, 9));
                break;
            case 3:
                if (from == to) continue;
                e = elements_of({{Verb::move, Verb::arc}, {from, {3, 3}, {0, 1.0 * random.below(4)}, to}}).at(0);
                break;
            default:
                e = line_element(from, to);
        }
        if (const auto normal = normal_form(e, 1e-3)) elements.push_back(*normal);
    }
    return elements;
}

// How many paths end openly at the least: one for every two places where an odd number of ends meets.
std::size_t odd_places(const std::vector<Element>& elements) {
    std::map<std::pair<double, double>, int> counts;
    for (const Element& e : elements) {
        if (is_closed(e)) continue;
        const auto [from, to] = ends_of(e);
        for (const Vec p : {from, to}) ++counts[{std::round(p.x * 1e6), std::round(p.y * 1e6)}];
    }
    std::size_t odd = 0;
    for (const auto& [place, count] : counts) odd += count % 2 == 1 ? 1 : 0;
    return odd;
}

TEST(PathElements, PathsAreMadeOfTheElements) {
    for (std::uint64_t seed = 0; seed < case_count(1000); ++seed) {
        CaseRandom random(seed);
        const std::vector<Element> elements = random_elements(random);
        const std::vector<JoinedPath> paths = paths_of(elements, 1e-9);
        std::vector<int> seen(elements.size(), 0);
        std::size_t open = 0;
        std::uint32_t last_first = 0;
        for (const JoinedPath& path : paths) {
            open += path.path.verbs.back() == Verb::close ? 0 : 1;
            EXPECT_EQ(std::count(path.path.verbs.begin(), path.path.verbs.end(), Verb::move), 1);
            const std::uint32_t first = *std::min_element(path.joined.begin(), path.joined.end());
            EXPECT_TRUE(&path == paths.data() || first > last_first) << "seed " << seed;
            last_first = first;
            // The path's own elements lie along those named, in their order; arcs in up to two.
            const std::vector<Element> own = elements_of(path.path);
            std::size_t next = 0;
            for (const std::uint32_t e : path.joined) {
                ++seen[e];
                const Interval whole = interval_of(elements[e]);
                double missing = whole.to - whole.from;
                for (; missing > 1e-6 && next < own.size(); ++next) {
                    const auto part = normal_form(own[next], 1e-9);
                    ASSERT_TRUE(part) << "seed " << seed;
                    ASSERT_TRUE(misfit(elements[e], *part, 1e-6)) << "seed " << seed << ", element " << e;
                    const Interval on = along(elements[e], *part, 1e-6)->on;
                    missing -= on.to - on.from;
                }
                ASSERT_NEAR(missing, 0, 1e-6) << "seed " << seed << ", element " << e;
            }
            ASSERT_EQ(next, own.size()) << "seed " << seed;
        }
        ASSERT_EQ(std::count(seen.begin(), seen.end(), 1), std::ssize(elements)) << "seed " << seed;
        ASSERT_EQ(2 * open, odd_places(elements)) << "seed " << seed;
    }
}

}  // namespace
}  // namespace filigree::curves
