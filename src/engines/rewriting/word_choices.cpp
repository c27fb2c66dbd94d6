#include "engines/rewriting/word_choices.h"

#include <algorithm>
#include <cmath>

#include "language/choice.h"
#include "language/walk.h"

namespace filigree::rewriting {
namespace {

bool is_of(const Preset& preset, std::string_view parameter) { return preset.path->parameter == parameter; }

ChoiceSource source_of(const Preset& preset) {
    return preset.kind == PresetKind::set ? ChoiceSource::set : ChoiceSource::fallback;
}

const CallExpression* one_of_in(const Preset& preset) {
    const auto* call = std::get_if<CallExpression>(&preset.value->node);
    return call != nullptr && call->name == "one_of" ? call : nullptr;
}

std::string macro_text(const Macro& macro) {
    return "random " + std::to_string(macro.low) + ".." + std::to_string(macro.high) + " \"" + to_utf8(macro.letters) +
           "\"" + (macro.is_unique ? " unique" : "");
}

// Nothing drawn: of the middle length, the letter that there are most of.
std::u32string middle_letters(const Macro& macro) {
    const auto count_of = [&](char32_t letter) {
        return std::count(macro.letters.begin(), macro.letters.end(), letter);
    };
    char32_t heaviest = macro.letters.empty() ? U' ' : macro.letters.front();
    for (const char32_t letter : macro.letters) {
        if (count_of(letter) > count_of(heaviest)) heaviest = letter;
    }
    return std::u32string(macro.low + (macro.high - macro.low) / 2, heaviest);
}

bool can_draw(const Macro& macro, const std::u32string& letters) {
    if (letters.size() < macro.low || letters.size() > macro.high) return false;
    return std::all_of(letters.begin(), letters.end(), [&](char32_t letter) {
        return macro.letters.find(letter) != std::u32string::npos && (!macro.is_unique || letter == letters.front());
    });
}

Diagnostic outside_domain(std::string_view what, const Value& recorded, const ChoiceDomain& domain) {
    return error("choices.outside-domain", "the recorded " + to_text(recorded) + " of '" + std::string(what) +
                                               "' cannot be drawn here, from " + domain_text(domain));
}

}  // namespace

std::optional<std::size_t> successor_named(const Rule& rule, const Value& value) {
    const auto* number = std::get_if<Quantity>(&value.data);
    if (number != nullptr) {
        const bool is_there = number->value >= 1 && number->value <= static_cast<double>(rule.successors.size()) &&
                              number->value == std::floor(number->value);
        return is_there ? std::optional(static_cast<std::size_t>(number->value) - 1) : std::nullopt;
    }
    const std::u32string name = letters_of(plain_text(value));
    for (std::size_t s = 0; s < rule.successors.size(); ++s) {
        if (letters_of(rule.successors[s].name) == name) return s;
    }
    return std::nullopt;
}

std::u32string drawn_letters(const Macro& macro, const std::function<std::uint64_t(std::uint64_t draw)>& bits) {
    std::uint64_t draw = 0;
    const auto whole = [&](std::uint64_t count) { return to_whole(bits(draw++), static_cast<std::uint32_t>(count)); };
    const std::uint64_t length = macro.low + whole(std::uint64_t{macro.high} - macro.low + 1);
    std::u32string letters;
    const auto letter = [&] { return macro.letters[whole(macro.letters.size())]; };
    if (macro.is_unique) {
        letters.assign(length, letter());
    } else {
        while (letters.size() < length) letters += letter();
    }
    return letters;
}

std::size_t raced(std::span<const double> weights, std::uint64_t bits) {
    std::size_t best = weights.size();
    double least = INFINITY;
    for (std::size_t s = 0; s < weights.size(); ++s) {
        const double time = race_time(fold(bits, s), weights[s]);
        if (time < least) {
            least = time;
            best = s;
        }
    }
    return best;
}

// --- places -----------------------------------------------------------------------------------------------------

WordChoices::WordChoices(PresetWalk walk, WordChoiceOptions options)
    : walk_(std::move(walk)),
      options_(options),
      needs_spots_(options.follows_presets || options.records),
      spots_(walk_),
      met_(walk_.presets.all.size()) {}

const PresetNode& WordChoices::node_of(const ChoosingSymbol& symbol) const {
    return options_.follows_presets ? spots_.node_of(symbol.spot) : walk_.root;
}

FactSet WordChoices::facts_asked() const {
    FactSet asked{};
    for (const Preset& preset : walk_.presets.all) {
        for (const ExpressionPtr& expression : {preset.value, preset.condition}) {
            if (!expression) continue;
            for (const NameInExpression& name : names_in(*expression)) {
                const auto fact = std::find(fact_names.begin(), fact_names.end(), name.text);
                if (fact != fact_names.end()) asked[static_cast<std::size_t>(fact - fact_names.begin())] = true;
            }
        }
    }
    return asked;
}

void WordChoices::meet(const PresetNode& node, std::string_view parameter) {
    for (const std::uint32_t preset : node.accepted) {
        if (is_of(walk_.presets.all[preset], parameter)) met_[preset] = 1;
    }
}

std::vector<std::uint8_t> WordChoices::met() const {
    std::vector<std::uint8_t> met = met_;
    for (std::size_t i = 0; i < met.size(); ++i) {
        const Preset& preset = walk_.presets.all[i];
        if (is_of(preset, "") || is_of(preset, "is_random")) met[i] = spots_.reached()[i];
    }
    return met;
}

Result<StepChoices> WordChoices::choices_of(const ChoosingSymbol& symbol, std::string_view parameter) {
    const PresetNode& node = node_of(symbol);
    meet(node, parameter);
    return choices_at(walk_, node, symbol.names, buffer());
}

// --- records ----------------------------------------------------------------------------------------------------

void WordChoices::record_choice(const void* text, std::string_view name, const ChoiceDomain& domain, Key key,
                                double value, ChoiceSource source) {
    if (options_.records) record(buffer_, text, name, domain, key, value, source);
}

void WordChoices::take_record(Spot spot) {
    if (made().size() + buffer_.rows.size() > most_recorded_choices) {
        left_out_ += buffer_.rows.size();
    } else if (!buffer_.rows.empty()) {
        recorder_.append(buffer_);
        spots_of_made_.resize(made().size(), spot);
    }
    buffer_ = {};
}

Result<StepChoices> WordChoices::of_edit(Spot spot, const Scope& names) {
    edit_node_ = options_.follows_presets ? spots_.node_of(spot) : walk_.root;
    for (const std::uint32_t preset : edit_node_.accepted) met_[preset] = 1;
    return choices_at(walk_, edit_node_, names, buffer());
}

// --- rules ------------------------------------------------------------------------------------------------------

struct WordChoices::Named {
    std::optional<std::size_t> only;  // the one that is taken; the number of all for none of them
    std::vector<double> weights;      // of the rule's successors: 0 for those that are not named; empty: all race
    ChoiceSource source = ChoiceSource::drawn;
};

Result<WordChoices::Named> WordChoices::named_by(const Preset& preset, const Value& value, const Rule& rule,
                                                 const StepChoices& choices, std::span<const double> weights,
                                                 std::string_view name, const ChoosingSymbol& symbol) {
    Named named;
    named.source = source_of(preset);
    const CallExpression* one_of = one_of_in(preset);
    if (one_of == nullptr) {
        named.only = successor_named(rule, value);
        if (!named.only && plain_text(value) == no_successor) named.only = rule.successors.size();
        return named;
    }
    // Those that are named race as they would among all: with their own weights, or the given ones.
    bool is_any_here = false;
    named.weights.assign(weights.size(), 0);
    for (const WeightedExpression& one : candidates_of(*one_of)) {
        Evaluation at;
        at.document = preset.document;
        at.scope = &symbol.names;
        at.words = {"*"};
        const Result<Value> candidate = evaluate(*one.candidate, at);
        if (!candidate) return candidate.diagnostics();
        const std::optional<std::size_t> successor = successor_named(rule, *candidate);
        is_any_here = is_any_here || successor || plain_text(*candidate) == no_successor;
        if (!successor) continue;
        double weight = weights[*successor];
        if (one.weight != nullptr) {
            ChoiceMaking making;
            making.is_random = choices.is_random;
            making.source = named.source;
            making.replay = choices.replay;
            making.record = choices.record;
            at.words.clear();
            at.site = {choices.seed.value, child(symbol.key, *successor), std::string(name) + "?weight"};
            at.choices = &making;
            const Result<Value> given = evaluate(*one.weight, at);
            const Result<double> number = given ? as_number(*given) : Result<double>(given.diagnostics());
            if (!number) return number.diagnostics();
            weight = *number;
        }
        named.weights[*successor] = weight;
    }
    // What `**.rule` names may be successors of another letter, or of another rule of this one.
    if (!is_any_here) named = {};
    return named;
}

Result<std::size_t> WordChoices::successor(const Rule& rule, std::span<const double> weights, std::string_view what,
                                           const ChoosingSymbol& symbol) {
    const std::string name = choice_name(what, symbol.times + 1);
    const Result<StepChoices> choices = choices_of(symbol, what);
    if (!choices) return choices.diagnostics();
    std::vector<double> racing(weights.begin(), weights.end());
    ChoiceSource source = ChoiceSource::drawn;
    if (!choices->accepted.empty()) {
        ChoiceBuffer decisions;
        StepChoices recording = *choices;
        recording.record = &decisions;
        Evaluation at;
        at.scope = &symbol.names;
        at.site = {0, symbol.key, name};
        at.words = {"*"};
        Result<std::optional<DecidedValue>> decided = decide(recording, what, nullptr, at);
        if (!decided && recording.replay != nullptr) {
            // What was recorded is the winner of the race below, which need not be one of those that are named here.
            decisions = {};
            recording.replay = nullptr;
            decided = decide(recording, what, nullptr, at);
        }
        if (!decided) return decided.diagnostics();
        Named named;
        if (*decided) {
            Result<Named> found =
                named_by(*(*decided)->preset, (*decided)->value, rule, *choices, weights, name, symbol);
            if (!found) return found.diagnostics();
            named = std::move(*found);
        }
        // Of what was drawn for the value, only what the value was made of counts, and only where it is taken.
        for (const ChoiceBuffer::Row& row : decisions.rows) {
            const ChoiceBuffer::Place& place = decisions.places[row.place];
            const bool is_value = place.name == name || place.name.rfind(name + "~", 0) == 0;
            if (is_value && !named.only) continue;
            record_choice(place.text, place.name, place.domain, row.key, row.value, row.source);
        }
        if (named.only) {
            take_record(symbol.spot);
            return *named.only;
        }
        if (!named.weights.empty()) {
            racing = std::move(named.weights);
            source = named.source;
        }
    }

    ChoiceDomain domain{ChoiceDomain::Kind::alternatives};
    std::vector<std::size_t> runners;
    for (std::size_t s = 0; s < racing.size(); ++s) {
        if (!(racing[s] > 0)) continue;
        runners.push_back(s);
        domain.alternatives.push_back({rule.successors[s].name, {}});
        domain.weights.push_back(racing[s]);
    }
    std::size_t winner = 0;  // of the runners
    if (runners.size() > 1 || source != ChoiceSource::drawn) {
        if (runners.empty()) {
            take_record(symbol.spot);
            return racing.size();
        }
        if (const Value* replayed = choices->replay ? choices->replay->find(symbol.key, name) : nullptr) {
            const std::optional<double> place = place_in(domain, *replayed);
            if (!place) return outside_domain(what, *replayed, domain);
            winner = static_cast<std::size_t>(*place);
            source = ChoiceSource::replayed;
        } else if (!choices->is_random) {
            winner = static_cast<std::size_t>(middle_of(domain));
            if (source == ChoiceSource::drawn) source = ChoiceSource::middle;
        } else {
            const std::uint64_t seed = seed_of_parameter(*choices->presets, choices->accepted, what, choices->seed);
            const std::size_t best = raced(racing, symbol.bits(seed, 0));
            winner = static_cast<std::size_t>(std::find(runners.begin(), runners.end(), best) - runners.begin());
        }
        record_choice(&rule, name, domain, symbol.key, static_cast<double>(winner), source);
    }
    take_record(symbol.spot);
    return runners.empty() ? racing.size() : runners[winner];
}

// --- macros -----------------------------------------------------------------------------------------------------

Result<std::u32string> WordChoices::letters(const Macro& macro, const ChoosingSymbol& symbol) {
    constexpr std::string_view what = "letters";
    const std::string name = choice_name(what, symbol.times + 1);
    const Result<StepChoices> choices = choices_of(symbol, what);
    if (!choices) return choices.diagnostics();
    if (!choices->accepted.empty()) {
        Evaluation at;
        at.scope = &symbol.names;
        at.site = {0, symbol.key, name};
        at.words = {"*"};
        const Result<std::optional<DecidedValue>> decided = decide(*choices, what, nullptr, at);
        if (!decided) return decided.diagnostics();
        take_record(symbol.spot);
        if (*decided) return letters_of(plain_text((*decided)->value));
    }
    ChoiceDomain domain{ChoiceDomain::Kind::worded};
    domain.alternatives = {{macro_text(macro), {}}, {}};
    std::u32string letters;
    ChoiceSource source = ChoiceSource::drawn;
    if (const Value* replayed = choices->replay ? choices->replay->find(symbol.key, name) : nullptr) {
        letters = letters_of(plain_text(*replayed));
        if (!can_draw(macro, letters)) return outside_domain(what, *replayed, domain);
        source = ChoiceSource::replayed;
    } else if (!choices->is_random) {
        letters = middle_letters(macro);
        source = ChoiceSource::middle;
    } else {
        const std::uint64_t seed = seed_of_parameter(*choices->presets, choices->accepted, what, choices->seed);
        letters = drawn_letters(macro, [&](std::uint64_t draw) { return symbol.bits(seed, draw); });
    }
    domain.alternatives[1].data = to_utf8(letters);
    record_choice(&macro, name, domain, symbol.key, 1, source);
    take_record(symbol.spot);
    return letters;
}

}  // namespace filigree::rewriting
