#include "scene/curves.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "plane/clean.h"

namespace filigree {
namespace {

struct Subpath {
    Path path;                // begins with a move
    std::vector<Point> ring;  // no point follows its equal, and the last of a closed one is not its first
    bool is_closed = false;
    bool is_curve = false;  // whether its path can be drawn; else its ring alone
};

std::vector<Point> snapped(const Polyline& line) {
    std::vector<Point> points;
    for (const Vec p : line.points) {
        if (!is_on_plane(p)) return {};
        const Point place = snap(p);
        if (points.empty() || points.back() != place) points.push_back(place);
    }
    while (line.closed && points.size() > 1 && points.back() == points.front()) points.pop_back();
    return points;
}

// Those that are something on the grid.
std::vector<Subpath> subpaths_of(const Path& path, double tolerance) {
    std::vector<Subpath> all;
    Subpath next;
    const auto end = [&] {
        const std::vector<Polyline> lines = flatten(next.path, tolerance);
        if (lines.empty()) return;
        next.ring = snapped(lines[0]);
        next.is_closed = lines[0].closed;
        next.is_curve = is_on_plane(next.path);
        if (next.ring.size() >= 2) all.push_back(std::move(next));
    };
    Vec start;
    std::size_t at = 0;
    for (const Verb verb : path.verbs) {
        const std::size_t count = point_count(verb);
        if (path.points.size() - at < count) break;
        const Vec* points = path.points.data() + at;
        at += count;
        if (verb == Verb::move) {
            end();
            next = {};
            start = points[0];
        }
        if (verb != Verb::move && next.path.verbs.empty()) next.path = {{Verb::move}, {start}};
        next.path.verbs.push_back(verb);
        next.path.points.insert(next.path.points.end(), points, points + count);
        if (verb == Verb::close) {
            end();
            next = {};
        }
    }
    end();
    return all;
}

// What tells an outline from all others that do not cross it: its highest point and what it encloses.
struct Outline {
    Point top;
    Int128 doubled_area = 0;
    std::size_t index = 0;

    bool is_same(const Outline& other) const { return top == other.top && doubled_area == other.doubled_area; }
};
Outline outline_of(RingView ring, std::size_t index) {
    const Point top = *std::min_element(ring.begin(), ring.end(),
                                        [](Point a, Point b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
    const Int128 area = doubled_area(ring);
    return {top, area < 0 ? -area : area, index};
}
void sort(std::vector<Outline>& outlines) {
    std::sort(outlines.begin(), outlines.end(), [](const Outline& a, const Outline& b) {
        return std::tie(a.top, a.doubled_area, a.index) < std::tie(b.top, b.doubled_area, b.index);
    });
}

class CurveAdder {
public:
    CurveAdder(Drawing& drawing, const Style& style, Key key) : drawing_(drawing), style_(style), key_(key) {}

    void add(const std::vector<Subpath>& subpaths) {
        std::vector<const Subpath*> filled, lines;
        for (const Subpath& subpath : subpaths) {
            const bool encloses = subpath.is_closed && subpath.ring.size() > 2;
            (has_fill(style_) && encloses ? filled : lines).push_back(&subpath);
        }
        if (!filled.empty() && !add_whole(filled)) {
            // Their strokes come over what they enclose.
            Style bare = style_;
            bare.stroke.reset();
            for (std::uint32_t p = 0; p < polygons_.size(); ++p) add_shape(p, bare, {});
            lines.insert(lines.begin(), filled.begin(), filled.end());
        }
        if (has_stroke(style_)) {
            for (const Subpath* line : lines) add_line(*line);
        }
        if (!polygons_.empty()) drawing_.geometry.push_back(std::make_shared<const Polygons>(std::move(polygons_)));
    }

private:
    // What the subpaths enclose, where they bound it whole. Else their polygons are there, but no shapes.
    bool add_whole(const std::vector<const Subpath*>& filled) {
        std::vector<std::vector<Point>> rings;
        std::vector<Outline> wanted;
        for (const Subpath* subpath : filled) {
            wanted.push_back(outline_of(subpath->ring, rings.size()));
            rings.push_back(subpath->ring);
        }
        polygons_ = clean(rings, FillRule::even_odd);
        std::vector<Outline> found;
        std::vector<std::uint32_t> polygon_of_ring;
        for (std::uint32_t p = 0; p < polygons_.size(); ++p) {
            const PolygonView polygon = polygons_[p];
            for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
                found.push_back(outline_of(polygon.ring(r), polygon_of_ring.size()));
                polygon_of_ring.push_back(p);
            }
        }
        sort(wanted);
        sort(found);
        if (!std::equal(wanted.begin(), wanted.end(), found.begin(), found.end(),
                        [](const Outline& a, const Outline& b) { return a.is_same(b); })) {
            return false;
        }
        std::vector<std::uint32_t> polygon_of_subpath(filled.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            polygon_of_subpath[wanted[i].index] = polygon_of_ring[found[i].index];
        }
        std::vector<std::vector<const Subpath*>> borders(polygons_.size());
        for (std::size_t i = 0; i < filled.size(); ++i) borders[polygon_of_subpath[i]].push_back(filled[i]);
        for (std::uint32_t p = 0; p < borders.size(); ++p) add_shape(p, style_, borders[p]);
        return true;
    }

    void add_line(const Subpath& line) {
        polygons_.points.insert(polygons_.points.end(), line.ring.begin(), line.ring.end());
        if (line.is_closed) polygons_.points.push_back(line.ring.front());
        polygons_.end_ring();
        polygons_.end_polygon();
        Style style = style_;
        style.is_open = true;
        add_shape(static_cast<std::uint32_t>(polygons_.size() - 1), style, {&line});
    }

    void add_shape(std::uint32_t polygon, const Style& style, const std::vector<const Subpath*>& parts) {
        DrawnShape shape{static_cast<std::uint32_t>(drawing_.geometry.size()), polygon, index_of(style), key_};
        const bool is_curve = !parts.empty() && std::all_of(parts.begin(), parts.end(),
                                                            [](const Subpath* part) { return part->is_curve; });
        if (is_curve) {
            shape.curve = static_cast<std::uint32_t>(drawing_.curves.size());
            Path& curve = drawing_.curves.emplace_back();
            for (const Subpath* part : parts) {
                curve.verbs.insert(curve.verbs.end(), part->path.verbs.begin(), part->path.verbs.end());
                curve.points.insert(curve.points.end(), part->path.points.begin(), part->path.points.end());
            }
        }
        drawing_.shapes.push_back(shape);
    }

    // Who draws many curves draws most of them in the last style.
    std::uint32_t index_of(const Style& style) {
        const auto last = std::find(drawing_.styles.rbegin(), drawing_.styles.rend(), style);
        if (last != drawing_.styles.rend()) {
            return static_cast<std::uint32_t>(drawing_.styles.rend() - last) - 1;
        }
        drawing_.styles.push_back(style);
        return static_cast<std::uint32_t>(drawing_.styles.size()) - 1;
    }

    Drawing& drawing_;
    const Style& style_;
    const Key key_;
    Polygons polygons_;  // of what is added
};

}  // namespace

bool is_on_plane(const Path& path) {
    return std::all_of(path.points.begin(), path.points.end(), [](Vec p) { return is_on_plane(p); });
}

void add_curve(Drawing& drawing, const Path& path, const Style& style, Key key, double tolerance) {
    CurveAdder(drawing, style, key).add(subpaths_of(path, tolerance));
}

}  // namespace filigree
