#include "formats/svg_viewport.h"

#include <cmath>

namespace filigree {
namespace {

// A length of the root; a percentage would be of a window, and there is none.
std::optional<double> root_size(SvgAttributes& root, const char* name, Axis axis) {
    if (trimmed(root.text(name)).ends_with('%')) return std::nullopt;
    return root.size(name, axis);
}

Vec without_negative_zeros(Vec v) { return {v.x == 0 ? 0 : v.x, v.y == 0 ? 0 : v.y}; }

}  // namespace

std::optional<RootViewport> root_viewport(SvgAttributes& root) {
    const std::optional<double> width = root_size(root, "width", Axis::x), height = root_size(root, "height", Axis::y);
    const std::optional<ViewBox> box = root.view_box();
    const AspectRatio ratio = root.aspect_ratio();
    const Transform own = root.transform();
    Vec size{width.value_or(usual_viewport.x), height.value_or(usual_viewport.y)};
    if (box) {
        if (!width && !height) size = box->size;
        if (width && !height) size.y = *width * box->size.y / box->size.x;
        if (height && !width) size.x = *height * box->size.x / box->size.y;
    }
    if (!(size.x > 0 && size.y > 0) || !is_on_plane(size)) {
        root.refuse(size.x > 0 && size.x <= 0x1p30 ? "height" : "width", "svg.bad-size",
                    "must be above 0 and at most 2^30 px");
        return std::nullopt;
    }

    Transform fitted = box ? fit(*box, size, ratio) : Transform{};
    // A page in mm is written with a rounded size; its px are still px.
    if (std::fabs(fitted.a - 1) < 1e-9 && std::fabs(fitted.d - 1) < 1e-9) fitted.a = fitted.d = 1;
    RootViewport viewport;
    viewport.origin = without_negative_zeros({-fitted.e, -fitted.f});
    viewport.size = size;
    viewport.transform = compose(own, scaling(fitted.a, fitted.d));
    viewport.inner_size = box ? box->size : size;
    if (!is_on_plane(viewport.origin)) {
        root.refuse("viewBox", "svg.bad-size", "leaves the plane (2^30 px)");
        return std::nullopt;
    }
    return viewport;
}

std::optional<InnerViewport> inner_viewport(SvgAttributes& element, std::optional<double> use_width,
                                            std::optional<double> use_height) {
    const Transform own = element.transform();
    const Vec at{element.length_or("x", Axis::x, 0), element.length_or("y", Axis::y, 0)};
    const std::optional<double> width = element.size("width", Axis::x), height = element.size("height", Axis::y);
    const Vec around = element.viewport();
    const Vec size{use_width ? *use_width : width.value_or(around.x),
                   use_height ? *use_height : height.value_or(around.y)};
    const std::optional<ViewBox> box = element.view_box();
    const AspectRatio ratio = element.aspect_ratio();
    if (!(size.x > 0 && size.y > 0)) return std::nullopt;
    InnerViewport viewport{compose(own, translation(at)), size};
    if (box) {
        viewport.transform = compose(viewport.transform, fit(*box, size, ratio));
        viewport.inner_size = box->size;
    }
    return viewport;
}

}  // namespace filigree
