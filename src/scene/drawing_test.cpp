#include "scene/drawing.h"

#include <gtest/gtest.h>

#include <string>

namespace filigree {
namespace {

// The walk as text: "(0", "a..b", "a..b!" for an overlay, ")".
std::string walk(const Drawing& drawing) {
    std::string text;
    for (const PaintStep& step : painting_steps(drawing)) {
        if (step.kind == PaintStep::Kind::enter) text += "(" + std::to_string(step.group);
        if (step.kind == PaintStep::Kind::leave) text += ")";
        if (step.kind == PaintStep::Kind::shapes) {
            text += " " + std::to_string(step.first) + ".." + std::to_string(step.end) + (step.overlay ? "! " : " ");
        }
    }
    return text;
}

TEST(PaintingSteps, ShapesThenChildrenThenOverlay) {
    Drawing drawing;
    drawing.shapes.resize(9);
    drawing.groups.resize(5);
    drawing.groups[0] = {"root", 0, 2, 2, 3, {1, 2}};
    drawing.groups[1] = {"root/empty", 0, 0, 0, 0, {3}};
    drawing.groups[2] = {"root/b", 3, 5, 0, 0, {4}};
    drawing.groups[3] = {"root/empty/too", 7, 7, 7, 7, {}};
    drawing.groups[4] = {"root/b/c", 0, 0, 5, 9, {}};
    EXPECT_EQ(walk(drawing), "(0 0..2 (2 3..5 (4 5..9! )) 2..3! )");
}

TEST(PaintingSteps, AnEmptyDrawingHasNone) {
    Drawing drawing;
    EXPECT_EQ(walk(drawing), "");
    drawing.groups.resize(3);
    drawing.groups[0].children = {1, 2};
    EXPECT_EQ(walk(drawing), "");
}

TEST(PaintingSteps, DeepTreesTakeNoStack) {
    Drawing drawing;
    drawing.shapes.resize(1);
    drawing.groups.resize(200'000);
    for (std::uint32_t g = 0; g + 1 < drawing.groups.size(); ++g) drawing.groups[g].children = {g + 1};
    drawing.groups.back().end_shape = 1;
    EXPECT_EQ(painting_steps(drawing).size(), 400'001U);
}

}  // namespace
}  // namespace filigree
