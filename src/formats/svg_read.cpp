#include "formats/svg_read.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "formats/svg_attributes.h"
#include "formats/svg_elements.h"
#include "formats/svg_notes.h"
#include "formats/svg_shapes.h"
#include "formats/svg_style.h"
#include "formats/svg_text.h"
#include "formats/svg_viewport.h"
#include "formats/xml.h"

namespace filigree {
namespace {

constexpr std::size_t most_elements = 1'000'000;
constexpr std::size_t most_points = 50'000'000;
constexpr std::size_t most_rules = 20'000;
// What a small file could blow up: attributes read again through `use`, and names of groups copied to each shape.
constexpr std::size_t most_repeated_bytes = 1U << 28;
constexpr std::size_t most_name_bytes = 1U << 30;
constexpr int most_levels = 200;
constexpr std::size_t most_errors = 50;

bool is_finite(const Transform& t) {
    return std::isfinite(t.a) && std::isfinite(t.b) && std::isfinite(t.c) && std::isfinite(t.d) && std::isfinite(t.e) &&
           std::isfinite(t.f);
}

// Whether all of a path lies on the plane: its points, and the circles that its arcs are pieces of.
bool is_on_plane(const Path& path) {
    std::size_t at = 0;
    for (const Verb verb : path.verbs) {
        switch (verb) {
            case Verb::move:
            case Verb::line:
                if (!is_on_plane(path.points[at])) return false;
                at += 1;
                break;
            case Verb::quadratic:
                if (!is_on_plane(path.points[at]) || !is_on_plane(path.points[at + 1])) return false;
                at += 2;
                break;
            case Verb::cubic:
                for (std::size_t k = 0; k < 3; ++k) {
                    if (!is_on_plane(path.points[at + k])) return false;
                }
                at += 3;
                break;
            case Verb::arc: {
                const Vec radii = path.points[at], to = path.points[at + 2];
                const double reach = 2 * std::max(std::fabs(radii.x), std::fabs(radii.y));
                if (!is_on_plane(Vec{std::fabs(to.x) + reach, std::fabs(to.y) + reach})) return false;
                at += 3;
                break;
            }
            case Verb::close:
                break;
        }
    }
    return true;
}

// What is in force where an element stands.
struct Context {
    Transform transform;
    SvgPaint paint;
    Vec viewport;  // what percentages are of
    int level = 0;
    bool is_svg = true;  // what names without a prefix are
};

class SvgReader {
public:
    SvgReader(const Xml& xml, SvgPurpose purpose) : xml_(xml), purpose_(purpose) {}

    Result<SvgPicture> read() && {
        const pugi::xml_node root = xml_.root();
        if (local_name(root.name()) != "svg" || !names_svg(namespace_of(root))) {
            return error("svg.not-svg",
                         "the root element is '" + std::string(root.name()).substr(0, 60) + "', not 'svg'",
                         xml_.span_of(root));
        }
        gather();
        const Context context = root_context(root);
        if (!is_stopped()) visit_children(root, context);
        if (has_errors(errors_)) return std::move(errors_);
        note_sheets(sheets_.left_out());
        if (purpose_ == SvgPurpose::drawing) note_sheets(sheets_.strokes_left_out());
        return Result<SvgPicture>(std::move(picture_), notes_.warnings());
    }

private:
    // --- before the walk: ids and style sheets, wherever they stand.

    void gather() {
        for (const pugi::xml_node child : xml_.document.children()) {
            if (child.type() == pugi::node_pi && std::string_view(child.name()) == "xml-stylesheet") {
                notes_.note("svg.external-style", "a style sheet outside of this file is not read",
                            xml_.span_of(child));
            }
        }
        pugi::xml_node at = xml_.root();
        while (at) {
            if (at.type() == pugi::node_element) gather_element(at);
            if (at.first_child()) {
                at = at.first_child();
                continue;
            }
            while (at && at != xml_.root() && !at.next_sibling()) at = at.parent();
            at = at && at != xml_.root() ? at.next_sibling() : pugi::xml_node();
        }
        if (sheets_.rule_count() > most_rules) {
            stop("svg.too-many-rules", "the style sheets have more than 20,000 rules", sheet_span_);
        }
    }

    void gather_element(pugi::xml_node element) {
        if (const std::string_view id = element.attribute("id").value(); !id.empty()) by_id_.try_emplace(id, element);
        if (local_name(element.name()) != "style") return;
        const std::string_view type = element.attribute("type").value();
        if (!type.empty() && type != "text/css") return;
        if (sheet_span_.file == SourceSpan::no_file) sheet_span_ = xml_.span_of(element);
        sheets_.add(text_of(element));
    }

    // --- problems

    bool is_stopped() const { return is_stopped_ || errors_.size() >= most_errors; }
    void stop(std::string code, std::string message, SourceSpan span) {
        if (!is_stopped_) errors_.push_back(fault(Fault::limit, std::move(code), std::move(message), span));
        is_stopped_ = true;
    }
    // Moves what the attributes found wrong to the errors; whether there was anything.
    bool take_errors(SvgAttributes& attributes) {
        Diagnostics found = attributes.take_diagnostics();
        const bool any = !found.empty();
        for (Diagnostic& one : found) {
            // A shape that `use` shows a thousand times is wrong once.
            if (std::find(errors_.begin(), errors_.end(), one) == errors_.end()) errors_.push_back(std::move(one));
        }
        return any;
    }
    void refuse(pugi::xml_node element, std::string code, std::string message) {
        Diagnostic one = error(std::move(code), std::move(message), xml_.span_of(element));
        if (std::find(errors_.begin(), errors_.end(), one) == errors_.end()) errors_.push_back(std::move(one));
    }
    void note(pugi::xml_node element, std::string code, std::string what, std::string hint = {}) {
        notes_.note(std::move(code), std::move(what), xml_.span_of(element), std::move(hint));
    }

    // --- viewports

    Context root_context(pugi::xml_node root) {
        SvgAttributes attributes(xml_, root, usual_viewport);
        const std::optional<RootViewport> viewport = root_viewport(attributes);
        take_errors(attributes);
        Context context;
        if (!viewport) {
            is_stopped_ = true;
            return context;
        }
        picture_.origin = viewport->origin;
        picture_.size = viewport->size;
        const CssValues said = values_at(root);
        if (!is_displayed(said)) is_stopped_ = true;
        note_effects(root, said);
        context.transform = viewport->transform;
        context.viewport = viewport->inner_size;
        context.paint = inherited(context.paint, said);
        return context;
    }

    // Inside a nested svg or a symbol; none where it has no room. `use` may say another size than its own.
    std::optional<Context> viewport_context(pugi::xml_node element, Context context, std::optional<double> use_width,
                                            std::optional<double> use_height) {
        SvgAttributes attributes(xml_, element, context.viewport);
        const std::optional<InnerViewport> viewport = inner_viewport(attributes, use_width, use_height);
        if (take_errors(attributes) || !viewport) return std::nullopt;
        context.transform = compose(context.transform, viewport->transform);
        context.viewport = viewport->inner_size;
        return context;
    }

    // --- the walk

    void visit_children(pugi::xml_node parent, const Context& context) {
        for (const pugi::xml_node child : parent.children()) {
            if (is_stopped()) return;
            if (child.type() == pugi::node_element) visit(child, context);
        }
    }

    void visit(pugi::xml_node element, Context context) {
        if (const pugi::xml_attribute said = element.attribute("xmlns")) context.is_svg = names_svg(said.value());
        const bool has_prefix = std::string_view(element.name()).find(':') != std::string_view::npos;
        if (has_prefix ? namespace_of(element) != svg_namespace : !context.is_svg) return;
        if (++element_count_ > most_elements) {
            return stop("svg.too-many-elements", "there are more than 1,000,000 elements", xml_.span_of(element));
        }
        if (++context.level > most_levels) {
            return stop("svg.too-deep", "the elements are nested more than 200 levels deep", xml_.span_of(element));
        }
        if (!use_targets_.empty() && !charge_attributes(element)) return;
        if (!meets_conditions(element)) return;
        const std::string_view name = local_name(element.name());
        if (is_passive(name)) return;
        const CssValues said = values_at(element);
        if (!is_displayed(said)) return;
        context.paint = inherited(context.paint, said);
        if (is_shape_element(name)) {
            note_effects(element, said);
            add_shape(element, context);
        } else if (is_container(name)) {
            note_effects(element, said);
            if (apply_transform(element, context)) visit_group(element, element, context);
        } else if (name == "switch") {
            note_effects(element, said);
            if (apply_transform(element, context)) visit_switch(element, context);
        } else if (name == "svg") {
            note_effects(element, said);
            if (const auto inner = viewport_context(element, context, {}, {})) visit_group(element, element, *inner);
        } else if (name == "use") {
            note_effects(element, said);
            visit_use(element, context);
        } else if (name == "text" && purpose_ == SvgPurpose::drawing) {
            add_label(element, context);
        } else {
            note_left_out(element, name);
        }
    }

    bool apply_transform(pugi::xml_node element, Context& context) {
        SvgAttributes attributes(xml_, element, context.viewport);
        context.transform = compose(context.transform, attributes.transform());
        return !take_errors(attributes);
    }

    // Where what is read stands.
    struct Around {
        std::size_t name_count = 0;
        std::optional<std::size_t> group;
    };
    // What is read until `leave_group`, which wants the answer, stands in this group, too.
    Around enter_group(pugi::xml_node group) {
        const Around before{groups_.size(), group_};
        for (std::string& name : names_of_group(group)) groups_.push_back(std::move(name));
        picture_.groups.push_back({group.attribute("id").value(), group.attribute("inkscape:label").value(),
                                   is_layer(group), group_, xml_.span_of(group)});
        group_ = picture_.groups.size() - 1;
        return before;
    }
    void leave_group(const Around& before) {
        groups_.resize(before.name_count);
        group_ = before.group;
    }

    // The children of `content` within a group that is called as `named` is.
    void visit_group(pugi::xml_node named, pugi::xml_node content, const Context& context) {
        const Around before = enter_group(named);
        visit_children(content, context);
        leave_group(before);
    }

    void visit_switch(pugi::xml_node element, const Context& context) {
        const Around before = enter_group(element);
        for (const pugi::xml_node child : element.children()) {
            if (child.type() != pugi::node_element || !meets_conditions(child)) continue;
            visit(child, context);
            break;
        }
        leave_group(before);
    }

    void visit_use(pugi::xml_node use, Context context) {
        const std::string_view reference = reference_of(use);
        if (reference.empty()) return;
        if (reference[0] != '#') {
            return refuse(use, "svg.external-reference",
                          described(use) + " refers to '" + std::string(reference.substr(0, 80)) +
                              "'; nothing outside of this file is read");
        }
        const auto found = by_id_.find(reference.substr(1));
        if (found == by_id_.end()) {
            return note(use, "svg.no-such-id",
                        "there is no element '" + std::string(reference.substr(1, 80)) + "' to use");
        }
        const pugi::xml_node target = found->second;
        if (std::find(use_targets_.begin(), use_targets_.end(), target) != use_targets_.end() || target == use) {
            return refuse(
                use, "svg.use-cycle",
                described(use) + " shows '" + std::string(reference.substr(1, 80)) + "', of which it is a part itself");
        }
        SvgAttributes attributes(xml_, use, context.viewport);
        const Vec at{attributes.length_or("x", Axis::x, 0), attributes.length_or("y", Axis::y, 0)};
        const std::optional<double> width = attributes.size("width", Axis::x),
                                    height = attributes.size("height", Axis::y);
        context.transform = compose(context.transform, compose(attributes.transform(), translation(at)));
        if (take_errors(attributes)) return;

        const Around before = enter_group(use);
        use_targets_.push_back(target);
        if (const std::string_view name = local_name(target.name()); name == "symbol" || name == "svg") {
            visit_used_viewport(target, context, width, height);
        } else {
            visit(target, context);
        }
        use_targets_.pop_back();
        leave_group(before);
    }

    void visit_used_viewport(pugi::xml_node target, Context context, std::optional<double> width,
                             std::optional<double> height) {
        if (++context.level > most_levels) {
            return stop("svg.too-deep", "the elements are nested more than 200 levels deep", xml_.span_of(target));
        }
        if (!charge_attributes(target)) return;
        const CssValues said = values_at(target);
        if (!is_displayed(said)) return;
        context.paint = inherited(context.paint, said);
        note_effects(target, said);
        if (const auto inner = viewport_context(target, context, width, height)) visit_group(target, target, *inner);
    }

    void add_shape(pugi::xml_node element, Context context) {
        if (!context.paint.visible) return;
        SvgAttributes attributes(xml_, element, context.viewport);
        const Transform transform = compose(context.transform, attributes.transform());
        const Path path = shape_path(attributes);
        if (take_errors(attributes) || path.verbs.empty()) return;
        if (is_finite(transform) && determinant(transform) == 0) return;  // SVG draws nothing then
        SvgShape shape;
        if (is_finite(transform)) shape.path = transform == Transform{} ? path : transformed(path, transform);
        if (!is_finite(transform) || !is_on_plane(shape.path)) return refuse_place(element);
        point_count_ += shape.path.points.size();
        if (!take_names(shape, element)) return;
        shape.fill_rule = context.paint.fill_rule;
        shape.filled = context.paint.filled && local_name(element.name()) != "line";
        const double stroke_width =
            attributes.in_px(context.paint.stroke_width, Axis::both) * std::sqrt(std::fabs(determinant(transform)));
        if (context.paint.stroke && stroke_width > 0 && std::isfinite(stroke_width)) {
            shape.stroke = context.paint.stroke;
            shape.stroke_width = stroke_width;
        }
        picture_.shapes.push_back(std::move(shape));
    }

    void add_label(pugi::xml_node element, const Context& context) {
        if (!context.paint.visible) return;
        SvgText text = read_text(element);
        element_count_ += text.element_count;
        if (!use_targets_.empty() && !charge(element, text.byte_count)) return;
        SvgAttributes own(xml_, element, context.viewport), x(xml_, text.placed_x, context.viewport),
            y(xml_, text.placed_y, context.viewport);
        const Vec place{x.first_length("x", Axis::x).value_or(0), y.first_length("y", Axis::y).value_or(0)};
        SvgLabel label;
        label.place = apply(compose(context.transform, own.transform()), place);
        bool is_wrong = false;
        for (SvgAttributes* const attributes : {&own, &x, &y}) is_wrong = take_errors(*attributes) || is_wrong;
        if (is_wrong || text.content.empty()) return;
        if (!is_on_plane(label.place)) return refuse_place(element);
        if (!take_names(label, element)) return;
        label.text = std::move(text.content);
        picture_.labels.push_back(std::move(label));
    }

    // Says what a shape or a label is called and where it stands; false where there has become too much of it all.
    template <class Named>
    bool take_names(Named& named, pugi::xml_node element) {
        for (const std::string& name : groups_) name_bytes_ += sizeof(std::string) + name.size();
        if (point_count_ > most_points || name_bytes_ > most_name_bytes) {
            stop("svg.too-large", "the shapes have more than 50,000,000 points or too long names",
                 xml_.span_of(element));
            return false;
        }
        named.id = element.attribute("id").value();
        named.label = element.attribute("inkscape:label").value();
        named.groups = groups_;
        named.group = group_;
        return true;
    }

    void refuse_place(pugi::xml_node element) {
        refuse(element, "svg.out-of-range", described(element) + " leaves the plane: coordinates go up to 2^30 px");
    }

    // What an element seen again through `use` costs; false where it has become too much.
    bool charge_attributes(pugi::xml_node element) {
        std::size_t bytes = 0;
        for (const pugi::xml_attribute attribute : element.attributes()) {
            bytes += 1 + std::string_view(attribute.value()).size();
        }
        return charge(element, bytes);
    }
    bool charge(pugi::xml_node element, std::size_t bytes) {
        repeated_bytes_ += bytes;
        if (repeated_bytes_ <= most_repeated_bytes) return true;
        stop("svg.too-large", "the elements that 'use' shows again are too large", xml_.span_of(element));
        return false;
    }

    CssValues values_at(pugi::xml_node element) {
        if (use_targets_.empty()) return sheets_.values_at(element);
        const auto [known, is_new] = values_of_used_.try_emplace(element.internal_object());
        if (is_new) known->second = sheets_.values_at(element);
        return known->second;
    }

    // --- what is left out

    void note_effects(pugi::xml_node element, const CssValues& said) {
        const auto note_where_said = [&](CssProperty property, std::string_view what) {
            const std::string_view value = said[property];
            if (value.empty() || value == "none") return;
            note(element, "svg.effect-left-out", std::string(what) + " is left out: the shapes are taken whole");
        };
        note_where_said(CssProperty::clip_path, "a clip path");
        note_where_said(CssProperty::mask, "a mask");
        note_where_said(CssProperty::filter, "a filter");
        if (const std::string_view value = said[CssProperty::transform]; !value.empty() && value != "none") {
            note(element, "svg.effect-left-out", "a transform in a style is left out",
                 "write it as the attribute 'transform'");
        }
    }

    void note_sheets(const std::vector<std::string>& left_out) {
        for (const std::string& one : left_out) {
            notes_.note("svg.style-left-out", "this part of a style sheet is left out: '" + one + "'", sheet_span_);
        }
    }

    void note_left_out(pugi::xml_node element, std::string_view name) {
        if (is_text(name)) {
            note(element, "svg.text-left-out", "text is left out",
                 "turn it into paths in the program that made the file");
        } else if (is_foreign_content(name)) {
            note(element, "svg.image-left-out", "'" + std::string(name) + "' is left out");
        } else {
            note(element, "svg.unknown-element",
                 "'" + std::string(name.substr(0, 60)) + "' is no element of SVG and left out");
        }
    }

    const Xml& xml_;
    const SvgPurpose purpose_;
    CssSheets sheets_;
    SourceSpan sheet_span_;  // of the first sheet
    std::unordered_map<std::string_view, pugi::xml_node> by_id_;
    std::unordered_map<const void*, CssValues> values_of_used_;

    SvgPicture picture_;
    Diagnostics errors_;
    SvgNotes notes_;
    bool is_stopped_ = false;
    std::size_t element_count_ = 0, point_count_ = 0, repeated_bytes_ = 0, name_bytes_ = 0;
    std::vector<std::string> groups_;          // around the element that is being read, by name
    std::optional<std::size_t> group_;         // the innermost of them
    std::vector<pugi::xml_node> use_targets_;  // that are being shown
};

}  // namespace

Result<SvgPicture> read_svg(std::string_view svg, std::uint32_t file, SvgPurpose purpose) {
    const Result<std::unique_ptr<Xml>> xml = parse_xml(svg, file);
    if (!xml) return xml.diagnostics();
    return SvgReader(**xml, purpose).read();
}

}  // namespace filigree
