// Edits of finished words: hybrids, reactions, compression, insertion, crossover, mutation (Roncoroni and Crousse,
// "Editing", Fig. 16 to 22).
//
// Pure functions from words to words, over edit tokens (word_tokens.h). A word may be any text; a word whose brackets
// are balanced stays so under every edit. A text that an edit puts in and that would unbalance it is refused, and so is
// a result of more than `most_symbols`, before it is made. All take time linear in the words, the texts and the result
// (chunks: in every pass).
//
// Words are texts: a modifier that comes to stand behind an axis letter, and a '=' behind anything, becomes part of the
// token before it. So the insertion of '=' behind a symbol freezes it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/limits.h"
#include "base/result.h"
#include "engines/rewriting/word_attributes.h"
#include "engines/rewriting/word_tokens.h"

namespace filigree::rewriting {

constexpr std::uint64_t most_edited_symbols = Limits{}.elements;

// Where each symbol of an edited word stood in the word before (in the first, of two), or `new_symbol` for what the
// edit puts: inserted texts, products, second copies, all that comes from the other word. No place stands there twice.
// Edits fill the one that they are given, unless they fail.
using EditTrace = std::vector<std::uint32_t>;
constexpr std::uint32_t new_symbol = UINT32_MAX;

// --- Two words into one

// One behind the other.
std::u32string add_words(std::u32string_view a, std::u32string_view b, EditTrace* trace = nullptr);

// a1 b1 a2 b2 ..., then what the longer has left. Brackets are tokens like all others.
std::u32string breed(std::u32string_view a, std::u32string_view b, EditTrace* trace = nullptr);

// The same, but every token keeps the heading of its parent: Xaaaa and Yaaaa give the stairs XaYaXaYaXaYaXaYa. A
// heading (X, Y or Z with its modifiers) takes no turn of its own. It is put before the next token of its parent where
// another one is in force, except before brackets, which have no heading. Brackets keep and restore headings, those of
// each parent by themselves. A parent that has set none yet takes what it finds. Headings with nothing behind them are
// dropped; turns by P, T and D are tokens like all others, and last until the next heading.
Result<std::u32string> breed_carrying_headings(std::u32string_view a, std::u32string_view b,
                                               std::uint64_t most_symbols = most_edited_symbols,
                                               EditTrace* trace = nullptr);

// --- Reactions between two words

// One side: a token, as exact as it is written (so `a=` does not react as `a` does), and what stands around it in its
// own word. Contexts are followed along the branch: branches beside the way are passed over, to the left the way goes
// on at the parent, to the right the branch is never left. They do not look at '='. Empty: anything.
struct Reactant {
    std::u32string token;
    std::u32string left = {};
    std::u32string right = {};
};

// Between the k-th token of one word and the k-th of the other, whichever of them is `x`. Conditions get the attributes
// of `x`, then of `y`; `happens` is asked with k, from 0, when all else fits, and says whether chance lets it happen.
struct Reaction {
    Reactant x;
    Reactant y;
    std::u32string product;
    std::function<bool(const SymbolAttributes&, const SymbolAttributes&)> condition = {};  // none: always
    std::function<bool(std::uint32_t pair)> happens = {};                                  // none: always
};

// What of a pair without a product is kept; tokens without a partner are treated as one side of such a pair.
enum class Unreacted { both, a, b, none };

struct ReactOptions {
    Unreacted unreacted = Unreacted::both;
    std::span<const std::uint32_t> ages_a = {};  // as attributes_of takes them
    std::span<const std::uint32_t> ages_b = {};
    ObjectTest objects = is_object;
    std::uint64_t most_symbols = most_edited_symbols;
    EditTrace* trace = nullptr;
};

constexpr std::size_t longest_reaction_context = 64;  // in tokens

// The first reaction of the list that fits wins. Brackets do not react.
Result<std::u32string> react(std::u32string_view a, std::u32string_view b, std::span<const Reaction> reactions,
                             const ReactOptions& options = {});

// --- Chunks

struct ChunkPair {
    std::u32string from;
    std::u32string to;
};

struct ChunkOptions {
    std::uint32_t most_passes = 1;  // more: again until nothing is left to replace
    std::uint64_t most_symbols = most_edited_symbols;
    EditTrace* trace = nullptr;  // from before the first pass
};

struct ChunkEdit {
    std::u32string word;
    std::uint64_t replaced = 0;  // chunks, in all passes
    std::uint32_t passes = 0;    // that were made
    bool is_settled = false;     // the last pass left the word as it was
};

// Replaces chunks, from the left, at each place the longest that fits, never overlapping; a chunk matches token by
// token, '=' and modifiers included. Of equal chunks the first in the list counts. Warns if a bound of more than one
// pass ends it.
Result<ChunkEdit> substitute(std::u32string_view word, std::span<const ChunkPair> pairs,
                             const ChunkOptions& options = {});

// The same where every chunk becomes one token (Fig. 16).
Result<ChunkEdit> compress(std::u32string_view word, std::span<const ChunkPair> pairs,
                           const ChunkOptions& options = {});

// Production backwards: `from` is a symbol of the grammar, `to` its successor. Successors that are empty, of the symbol
// alone or unbalanced cannot be taken back: they are left out, the last with a warning.
Result<ChunkEdit> compress_by_rules(std::u32string_view word, std::span<const ChunkPair> productions,
                                    const ChunkOptions& options = {});

// --- Insertion

// Which tokens an edit is for.
struct TokenSelector {
    std::u32string letters = {};                                                              // empty: all objects
    std::function<bool(std::uint32_t index, const SymbolAttributes& attributes)> where = {};  // none: always
    std::span<const std::uint32_t> ages = {};  // as attributes_of takes them
    ObjectTest objects = is_object;
};
std::vector<std::uint32_t> selected_tokens(std::u32string_view word, const std::vector<EditToken>& tokens,
                                           const TokenSelector& selector);

enum class Side { before, after };
Result<std::u32string> insert_beside(std::u32string_view word, std::u32string_view text, Side side,
                                     const TokenSelector& selector, std::uint64_t most_symbols = most_edited_symbols,
                                     EditTrace* trace = nullptr);

// At the beginning or end of branches: d at the end of a[b[c]] gives a[b[cd]d].
struct BranchSelector {
    std::function<bool(const WordBranch&)> where = {};  // none: all
    bool with_trunk = false;                            // the word itself, too, whatever `where` says
    ObjectTest objects = is_object;
};
enum class BranchEnd { begin, end };
Result<std::u32string> append_to_branches(std::u32string_view word, std::u32string_view text, BranchEnd end,
                                          const BranchSelector& selector = {},
                                          std::uint64_t most_symbols = most_edited_symbols, EditTrace* trace = nullptr);

// --- Geometry

// Turns before each chosen token by so many `+`, or `-` where the amount is below 0; 0 puts nothing. They add up along
// the branch, as turns do. `ordinal` counts the chosen tokens, `index` is that of the token, both from 0.
using TurnAmount = std::function<std::int32_t(std::uint32_t ordinal, std::uint32_t index)>;
Result<std::u32string> turn_before(std::u32string_view word, const TokenSelector& selector, char32_t axis,
                                   const TurnAmount& amount, std::uint64_t most_symbols = most_edited_symbols,
                                   EditTrace* trace = nullptr);
inline Result<std::u32string> twist(std::u32string_view word, const TokenSelector& selector, const TurnAmount& amount) {
    return turn_before(word, selector, U'D', amount);
}
inline Result<std::u32string> bend(std::u32string_view word, const TokenSelector& selector, const TurnAmount& amount) {
    return turn_before(word, selector, U'T', amount);
}
inline TurnAmount constant_turn(std::int32_t amount) {
    return [amount](std::uint32_t, std::uint32_t) { return amount; };
}

// `~(factor)` before each chosen token: the steps from there to the end of the branch are scaled. 1 puts nothing; a
// factor that is not above 0 or not finite is an error.
using ShrinkFactor = std::function<double(std::uint32_t ordinal, std::uint32_t index)>;
Result<std::u32string> shrink(std::u32string_view word, const TokenSelector& selector, const ShrinkFactor& factor,
                              std::uint64_t most_symbols = most_edited_symbols, EditTrace* trace = nullptr);
inline ShrinkFactor constant_shrink(double factor) {
    return [factor](std::uint32_t, std::uint32_t) { return factor; };
}

// --- Removal and genetics

// Ranges must lie inside the word and hold both brackets of every pair, or none.
Result<std::u32string> remove_range(std::u32string_view word, TokenRange range, EditTrace* trace = nullptr);
// Of the trunk: all.
std::u32string remove_branches(std::u32string_view word, const BranchSelector& selector, EditTrace* trace = nullptr);

struct WordPair {
    std::u32string a;
    std::u32string b;
};
struct PairTrace {
    EditTrace a;
    EditTrace b;  // places in the first word, too
};
// Each word gets the range of the other in the place of its own. Empty ranges are places between tokens.
Result<WordPair> crossover(std::u32string_view a, TokenRange range_a, std::u32string_view b, TokenRange range_b,
                           PairTrace* trace = nullptr);
Result<WordPair> crossover_branches(std::u32string_view a, std::uint32_t branch_a, std::u32string_view b,
                                    std::uint32_t branch_b,  // ordinals, as in branches_of
                                    PairTrace* trace = nullptr);

// Chances for each token, 0 to 1. They are tried in this order, and at most one comes about.
struct MutationRates {
    double replace = 0;  // by a token drawn from `replacements`
    double remove = 0;
    double twice = 0;  // put a second time behind it
    double swap = 0;   // with the next token, which then does not mutate itself
};
// 64 random bits at an address. Each use of chance has its own `draw`, so that one rate changes nothing of the others.
enum class MutationDraw : std::uint32_t { replace, replacement, remove, twice, swap };
using TokenBits = std::function<std::uint64_t(std::uint32_t token, MutationDraw draw)>;

// Brackets stay where they are. `replacements`: a text whose tokens are drawn, so how often one stands there is its
// weight; its brackets are not drawn. Empty: the word itself.
Result<std::u32string> mutate(std::u32string_view word, const MutationRates& rates, std::u32string_view replacements,
                              const TokenBits& bits, std::uint64_t most_symbols = most_edited_symbols,
                              EditTrace* trace = nullptr);

// --- Cleaning

struct CleanedWord {
    std::u32string word;
    std::vector<std::string> changes;  // "removed 2 ']' that close nothing, at 0 and 5", by code points of the original
};
// Removes blanks, `]` that close nothing and '=' with nothing before it; closes at the end what is open. Modifiers that
// follow no axis letter are legal. What is clean stays as it is.
CleanedWord clean_up(std::u32string_view word, EditTrace* trace = nullptr);

}  // namespace filigree::rewriting
