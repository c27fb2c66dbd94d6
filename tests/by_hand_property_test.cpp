// Laws of what is drawn by hand, over random grammars and outlines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engines/tangle/verify.h"
#include "formats/svg_write.h"
#include "plane/perturb.h"
#include "plane/verify.h"
#include "plane/weld.h"
#include "session/run.h"
#include "tests/random_document.h"

namespace filigree {
namespace {

using tangle::Tangle;

struct Opened {
    OpenedDocument opened;
    CheckedDocument checked;
};
Opened opened_text(std::string text) {
    Opened all{open_text("random.fil", std::move(text), {}), {}};
    all.checked = check_document(all.opened);
    return all;
}

std::optional<Tangle> derived(const Opened& all) {
    SerialExecutor serial;
    Result<Tangle> whole = derive_document(all.opened, all.checked, {}, serial, {});
    return whole ? std::optional(std::move(*whole)) : std::nullopt;  // else it reached a limit
}

// Which polygons share which edge, by the number of the edge's place in their rings' order.
using Edges = std::map<std::pair<Point, Point>, int>;
Edges edges_of(const Polygons& polygons) {
    Edges edges;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        for (std::size_t r = 0; r < polygons[i].ring_count(); ++r) {
            const RingView ring = polygons[i].ring(r);
            for (std::size_t k = 0; k < ring.size(); ++k) ++edges[{ring[k], ring[(k + 1) % ring.size()]}];
        }
    }
    return edges;
}
double rim_length(const Edges& edges) {
    double sum = 0;
    for (const auto& [edge, count] : edges) {
        if (!edges.contains({edge.second, edge.first})) sum += length(to_px(edge.second) - to_px(edge.first));
    }
    return sum;
}
std::size_t rim_count(const Edges& edges) {
    std::size_t count = 0;
    for (const auto& entry : edges) count += edges.contains({entry.first.second, entry.first.first}) ? 0 : 1;
    return count;
}

PerturbInput leaves_of(const Tangle& tangle, CaseRandom& random) {
    PerturbInput input;
    input.seed = random.bits();
    const int mood = random.whole(0, 3);
    const Wobble common{random.between(0.1, 4), random.between(10, 120)};
    for (const tangle::Group& group : tangle.groups) {
        Wobble own = common;
        if (mood == 1) own.amplitude = random.coin() ? 0 : random.between(0, 6);
        if (mood == 2) own = {random.between(0, 5), random.coin() ? 30.0 : 90.0};
        if (mood == 3 && random.below(3) == 0) own = follows_neighbours;
        if (group.consumer != tangle::none) continue;
        for (const tangle::Shape& shape : group.shapes) {
            if (shape.is_mark) continue;
            input.faces.polygons.add(tangle.polygon(shape));
            input.faces.wobbles.push_back(own);
        }
    }
    for (std::uint32_t g = 0; g < tangle.start_groups; ++g) {
        for (const tangle::Shape& shape : tangle.groups[g].shapes) {
            input.borders.polygons.add(tangle.polygon(shape));
            input.borders.wobbles.push_back(common);
        }
    }
    return input;
}

TEST(ByHandProperty, PerturbedLeavesStayAPartition) {
    std::size_t shapes = 0;
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(300); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Opened all = opened_text(RandomDocument(seed).text());
        const std::optional<Tangle> tangle = derived(all);
        if (!tangle) continue;
        CaseRandom random(seed);
        const PerturbInput input = leaves_of(*tangle, random);
        const Perturbed moved = perturb(input);
        ASSERT_EQ(moved.faces.size(), input.faces.polygons.size());
        shapes += moved.faces.size();
        for (std::size_t i = 0; i < moved.faces.size(); ++i) {
            if (moved.faces[i].ring_count() == 0) continue;
            ASSERT_EQ(find_flaw(moved.faces[i]).value_or(""), "") << "polygon " << i;
        }
        ASSERT_EQ(find_overlap(moved.faces).value_or(""), "");
        ASSERT_NEAR(area(moved.faces), area(moved.borders), 1e-9 * area(moved.borders));
        // Edges that two faces share are shared still: only the rim has edges on its own.
        ASSERT_LE(rim_count(edges_of(moved.faces)), rim_count(edges_of(moved.borders)) + 8);
        ASSERT_NEAR(rim_length(edges_of(moved.faces)), rim_length(edges_of(moved.borders)), 1e-4);
    }
    std::cout << shapes << " shapes\n";
    EXPECT_GT(shapes, 10 * case_count(300));
}

std::string random_styles(std::uint64_t seed) {
    CaseRandom random(seed);
    static constexpr const char* styles[] = {
        "style * { wobble: 1.5px }",
        "style * { wobble: 0.5px..2px; wobble-length: 60px }",
        "style t1, t2 { wobble: 2px; wobble-length: 30px }",
        "style t3 { wobble: 0 }",
        "style * { line: drawn }",
        "style t2, t3 { line: drawn; pen: 1px..2px }",
        "style t0, t1 { pen: 2px; stroke: #204080; line: one_of(drawn, even) }",
        "style t2 { fill: none; stroke: none }",
    };
    std::string all;
    for (const char* style : styles) {
        if (random.below(3) == 0) all += std::string(style) + "\n";
    }
    return all;
}

TEST(ByHandProperty, DrawingsAreCleanPolygonsWhoseKeysStay) {
    SerialExecutor serial;
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(100); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::string text = RandomDocument(seed, 1.5).text() + random_styles(seed);
        const Opened all = opened_text(text);
        ASSERT_FALSE(has_errors(all.checked.diagnostics)) << text;
        const auto run = run_document(all.opened, all.checked, {}, serial, {});
        if (!run) continue;
        const Drawing& drawing = run->drawing;
        for (const DrawnShape& shape : drawing.shapes) {
            ASSERT_LT(shape.geometry, drawing.geometry.size());
            ASSERT_LT(shape.polygon, drawing.geometry[shape.geometry]->size());
            const PolygonView polygon = (*drawing.geometry[shape.geometry])[shape.polygon];
            if (polygon.ring_count() == 0) continue;
            ASSERT_EQ(find_flaw(polygon).value_or(""), "") << text;
        }
        std::size_t painted = 0;
        for (const PaintStep& step : painting_steps(drawing)) painted += step.end - step.first;
        ASSERT_EQ(painted, drawing.shapes.size());
        const auto again = run_document(all.opened, all.checked, {}, serial, {});
        ASSERT_TRUE(again);
        ASSERT_EQ(to_svg(drawing, {}), to_svg(again->drawing, {}));
    }
}

}  // namespace
}  // namespace filigree
