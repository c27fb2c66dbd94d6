#include "formats/png_write.h"

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "formats/png_encode.h"
#include "plane/cubics.h"

namespace filigree {
namespace {

constexpr double most_pixels_a_side = 32'000;
constexpr double most_pixels = 400e6;
// Cairo counts in 24.8 bit fixed point and does not notice where that is left; outlines are cut before.
constexpr double farthest = 1 << 20;
constexpr double mitre_limit = 4;  // SVG's own

struct CairoDeleter {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, CairoDeleter>;
using CairoContext = std::unique_ptr<cairo_t, CairoDeleter>;

Diagnostic cairo_fault(cairo_status_t status) {
    const bool is_memory = status == CAIRO_STATUS_NO_MEMORY || status == CAIRO_STATUS_INVALID_SIZE;
    return fault(is_memory ? Fault::limit : Fault::internal, "png.not-drawn",
                 std::string("the picture could not be drawn: ") + cairo_status_to_string(status));
}

void set_source(cairo_t* cairo, Colour colour) {
    cairo_set_source_rgba(cairo, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0, colour.alpha / 255.0);
}

struct Rectangle {  // pixels
    Vec min, max;
};

// The part of a ring on one side of a line parallel to an axis (Sutherland and Hodgman).
std::vector<Vec> cut(const std::vector<Vec>& ring, double Vec::*axis, double at, bool keep_above) {
    std::vector<Vec> kept;
    const auto is_kept = [&](Vec p) { return keep_above ? p.*axis >= at : p.*axis <= at; };
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec from = ring[i], to = ring[(i + 1) % ring.size()];
        if (is_kept(from)) kept.push_back(from);
        if (is_kept(from) == is_kept(to)) continue;
        Vec crossing = from + (to - from) * ((at - from.*axis) / (to.*axis - from.*axis));
        crossing.*axis = at;
        kept.push_back(crossing);
    }
    return kept;
}

// The part of a stretch inside a rectangle, none where it passes by (Liang and Barsky).
std::optional<std::pair<Vec, Vec>> cut(Vec from, Vec to, const Rectangle& within) {
    double first = 0, last = 1;
    for (double Vec::*axis : {&Vec::x, &Vec::y}) {
        const double along = to.*axis - from.*axis;
        if (along == 0) {
            if (from.*axis < within.min.*axis || from.*axis > within.max.*axis) return std::nullopt;
            continue;
        }
        const double enter = ((along > 0 ? within.min : within.max).*axis - from.*axis) / along;
        const double leave = ((along > 0 ? within.max : within.min).*axis - from.*axis) / along;
        first = std::max(first, enter);
        last = std::min(last, leave);
    }
    if (first > last) return std::nullopt;
    const auto at = [&](double share) { return share == 1 ? to : from + share * (to - from); };
    return std::pair{at(first), at(last)};
}

class Painter {
public:
    Painter(cairo_t* cairo, const Drawing& drawing, double scale, Vec size)
        : cairo_(cairo), drawing_(drawing), scale_(scale), size_(size) {
        cairo_set_fill_rule(cairo_, CAIRO_FILL_RULE_EVEN_ODD);
        cairo_set_miter_limit(cairo_, mitre_limit);
    }

    // As far as the job goes on.
    void paint(const Job& job) {
        std::uint32_t painted = 0;
        for (const PaintStep& step : painting_steps(drawing_)) {
            for (std::uint32_t s = step.first; s < step.end; ++s) {
                if ((++painted & 0xFF) == 0 && is_cancelled(job)) return;
                paint(drawing_.shapes[s]);
            }
        }
    }

private:
    void paint(const DrawnShape& shape) {
        const Style& style = drawing_.styles[shape.style];
        const bool is_filled = has_fill(style), is_stroked = has_stroke(style);
        const double pen = is_stroked ? std::min(style.pen * scale_, farthest) : 0;
        const PolygonView polygon = polygon_of(drawing_, shape);
        if (polygon.ring_count() == 0 || (!is_filled && !is_stroked)) return;

        const Box box = bounds(polygon);
        const Vec min = to_pixels(box.min), max = to_pixels(box.max);
        const double margin = pen * mitre_limit / 2 + 2;
        if (max.x < -margin || max.y < -margin || min.x > size_.x + margin || min.y > size_.y + margin) return;
        const bool is_near = std::min(min.x, min.y) >= -farthest && std::max(max.x, max.y) <= farthest;

        cairo_new_path(cairo_);
        const bool is_curve = is_near && add_near_curve(shape);
        for (std::size_t r = 0; r < polygon.ring_count() && !is_curve; ++r) {
            if (is_near) {
                begin_ring();
                for (const Point p : polygon.ring(r)) line_to(to_pixels(p));
                if (!style.is_open) cairo_close_path(cairo_);
            } else if (style.is_open) {
                add_cut_line(polygon.ring(r), {{-margin, -margin}, {size_.x + margin, size_.y + margin}});
            } else {
                add_cut_ring(polygon.ring(r), {{-margin, -margin}, {size_.x + margin, size_.y + margin}});
            }
        }
        if (is_filled) {
            set_source(cairo_, *style.fill);
            if (is_stroked) {
                cairo_fill_preserve(cairo_);
            } else {
                cairo_fill(cairo_);
            }
        }
        if (is_stroked) stroke(style, pen);
    }

    void stroke(const Style& style, double pen) {
        set_source(cairo_, *style.stroke);
        cairo_set_line_width(cairo_, pen);
        cairo_set_line_join(cairo_, style.corner == Corner::mitre   ? CAIRO_LINE_JOIN_MITER
                                    : style.corner == Corner::round ? CAIRO_LINE_JOIN_ROUND
                                                                    : CAIRO_LINE_JOIN_BEVEL);
        const bool is_rounded = style.is_open && style.corner == Corner::round;
        cairo_set_line_cap(cairo_, is_rounded ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
        cairo_stroke(cairo_);
    }

    // Where its control points are near, too.
    bool add_near_curve(const DrawnShape& shape) {
        if (!has_curve(shape)) return false;
        Path cubics = in_cubics(drawing_.curves[shape.curve]);
        for (Vec& p : cubics.points) {
            p = to_pixels(p);
            if (std::max(std::fabs(p.x), std::fabs(p.y)) > farthest) return false;
        }
        const Vec* p = cubics.points.data();
        for (const Verb verb : cubics.verbs) {
            if (verb == Verb::move) cairo_move_to(cairo_, p[0].x, p[0].y);
            if (verb == Verb::line) line_to(p[0]);
            if (verb == Verb::cubic) cairo_curve_to(cairo_, p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y);
            if (verb == Verb::close) cairo_close_path(cairo_);
            p += point_count(verb);
        }
        return true;
    }

    // What is cut off, and the edges along the cut, lie farther outside than the pen reaches.
    void add_cut_ring(RingView ring, const Rectangle& within) {
        std::vector<Vec> points;
        points.reserve(ring.size());
        for (const Point p : ring) points.push_back(to_pixels(p));
        points = cut(points, &Vec::x, within.min.x, true);
        points = cut(points, &Vec::x, within.max.x, false);
        points = cut(points, &Vec::y, within.min.y, true);
        points = cut(points, &Vec::y, within.max.y, false);
        if (points.empty()) return;
        begin_ring();
        for (const Vec p : points) line_to(p);
        cairo_close_path(cairo_);
    }

    // Each stretch cut by itself: what goes out of sight comes back as a new line, its ends out of sight.
    void add_cut_line(RingView line, const Rectangle& within) {
        Vec last;
        bool is_drawing = false;
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Vec from = to_pixels(line[i - 1]), to = to_pixels(line[i]);
            const std::optional<std::pair<Vec, Vec>> seen = cut(from, to, within);
            if (!seen) continue;
            if (!is_drawing || seen->first != last) {
                begin_ring();
                line_to(seen->first);
            }
            line_to(seen->second);
            last = seen->second;
            is_drawing = true;
        }
    }

    void begin_ring() { cairo_new_sub_path(cairo_); }  // the next line only moves
    void line_to(Vec p) { cairo_line_to(cairo_, p.x, p.y); }
    Vec to_pixels(Vec p) const { return (p - drawing_.canvas.origin) * scale_; }
    Vec to_pixels(Point p) const { return to_pixels(to_px(p)); }

    cairo_t* cairo_;
    const Drawing& drawing_;
    const double scale_;
    const Vec size_;  // pixels
};

}  // namespace

Result<std::string> to_png(const Drawing& drawing, const PngOptions& options) {
    const Canvas& canvas = drawing.canvas;
    const Vec exact = canvas.size * options.scale;
    if (!(options.scale > 0 && exact.x > 0 && exact.y > 0) || !std::isfinite(exact.x) || !std::isfinite(exact.y) ||
        !is_on_plane(canvas.origin)) {
        return fault(Fault::limit, "png.no-size", "a picture needs a width, a height and a scale above 0");
    }
    // What rounding left over is no further pixel.
    const Vec size{std::max(1.0, std::ceil(exact.x - 1e-6)), std::max(1.0, std::ceil(exact.y - 1e-6))};
    if (size.x > most_pixels_a_side || size.y > most_pixels_a_side || size.x * size.y > most_pixels) {
        Diagnostic refused = fault(Fault::limit, "png.too-large",
                                   "the picture would have more than 32,000 pixels a side or 400,000,000 in all");
        refused.hints = {"choose a smaller scale"};
        return refused;
    }
    const Colour paper = canvas.background.value_or(Colour{255, 255, 255, 255});
    const bool has_alpha = paper.alpha != 255;
    const auto width = static_cast<int>(size.x), height = static_cast<int>(size.y);
    const Surface surface(
        cairo_image_surface_create(has_alpha ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24, width, height));
    if (const cairo_status_t status = cairo_surface_status(surface.get()); status != CAIRO_STATUS_SUCCESS) {
        return cairo_fault(status);
    }
    const CairoContext cairo(cairo_create(surface.get()));
    set_source(cairo.get(), paper);
    cairo_set_operator(cairo.get(), CAIRO_OPERATOR_SOURCE);
    cairo_paint(cairo.get());
    cairo_set_operator(cairo.get(), CAIRO_OPERATOR_OVER);
    Painter(cairo.get(), drawing, options.scale, size).paint(options.job);
    if (is_cancelled(options.job)) return cancelled_diagnostic();
    if (const cairo_status_t status = cairo_status(cairo.get()); status != CAIRO_STATUS_SUCCESS) {
        return cairo_fault(status);
    }
    cairo_surface_flush(surface.get());
    PixelView pixels;
    pixels.width = static_cast<std::uint32_t>(width);
    pixels.height = static_cast<std::uint32_t>(height);
    pixels.rows = cairo_image_surface_get_data(surface.get());
    pixels.stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
    pixels.has_alpha = has_alpha;
    return encode_png(pixels, options.scale);
}

}  // namespace filigree
