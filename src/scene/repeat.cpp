#include "scene/repeat.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "scene/arrange.h"
#include "scene/curves.h"

namespace filigree {
namespace {

constexpr std::uint32_t unused = UINT32_MAX;
constexpr double mitre_reach = 4;  // half pens from a corner to its tip, at most: SVG's own limit

// How far pens reach beyond the shapes, grid units.
std::int64_t pen_reach(const Drawing& drawing) {
    double reach = 0;
    for (const Style& style : drawing.styles) {
        if (!style.stroke || !(style.pen > 0)) continue;
        reach = std::max(reach, style.pen / 2 * (style.corner == Corner::mitre ? mitre_reach : 1));
    }
    return std::llround(std::min(reach, 0x1p30) * grid_per_px);
}

Box canvas_box(const Canvas& canvas, std::int64_t margin) {
    if (!is_on_plane(canvas.origin) || !is_on_plane(canvas.origin + canvas.size)) return {};
    const Point low = snap(canvas.origin), high = snap(canvas.origin + canvas.size);
    return {{low.x - margin, low.y - margin}, {high.x + margin, high.y + margin}};
}

Box moved(const Box& box, Point by) {
    return {{box.min.x + by.x, box.min.y + by.y}, {box.max.x + by.x, box.max.y + by.y}};
}
bool is_within(const Box& box, const Box& around) {
    return around.min.x < box.min.x && around.min.y < box.min.y && box.max.x < around.max.x && box.max.y < around.max.y;
}
// More than touching.
bool meets(const Box& a, const Box& b) {
    return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

// Whole tiles by which a box can be moved so that it meets another one: from first to last.
struct Steps {
    std::int64_t first = 0, last = 0;
    std::int64_t count() const { return std::max<std::int64_t>(0, last - first + 1); }
};
std::int64_t floor_of(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }
Steps steps_to_meet(std::int64_t low, std::int64_t high, std::int64_t to_low, std::int64_t to_high, std::int64_t step) {
    if (step == 0) return {0, low < to_high && to_low < high ? 0 : -1};
    return {floor_of(to_low - high, step) + 1, -floor_of(low - to_high, step) - 1};
}

// What is folded into the keys of a copy's shapes.
Key key_below(const Copy& copy) {
    const Key of_operation = child(Key{hash_text("copy")}, copy.operation);
    return child(child(of_operation, static_cast<std::uint64_t>(copy.column)), static_cast<std::uint64_t>(copy.row));
}

// The motif with all polygons that it shows in one place.
struct Gathered {
    Drawing drawing;  // without geometry: its shapes are those of the motif
    Polygons polygons;
    std::vector<bool> is_line;  // of each
};
Gathered gather(const Drawing& motif) {
    Gathered all{motif, {}, {}};
    all.drawing.geometry.assign(1, nullptr);
    std::vector<std::vector<std::uint32_t>> places(motif.geometry.size());
    for (DrawnShape& shape : all.drawing.shapes) {
        std::vector<std::uint32_t>& place = places[shape.geometry];
        const Polygons& from = *motif.geometry[shape.geometry];
        place.resize(from.size(), unused);
        if (place[shape.polygon] == unused) {
            place[shape.polygon] = static_cast<std::uint32_t>(all.polygons.size());
            all.polygons.add(from[shape.polygon]);
            all.is_line.push_back(motif.styles[shape.style].is_open);
        }
        shape.polygon = place[shape.polygon];
        shape.geometry = 0;
    }
    return all;
}

// The polygons that are seen, moved; the others without rings.
Polygons shown(const Polygons& images, const std::vector<Box>& boxes, const Box& seen, Point by, bool all_are) {
    Polygons copy;
    if (all_are) {
        copy = images;
        for (Point& p : copy.points) p = {p.x + by.x, p.y + by.y};
        return copy;
    }
    copy.polygon_ends.reserve(images.size());
    for (std::size_t i = 0; i < images.size(); ++i) {
        if (is_empty(boxes[i]) || !meets(moved(boxes[i], by), seen)) {
            copy.end_polygon();
            continue;
        }
        const PolygonView image = images[i];
        for (std::size_t r = 0; r < image.ring_count(); ++r) {
            for (const Point p : image.ring(r)) copy.points.push_back({p.x + by.x, p.y + by.y});
            copy.end_ring();
        }
        copy.end_polygon();
    }
    return copy;
}

class Repeater {
public:
    Repeater(const Drawing& motif, const Symmetry& symmetry, const RepeatOptions& options)
        : motif_(motif),
          symmetry_(symmetry),
          options_(options),
          seen_(canvas_box(options.canvas, pen_reach(motif))),
          gathered_(gather(motif)),
          copy_(gathered_.drawing),
          placer_(result_) {}

    Result<Drawing> run() {
        result_.canvas = options_.canvas;
        result_.groups.emplace_back();
        if (is_empty(seen_)) return std::move(result_);
        const SymmetryImages images(symmetry_, gathered_.polygons, gathered_.is_line);
        for (std::uint32_t k = 0; k < symmetry_.operation_count() && !problem_; ++k) place_all(images.under(k), k);
        if (problem_) return *problem_;
        return std::move(result_);
    }

private:
    void place_all(const Polygons& images, std::uint32_t operation) {
        std::vector<Box> boxes;
        boxes.reserve(images.size());
        for (std::size_t i = 0; i < images.size(); ++i) boxes.push_back(bounds(images[i]));
        Box whole;
        for (const Box& box : boxes) {
            if (is_empty(box)) continue;
            extend(whole, box.min);
            extend(whole, box.max);
        }
        if (is_empty(whole)) return;
        const Point tile = symmetry_.tile();
        const Steps rows = steps_to_meet(whole.min.y, whole.max.y, seen_.min.y, seen_.max.y, tile.y);
        const Steps columns = steps_to_meet(whole.min.x, whole.max.x, seen_.min.x, seen_.max.x, tile.x);
        copies_ += static_cast<double>(rows.count()) * static_cast<double>(columns.count());
        if (copies_ > static_cast<double>(options_.most_copies))
            return refuse("limit.copies", "copies", options_.most_copies);
        for (std::int64_t row = rows.first; row <= rows.last; ++row) {
            for (std::int64_t column = columns.first; column <= columns.last && !problem_; ++column) {
                const Point by{column * tile.x, row * tile.y};
                const bool all_are = is_within(moved(whole, by), seen_);
                place({operation, column, row}, shown(images, boxes, seen_, by, all_are), all_are);
            }
        }
    }

    void place(const Copy& copy, Polygons polygons, bool is_whole) {
        if (is_cancelled(options_.job)) problem_ = cancelled_diagnostic();
        if (problem_ || polygons.points.empty()) return;
        Placement placement;
        placement.clip = options_.clip;
        placement.path_prefix = path_of_copy(symmetry_, copy);
        if (copy == Copy{} && is_whole) {
            placer_.place(motif_, placement);  // shares the motif's geometry
        } else {
            copy_.geometry[0] = std::make_shared<const Polygons>(std::move(polygons));
            if (!motif_.curves.empty()) move_curves(symmetry_.transform(copy));
            const Key here = key_below(copy);
            for (std::size_t s = 0; s < copy_.shapes.size(); ++s) {
                copy_.shapes[s].key = child(motif_.shapes[s].key, here.value);
            }
            placer_.place(copy_, placement);
        }
        if (result_.shapes.size() > options_.most_shapes) refuse("limit.elements", "shapes", options_.most_shapes);
    }

    // Those of shapes that are seen.
    void move_curves(const Transform& to_copy) {
        copy_.curves.assign(motif_.curves.size(), {});
        for (std::size_t s = 0; s < copy_.shapes.size(); ++s) {
            const std::uint32_t curve = motif_.shapes[s].curve;
            copy_.shapes[s].curve = DrawnShape::no_curve;
            const bool is_seen = (*copy_.geometry[0])[copy_.shapes[s].polygon].ring_count() > 0;
            if (curve == DrawnShape::no_curve || !is_seen) continue;
            Path& moved = copy_.curves[curve];
            if (moved.verbs.empty()) moved = transformed(motif_.curves[curve], to_copy);
            if (is_on_plane(moved)) copy_.shapes[s].curve = curve;
        }
    }

    void refuse(std::string code, const std::string& what, std::uint64_t most) {
        problem_ = fault(Fault::limit, std::move(code),
                         "the repeated drawing has more than " + to_text(most) + " " + what + " on the page");
        problem_->hints.push_back("a larger tile or a smaller page holds fewer");
    }

    const Drawing& motif_;
    const Symmetry& symmetry_;
    const RepeatOptions& options_;
    const Box seen_;
    const Gathered gathered_;
    Drawing copy_;  // the one that is placed next
    Drawing result_;
    DrawingPlacer placer_;
    double copies_ = 0;
    std::optional<Diagnostic> problem_;
};

}  // namespace

Key key_of_copy(Key shape, const Copy& copy) { return copy == Copy{} ? shape : child(shape, key_below(copy).value); }

std::string path_of_copy(const Symmetry& symmetry, const Copy& copy) {
    std::string path = symmetry.group().name + "/" + to_text(std::uint64_t{copy.operation});
    if (copy.column == 0 && copy.row == 0) return path;
    return path + "/" + to_text(static_cast<double>(copy.column)) + "," + to_text(static_cast<double>(copy.row));
}

Box bounds_of_copies(const Symmetry& symmetry, const Polygons& motif) {
    const SymmetryImages images(symmetry, motif);
    Box box;
    for (std::uint32_t k = 0; k < symmetry.operation_count(); ++k) {
        const Box one = bounds(images.under(k));
        if (is_empty(one)) continue;
        extend(box, one.min);
        extend(box, one.max);
    }
    return box;
}

Result<Drawing> repeated(const Drawing& motif, const Symmetry& symmetry, const RepeatOptions& options) {
    return Repeater(motif, symmetry, options).run();
}

}  // namespace filigree
