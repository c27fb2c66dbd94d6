#include "engines/shape/derive.h"

#include <algorithm>

#include "curves/along.h"
#include "engines/shape/doubts.h"
#include "engines/shape/shape_values.h"
#include "language/shape_forms.h"

namespace filigree::shape {
namespace {

using curves::Element;
using curves::Shape;

// Takes elements out of a design and puts others in, with the states that they came with.
void make(Derivation& derivation, const std::vector<Element>& removed, const std::vector<Element>& added,
          const std::vector<std::uint32_t>& added_by) {
    std::vector<Element> elements;
    std::vector<std::uint32_t> made_by;
    elements.reserve(derivation.design.elements.size() + added.size());
    made_by.reserve(elements.capacity());
    std::size_t gone = 0, fresh = 0;
    const auto put_fresh = [&] {
        made_by.push_back(added_by[fresh]);
        elements.push_back(added[fresh++]);
    };
    for (std::size_t i = 0; i < derivation.design.elements.size(); ++i) {
        const Element& e = derivation.design.elements[i];
        if (gone < removed.size() && e == removed[gone]) {
            ++gone;
            continue;
        }
        while (fresh < added.size() && comes_before(added[fresh], e)) put_fresh();
        elements.push_back(e);
        made_by.push_back(derivation.made_by[i]);
    }
    while (fresh < added.size()) put_fresh();
    derivation.design.elements = std::move(elements);
    derivation.made_by = std::move(made_by);
}

// The states that the elements of a change came with, where it becomes that of a step to `state`.
void tell_origins(const Derivation& derivation, double tolerance, std::uint32_t state, Step& step) {
    const std::vector<Element>& all = derivation.design.elements;
    for (const Element& e : step.change.removed) {
        const auto place = std::lower_bound(all.begin(), all.end(), e, curves::comes_before) - all.begin();
        step.removed_by.push_back(derivation.made_by[static_cast<std::size_t>(place)]);
    }
    for (const Element& e : step.change.added) {
        std::uint32_t origin = state;
        for (std::size_t r = 0; r < step.change.removed.size() && origin == state; ++r) {
            if (misfit(step.change.removed[r], e, 2 * tolerance)) origin = step.removed_by[r];
        }
        step.added_by.push_back(origin);
    }
}

// Runs what a document says, with its presets in hand.
class Deriver {
public:
    Deriver(const Grammar& grammar, const Surroundings& around, const DeriveOptions& options, const Job& job)
        : grammar_(grammar),
          around_(around),
          options_(options),
          job_(job),
          walk_(begin_walk(options.site, around.document, around.settings.globals, around.settings.seed)),
          derivation_(begin(grammar)),
          seen_(seen_design(grammar, derivation_)) {
        recorder_.append(around.settings.definitions);
        derivation_.end_definition_choice = recorder_.choices.size();
        derivation_.met.resize(walk_.presets.all.size());
    }

    Result<Derivation> run() {
        const std::uint64_t by_hand = static_cast<std::uint64_t>(
            std::count_if(grammar_.by_hand.begin(), grammar_.by_hand.end(),
                          [](const auto& one) { return std::holds_alternative<ApplyAt>(one); }));
        const std::uint64_t count =
            options_.by_hand_alone ? by_hand : options_.steps.value_or(by_hand + grammar_.steps);
        for (const auto& one : grammar_.by_hand) {
            if (options_.steps && derivation_.steps.size() >= count) break;
            std::optional<Diagnostic> problem;
            if (const auto* apply = std::get_if<ApplyAt>(&one)) {
                problem = apply_by_hand(*apply);
            } else {
                return_to(std::get<BackTo>(one));
            }
            if (problem) return std::move(*problem);
        }
        for (std::uint32_t number = 1; derivation_.steps.size() < count; ++number) {
            report(job_, "derive", static_cast<double>(derivation_.steps.size()) / static_cast<double>(count));
            if (is_cancelled(job_)) return cancelled_diagnostic();
            const Result<bool> went_on = step_by_machine(number);
            if (!went_on) return went_on.diagnostics();
            if (!*went_on) break;
        }
        derivation_.choices = std::move(recorder_.choices);
        Diagnostics warnings;
        if (auto doubt = warning_of(derivation_.ambiguities, around_.document, {})) {
            warnings.push_back(*std::move(doubt));
        }
        return {std::move(derivation_), std::move(warnings)};
    }

private:
    Key step_key(std::uint64_t number) const { return child(rooted(options_.site, Key{hash_text("step")}), number); }

    void return_to(const BackTo& back) {
        std::uint32_t state = 0;
        for (std::uint32_t s = 0; s < derivation_.steps.size(); ++s) {
            if (derivation_.steps[s].name == back.name) state = s + 1;
        }
        go_to(derivation_, state);
        seen_ = seen_design(grammar_, derivation_);
    }

    std::optional<Diagnostic> apply_by_hand(const ApplyAt& wanted) {
        const Result<Applications> found = applications_of(grammar_, wanted.rule, seen_, around_, job_);
        if (!found) return found.diagnostics().front();
        const Result<Application> at = application_at(grammar_, *found, wanted, around_);
        if (!at) return at.diagnostics().front();
        std::vector<Application> all = {*at};
        if (wanted.is_orbit) all = orbit_of(*at, *found, grammar_, derivation_.design);
        const std::string segment = "apply";
        PresetNode node = node_below(walk_, walk_.root, {segment, ++by_hand_, 0});
        const Key key = child(rooted(options_.site, Key{hash_text("apply")}), by_hand_);
        ChoiceBuffer record;
        std::optional<Diagnostic> problem = take(std::move(all), node, key, record);
        if (problem) return problem;
        derivation_.steps.back().by_hand = by_hand_;
        derivation_.steps.back().by = wanted.span;
        derivation_.steps.back().name = wanted.name;
        return std::nullopt;
    }

    Result<bool> step_by_machine(std::uint32_t number) {
        const Key key = step_key(number);
        const PresetNode node = node_below(walk_, walk_.root, {"step", number, 0});
        ChoiceBuffer record;
        Result<std::optional<NextStep>> next = draw_step(grammar_, seen_, walk_, node, key, around_, job_, record);
        if (!next) return next.diagnostics();
        if (!*next) {
            derivation_.is_finished = true;
            return false;
        }
        std::optional<Diagnostic> problem = take(std::move((*next)->at), node, key, record);
        if (problem) return std::move(*problem);
        derivation_.steps.back().number = number;
        return true;
    }

    // Applies a rule; the choices of its right side are made below the step's node.
    std::optional<Diagnostic> take(std::vector<Application> at, const PresetNode& node, Key key, ChoiceBuffer& record) {
        const Rule& rule = grammar_.rules[at[0].rule];
        const PresetNode below = node_below(walk_, node, {rule.name});
        for (const PresetNode* met : {&node, &below}) {
            for (const std::uint32_t preset : met->accepted) derivation_.met[preset] = 1;
        }
        std::vector<Shape> puts;
        Result<StepChoices> choices = choices_at(walk_, below, around_.settings.globals, &record);
        if (!choices) return choices.diagnostics().front();
        for (std::uint32_t i = 0; i < at.size(); ++i) {
            Result<Shape> put = put_by(grammar_, at[i], i, child(key, rule.name), around_, *choices);
            if (!put) return put.diagnostics().front();
            puts.push_back(std::move(*put));
        }
        const std::uint64_t most = around_.settings.limits.elements;
        Step& step = apply_rule(derivation_, grammar_, std::move(at), puts);
        seen_.follow(step.change);
        step.first_choice = recorder_.choices.size();
        recorder_.append(record);
        step.end_choice = recorder_.choices.size();
        if (derivation_.design.elements.size() > most) {
            return fault(Fault::limit, "limit.elements",
                         "the design has more than " + std::to_string(most) + " elements after step " +
                             std::to_string(derivation_.steps.size()) + ", by the rule '" + rule.name + "'",
                         rule.span);
        }
        return std::nullopt;
    }

    const Grammar& grammar_;
    const Surroundings& around_;
    const DeriveOptions& options_;
    const Job& job_;
    PresetWalk walk_;
    ChoiceRecorder recorder_;
    Derivation derivation_;
    SeenDesign seen_;  // where the derivation stands
    std::uint32_t by_hand_ = 0;
};

}  // namespace

Derivation begin(const Grammar& grammar) {
    Derivation derivation;
    derivation.design = grammar.start;
    derivation.made_by.assign(grammar.start.elements.size(), 0);
    return derivation;
}

std::vector<std::uint32_t> way_to(const Derivation& derivation, std::uint32_t state) {
    std::vector<std::uint32_t> way = {state};
    while (way.back() != 0) way.push_back(derivation.steps[way.back() - 1].before);
    std::reverse(way.begin(), way.end());
    return way;
}

void go_to(Derivation& derivation, std::uint32_t state) {
    const std::vector<std::uint32_t> from = way_to(derivation, derivation.state), to = way_to(derivation, state);
    const auto [fork, other] = std::mismatch(from.begin(), from.end(), to.begin(), to.end());
    for (auto back = from.end(); back != fork; --back) {
        const Step& step = derivation.steps[*(back - 1) - 1];
        make(derivation, step.change.added, step.change.removed, step.removed_by);
    }
    for (auto next = other; next != to.end(); ++next) {
        const Step& step = derivation.steps[*next - 1];
        make(derivation, step.change.removed, step.change.added, step.added_by);
    }
    derivation.state = state;
}

Result<Shape> put_by(const Grammar& grammar, const Application& at, std::uint32_t number, Key step,
                     const Surroundings& around, const StepChoices& choices) {
    const Rule& rule = grammar.rules[at.rule];
    const auto placed_on_plane = [&](const Shape& right) -> Result<Shape> {
        const auto leaves = [&](const Element& e) { return !is_on_plane(transformed(e, at.fit.by)); };
        if (std::any_of(right.elements.begin(), right.elements.end(), leaves)) {
            return fault(Fault::limit, "limit.plane",
                         "the rule '" + rule.name + "' leads beyond the plane, which ends 2^30 px from the origin",
                         rule.span);
        }
        return placed(right, rule, at, grammar.tolerance);
    };
    if (rule.right_side == nullptr) return placed_on_plane(rule.right);
    Evaluation evaluation;
    evaluation.document = &around.document;
    evaluation.scope = &around.settings.globals;
    evaluation.site.key = number == 0 ? step : child(step, number);
    evaluation.site.name = "right";
    const Result<Value> value = evaluate_with(choices, "right", *rule.right_side, with_shapes(evaluation));
    if (!value) return value.diagnostics();
    const Result<Shape> right = shape_of(*value, {around.document, around.files, grammar.tolerance});
    if (!right) return right.diagnostics();
    return placed_on_plane(*right);
}

SeenDesign seen_design(const Grammar& grammar, const Derivation& derivation) {
    return {grammar, derivation.design, static_cast<std::uint32_t>(way_to(derivation, derivation.state).size() - 1)};
}

Step& apply_rule(Derivation& derivation, const Grammar& grammar, std::vector<Application> at,
                 const std::vector<Shape>& puts) {
    std::vector<Element> taken, put;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const Rule& rule = grammar.rules[at[i].rule];
        const std::vector<Element> covered =
            at[i].covered.empty() ? placed(rule.left, rule, at[i], grammar.tolerance).elements : at[i].covered;
        taken.insert(taken.end(), covered.begin(), covered.end());
        put.insert(put.end(), puts[i].elements.begin(), puts[i].elements.end());
    }
    Step step;
    step.before = derivation.state;
    step.rule = at[0].rule;
    step.change = change_by(derivation.design, merged(std::move(taken), grammar.tolerance),
                            merged(std::move(put), grammar.tolerance), grammar.tolerance, &derivation.ambiguities);
    step.applied = std::move(at);
    const auto state = static_cast<std::uint32_t>(derivation.steps.size() + 1);
    tell_origins(derivation, grammar.tolerance, state, step);
    make(derivation, step.change.removed, step.change.added, step.added_by);
    derivation.steps.push_back(std::move(step));
    derivation.state = state;
    return derivation.steps.back();
}

Result<Derivation> derive(const Grammar& grammar, const Surroundings& around, const DeriveOptions& options,
                          const Job& job) {
    return Deriver(grammar, around, options, job).run();
}

}  // namespace filigree::shape
