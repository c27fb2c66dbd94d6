#include "engines/tangle/draw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "derivation/page_canvas.h"
#include "engines/tangle/paths.h"
#include "engines/tangle/scopes.h"
#include "language/style.h"
#include "scene/arrange.h"
#include "scene/by_hand.h"

namespace filigree::tangle {
namespace {

constexpr Colour ink{0, 0, 0, 255};
constexpr std::uint64_t hand_noise = 1;  // not the document's seed: replayed choices draw the same at any seed
constexpr Colour paper{255, 255, 255, 255};

// Outlines of large regions are drawn bolder than the hatching inside them.
double pen_at_depth(std::uint32_t depth) {
    double pen = 1.5;
    for (std::uint32_t d = 1; d < depth && pen > 0.7; ++d) pen *= 0.86;
    return std::max(pen, 0.7);
}

// A colour by hue in turns, saturation and lightness, all in 0..1.
Colour from_hsl(double hue, double saturation, double lightness) {
    const double spread = saturation * std::min(lightness, 1 - lightness);
    const auto channel = [&](double offset) {
        const double at = (hue - std::floor(hue)) * 12 + offset;
        const double k = at - 12 * std::floor(at / 12);
        const double ramp = std::clamp(std::min(k - 3, 9 - k), -1.0, 1.0);
        return static_cast<std::uint8_t>(std::lround(255 * (lightness - spread * ramp)));
    };
    return {channel(0), channel(8), channel(4), 255};
}

// Styles as a drawing holds them: each once, in the order of their first use.
class StyleTable {
public:
    std::uint32_t index_of(const Style& style, std::vector<Style>& styles) {
        const auto [known, fresh] = known_.emplace(key_of(style), static_cast<std::uint32_t>(styles.size()));
        if (fresh) styles.push_back(style);
        return known->second;
    }

private:
    using StyleKey = std::array<std::uint64_t, 4>;

    static std::uint64_t packed(const std::optional<Colour>& colour) {
        if (!colour) return UINT64_MAX;
        return std::uint64_t{colour->red} << 24 | std::uint64_t{colour->green} << 16 |
               std::uint64_t{colour->blue} << 8 | colour->alpha;
    }
    static StyleKey key_of(const Style& style) {
        return {packed(style.fill), packed(style.stroke), static_cast<std::uint64_t>(std::llround(style.pen * 1e6)),
                static_cast<std::uint64_t>(style.corner)};
    }

    std::map<StyleKey, std::uint32_t> known_;
};

void apply(const StyleOverride& over, Style& style) {
    if (over.fill) style.fill = *over.fill;
    if (over.stroke) style.stroke = *over.stroke;
    if (over.pen) style.pen = *over.pen;
    if (over.corner) style.corner = *over.corner;
}

// What presets may say of styles.
constexpr std::string_view style_parameters[] = {"fill",   "stroke",        "pen",  "corner",
                                                 "wobble", "wobble_length", "line", "when"};

HandStyle hand_style_of(const StyleOverride& over) {
    HandStyle style;
    if (over.wobble) style.wobble.amplitude = *over.wobble;
    if (over.wobble_length) style.wobble.wavelength = *over.wobble_length;
    style.has_drawn_line = over.line == LineQuality::drawn;
    return style;
}

// Whether any style says that something is drawn by hand; presets only change what styles say.
bool may_be_by_hand(const StyleSheet& sheet) {
    return std::any_of(sheet.rules.begin(), sheet.rules.end(), [](const StyleRule& rule) {
        return std::any_of(rule.properties.begin(), rule.properties.end(), [](const StyleRuleProperty& property) {
            return property.kind == StylePropertyKind::wobble || property.kind == StylePropertyKind::line;
        });
    });
}

class Drawer {
public:
    Drawer(const Tangle& tangle, const Grammar& grammar, const Settings& settings, const Document& document,
           StyleSheet sheet, const DrawOptions& options)
        : tangle_(tangle),
          grammar_(grammar),
          sheet_(std::move(sheet)),
          may_be_by_hand_(may_be_by_hand(sheet_)),
          colour_by_(options.colour_by),
          job_(options.job),
          walk_(begin_walk(options.site, document, settings.globals, settings.seed)) {
        picture_.met.resize(walk_.presets.all.size());
        const bool may_be_preset = std::any_of(std::begin(style_parameters), std::end(style_parameters),
                                               [&](std::string_view name) { return may_name(walk_.presets, name); });
        for (const std::string& tag : grammar.tags) {
            tag_styles_.push_back(style_of_tag(sheet_, tag, may_be_preset));
            is_named_.push_back(
                std::any_of(settings.styles.begin(), settings.styles.end(), [&](const StyleStatement* style) {
                    return std::any_of(style->tags.begin(), style->tags.end(),
                                       [&](const Name& name) { return name.text == tag; });
                }));
        }
    }

    Result<Picture> draw() {
        drawing_.geometry = tangle_.geometry;
        drawing_.groups.emplace_back();  // the starts
        for (std::uint32_t g = 0; g < tangle_.start_groups; ++g) draw_leaf(g);
        drawing_.groups[0].end_shape = shape_count();
        std::vector<std::string> paths(tangle_.groups.size());
        for (std::uint32_t g = 0; g < tangle_.start_groups; ++g) paths[g] = segment_of_group(tangle_, grammar_, g);
        for (std::uint32_t s = 0; s < tangle_.steps.size() && !is_stopped(); ++s) {
            const Step& step = tangle_.steps[s];
            DrawingGroup group;
            group.path = paths[step.group] + "/" + grammar_.rules[step.rule].segment;
            group.first_shape = shape_count();
            for (std::uint32_t g = step.first_output; g < step.end_output; ++g) {
                if (tangle_.groups[g].consumer == none) {
                    draw_leaf(g);
                } else {
                    paths[g] = group.path + "/" + segment_of_group(tangle_, grammar_, g);
                }
            }
            group.end_shape = shape_count();
            const std::uint32_t producer = tangle_.groups[step.group].producer;
            drawing_.groups[producer == none ? 0 : producer + 1].children.push_back(s + 1);
            drawing_.groups.push_back(std::move(group));
        }
        if (is_stopped()) return errors_;  // not all steps have a group then
        for (std::uint32_t s = 0; s < tangle_.steps.size() && !is_stopped(); ++s) draw_overlay(s);
        if (is_stopped()) return errors_;
        draw_by_hand(drawing_, hand_shapes_, hand_noise);
        DrawingPlacer placer(drawing_);
        for (std::uint32_t s = 0; s < tangle_.steps.size() && !is_stopped(); ++s) place_embedded(s, placer);
        if (is_stopped()) return errors_;
        picture_.drawing = std::move(drawing_);
        picture_.choices = std::move(recorder_.choices);
        return std::move(picture_);
    }

private:
    // After an error; a cancelled job becomes one.
    bool is_stopped() {
        if (errors_.empty() && is_cancelled(job_)) errors_.push_back(cancelled_diagnostic());
        return !errors_.empty();
    }

    std::uint32_t shape_count() const { return static_cast<std::uint32_t>(drawing_.shapes.size()); }

    void add_shape(const Shape& shape, const Style& style, HandRole role, const HandStyle& by_hand) {
        if (may_be_by_hand_) hand_shapes_.push_back({shape.geometry, shape.polygon, shape_count(), role, by_hand});
        drawing_.shapes.push_back({shape.geometry, shape.polygon, styles_.index_of(style, drawing_.styles), shape.key});
    }

    Colour false_colour(const Group& group, std::uint32_t number) const {
        // Hues a golden section apart differ well for any number of them.
        constexpr double golden = 0.61803398874989485;
        if (colour_by_ == ColourBy::group) return from_hsl(golden * number, 0.55, 0.62);
        if (colour_by_ == ColourBy::step) {
            const double steps = std::max<double>(1, static_cast<double>(tangle_.steps.size()));
            const double at = group.producer == none ? 0 : (group.producer + 1) / steps;
            return from_hsl(0.62 - 0.5 * at, 0.6, 0.3 + 0.5 * at);
        }
        const double shade = golden * number - std::floor(golden * number);
        return from_hsl(golden * group.tag, 0.6, 0.45 + 0.35 * shade);
    }

    Style base_style(const Group& group, const Shape& shape, std::uint32_t number) const {
        Style style;
        style.pen = pen_at_depth(group.depth);
        if (colour_by_ != ColourBy::style) {
            style.fill = false_colour(group, number);
            style.stroke = ink;
            style.pen = 0.7;
            return style;
        }
        style.fill = shape.inked ? ink : shape.fill.value_or(paper);
        style.stroke = shape.border_in_paper ? paper : ink;
        if (shape.is_mark) style.stroke.reset();
        return style;
    }

    std::optional<StyleOverride> override_of(std::uint32_t group, std::size_t index) {
        const TagStyle& of_tag = tag_styles_[tangle_.groups[group].tag];
        if (of_tag.is_constant) return of_tag.common;
        const Scope scope = style_scope(tangle_, group, index);
        ChoiceBuffer record;
        PresetNode node;
        const StyleChoices choices = [&](std::string_view segment) {
            node = style_node(tangle_.groups[group], index, segment);
            for (const std::uint32_t preset : node.accepted) {
                const std::string& parameter = walk_.presets.all[preset].path->parameter;
                for (const std::string_view known : style_parameters) {
                    if (parameter == known) picture_.met[preset] = 1;
                }
            }
            return choices_at(walk_, node, scope, &record);
        };
        const Result<StyleOverride> style =
            style_of_shape(sheet_, of_tag, scope, style_key(tangle_.groups[group], index), choices);
        if (!record.rows.empty()) {
            const std::size_t first = recorder_.choices.size();
            recorder_.append(record);
            picture_.styled.push_back({group, static_cast<std::uint32_t>(index), first, recorder_.choices.size()});
        }
        if (style) return *style;
        if (errors_.empty()) errors_ = style.diagnostics();
        return std::nullopt;
    }

    // The node of a style statement below a shape: GROUP/SHAPE/style#2, and GROUP/style#2 for all of its shapes.
    PresetNode style_node(const Group& group, std::size_t index, std::string_view segment) const {
        if (!group.presets) return {nullptr, {}, group.seed};
        const PresetNode above{group.presets, {}, group.seed};
        const PresetNode shape = node_below(walk_, above, {{}, 0, group.number_of(index)});
        const PresetState below = shape.state ? advance(walk_.presets, shape.state, {segment}) : nullptr;
        return node_in_state(walk_, joined(below, advance(walk_.presets, group.presets, {segment})), shape.seed);
    }

    // What has grown in the shapes of a step, over all that the step itself draws.
    void place_embedded(std::uint32_t number, DrawingPlacer& placer) {
        const Step& step = tangle_.steps[number];
        for (std::size_t i = 0; i < step.embedded.size() && !is_stopped(); ++i) {
            if (!step.embedded[i]) continue;
            Placement placement;
            placement.parent = number + 1;
            placement.path_prefix = path_of_embedded(tangle_, grammar_, number, i);
            placer.place(step.embedded[i]->drawing, placement);
        }
    }

    void draw_leaf(std::uint32_t number) {
        const Group& group = tangle_.groups[number];
        if (group.consumer != none) return;
        for (std::size_t i = 0; i < group.shapes.size() && !is_stopped(); ++i) {
            const Shape& shape = group.shapes[i];
            Style style = base_style(group, shape, number);
            HandStyle by_hand;
            if (colour_by_ == ColourBy::style && !group.hidden) {
                if (const auto over = override_of(number, i)) {
                    apply(*over, style);
                    by_hand = hand_style_of(*over);
                }
            }
            const HandRole role = shape.is_mark ? HandRole::mark : HandRole::face;
            if ((style.fill || style.stroke) && !group.hidden) {
                add_shape(shape, style, role, by_hand);
            } else if (may_be_by_hand_ && !shape.is_mark) {
                hand_shapes_.push_back({shape.geometry, shape.polygon, HandShape::not_drawn, role, {}});
            }
        }
    }

    // The borders of shapes that a step expanded, where a style names their tag.
    void draw_overlay(std::uint32_t step) {
        const std::uint32_t number = tangle_.steps[step].group;
        const Group& group = tangle_.groups[number];
        DrawingGroup& drawn = drawing_.groups[step + 1];
        drawn.first_overlay = shape_count();
        if (is_named_[group.tag] && colour_by_ == ColourBy::style) {
            for (std::size_t i = 0; i < group.shapes.size() && !is_stopped(); ++i) {
                Style style = base_style(group, group.shapes[i], number);
                const auto over = override_of(number, i);
                if (!over || !(over->pen || over->stroke)) continue;
                apply(*over, style);
                style.fill.reset();
                if (style.stroke && style.pen > 0) {
                    const HandRole role = group.shapes[i].is_mark ? HandRole::mark : HandRole::border;
                    add_shape(group.shapes[i], style, role, hand_style_of(*over));
                }
            }
        }
        drawn.end_overlay = shape_count();
    }

    const Tangle& tangle_;
    const Grammar& grammar_;
    StyleSheet sheet_;
    const bool may_be_by_hand_;
    ColourBy colour_by_;
    const Job& job_;
    std::vector<TagStyle> tag_styles_;  // of each tag
    std::vector<bool> is_named_;        // whether a style names it, other than by *
    const PresetWalk walk_;
    StyleTable styles_;
    Drawing drawing_;
    std::vector<HandShape> hand_shapes_;  // what is drawn, and leaves that are not
    Picture picture_;
    ChoiceRecorder recorder_;
    Diagnostics errors_;
};

}  // namespace

Result<Picture> draw(const Tangle& tangle, const Grammar& grammar, const Settings& settings, const Document& document,
                     const DrawOptions& options) {
    Result<StyleSheet> sheet = read_styles(settings, document);
    if (!sheet) return sheet.diagnostics();
    Diagnostics warnings;
    const Canvas canvas = page_canvas(settings, document, bounds(*tangle.geometry[0]), "starts", warnings);
    Result<Picture> picture = Drawer(tangle, grammar, settings, document, std::move(*sheet), options).draw();
    if (!picture) return picture;
    picture->drawing.canvas = canvas;
    return Result<Picture>(std::move(*picture), std::move(warnings));
}

}  // namespace filigree::tangle
