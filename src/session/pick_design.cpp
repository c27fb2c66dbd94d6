#include "session/pick_design.h"

#include "curves/nearest.h"
#include "engines/shape/paths.h"
#include "session/list_matches.h"
#include "session/list_steps.h"

namespace filigree {
namespace {

constexpr double reach = 3;  // px on the page

}  // namespace

std::optional<Picked> pick_element(const OpenedDocument& opened, const CheckedDocument& checked, const DesignRun& run,
                                   Key root, const std::string& prefix, Vec at) {
    const shape::Grammar& grammar = *checked.design;
    const std::vector<curves::Element>& elements = run.derivation.design.elements;
    const Vec place = at * (1 / run.scale);
    std::size_t nearest = elements.size();
    double least = reach / run.scale;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const curves::Bounds box = bounds_of(elements[i]);
        const bool is_far = place.x < box.min.x - least || place.x > box.max.x + least || place.y < box.min.y - least ||
                            place.y > box.max.y + least;
        if (is_far) continue;
        if (const double distance = foot_on(elements[i], place).distance; distance <= least) {
            least = distance;
            nearest = i;
        }
    }
    if (nearest == elements.size()) return std::nullopt;
    const std::uint32_t state = run.derivation.made_by[nearest];
    Picked picked;
    picked.path = prefix + shape::path_of_state(run.derivation, grammar, state);
    picked.tag = state == 0 ? grammar.start_tag : grammar.rules[run.derivation.steps[state - 1].rule].name;
    picked.key = child(child(root, "state"), state);
    if (state == 0) return picked;
    const shape::Step& step = run.derivation.steps[state - 1];
    const shape::Rule& rule = grammar.rules[step.rule];
    for (const shape::Application& one : step.applied) {
        PickedStep made;
        made.path = picked.path;
        made.document = opened.name;
        made.rule = rule.name;
        made.operation = apply_text(opened, checked, {}, one, false);
        made.line = line_of(opened.document, step.number > 0 ? rule.span : step.by);
        made.key = picked.key;
        picked.steps.push_back(std::move(made));
    }
    return picked;
}

}  // namespace filigree
