#include "engines/tangle/derive.h"

#include <algorithm>
#include <map>

#include "engines/tangle/draw_rule.h"
#include "engines/tangle/embed_step.h"
#include "engines/tangle/reuse.h"
#include "engines/tangle/scopes.h"

namespace filigree::tangle {
namespace {

constexpr std::size_t wave_size = 256;  // groups expanded between two commits

// What each(...) may know of every shape.
std::vector<ShapeContext> shape_contexts(const Tangle& tangle, const Group& group, Key step, const Scope& outer) {
    std::vector<ShapeContext> contexts(group.shapes.size());
    for (std::size_t i = 0; i < contexts.size(); ++i) {
        const Shape& shape = group.shapes[i];
        contexts[i].key = Key{fold(step.value, shape.key.value)};
        contexts[i].scope = shape_scope(tangle, shape, group.number_of(i));
        contexts[i].scope.outer = &outer;
    }
    return contexts;
}

bool has_per_shape_arguments(const Rule& rule) {
    return std::any_of(rule.call.expressions.begin(), rule.call.expressions.end(),
                       [](const ExpressionPtr& expression) { return expression && varies_by_shape(*expression); });
}

bool same_arguments(const Arguments& a, const Arguments& b) {
    return a.values.size() == b.values.size() && std::equal(a.values.begin(), a.values.end(), b.values.begin(),
                                                            [](const ArgumentValue& x, const ArgumentValue& y) {
                                                                return x.common == y.common &&
                                                                       x.per_shape == y.per_shape;
                                                            });
}

// What became of one group of a wave.
struct Expansion {
    bool terminal = true;
    std::uint32_t taken_over = none;  // a step of the earlier derivation that holds as a whole,
    bool leaf_taken_over = false;     // likewise that there is none
    std::uint32_t reused = none;      // or whose result alone does
    std::uint32_t rule = 0;
    Key key;
    std::uint32_t scatter = 0;
    PresetNode node;  // of the step
    Arguments arguments;
    OperatorOutput output;
    std::vector<std::shared_ptr<const Embedded>> embedded;
    ChoiceBuffer choices;
    Diagnostics errors;
};

class Deriver {
public:
    Deriver(const Grammar& grammar, const PlaneStart& start, const Settings& settings, const Document& document,
            const DeriveOptions& options, Executor& executor)
        : grammar_(grammar),
          settings_(settings),
          document_(document),
          options_(options),
          executor_(executor),
          element_limit_(std::min(settings.limits.elements, options.element_budget.value_or(UINT64_MAX))),
          walk_(begin_walk(options.site, document, settings.globals, settings.seed)),
          reads_(std::make_shared<Reads>(
              reads_of(grammar, start, settings, document, walk_, options.shapes->fingerprint()))),
          previous_(options.previous, *reads_) {
        for (const Rule& rule : grammar.rules) per_shape_.push_back(has_per_shape_arguments(rule));
        tangle_.met.resize(walk_.presets.all.size());
        tangle_.reads = reads_;
        find_applied_rules();
        begin(start);
    }

    Result<Tangle> run(const Job& job) {
        std::size_t next = 0;
        while (next < tangle_.groups.size()) {
            if (options_.steps && tangle_.steps.size() >= *options_.steps) break;
            if (is_cancelled(job)) return cancelled_diagnostic();
            const std::size_t end = std::min(tangle_.groups.size(), next + wave_size);
            std::vector<Expansion> wave(end - next);
            if (end - next >= 2 * executor_.width()) {
                executor_.run(wave.size(), [&](std::size_t i) { wave[i] = expand(next + i, serial_); });
            } else {
                for (std::size_t i = 0; i < wave.size(); ++i) wave[i] = expand(next + i, executor_);
            }
            for (std::size_t i = 0; i < wave.size(); ++i, ++next) {
                if (wave[i].terminal) {
                    keep_leaf_choices(static_cast<std::uint32_t>(next), wave[i]);
                    continue;
                }
                if (options_.steps && tangle_.steps.size() >= *options_.steps) return finished();
                if (!wave[i].errors.empty()) return wave[i].errors;
                if (auto stop = commit(static_cast<std::uint32_t>(next), std::move(wave[i]))) return *stop;
            }
            report(job, "derive", -1);
        }
        return finished();
    }

private:
    Tangle finished() {
        tangle_.is_prefix = options_.steps.has_value();
        tangle_.choices = std::move(recorder_.choices);
        return std::move(tangle_);
    }

    void find_applied_rules() {
        std::size_t number = 0;
        for (std::uint32_t s = 0; s < document_.statements.size(); ++s) {
            if (!std::holds_alternative<ApplyStatement>(document_.statements[s].node)) continue;
            applied_rules_[s] = grammar_.applied[number++];
        }
    }

    void begin(const PlaneStart& start) {
        recorder_.append(settings_.definitions);
        tangle_.end_definition_choice = recorder_.choices.size();
        recorder_.append(start.choices);
        tangle_.end_start_choice = recorder_.choices.size();
        for (const std::uint32_t preset : start.met) tangle_.met[preset] = 1;
        meet(node_below(walk_, walk_.root, {"let"}), nullptr);
        for (const auto& [name, value] : settings_.globals.names) meet(definition_node(walk_, name), nullptr);

        tangle_.geometry.push_back(std::make_shared<const Polygons>(start.polygons));
        geometry_now_.assign(1, 0);
        for (std::size_t g = 0; g < start.groups.size(); ++g) {
            const StartGroup& from = start.groups[g];
            Group group;
            group.tag = grammar_.find_tag(from.tag);
            group.key = from.key;
            for (const StartShape& shape : from.shapes) {
                Shape first;
                first.key = shape.key;
                first.polygon = shape.polygon;
                group.shapes.push_back(first);
            }
            const Tangle* old = previous_.tangle();
            const bool is_same = previous_.has_same_start() && g < old->start_groups && !is_parted(*old, g);
            add_group(std::move(group), walk_.root, is_same ? static_cast<std::uint32_t>(g) : none);
        }
        tangle_.start_groups = static_cast<std::uint32_t>(tangle_.groups.size());
    }

    // Whether single shapes were picked out of a group, or it is such a shape.
    static bool is_parted(const Tangle& tangle, std::size_t group) {
        return tangle.groups[group].picked != 0 || !tangle.groups[group].numbers.empty();
    }

    // --- presets ---

    // Notes which presets have met a node: what may stand behind the dot there is in `parameters`, in a step.
    void meet(const PresetNode& node, const OperatorDescription* step) {
        for (const std::uint32_t i : node.accepted) {
            const Preset& preset = walk_.presets.all[i];
            const std::string& parameter = preset.path->parameter;
            const bool anywhere = parameter.empty() || parameter == "is_random";
            const bool of_group = step == nullptr && parameter == "rule";
            const bool of_step = step != nullptr && (parameter == "when" || parameter == "weight" ||
                                                     parameter == "scatter" || has_parameter(*step, parameter));
            if (preset.kind != PresetKind::apply && (anywhere || of_group || of_step)) tangle_.met[i] = 1;
        }
    }
    static bool has_parameter(const OperatorDescription& description, std::string_view name) {
        return std::any_of(description.parameters.begin(), description.parameters.end(),
                           [&](const ParameterDescription& parameter) { return parameter.name == name; });
    }

    // The `apply` that goes first among those that name this node; none where there is none.
    std::optional<std::uint32_t> applied_preset(std::span<const std::uint32_t> accepted) const {
        for (const std::uint32_t i : accepted) {
            const Preset& preset = walk_.presets.all[i];
            if (preset.kind == PresetKind::apply && preset.document == &document_) return i;
        }
        return std::nullopt;
    }

    PresetNode node_of(const Group& group) const {
        PresetNode node{group.presets, {}, group.seed};
        if (group.presets) node.accepted = accepted(walk_.presets, group.presets);
        return node;
    }

    PresetNode step_node(const PresetNode& group, const Rule& rule) const {
        if (!group.state && rule.name.empty()) return {nullptr, {}, group.seed};
        PresetState state = group.state ? advance(walk_.presets, group.state, {rule.segment}) : nullptr;
        if (!rule.name.empty()) state = enter_named(walk_.presets, state, rule.name, own_level());
        return node_in_state(walk_, std::move(state), group.seed);
    }

    std::uint32_t own_level() const { return static_cast<std::uint32_t>(walk_.presets.trees.size() - 1); }

    // What paths with the numbers of shapes say of a step.
    std::vector<ShapeChoices> shape_choices(const Group& group, const Rule& rule) const {
        std::vector<ShapeChoices> choices;
        if (!may_pick_shapes(walk_.presets, group.presets)) return choices;
        for (std::size_t i = 0; i < group.shapes.size(); ++i) {
            const PresetState shape = advance(walk_.presets, group.presets, {{}, 0, group.number_of(i)});
            if (!shape) continue;
            std::vector<std::uint32_t> above = accepted(walk_.presets, shape);
            std::vector<std::uint32_t> found = accepted(walk_.presets, advance(walk_.presets, shape, {rule.segment}));
            if (found.empty() && above.empty()) continue;
            choices.push_back({static_cast<std::uint32_t>(i), std::move(found), std::move(above)});
        }
        return choices;
    }

    // --- one step ---

    // The group of the earlier derivation that has the same shapes, or none.
    std::uint32_t same_group(std::size_t number) const { return same_[number]; }

    bool is_whole_reusable(std::size_t number, std::uint32_t old_number) const {
        const Group& group = tangle_.groups[number];
        const Group& old = previous_.tangle()->groups[old_number];
        if (!same_seed(group.seed, old.seed) || group.hidden != old.hidden) return false;
        if (!previous_.has_same_rules(group.tag, old.tag)) return false;
        if (!previous_.has_same_presets(group.presets, old.presets)) return false;
        // A prefix of a derivation does not know what would have become of its last groups.
        return old.consumer != none ? can_take_over(old.consumer) : !previous_.tangle()->is_prefix;
    }
    // A step out of whose results single shapes were picked is run again.
    bool can_take_over(std::uint32_t old_step) const {
        const Tangle& old = *previous_.tangle();
        const Step& step = old.steps[old_step];
        // What presets have met inside is noted by their numbers.
        if (!step.embedded.empty() && reads_->presets != old.reads->presets) return false;
        std::uint64_t shapes = 0;
        for (std::uint32_t g = step.first_output; g < step.end_output; ++g) {
            if (is_parted(old, g)) return false;
            shapes += old.groups[g].shapes.size();
        }
        return elements_ + shapes <= element_limit_;
    }

    const Scope& outer_scope(const Group& group) const {
        return group.environment == none ? settings_.globals : *environments_.find(group.environment)->second;
    }

    // A preset of a document around this one stands in a text that places of this one cannot mean.
    void name_outer_presets(Diagnostics& reasons) const {
        for (Diagnostic& reason : reasons) {
            for (const Preset& preset : walk_.presets.all) {
                const bool is_inside = preset.document != &document_ && reason.span.file == preset.span.file &&
                                       reason.span.begin >= preset.span.begin && reason.span.end <= preset.span.end;
                if (!is_inside || !preset.value) continue;
                reason.span = {};
                reason.hints.push_back("it is said by the preset of " + to_text(*preset.path));
                break;
            }
        }
    }

    Expansion expand(std::size_t number, Executor& executor) const {
        Expansion expansion = expanded(number, executor);
        if (!expansion.errors.empty() && options_.site.is_embedded) name_outer_presets(expansion.errors);
        return expansion;
    }

    Expansion expanded(std::size_t number, Executor& executor) const {
        const Group& group = tangle_.groups[number];
        Expansion expansion;
        const std::uint32_t old_group = same_group(number);
        if (old_group != none && is_whole_reusable(number, old_group)) {
            expansion.taken_over = previous_.tangle()->groups[old_group].consumer;
            expansion.terminal = expansion.leaf_taken_over = expansion.taken_over == none;
            return expansion;
        }
        const std::vector<std::uint32_t>& matching = grammar_.rules_of_tag[group.tag];
        const PresetNode node = node_of(group);
        const auto applied = applied_preset(node.accepted);
        if (!applied && (matching.empty() || group.hidden)) return expansion;

        const Scope scope = step_scope(tangle_, static_cast<std::uint32_t>(number), outer_scope(group));
        std::optional<std::uint32_t> rule;
        if (applied) {
            rule = applied_rules_.find(walk_.presets.all[*applied].statement)->second;
        } else {
            auto drawn = draw_rule({grammar_, document_, walk_, group.key, node, matching, scope}, expansion.choices);
            expansion.errors = drawn.diagnostics();
            if (drawn) rule = *drawn;
        }
        expansion.terminal = !rule && expansion.errors.empty();
        if (rule) run_step(group, node, *rule, scope, old_group, executor, expansion);
        return expansion;
    }

    void run_step(const Group& group, const PresetNode& node, std::uint32_t number, const Scope& scope,
                  std::uint32_t old_group, Executor& executor, Expansion& expansion) const {
        const Rule& rule = grammar_.rules[number];
        expansion.rule = number;
        expansion.key = child(group.key, rule.key.value);
        expansion.node = step_node(node, rule);
        Result<StepChoices> choices = choices_at(walk_, expansion.node, scope, &expansion.choices);
        if (!choices) {
            expansion.errors = choices.diagnostics();
            return;
        }
        const std::vector<ShapeChoices> of_shapes = shape_choices(group, rule);
        choices->shapes = of_shapes;
        std::vector<ShapeContext> contexts;
        if (per_shape_[number] || !of_shapes.empty() || presets_vary_by_shape(rule.call, *choices))
            contexts = shape_contexts(tangle_, group, expansion.key, scope);
        Result<Arguments> arguments =
            evaluate_arguments(rule.call, document_, scope, *choices, expansion.key, contexts);
        if (!arguments) {
            expansion.errors = arguments.diagnostics();
            return;
        }
        expansion.arguments = std::move(*arguments);
        if (scatters(*rule.op, expansion.arguments)) {
            const Result<std::uint32_t> scatter = draw_scatter(*choices, expansion.key, scope);
            if (!scatter) {
                expansion.errors = scatter.diagnostics();
                return;
            }
            expansion.scatter = *scatter;
        }
        switch (rule.kind) {
            case RuleKind::operation:
                if (old_group != none && has_same_result(old_group, rule, expansion)) {
                    expansion.reused = previous_.tangle()->groups[old_group].consumer;
                } else {
                    run_operator(group, rule, executor, expansion);
                }
                return;
            case RuleKind::macro:
                expansion.output.groups.push_back({0, 0, group.shapes});
                return;
            case RuleKind::embed:
                run_embedding(group, rule, executor, expansion);
                return;
        }
    }

    bool has_same_result(std::uint32_t old_group, const Rule& rule, const Expansion& expansion) const {
        const Tangle& old = *previous_.tangle();
        const std::uint32_t old_step = old.groups[old_group].consumer;
        if (old_step == none || !can_take_over(old_step)) return false;
        const Step& step = old.steps[old_step];
        return step.op == rule.op && step.key == expansion.key && step.scatter == expansion.scatter &&
               reads_->common == old.reads->common && same_arguments(step.arguments, expansion.arguments);
    }

    std::uint64_t element_budget() const { return element_limit_ - std::min(element_limit_, elements_); }

    void run_operator(const Group& group, const Rule& rule, Executor& executor, Expansion& expansion) const {
        Result<OperatorOutput> output =
            rule.op->run({tangle_, group.shapes, expansion.arguments, expansion.scatter, expansion.key,
                          settings_.resolution, element_budget(), executor, *options_.shapes});
        if (output) {
            expansion.output = std::move(*output);
            return;
        }
        expansion.errors = output.diagnostics();
        for (Diagnostic& reason : expansion.errors) {
            if (reason.span.file == SourceSpan::no_file) reason.span = rule.span;
        }
    }

    void run_embedding(const Group& group, const Rule& rule, Executor& executor, Expansion& expansion) const {
        expansion.output.groups.push_back({0, 0, group.shapes});
        EmbedStep step{tangle_,         group,          rule,  expansion.arguments,
                       expansion.key,   expansion.node, walk_, options_.site.depth,
                       element_budget()};
        auto embedded = embed_step(step, options_.embed, executor);
        if (!embedded) {
            expansion.errors = embedded.diagnostics();
            for (Diagnostic& reason : expansion.errors) {
                if (reason.span.file == SourceSpan::no_file) reason.span = rule.span;
            }
        } else {
            expansion.embedded = std::move(*embedded);
        }
    }

    // --- committing ---

    // Adds the step and its groups; a diagnostic where that would pass a limit.
    std::optional<Diagnostic> commit(std::uint32_t number, Expansion expansion) {
        const Tangle* old = previous_.tangle();
        const bool is_taken_over = expansion.taken_over != none;
        Step step;
        if (is_taken_over) {
            const Step& from = old->steps[expansion.taken_over];
            const std::uint32_t rule = rule_now(number, from);
            expansion.rule = rule;
            expansion.node = step_node(node_of(tangle_.groups[number]), grammar_.rules[rule]);
            step.key = from.key;
            step.scatter = from.scatter;
            step.arguments = from.arguments;
            step.arguments.description = &grammar_.rules[rule].op->description;
            step.embedded = from.embedded;
        } else {
            step.key = expansion.key;
            step.scatter = expansion.scatter;
            step.arguments = std::move(expansion.arguments);
            step.embedded = std::move(expansion.embedded);
        }
        const Rule& rule = grammar_.rules[expansion.rule];
        step.rule = expansion.rule;
        step.op = rule.op;
        step.group = number;
        step.first_output = static_cast<std::uint32_t>(tangle_.groups.size());
        step.first_choice = recorder_.choices.size();
        const auto step_number = static_cast<std::uint32_t>(tangle_.steps.size());
        const std::uint32_t depth = tangle_.groups[number].depth + 1;
        if (depth > settings_.limits.depth) return limit_reached(rule, "depth", settings_.limits.depth, "steps deep");

        if (is_taken_over) {
            const Step& from = old->steps[expansion.taken_over];
            recorder_.append(old->choices, from.first_choice, from.end_choice);
        } else {
            recorder_.append(expansion.choices);
        }
        step.end_choice = recorder_.choices.size();
        meet(expansion.node, &rule.op->description);
        for (const ShapeChoices& of_shape : shape_choices(tangle_.groups[number], rule)) {
            meet({nullptr, of_shape.accepted, {}}, &rule.op->description);
        }
        if (const auto applied = applied_preset(node_of(tangle_.groups[number]).accepted)) tangle_.met[*applied] = 1;

        const std::uint32_t source = is_taken_over ? expansion.taken_over : expansion.reused;
        if (rule.kind == RuleKind::macro) enter_macro(step_number, step, tangle_.groups[number], rule);
        if (source != none) {
            take_groups(source, step, step_number, depth, rule, expansion.node);
        } else {
            add_groups(std::move(expansion.output), step, step_number, depth, rule, expansion.node);
        }
        for (const auto& embedded : step.embedded) {
            if (!embedded) continue;
            elements_ += embedded->elements;
            memory_ += embedded->memory_bytes;
            for (std::size_t i = 0; i < embedded->met.size() && i < tangle_.met.size(); ++i) {
                if (embedded->met[i] != 0) tangle_.met[i] = 1;
            }
        }
        step.end_output = static_cast<std::uint32_t>(tangle_.groups.size());
        memory_ += sizeof(Step) + step.arguments.values.capacity() * sizeof(ArgumentValue);
        tangle_.groups[number].consumer = step_number;
        tangle_.steps.push_back(std::move(step));
        if (elements_ > element_limit_) {
            return limit_reached(rule, "elements", element_limit_, "shapes");
        }
        if (memory_ > settings_.limits.memory_bytes) {
            return limit_reached(rule, "memory", settings_.limits.memory_bytes, "bytes");
        }
        return std::nullopt;
    }

    // What was drawn for a group that stays a leaf, as in `when 0..1 < 0.5`.
    void keep_leaf_choices(std::uint32_t number, const Expansion& expansion) {
        const std::size_t first = recorder_.choices.size();
        const std::uint32_t old_number = same_group(number);
        if (!expansion.choices.rows.empty()) {
            recorder_.append(expansion.choices);
        } else if (old_number != none && expansion.leaf_taken_over) {
            const std::vector<LeafChoices>& old = previous_.tangle()->leaf_choices;
            const auto found =
                std::lower_bound(old.begin(), old.end(), old_number,
                                 [](const LeafChoices& leaf, std::uint32_t group) { return leaf.group < group; });
            if (found == old.end() || found->group != old_number) return;
            recorder_.append(previous_.tangle()->choices, found->first_choice, found->end_choice);
        }
        if (recorder_.choices.size() == first) return;
        tangle_.leaf_choices.push_back({number, first, recorder_.choices.size()});
    }

    // The rule of a step that is taken over, among the rules as they are numbered now.
    std::uint32_t rule_now(std::uint32_t group, const Step& old) const {
        if (const auto applied = applied_preset(node_of(tangle_.groups[group]).accepted)) {
            return applied_rules_.find(walk_.presets.all[*applied].statement)->second;
        }
        for (const std::uint32_t r : grammar_.rules_of_tag[tangle_.groups[group].tag]) {
            if (child(tangle_.groups[group].key, grammar_.rules[r].key.value) == old.key) return r;
        }
        return 0;  // the group has the same rules as before, so one has made the step
    }

    // The parameters of a macro become names for the rules in it.
    void enter_macro(std::uint32_t number, const Step& step, const Group& group, const Rule& rule) {
        auto scope = std::make_unique<Scope>(outer_scope(group));
        for (std::size_t i = 0; i < step.arguments.values.size(); ++i) {
            scope->names[std::string(rule.op->description.parameters[i].name)] = step.arguments.values[i].at(0);
        }
        environments_[number] = std::move(scope);
    }

    // The environment of what comes out of a step.
    std::uint32_t environment_behind(std::uint32_t step, const Group& group, const Rule& rule,
                                     std::uint32_t port) const {
        if (rule.kind == RuleKind::macro) return step;
        std::uint32_t environment = group.environment;
        for (std::uint32_t i = 0; i < rule.outputs[port].leaves && environment != none; ++i) {
            environment = tangle_.groups[tangle_.steps[environment].group].environment;
        }
        return environment;
    }

    void add_groups(OperatorOutput output, Step& step, std::uint32_t number, std::uint32_t depth, const Rule& rule,
                    const PresetNode& node) {
        if (!output.geometry.empty()) {
            output.geometry.points.shrink_to_fit();
            add_geometry(step, std::make_shared<const Polygons>(std::move(output.geometry)));
        }
        std::vector<std::uint32_t> ordinals(std::max<std::size_t>(1, rule.op->description.ports.size()), 0);
        for (OutputGroup& made : output.groups) {
            const std::uint32_t ordinal = ++ordinals[made.port];
            if (made.shapes.empty()) continue;
            Group group = output_group(step, number, depth, rule, made.port);
            group.key = Key{fold(fold(step.key.value, made.port), made.local_key)};
            group.ordinal = rule.op->description.regroups ? ordinal : 0;
            group.shapes = std::move(made.shapes);
            for (Shape& shape : group.shapes) {
                if (shape.geometry == none) shape.geometry = step.geometry;
            }
            add_group(std::move(group), node, none);
        }
    }

    // The groups of a step of the earlier derivation, with their geometry.
    void take_groups(std::uint32_t old_step, Step& step, std::uint32_t number, std::uint32_t depth, const Rule& rule,
                     const PresetNode& node) {
        const Tangle& old = *previous_.tangle();
        const Step& from = old.steps[old_step];
        if (from.geometry != none) {
            add_geometry(step, old.geometry[from.geometry]);
            if (geometry_now_.size() <= from.geometry) geometry_now_.resize(old.geometry.size(), none);
            geometry_now_[from.geometry] = step.geometry;
        }
        for (std::uint32_t g = from.first_output; g < from.end_output; ++g) {
            const Group& before = old.groups[g];
            Group group = output_group(step, number, depth, rule, before.port);
            group.key = before.key;
            group.ordinal = before.ordinal;
            group.shapes = before.shapes;
            for (Shape& shape : group.shapes) shape.geometry = geometry_now_[shape.geometry];
            add_group(std::move(group), node, g);
        }
    }

    void add_geometry(Step& step, std::shared_ptr<const Polygons> geometry) {
        memory_ += geometry->memory_bytes();
        step.geometry = static_cast<std::uint32_t>(tangle_.geometry.size());
        tangle_.geometry.push_back(std::move(geometry));
    }

    Group output_group(const Step& step, std::uint32_t number, std::uint32_t depth, const Rule& rule,
                       std::uint32_t port) const {
        Group group;
        group.tag = rule.outputs[port].tag;
        group.hidden = rule.outputs[port].hidden;
        group.producer = number;
        group.port = port;
        group.depth = depth;
        group.environment = environment_behind(number, tangle_.groups[step.group], rule, port);
        return group;
    }

    // `old`: the group of the earlier derivation with the same shapes, or none.
    void add_group(Group group, const PresetNode& above, std::uint32_t old) {
        const std::string_view tag = group.hidden ? std::string_view("_") : grammar_.tags[group.tag];
        PresetNode node = node_below(walk_, above, {tag, group.ordinal});
        meet(node, nullptr);
        group.seed = node.seed;
        if (may_pick_shapes(walk_.presets, node.state) && pick_shapes(group, node)) old = none;
        group.presets = std::move(node.state);
        if (group.shapes.empty()) return;
        push(std::move(group), old);
    }

    void push(Group group, std::uint32_t old) {
        elements_ += group.shapes.size();
        memory_ += group.shapes.capacity() * sizeof(Shape) + sizeof(Group);
        tangle_.groups.push_back(std::move(group));
        same_.push_back(old);
    }

    // Makes a group of its own of every shape that an `apply` names; whether there was one.
    bool pick_shapes(Group& group, const PresetNode& node) {
        std::vector<Shape> rest;
        std::vector<std::uint32_t> numbers;
        for (std::size_t i = 0; i < group.shapes.size(); ++i) {
            const auto number = static_cast<std::uint32_t>(i + 1);
            PresetNode shape_node = node_below(walk_, node, {{}, 0, number});
            meet(shape_node, nullptr);
            if (!applied_preset(shape_node.accepted)) {
                rest.push_back(group.shapes[i]);
                numbers.push_back(number);
                continue;
            }
            Group picked = group;
            picked.shapes.assign(1, group.shapes[i]);
            picked.key = child(group.key, group.shapes[i].key.value);
            picked.picked = number;
            picked.seed = shape_node.seed;
            picked.presets = std::move(shape_node.state);
            push(std::move(picked), none);
        }
        if (rest.size() == group.shapes.size()) return false;
        group.shapes = std::move(rest);
        group.numbers = std::move(numbers);
        return true;
    }

    static Diagnostic limit_reached(const Rule& rule, const char* name, std::uint64_t limit, const char* unit) {
        Diagnostic reason = fault(Fault::limit, std::string("limit.") + name,
                                  "the limit of " + std::to_string(limit) + " " + unit + " is reached here", rule.span);
        reason.hints.push_back(std::string("`limit ") + name + " ...` in the document raises it");
        return reason;
    }

    const Grammar& grammar_;
    const Settings& settings_;
    const Document& document_;
    const DeriveOptions& options_;
    Executor& executor_;
    const std::uint64_t element_limit_;
    mutable SerialExecutor serial_;
    const PresetWalk walk_;
    const std::shared_ptr<const Reads> reads_;
    const Previous previous_;
    std::vector<bool> per_shape_;                           // of each rule: whether an argument varies by shape
    std::map<std::uint32_t, std::uint32_t> applied_rules_;  // of `apply` statements, by their number
    Tangle tangle_;
    ChoiceRecorder recorder_;
    std::vector<std::uint32_t> same_;          // of each group: the one of the earlier derivation, or none
    std::vector<std::uint32_t> geometry_now_;  // of each geometry of the earlier derivation that is taken over
    std::map<std::uint32_t, std::unique_ptr<const Scope>> environments_;  // of each macro step: its parameters
    std::uint64_t elements_ = 0;
    std::uint64_t memory_ = 0;
};

}  // namespace

Result<Tangle> derive(const Grammar& grammar, const PlaneStart& start, const Settings& settings,
                      const Document& document, const DeriveOptions& options, Executor& executor, const Job& job) {
    return Deriver(grammar, start, settings, document, options, executor).run(job);
}

}  // namespace filigree::tangle
