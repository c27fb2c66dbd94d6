#include "formats/pdf_write.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "formats/deflate.h"
#include "formats/pdf_carried.h"
#include "formats/pdf_file.h"
#include "formats/svg_path_data.h"
#include "plane/cubics.h"

namespace filigree {
namespace {

constexpr std::size_t points_a_piece = 60'000;  // about a million bytes
constexpr std::size_t longest_coordinate = 20;
constexpr double points_a_px = 0.75;
constexpr double longest_side = 14'400;  // of a page, in its units

struct Alpha {
    std::uint8_t fill = 255, stroke = 255;

    auto operator<=>(const Alpha&) const = default;
};
Alpha alpha_of(const Style& style) {
    return {has_fill(style) ? style.fill->alpha : std::uint8_t{255},
            has_stroke(style) ? style.stroke->alpha : std::uint8_t{255}};
}
std::string name_of(Alpha alpha) { return "/A" + std::to_string(alpha.fill) + "-" + std::to_string(alpha.stroke); }

std::string colour_text(Colour colour) {
    std::string text;
    for (const std::uint8_t channel : {colour.red, colour.green, colour.blue}) {
        text += pdf_number(channel / 255.0, 4) + " ";
    }
    return text;
}

// The painting operators of a range of shapes. It starts from no known state, so that ranges do not need each other.
class PieceWriter {
public:
    PieceWriter(const Drawing& drawing, int decimals) : drawing_(drawing), decimals_(decimals) {
        for (int i = 0; i < decimals; ++i) unit_ *= 10;
    }

    void put(std::string_view text) { out_.put(text); }
    void put(const DrawnShape& shape) {
        const Style& style = drawing_.styles[shape.style];
        const bool is_filled = has_fill(style), is_stroked = has_stroke(style);
        if (!is_filled && !is_stroked) return;
        if (polygon_of(drawing_, shape).point_count() == 0) return;
        set(style, shape.style);
        put_outline(shape, is_stroked && !style.is_open);
        if (is_filled && is_stroked && style.stroke->alpha != 255) {
            out_.put("f*\n");  // both at once would cut the stroke out of the fill
            put_outline(shape, true);
            out_.put("S\n");
        } else {
            out_.put(!is_stroked ? "f*\n" : is_filled ? "B*\n" : "S\n");
        }
    }
    std::string take() && { return std::move(out_).take(); }

private:
    void set(const Style& style, std::uint32_t index) {
        if (last_style_ == index) return;
        last_style_ = index;
        if (const Alpha alpha = alpha_of(style); alpha_ != alpha) {
            out_.put(name_of(alpha) + " gs\n");
            alpha_ = alpha;
        }
        if (has_fill(style)) say(fill_, colour_text(*style.fill) + "rg\n");
        if (!has_stroke(style)) return;
        say(stroke_, colour_text(*style.stroke) + "RG\n");
        say(pen_, pdf_number(style.pen * unit_, 3) + " w\n");
        if (style.is_open) say(cap_, style.corner == Corner::round ? "1 J\n" : "0 J\n");
        say(corner_, style.corner == Corner::mitre ? "0 j\n" : style.corner == Corner::round ? "1 j\n" : "2 j\n");
    }
    void say(std::string& in_force, std::string wanted) {
        if (in_force == wanted) return;
        out_.put(wanted);
        in_force = std::move(wanted);
    }

    void put_outline(const DrawnShape& shape, bool is_closed) {
        if (has_curve(shape)) return put_curve(in_cubics(drawing_.curves[shape.curve]));
        const PolygonView polygon = polygon_of(drawing_, shape);
        for (std::size_t r = 0; r < polygon.ring_count(); ++r) put_ring(polygon.ring(r), r > 0, is_closed);
    }

    void put_curve(const Path& cubics) {
        std::size_t at = 0;
        for (const Verb verb : cubics.verbs) {
            char* to = out_.room(6 * longest_coordinate + 2);
            for (const std::size_t end = at + point_count(verb); at < end; ++at) {
                const Point place = rounded(snap(cubics.points[at]));
                to = put_number(put_number(to, place.x), place.y);
            }
            *to++ = verb == Verb::move ? 'm' : verb == Verb::line ? 'l' : verb == Verb::cubic ? 'c' : 'h';
            *to++ = '\n';
            out_.advance_to(to);
        }
    }

    void put_ring(RingView ring, bool is_hole, bool is_closed) {
        if (ring.empty()) return;
        char* const begin = out_.room(ring.size() * (2 * longest_coordinate + 2) + 2);
        char* to = begin;
        Point last;
        std::size_t count = 0;
        for (const Point p : ring) {
            const Point at = rounded(p);
            if (count > 0 && at == last) continue;
            to = put_number(put_number(to, at.x), at.y);
            *to++ = count == 0 ? 'm' : 'l';
            *to++ = '\n';
            last = at;
            ++count;
        }
        if (is_hole && count < 3) return;
        if (is_closed) {  // filling closes by itself
            *to++ = 'h';
            *to++ = '\n';
        }
        out_.advance_to(to);
    }

    Point rounded(Point p) const { return {rounded_coordinate(p.x, decimals_), rounded_coordinate(p.y, decimals_)}; }

    static char* put_number(char* to, std::int64_t value) {
        to = std::to_chars(to, to + longest_coordinate, value).ptr;
        *to++ = ' ';
        return to;
    }

    const Drawing& drawing_;
    const int decimals_;
    double unit_ = 1;
    TextBuffer out_;
    std::optional<std::uint32_t> last_style_;
    std::optional<Alpha> alpha_;
    std::string fill_, stroke_, pen_, corner_, cap_;  // as last said
};

// The shapes in the order of painting, in ranges of about as many points each.
struct Range {
    std::uint32_t first = 0, end = 0;
};
std::vector<std::vector<Range>> pieces_of(const Drawing& drawing) {
    std::vector<std::vector<Range>> pieces(1);
    std::size_t points = 0;
    for (const PaintStep& step : painting_steps(drawing)) {
        for (std::uint32_t s = step.first; s < step.end; ++s) {
            if (points > points_a_piece) {
                pieces.emplace_back();
                points = 0;
            }
            if (pieces.back().empty() || pieces.back().back().end != s) pieces.back().push_back({s, s});
            pieces.back().back().end = s + 1;
            points += polygon_of(drawing, drawing.shapes[s]).point_count();
        }
    }
    return pieces;
}

int fitting_decimals(const Drawing& drawing, int wanted) {
    std::int64_t farthest = 0;
    for (const DrawnShape& shape : drawing.shapes) {
        const PolygonView polygon = polygon_of(drawing, shape);
        if (polygon.ring_count() == 0) continue;
        Box box = bounds(polygon);
        if (has_curve(shape)) {
            for (const Vec p : in_cubics(drawing.curves[shape.curve]).points) extend(box, snap(p));
        }
        if (!is_empty(box)) farthest = std::max({farthest, -box.min.x, -box.min.y, box.max.x, box.max.y});
    }
    int decimals = std::clamp(wanted, 0, 6);
    while (decimals > 0 && rounded_coordinate(farthest, decimals) > INT32_MAX) --decimals;
    return decimals;
}

class PdfWriter {
public:
    PdfWriter(const Drawing& drawing, const PdfOptions& options)
        : drawing_(drawing), options_(options), decimals_(fitting_decimals(drawing, options.decimals)) {
        for (const DrawnShape& shape : drawing.shapes) {
            const Alpha alpha = alpha_of(drawing.styles[shape.style]);
            alphas_.insert(alpha);
        }
        if (drawing.canvas.background) alphas_.insert({drawing.canvas.background->alpha, 255});
        const double side = std::max(points(drawing.canvas.size.x), points(drawing.canvas.size.y));
        user_unit_ = side > longest_side ? std::ceil(side / longest_side) : 1;
    }

    std::string write() && {
        PdfFile pdf;
        const std::size_t catalog = pdf.take_number(), pages = pdf.take_number(), page = pdf.take_number();
        const std::size_t info = pdf.take_number();
        std::string contents;
        for (const std::string& packed : packed_pieces()) {
            const std::size_t number = pdf.take_number();
            pdf.put_stream(number, "", packed);
            contents += (contents.empty() ? "" : " ") + pdf_reference(number);
        }
        pdf.put(page, page_text(pages, contents));
        pdf.put(pages, "<< /Type /Pages /Kids [" + pdf_reference(page) + "] /Count 1 >>");
        const std::string title = options_.title.empty() ? "" : "/Title " + pdf_text(options_.title) + " ";
        pdf.put(info, "<< " + title + "/Producer (Filigree) >>");
        const std::string carried = options_.carried == nullptr ? "" : put_carried(pdf, *options_.carried);
        pdf.put(catalog, "<< /Type /Catalog /Pages " + pdf_reference(pages) + " " + carried + ">>");
        return std::move(pdf).finish(catalog, info);
    }

private:
    // A length on the page before its unit is chosen.
    static double points(double px) { return std::isfinite(px) ? px * points_a_px : 0; }
    std::string page_number(double px) const { return pdf_number(points(px) / user_unit_, 6); }

    std::vector<std::string> packed_pieces() const {
        const std::vector<std::vector<Range>> pieces = pieces_of(drawing_);
        std::vector<std::string> packed(pieces.size());
        const auto pack = [&](std::size_t i) {
            PieceWriter writer(drawing_, decimals_);
            if (i == 0) writer.put(opening());
            for (const Range& range : pieces[i]) {
                for (std::uint32_t s = range.first; s < range.end; ++s) writer.put(drawing_.shapes[s]);
            }
            if (i + 1 == pieces.size()) writer.put("Q\n");
            packed[i] = deflated(std::move(writer).take());
        };
        SerialExecutor serial;
        (options_.executor == nullptr ? serial : *options_.executor).run(pieces.size(), pack);
        return packed;
    }

    // The paper, and then the matrix from whole coordinates to the page.
    std::string opening() const {
        const Canvas& canvas = drawing_.canvas;
        std::string text = "q\n";
        if (canvas.background) {
            text += name_of({canvas.background->alpha, 255}) + " gs\n" + colour_text(*canvas.background) + "rg\n0 0 " +
                    page_number(canvas.size.x) + " " + page_number(canvas.size.y) + " re f\n";
        }
        double scale = points_a_px / user_unit_;
        for (int i = 0; i < decimals_; ++i) scale /= 10;
        const std::string by = pdf_number(scale, 14);
        text += by + " 0 0 -" + by + " " + page_number(-canvas.origin.x) + " " +
                page_number(canvas.origin.y + canvas.size.y) + " cm\n4 M\n";  // SVG's own limit of mitres
        return text;
    }

    std::string page_text(std::size_t pages, const std::string& contents) const {
        std::string text = "<< /Type /Page /Parent " + pdf_reference(pages) + " /MediaBox [0 0 " +
                           page_number(drawing_.canvas.size.x) + " " + page_number(drawing_.canvas.size.y) + "]";
        if (user_unit_ > 1) text += " /UserUnit " + pdf_number(user_unit_, 0);
        text += " /Contents [" + contents + "] /Resources <<";
        if (!alphas_.empty()) {
            text += " /ExtGState <<";
            for (const Alpha alpha : alphas_) {
                text += " " + name_of(alpha) + " << /ca " + pdf_number(alpha.fill / 255.0, 4) + " /CA " +
                        pdf_number(alpha.stroke / 255.0, 4) + " >>";
            }
            text += " >>";
        }
        text += " >>";
        const bool is_opaque = std::all_of(alphas_.begin(), alphas_.end(), [](Alpha a) { return a == Alpha{}; });
        if (!is_opaque) text += " /Group << /S /Transparency /CS /DeviceRGB >>";
        return text + " >>";
    }

    const Drawing& drawing_;
    const PdfOptions& options_;
    const int decimals_;
    double user_unit_ = 1;  // points
    std::set<Alpha> alphas_;
};

}  // namespace

std::string to_pdf(const Drawing& drawing, const PdfOptions& options) { return PdfWriter(drawing, options).write(); }

}  // namespace filigree
