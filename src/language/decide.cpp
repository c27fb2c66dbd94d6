// What presets give for a parameter; declared in step_choices.h.
#include <algorithm>
#include <list>

#include "base/number_text.h"
#include "language/replaced_scope.h"
#include "language/step_choices.h"

namespace filigree {

namespace {

ChoiceSource source_of(const Preset& preset) {
    return preset.kind == PresetKind::fallback ? ChoiceSource::fallback : ChoiceSource::set;
}

Result<bool> flag_of(Result<Value> value, SourceSpan span) {
    if (!value) return std::move(value).diagnostics();
    const Symbol* word = std::get_if<Symbol>(&value->data);
    if (word != nullptr && (word->name == "yes" || word->name == "no")) return word->name == "yes";
    value->span = span;
    return as_flag(*value);
}

// Only where the presets say something of it.
Result<std::optional<bool>> randomness_said(const Presets& presets, std::span<const std::uint32_t> accepted,
                                            const Scope& scope) {
    ChoiceMaking making;
    making.is_random = false;
    for (const Preset* preset : values_for(presets, accepted, "is_random")) {
        if (preset->kind != PresetKind::set || preset->path->draw != 0) continue;
        const ReplacedScope replaced(&scope, ReplacedScope::outermost(&scope), preset->globals);
        Evaluation at;
        at.document = preset->document;
        at.scope = replaced.get();
        at.choices = &making;
        if (preset->condition) {
            const Result<bool> holds = flag_of(evaluate(*preset->condition, at), preset->condition->span);
            if (!holds) return holds.diagnostics();
            if (!*holds) continue;
        }
        at.words = {"yes", "no"};
        at.whole = true;
        const Result<bool> flag = flag_of(evaluate(*preset->value, at), preset->value->span);
        if (!flag) return flag.diagnostics();
        return std::optional<bool>(*flag);
    }
    return std::optional<bool>();
}

// Decides one parameter at one place.
class Decision {
public:
    Decision(const StepChoices& choices, std::string_view parameter, const Evaluation& at, const Evaluation& of_presets)
        : choices_(choices), parameter_(parameter), at_(at), of_presets_(of_presets), is_random_(choices.is_random) {
        const bool has_presets = choices.presets != nullptr && !choices.accepted.empty();
        seed_ = has_presets ? seed_below(choices.accepted, choices.seed) : choices.seed.value;
        if (has_presets) add(choices.accepted, false);
    }

    std::optional<Diagnostics> take_shape(const ShapeChoices& shape) {
        const std::vector<std::uint32_t> accepted = of_shape_alone(shape.accepted);
        const std::vector<std::uint32_t> at_shape = of_shape_alone(shape.above);
        if ((accepted.empty() && at_shape.empty()) || choices_.presets == nullptr) return std::nullopt;
        const Scope no_names;
        const Scope& names = of_presets_.scope != nullptr ? *of_presets_.scope : no_names;
        const Result<std::optional<bool>> is_random = randomness_said(*choices_.presets, accepted, names);
        if (!is_random) return is_random.diagnostics();
        is_random_ = is_random->value_or(is_random_);
        const NodeSeed above = seed_at_node(*choices_.presets, at_shape, choices_.seed);
        const NodeSeed seed = seed_at_node(*choices_.presets, accepted, above);
        seed_ = seed_below(accepted, {seed_below(choices_.accepted, seed), seed.rerolls});
        said_.clear();
        add(accepted, true);
        add(choices_.accepted, false);
        return std::nullopt;
    }

    Result<std::optional<DecidedValue>> run(const Expression* own) {
        number_conditions();
        for (const Said& said : said_) {
            const Result<bool> holds = condition_holds(said);
            if (!holds) return holds.diagnostics();
            if (!*holds) continue;
            if (said.preset->path->draw != 0) {
                add_draw(said);
            } else {
                return value_of(said);
            }
        }
        if (own == nullptr) return std::optional<DecidedValue>();
        return value_of(*own);
    }

private:
    struct Said {
        const Preset* preset = nullptr;
        bool of_shape = false;
        std::uint32_t condition = 0;  // a number among those of the same key whose conditions draw
    };
    // What a preset's expressions are evaluated with.
    struct Names {
        ReplacedScope scope, shape_scope;
    };

    const StepChoices& choices_;
    const std::string_view parameter_;
    const Evaluation& at_;
    const Evaluation& of_presets_;
    bool is_random_;
    std::uint64_t seed_ = 0;
    std::vector<Said> said_;
    std::vector<DrawPreset> draws_;  // the first of each draw counts
    std::list<Names> names_;

    // Those that are not said of the whole step.
    std::vector<std::uint32_t> of_shape_alone(const std::vector<std::uint32_t>& presets) const {
        std::vector<std::uint32_t> alone;
        for (const std::uint32_t one : presets) {
            const bool is_common =
                std::find(choices_.accepted.begin(), choices_.accepted.end(), one) != choices_.accepted.end();
            if (!is_common) alone.push_back(one);
        }
        return alone;
    }

    std::uint64_t seed_below(std::span<const std::uint32_t> accepted, const NodeSeed& seed) const {
        if (parameter_.empty()) return seed.value;  // nothing but the node itself
        return seed_of_parameter(*choices_.presets, accepted, parameter_, seed);
    }

    // `set`s go before `default`s, and those that are added first before the others.
    void add(std::span<const std::uint32_t> accepted, bool of_shape) {
        for (const Preset* preset : values_for(*choices_.presets, accepted, parameter_)) {
            const bool is_set = preset->kind == PresetKind::set;
            if (!is_set && is_random_) continue;
            const auto first_default = std::find_if(
                said_.begin(), said_.end(), [](const Said& one) { return one.preset->kind != PresetKind::set; });
            said_.insert(is_set ? first_default : said_.end(), {preset, of_shape});
        }
    }

    void number_conditions() {
        std::uint32_t drawing[] = {0, 0};
        for (Said& said : said_) {
            said.condition = drawing[said.of_shape ? 1 : 0] + 1;
            const ExpressionPtr& condition = said.preset->condition;
            if (condition && has_choice(*condition)) ++drawing[said.of_shape ? 1 : 0];
        }
    }

    // The evaluation of something that a preset says.
    Evaluation evaluation_of(const Said& said, const ChoiceMaking& making) {
        Evaluation at = of_presets_;
        const Scope* document_names = ReplacedScope::outermost(at.scope);
        const Names& names = names_.emplace_back(Names{{at.scope, document_names, said.preset->globals},
                                                       {at.shape_scope, document_names, said.preset->globals}});
        at.document = said.preset->document;
        at.scope = names.scope.get();
        at.shape_scope = names.shape_scope.get();
        at.by_shape = at.by_shape || said.of_shape;
        at.choices = &making;
        complete(at.site);
        return at;
    }
    void complete(ChoiceSite& site) const {
        site.seed = seed_;
        if (site.name.empty()) site.name = parameter_;
    }
    ChoiceMaking making_by(ChoiceSource source) const {
        ChoiceMaking making;
        making.is_random = is_random_;
        making.source = source;
        making.replay = choices_.replay;
        making.record = choices_.record;
        return making;
    }

    Result<bool> condition_holds(const Said& said) {
        const ExpressionPtr& condition = said.preset->condition;
        if (!condition) return true;
        const ChoiceMaking making = making_by(source_of(*said.preset));
        Evaluation at = evaluation_of(said, making);
        std::string suffix = "?when";
        if (said.condition > 1) suffix += "#" + to_text(std::uint64_t{said.condition});
        ChoiceAddress recorded_at;
        at.site.name += suffix;
        if (at.site.recorded_at != nullptr) {
            recorded_at = *at.site.recorded_at;
            recorded_at.name += suffix;
            at.site.recorded_at = &recorded_at;
        }
        at.words.clear();
        at.calls.clear();
        at.whole = false;
        return flag_of(evaluate(*condition, at), condition->span);
    }

    void add_draw(const Said& said) {
        const ChoiceMaking making;
        const Evaluation at = evaluation_of(said, making);
        draws_.push_back({said.preset->path->draw, said.preset->value, source_of(*said.preset), at.document, at.scope,
                          at.shape_scope, said.of_shape});
    }

    Result<std::optional<DecidedValue>> value_of(const Said& said) {
        ChoiceMaking making = making_by(source_of(*said.preset));
        making.draws = draws_;
        const Evaluation at = evaluation_of(said, making);
        const std::size_t recorded = making.record != nullptr ? making.record->rows.size() : 0;
        Result<Value> value = evaluate(*said.preset->value, at);
        if (!value) return std::move(value).diagnostics();
        if (making.record != nullptr && making.record->rows.size() == recorded) {
            record_fixed(*said.preset, *value, at);
        }
        return std::optional(DecidedValue{std::move(*value), said.preset});
    }

    void record_fixed(const Preset& preset, const Value& value, const Evaluation& at) const {
        ChoiceDomain domain{ChoiceDomain::Kind::fixed};
        domain.alternatives = {value};
        ChoiceAddress address{at.shape_key.value_or(at.site.key), at.site.name};
        if (at.site.recorded_at != nullptr) address = *at.site.recorded_at;
        record(*choices_.record, preset.value.get(), address.name, domain, address.key, 0, source_of(preset));
    }

    Result<std::optional<DecidedValue>> value_of(const Expression& own) {
        ChoiceMaking making = making_by(ChoiceSource::drawn);
        making.draws = draws_;
        Evaluation at = at_;
        complete(at.site);
        const bool is_plain =
            making.is_random && making.replay == nullptr && making.record == nullptr && draws_.empty();
        at.choices = is_plain ? nullptr : &making;
        Result<Value> value = evaluate(own, at);
        if (!value) return std::move(value).diagnostics();
        return std::optional(DecidedValue{std::move(*value), nullptr});
    }
};

}  // namespace

Result<bool> is_random_at(const Presets& presets, std::span<const std::uint32_t> accepted, const Scope& scope) {
    const Result<std::optional<bool>> said = randomness_said(presets, accepted, scope);
    if (!said) return said.diagnostics();
    return said->value_or(true);
}

Result<std::optional<DecidedValue>> decide(const StepChoices& choices, std::string_view parameter,
                                           const Expression* own, const Evaluation& at, const Evaluation* of_presets,
                                           const ShapeChoices* shape) {
    Decision decision(choices, parameter, at, of_presets != nullptr ? *of_presets : at);
    if (shape != nullptr) {
        if (std::optional<Diagnostics> problems = decision.take_shape(*shape)) return std::move(*problems);
    }
    return decision.run(own);
}

}  // namespace filigree
