#include "engines/rewriting/word_edits.h"

#include <algorithm>

#include "base/number_text.h"
#include "engines/rewriting/word_edits_checks.h"
#include "engines/rewriting/word_edits_writer.h"

namespace filigree::rewriting {
namespace {

// One parent of a hybrid that carries headings, read from left to right.
class HeadedReader {
public:
    explicit HeadedReader(std::u32string_view word) : word_(word), tokens_(edit_tokens(word)) {}

    // The next token that is no heading; none at the end.
    std::optional<EditToken> next() {
        while (next_ < tokens_.size()) {
            const EditToken token = tokens_[next_++];
            const char32_t symbol = token_symbol(word_, token);
            if (symbol == U'X' || symbol == U'Y' || symbol == U'Z') {
                heading_ = token;
                continue;
            }
            if (symbol == U'[') outer_.push_back(heading_);
            if (symbol == U']' && !outer_.empty()) {
                heading_ = outer_.back();
                outer_.pop_back();
            }
            return token;
        }
        return std::nullopt;
    }
    std::u32string_view word() const { return word_; }
    EditToken heading() const { return heading_; }  // of the token that `next` gave; empty where there is none

private:
    std::u32string_view word_;
    std::vector<EditToken> tokens_;
    std::size_t next_ = 0;
    EditToken heading_;
    std::vector<EditToken> outer_;
};

class HeadedWriter {
public:
    HeadedWriter(std::u32string_view first, EditTrace* trace) : out_(first, trace) {}

    void put(const HeadedReader& parent, EditToken token, bool is_first) {
        const char32_t symbol = token_symbol(parent.word(), token);
        const std::u32string_view heading = token_text(parent.word(), parent.heading());
        if (symbol == U'[') outer_.push_back(heading_);
        if (symbol == U']' && !outer_.empty()) {
            heading_ = outer_.back();
            outer_.pop_back();
        }
        if (!is_bracket(symbol) && !heading.empty() && heading != heading_) {
            out_.add(heading);
            heading_ = heading;
        }
        if (is_first) {
            out_.keep(token);
        } else {
            out_.add(token_text(parent.word(), token));
        }
    }
    EditWriter& out() { return out_; }

private:
    EditWriter out_;
    std::u32string_view heading_;  // in force where the word ends
    std::vector<std::u32string_view> outer_;
};

Diagnostics range_errors(std::string_view name, std::u32string_view word, const std::vector<EditToken>& tokens,
                         TokenRange range) {
    const auto text = [](TokenRange r) {
        return to_text(std::uint64_t{r.begin}) + " to " + to_text(std::uint64_t{r.end});
    };
    if (range.begin > range.end || range.end > tokens.size()) {
        return {error("rewriting.range-outside", "the range " + text(range) + " does not lie inside " +
                                                     std::string(name) + ", which has " +
                                                     to_text(std::uint64_t{tokens.size()}) + " tokens")};
    }
    if (is_balanced(range_text(word, tokens, range))) return {};
    std::vector<std::string> hints;
    if (const auto wider = balanced_range(word, tokens, range)) hints.push_back("a whole range is " + text(*wider));
    return {error("rewriting.torn-range", "the range " + text(range) + " of " + std::string(name) + " tears a branch",
                  {}, std::move(hints))};
}

// A range in code points; an empty one is a place.
EditToken piece_of(std::u32string_view word, const std::vector<EditToken>& tokens, TokenRange range) {
    const auto size = static_cast<std::uint32_t>(word.size());
    const std::uint32_t begin = range.begin < tokens.size() ? tokens[range.begin].begin : size;
    return {begin, range.begin == range.end ? begin : tokens[range.end - 1].end};
}

// The word with another text in the place of a piece.
std::u32string with_piece(std::u32string_view word, EditToken piece, std::u32string_view text, EditTrace* trace) {
    EditWriter out(word, trace);
    out.reserve(word.size() - (piece.end - piece.begin) + text.size());
    out.keep(0, piece.begin);
    out.add(text);
    out.keep_from(piece.end);
    return out.take();
}

Result<TokenRange> range_of_branch(std::string_view name, std::u32string_view word,
                                   const std::vector<EditToken>& tokens, std::uint32_t ordinal) {
    const std::vector<WordBranch> branches = branches_of(word, tokens);
    if (ordinal < branches.size()) return branches[ordinal].range;
    return error("rewriting.no-such-branch", std::string(name) + " has no branch " + to_text(std::uint64_t{ordinal}) +
                                                 ", it has " + to_text(std::uint64_t{branches.size()}));
}

constexpr std::string_view first_word = "the first word";
constexpr std::string_view second_word = "the second word";

}  // namespace

std::u32string add_words(std::u32string_view a, std::u32string_view b, EditTrace* trace) {
    EditWriter out(a, trace);
    out.reserve(a.size() + b.size());
    out.keep_from(0);
    out.add(b);
    return out.take();
}

std::u32string breed(std::u32string_view a, std::u32string_view b, EditTrace* trace) {
    const std::vector<EditToken> tokens_a = edit_tokens(a);
    const std::vector<EditToken> tokens_b = edit_tokens(b);
    EditWriter out(a, trace);
    out.reserve(a.size() + b.size());
    for (std::size_t i = 0; i < std::max(tokens_a.size(), tokens_b.size()); ++i) {
        if (i < tokens_a.size()) out.keep(tokens_a[i]);
        if (i < tokens_b.size()) out.add(token_text(b, tokens_b[i]));
    }
    return out.take();
}

Result<std::u32string> breed_carrying_headings(std::u32string_view a, std::u32string_view b, std::uint64_t most_symbols,
                                               EditTrace* trace) {
    HeadedReader parents[] = {HeadedReader(a), HeadedReader(b)};
    HeadedWriter writer(a, trace);
    for (bool any = true; any;) {
        any = false;
        for (HeadedReader& parent : parents) {
            const std::optional<EditToken> token = parent.next();
            if (!token) continue;
            writer.put(parent, *token, &parent == &parents[0]);
            any = true;
        }
        const std::size_t size = writer.out().text().size();
        if (size > most_symbols) return too_large_word(size, most_symbols);
    }
    return writer.out().take();
}

Result<std::u32string> remove_range(std::u32string_view word, TokenRange range, EditTrace* trace) {
    const std::vector<EditToken> tokens = edit_tokens(word);
    if (Diagnostics errors = range_errors("the word", word, tokens, range); !errors.empty()) return errors;
    return with_piece(word, piece_of(word, tokens, range), {}, trace);
}

std::u32string remove_branches(std::u32string_view word, const BranchSelector& selector, EditTrace* trace) {
    EditWriter out(word, trace);
    if (selector.with_trunk) return {};
    const std::vector<EditToken> tokens = edit_tokens(word);
    std::uint32_t kept_from = 0;  // tokens before it are done with
    for (const WordBranch& branch : branches_of(word, tokens, selector.objects)) {
        if (branch.range.begin < kept_from || (selector.where && !selector.where(branch))) continue;
        out.keep(piece_of(word, tokens, {kept_from, branch.range.begin}));
        kept_from = branch.range.end;
    }
    out.keep(piece_of(word, tokens, {kept_from, static_cast<std::uint32_t>(tokens.size())}));
    return out.take();
}

Result<WordPair> crossover(std::u32string_view a, TokenRange range_a, std::u32string_view b, TokenRange range_b,
                           PairTrace* trace) {
    const std::vector<EditToken> tokens_a = edit_tokens(a);
    const std::vector<EditToken> tokens_b = edit_tokens(b);
    Diagnostics errors = range_errors(first_word, a, tokens_a, range_a);
    append(errors, range_errors(second_word, b, tokens_b, range_b));
    if (!errors.empty()) return errors;
    const EditToken piece_a = piece_of(a, tokens_a, range_a);
    const EditToken piece_b = piece_of(b, tokens_b, range_b);
    EditWriter second(a, trace != nullptr ? &trace->b : nullptr);  // holds a piece of the first
    second.add(b.substr(0, piece_b.begin));
    second.keep(piece_a);
    second.add(b.substr(piece_b.end));
    return WordPair{with_piece(a, piece_a, token_text(b, piece_b), trace != nullptr ? &trace->a : nullptr),
                    second.take()};
}

Result<WordPair> crossover_branches(std::u32string_view a, std::uint32_t branch_a, std::u32string_view b,
                                    std::uint32_t branch_b, PairTrace* trace) {
    const Result<TokenRange> range_a = range_of_branch(first_word, a, edit_tokens(a), branch_a);
    if (!range_a) return range_a.diagnostics();
    const Result<TokenRange> range_b = range_of_branch(second_word, b, edit_tokens(b), branch_b);
    if (!range_b) return range_b.diagnostics();
    return crossover(a, *range_a, b, *range_b, trace);
}

}  // namespace filigree::rewriting
