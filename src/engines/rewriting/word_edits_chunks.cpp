// Chunks become other chunks. All are found in one sweep from the right by an automaton of the reversed chunks (Aho and
// Corasick): it gives the longest chunk that begins at each token, however long and alike chunks are.
#include <algorithm>
#include <array>
#include <numeric>
#include <unordered_map>

#include "base/number_text.h"
#include "engines/rewriting/word_edits.h"
#include "engines/rewriting/word_edits_checks.h"
#include "engines/rewriting/word_edits_writer.h"

namespace filigree::rewriting {
namespace {

constexpr std::uint32_t none = UINT32_MAX;

// Numbers for the tokens that occur in chunks.
class TokenNumbers {
public:
    TokenNumbers() { short_.fill(none); }

    std::uint32_t add(std::u32string_view token) {
        const std::uint32_t known = find(token);
        if (known != none) return known;
        const std::uint32_t number = count_++;
        if (is_short(token)) {
            short_[token.front()] = number;
        } else {
            long_.emplace(token, number);
        }
        return number;
    }
    std::uint32_t find(std::u32string_view token) const {
        if (is_short(token)) return short_[token.front()];
        if (long_.empty()) return none;
        const auto found = long_.find(token);
        return found == long_.end() ? none : found->second;
    }

private:
    static bool is_short(std::u32string_view token) { return token.size() == 1 && token.front() < 128; }

    std::array<std::uint32_t, 128> short_;
    std::unordered_map<std::u32string_view, std::uint32_t> long_;
    std::uint32_t count_ = 0;
};

class ChunkAutomaton {
public:
    // The chunks must outlive it; none is empty.
    explicit ChunkAutomaton(std::span<const ChunkPair> pairs) {
        for (std::uint32_t p = 0; p < pairs.size(); ++p) add(pairs[p].from, p);
        link();
    }

    // For every token of the word, the pair with the longest chunk that begins there; `none` for none.
    std::vector<std::uint32_t> longest_at(std::u32string_view word, const std::vector<EditToken>& tokens) const {
        std::vector<std::uint32_t> longest(tokens.size(), none);
        std::uint32_t state = 0;
        for (std::size_t i = tokens.size(); i-- > 0;) {
            const std::uint32_t number = numbers_.find(token_text(word, tokens[i]));
            state = number == none ? 0 : after(state, number);
            longest[i] = nodes_[state].chunk;
        }
        return longest;
    }
    std::uint32_t length(std::uint32_t pair) const { return lengths_[pair]; }  // in tokens

private:
    struct Node {
        std::uint32_t parent = 0;
        std::uint32_t token = 0;  // by which it is reached from there
        std::uint32_t depth = 0;
        std::uint32_t shorter = 0;   // the longest end of its text that is a node, too
        std::uint32_t chunk = none;  // the longest chunk that its text ends with
    };

    static std::uint64_t edge(std::uint32_t node, std::uint32_t token) { return std::uint64_t{node} << 32 | token; }

    void add(std::u32string_view chunk, std::uint32_t pair) {
        const std::vector<EditToken> tokens = edit_tokens(chunk);
        lengths_.push_back(static_cast<std::uint32_t>(tokens.size()));
        std::uint32_t node = 0;
        for (std::size_t i = tokens.size(); i-- > 0;) {
            const std::uint32_t token = numbers_.add(token_text(chunk, tokens[i]));
            const auto [found, is_new] =
                next_.try_emplace(edge(node, token), static_cast<std::uint32_t>(nodes_.size()));
            if (is_new) nodes_.push_back({node, token, nodes_[node].depth + 1, 0, none});
            node = found->second;
        }
        if (nodes_[node].chunk == none) nodes_[node].chunk = pair;
    }

    // From the shallow nodes to the deep, since each stands on shallower ones.
    void link() {
        std::vector<std::uint32_t> order(nodes_.size());
        std::iota(order.begin(), order.end(), 0U);
        std::sort(order.begin(), order.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return nodes_[a].depth < nodes_[b].depth; });
        for (const std::uint32_t n : order) {
            Node& node = nodes_[n];
            if (node.depth > 1) node.shorter = after(nodes_[node.parent].shorter, node.token);
            if (node.chunk == none) node.chunk = nodes_[node.shorter].chunk;
        }
    }

    std::uint32_t after(std::uint32_t state, std::uint32_t token) const {
        while (true) {
            const auto found = next_.find(edge(state, token));
            if (found != next_.end()) return found->second;
            if (state == 0) return 0;
            state = nodes_[state].shorter;
        }
    }

    TokenNumbers numbers_;
    std::vector<Node> nodes_ = std::vector<Node>(1);
    std::unordered_map<std::uint64_t, std::uint32_t> next_;
    std::vector<std::uint32_t> lengths_;
};

// The trace of two edits, one behind the other.
EditTrace followed(const EditTrace& first, EditTrace second) {
    for (std::uint32_t& place : second) place = place == new_symbol ? new_symbol : first[place];
    return second;
}

// One pass over the word of `edit`. Errors leave it as it was.
Diagnostics replace_once(ChunkEdit& edit, std::span<const ChunkPair> pairs, const ChunkAutomaton& automaton,
                         const ChunkOptions& options) {
    const std::vector<EditToken> tokens = edit_tokens(edit.word);
    const std::vector<std::uint32_t> longest = automaton.longest_at(edit.word, tokens);
    std::uint64_t size = edit.word.size();
    std::uint64_t replaced = 0;
    for (std::size_t i = 0; i < tokens.size();) {
        if (longest[i] == none) {
            ++i;
            continue;
        }
        size += pairs[longest[i]].to.size();
        size -= pairs[longest[i]].from.size();
        i += automaton.length(longest[i]);
        ++replaced;
    }
    ++edit.passes;
    edit.is_settled = replaced == 0;
    if (replaced == 0) return {};
    if (size > options.most_symbols) return {too_large_word(size, options.most_symbols)};
    EditTrace trace;
    EditWriter out(edit.word, options.trace != nullptr ? &trace : nullptr);
    out.reserve(size);
    for (std::size_t i = 0; i < tokens.size();) {
        if (longest[i] == none) {
            out.keep(tokens[i++]);
        } else {
            out.add(pairs[longest[i]].to);
            i += automaton.length(longest[i]);
        }
    }
    edit.replaced += replaced;
    edit.is_settled = out.text() == edit.word;
    edit.word = out.take();
    if (options.trace != nullptr) *options.trace = followed(*options.trace, std::move(trace));
    return {};
}

Diagnostics pair_errors(std::span<const ChunkPair> pairs) {
    Diagnostics errors;
    for (const ChunkPair& pair : pairs) {
        if (pair.from.empty()) {
            errors.push_back(
                error("rewriting.empty-chunk", "a chunk to be replaced by " + quoted(pair.to) + " is empty"));
        } else if (bracket_shape(pair.from) != bracket_shape(pair.to)) {
            errors.push_back(error(
                "rewriting.unbalanced-chunk",
                "the chunk " + quoted(pair.from) + " has other brackets than " + quoted(pair.to) + " in its place", {},
                {"both must open and close as many branches"}));
        }
    }
    return errors;
}

}  // namespace

Result<ChunkEdit> substitute(std::u32string_view word, std::span<const ChunkPair> pairs, const ChunkOptions& options) {
    if (Diagnostics errors = pair_errors(pairs); !errors.empty()) return errors;
    const ChunkAutomaton automaton(pairs);
    ChunkEdit edit;
    edit.word = word;
    if (options.trace != nullptr) {
        options.trace->resize(word.size());
        std::iota(options.trace->begin(), options.trace->end(), 0U);
    }
    while (!edit.is_settled && edit.passes < options.most_passes) {
        Diagnostics errors = replace_once(edit, pairs, automaton, options);
        if (!errors.empty()) return errors;
    }
    Diagnostics warnings;
    if (!edit.is_settled && options.most_passes > 1) {
        warnings.push_back(warning("rewriting.chunks-not-settled", "after " + to_text(std::uint64_t{edit.passes}) +
                                                                       " passes there is still something to replace"));
    }
    return {std::move(edit), std::move(warnings)};
}

Result<ChunkEdit> compress(std::u32string_view word, std::span<const ChunkPair> pairs, const ChunkOptions& options) {
    Diagnostics errors;
    for (const ChunkPair& pair : pairs) {
        if (edit_tokens(pair.to).size() == 1) continue;
        errors.push_back(error("rewriting.not-one-symbol", quoted(pair.to) + " is not one symbol", {},
                               {"compress puts one symbol for a chunk, substitute any text"}));
    }
    if (!errors.empty()) return errors;
    return substitute(word, pairs, options);
}

Result<ChunkEdit> compress_by_rules(std::u32string_view word, std::span<const ChunkPair> productions,
                                    const ChunkOptions& options) {
    std::vector<ChunkPair> backwards;
    Diagnostics warnings;
    for (const ChunkPair& production : productions) {
        if (production.to.empty() || production.to == production.from) continue;
        if (bracket_shape(production.from) != bracket_shape(production.to)) {
            warnings.push_back(
                warning("rewriting.unbalanced-production",
                        "the successor " + quoted(production.to) + " is not balanced, so it cannot be taken back"));
            continue;
        }
        backwards.push_back({production.to, production.from});
    }
    Result<ChunkEdit> edit = compress(word, backwards, options);
    if (!edit) return edit;
    append(warnings, edit.diagnostics());
    return {std::move(*edit), std::move(warnings)};
}

}  // namespace filigree::rewriting
