#include "language/possible_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "language/path_cases.h"

namespace filigree {
namespace {

// big_poly : outline -> in, out;  in : regular_split -> [quads];  quads : outline -> in, out;  let gap
PathGraph example() {
    const std::vector<std::string> group = {"rule", "is_random"}, outline = {"distance", "when", "is_random"};
    PathGraph graph;
    graph.nodes = {
        {true, false, "big_poly", {1}, group},
        {false, false, "outline", {2, 3}, outline},
        {true, false, "in", {4}, group},
        {true, false, "out", {}, {}},
        {false, false, "regular_split", {5}, {"direction", "size", "is_random"}},
        {true, true, "quads", {6}, group},
        {false, false, "outline", {2, 3}, outline},
        {false, false, "let", {8}, {}},
        {false, false, "gap", {}, {"gap"}},
    };
    graph.roots = {0, 7};
    return graph;
}

PathCheck check(std::string_view path) { return check_path(example(), path_of(path)); }
std::string nearest(std::string_view path) { return check(path).nearest; }
using Nodes = std::vector<std::uint32_t>;

TEST(PossiblePaths, EndAtTheirNodes) {
    EXPECT_EQ(check("big_poly").ends, Nodes{0});
    EXPECT_EQ(check("big_poly/outline/in/regular_split/quads[3]/outline.distance~2").ends, Nodes{6});
    EXPECT_EQ(check("big_poly/outline/in/regular_split/quads/outline/in/regular_split/quads").ends, Nodes{5});
    EXPECT_EQ(check("**/outline").ends, (Nodes{1, 6}));
    EXPECT_EQ(check("**/quads/**/outline").ends, Nodes{6});
    EXPECT_EQ(check("**.is_random").ends, (Nodes{0, 1, 2, 4, 5, 6}));
    EXPECT_EQ(check("big_poly/outline/*.rule").ends, Nodes{2});
    EXPECT_EQ(check("let/gap").ends, Nodes{8});
    EXPECT_EQ(check("big_poly/outline/in[1,2]").ends, Nodes{2});
    EXPECT_TRUE(check("**").possible);
    EXPECT_TRUE(check("**").why.empty());
    EXPECT_TRUE(check("**").nearest.empty());
}

TEST(PossiblePaths, MayNameSingleShapes) {
    EXPECT_EQ(check("big_poly/2,5/outline.distance").ends, Nodes{1});
    const PathCheck shape = check("big_poly/2");
    EXPECT_TRUE(shape.possible);
    EXPECT_EQ(shape.ends, Nodes{});
    EXPECT_EQ(shape.shapes_of, Nodes{0});
    const PathCheck open = check("big_poly/outline/in/*");
    EXPECT_EQ(open.ends, Nodes{4});
    EXPECT_EQ(open.shapes_of, Nodes{2});
    EXPECT_EQ(check("big_poly/*/outline").ends, Nodes{1});
    EXPECT_FALSE(check("big_poly/2/3").possible);
    EXPECT_FALSE(check("big_poly/outline/2").possible);
    EXPECT_FALSE(check("let/2").possible);
    EXPECT_FALSE(check("2").possible);
    EXPECT_FALSE(check("big_poly/2.rule").possible);
}

TEST(PossiblePaths, TellWhatIsNot) {
    const auto why = [](std::string_view path) {
        const PathCheck result = check(path);
        EXPECT_FALSE(result.possible) << path;
        EXPECT_TRUE(result.ends.empty()) << path;
        return std::to_string(result.failing) + ": " + result.why;
    };
    EXPECT_EQ(why("bigpoly/outline"), "0: nothing called 'bigpoly' stands at the start");
    EXPECT_EQ(why("big_poly/outlin/in"), "1: nothing called 'outlin' stands below 'big_poly'");
    EXPECT_EQ(why("**/outline/quads"), "2: nothing called 'quads' stands below '**/outline'");
    EXPECT_EQ(why("big_poly/outline/in[2,3]"),
              "2: there are not several 'in' below 'big_poly/outline', so they have no numbers");
    EXPECT_EQ(why("big_poly/outline[1]"),
              "1: there are not several 'outline' below 'big_poly', so they have no numbers");
    EXPECT_EQ(why("big_poly/outline/2"), "2: 'big_poly/outline' is no group, so it has no shapes");
    EXPECT_EQ(why("2/outline"), "0: a path begins with a name, not with a shape's number");
    EXPECT_EQ(why("let/gap/*"), "2: nothing stands below 'let/gap'");
    EXPECT_EQ(why("big_poly/outline.distanc"), "2: 'big_poly/outline' has no parameter called 'distanc'");
}

TEST(PossiblePaths, ShowTheNearest) {
    EXPECT_EQ(nearest("bigpoly/outline/in.rul"), "big_poly/outline/in.rule");
    EXPECT_EQ(nearest("big_poly/outlin/in/regular_splitt/quad[3]"), "big_poly/outline/in/regular_split/quads[3]");
    EXPECT_EQ(nearest("big_poly/outline/in[2]/regular_split"), "big_poly/outline/in/regular_split");
    EXPECT_EQ(nearest("big_poly/outlin[2]/in"), "big_poly/outline/in");
    EXPECT_EQ(nearest("big_poly/outline.distanc~2"), "big_poly/outline.distance~2");
    EXPECT_EQ(nearest("**/outlin.distance"), "**/outline.distance");
    // Nothing is near: the first that may stand there.
    EXPECT_EQ(nearest("zzzzzz/outline"), "big_poly/outline");
    EXPECT_EQ(nearest("big_poly/outline.zzzzzz"), "big_poly/outline.distance");
    // A step was left out, or a parameter's step.
    EXPECT_EQ(nearest("big_poly/in/regular_split"), "big_poly/outline/in/regular_split");
    EXPECT_EQ(nearest("big_poly.distance"), "big_poly/outline.distance");
    // Too much is dropped.
    EXPECT_EQ(nearest("big_poly/zzzzzz/outline"), "big_poly/outline");
    EXPECT_EQ(nearest("big_poly/outline/2/in"), "big_poly/outline/in");
    EXPECT_EQ(nearest("let/gap/gap/gap"), "let/gap");
    EXPECT_EQ(nearest("let/gap/**/*/**"), "let/gap/**");
    EXPECT_EQ(nearest("2"), "big_poly");
    EXPECT_EQ(nearest("big_poly/2.rule"), "big_poly.rule");
    EXPECT_EQ(nearest("big_poly/outline/out/2.rule"), "big_poly/outline.distance");
    EXPECT_EQ(nearest("let.when"), "let");
}

TEST(PossiblePaths, OfAnEmptyGraphAreNone) {
    for (const std::string_view path : {"a", "**", "*/2.x"}) {
        const PathCheck result = check_path({}, path_of(path));
        EXPECT_FALSE(result.possible);
        EXPECT_EQ(result.failing, 0U);
        EXPECT_FALSE(result.why.empty());
        EXPECT_EQ(result.nearest, "");
    }
}

// --- against an oracle ------------------------------------------------------------------------------------------

const std::vector<std::string> node_names = {"inner", "outer", "middle"};
const std::vector<std::string> path_names = {"inner", "outer", "middle", "iner", "outre", "zzz"};
const std::vector<std::string> parameter_names = {"distance", "rule", "when"};

PathGraph random_graph(CaseRandom& random) {
    PathGraph graph;
    const std::uint32_t count = random.whole(1U, 4U);
    const auto random_nodes = [&](std::uint32_t most) {
        std::vector<std::uint32_t> nodes;
        for (std::uint32_t i = random.below(most + 1); i > 0; --i) nodes.push_back(random.below(count));
        return nodes;
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        PathNode& node = graph.nodes.emplace_back();
        node.is_group = random.coin();
        node.has_ordinals = random.coin();
        node.segment = node_names[random.index(node_names.size())];
        node.next = random_nodes(2);
        for (const std::string& name : parameter_names) {
            if (random.below(3) == 0) node.parameters.push_back(name);
        }
    }
    graph.roots = random_nodes(2);
    return graph;
}

// One segment of a walk through the graph: a node, or a single shape of it.
struct Found {
    std::uint32_t node = 0;
    bool is_shape = false;

    auto operator<=>(const Found&) const = default;
};

bool is_matched(const PathGraph& graph, const PathSegment& wanted, const Found& found) {
    const PathNode& node = graph.nodes[found.node];
    if (wanted.kind == PathSegment::Kind::any) return true;
    if (wanted.kind == PathSegment::Kind::shapes) return found.is_shape;
    if (found.is_shape || wanted.name != node.segment) return false;
    if (wanted.ordinals.empty() || node.has_ordinals) return true;
    return node.is_group && std::set<std::uint32_t>(wanted.ordinals.begin(), wanted.ordinals.end()).count(1) == 1;
}

bool is_matched(const PathGraph& graph, std::span<const PathSegment> wanted, std::span<const Found> found) {
    if (wanted.empty()) return found.empty();
    if (wanted.front().kind == PathSegment::Kind::any_depth) {
        return is_matched(graph, wanted.subspan(1), found) ||
               (!found.empty() && is_matched(graph, wanted, found.subspan(1)));
    }
    return !found.empty() && is_matched(graph, wanted.front(), found.front()) &&
           is_matched(graph, wanted.subspan(1), found.subspan(1));
}

// Where the walks of at most `depth` more segments end that the path matches.
void enumerate(const PathGraph& graph, const ChoicePath& path, std::vector<Found>& walked, std::size_t depth,
               std::set<Found>& ends) {
    if (!walked.empty() && is_matched(graph, path.segments, walked)) {
        const Found& end = walked.back();
        const std::vector<std::string>& has = graph.nodes[end.node].parameters;
        if (path.parameter.empty() ||
            (!end.is_shape && std::find(has.begin(), has.end(), path.parameter) != has.end())) {
            ends.insert(end);
        }
    }
    if (depth == 0) return;
    std::vector<Found> next;
    for (const std::uint32_t node : walked.empty() ? graph.roots : graph.nodes[walked.back().node].next) {
        next.push_back({node, false});
    }
    if (!walked.empty() && !walked.back().is_shape && graph.nodes[walked.back().node].is_group) {
        next.push_back({walked.back().node, true});
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    for (const Found& found : next) {
        walked.push_back(found);
        enumerate(graph, path, walked, depth - 1, ends);
        walked.pop_back();
    }
}

// The longest walk that a path of three segments with two `**` can need in a graph of four nodes.
constexpr std::size_t deepest = 9;

TEST(PathsAtRandom, ArePossibleWhereAWalkMatches) {
    const std::uint64_t cases = case_count();
    std::uint64_t possible = 0, repaired = 0;
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        CaseRandom random(seed);
        const PathGraph graph = random_graph(random);
        for (int i = 0; i < 4; ++i) {
            ChoicePath path = random_path(random, path_names, 3);
            if (random.below(3) == 0) path.parameter = parameter_names[random.index(parameter_names.size())];
            std::vector<Found> walked;
            std::set<Found> expected;
            enumerate(graph, path, walked, deepest, expected);

            const PathCheck result = check_path(graph, path);
            std::set<Found> found;
            for (const std::uint32_t node : result.ends) found.insert({node, false});
            for (const std::uint32_t node : result.shapes_of) found.insert({node, true});
            ASSERT_EQ(found, expected) << "seed " << seed << " " << to_text(path);
            ASSERT_EQ(found.size(), result.ends.size() + result.shapes_of.size()) << "seed " << seed;
            ASSERT_EQ(result.possible, !expected.empty()) << "seed " << seed << " " << to_text(path);
            ASSERT_TRUE(std::is_sorted(result.ends.begin(), result.ends.end())) << "seed " << seed;
            ASSERT_TRUE(std::is_sorted(result.shapes_of.begin(), result.shapes_of.end())) << "seed " << seed;
            ASSERT_EQ(result.why.empty(), result.possible) << "seed " << seed;
            possible += result.possible ? 1 : 0;

            // What is nearest is possible, and what is possible is its own nearest.
            const ChoicePath nearest = nearest_path(graph, path);
            if (graph.roots.empty()) {
                ASSERT_TRUE(nearest.segments.empty()) << "seed " << seed;
                continue;
            }
            ASSERT_TRUE(check_path(graph, nearest).possible)
                << "seed " << seed << " " << to_text(path) << " " << to_text(nearest);
            ASSERT_EQ(same_path(nearest, path), result.possible) << "seed " << seed << " " << to_text(path);
            ASSERT_EQ(result.nearest, result.possible ? "" : to_text(nearest)) << "seed " << seed;
            for (std::size_t k = 1; k < nearest.segments.size(); ++k) {
                ASSERT_FALSE(nearest.segments[k - 1].kind == PathSegment::Kind::any_depth &&
                             nearest.segments[k].kind == PathSegment::Kind::any_depth)
                    << "seed " << seed;
            }
            // The segments before the one that fails are kept, but where a parameter was looked for further up.
            if (!result.possible && path.parameter.empty()) {
                ASSERT_GE(nearest.segments.size(), result.failing) << "seed " << seed;
                for (std::size_t k = 0; k < result.failing; ++k) {
                    ASSERT_EQ(nearest.segments[k], path.segments[k]) << "seed " << seed;
                }
                ++repaired;
            }
        }
    }
    EXPECT_GT(possible, cases / 4);
    EXPECT_GT(repaired, cases / 4);
}

// Every node leads to every node, and every second segment may take any number of them.
TEST(PathsAtRandom, TakeNoExponentialTime) {
    PathGraph graph;
    for (std::uint32_t i = 0; i < 60; ++i) {
        graph.nodes.push_back({true, false, i % 2 == 0 ? "a" : "b", {}, {"rule"}});
        graph.roots.push_back(i);
    }
    for (PathNode& node : graph.nodes) node.next = graph.roots;
    ChoicePath path;
    for (int i = 0; i < 100; ++i) {
        path.segments.push_back({PathSegment::Kind::any_depth, {}, {}});
        path.segments.push_back({PathSegment::Kind::name, i % 2 == 0 ? "a" : "b", {}});
    }
    EXPECT_EQ(check_path(graph, path).ends.size(), 30U);
    path.segments.push_back({PathSegment::Kind::name, "c", {}});
    const PathCheck result = check_path(graph, path);
    EXPECT_EQ(result.failing, 200U);
    EXPECT_TRUE(result.nearest.ends_with("/**/b/a"));
}

}  // namespace
}  // namespace filigree
