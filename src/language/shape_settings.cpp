#include "language/shape_settings.h"

#include <array>

namespace filigree {
namespace {

constexpr std::array settings = {
    ShapeSetting{"steps", "steps 12", "how many rules are applied, or until none applies"},
    ShapeSetting{"choose", "choose random", "which of the matches is taken: first, random, all at once, or an orbit"},
    ShapeSetting{"match", "match isometry", "under which maps left sides are found, in rules that do not say it"},
    ShapeSetting{"tolerance", "tolerance 0.001mm", "how far apart two curves may lie that count as one"},
    ShapeSetting{"show", "show control_polygons, matches(slide)", "what is drawn besides the design", true},
};

}  // namespace

std::span<const ShapeSetting> shape_settings() { return settings; }

const ShapeSetting* find_shape_setting(std::string_view name) {
    for (const ShapeSetting& setting : settings) {
        if (setting.name == name) return &setting;
    }
    return nullptr;
}

}  // namespace filigree
