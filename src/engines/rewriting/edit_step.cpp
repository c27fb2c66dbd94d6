#include "engines/rewriting/edit_step.h"

#include <algorithm>

#include "engines/rewriting/pattern.h"

namespace filigree::rewriting {
namespace {

// The rules of the document's own system that put one fixed text, whenever they do.
std::vector<ChunkPair> productions_of(const Grammar& grammar, std::uint64_t most) {
    std::vector<ChunkPair> productions;
    for (const Rule& rule : grammar.systems[0].rules) {
        for (const Successor& successor : rule.successors) {
            if (successor.kind != Successor::Kind::pattern || !is_constant(successor.pattern)) continue;
            const Result<std::u32string> text = expanded(successor.pattern, most, {});
            if (text) productions.push_back({{rule.letter}, *text});
        }
    }
    return productions;
}

class Editor {
public:
    Editor(const Derivation& derivation, const WordEdit& edit, const Grammar& grammar, const DeriveOptions& options,
           const OtherDocument& other, const Job& job)
        : derivation_(derivation),
          edit_(edit),
          grammar_(grammar),
          options_(options),
          other_(other),
          job_(job),
          names_(names_of_word(derivation.registers, derivation.iteration, options.globals)),
          key_(child(Key{fold(options.root.value, edit.key.value)}, derivation.iteration)),
          segment_(segment_of(grammar, edit)) {}

    Result<EditOutput> run() const {
        const std::u32string word = letters_of(derivation_.word, derivation_.alphabet);
        StepChoices choices;
        choices.seed.value = options_.seed;
        Spot spot = Spots::root;
        if (derivation_.choices) {
            if (derivation_.choices->needs_spots()) spot = spot_below(options_.spot);
            Result<StepChoices> asked = derivation_.choices->of_edit(spot, names_);
            if (!asked) return asked.diagnostics();
            choices = std::move(*asked);
        }
        EditArguments arguments(edit_, *options_.document, names_, choices, key_);
        if (Diagnostics problems = arguments.evaluate_common(most()); has_errors(problems)) return problems;
        const Result<std::vector<ChunkPair>> pairs = put_pairs(edit_.pairs, *options_.document, names_, most());
        if (!pairs) return pairs.diagnostics();
        std::u32string other;
        if (edit_.op->takes_other()) {
            Result<std::u32string> found = other_word(arguments);
            if (!found) return std::move(found).diagnostics();
            other = std::move(*found);
        }
        std::vector<ChunkPair> productions;
        if (edit_.op->pairs == EditOperator::Pairs::chunks && edit_.pairs.empty())
            productions = productions_of(grammar_, most());
        // All chance inside an edit hangs on one choice.
        std::optional<Result<std::uint32_t>> scatter;
        const auto bits = [&](std::uint32_t token, MutationDraw draw) {
            if (!scatter) scatter = draw_scatter(choices, key_, names_);
            const std::uint64_t seed = *scatter ? **scatter : 0;
            return random_bits(seed, child(key_, token), "edit", static_cast<std::uint64_t>(draw));
        };
        EditInput input{word, derivation_.word.ages, other, *pairs, productions, arguments, bits, most()};
        Result<EditOutput> output = edit_.op->run(input);
        if (derivation_.choices) derivation_.choices->take_record(spot);
        if (scatter && !*scatter) return scatter->diagnostics();
        return output;
    }

    // The word with its columns, in which the new symbols get theirs; none where there are too many symbols.
    std::optional<Word> edited(const EditOutput& output, Alphabet& alphabet) const {
        const Word& from = derivation_.word;
        const std::vector<std::uint32_t> indexes =
            indexes_of(from, [](Symbol symbol) { return symbol != Alphabet::freeze; });
        const std::vector<std::uint32_t> followers =
            indexes_of(from, [&](Symbol symbol) { return alphabet[symbol].role == Role::follower; });
        Word to;
        to.symbols.reserve(output.word.size());
        std::uint64_t ancestor = options_.root.value;
        std::uint64_t children = 0;
        Spot ancestor_spot = options_.spot;
        std::optional<Siblings> siblings;  // behind one ancestor
        bool is_behind_run = false;
        const Roles& roles = grammar_.systems[derivation_.scopes[0].system].roles;
        for (std::size_t at = 0; at < output.word.size(); ++at) {
            const std::uint32_t place = output.trace[at];
            const char32_t letter = output.word[at];
            if (letter == U'=') {
                if (!to.symbols.empty()) to.symbols.push_back(Alphabet::freeze);  // behind nothing it means nothing
                continue;
            }
            Role role = roles.of(letter);
            if (place != new_symbol) {
                const Symbol symbol = from.symbols[place];
                const std::uint32_t index = indexes[place];
                to.symbols.push_back(symbol);
                if (!from.keys.empty()) to.keys.push_back(from.keys[index]);
                if (!from.ages.empty()) to.ages.push_back(from.ages[index]);
                if (!from.spots.empty()) to.spots.push_back(from.spots[index]);
                ancestor = from.keys.empty() ? 0 : from.keys[index];
                ancestor_spot = from.spots.empty() ? Spots::root : from.spots[index];
                children = 0;
                role = alphabet[symbol].role;
                if (role == Role::follower) to.origins.push_back(from.origins[followers[place]]);
            } else {
                if (is_behind_run && roles.inverters.find(letter) != std::u32string::npos) role = Role::inverter;
                const std::optional<Symbol> symbol = alphabet.number_of({letter, role, 0});
                if (!symbol) return std::nullopt;
                to.symbols.push_back(*symbol);
                if (role == Role::follower) to.origins.push_back(1);
                if (!from.spots.empty()) {
                    if (children == 0) siblings.emplace(derivation_.choices->spots()).begin(spot_below(ancestor_spot));
                    to.spots.push_back(siblings->next(letter));
                }
                if (!from.keys.empty()) to.keys.push_back(fold(fold(ancestor, key_.value), children++));
                if (!from.ages.empty()) to.ages.push_back(1);
            }
            is_behind_run = role == Role::counter;
        }
        return to;
    }

private:
    // Its name, with #2 where it is the second of this name.
    static std::string segment_of(const Grammar& grammar, const WordEdit& edit) {
        std::uint64_t number = 1;
        for (const WordEdit& known : grammar.edits) {
            if (&known == &edit) break;
            number += known.op == edit.op ? 1 : 0;
        }
        const std::string name(edit.op->description.name);
        return number == 1 ? name : name + "#" + std::to_string(number);
    }
    // An edit that is made again and again has a place of its own behind each iteration.
    Spot spot_below(Spot above) const {
        return derivation_.choices->spots().below(above, segment_, edit_.is_once ? 0 : derivation_.iteration);
    }

    // In both limits, whatever stands beside the symbols.
    std::uint64_t most() const {
        const Word& word = derivation_.word;
        const std::uint64_t each = 1 + (word.origins.empty() ? 0 : 4) + (word.keys.empty() ? 0 : 8) +
                                   (word.ages.empty() ? 0 : 4) + (word.spots.empty() ? 0 : 4 + 16);
        return std::min(options_.limits.elements, options_.limits.memory_bytes / each);
    }

    // Of every place, how many symbols stand before it that a column counts.
    template <class IsCounted>
    static std::vector<std::uint32_t> indexes_of(const Word& word, IsCounted is_counted) {
        std::vector<std::uint32_t> indexes(word.size());
        std::uint32_t index = 0;
        for (std::size_t place = 0; place < word.size(); ++place) {
            indexes[place] = index;
            if (is_counted(word.symbols[place])) ++index;
        }
        return indexes;
    }

    Result<std::u32string> other_word(const EditArguments& arguments) const {
        if (arguments.is_given("with_word")) return arguments.letters("with_word");
        const Value& with = arguments.value("with");
        const auto* symbol = std::get_if<filigree::Symbol>(&with.data);
        const auto* text = std::get_if<std::string>(&with.data);
        const std::string name = symbol != nullptr ? symbol->name : text != nullptr ? *text : std::string();
        if (const std::optional<std::uint32_t> system = system_of_letter(grammar_, name)) return word_of(*system);
        if (text == nullptr || !other_) {
            return error("rewriting.unknown-system", "there is no system '" + name + "'", with.span,
                         {"another document is named in quotes"});
        }
        return other_(name);
    }

    // The word of a system behind all its iterations, derived on its own.
    Result<std::u32string> word_of(std::uint32_t system) const {
        DeriveOptions options = options_;
        ++options.nested;
        options.root = key_;
        options.choices = derivation_.choices;
        if (options.choices && options.choices->needs_spots()) {
            options.spot = options.choices->spots().below(spot_below(options_.spot), "system");
        }
        const Result<Derivation> inner = derive_system(grammar_, options, system, job_);
        if (!inner) return inner.diagnostics();
        return letters_of(inner->word, inner->alphabet);
    }

    const Derivation& derivation_;
    const WordEdit& edit_;
    const Grammar& grammar_;
    const DeriveOptions& options_;
    const OtherDocument& other_;
    const Job& job_;
    const Scope names_;
    const Key key_;
    const std::string segment_;  // of paths
};

bool acts(const WordEdit& edit, EditTime time, std::uint32_t iteration) {
    if (edit.is_once || time == EditTime::end) return edit.is_once && time == EditTime::end;
    return edit.first <= iteration && iteration <= edit.last;
}

}  // namespace

Result<EditReport> apply_edit(Derivation& derivation, const WordEdit& edit, const Grammar& grammar,
                              const DeriveOptions& options, const OtherDocument& other, const Job& job) {
    const Editor editor(derivation, edit, grammar, options, other, job);
    Result<EditOutput> output = editor.run();
    if (!output) return with_span(std::move(output).diagnostics(), edit.span);
    Alphabet alphabet = derivation.alphabet;
    std::optional<Word> word = editor.edited(*output, alphabet);
    if (!word) return with_span({too_many_symbols()}, edit.span);
    EditReport report;
    report.before = derivation.word.size();
    report.after = word->size();
    const auto is_new = [](std::uint32_t place) { return place == new_symbol; };
    report.kept = output->trace.size() -
                  static_cast<std::size_t>(std::count_if(output->trace.begin(), output->trace.end(), is_new));
    report.replaced = output->replaced;
    report.passes = output->passes;
    report.changes = std::move(output->changes);
    report.other = std::move(output->other);
    derivation.word = std::move(*word);
    derivation.alphabet = std::move(alphabet);
    begin_columns(derivation, grammar, options);  // a word without symbols had none to go on with
    return {std::move(report), with_span(output.diagnostics(), edit.span)};
}

Diagnostics apply_edits(Derivation& derivation, const Grammar& grammar, EditTime time, const DeriveOptions& options,
                        const OtherDocument& other, const Job& job) {
    Diagnostics warnings;
    for (const WordEdit& edit : grammar.edits) {
        if (!acts(edit, time, derivation.iteration)) continue;
        const Result<EditReport> report = apply_edit(derivation, edit, grammar, options, other, job);
        if (!report) return report.diagnostics();
        append(warnings, report.diagnostics());
    }
    return warnings;
}

bool asks_for_ages(const WordEdit& edit) {
    FactSet asked{};
    for (const WordEdit::TokenExpression& one : edit.by_token) add_facts(asked, one.expression);
    return has(asked, Fact::age);
}

Scope names_of_word(const std::vector<Register>& registers, std::uint32_t iteration, const Scope* globals) {
    Scope names{globals};
    for (const Register& known : registers) names.names[known.name] = Value{Quantity{known.value}, {}};
    names.names["t"] = Value{Quantity{static_cast<double>(iteration)}, {}};
    return names;
}

std::optional<std::uint32_t> system_of_letter(const Grammar& grammar, std::string_view letter) {
    const std::u32string letters = letters_of(letter);
    return letters.size() == 1 ? find_system(grammar, letters[0]) : std::nullopt;
}

}  // namespace filigree::rewriting
