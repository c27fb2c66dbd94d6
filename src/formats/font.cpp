#include "formats/font.h"

#include <hb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "base/unicode.h"
#include "formats/font_check.h"
#include "formats/text_runs.h"

namespace filigree {
namespace {

constexpr std::size_t longest_text = 100'000;
constexpr double largest_size = 1e6;
constexpr std::size_t most_named = 10;  // characters in a warning

struct HarfBuzzDeleter {
    void operator()(hb_blob_t* blob) const { hb_blob_destroy(blob); }
    void operator()(hb_face_t* face) const { hb_face_destroy(face); }
    void operator()(hb_font_t* font) const { hb_font_destroy(font); }
    void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
    void operator()(hb_draw_funcs_t* functions) const { hb_draw_funcs_destroy(functions); }
};
template <class T>
using HarfBuzz = std::unique_ptr<T, HarfBuzzDeleter>;

// A path that is being drawn, and where the font's units lie in it.
struct Pen {
    Path path;
    double size = 1, units = 1;  // px and units an em
    Vec origin;                  // px

    Vec at(float x, float y) const { return {origin.x + x * size / units, origin.y - y * size / units}; }
};

void on_move(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) {
    Pen& pen = *static_cast<Pen*>(data);
    pen.path.verbs.push_back(Verb::move);
    pen.path.points.push_back(pen.at(x, y));
}
void on_line(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) {
    Pen& pen = *static_cast<Pen*>(data);
    pen.path.verbs.push_back(Verb::line);
    pen.path.points.push_back(pen.at(x, y));
}
void on_quadratic(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float cx, float cy, float x, float y, void*) {
    Pen& pen = *static_cast<Pen*>(data);
    pen.path.verbs.push_back(Verb::quadratic);
    pen.path.points.insert(pen.path.points.end(), {pen.at(cx, cy), pen.at(x, y)});
}
void on_cubic(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float ax, float ay, float bx, float by, float x, float y,
              void*) {
    Pen& pen = *static_cast<Pen*>(data);
    pen.path.verbs.push_back(Verb::cubic);
    pen.path.points.insert(pen.path.points.end(), {pen.at(ax, ay), pen.at(bx, by), pen.at(x, y)});
}
void on_close(hb_draw_funcs_t*, void* data, hb_draw_state_t*, void*) {
    static_cast<Pen*>(data)->path.verbs.push_back(Verb::close);
}

HarfBuzz<hb_draw_funcs_t> drawing_functions() {
    HarfBuzz<hb_draw_funcs_t> functions(hb_draw_funcs_create());
    hb_draw_funcs_set_move_to_func(functions.get(), on_move, nullptr, nullptr);
    hb_draw_funcs_set_line_to_func(functions.get(), on_line, nullptr, nullptr);
    hb_draw_funcs_set_quadratic_to_func(functions.get(), on_quadratic, nullptr, nullptr);
    hb_draw_funcs_set_cubic_to_func(functions.get(), on_cubic, nullptr, nullptr);
    hb_draw_funcs_set_close_path_func(functions.get(), on_close, nullptr, nullptr);
    return functions;
}

// Scripts whose letters hold hands, so that space between them would tear words.
bool is_joined(hb_script_t script) {
    static constexpr std::array joined = {
        HB_SCRIPT_ARABIC,   HB_SCRIPT_SYRIAC, HB_SCRIPT_MONGOLIAN, HB_SCRIPT_NKO,        HB_SCRIPT_MANDAIC,
        HB_SCRIPT_PHAGS_PA, HB_SCRIPT_ADLAM,  HB_SCRIPT_SOGDIAN,   HB_SCRIPT_MANICHAEAN, HB_SCRIPT_HANIFI_ROHINGYA};
    return std::find(joined.begin(), joined.end(), script) != joined.end();
}

// A glyph of a line, placed in the font's units and in spacings.
struct Placed {
    std::uint32_t glyph = 0;
    std::size_t cluster = 0;     // byte offset in the whole text
    std::int64_t x = 0, y = 0;   // units, y upwards
    std::uint32_t spacings = 0;  // before it
};
struct Line {
    std::vector<Placed> glyphs;
    std::int64_t width = 0;  // units
    std::uint32_t spacings = 0;
};

class TextSetter {
public:
    TextSetter(hb_font_t* font, std::string_view text, double size, const TextOptions& options)
        : font_(font),
          text_(text),
          options_(options),
          size_(size),
          units_(hb_face_get_upem(hb_font_get_face(font))),
          is_letter_start_(text.size() + 1, false) {
        std::replace(text_.begin(), text_.end(), '\t', ' ');
    }

    Result<std::vector<Glyph>> set() && {
        std::size_t lines = 0;
        for (std::size_t begin = 0; begin <= text_.size(); ++lines) {
            const std::size_t newline = std::min(text_.find('\n', begin), text_.size());
            std::size_t end = newline;
            if (end > begin && newline < text_.size() && text_[end - 1] == '\r') --end;
            is_letter_start_[end] = true;
            const Line line = shape_line(begin, end);
            if (!draw(line, static_cast<double>(lines) * options_.line_height * size_)) {
                return fault(Fault::limit, "font.too-large", "the text reaches too far for a drawing of this size");
            }
            begin = newline + 1;
        }
        for (Glyph& glyph : glyphs_) glyph.text = letter_at(glyph.begin);
        return {std::move(glyphs_), warnings()};
    }

private:
    Line shape_line(std::size_t begin, std::size_t end) {
        Line line;
        const std::string_view text = std::string_view(text_).substr(begin, end - begin);
        std::size_t last_cluster = text_.size();
        bool is_spaced = false;  // whether the letter before asks for space
        for (const TextRun& run : text_runs(text)) {
            const HarfBuzz<hb_buffer_t> buffer = shaped(text, run);
            unsigned count = 0;
            const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
            const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer.get(), nullptr);
            for (unsigned i = 0; i < count; ++i) {
                const std::size_t cluster = begin + infos[i].cluster;
                is_letter_start_[cluster] = true;
                if (cluster != last_cluster) {
                    if (is_spaced) ++line.spacings;
                    is_spaced = options_.letter_spacing != 0 && !is_joined(run.script);
                    last_cluster = cluster;
                }
                if (infos[i].codepoint == 0) {
                    missing_.push_back(cluster);
                } else {
                    line.glyphs.push_back({infos[i].codepoint, cluster, line.width + positions[i].x_offset,
                                           positions[i].y_offset, line.spacings});
                }
                line.width += positions[i].x_advance;
            }
        }
        return line;
    }

    HarfBuzz<hb_buffer_t> shaped(std::string_view line, const TextRun& run) const {
        HarfBuzz<hb_buffer_t> buffer(hb_buffer_create());
        // The whole line stands around the run, so that letters join across runs.
        hb_buffer_add_utf8(buffer.get(), line.data(), static_cast<int>(line.size()), static_cast<unsigned>(run.begin),
                           static_cast<int>(run.end - run.begin));
        hb_buffer_set_direction(buffer.get(), run.is_right_to_left ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
        hb_buffer_set_script(buffer.get(), run.script);
        hb_buffer_set_language(buffer.get(), hb_language_from_string("und", -1));  // not that of the machine
        const auto off = [](hb_tag_t feature) {
            return hb_feature_t{feature, 0, HB_FEATURE_GLOBAL_START, HB_FEATURE_GLOBAL_END};
        };
        const std::array no_ligatures = {off(HB_TAG('l', 'i', 'g', 'a')), off(HB_TAG('c', 'l', 'i', 'g'))};
        const bool is_loose = options_.letter_spacing != 0 && !is_joined(run.script);
        hb_shape(font_, buffer.get(), no_ligatures.data(), is_loose ? static_cast<unsigned>(no_ligatures.size()) : 0U);
        return buffer;
    }

    // False where the line leaves the plane.
    bool draw(const Line& line, double baseline) {
        const double spacing = options_.letter_spacing;
        const double width = px(line.width) + line.spacings * spacing;
        const double left = options_.align == TextAlign::left     ? 0
                            : options_.align == TextAlign::centre ? -width / 2
                                                                  : -width;
        Pen pen;
        pen.size = size_;
        pen.units = units_;
        for (const Placed& placed : line.glyphs) {
            pen.origin = {left + px(placed.x) + placed.spacings * spacing, baseline - px(placed.y)};
            pen.path = {};
            draw_glyph(placed.glyph, pen);
            if (pen.path.verbs.empty()) continue;
            for (const Vec p : pen.path.points) {
                if (!is_on_plane(p)) return false;
            }
            if (glyphs_.empty() || glyphs_.back().begin != placed.cluster) glyphs_.push_back({{}, placed.cluster, {}});
            Path& path = glyphs_.back().path;
            path.verbs.insert(path.verbs.end(), pen.path.verbs.begin(), pen.path.verbs.end());
            path.points.insert(path.points.end(), pen.path.points.begin(), pen.path.points.end());
        }
        return true;
    }

    double px(std::int64_t units) const { return static_cast<double>(units) * size_ / units_; }

    void draw_glyph(std::uint32_t glyph, Pen& pen) {
#if HB_VERSION_ATLEAST(7, 0, 0)
        hb_font_draw_glyph(font_, glyph, functions_.get(), &pen);
#else
        hb_font_get_glyph_shape(font_, glyph, functions_.get(), &pen);
#endif
    }

    std::string letter_at(std::size_t begin) const {
        std::size_t end = begin + 1;
        while (end < text_.size() && !is_letter_start_[end]) ++end;
        return text_.substr(begin, end - begin);
    }

    Diagnostics warnings() {
        std::sort(missing_.begin(), missing_.end());
        std::vector<std::string> letters;
        for (const std::size_t at : missing_) {
            std::string letter = letter_at(at);
            if (std::find(letters.begin(), letters.end(), letter) == letters.end()) letters.push_back(letter);
        }
        if (letters.empty()) return {};
        std::string names;
        for (std::size_t i = 0; i < std::min(letters.size(), most_named); ++i) {
            names += (i == 0 ? "'" : ", '") + letters[i] + "'";
        }
        if (letters.size() > most_named) names += " and " + std::to_string(letters.size() - most_named) + " more";
        return {warning("font.no-letter", "the font has no letter for " + names)};
    }

    hb_font_t* font_;
    std::string text_;
    const TextOptions& options_;
    const double size_, units_;  // px and units an em
    const HarfBuzz<hb_draw_funcs_t> functions_ = drawing_functions();
    std::vector<bool> is_letter_start_;  // by byte
    std::vector<std::size_t> missing_;   // clusters
    std::vector<Glyph> glyphs_;
};

Diagnostics check_arguments(std::string_view text, double size, const TextOptions& options) {
    if (!(size > 0 && size <= largest_size)) {
        return {error("font.bad-size", "the size of a text must be above 0 and at most 1,000,000 px")};
    }
    if (!(std::fabs(options.line_height) <= 1000) || !(std::fabs(options.letter_spacing) <= largest_size)) {
        return {error("font.bad-spacing", "the spacing of a text must be at most 1,000 lines and 1,000,000 px")};
    }
    if (text.size() > longest_text) {
        return {fault(Fault::limit, "font.long-text", "a text may have at most 100,000 bytes")};
    }
    if (unicode::find_invalid(text) != std::string_view::npos) {
        return {error("font.bad-text", "the text is no valid UTF-8")};
    }
    return {};
}

}  // namespace

Result<std::vector<Glyph>> text_outlines(std::string_view font, std::string_view text, double size,
                                         const TextOptions& options) {
    if (Diagnostics wrong = check_arguments(text, size, options); !wrong.empty()) return wrong;
    if (Diagnostics wrong = check_font(font); !wrong.empty()) return wrong;
    const HarfBuzz<hb_blob_t> blob(
        hb_blob_create(font.data(), static_cast<unsigned>(font.size()), HB_MEMORY_MODE_READONLY, nullptr, nullptr));
    const HarfBuzz<hb_face_t> face(hb_face_create(blob.get(), 0));
    const HarfBuzz<hb_font_t> shaper(hb_font_create(face.get()));
    const unsigned units = hb_face_get_upem(face.get());
    if (hb_face_get_glyph_count(face.get()) == 0 || units == 0) {
        return error("font.broken", "the font has no letters");
    }
    hb_font_set_scale(shaper.get(), static_cast<int>(units), static_cast<int>(units));  // the font's own units
    return TextSetter(shaper.get(), text, size, options).set();
}

}  // namespace filigree
