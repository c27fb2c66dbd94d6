#include "engines/tangle/density.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "language/form_value.h"

namespace filigree::tangle {

// sums[(height + 1) rows of (width + 1)]: of all pixels above and to the left.
struct DarknessSums {
    std::uint32_t width = 0, height = 0;
    std::vector<double> sums;

    // The mean over a rectangle in pixels, cut off at the picture's rim.
    double mean(double left, double top, double right, double bottom) const {
        const auto clamped = [](double v, std::uint32_t most) {
            return static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(most)));
        };
        std::size_t x0 = clamped(std::floor(left), width), x1 = clamped(std::ceil(right), width);
        std::size_t y0 = clamped(std::floor(top), height), y1 = clamped(std::ceil(bottom), height);
        if (x0 == x1 || y0 == y1) return 0;
        const std::size_t row = std::size_t{width} + 1;
        const double sum = sums[y1 * row + x1] - sums[y0 * row + x1] - sums[y1 * row + x0] + sums[y0 * row + x0];
        return sum / (static_cast<double>(x1 - x0) * static_cast<double>(y1 - y0));
    }
};

namespace {

std::vector<OperatorDescription> make_forms() {
    const auto part = [](std::string_view name, std::string_view help, std::string_view default_text) {
        return ParameterDescription{
            .name = name, .type = ParameterType::real, .help = help, .default_text = default_text, .low = 0, .high = 1};
    };
    return {{.name = "gradient",
             .help = "from one density to another across the box",
             .source = "Secord 2002",
             .parameters = {part("from", "where it begins", "1"), part("to", "where it ends", "0"),
                            ParameterDescription{.name = "angle",
                                                 .type = ParameterType::angle,
                                                 .help = "which way it goes, from the x axis towards y",
                                                 .default_text = "90"}},
             .example = "stipple(3, density: gradient(1, 0.1, 45)) : petal -> dotted"},
            {.name = "radial",
             .help = "from the middle of the box to the ellipse in it",
             .source = "Secord 2002",
             .parameters = {part("centre", "in the middle", "0"), part("border", "on the ellipse and beyond", "1")},
             .example = "stipple(3, density: radial(0.05, 1)) : petal -> dotted"},
            {.name = "image",
             .help = "a picture over the box, which it covers; the darker, the denser",
             .source = "Secord 2002",
             .parameters = {{.name = "name",
                             .type = ParameterType::text,
                             .help = "a PNG or JPEG file, beside the document or below it"}},
             .example = "stipple(2, size: 1, density: image(\"portrait.png\")) : page -> dotted"}};
}

std::shared_ptr<const DarknessSums> sums_of(const GreyImage& image) {
    auto picture = std::make_shared<DarknessSums>();
    picture->width = image.width;
    picture->height = image.height;
    const std::size_t row = std::size_t{image.width} + 1;
    picture->sums.assign(row * (std::size_t{image.height} + 1), 0);
    for (std::size_t y = 0; y < image.height; ++y) {
        double in_row = 0;
        for (std::size_t x = 0; x < image.width; ++x) {
            in_row += static_cast<double>(image.darkness[y * image.width + x]);
            picture->sums[(y + 1) * row + x + 1] = picture->sums[y * row + x + 1] + in_row;
        }
    }
    return picture;
}

struct Area {  // px
    Vec centre, half;
};
Area area_of(const Box& box) {
    const Vec low = to_px(box.min), high = to_px(box.max);
    return {0.5 * (low + high), 0.5 * (high - low)};
}

std::function<double(Vec)> gradient(const SymbolicCall& call, const Area& area) {
    const elementary::CosSin turn = elementary::cos_sin_degrees(number_of(call, "angle"));
    const Vec along{turn.cos, turn.sin};
    const double reach = std::fabs(along.x) * area.half.x + std::fabs(along.y) * area.half.y;
    const double from = number_of(call, "from"), to = number_of(call, "to");
    return [=](Vec p) {
        const double t = std::clamp(0.5 + 0.5 * dot(p - area.centre, along) / reach, 0.0, 1.0);
        return from + (to - from) * t;
    };
}

std::function<double(Vec)> radial(const SymbolicCall& call, const Area& area) {
    const double centre = number_of(call, "centre"), border = number_of(call, "border");
    return [=](Vec p) {
        const Vec off = p - area.centre;
        const double t = std::min(length({off.x / area.half.x, off.y / area.half.y}), 1.0);
        return centre + (border - centre) * t;
    };
}

std::function<double(Vec)> covering(std::shared_ptr<const DarknessSums> picture, const Area& area, double blur) {
    // So many pixels to the px that the picture just covers the area, their middles one on the other.
    const double pixels = std::min(picture->width / (2 * area.half.x), picture->height / (2 * area.half.y));
    const Vec middle{picture->width / 2.0, picture->height / 2.0};
    const double half = std::max(blur * pixels, 1.0) / 2;
    return [picture = std::move(picture), middle, pixels, half, centre = area.centre](Vec p) {
        const Vec at = middle + (p - centre) * pixels;
        return picture->mean(at.x - half, at.y - half, at.x + half, at.y + half);
    };
}

}  // namespace

const std::vector<OperatorDescription>& density_forms() {
    static const std::vector<OperatorDescription> forms = make_forms();
    return forms;
}

Result<Densities> Densities::of(const OperatorInput& input, std::string_view density, std::string_view over) {
    Densities densities;
    Box group;
    for (std::size_t i = 0; i < input.shapes.size(); ++i) {
        const Box own = bounds(input.tangle.polygon(input.shapes[i]));
        extend(group, own.min);
        extend(group, own.max);
    }
    const Value* last = nullptr;
    for (std::size_t i = 0; i < input.shapes.size(); ++i) {
        const Value& value = input.arguments.value(density, i);
        if (input.arguments.word(over, i) == "group") densities.boxes_.resize(input.shapes.size());
        if (!densities.boxes_.empty() && input.arguments.word(over, i) == "group") densities.boxes_[i] = group;
        if (last == &value) continue;  // the same for all shapes
        One one{value, nullptr};
        if (last != nullptr && *last == value) {
            one.picture = densities.all_.back().picture;
        } else if (const auto* call = std::get_if<SymbolicCall>(&value.data);
                   call != nullptr && call->name == "image") {
            const Result<std::shared_ptr<const GreyImage>> image = input.forms.image(text_of(*call, "name"));
            if (!image) return image.diagnostics();
            one.picture = sums_of(**image);
        }
        last = &value;
        densities.all_.push_back(std::move(one));
    }
    return densities;
}

std::function<double(Vec)> Densities::at(std::size_t shape, PolygonView polygon, double blur) const {
    const One& one = all_.size() == 1 ? all_[0] : all_[shape];
    if (const auto* number = std::get_if<Quantity>(&one.value.data)) {
        const double density = number->value;
        if (density == 1) return {};
        return [density](Vec) { return density; };
    }
    const auto& call = std::get<SymbolicCall>(one.value.data);
    const Area area = area_of(boxes_.empty() || is_empty(boxes_[shape]) ? bounds(polygon) : boxes_[shape]);
    if (call.name == "gradient") return gradient(call, area);
    if (call.name == "radial") return radial(call, area);
    return covering(one.picture, area, blur / 4);
}

}  // namespace filigree::tangle
