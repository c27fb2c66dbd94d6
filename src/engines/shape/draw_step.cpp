// Which rule the machine applies next, and where: the automatic mode of derivation.
#include <algorithm>
#include <cmath>

#include "engines/shape/derive.h"

namespace filigree::shape {
namespace {

struct Runner {
    std::uint32_t rule = 0;
    Applications found;
};

class StepDrawer {
public:
    StepDrawer(const Grammar& grammar, SeenDesign& design, const StepChoices& choices, Key key,
               std::span<const std::uint32_t> accepted, const Surroundings& around, ChoiceBuffer& record)
        : grammar_(grammar),
          design_(design),
          choices_(choices),
          key_(key),
          accepted_(accepted),
          around_(around),
          record_(record) {}

    Result<std::optional<NextStep>> draw(std::vector<Runner> runners) {
        if (runners.empty()) return std::optional<NextStep>();
        Result<std::size_t> winner = draw_rule(runners);
        if (!winner) return winner.diagnostics();
        std::vector<Application>& all = runners[*winner].found.all;
        if (grammar_.pick == Pick::all) {
            // Of each match the first variant: the others would take the same away once more.
            const auto is_variant = [](const Application& a, const Application& b) { return a.match == b.match; };
            all.erase(std::unique(all.begin(), all.end(), is_variant), all.end());
            return std::optional(NextStep{std::move(all)});
        }
        Result<std::size_t> index = grammar_.pick == Pick::first ? Result<std::size_t>(0) : draw_match(all.size());
        if (!index) return index.diagnostics();
        if (grammar_.pick == Pick::orbit) {
            const Applications& among = runners[*winner].found;
            return std::optional(NextStep{orbit_of(all[*index], among, grammar_, design_.shape())});
        }
        return std::optional(NextStep{{std::move(all[*index])}});
    }

private:
    const std::string& name(const Runner& runner) const { return grammar_.rules[runner.rule].name; }

    std::uint64_t seed_of(std::string_view parameter) const {
        if (accepted_.empty()) return choices_.seed.value;
        return seed_of_parameter(*choices_.presets, accepted_, parameter, choices_.seed);
    }

    // What a preset or a replay says of a choice, and as which source it is recorded.
    struct Given {
        std::optional<Value> value;
        ChoiceSource source = ChoiceSource::set;
    };
    Result<Given> given(std::string_view parameter) {
        StepChoices silent = choices_;
        silent.record = nullptr;
        Evaluation at;
        at.document = &around_.document;
        at.scope = &around_.settings.globals;
        at.site.key = key_;
        at.site.name = parameter;
        at.words = {"*"};
        Result<std::optional<Value>> preset = preset_value(silent, parameter, at);
        if (!preset) return preset.diagnostics();
        if (*preset) return Given{std::move(*preset), ChoiceSource::set};
        if (const Value* replayed = choices_.replay != nullptr ? choices_.replay->find(key_, parameter) : nullptr) {
            return Given{*replayed, ChoiceSource::replayed};
        }
        return Given{};
    }

    Result<std::size_t> draw_rule(const std::vector<Runner>& runners) {
        Result<Given> said = given("rule");
        if (!said) return said.diagnostics();
        ChoiceDomain domain;
        domain.kind = ChoiceDomain::Kind::alternatives;
        std::vector<Key> keys;
        std::size_t heaviest = 0;
        for (std::size_t i = 0; i < runners.size(); ++i) {
            const double weight = grammar_.rules[runners[i].rule].weight;
            domain.alternatives.push_back({name(runners[i]), {}});
            domain.weights.push_back(weight);
            keys.push_back(Key{hash_text(name(runners[i]))});
            if (weight > domain.weights[heaviest]) heaviest = i;
        }
        std::size_t winner = heaviest;
        ChoiceSource source = ChoiceSource::drawn;
        if (said->value) {
            const std::string wanted = plain_text(*said->value);
            const auto found = std::find_if(runners.begin(), runners.end(),
                                            [&](const Runner& runner) { return name(runner) == wanted; });
            if (found == runners.end()) {
                return error("shape.rule-not-here", "the rule '" + wanted + "' does not apply in this step",
                             said->value->span, {"of those that do, one is '" + name(runners[0]) + "'"});
            }
            winner = static_cast<std::size_t>(found - runners.begin());
            source = said->source;
        } else if (runners.size() == 1) {
            return winner;
        } else if (choices_.is_random) {
            winner = race(seed_of("rule"), key_, "rule", keys, domain.weights);
        } else {
            source = ChoiceSource::middle;
        }
        record(&record_, "rule", domain, static_cast<double>(winner), source);
        return winner;
    }

    Result<std::size_t> draw_match(std::size_t count) {
        Result<Given> said = given("match");
        if (!said) return said.diagnostics();
        ChoiceDomain domain;
        domain.whole = true;
        domain.low = 1;
        domain.high = static_cast<double>(count);
        std::size_t index = (count - 1) / 2;
        ChoiceSource source = ChoiceSource::drawn;
        if (said->value) {
            const Result<double> number = as_number(*said->value);
            if (!number) return number.diagnostics();
            if (!(*number >= 1 && *number <= domain.high && *number == std::floor(*number))) {
                return error("preset.outside-domain",
                             "'match' takes a whole number from 1 to " + std::to_string(count) + " here",
                             said->value->span);
            }
            index = static_cast<std::size_t>(*number) - 1;
            source = said->source;
        } else if (count == 1) {
            return index;
        } else if (choices_.is_random) {
            index = static_cast<std::size_t>(
                to_whole(random_bits(seed_of("match"), key_, "match"), static_cast<std::uint32_t>(count)));
        } else {
            source = ChoiceSource::middle;
        }
        record(&domain, "match", domain, static_cast<double>(index + 1), source);
        return index;
    }

    void record(const void* text, std::string_view name, const ChoiceDomain& domain, double value,
                ChoiceSource source) {
        filigree::record(record_, text, name, domain, key_, value, source);
    }

    const Grammar& grammar_;
    SeenDesign& design_;
    const StepChoices& choices_;
    const Key key_;
    const std::span<const std::uint32_t> accepted_;
    const Surroundings& around_;
    ChoiceBuffer& record_;
};

}  // namespace

std::vector<std::uint32_t> automatic_rules(const Grammar& grammar) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t r = 0; r < grammar.rules.size(); ++r) {
        if (grammar.rules[r].weight > 0) order.push_back(r);
    }
    const auto priority = [&](std::uint32_t r) { return grammar.rules[r].priority; };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return priority(a) != priority(b) ? priority(a) > priority(b) : a < b;
    });
    return order;
}

Result<std::optional<NextStep>> draw_step(const Grammar& grammar, SeenDesign& design, const PresetWalk& walk,
                                          const PresetNode& node, Key key, const Surroundings& around, const Job& job,
                                          ChoiceBuffer& record) {
    Result<StepChoices> choices = choices_at(walk, node, around.settings.globals, &record);
    if (!choices) return choices.diagnostics();
    std::vector<Runner> runners;
    for (const std::uint32_t r : automatic_rules(grammar)) {
        if (!runners.empty() && grammar.rules[r].priority < grammar.rules[runners.front().rule].priority) break;
        Result<Applications> found = applications_of(grammar, r, design, around, job);
        if (!found) return found.diagnostics();
        if (!found->all.empty()) runners.push_back({r, std::move(*found)});
    }
    return StepDrawer(grammar, design, *choices, key, node.accepted, around, record).draw(std::move(runners));
}

}  // namespace filigree::shape
