#include "engines/tangle/derive.h"

#include <algorithm>

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
        contexts[i].scope = shape_scope(tangle, shape, i);
        contexts[i].scope.outer = &outer;
    }
    return contexts;
}

bool has_per_shape_arguments(const Rule& rule) {
    return std::any_of(rule.call.expressions.begin(), rule.call.expressions.end(),
                       [](const ExpressionPtr& expression) { return expression && varies_by_shape(*expression); });
}

// What became of one group of a wave.
struct Expansion {
    bool terminal = true;
    std::uint32_t rule = 0;
    Key key;
    Arguments arguments;
    OperatorOutput output;
    Diagnostics errors;
};

class Deriver {
public:
    Deriver(const Grammar& grammar, const Settings& settings, const Document& document, Executor& executor)
        : grammar_(grammar), settings_(settings), document_(document), executor_(executor) {
        for (const Rule& rule : grammar.rules) per_shape_.push_back(has_per_shape_arguments(rule));
    }

    void begin(const PlaneStart& start) {
        tangle_.geometry.push_back(std::make_shared<const Polygons>(start.polygons));
        for (const StartGroup& from : start.groups) {
            Group group;
            group.tag = grammar_.find_tag(from.tag);
            group.key = from.key;
            for (const StartShape& shape : from.shapes) {
                Shape first;
                first.key = shape.key;
                first.polygon = shape.polygon;
                group.shapes.push_back(first);
            }
            elements_ += group.shapes.size();
            tangle_.groups.push_back(std::move(group));
        }
        tangle_.start_groups = static_cast<std::uint32_t>(tangle_.groups.size());
    }

    Result<Tangle> run(const DeriveOptions& options, const Job& job) {
        std::size_t next = 0;
        while (next < tangle_.groups.size()) {
            if (options.steps && tangle_.steps.size() >= *options.steps) break;
            if (is_cancelled(job)) return cancelled_diagnostic();
            const std::size_t end = std::min(tangle_.groups.size(), next + wave_size);
            std::vector<Expansion> wave(end - next);
            if (end - next >= 2 * executor_.width()) {
                executor_.run(wave.size(), [&](std::size_t i) { wave[i] = expand(next + i, serial_); });
            } else {
                for (std::size_t i = 0; i < wave.size(); ++i) wave[i] = expand(next + i, executor_);
            }
            for (std::size_t i = 0; i < wave.size(); ++i, ++next) {
                if (wave[i].terminal) continue;
                if (options.steps && tangle_.steps.size() >= *options.steps) return std::move(tangle_);
                if (!wave[i].errors.empty()) return wave[i].errors;
                if (auto stop = commit(static_cast<std::uint32_t>(next), std::move(wave[i]))) return *stop;
            }
            report(job, "derive", -1);
        }
        return std::move(tangle_);
    }

private:
    Expansion expand(std::size_t number, Executor& executor) const {
        const Group& group = tangle_.groups[number];
        Expansion expansion;
        const std::vector<std::uint32_t>& matching = grammar_.rules_of_tag[group.tag];
        if (matching.empty() || group.hidden) return expansion;
        const Scope scope = step_scope(tangle_, static_cast<std::uint32_t>(number), settings_.globals);
        const std::optional<std::uint32_t> rule = draw_rule(group, matching, scope, expansion.errors);
        expansion.terminal = !rule && expansion.errors.empty();
        if (!rule) return expansion;

        expansion.rule = *rule;
        expansion.key = child(group.key, grammar_.rules[*rule].key.value);
        std::vector<ShapeContext> contexts;
        if (per_shape_[*rule]) contexts = shape_contexts(tangle_, group, expansion.key, scope);
        Result<Arguments> arguments =
            evaluate_arguments(grammar_.rules[*rule].call, document_, scope, settings_.seed, expansion.key, contexts);
        if (!arguments) {
            expansion.errors = arguments.diagnostics();
            return expansion;
        }
        expansion.arguments = std::move(*arguments);
        const std::uint64_t budget = settings_.limits.elements - std::min(settings_.limits.elements, elements_);
        Result<OperatorOutput> output =
            grammar_.rules[*rule].op->run({tangle_, group.shapes, expansion.arguments, settings_.seed, expansion.key,
                                           settings_.resolution, budget, executor});
        if (!output) {
            expansion.errors = output.diagnostics();
            for (Diagnostic& reason : expansion.errors) {
                if (reason.span.file == SourceSpan::no_file) reason.span = grammar_.rules[*rule].span;
            }
        } else {
            expansion.output = std::move(*output);
        }
        return expansion;
    }

    // The race among the rules whose condition holds; none where the group is terminal.
    std::optional<std::uint32_t> draw_rule(const Group& group, const std::vector<std::uint32_t>& matching,
                                           const Scope& scope, Diagnostics& errors) const {
        std::vector<Key> keys;
        std::vector<double> weights;
        std::vector<std::uint32_t> candidates;
        for (const std::uint32_t r : matching) {
            const Rule& rule = grammar_.rules[r];
            const auto value_of = [&](const ExpressionPtr& expression, const char* name) {
                Evaluation at;
                at.document = &document_;
                at.scope = &scope;
                at.site = {settings_.seed, child(group.key, rule.key.value), name};
                return evaluate(*expression, at);
            };
            if (rule.condition) {
                const Result<Value> value = value_of(rule.condition, "when");
                const Result<bool> holds = value ? as_flag(*value) : Result<bool>(value.diagnostics());
                append(errors, holds.diagnostics());
                if (!holds || !*holds) continue;
            }
            double weight = 1;
            if (rule.weight) {
                const Result<Value> value = value_of(rule.weight, "weight");
                const Result<double> number = value ? as_number(*value) : Result<double>(value.diagnostics());
                append(errors, number.diagnostics());
                if (!number) continue;
                weight = *number;
                if (weight < 0) {
                    errors.push_back(
                        error("tangle.negative-weight", "a weight must not be below 0", rule.weight->span));
                    continue;
                }
            }
            candidates.push_back(r);
            keys.push_back(rule.key);
            weights.push_back(weight);
        }
        if (!errors.empty() || candidates.empty()) return std::nullopt;
        const std::size_t winner = race(settings_.seed, group.key, "rule", keys, weights);
        if (winner == candidates.size()) return std::nullopt;
        return candidates[winner];
    }

    // Adds the step and its groups; a diagnostic where that would pass a limit.
    std::optional<Diagnostic> commit(std::uint32_t number, Expansion expansion) {
        const Rule& rule = grammar_.rules[expansion.rule];
        Step step;
        step.key = expansion.key;
        step.rule = expansion.rule;
        step.group = number;
        step.arguments = std::move(expansion.arguments);
        step.first_output = static_cast<std::uint32_t>(tangle_.groups.size());
        const auto step_number = static_cast<std::uint32_t>(tangle_.steps.size());
        const std::uint32_t depth = tangle_.groups[number].depth + 1;
        const auto geometry = static_cast<std::uint32_t>(tangle_.geometry.size());
        if (depth > settings_.limits.depth) return limit_reached(rule, "depth", settings_.limits.depth, "steps deep");
        if (!expansion.output.geometry.empty()) {
            expansion.output.geometry.points.shrink_to_fit();
            memory_ += expansion.output.geometry.memory_bytes();
            tangle_.geometry.push_back(std::make_shared<const Polygons>(std::move(expansion.output.geometry)));
        }

        std::vector<std::uint32_t> ordinals(rule.op->description.ports.size(), 0);
        for (OutputGroup& output : expansion.output.groups) {
            const std::uint32_t ordinal = ++ordinals[output.port];
            if (output.shapes.empty()) continue;
            Group group;
            group.tag = rule.outputs[output.port].tag;
            group.hidden = rule.outputs[output.port].hidden;
            group.key = Key{fold(fold(step.key.value, output.port), output.local_key)};
            group.producer = step_number;
            group.port = output.port;
            group.ordinal = rule.op->description.regroups ? ordinal : 0;
            group.depth = depth;
            group.shapes = std::move(output.shapes);
            for (Shape& shape : group.shapes) {
                if (shape.geometry == none) shape.geometry = geometry;
            }
            elements_ += group.shapes.size();
            memory_ += group.shapes.capacity() * sizeof(Shape) + sizeof(Group);
            tangle_.groups.push_back(std::move(group));
        }
        step.end_output = static_cast<std::uint32_t>(tangle_.groups.size());
        memory_ += sizeof(Step) + step.arguments.values.capacity() * sizeof(ArgumentValue);
        tangle_.groups[number].consumer = step_number;
        tangle_.steps.push_back(std::move(step));
        if (elements_ > settings_.limits.elements) {
            return limit_reached(rule, "elements", settings_.limits.elements, "shapes");
        }
        if (memory_ > settings_.limits.memory_bytes) {
            return limit_reached(rule, "memory", settings_.limits.memory_bytes, "bytes");
        }
        return std::nullopt;
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
    Executor& executor_;
    mutable SerialExecutor serial_;
    std::vector<bool> per_shape_;  // of each rule: whether an argument varies by shape
    Tangle tangle_;
    std::uint64_t elements_ = 0;
    std::uint64_t memory_ = 0;
};

}  // namespace

Result<Tangle> derive(const Grammar& grammar, const PlaneStart& start, const Settings& settings,
                      const Document& document, const DeriveOptions& options, Executor& executor, const Job& job) {
    Deriver deriver(grammar, settings, document, executor);
    deriver.begin(start);
    return deriver.run(options, job);
}

std::string segment_of_group(const Tangle& tangle, const Grammar& grammar, std::uint32_t group) {
    const Group& here = tangle.groups[group];
    std::string segment = here.hidden ? "_" : grammar.tags[here.tag];
    if (here.ordinal != 0) segment += "[" + std::to_string(here.ordinal) + "]";
    return segment;
}

std::string path_of_group(const Tangle& tangle, const Grammar& grammar, std::uint32_t group) {
    std::string path;
    for (std::uint32_t at = group; at != none;) {
        const Group& here = tangle.groups[at];
        const std::string segment = segment_of_group(tangle, grammar, at);
        if (here.producer == none) return segment + path;
        const Step& step = tangle.steps[here.producer];
        path = "/" + grammar.rules[step.rule].segment + "/" + segment + path;
        at = step.group;
    }
    return path;
}

std::string path_of_step(const Tangle& tangle, const Grammar& grammar, std::uint32_t step) {
    return path_of_group(tangle, grammar, tangle.steps[step].group) + "/" +
           grammar.rules[tangle.steps[step].rule].segment;
}

}  // namespace filigree::tangle
