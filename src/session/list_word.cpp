#include "session/list_word.h"

#include <nlohmann/json.hpp>

#include "base/unicode.h"
#include "engines/rewriting/decide.h"
#include "engines/rewriting/implicit_word.h"
#include "engines/rewriting/plain.h"
#include "engines/rewriting/symbols.h"

namespace filigree {
namespace {

constexpr std::uint64_t most_in_slice = 100'000'000;

bool is_control(char32_t letter) { return letter < 0x20 || (letter >= 0x7F && letter < 0xA0); }

std::string shown_word(const rewriting::Word& word, const rewriting::Alphabet& alphabet) {
    for (std::size_t s = 0; s < alphabet.size(); ++s) {
        if (is_control(alphabet[static_cast<rewriting::Symbol>(s)].letter)) {
            return shown(rewriting::letters_of(word, alphabet));
        }
    }
    return rewriting::to_text(word, alphabet);
}

}  // namespace

std::string shown(std::u32string_view letters) {
    std::string text;
    for (const char32_t letter : letters) {
        if (!is_control(letter)) {
            unicode::append_utf8(text, letter);
            continue;
        }
        constexpr std::string_view digits = "0123456789abcdef";
        text += "\\u{";
        if (letter >= 0x10) text += digits[letter >> 4];
        text += digits[letter & 15];
        text += '}';
    }
    return text;
}

std::string word_text(const rewriting::Derivation& derivation) {
    return shown_word(derivation.word, derivation.alphabet) + "\n";
}

std::string word_json(const OpenedDocument& opened, const CheckedDocument& checked,
                      const rewriting::Derivation& derivation) {
    using Json = nlohmann::ordered_json;
    Json json;
    json["document"] = opened.name;
    json["engine"] = checked.settings->engine;
    json["seed"] = checked.settings->seed;
    json["iteration"] = derivation.iteration;
    json["length"] = derivation.word.size();
    json["word"] = rewriting::to_text(derivation.word, derivation.alphabet);
    json["waiting"] = Json::array();
    const std::vector<rewriting::Symbol>& symbols = derivation.word.symbols;
    std::size_t index = 0;
    for (std::size_t place = 0; place < symbols.size(); ++index) {
        const std::size_t turns = rewriting::freezes_behind(symbols, place);
        if (turns > 0) {
            const char32_t letter = derivation.alphabet[symbols[place]].letter;
            json["waiting"].push_back(
                {{"index", index}, {"symbol", rewriting::to_utf8(std::u32string(1, letter))}, {"turns", turns}});
        }
        place += 1 + turns;
    }
    json["registers"] = Json::object();
    for (const rewriting::Register& known : derivation.registers) json["registers"][known.name] = known.value;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<std::string> answer(const OpenedDocument& opened, const CheckedDocument& checked,
                           std::optional<std::uint64_t> steps, const WordQuestion& question) {
    const rewriting::Grammar& grammar = *checked.words;
    Result<rewriting::Derivation> derivation = rewriting::begin(grammar, word_options(opened, checked));
    if (!derivation) return derivation.diagnostics();
    const auto plain = rewriting::plain_substitution(*derivation, grammar);
    if (!plain) {
        return error(
            "rewriting.not-plain",
            "only words of a grammar without choices, contexts, edits and special symbols can be asked for that",
            checked.settings->engine_span);
    }
    const std::uint64_t count = steps.value_or(grammar.systems[0].iterations);
    const std::vector<rewriting::Symbol>& axiom = derivation->word.symbols;
    if (question.kind == WordQuestion::Kind::length) {
        return rewriting::to_text(rewriting::length_of_word(*plain, axiom, count)) + "\n";
    }
    if (question.kind == WordQuestion::Kind::counts) {
        const std::array<rewriting::BigInt, 256> counts = rewriting::counts_of_symbols(*plain, axiom, count);
        std::string text;
        for (std::size_t s = 0; s < derivation->alphabet.size(); ++s) {
            if (counts[s] == rewriting::BigInt()) continue;
            const char32_t letter = derivation->alphabet[static_cast<rewriting::Symbol>(s)].letter;
            text += shown({&letter, 1}) + " " + rewriting::to_text(counts[s]) + "\n";
        }
        return text;
    }
    const std::optional<rewriting::BigInt> first = rewriting::parse_bigint(question.first);
    if (!first || question.count > most_in_slice) {
        return fault(Fault::usage, "rewriting.bad-slice",
                     "a slice is FIRST:COUNT, from 0, of at most " + std::to_string(most_in_slice) + " symbols");
    }
    const Result<rewriting::ImplicitWord> word =
        rewriting::implicit_word(*plain, axiom, count, checked.settings->limits.memory_bytes);
    if (!word) return word.diagnostics();
    rewriting::Word slice;
    slice.symbols = word->slice(*first, question.count);
    return shown_word(slice, derivation->alphabet) + "\n";
}

}  // namespace filigree
