#include "base/number_text.h"
#include "engines/rewriting/word_edits.h"
#include "engines/rewriting/word_edits_writer.h"

namespace filigree::rewriting {
namespace {

bool is_blank(char32_t c) { return c == U' ' || (c >= U'\t' && c <= U'\r') || c == U'\u00A0'; }

// "at 0, 5, 7 and 12 more"
std::string places_text(const std::vector<std::uint32_t>& places) {
    constexpr std::size_t most_listed = 8;
    std::string text = "at ";
    for (std::size_t i = 0; i < places.size() && i < most_listed; ++i) {
        if (i > 0) text += i + 1 == places.size() ? " and " : ", ";
        text += to_text(std::uint64_t{places[i]});
    }
    if (places.size() > most_listed) text += " and " + to_text(std::uint64_t{places.size() - most_listed}) + " more";
    return text;
}

void report(std::vector<std::string>& changes, const std::string& before, const std::string& behind,
            const std::vector<std::uint32_t>& places) {
    if (places.empty()) return;
    changes.push_back(before + " " + to_text(std::uint64_t{places.size()}) + " " + behind + places_text(places));
}

}  // namespace

CleanedWord clean_up(std::u32string_view word, EditTrace* trace) {
    CleanedWord cleaned;
    EditWriter out(word, trace);
    std::u32string solid;
    std::vector<std::uint32_t> origins;  // where its symbols stood
    std::vector<std::uint32_t> blanks, freezes, closing, opening;
    for (std::uint32_t i = 0; i < word.size(); ++i) {
        if (is_blank(word[i])) {
            blanks.push_back(i);
            continue;
        }
        solid += word[i];
        origins.push_back(i);
    }
    const std::vector<EditToken> tokens = edit_tokens(solid);
    const std::vector<std::uint32_t> partners = bracket_partners(solid, tokens);
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        const char32_t symbol = token_symbol(solid, tokens[i]);
        const bool is_alone = is_bracket(symbol) && partners[i] == no_token;
        if (symbol == U'=') {
            for (std::uint32_t at = tokens[i].begin; at < tokens[i].end; ++at) freezes.push_back(origins[at]);
        } else if (is_alone && symbol == U']') {
            closing.push_back(origins[tokens[i].begin]);
        } else {
            for (std::uint32_t at = tokens[i].begin; at < tokens[i].end; ++at) out.keep(origins[at], origins[at] + 1);
            if (is_alone) opening.push_back(origins[tokens[i].begin]);
        }
    }
    out.add(std::u32string(opening.size(), U']'));
    cleaned.word = out.take();
    report(cleaned.changes, "removed", blanks.size() == 1 ? "blank " : "blanks ", blanks);
    report(cleaned.changes, "removed", "'=' with nothing before, ", freezes);
    report(cleaned.changes, "removed", closing.size() == 1 ? "']' that closes nothing, " : "']' that close nothing, ",
           closing);
    report(cleaned.changes, "added", "']' at the end for '[' ", opening);
    return cleaned;
}

}  // namespace filigree::rewriting
