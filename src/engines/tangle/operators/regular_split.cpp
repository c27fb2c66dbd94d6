// regular_split: cut shapes along copies of one curve at equal or cycling distances (gTangle, section 4.2).
//
// The family lies in the frame of the shape that is split; a dual split cuts the pieces once more by the same
// family turned by a quarter turn, both laid out from the input shape, so that its fields line up.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "base/elementary.h"
#include "engines/tangle/operators/operators.h"
#include "engines/tangle/orientation.h"
#include "plane/level_cut.h"

namespace filigree::tangle {
namespace {

constexpr double sliver = 0.25;  // of the distance: thinner end strips join their neighbour
constexpr std::size_t most_levels = 1'000'000;

// The curve as samples over one wavelength, close enough to the resolution; nothing for a straight line.
Profile profile_of(std::string_view curve, double amplitude, double wavelength, double resolution) {
    if (curve == "line" || amplitude == 0) return {};
    if (curve == "zigzag") return {wavelength / 4, {0, amplitude, 0, -amplitude}};
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

struct Levels {
    std::vector<double> at;        // px
    std::int32_t first_strip = 0;  // index of the strip below the first
    bool too_many = false;
};

// Where the family is laid out, and the part of it that a shape can meet.
struct Layout {
    LevelRange whole;        // the cuts are centred in it, or fitted to it
    LevelRange visible;      // only cuts inside it are made
    bool at_origin = false;  // not centred: one cut lies at level 0
    bool fit = false;
};

// Cuts by `offsets` in turn. Kept exactly they lie around the middle, so that both end strips come out equal;
// fitted they are stretched so that a whole number of strips fills the range.
Levels levels_in(const Layout& layout, const std::vector<double>& offsets) {
    const double period = std::accumulate(offsets.begin(), offsets.end(), 0.0);
    const double extent = layout.whole.high - layout.whole.low;
    const auto size = static_cast<std::int64_t>(offsets.size());
    double stretch = 1;
    double anchor = layout.at_origin ? 0 : (layout.whole.low + layout.whole.high) / 2;
    if (layout.fit && !layout.at_origin) {
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
    const double thin = layout.at_origin ? 0 : sliver * stretch * *std::min_element(offsets.begin(), offsets.end());
    const double low = std::max(layout.visible.low, layout.whole.low + thin);
    const double high = std::min(layout.visible.high, layout.whole.high - thin);
    Levels levels;
    auto n = static_cast<std::int64_t>(std::floor((low - anchor) / (stretch * period))) * size;
    while (position(n) <= low) ++n;
    levels.first_strip = static_cast<std::int32_t>(n - 1);
    for (; position(n) < high; ++n) levels.at.push_back(position(n));
    return levels;
}

// Local keys of the pieces of one cut, which come by strip: the strip's number and which piece of it, so that
// one strip more at either end renames nothing.
class LocalKeys {
public:
    explicit LocalKeys(std::uint64_t within) : within_(within) {}

    std::uint64_t next(std::int32_t strip) {
        piece_ = strip == last_ ? piece_ + 1 : 0;
        last_ = strip;
        return fold(fold(within_, static_cast<std::uint32_t>(strip)), piece_);
    }

private:
    std::uint64_t within_ = 0, piece_ = 0;
    std::int32_t last_ = INT32_MIN;
};

// The extent across a frame of everything inside a box, give or take the curve's own height.
LevelRange range_of_box(const Box& box, const Frame& frame, const Profile& profile) {
    LevelRange range{1e300, -1e300};
    for (const Point corner : {box.min, box.max, Point{box.min.x, box.max.y}, Point{box.max.x, box.min.y}}) {
        const double level = to_frame(frame, to_px(corner)).y;
        range = {std::min(range.low, level), std::max(range.high, level)};
    }
    double height = 0;
    for (const double sample : profile.samples) height = std::max(height, std::fabs(sample));
    return {range.low - height, range.high + height};
}

Box bounds_of_all(const OperatorInput& input) {
    Box all;
    for (const Shape& shape : input.shapes) {
        const Box one = bounds(input.tangle.polygon(shape));
        extend(all, one.min);
        extend(all, one.max);
    }
    return all;
}

Result<OperatorOutput> run(const OperatorInput& input) {
    const Arguments& arguments = input.arguments;
    const std::string_view anchor = arguments.word("anchor");
    const bool dual = arguments.flag("dual"), fit = arguments.flag("fit");
    const Box group_box = anchor == "group" ? bounds_of_all(input) : Box{};
    std::atomic<bool> too_many = false;
    Result<OperatorOutput> output =
        for_each_shape(input, [&](std::size_t index, const Shape& shape, PolygonView polygon, Batch& batch) {
            if (too_many.load(std::memory_order_relaxed)) return;
            const std::vector<double> offsets = arguments.lengths("offset", index);
            const Profile profile = profile_of(arguments.word("curve", index), arguments.number("amplitude", index),
                                               arguments.number("wavelength", index), input.resolution);
            const Vec direction = direction_of(arguments.value("angle", index), shape, polygon);
            const Box box = anchor == "group" ? group_box : bounds(polygon);
            const Vec centre = 0.5 * (to_px(box.min) + to_px(box.max));
            const Frame frame{anchor == "page" ? Vec{0, 0} : centre, direction};
            const auto family_in = [&](const Frame& at) {
                const LevelRange own = level_range(polygon, at, profile);
                const LevelRange whole = anchor == "group" ? range_of_box(group_box, at, profile) : own;
                Levels levels = levels_in({whole, own, anchor == "page", fit}, offsets);
                if (levels.too_many || levels.at.size() > input.element_budget) too_many = true;
                return LevelFamily{at, profile, std::move(levels.at), levels.first_strip};
            };
            const LevelFamily first = family_in(frame);
            if (too_many) return;
            const auto add = [&](const Polygons& pieces, std::size_t i, std::int32_t column, std::int32_t row,
                                 std::uint64_t local) {
                Shape piece = piece_of(shape, input.step, local, batch.geometry.size());
                piece.direction = direction;
                piece.column = column;
                piece.row = row;
                batch.geometry.add(pieces[i]);
                batch.ports[0].push_back(piece);
            };
            const LevelCut strips = cut(polygon, first);
            LocalKeys strip_keys(0);
            if (!dual) {
                for (std::size_t i = 0; i < strips.pieces.size(); ++i) {
                    add(strips.pieces, i, strips.strips[i], 0, strip_keys.next(strips.strips[i]));
                }
                return;
            }
            const LevelFamily second = family_in(turned(frame));
            if (too_many) return;
            for (std::size_t s = 0; s < strips.pieces.size(); ++s) {
                const LevelCut fields = cut(strips.pieces[s], second);
                LocalKeys field_keys(strip_keys.next(strips.strips[s]));
                for (std::size_t i = 0; i < fields.pieces.size(); ++i) {
                    add(fields.pieces, i, strips.strips[s], fields.strips[i], field_keys.next(fields.strips[i]));
                }
            }
        });
    if (too_many) return too_many_shapes(input);
    return output;
}

}  // namespace

Operator regular_split_operator() {
    return {
        {.name = "regular_split",
         .aliases = {"regularSplit"},
         .help = "cut along copies of a curve at regular distances, once or crosswise",
         .source = "gTangle, section 4.2",
         .parameters = {{.name = "curve",
                         .type = ParameterType::word,
                         .help = "what the cuts look like",
                         .default_text = "line",
                         .words = {"line", "wave", "zigzag"}},
                        {.name = "offset",
                         .type = ParameterType::lengths,
                         .help = "distance from cut to cut; a list is used in turn",
                         .low = 0.01,
                         .high = 1e6,
                         .aliases = {"offsets"}},
                        {.name = "dual",
                         .type = ParameterType::flag,
                         .help = "cut once more at right angles, into fields",
                         .default_text = "false"},
                        {.name = "angle",
                         .type = ParameterType::direction,
                         .help = "direction of the cuts, in degrees from x towards y, or relative to the shape's own",
                         .default_text = "0..180",
                         .words = {"keep", "across", "axis"},
                         .calls = {"turn", "towards"}},
                        {.name = "fit",
                         .type = ParameterType::flag,
                         .help = "stretch the distance so that a whole number of strips fills the shape",
                         .default_text = "false"},
                        {.name = "anchor",
                         .type = ParameterType::word,
                         .help =
                             "where the cuts are laid out from: each shape, the whole group, or the origin of the page",
                         .default_text = "shape",
                         .words = {"shape", "group", "page"}},
                        {.name = "amplitude",
                         .type = ParameterType::length,
                         .help = "height of a wave or zigzag above its middle",
                         .default_text = "4px",
                         .low = 0,
                         .high = 1e6},
                        {.name = "wavelength",
                         .type = ParameterType::length,
                         .help = "length of one wave or tooth",
                         .default_text = "40px",
                         .low = 0.1,
                         .high = 1e6}},
         .ports = {{"pieces", "the strips, or the fields of a dual split"}},
         .example = "regular_split(wave, 12, angle: across) : leaf -> strips"},
        run};
}

}  // namespace filigree::tangle
