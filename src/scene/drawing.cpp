#include "scene/drawing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace filigree {

void fit_canvas(Canvas& canvas, const Box& box, std::optional<double> margin) {
    const Vec low = to_px(box.min), high = to_px(box.max);
    const double around = margin.value_or(std::max(2.0, 0.02 * std::max(high.x - low.x, high.y - low.y)));
    const auto down = [](double px) { return std::floor(px * 1000) / 1000; };
    const Vec top = high + Vec{around, around};
    canvas.origin = {down(low.x - around), down(low.y - around)};
    canvas.size = {-down(canvas.origin.x - top.x), -down(canvas.origin.y - top.y)};
}

namespace {

struct Place {
    std::uint32_t group;
    std::size_t next_child;
};

// Whether a group or one below it has a shape. Children stand after their parents, so one pass from the end does.
std::vector<char> groups_with_shapes(const std::vector<DrawingGroup>& groups) {
    std::vector<char> has(groups.size(), 0);
    for (std::size_t g = groups.size(); g-- > 0;) {
        const DrawingGroup& group = groups[g];
        bool any = group.first_shape < group.end_shape || group.first_overlay < group.end_overlay;
        for (const std::uint32_t child : group.children) any = any || has[child] != 0;
        has[g] = any ? 1 : 0;
    }
    return has;
}

}  // namespace

std::vector<PaintStep> painting_steps(const Drawing& drawing) {
    std::vector<PaintStep> steps;
    const std::vector<char> has_shapes = groups_with_shapes(drawing.groups);
    std::vector<Place> open;
    const auto enter = [&](std::uint32_t g) {
        if (has_shapes[g] == 0) return;
        const DrawingGroup& group = drawing.groups[g];
        steps.push_back({PaintStep::Kind::enter, false, g, 0, 0});
        if (group.first_shape < group.end_shape) {
            steps.push_back({PaintStep::Kind::shapes, false, g, group.first_shape, group.end_shape});
        }
        open.push_back({g, 0});
    };
    if (!drawing.groups.empty()) enter(0);
    while (!open.empty()) {
        const std::uint32_t g = open.back().group;
        const DrawingGroup& group = drawing.groups[g];
        if (open.back().next_child < group.children.size()) {
            enter(group.children[open.back().next_child++]);
            continue;
        }
        if (group.first_overlay < group.end_overlay) {
            steps.push_back({PaintStep::Kind::shapes, true, g, group.first_overlay, group.end_overlay});
        }
        steps.push_back({PaintStep::Kind::leave, false, g, 0, 0});
        open.pop_back();
    }
    return steps;
}

}  // namespace filigree
