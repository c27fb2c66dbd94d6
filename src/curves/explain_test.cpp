#include "curves/explain.h"

#include <gtest/gtest.h>

#include "curves/curve_test_shapes.h"
#include "curves/moments.h"
#include "curves/detect.h"
#include "curves/test_shapes.h"

namespace filigree::curves {
namespace {

using test_shapes::flower;
using test_shapes::moved;
using test_shapes::petal;
using test_shapes::shape_of;

Explanation explanation_of(const Shape& left, const Shape& design, const MatchOptions& options = {},
                           std::optional<Vec> near = std::nullopt) {
    return explain(left, MatchIndex(design, options.tolerance), options, near);
}

// The design without `share` of the length of one element's parameter at its end.
Shape shortened(const Shape& design, std::size_t element, double share) {
    std::vector<Element> elements = design.elements;
    const Interval on = interval_of(elements[element]);
    elements[element] = piece_of(elements[element], {on.from, on.to - share * (on.to - on.from)});
    return shape_of(elements);
}

Shape triangle() {
    return shape_of({line_element({0, 0}, {6, 0}), line_element({6, 0}, {1, 4}), line_element({1, 4}, {0, 0})});
}
const Transform somewhere = compose(translation({20, -7}), compose(rotation_degrees(33), scaling(1.5, 1.5)));

TEST(Explain, AMatchLacksNothing) {
    const Explanation found = explanation_of(petal(), flower());
    EXPECT_TRUE(found.is_match());
    EXPECT_EQ(found.fitting, 2U);
    EXPECT_EQ(text_of(found), (std::vector<std::string>{"every element lies on the design"}));
}

TEST(Explain, AParabolaThatEndsTooEarlyIsNamedWithWhereItEnds) {
    const Shape design = moved(petal(), somewhere);
    const Shape cut = shortened(design, 1, 0.004);
    const Explanation found = explanation_of(petal(), cut);
    EXPECT_FALSE(found.is_match());
    EXPECT_EQ(found.fitting, 1U);
    const std::size_t lacking = found.findings[0].lack == Lack::none ? 1 : 0;
    EXPECT_EQ(found.findings[lacking].lack, Lack::ends_early);
    EXPECT_NEAR(found.findings[lacking].share, 0.004, 0.003);
    const auto [first, last] = ends_of(cut.elements[*found.findings[lacking].carrier]);
    EXPECT_LT(std::min(length(found.findings[lacking].at - first), length(found.findings[lacking].at - last)), 1e-9);
    ASSERT_EQ(text_of(found).size(), 1U);
    EXPECT_NE(text_of(found)[0].find("(parabola): its curve ends 0."), std::string::npos) << text_of(found)[0];
}

TEST(Explain, ALineThatEndsTooEarlyIsFoundByTheOthers) {
    const Shape design = moved(triangle(), somewhere);
    for (std::size_t i = 0; i < 3; ++i) {
        SCOPED_TRACE(i);
        const Explanation found = explanation_of(triangle(), shortened(design, i, 0.004));
        EXPECT_EQ(found.fitting, 2U);
        EXPECT_NEAR(found.scale, 1.5, 1e-6);
        for (const Finding& finding : found.findings) {
            if (finding.lack == Lack::none) continue;
            EXPECT_EQ(finding.lack, Lack::ends_early);
            EXPECT_NEAR(finding.share, 0.004, 1e-6);
        }
        EXPECT_NE(text_of(found)[0].find("(line): its curve ends 0.4 % too early, at ("), std::string::npos);
    }
}

TEST(Explain, ElementsOfEveryKindThatEndTooEarlyAreFound) {
    CaseRandom random(11);
    for (const ElementKind kind : {ElementKind::line, ElementKind::parabola, ElementKind::arc, ElementKind::cubic}) {
        for (int round = 0; round < 10; ++round) {
            SCOPED_TRACE(static_cast<int>(kind) * 100 + round);
            Element own = random_element(random, kind);
            while (is_closed(own)) own = random_element(random, kind);
            std::vector<Element> elements = petal().elements;
            elements.push_back(own);
            const Shape left = shape_of(elements);
            const Shape design = moved(left, random_similarity(random));
            for (std::size_t i = 0; i < design.elements.size(); ++i) {
                if (design.elements[i].kind != kind) continue;
                const Shape cut = shortened(design, i, 0.01);
                const Explanation found = explanation_of(left, cut);
                EXPECT_EQ(found.fitting, 2U);
                std::size_t early = 0;
                for (const Finding& finding : found.findings) early += finding.lack == Lack::ends_early;
                EXPECT_EQ(early, 1U);
            }
        }
    }
}

TEST(Explain, WhatLiesOffIsMeasuredInTolerances) {
    // Of the same size, since a triangle with a side moved aside is a triangle of another size.
    Shape design = moved(triangle(), compose(translation({20, -7}), rotation_degrees(33)));
    MatchOptions options;
    options.group = MatchGroup::isometry;
    const Vec way = design.elements[0].at[1] - design.elements[0].at[0];
    const Vec aside = perpendicular(way) * (3.2e-6 / length(way));
    for (Vec& end : design.elements[0].at) end = end + aside;
    design.elements[0] = piece_of(design.elements[0], {-0.1, 1.1});
    const Explanation found = explanation_of(triangle(), design, options);
    EXPECT_EQ(found.fitting, 2U);
    const auto off = std::find_if(found.findings.begin(), found.findings.end(),
                                  [](const Finding& finding) { return finding.lack != Lack::none; });
    EXPECT_EQ(off->lack, Lack::off);
    EXPECT_NEAR(off->tolerances, 3.2, 0.01);
    EXPECT_NE(text_of(found)[0].find("(line): lies 3.2 tolerances off"), std::string::npos) << text_of(found)[0];
}

TEST(Explain, ColoursLabelsAndWeightsAreNamed) {
    Shape left = petal();
    left.elements.insert(left.elements.begin(), point_element({3, 3}));
    Shape design = moved(left, somewhere);
    ASSERT_TRUE(explanation_of(left, design).is_match());
    design.elements[0].layer = 4;
    EXPECT_EQ(text_of(explanation_of(left, design))[0], "element 1 (point): the label there is another one");
    design.elements[0].layer = 0;
    design.elements[1].layer = 4;
    EXPECT_NE(text_of(explanation_of(left, design))[0].find("the colour there is another one"), std::string::npos);
    for (Element& e : design.elements) e.layer = 4;
    EXPECT_EQ(text_of(explanation_of(left, design)).size(), 3U);
    for (Element& e : design.elements) e.layer = 0;
    design.elements[2].weight = 0.5;
    EXPECT_NE(text_of(explanation_of(left, design))[0].find("what lies there is too light"), std::string::npos);
    design.elements[2].weight = 2;
    EXPECT_TRUE(explanation_of(left, design).is_match());
    MatchOptions equal;
    equal.weights = WeightRule::equal;
    EXPECT_NE(text_of(explanation_of(left, design, equal))[0].find("what lies there is too heavy"), std::string::npos);
}

TEST(Explain, WhatTheGroupDoesNotAllowIsNamed) {
    const Shape hook = shape_of({parabola_element({-1, -1}, {1, -3}, {3, 3}), line_element({3, 3}, {5, 0})});
    MatchOptions options;
    options.with_reflections = false;
    Explanation found = explanation_of(hook, moved(hook, scaling(-1, 1)), options);
    EXPECT_EQ(text_of(found), (std::vector<std::string>{"it would have to be reflected"}));
    options.group = MatchGroup::isometry;
    found = explanation_of(hook, moved(hook, scaling(1.25, 1.25)), options);
    EXPECT_EQ(text_of(found), (std::vector<std::string>{"the scale, 1.3, is not allowed"}));
    options.group = MatchGroup::translation;
    found = explanation_of(hook, moved(hook, rotation_degrees(30)), options);
    EXPECT_EQ(text_of(found), (std::vector<std::string>{"it would have to be turned by 30 degrees"}));
    options.group = MatchGroup::similarity;
    options.min_scale = 2;
    found = explanation_of(hook, moved(hook, scaling(0.5, 0.5)), options);
    EXPECT_EQ(text_of(found), (std::vector<std::string>{"the scale, 0.5, is not allowed"}));
}

TEST(Explain, APlaceChoosesAmongEmbeddings) {
    const Shape design = moved(petal(), somewhere);
    std::vector<Element> elements = shortened(design, 0, 0.01).elements;
    const Transform elsewhere = compose(translation({-40, 3}), rotation_degrees(200));
    for (const Element& e : shortened(moved(petal(), elsewhere), 1, 0.3).elements) elements.push_back(e);
    const Shape both = shape_of(elements);
    const auto centroid_at = [&](std::optional<Vec> near) { return explanation_of(petal(), both, {}, near).centroid; };
    const Vec here = apply(somewhere, centroid_of(petal())), there = apply(elsewhere, centroid_of(petal()));
    EXPECT_LT(length(centroid_at(std::nullopt) - here), 1);
    EXPECT_LT(length(centroid_at(here) - here), 1);
    EXPECT_LT(length(centroid_at(there) - there), 1);
}

TEST(Explain, WhatTheDesignDoesNotHaveIsSaid) {
    Shape left = petal();
    left.elements.push_back(circle_element({0, 0}, 1));
    Explanation found = explanation_of(left, flower());
    EXPECT_EQ(text_of(found).back(), "element 3 (arc): there is no arc in the whole design");
    EXPECT_EQ(found.fitting, 2U);
    found = explanation_of(left, {});
    EXPECT_EQ(found.fitting, 0U);
    EXPECT_EQ(text_of(found).size(), 3U);
    const std::atomic<bool> flag = true;
    MatchOptions options;
    options.job.cancel_flag = &flag;
    EXPECT_FALSE(explanation_of(left, flower(), options).is_complete);
}

// Among much else the work stays bounded.
TEST(Explain, LargeDesignsAreExplainedByWhatIsNearThePlace) {
    CaseRandom random(3);
    std::vector<Element> elements;
    for (int i = 0; i < 3000; ++i) {
        const Element e = random_element(random, i % 2 == 0 ? ElementKind::line : ElementKind::parabola);
        elements.push_back(transformed(e, compose(translation(random_place(random, Coordinates::any, 400)),
                                                  rotation_degrees(random.between(0, 360)))));
    }
    const Transform by = compose(translation({123, 45}), scaling(0.5, 0.5));
    Shape left = petal();
    for (const Element& e : triangle().elements) left.elements.push_back(e);
    left = shape_of(left.elements);
    for (const Element& e : shortened(moved(left, by), 0, 0.02).elements) elements.push_back(e);
    const Explanation found = explanation_of(left, shape_of(elements), {}, Vec{123, 45});
    EXPECT_EQ(found.fitting, 4U);
    EXPECT_NEAR(found.scale, 0.5, 1e-9);
}

}  // namespace
}  // namespace filigree::curves
