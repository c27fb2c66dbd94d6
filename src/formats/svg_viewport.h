// The viewports of SVG elements: the root's, and those of nested svg elements and symbols.
#pragma once

#include <optional>

#include "formats/svg_attributes.h"

namespace filigree {

constexpr Vec usual_viewport{300, 150};  // px, where a root says nothing

struct RootViewport {
    Vec origin, size;     // px; shapes lie where the view box's coordinates, scaled, put them
    Transform transform;  // from the root's content to px
    Vec inner_size;       // what percentages inside are of
};
// None, with a diagnostic, where there is no size or it leaves the plane.
std::optional<RootViewport> root_viewport(SvgAttributes& root);

struct InnerViewport {
    Transform transform;  // from its content to what is around it
    Vec inner_size;
};
// None where it has no room. A `use` may say another size than the element's own.
std::optional<InnerViewport> inner_viewport(SvgAttributes& element, std::optional<double> use_width,
                                            std::optional<double> use_height);

}  // namespace filigree
