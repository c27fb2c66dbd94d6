#include "formats/svg_write.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "base/number_text.h"
#include "formats/svg_carried.h"
#include "formats/svg_path_data.h"
#include "formats/xml.h"

namespace filigree {
namespace {

// Some readers refuse attributes of more than ten million bytes, and long paths are slow to draw.
constexpr std::size_t longest_run = 1'000'000;

std::string number(double value, int decimals) {
    std::string text;
    append_fixed(text, std::isfinite(value) ? value : 0, decimals);
    return text;
}
std::string exact_number(double value) { return to_text(std::isfinite(value) ? value : 0); }

std::string hex_colour(Colour colour) { return to_text(Colour{colour.red, colour.green, colour.blue, 255}); }
std::string opacity(std::uint8_t alpha) { return number(alpha / 255.0, 4); }

// What presentation attributes are in force at a place; the initial values are those of SVG.
struct Attributes {
    std::string fill = "black", stroke = "none";
    std::string fill_opacity = "1", stroke_opacity = "1", stroke_width = "1", stroke_linejoin = "miter";
    std::string stroke_linecap = "butt";
};

// Fill and stroke are said together where either changes, so that no reader has to know the initial values;
// what refines them is said only where it matters and differs.
std::string changed(Attributes& in_force, const Style& style) {
    const bool is_filled = has_fill(style), is_stroked = has_stroke(style);
    Attributes wanted = in_force;
    wanted.fill = is_filled ? hex_colour(*style.fill) : "none";
    wanted.stroke = is_stroked ? hex_colour(*style.stroke) : "none";
    if (is_filled) wanted.fill_opacity = opacity(style.fill->alpha);
    if (is_stroked) {
        wanted.stroke_opacity = opacity(style.stroke->alpha);
        wanted.stroke_width = number(style.pen, 4);
        wanted.stroke_linejoin = style.corner == Corner::mitre   ? "miter"
                                 : style.corner == Corner::round ? "round"
                                                                 : "bevel";
        if (style.is_open) wanted.stroke_linecap = style.corner == Corner::round ? "round" : "butt";
    }
    std::string text;
    const auto say = [&](std::string_view name, const std::string& value) {
        text.append(" ").append(name).append("=\"").append(value).append("\"");
    };
    const auto say_changed = [&](std::string_view name, const std::string& before, const std::string& after) {
        if (before != after) say(name, after);
    };
    if (wanted.fill != in_force.fill || wanted.stroke != in_force.stroke) {
        say("fill", wanted.fill);
        say("stroke", wanted.stroke);
    }
    say_changed("fill-opacity", in_force.fill_opacity, wanted.fill_opacity);
    say_changed("stroke-opacity", in_force.stroke_opacity, wanted.stroke_opacity);
    say_changed("stroke-width", in_force.stroke_width, wanted.stroke_width);
    say_changed("stroke-linejoin", in_force.stroke_linejoin, wanted.stroke_linejoin);
    say_changed("stroke-linecap", in_force.stroke_linecap, wanted.stroke_linecap);
    in_force = std::move(wanted);
    return text;
}

// Counts how often each short name was used; a table with open addressing, as a drawing may have millions.
class ShortNames {
public:
    explicit ShortNames(std::size_t count) {
        std::size_t size = 16;
        while (size < 2 * count) size *= 2;
        slots_.resize(size);
    }
    // How many times `name` was used before.
    std::uint32_t use(std::uint32_t name) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = static_cast<std::size_t>(mix(name)) & mask;
        while (slots_[at].count != 0 && slots_[at].name != name) at = (at + 1) & mask;
        slots_[at].name = name;
        return slots_[at].count++;
    }

private:
    struct Slot {
        std::uint32_t name = 0, count = 0;
    };
    std::vector<Slot> slots_;
};

// The one style of all of a group's shapes.
std::optional<Style> common_style(const Drawing& drawing, const DrawingGroup& group) {
    std::optional<std::uint32_t> common;
    const auto agrees = [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t s = first; s < end; ++s) {
            const std::uint32_t style = drawing.shapes[s].style;
            if (!common) common = style;
            if (style != *common && drawing.styles[style] != drawing.styles[*common]) return false;
        }
        return true;
    };
    if (!agrees(group.first_shape, group.end_shape) || !agrees(group.first_overlay, group.end_overlay)) return {};
    if (!common) return {};
    return drawing.styles[*common];
}

class SvgWriter {
public:
    SvgWriter(const Drawing& drawing, const SvgOptions& options)
        : drawing_(drawing), options_(options), decimals_(std::clamp(options.decimals, 0, 6)) {}

    std::string write() && {
        std::string head = head_text();
        std::size_t points = 0;
        for (const DrawnShape& shape : drawing_.shapes) points += polygon_of(drawing_, shape).point_count();
        out_.reserve(head.size() + 1024 + points * (6 + static_cast<std::size_t>(decimals_)) +
                     drawing_.shapes.size() * 48 + drawing_.groups.size() * 96);
        out_.put(head);
        if (options_.lean) {
            put_runs();
        } else {
            put_groups();
        }
        out_.put("</svg>\n");
        return std::move(out_).take();
    }

private:
    std::string head_text() const {
        const Canvas& canvas = drawing_.canvas;
        const auto length = [&](double px) {
            return canvas.in_mm ? number(px * 25.4 / 96, 9) + "mm" : exact_number(px);
        };
        const std::string x = exact_number(canvas.origin.x), y = exact_number(canvas.origin.y);
        const std::string width = exact_number(canvas.size.x), height = exact_number(canvas.size.y);
        std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
        head += "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + length(canvas.size.x) + "\" height=\"" +
                length(canvas.size.y) + "\" viewBox=\"" + x + " " + y + " " + width + " " + height + "\">\n";
        if (!options_.title.empty()) {
            head += "<title>";
            append_escaped(head, options_.title);
            head += "</title>\n";
        }
        if (options_.carried != nullptr) append_carried(head, *options_.carried);
        if (canvas.background) {
            head += "<rect id=\"background\" x=\"" + x + "\" y=\"" + y + "\" width=\"" + width + "\" height=\"" +
                    height + "\" fill=\"" + hex_colour(*canvas.background) + "\"";
            if (canvas.background->alpha != 255) head += " fill-opacity=\"" + opacity(canvas.background->alpha) + "\"";
            head += "/>\n";
        }
        return head;
    }

    struct Open {  // a group
        Attributes in_force;
        bool is_uniform = false;                   // its shapes need not say how they look
        std::map<std::uint32_t, std::string> own;  // else: what they say, by style
    };

    void put_groups() {
        ShortNames names(drawing_.shapes.size());
        std::vector<Open> open;
        for (const PaintStep& step : painting_steps(drawing_)) {
            if (step.kind == PaintStep::Kind::leave) {
                out_.put("</g>\n");
                open.pop_back();
            } else if (step.kind == PaintStep::Kind::enter) {
                out_.put(open.empty() ? "<g fill-rule=\"evenodd\"" : "<g");
                open.push_back(
                    put_group_start(drawing_.groups[step.group], open.empty() ? Attributes{} : open.back().in_force));
            } else {
                for (std::uint32_t s = step.first; s < step.end; ++s) put_shape(names, open.back(), drawing_.shapes[s]);
            }
        }
    }

    Open put_group_start(const DrawingGroup& group, const Attributes& around) {
        Open opened{around, false, {}};
        if (!group.path.empty()) {
            std::string path;
            append_escaped(path, group.path);
            out_.put(" data-path=\"");
            out_.put(path);
            out_.put('"');
        }
        if (const std::optional<Style> common = common_style(drawing_, group)) {
            opened.is_uniform = true;
            out_.put(changed(opened.in_force, *common));
        }
        out_.put(">\n");
        return opened;
    }

    void put_shape(ShortNames& names, Open& group, const DrawnShape& shape) {
        put_opening(names, shape.key);
        if (!group.is_uniform) {
            const auto [own, is_new] = group.own.try_emplace(shape.style);
            if (is_new) {
                Attributes in_force = group.in_force;
                own->second = changed(in_force, drawing_.styles[shape.style]);
            }
            out_.put(own->second);
        }
        out_.put(" d=\"");
        put_data(shape, {});
        out_.put("\"/>\n");
    }

    Point put_data(const DrawnShape& shape, Point from) {
        if (has_curve(shape)) return put_curve_data(out_, drawing_.curves[shape.curve], decimals_, from);
        const PolygonView polygon = polygon_of(drawing_, shape);
        return drawing_.styles[shape.style].is_open ? put_line_data(out_, polygon.outer(), decimals_, from)
                                                    : put_path_data(out_, polygon, decimals_, from);
    }

    void put_opening(ShortNames& names, Key key) {
        const auto name = static_cast<std::uint32_t>(key.value >> 32);
        static constexpr char hex[] = "0123456789abcdef";
        out_.put("<path id=\"s");
        for (int shift = 28; shift >= 0; shift -= 4) out_.put(hex[name >> shift & 15]);
        if (const std::uint32_t before = names.use(name); before > 0) out_.put("-" + std::to_string(before + 1));
        out_.put('"');
    }

    // Lean: outers and holes turn against each other, so the rule of non-zero winding, SVG's own, unites
    // overlapping shapes where the even-odd rule would leave holes. Curves turn either way, and those that are filled
    // are paths of their own.
    void put_runs() {
        const Style* style = nullptr;  // of the path that is being written
        bool is_overlay = false, is_own = false;
        std::size_t begin = 0;
        Point at;
        for (const PaintStep& step : painting_steps(drawing_)) {
            if (step.kind != PaintStep::Kind::shapes) continue;
            for (std::uint32_t s = step.first; s < step.end; ++s) {
                const Style& wanted = drawing_.styles[drawing_.shapes[s].style];
                const bool was_own = std::exchange(is_own, has_curve(drawing_.shapes[s]) && has_fill(wanted));
                if (style == nullptr || was_own || is_own || out_.size() - begin > longest_run ||
                    !may_join(*style, is_overlay, wanted, step.overlay)) {
                    if (style != nullptr) out_.put("\"/>\n");
                    Attributes initial;
                    out_.put("<path");
                    out_.put(changed(initial, wanted));
                    if (is_own) out_.put(" fill-rule=\"evenodd\"");
                    out_.put(" d=\"");
                    begin = out_.size();
                    at = {};
                }
                style = &wanted;
                is_overlay = step.overlay;
                at = put_data(drawing_.shapes[s], at);
            }
        }
        if (style != nullptr) out_.put("\"/>\n");
    }

    static bool may_join(const Style& a, bool a_is_overlay, const Style& b, bool b_is_overlay) {
        if (!(a == b)) return false;
        const bool is_opaque = (!a.fill || a.fill->alpha == 255) && (!a.stroke || a.stroke->alpha == 255);
        // Overlays are painted over what lies below, strokes included.
        return is_opaque && (!(a.fill && a.stroke) || a_is_overlay == b_is_overlay);
    }

    const Drawing& drawing_;
    const SvgOptions& options_;
    const int decimals_;
    TextBuffer out_;
};

}  // namespace

std::string to_svg(const Drawing& drawing, const SvgOptions& options) { return SvgWriter(drawing, options).write(); }

}  // namespace filigree
