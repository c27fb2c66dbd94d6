#include "base/number_text.h"
#include "base/random.h"
#include "engines/rewriting/word_edits.h"
#include "engines/rewriting/word_edits_checks.h"
#include "engines/rewriting/word_edits_writer.h"

namespace filigree::rewriting {
namespace {

std::vector<std::u32string_view> replacement_tokens(std::u32string_view text) {
    std::vector<std::u32string_view> texts;
    for (const EditToken token : edit_tokens(text)) {
        if (!is_bracket(token_symbol(text, token))) texts.push_back(token_text(text, token));
    }
    return texts;
}

}  // namespace

Result<std::u32string> mutate(std::u32string_view word, const MutationRates& rates, std::u32string_view replacements,
                              const TokenBits& bits, std::uint64_t most_symbols, EditTrace* trace) {
    for (const double rate : {rates.replace, rates.remove, rates.twice, rates.swap}) {
        if (rate >= 0 && rate <= 1) continue;
        return error("rewriting.mutation-rate", "the rate " + to_text(rate) + " does not lie between 0 and 1");
    }
    const std::vector<EditToken> tokens = edit_tokens(word);
    std::vector<std::u32string_view> drawn_from;
    if (rates.replace > 0) drawn_from = replacement_tokens(replacements.empty() ? word : replacements);
    const auto happens = [&](std::uint32_t token, MutationDraw draw, double rate) {
        return rate > 0 && to_unit(bits(token, draw)) < rate;
    };
    EditWriter out(word, trace);
    out.reserve(word.size());
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        const std::u32string_view text = token_text(word, tokens[i]);
        if (out.text().size() > most_symbols) break;
        if (is_bracket(text.front())) {
            out.keep(tokens[i]);
        } else if (!drawn_from.empty() && happens(i, MutationDraw::replace, rates.replace)) {
            const auto count = static_cast<std::uint32_t>(drawn_from.size());
            out.add(drawn_from[to_whole(bits(i, MutationDraw::replacement), count)]);
        } else if (happens(i, MutationDraw::remove, rates.remove)) {
            continue;
        } else if (happens(i, MutationDraw::twice, rates.twice)) {
            out.keep(tokens[i]);
            out.add(text);
        } else if (i + 1 < tokens.size() && !is_bracket(token_symbol(word, tokens[i + 1])) &&
                   happens(i, MutationDraw::swap, rates.swap)) {
            out.keep(tokens[i + 1]);
            out.keep(tokens[i]);
            ++i;
        } else {
            out.keep(tokens[i]);
        }
    }
    if (out.text().size() > most_symbols) return too_large_word(out.text().size(), most_symbols);
    return out.take();
}

}  // namespace filigree::rewriting
