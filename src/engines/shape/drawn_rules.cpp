#include "engines/shape/drawn_rules.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <type_traits>
#include <utility>

#include "curves/path_elements.h"
#include "engines/shape/drawn_groups.h"

namespace filigree::shape {
namespace {

void extend(curves::Bounds& bounds, const Path& path) {
    curves::extend(bounds, curves::bounds_of(curves::elements_of(path)));
}
curves::Bounds bounds_of(const DrawnSide& side) {
    curves::Bounds bounds;
    for (const DrawnPath& one : side.paths) extend(bounds, one.path);
    for (const DrawnLabel& label : side.labels) curves::extend(bounds, label.place);
    return bounds;
}
bool is_empty(const DrawnSide& side) { return side.paths.empty() && side.labels.empty(); }

void append_moved(DrawnSide& to, const DrawnSide& from, Vec by) {
    for (const DrawnPath& one : from.paths) {
        to.paths.push_back(one);
        if (by != Vec{}) to.paths.back().path = transformed(one.path, translation(by));
    }
    for (const DrawnLabel& label : from.labels) to.labels.push_back({label.text, label.place + by});
}

// Whether every subpath ends where it began.
bool is_closed(const Path& path) {
    Vec start, here;
    std::size_t at = 0;
    for (const Verb verb : path.verbs) {
        if (verb == Verb::move && here != start) return false;
        at += point_count(verb);
        here = verb == Verb::close ? start : path.points[at - 1];
        if (verb == Verb::move) start = here;
    }
    return here == start;
}

// Where marks say that the origin is.
std::optional<Vec> middle_of(const curves::Bounds& marks) {
    if (marks.min.x > marks.max.x) return std::nullopt;
    return 0.5 * (marks.min + marks.max);
}

// What stands in one coordinate system: a side of a rule, what is beside the sides, a condition, a region.
struct Frame {
    DrawnSide drawn;
    curves::Bounds marks;

    void add_mark(const SvgShape& shape) { extend(marks, shape.path); }
    void add_mark(const SvgLabel& label) { curves::extend(marks, label.place); }
};

// Shapes as they are drawn, in colours where the file has several.
class Pencil {
public:
    Pencil(const SvgPicture& picture, const DrawnOptions& options) : options_(options) {
        std::vector<DrawnRole> roles;
        for (const SvgGroup& group : picture.groups) {
            roles.push_back(role_within(group.parent ? roles[*group.parent] : DrawnRole::plain, role_of(group)));
        }
        std::optional<Colour> first;
        for (const SvgShape& shape : picture.shapes) {
            const DrawnRole role = role_within(shape.group ? roles[*shape.group] : DrawnRole::plain, role_of(shape));
            if (!shape.stroke || (role != DrawnRole::plain && role != DrawnRole::condition)) continue;
            has_colours_ = has_colours_ || (first && *first != *shape.stroke);
            first = shape.stroke;
        }
    }

    void draw(const SvgShape& shape, DrawnSide& on) const {
        DrawnPath one;
        one.path = shape.path;
        if (has_colours_) one.colour = shape.stroke;
        if (options_.widths_are_weights && shape.stroke) one.weight = shape.stroke_width;
        on.paths.push_back(std::move(one));
    }
    void draw(const SvgLabel& label, DrawnSide& on) const { on.labels.push_back({label.text, label.place}); }

private:
    DrawnOptions options_;
    bool has_colours_ = false;
};

// --- what belongs to them

struct Extra {  // a condition or a region
    DrawnRole role = DrawnRole::condition;
    std::size_t around = 0;  // the frame that it stands in
    Frame frame;
};
struct RuleParts {
    std::string name;
    SourceSpan span;
    std::array<Frame, 3> frames;  // beside the sides, left, right
    std::vector<Extra> extras;
};
constexpr std::size_t beside = 0, at_left = 1, at_right = 2;

// Where a group stands.
struct Place {
    std::optional<std::size_t> rule;
    std::size_t frame = beside;
    std::optional<std::size_t> extra;
    DrawnRole role = DrawnRole::plain;
};

class RuleReader {
public:
    RuleReader(const SvgPicture& picture, const DrawnOptions& options, const std::vector<RuleGroups>& rules)
        : pencil_(picture, options), parts_(rules.size()), places_(picture.groups.size()) {
        for (std::size_t r = 0; r < rules.size(); ++r) {
            const SvgGroup& group = picture.groups[rules[r].rule];
            parts_[r].span = group.span;
            parts_[r].name = name_of(group);
            if (parts_[r].name.empty()) parts_[r].name = "rule" + std::to_string(r + 1);
            places_[rules[r].rule].rule = r;
        }
        for (std::size_t g = 0; g < picture.groups.size(); ++g) {
            const auto parent = picture.groups[g].parent;
            if (!parent || !places_[*parent].rule) continue;
            places_[g] = place_within(places_[*parent], role_of(picture.groups[g]));
            const RuleGroups& rule = rules[*places_[g].rule];
            if (g == rule.left) places_[g].frame = at_left;
            if (g == rule.right) places_[g].frame = at_right;
        }
        for (const SvgShape& shape : picture.shapes) add(shape);
        for (const SvgLabel& label : picture.labels) add(label);
    }

    std::vector<RuleParts> take() && { return std::move(parts_); }

private:
    Place place_within(const Place& around, DrawnRole own) {
        Place place = around;
        place.role = role_within(around.role, own);
        if (around.role == DrawnRole::plain &&
            (place.role == DrawnRole::condition || place.role == DrawnRole::region)) {
            std::vector<Extra>& extras = parts_[*place.rule].extras;
            place.extra = extras.size();
            extras.push_back({place.role, place.frame, {}});
        }
        return place;
    }

    template <class Drawn>
    void add(const Drawn& drawn) {
        if (!drawn.group || !places_[*drawn.group].rule) return;
        const Place place = place_within(places_[*drawn.group], role_of(drawn));
        if (place.role == DrawnRole::notes) return;
        RuleParts& rule = parts_[*place.rule];
        Frame& frame = place.extra ? rule.extras[*place.extra].frame : rule.frames[place.frame];
        if (place.role == DrawnRole::origin) return frame.add_mark(drawn);
        const bool is_caption = std::is_same_v<Drawn, SvgLabel> && !place.extra && place.frame == beside;
        if (!is_caption) pencil_.draw(drawn, frame.drawn);
    }

    Pencil pencil_;
    std::vector<RuleParts> parts_;
    std::vector<Place> places_;  // of each group
};

DrawnRule assembled(RuleParts parts, Diagnostics& diagnostics) {
    const std::string named = "the rule '" + parts.name + "'";
    const Frame &both = parts.frames[beside], &left = parts.frames[at_left], &right = parts.frames[at_right];
    const auto origin_of = [&](const Frame& frame) {
        const auto own = middle_of(frame.marks);
        return own ? own : middle_of(both.marks);
    };
    const std::optional<Vec> left_origin = origin_of(left), right_origin = origin_of(right);
    if (left_origin.has_value() != right_origin.has_value()) {
        diagnostics.push_back(error(
            "shape.one-origin",
            "of " + named + " only the " + (left_origin ? "left" : "right") + " side has a mark 'origin'", parts.span));
    }
    const curves::Bounds l = bounds_of(left.drawn), r = bounds_of(right.drawn);
    const bool is_apart = l.max.x < r.min.x || r.max.x < l.min.x || l.max.y < r.min.y || r.max.y < l.min.y;
    if (!left_origin && !right_origin && is_apart && !is_empty(left.drawn) && !is_empty(right.drawn)) {
        diagnostics.push_back(warning("shape.sides-apart",
                                      "the sides of " + named + " lie apart on the page, and so will they be put",
                                      parts.span, {"draw a cross called 'origin' in each side"}));
    }

    DrawnRule rule;
    const Vec to_left = -left_origin.value_or(Vec{}), to_right = -right_origin.value_or(Vec{});
    append_moved(rule.left, both.drawn, to_left);
    append_moved(rule.left, left.drawn, to_left);
    append_moved(rule.right, both.drawn, to_left);
    append_moved(rule.right, right.drawn, to_right);
    if (is_empty(rule.left)) {
        diagnostics.push_back(error("shape.empty-left-side", "the left side of " + named + " is empty", parts.span));
    }
    for (const Extra& extra : parts.extras) {
        const auto own = middle_of(extra.frame.marks);
        DrawnSide moved;
        append_moved(moved, extra.frame.drawn, own ? -*own : extra.around == at_right ? to_right : to_left);
        if (is_empty(moved)) continue;
        if (extra.role == DrawnRole::condition) {
            rule.conditions.push_back(std::move(moved));
            continue;
        }
        for (DrawnPath& one : moved.paths) {
            if (!is_closed(one.path)) {
                diagnostics.push_back(
                    error("shape.open-region", "a void region of " + named + " is no closed path", parts.span));
            }
            rule.regions.push_back(std::move(one.path));
        }
    }
    rule.name = std::move(parts.name);
    rule.span = parts.span;
    return rule;
}

}  // namespace

Result<std::vector<DrawnRule>> drawn_rules(const SvgPicture& picture, const DrawnOptions& options) {
    Diagnostics diagnostics;
    const std::vector<RuleGroups> groups = find_rules(picture.groups, diagnostics);
    std::vector<DrawnRule> rules;
    std::set<std::string> names;
    for (RuleParts& parts : RuleReader(picture, options, groups).take()) {
        if (!names.insert(parts.name).second) {
            diagnostics.push_back(
                error("shape.rule-twice", "there are two rules '" + parts.name + "' in the drawing", parts.span));
        }
        rules.push_back(assembled(std::move(parts), diagnostics));
    }
    if (rules.empty() && !has_errors(diagnostics)) {
        diagnostics.push_back(error("shape.no-drawn-rule", "no group of the drawing is a rule", {},
                                    {"a rule is a group that holds two groups, called 'left' and 'right'"}));
    }
    if (has_errors(diagnostics)) return diagnostics;
    return Result<std::vector<DrawnRule>>(std::move(rules), std::move(diagnostics));
}

Result<DrawnSide> drawn_below(const SvgPicture& picture, std::string_view name, const DrawnOptions& options) {
    const auto is_named = [&](const auto& one) { return one.id == name || one.label == name; };
    std::vector<std::string_view> known;
    const auto know = [&](const auto& one) {
        for (const std::string_view own : {std::string_view(one.label), std::string_view(one.id)}) {
            if (!own.empty()) known.push_back(own);
        }
    };
    const std::optional<DrawnRole> whole = name.empty() ? std::optional(DrawnRole::plain) : std::nullopt;
    std::vector<std::optional<DrawnRole>> roles;  // of each group that is named or in one
    const auto role_below = [&](const auto& one, const std::optional<std::size_t>& around) {
        const std::optional<DrawnRole> outside = around ? roles[*around] : whole;
        if (outside) return std::optional(role_within(*outside, role_of(one)));
        return is_named(one) ? std::optional(DrawnRole::plain) : std::nullopt;
    };
    for (const SvgGroup& group : picture.groups) {
        roles.push_back(role_below(group, group.parent));
        know(group);
    }
    const Pencil pencil(picture, options);
    Frame frame;
    const auto add = [&](const auto& drawn) {
        know(drawn);
        const std::optional<DrawnRole> role = role_below(drawn, drawn.group);
        if (role == DrawnRole::origin) frame.add_mark(drawn);
        if (role == DrawnRole::plain) pencil.draw(drawn, frame.drawn);
    };
    for (const SvgShape& shape : picture.shapes) add(shape);
    for (const SvgLabel& label : picture.labels) add(label);
    if (is_empty(frame.drawn)) {
        if (name.empty()) return error("shape.unknown-id", "the drawing is empty");
        return error("shape.unknown-id", "the drawing has nothing called '" + std::string(name) + "'", {},
                     did_you_mean(name, known));
    }
    DrawnSide side;
    append_moved(side, frame.drawn, -middle_of(frame.marks).value_or(Vec{}));
    return side;
}

}  // namespace filigree::shape
