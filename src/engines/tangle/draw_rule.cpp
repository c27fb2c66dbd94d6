#include "engines/tangle/draw_rule.h"

#include <algorithm>
#include <string>
#include <vector>

#include "language/walk.h"

namespace filigree::tangle {
namespace {

struct Runner {
    std::uint32_t rule = 0;
    double weight = 1;
};

class RuleDrawer {
public:
    RuleDrawer(const RuleDraw& draw, ChoiceBuffer& record) : draw_(draw), record_(record) {}

    Result<std::optional<std::uint32_t>> run() {
        Result<StepChoices> choices = choices_at(draw_.walk, draw_.node, draw_.scope, &record_);
        if (!choices) return choices.diagnostics();
        if (!draw_.node.accepted.empty()) {
            Result<std::optional<Preset>> preset = deciding_preset(*choices);
            if (!preset) return preset.diagnostics();
            if (*preset) return by_preset(**preset, *choices);
        }
        return race_of(all_runners(), *choices, ChoiceSource::drawn);
    }

private:
    const Rule& rule(std::uint32_t index) const { return draw_.grammar.rules[index]; }

    Evaluation evaluation() const {
        Evaluation at;
        at.document = &draw_.document;
        at.scope = &draw_.scope;
        at.site.key = draw_.group;
        at.site.name = "rule";
        at.words = {"*"};
        return at;
    }

    // The preset of `rule` that counts here.
    Result<std::optional<Preset>> deciding_preset(const StepChoices& choices) {
        ChoiceBuffer decisions;
        StepChoices recording = choices;
        recording.record = &decisions;
        Result<std::optional<DecidedValue>> decided = decide(recording, "rule", nullptr, evaluation());
        if (!decided && recording.replay != nullptr) {
            // What was recorded is the winner of the race below, which need not be one of those that are named here.
            decisions = {};
            recording.replay = nullptr;
            decided = decide(recording, "rule", nullptr, evaluation());
        }
        if (!decided) return decided.diagnostics();
        std::optional<Preset> preset;
        if (*decided) {
            value_ = (*decided)->value;
            preset = *(*decided)->preset;
        }
        // Of several rules that it names, the race below draws one; all else that was chosen for it stands.
        const bool is_raced = preset && is_one_of(*preset);
        for (const ChoiceBuffer::Row& row : decisions.rows) {
            const ChoiceBuffer::Place& place = decisions.places[row.place];
            const bool is_value = place.name == "rule" || place.name.rfind("rule~", 0) == 0;
            if (is_raced && is_value) continue;
            record(record_, place.text, place.name, place.domain, row.key, row.value, row.source);
        }
        return preset;
    }
    static bool is_one_of(const Preset& preset) {
        const auto* call = std::get_if<CallExpression>(&preset.value->node);
        return call != nullptr && call->name == "one_of";
    }

    Result<std::optional<std::uint32_t>> by_preset(const Preset& preset, const StepChoices& choices) {
        const ChoiceSource source = preset.kind == PresetKind::set ? ChoiceSource::set : ChoiceSource::fallback;
        if (!is_one_of(preset)) {
            const std::optional<Runner> only = runner_named(value_, preset);
            if (!errors_.empty()) return errors_;
            if (is_elsewhere_) return race_of(all_runners(), choices, ChoiceSource::drawn);
            return only ? std::optional(only->rule) : std::nullopt;
        }
        // Those that are named race as they would among all: with their own conditions and weights.
        std::vector<Runner> runners;
        for (const WeightedExpression& one : candidates_of(std::get<CallExpression>(preset.value->node))) {
            Evaluation at = evaluation();
            at.document = preset.document;
            const Result<Value> name = evaluate(*one.candidate, at);
            if (!name) return name.diagnostics();
            const std::optional<Runner> runner = runner_named(*name, preset);
            if (!errors_.empty()) return errors_;
            if (!runner) continue;
            const std::optional<Runner> running = with_weight(runner->rule, one.weight, preset.document, source);
            if (running) runners.push_back(*running);
        }
        if (runners.empty() && is_elsewhere_) return race_of(all_runners(), choices, ChoiceSource::drawn);
        return race_of(std::move(runners), choices, source);
    }

    // A path such as `**.rule` may name a rule that only other tags have.
    static bool leaves_tag_open(const ChoicePath& path) {
        return std::any_of(path.segments.begin(), path.segments.end(), [](const PathSegment& segment) {
            return segment.kind == PathSegment::Kind::any || segment.kind == PathSegment::Kind::any_depth;
        });
    }

    // The rule that a preset names; none for the word `none`.
    std::optional<Runner> runner_named(const Value& value, const Preset& preset) {
        const std::string name = plain_text(value);
        for (const std::uint32_t r : draw_.matching) {
            if (rule(r).segment == name) return Runner{r, 1};
        }
        if (name == "none") return std::nullopt;
        if (leaves_tag_open(*preset.path)) {
            is_elsewhere_ = true;
            return std::nullopt;
        }
        std::vector<std::string_view> known;
        for (const std::uint32_t r : draw_.matching) known.push_back(rule(r).segment);
        std::vector<std::string> hints = did_you_mean(name, known);
        if (hints.empty() && !known.empty()) hints.push_back("one of them is '" + std::string(known.front()) + "'");
        errors_.push_back(error("preset.unknown-rule", "there is no rule '" + name + "' for this tag",
                                preset.value->span, std::move(hints)));
        return std::nullopt;
    }

    std::vector<Runner> all_runners() {
        std::vector<Runner> runners;
        for (const std::uint32_t r : draw_.matching) {
            const auto runner = with_weight(r, nullptr, &draw_.document, ChoiceSource::drawn);
            if (runner) runners.push_back(*runner);
        }
        return runners;
    }

    // A rule whose condition holds, with its weight, or the given one.
    std::optional<Runner> with_weight(std::uint32_t index, const Expression* given, const Document* given_in,
                                      ChoiceSource source) {
        const Rule& candidate = rule(index);
        Runner runner{index, 1};
        if (!candidate.condition && !candidate.weight && given == nullptr) return runner;
        PresetNode node = node_below(draw_.walk, draw_.node, {candidate.segment});
        const Result<StepChoices> choices = choices_at(draw_.walk, node, draw_.scope, &record_);
        if (!choices) return failed(choices.diagnostics());
        const auto value_of = [&](const ExpressionPtr& expression, const char* name) {
            Evaluation at;
            at.document = &draw_.document;
            at.scope = &draw_.scope;
            at.site.key = child(draw_.group, candidate.key.value);
            at.site.name = name;
            return evaluate_with(*choices, name, *expression, at);
        };
        if (candidate.condition) {
            const Result<Value> value = value_of(candidate.condition, "when");
            const Result<bool> holds = value ? as_flag(*value) : Result<bool>(value.diagnostics());
            if (!holds) return failed(holds.diagnostics());
            if (!*holds) return std::nullopt;
        }
        if (given == nullptr && !candidate.weight) return runner;
        ChoiceMaking making;
        making.is_random = choices->is_random;
        making.source = source;
        making.replay = choices->replay;
        making.record = &record_;
        Evaluation at = evaluation();
        at.document = given_in;
        at.words.clear();
        at.site = {choices->seed.value, child(draw_.group, candidate.key.value), "rule?weight"};
        at.choices = &making;
        const Result<Value> value = given != nullptr ? evaluate(*given, at) : value_of(candidate.weight, "weight");
        const Result<double> number = value ? as_number(*value) : Result<double>(value.diagnostics());
        if (!number) return failed(number.diagnostics());
        if (*number < 0) {
            const SourceSpan span = given != nullptr ? given->span : candidate.weight->span;
            return failed({error("tangle.negative-weight", "a weight must not be below 0", span)});
        }
        runner.weight = *number;
        return runner;
    }
    std::nullopt_t failed(const Diagnostics& reasons) {
        append(errors_, reasons);
        return std::nullopt;
    }

    Result<std::optional<std::uint32_t>> race_of(std::vector<Runner> runners, const StepChoices& choices,
                                                 ChoiceSource source) {
        if (!errors_.empty()) return errors_;
        std::erase_if(runners, [](const Runner& runner) { return !(runner.weight > 0); });
        if (runners.empty()) return std::optional<std::uint32_t>();
        if (runners.size() == 1 && source == ChoiceSource::drawn) return std::optional(runners[0].rule);
        if (const Value* replayed = choices.replay ? choices.replay->find(draw_.group, "rule") : nullptr) {
            for (std::size_t i = 0; i < runners.size(); ++i) {
                if (plain_text(*replayed) == rule(runners[i].rule).segment) {
                    return recorded(runners, i, ChoiceSource::replayed);
                }
            }
            return error("choices.outside-domain", "the recorded rule " + to_text(*replayed) + " cannot be drawn here",
                         rule(runners[0].rule).span);
        }
        if (!choices.is_random) {
            const auto heaviest = std::max_element(
                runners.begin(), runners.end(), [](const Runner& a, const Runner& b) { return a.weight < b.weight; });
            return recorded(runners, static_cast<std::size_t>(heaviest - runners.begin()),
                            source == ChoiceSource::drawn ? ChoiceSource::middle : source);
        }
        std::vector<Key> keys;
        std::vector<double> weights;
        for (const Runner& runner : runners) {
            keys.push_back(rule(runner.rule).key);
            weights.push_back(runner.weight);
        }
        const std::uint64_t seed = draw_.node.accepted.empty()
                                       ? choices.seed.value
                                       : seed_of_parameter(*choices.presets, choices.accepted, "rule", choices.seed);
        return recorded(runners, race(seed, draw_.group, "rule", keys, weights), source);
    }

    std::optional<std::uint32_t> recorded(const std::vector<Runner>& runners, std::size_t winner, ChoiceSource source) {
        ChoiceDomain domain;
        domain.kind = ChoiceDomain::Kind::alternatives;
        for (const Runner& runner : runners) {
            domain.alternatives.push_back({rule(runner.rule).segment, {}});
            domain.weights.push_back(runner.weight);
        }
        const void* text = draw_.matching.empty() ? nullptr : draw_.matching.data();
        record(record_, text, "rule", domain, draw_.group, static_cast<double>(winner), source);
        return runners[winner].rule;
    }

    const RuleDraw& draw_;
    ChoiceBuffer& record_;
    Value value_;                // of the deciding preset
    bool is_elsewhere_ = false;  // it names a rule that this tag has not, but another may have
    Diagnostics errors_;
};

}  // namespace

Result<std::optional<std::uint32_t>> draw_rule(const RuleDraw& draw, ChoiceBuffer& record) {
    return RuleDrawer(draw, record).run();
}

}  // namespace filigree::tangle
