#include "session/pick.h"

#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "engines/tangle/paths.h"
#include "session/embed.h"
#include "session/list_steps.h"
#include "session/pick_design.h"
#include "session/pick_symbol.h"

namespace filigree {
namespace {

using tangle::none;
using tangle::Tangle;

// A tangle with what its parts are asked about.
struct Layer {
    const OpenedDocument& opened;
    const CheckedDocument& checked;
    const Tangle& tangle;
    std::string prefix;  // of paths
};

struct Hit {
    std::uint32_t group = none;
    std::size_t shape = 0;
};

// The leaf that is painted last over a point: groups are painted in the order of the steps that made them, children
// over their parents; marks lie over what they mark.
Hit leaf_at(const Tangle& tangle, Point at) {
    Hit hit;
    bool is_mark = false;
    for (std::uint32_t g = 0; g < tangle.groups.size(); ++g) {
        const tangle::Group& group = tangle.groups[g];
        if (group.consumer != none || group.hidden) continue;
        for (std::size_t i = 0; i < group.shapes.size(); ++i) {
            const tangle::Shape& shape = group.shapes[i];
            if (hit.group != none && is_mark && !shape.is_mark) continue;
            const PolygonView polygon = tangle.polygon(shape);
            const Box box = bounds(polygon);
            if (at.x < box.min.x || at.y < box.min.y || at.x > box.max.x || at.y > box.max.y) continue;
            if (locate(polygon, at) < 0) continue;
            hit = {g, i};
            is_mark = shape.is_mark;
        }
    }
    return hit;
}

// Which shape of a group lies over a place: what a step makes of a shape lies in that, all but marks on its border.
std::optional<std::size_t> shape_at(const Tangle& tangle, const tangle::Group& group, Point at) {
    for (std::size_t i = group.shapes.size(); i-- > 0;) {
        if (locate(tangle.polygon(group.shapes[i]), at) >= 0) return i;
    }
    return std::nullopt;
}

// An argument that every shape has its own of is that of the shape at the place; it is left out where none is there.
PickedStep picked_step(const Layer& layer, std::uint32_t number, Point at) {
    const tangle::Step& step = layer.tangle.steps[number];
    const std::optional<std::size_t> shape = shape_at(layer.tangle, layer.tangle.groups[step.group], at);
    const tangle::Rule& rule = layer.checked.grammar->rules[step.rule];
    PickedStep picked;
    picked.path = layer.prefix + tangle::path_of_step(layer.tangle, *layer.checked.grammar, number);
    picked.document = layer.opened.name;
    picked.rule = rule.segment;
    picked.operation = std::string(rule.op->description.name);
    picked.line = line_of(layer.opened.document, rule.span);
    picked.key = step.key;
    for (std::size_t i = 0; i < step.arguments.values.size(); ++i) {
        const ArgumentValue& argument = step.arguments.values[i];
        if (!argument.per_shape.empty() && !shape) continue;
        const std::string text = text_with_unit(argument.at(shape.value_or(0)));
        if (text == tangle::not_given) continue;
        picked.arguments.emplace_back(std::string(step.arguments.description->parameters[i].name), text);
    }
    if (scatters(*rule.op, step.arguments))
        picked.arguments.emplace_back("scatter", to_text(std::uint64_t{step.scatter}));
    return picked;
}

// The steps behind a group of one tangle, innermost first.
void add_chain(const Layer& layer, std::uint32_t group, Point place, std::vector<PickedStep>& steps) {
    for (std::uint32_t at = group; layer.tangle.groups[at].producer != none;) {
        const std::uint32_t step = layer.tangle.groups[at].producer;
        steps.push_back(picked_step(layer, step, place));
        at = layer.tangle.steps[step].group;
    }
}

std::optional<Picked> pick_in(const Layer& layer, Vec at);

// In what grows in a shape; `at` is in the host's coordinates.
std::optional<Picked> pick_inside(const Embedded& embedded, const std::string& prefix, Vec at) {
    if (const EmbeddedTangle* inner = tangle_in(embedded)) {
        return pick_in({*inner->opened, *inner->checked, inner->tangle, prefix}, apply(inverse(inner->to_host), at));
    }
    if (const EmbeddedDesign* inner = design_in(embedded)) {
        return pick_element(*inner->opened, *inner->checked, inner->design, inner->root, prefix,
                            apply(inverse(inner->to_host), at));
    }
    const EmbeddedWord& inner = *word_in(embedded);
    return pick_symbol(*inner.opened, *inner.checked, inner.word, {inner.root, prefix},
                       apply(inverse(inner.to_host), at));
}

std::optional<Picked> pick_in(const Layer& layer, Vec at) {
    const Point point = snap(at);
    const Hit hit = leaf_at(layer.tangle, point);
    if (hit.group == none) return std::nullopt;
    const tangle::Group& group = layer.tangle.groups[hit.group];
    const tangle::Shape& shape = group.shapes[hit.shape];
    // What grows in the shape lies over it.
    if (group.producer != none) {
        const tangle::Step& step = layer.tangle.steps[group.producer];
        if (hit.shape < step.embedded.size() && step.embedded[hit.shape]) {
            const std::string prefix =
                layer.prefix +
                tangle::path_of_embedded(layer.tangle, *layer.checked.grammar, group.producer, hit.shape) + "/";
            if (auto picked = pick_inside(*step.embedded[hit.shape], prefix, at)) {
                add_chain(layer, hit.group, point, picked->steps);
                return picked;
            }
        }
    }
    Picked picked;
    picked.path = layer.prefix + tangle::path_of_group(layer.tangle, *layer.checked.grammar, hit.group);
    if (group.shapes.size() > 1 || !group.numbers.empty()) {
        picked.path += "/" + std::to_string(group.number_of(hit.shape));
    }
    picked.tag = layer.checked.grammar->tags[group.tag];
    picked.key = shape.key;
    picked.area = area(layer.tangle.polygon(shape));
    add_chain(layer, hit.group, point, picked.steps);
    return picked;
}

// The same in all copies of a motif; later ones lie over earlier ones (scene/repeat.h).
std::optional<Picked> pick_in_copies(const Layer& motif, const Symmetry& symmetry, Vec at) {
    const Box box = bounds(*motif.tangle.geometry[0]);
    const Vec tile = to_px(symmetry.tile());
    // The whole tiles by which a stretch from low to high comes to lie over a place, the farthest first.
    const auto tiles = [](double place, double low, double high, double side) {
        if (!(side > 0)) return std::pair<std::int64_t, std::int64_t>{0, 0};
        return std::pair{static_cast<std::int64_t>(std::floor((place - low) / side)),
                         static_cast<std::int64_t>(std::ceil((place - high) / side))};
    };
    for (std::uint32_t operation = symmetry.operation_count(); operation-- > 0;) {
        const Transform to_copy = symmetry.transform({operation, 0, 0});
        Vec low{1e300, 1e300}, high{-1e300, -1e300};
        for (const Point corner : {box.min, box.max, Point{box.min.x, box.max.y}, Point{box.max.x, box.min.y}}) {
            const Vec image = apply(to_copy, to_px(corner));
            low = {std::min(low.x, image.x), std::min(low.y, image.y)};
            high = {std::max(high.x, image.x), std::max(high.y, image.y)};
        }
        const auto [last_row, first_row] = tiles(at.y, low.y, high.y, tile.y);
        const auto [last_column, first_column] = tiles(at.x, low.x, high.x, tile.x);
        for (std::int64_t row = last_row; row >= first_row; --row) {
            for (std::int64_t column = last_column; column >= first_column; --column) {
                const Transform copy = symmetry.transform({operation, column, row});
                if (auto picked = pick_in(motif, apply(inverse(copy), at))) return picked;
            }
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<Picked> pick(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run, Vec at) {
    if (run.word) return pick_symbol(opened, checked, *run.word, {}, at);
    if (run.design) return pick_element(opened, checked, *run.design, {}, {}, at);
    const Layer whole{opened, checked, run.tangle, ""};
    if (checked.start->symmetry) return pick_in_copies(whole, *checked.start->symmetry, at);
    return pick_in(whole, at);
}

std::string picked_text(const Picked& picked) {
    std::string text = picked.path + "  (" + to_text(picked.area) + " px2, key " + to_hex(picked.key.value) + ")\n";
    for (const PickedStep& step : picked.steps) {
        text += "  made by " + step.path + "  (" + step.document + ", line " + std::to_string(step.line) + ")\n";
        text += "    " + step.operation;
        for (std::size_t i = 0; i < step.arguments.size(); ++i) {
            text += (i == 0 ? "(" : ", ") + step.arguments[i].first + ": " + step.arguments[i].second;
        }
        text += step.arguments.empty() ? "\n" : ")\n";
    }
    if (picked.steps.empty()) text += "  nothing made it: it stands at the beginning\n";
    return text;
}

std::string picked_json(const Picked& picked) {
    using Json = nlohmann::ordered_json;
    Json json;
    json["path"] = picked.path;
    json["tag"] = picked.tag;
    json["key"] = to_hex(picked.key.value);
    json["area"] = picked.area;
    json["steps"] = Json::array();
    for (const PickedStep& step : picked.steps) {
        Json one;
        one["path"] = step.path;
        one["document"] = step.document;
        one["rule"] = step.rule;
        one["operator"] = step.operation;
        one["line"] = step.line;
        one["key"] = to_hex(step.key.value);
        one["arguments"] = Json::object();
        for (const auto& [name, value] : step.arguments) one["arguments"][name] = value;
        json["steps"].push_back(std::move(one));
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace filigree
