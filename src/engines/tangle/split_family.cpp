#include "engines/tangle/split_family.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/elementary.h"

namespace filigree::tangle {
namespace {

constexpr double sliver = 0.25;  // of the distance: thinner end strips join their neighbour
constexpr std::size_t most_levels = 1'000'000;

double sum(const std::vector<double>& offsets) { return std::accumulate(offsets.begin(), offsets.end(), 0.0); }

// Where each of `cycles` rounds of offsets starts and goes on, as degrees from the first.
std::vector<double> degrees_of(const std::vector<double>& offsets, double cycles, double first_degrees) {
    std::vector<double> degrees;
    const double period = sum(offsets);
    for (double cycle = 0; cycle < cycles; ++cycle) {
        double within = 0;
        for (const double offset : offsets) {
            degrees.push_back(first_degrees + 360 * ((cycle + within / period) / cycles));
            within += offset;
        }
    }
    return degrees;
}

}  // namespace

SplitLevels levels_in(const SplitLayout& layout, const std::vector<double>& offsets) {
    const double period = sum(offsets);
    const double extent = layout.whole.high - layout.whole.low;
    const auto size = static_cast<std::int64_t>(offsets.size());
    double stretch = 1;
    double anchor = layout.from_zero ? 0 : (layout.whole.low + layout.whole.high) / 2;
    if (layout.fit && !layout.from_zero) {
        const double periods = std::max(1.0, std::round(extent / period));
        stretch = extent / (periods * period);
        anchor = layout.whole.low;
    }
    const double visible = layout.visible.high - layout.visible.low;
    if (!(visible / (stretch * period) * static_cast<double>(size) < static_cast<double>(most_levels))) {
        return {.at = {}, .first_strip = 0, .too_many = true};
    }
    // Cut number n (of any sign) lies at the anchor plus whole periods plus the offsets before it in its period.
    const auto position = [&](std::int64_t n) {
        std::int64_t cycle = n / size, rest = n % size;
        if (rest < 0) {
            rest += size;
            --cycle;
        }
        const double within = std::accumulate(offsets.begin(), offsets.begin() + rest, 0.0);
        return anchor + stretch * (static_cast<double>(cycle) * period + within);
    };
    // Strips thinner than a part of the distance are left out at the ends of the layout.
    const double thin = layout.keeps_slivers ? 0 : sliver * stretch * *std::min_element(offsets.begin(), offsets.end());
    const double low = std::max(layout.visible.low, layout.whole.low + thin);
    const double high = std::min(layout.visible.high, layout.whole.high - thin);
    SplitLevels levels;
    auto n = static_cast<std::int64_t>(std::floor((low - anchor) / (stretch * period))) * size;
    while (position(n) <= low) ++n;
    levels.first_strip = static_cast<std::int32_t>(n - 1);
    for (; position(n) < high; ++n) levels.at.push_back(position(n));
    return levels;
}

SplitLevels ring_levels(const PolarLayout& layout, const std::vector<double>& offsets) {
    return levels_in({layout.reach, layout.visible, !layout.fit, layout.fit, layout.keeps_slivers}, offsets);
}

Circles rings_of(const PolarLayout& layout, SplitLevels levels) {
    return {layout.centre, std::move(levels.at), levels.first_strip, layout.tolerance};
}

Rays rays_of(const PolarLayout& layout, const std::vector<double>& offsets, double at_distance) {
    const double around = 2 * elementary::pi * at_distance / sum(offsets);
    // An even number of rays, so that colours that take turns close up.
    const double cycles =
        offsets.size() % 2 == 0 ? std::max(1.0, std::round(around)) : std::max(2.0, 2 * std::round(around / 2));
    return {.centre = layout.centre,
            .degrees = degrees_of(offsets, std::min(cycles, double{most_levels}), layout.first_degrees),
            .tolerance = layout.tolerance};
}

Rays spiral_of(const PolarLayout& layout, const std::vector<double>& offsets) {
    std::vector<double> arms = offsets;
    if (arms.size() == 1) arms.push_back(arms[0]);
    double pitch = sum(arms);
    if (layout.fit) pitch = layout.reach.high / std::max(1.0, std::round(layout.reach.high / pitch));
    return {.centre = layout.centre,
            .degrees = degrees_of(arms, 1, layout.first_degrees),
            .curl = 360 / pitch,
            .tolerance = layout.tolerance};
}

ParameterDescription centre_parameter() {
    return {.name = "centre",
            .type = ParameterType::form,
            .help = "the point that curves go around or out from: the middle of each shape, or (x, y)",
            .default_text = "middle",
            .words = {"middle"},
            .aliases = {"center"},
            .takes_points = true};
}

Vec centre_of(const Value& centre, Vec otherwise) {
    const auto* point = std::get_if<Vec>(&centre.data);
    return point == nullptr ? otherwise : *point;
}

Result<DrawnCurves> DrawnCurves::of(const OperatorInput& input, std::string_view form) {
    const auto read = [&](const Value& value) -> Result<std::shared_ptr<const Drawn>> {
        const auto* call = std::get_if<SymbolicCall>(&value.data);
        if (call == nullptr) return std::shared_ptr<const Drawn>();
        const Result<std::shared_ptr<const ShapeOutlines>> outlines = input.forms.outlines(*call);
        if (!outlines) return outlines.diagnostics();
        std::optional<DrawnCurve> curve = drawn_curve((*outlines)->lines);
        if (!curve) return error("tangle.empty-form", "'" + call->name + "' draws no curve to cut along", value.span);
        std::optional<Profile> profile = profile_of(*curve, input.resolution);
        return {std::make_shared<const Drawn>(std::move(*curve), std::move(profile)), outlines.diagnostics()};
    };
    DrawnCurves all;
    Diagnostics warnings;
    const Value* last = nullptr;
    for (std::size_t i = 0; i < input.shapes.size(); ++i) {
        const Value& value = input.arguments.value(form, i);
        if (last == &value) continue;  // the same for all shapes
        Result<std::shared_ptr<const Drawn>> drawn =
            last != nullptr && *last == value ? Result(all.curves_.back()) : read(value);
        last = &value;
        if (!drawn) return drawn.diagnostics();
        all.curves_.push_back(*drawn);
        if (warnings.empty()) warnings = drawn.diagnostics();
    }
    return {std::move(all), std::move(warnings)};
}

Profile zigzag_profile(double amplitude, double wavelength) { return {wavelength / 4, {0, amplitude, 0, -amplitude}}; }

Profile wave_profile(double amplitude, double wavelength, double resolution) {
    // A chord of h px lies h^2 A k^2 / 8 off the crest of A sin(k u).
    const double k = 2 * elementary::pi / wavelength;
    const double chord = std::sqrt(8 * resolution / (amplitude * k * k));
    const double wanted = std::clamp(std::ceil(wavelength / chord / 4) * 4, 12.0, 400.0);
    const auto count = static_cast<std::size_t>(wanted);
    Profile wave{wavelength / wanted, {}};
    for (std::size_t i = 0; i < count; ++i) {
        wave.samples.push_back(amplitude * elementary::cos_sin_degrees(360.0 * static_cast<double>(i) / wanted).sin);
    }
    return wave;
}

}  // namespace filigree::tangle
