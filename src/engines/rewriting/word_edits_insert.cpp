// Insertion beside tokens and in branches, and the geometric edits, which insert turns and shrinks.
#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "engines/rewriting/word_edits.h"
#include "engines/rewriting/word_edits_checks.h"
#include "engines/rewriting/word_edits_writer.h"

namespace filigree::rewriting {
namespace {

// The word with one text at some places, given in code points in their order; a place may come twice.
Result<std::u32string> with_text_at(std::u32string_view word, std::u32string_view text,
                                    const std::vector<std::uint32_t>& places, std::uint64_t most_symbols,
                                    EditTrace* trace) {
    const std::uint64_t size = word.size() + std::uint64_t{places.size()} * text.size();
    if (size > most_symbols) return too_large_word(size, most_symbols);
    EditWriter out(word, trace);
    out.reserve(size);
    std::size_t done = 0;
    for (const std::uint32_t place : places) {
        out.keep(done, place);
        out.add(text);
        done = place;
    }
    out.keep_from(done);
    return out.take();
}

// '~', the factor and its brackets.
std::u32string shrink_text(double factor) {
    std::u32string text = U"~(";
    for (const char c : to_text(factor)) text += static_cast<char32_t>(c);
    return text + U")";
}

}  // namespace

std::vector<std::uint32_t> selected_tokens(std::u32string_view word, const std::vector<EditToken>& tokens,
                                           const TokenSelector& selector) {
    const std::vector<SymbolAttributes> attributes = attributes_of(word, tokens, selector.ages, selector.objects);
    std::u32string letters = selector.letters;
    std::sort(letters.begin(), letters.end());
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        const SymbolAttributes& one = attributes[i];
        const bool fits =
            letters.empty() ? one.is_object : std::binary_search(letters.begin(), letters.end(), one.symbol);
        if (fits && (!selector.where || selector.where(i, one))) chosen.push_back(i);
    }
    return chosen;
}

Result<std::u32string> insert_beside(std::u32string_view word, std::u32string_view text, Side side,
                                     const TokenSelector& selector, std::uint64_t most_symbols, EditTrace* trace) {
    if (!is_balanced(text)) return unbalanced_text("the insertion", text);
    const std::vector<EditToken> tokens = edit_tokens(word);
    std::vector<std::uint32_t> places;
    for (const std::uint32_t i : selected_tokens(word, tokens, selector)) {
        places.push_back(side == Side::before ? tokens[i].begin : tokens[i].end);
    }
    return with_text_at(word, text, places, most_symbols, trace);
}

Result<std::u32string> append_to_branches(std::u32string_view word, std::u32string_view text, BranchEnd end,
                                          const BranchSelector& selector, std::uint64_t most_symbols,
                                          EditTrace* trace) {
    if (!is_balanced(text)) return unbalanced_text("the appended text", text);
    const std::vector<EditToken> tokens = edit_tokens(word);
    std::vector<std::uint32_t> places;
    if (selector.with_trunk) places.push_back(end == BranchEnd::begin ? 0 : static_cast<std::uint32_t>(word.size()));
    for (const WordBranch& branch : branches_of(word, tokens, selector.objects)) {
        if (selector.where && !selector.where(branch)) continue;
        places.push_back(end == BranchEnd::begin ? tokens[branch.range.begin].end : tokens[branch.range.end - 1].begin);
    }
    std::sort(places.begin(), places.end());
    return with_text_at(word, text, places, most_symbols, trace);
}

Result<std::u32string> turn_before(std::u32string_view word, const TokenSelector& selector, char32_t axis,
                                   const TurnAmount& amount, std::uint64_t most_symbols, EditTrace* trace) {
    if (!is_axis_letter(axis)) {
        return error("rewriting.no-axis", quoted({&axis, 1}) + " is no axis", {}, {"an axis is one of P T D X Y Z"});
    }
    const std::vector<EditToken> tokens = edit_tokens(word);
    const std::vector<std::uint32_t> chosen = selected_tokens(word, tokens, selector);
    std::vector<std::int32_t> amounts;
    std::uint64_t size = word.size();
    for (std::uint32_t k = 0; k < chosen.size(); ++k) {
        amounts.push_back(amount(k, chosen[k]));
        if (amounts.back() != 0) size += 1 + static_cast<std::uint64_t>(std::abs(std::int64_t{amounts.back()}));
    }
    if (size > most_symbols) return too_large_word(size, most_symbols);
    EditWriter out(word, trace);
    out.reserve(size);
    std::size_t done = 0;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        const std::size_t place = tokens[chosen[k]].begin;
        out.keep(done, place);
        done = place;
        if (amounts[k] == 0) continue;
        const auto count = static_cast<std::size_t>(std::abs(std::int64_t{amounts[k]}));
        out.add(std::u32string(1, axis) + std::u32string(count, amounts[k] > 0 ? U'+' : U'-'));
    }
    out.keep_from(done);
    return out.take();
}

Result<std::u32string> shrink(std::u32string_view word, const TokenSelector& selector, const ShrinkFactor& factor,
                              std::uint64_t most_symbols, EditTrace* trace) {
    const std::vector<EditToken> tokens = edit_tokens(word);
    const std::vector<std::uint32_t> chosen = selected_tokens(word, tokens, selector);
    EditWriter out(word, trace);
    std::size_t done = 0;
    for (std::uint32_t k = 0; k < chosen.size(); ++k) {
        const double by = factor(k, chosen[k]);
        if (!(by > 0) || !std::isfinite(by)) {
            return error("rewriting.shrink-factor", "a factor of " + to_text(by) + " for token " +
                                                        to_text(std::uint64_t{chosen[k]}) +
                                                        " is not above 0 or not finite");
        }
        const std::size_t place = tokens[chosen[k]].begin;
        out.keep(done, place);
        done = place;
        if (by != 1) out.add(shrink_text(by));
        if (const std::uint64_t size = out.text().size() + (word.size() - done); size > most_symbols) {
            return too_large_word(size, most_symbols);
        }
    }
    out.keep_from(done);
    return out.take();
}

}  // namespace filigree::rewriting
