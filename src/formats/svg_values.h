// The little languages inside SVG's attributes: numbers, lengths, lists of transforms, viewports.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "plane/point.h"
#include "plane/transform.h"

namespace filigree {

std::string_view trimmed(std::string_view text);  // without white space at its ends

// The whole text as numbers with white space or one comma between them; none where that is not so.
std::optional<std::vector<double>> parse_number_list(std::string_view text);

struct SvgLength {
    double value = 0;  // px, or per cent
    bool is_percentage = false;

    bool operator==(const SvgLength&) const = default;
};
// A number with an optional unit: px, mm, cm, Q, in, pt, pc, %; em, rem and ex as in a font of 16 px.
std::optional<SvgLength> parse_length(std::string_view text);

std::optional<Transform> parse_transform_list(std::string_view text);

struct ViewBox {
    Vec origin;
    Vec size;  // above 0
};
// None for `none`, for anything that is no four numbers and for sizes that are not above 0.
std::optional<ViewBox> parse_view_box(std::string_view text);

// How a view box is fitted into its viewport.
struct AspectRatio {
    bool stretch = false;                 // none
    bool slice = false;                   // cover instead of meet
    double align_x = 0.5, align_y = 0.5;  // 0 min, 0.5 mid, 1 max
};
std::optional<AspectRatio> parse_aspect_ratio(std::string_view text);

// From the view box's units into the viewport (whose top left is the origin), of `size`.
Transform fit(const ViewBox& box, Vec size, const AspectRatio& ratio);

}  // namespace filigree
