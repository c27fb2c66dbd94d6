// regular_split: cut shapes along copies of one curve at equal or cycling distances (gTangle, section 4.2).
//
// Lines, waves, zigzags and drawn curves that are graphs lie in the frame of the shape that is split and go through
// the fast level cut; a dual split cuts the pieces once more by the same family turned by a quarter turn, both laid
// out from the input shape, so that its fields line up. Circles, spirals, rays and drawn curves that double back are
// no graphs: these, and what crosses them in a dual split, are cut in one go.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "base/elementary.h"
#include "derivation/start_shapes.h"
#include "engines/tangle/operators/operators.h"
#include "engines/tangle/orientation.h"
#include "engines/tangle/split_family.h"

namespace filigree::tangle {
namespace {

constexpr std::size_t most_rays = 20'000;  // all meet in one point, where each is looked at with each other

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
LevelRange range_of_box(const Box& box, const Frame& frame, double height) {
    LevelRange range{1e300, -1e300};
    for (const Point corner : {box.min, box.max, Point{box.min.x, box.max.y}, Point{box.max.x, box.min.y}}) {
        const double level = to_frame(frame, to_px(corner)).y;
        range = {std::min(range.low, level), std::max(range.high, level)};
    }
    return {range.low - height, range.high + height};
}

// The greatest distance from a point to a box, and the least.
LevelRange distance_range_of_box(const Box& box, Vec from) {
    const Vec low = to_px(box.min) - from, high = to_px(box.max) - from;
    const auto nearest = [](double a, double b) { return a > 0 ? a : b < 0 ? -b : 0.0; };
    return {length({nearest(low.x, high.x), nearest(low.y, high.y)}),
            length({std::max(-low.x, high.x), std::max(-low.y, high.y)})};
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

// Of one shape: cuts it into the batch by what the arguments say.
class Splitter {
public:
    Splitter(const OperatorInput& input, const DrawnCurves& drawn, const Box& group_box, std::size_t index,
             const Shape& shape, PolygonView polygon, Batch& batch)
        : input_(input),
          drawn_(drawn.at(index)),
          group_box_(group_box),
          index_(index),
          shape_(shape),
          polygon_(polygon),
          batch_(batch),
          anchor_(input.arguments.word("anchor")),
          dual_(input.arguments.flag("dual")),
          fit_(input.arguments.flag("fit")),
          offsets_(input.arguments.lengths("offset", index)),
          direction_(direction_of(input.arguments.value("angle", index), shape, polygon)) {
        if (drawn_ == nullptr) word_ = input.arguments.word("curve", index);
    }

    // False: it makes too many shapes.
    bool run() {
        const double widest = *std::max_element(offsets_.begin(), offsets_.end());
        // Hardly a field is larger than four squares of the widest distance.
        if (dual_ && area(polygon_) / (4 * widest * widest) > static_cast<double>(input_.element_budget)) return false;
        if (word_ == "circ" || word_ == "circle" || word_ == "spiral" || word_ == "rays") return split_about_point();
        const Box box = anchor_ == "group" ? group_box_ : bounds(polygon_);
        const Vec centre = 0.5 * (to_px(box.min) + to_px(box.max));
        frame_ = {anchor_ == "page" ? Vec{0, 0} : centre, direction_};
        if (drawn_ != nullptr && !drawn_->profile) return split_by_copies();
        if (drawn_ != nullptr) profile_ = *drawn_->profile;
        const double amplitude = input_.arguments.number("amplitude", index_);
        const double wavelength = input_.arguments.number("wavelength", index_);
        if (word_ == "wave" && amplitude != 0) profile_ = wave_profile(amplitude, wavelength, input_.resolution);
        if (word_ == "zigzag" && amplitude != 0) profile_ = zigzag_profile(amplitude, wavelength);
        return split_by_levels();
    }

private:
    bool is_over_budget() const { return batch_.ports[0].size() > input_.element_budget; }

    void add(PolygonView piece, std::int32_t column, std::int32_t row, std::uint64_t local, Vec direction) {
        Shape made = piece_of(shape_, input_.step, local, batch_.geometry.size());
        made.direction = direction;
        made.column = column;
        made.row = row;
        batch_.geometry.add(piece);
        batch_.ports[0].push_back(made);
    }

    // Nothing where there are too many.
    bool find_levels(SplitLevels& levels, const Frame& frame, LevelRange own, double height) const {
        const LevelRange whole = anchor_ == "group" ? range_of_box(group_box_, frame, height) : own;
        const bool on_page = anchor_ == "page";
        levels = levels_in({whole, own, on_page, fit_, on_page}, offsets_);
        return !levels.too_many && levels.at.size() <= input_.element_budget;
    }

    bool split_by_levels() {
        double height = 0;
        for (const double sample : profile_.samples) height = std::max(height, std::fabs(sample));
        const auto family_in = [&](LevelFamily& family, const Frame& frame) {
            SplitLevels levels;
            if (!find_levels(levels, frame, level_range(polygon_, frame, profile_), height)) return false;
            family = {frame, profile_, std::move(levels.at), levels.first_strip};
            return true;
        };
        LevelFamily first, second;
        if (!family_in(first, frame_)) return false;
        if (dual_ && !family_in(second, turned(frame_))) return false;
        const LevelCut strips = cut(polygon_, first);
        LocalKeys strip_keys(0);
        for (std::size_t s = 0; s < strips.pieces.size(); ++s) {
            const std::uint64_t key = strip_keys.next(strips.strips[s]);
            if (!dual_) {
                add(strips.pieces[s], strips.strips[s], 0, key, direction_);
                continue;
            }
            const LevelCut fields = cut(strips.pieces[s], second);
            LocalKeys field_keys(key);
            for (std::size_t i = 0; i < fields.pieces.size(); ++i) {
                add(fields.pieces[i], strips.strips[s], fields.strips[i], field_keys.next(fields.strips[i]),
                    direction_);
            }
            if (is_over_budget()) return false;
        }
        return true;
    }

    // Pieces have the direction that `direction_at` gives for them.
    template <class DirectionAt>
    bool split_by_families(const CurveFamily& first, const CurveFamily* second, DirectionAt direction_at) {
        const FamilyCut fields = cut_by_families(polygon_, first, second);
        if (fields.too_large) return false;
        LocalKeys column_keys(0), row_keys(0);
        for (std::size_t i = 0; i < fields.pieces.size(); ++i) {
            const std::int32_t column = fields.columns[i], row = fields.rows[i];
            const bool is_new_column = i == 0 || column != fields.columns[i - 1];
            if (second != nullptr && is_new_column) row_keys = LocalKeys(column_keys.next(column));
            const std::uint64_t key = second == nullptr ? column_keys.next(column) : row_keys.next(row);
            add(fields.pieces[i], column, row, key, direction_at(fields.pieces[i]));
        }
        return true;
    }

    bool split_by_copies() {
        const auto copies_in = [&](Copies& copies, const Frame& frame) {
            copies.curve = drawn_->curve;
            copies.frame = frame;
            // A copy is met where its level lies within its own extent from the shape.
            const LevelRange own = level_range(polygon_, frame, {});
            const LevelRange met{own.low - copies.curve.high, own.high - copies.curve.low};
            SplitLevels levels;
            if (!find_levels(levels, frame, met, std::max(copies.curve.high, -copies.curve.low))) return false;
            copies.levels = std::move(levels.at);
            copies.first_strip = levels.first_strip;
            return true;
        };
        Copies first, second;
        if (!copies_in(first, frame_)) return false;
        if (dual_ && !copies_in(second, turned(frame_))) return false;
        const CurveFamily across = std::move(second);
        return split_by_families(std::move(first), dual_ ? &across : nullptr, [&](PolygonView) { return direction_; });
    }

    bool split_about_point() {
        PolarLayout layout;
        const Vec middle = anchor_ == "page"    ? Vec{0, 0}
                           : anchor_ == "group" ? 0.5 * (to_px(group_box_.min) + to_px(group_box_.max))
                                                : centroid(polygon_);
        layout.centre = centre_of(input_.arguments.value("centre", index_), middle);
        layout.visible = distance_range(polygon_, layout.centre);
        layout.reach = anchor_ == "group" ? distance_range_of_box(group_box_, layout.centre) : layout.visible;
        layout.first_degrees = elementary::atan2(direction_.y, direction_.x) * 180 / elementary::pi;
        layout.fit = fit_;
        layout.keeps_slivers = anchor_ != "shape";
        layout.tolerance = input_.resolution;
        const std::vector<double> mean{std::accumulate(offsets_.begin(), offsets_.end(), 0.0) /
                                       static_cast<double>(offsets_.size())};
        const bool are_rays = word_ == "rays";
        CurveFamily first, second;
        if (are_rays) {
            Rays rays = rays_of(layout, offsets_, (layout.reach.low + layout.reach.high) / 2);
            if (rays.degrees.size() > std::min(most_curves(), most_rays)) return false;
            first = std::move(rays);
        }
        if (word_ == "spiral") {
            if (layout.visible.high - layout.visible.low > mean[0] * static_cast<double>(most_curves())) return false;
            first = spiral_of(layout, offsets_);
        }
        if (!are_rays || dual_) {
            SplitLevels levels = ring_levels(layout, offsets_);
            if (levels.too_many || levels.at.size() > most_curves()) return false;
            if (are_rays)
                second = rings_of(layout, std::move(levels));
            else if (word_ != "spiral")
                first = rings_of(layout, std::move(levels));
        }
        if (!are_rays && dual_) {
            Rays rays = rays_of(layout, mean, layout.reach.high);
            if (rays.degrees.size() > std::min(most_curves(), most_rays)) return false;
            second = std::move(rays);
        }
        return split_by_families(first, dual_ ? &second : nullptr, [&](PolygonView piece) {
            // Along the curves where the piece lies, if it does not go around the centre.
            const Vec out = centroid(piece) - layout.centre;
            const double distance = length(out);
            const bool goes_around = is_on_plane(layout.centre) && locate(piece.outer(), snap(layout.centre)) >= 0;
            if (goes_around || distance == 0) return direction_;
            return (are_rays ? out : perpendicular(out)) * (1 / distance);
        });
    }

    // Each cuts off at least a piece, give or take the rays that miss the shape.
    std::size_t most_curves() const {
        return static_cast<std::size_t>(std::min<std::uint64_t>(input_.element_budget, std::uint64_t{1} << 20));
    }

    const OperatorInput& input_;
    const DrawnCurves::Drawn* drawn_ = nullptr;
    const Box& group_box_;
    std::size_t index_ = 0;
    const Shape& shape_;
    PolygonView polygon_;
    Batch& batch_;
    std::string_view word_;  // of the curve; empty for a drawn one
    std::string_view anchor_;
    bool dual_ = false, fit_ = false;
    std::vector<double> offsets_;
    Vec direction_;
    Frame frame_;
    Profile profile_;
};

Result<OperatorOutput> run(const OperatorInput& input) {
    const Result<DrawnCurves> drawn = DrawnCurves::of(input, "curve");
    if (!drawn) return drawn.diagnostics();
    const Box group_box = input.arguments.word("anchor") == "group" ? bounds_of_all(input) : Box{};
    std::atomic<bool> too_many = false;
    Result<OperatorOutput> output =
        for_each_shape(input, [&](std::size_t index, const Shape& shape, PolygonView polygon, Batch& batch) {
            if (too_many.load(std::memory_order_relaxed)) return;
            if (!Splitter(input, *drawn, group_box, index, shape, polygon, batch).run()) too_many = true;
        });
    if (too_many) return too_many_shapes(input);
    if (!output) return output;
    return {std::move(*output), drawn.diagnostics()};
}

}  // namespace

Operator regular_split_operator() {
    return {{.name = "regular_split",
             .aliases = {"regularSplit"},
             .help = "cut along copies of a curve at regular distances, once or crosswise",
             .source = "gTangle, section 4.2",
             .parameters =
                 {{.name = "curve",
                   .type = ParameterType::form,
                   .help = "what the cuts look like: straight, waving, rings around the centre, a spiral, rays, or "
                           "copies of a drawn curve",
                   .default_text = "line",
                   .words = {"line", "wave", "zigzag", "circ", "circle", "spiral", "rays"},
                   .forms = &curve_forms()},
                  {.name = "offset",
                   .type = ParameterType::lengths,
                   .help = "distance from cut to cut (of rays, halfway out); a list is used in turn",
                   .low = 0.01,
                   .high = 1e6,
                   .aliases = {"offsets"}},
                  {.name = "dual",
                   .type = ParameterType::flag,
                   .help = "cut once more at right angles, into fields",
                   .default_text = "false"},
                  {.name = "angle",
                   .type = ParameterType::direction,
                   .help = "direction of the cuts (of the first ray), in degrees from x towards y, or relative to the "
                           "shape's own",
                   .default_text = "0..180",
                   .words = {"keep", "across", "axis"},
                   .calls = {"turn", "towards"}},
                  {.name = "fit",
                   .type = ParameterType::flag,
                   .help = "stretch the distance so that a whole number of strips fills the shape",
                   .default_text = "false"},
                  {.name = "anchor",
                   .type = ParameterType::word,
                   .help = "where the cuts are laid out from: each shape, the whole group, or the origin of the page",
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
                   .high = 1e6},
                  centre_parameter()},
             .ports = {{"pieces", "the strips, or the fields of a dual split"}},
             .example = "regular_split(wave, 12, angle: across) : leaf -> strips"},
            run};
}

}  // namespace filigree::tangle
