#include "language/step_choices.h"

#include "language/choice.h"

namespace filigree {

std::vector<const Preset*> presets_in_force(const StepChoices& choices, std::string_view parameter) {
    if (choices.presets == nullptr || choices.accepted.empty()) return {};
    std::vector<const Preset*> said = values_for(*choices.presets, choices.accepted, parameter);
    if (choices.is_random) {
        std::erase_if(said, [](const Preset* preset) { return preset->kind != PresetKind::set; });
    }
    return said;
}

Result<std::optional<Value>> preset_value(const StepChoices& choices, std::string_view parameter,
                                          const Evaluation& at) {
    Result<std::optional<DecidedValue>> decided = decide(choices, parameter, nullptr, at);
    if (!decided) return std::move(decided).diagnostics();
    if (!*decided) return std::optional<Value>();
    return std::optional(std::move((*decided)->value));
}

Result<Value> evaluate_with(const StepChoices& choices, std::string_view parameter, const Expression& own,
                            const Evaluation& at) {
    const Result<std::optional<DecidedValue>> decided = decide(choices, parameter, &own, at);
    if (!decided) return decided.diagnostics();
    return (*decided)->value;
}

Result<std::uint32_t> draw_scatter(const StepChoices& choices, Key step, const Scope& scope) {
    constexpr std::string_view name = "scatter";
    static const char text = 0;  // stands for an expression
    ChoiceDomain domain{ChoiceDomain::Kind::range, true};
    domain.high = 4294967295.0;
    Evaluation at;
    at.scope = &scope;
    at.site = {0, step, std::string(name)};
    at.whole = true;
    const Result<std::optional<DecidedValue>> decided = decide(choices, name, nullptr, at);
    if (!decided) return decided.diagnostics();
    if (*decided) {
        const std::optional<double> value = place_in(domain, (*decided)->value);
        if (value) return static_cast<std::uint32_t>(*value);
        return error("preset.outside-domain",
                     "'scatter' must be a whole number in " + domain_text(domain) + ", but this is " +
                         text_with_unit((*decided)->value),
                     (*decided)->preset->value->span);
    }
    const Value* replayed = choices.replay != nullptr ? choices.replay->find(step, name) : nullptr;
    ChoiceSource source = ChoiceSource::drawn;
    double value = 0;
    if (replayed != nullptr) {
        const std::optional<double> found = place_in(domain, *replayed);
        if (!found) {
            return error("choices.outside-domain", "the recorded " + text_with_unit(*replayed) +
                                                       " of 'scatter' does not lie in " + domain_text(domain));
        }
        value = *found;
        source = ChoiceSource::replayed;
    } else if (!choices.is_random) {
        value = 2147483648.0;
        source = ChoiceSource::middle;
    } else {
        std::uint64_t seed = choices.seed.value;
        if (choices.presets != nullptr && !choices.accepted.empty()) {
            seed = seed_of_parameter(*choices.presets, choices.accepted, name, choices.seed);
        }
        value = static_cast<double>(random_bits(seed, step, name) >> 32);
    }
    if (choices.record != nullptr) record(*choices.record, &text, name, domain, step, value, source);
    return static_cast<std::uint32_t>(value);
}

}  // namespace filigree
