#include "engines/tangle/motifs.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "engines/tangle/orientation.h"
#include "plane/transform.h"

namespace filigree::tangle {
namespace {

// Looks farther and farther until there is something.
Vec along_border(const EdgeTree& border, Vec at, Vec otherwise) {
    for (double reach = 1; reach < 0x1p33; reach *= 4) {
        if (!border.is_any_nearer(at, reach)) continue;
        const EdgeTree::Place place = border.place(at, reach, reach);
        const Vec away = place.nearest - at;
        return place.distance > 0 ? perpendicular(away) * (1 / length(away)) : otherwise;
    }
    return otherwise;
}

}  // namespace

Result<DrawnMotifs> DrawnMotifs::of(const OperatorInput& input, std::string_view form, std::string_view size) {
    double largest = 0;
    for (std::size_t i = 0; i < input.shapes.size(); ++i) largest = std::max(largest, input.arguments.number(size, i));
    const auto read = [&](const Value& value) -> Result<std::shared_ptr<const Motif>> {
        const auto* call = std::get_if<SymbolicCall>(&value.data);
        if (call == nullptr) return std::shared_ptr<const Motif>();
        const Result<std::shared_ptr<const ShapeOutlines>> outlines = input.forms.outlines(*call);
        if (!outlines) return outlines.diagnostics();
        const double tolerance = std::clamp(input.resolution / std::max(largest, 1e-9), 1e-4, 0.02);
        auto motif = std::make_shared<const Motif>(drawn_motif((*outlines)->lines, (*outlines)->rule, tolerance));
        if (motif->points.empty()) {
            return error("tangle.empty-form", "'" + call->name + "' encloses no area that could be placed", value.span);
        }
        return {motif, outlines.diagnostics()};
    };
    DrawnMotifs all;
    Diagnostics warnings;
    const Value* last = nullptr;
    for (std::size_t i = 0; i < input.shapes.size(); ++i) {
        const Value& value = input.arguments.value(form, i);
        if (last == &value) continue;  // the same for all shapes
        Result<std::shared_ptr<const Motif>> motif =
            last != nullptr && *last == value ? Result(all.motifs_.back()) : read(value);
        last = &value;
        if (!motif) return motif.diagnostics();
        all.motifs_.push_back(*motif);
        if (warnings.empty()) warnings = motif.diagnostics();
    }
    return {std::move(all), std::move(warnings)};
}

Vec copy_direction(const Value& value, const Shape& shape, PolygonView polygon, const EdgeTree& border, Vec at,
                   std::uint64_t bits) {
    if (const auto* word = std::get_if<Symbol>(&value.data)) {
        if (word->name == "random") return unit_at_degrees(360 * to_unit(mix(bits ^ hash_text("rotation"))));
        if (word->name == "along") return along_border(border, at, shape.direction);
    }
    if (const auto* call = std::get_if<SymbolicCall>(&value.data); call != nullptr && call->name == "towards") {
        const Vec towards = std::get<Vec>(call->arguments.front().value.data) - at;
        const double distance = length(towards);
        return distance > 0 ? towards * (1 / distance) : shape.direction;
    }
    return direction_of(value, shape, polygon);
}

ParameterDescription rotation_parameter(std::string_view help, std::string_view default_text) {
    return {.name = "rotation",
            .type = ParameterType::direction,
            .help = help,
            .default_text = default_text,
            .words = {"keep", "across", "axis", "random", "along"},
            .calls = {"turn", "towards"}};
}

}  // namespace filigree::tangle
