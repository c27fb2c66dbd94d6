#include "engines/rewriting/word_edits.h"

#include <algorithm>

#include "base/number_text.h"
#include "engines/rewriting/word_edits_checks.h"

namespace filigree::rewriting {
namespace {

// One parent of a hybrid that carries headings, read from left to right.
class HeadedReader {
public:
    explicit HeadedReader(std::u32string_view word) : word_(word), tokens_(edit_tokens(word)) {}

    // The next token that is no heading; empty at the end.
    std::u32string_view next() {
        while (next_ < tokens_.size()) {
            const EditToken token = tokens_[next_++];
            const char32_t symbol = token_symbol(word_, token);
            if (symbol == U'X' || symbol == U'Y' || symbol == U'Z') {
                heading_ = token_text(word_, token);
                continue;
            }
            if (symbol == U'[') outer_.push_back(heading_);
            if (symbol == U']' && !outer_.empty()) {
                heading_ = outer_.back();
                outer_.pop_back();
            }
            return token_text(word_, token);
        }
        return {};
    }
    std::u32string_view heading() const { return heading_; }  // of the token that `next` gave

private:
    std::u32string_view word_;
    std::vector<EditToken> tokens_;
    std::size_t next_ = 0;
    std::u32string_view heading_;
    std::vector<std::u32string_view> outer_;
};

class HeadedWriter {
public:
    void put(std::u32string_view token, std::u32string_view heading) {
        const char32_t symbol = token.front();
        if (symbol == U'[') outer_.push_back(heading_);
        if (symbol == U']' && !outer_.empty()) {
            heading_ = outer_.back();
            outer_.pop_back();
        }
        if (!is_bracket(symbol) && !heading.empty() && heading != heading_) {
            word_ += heading;
            heading_ = heading;
        }
        word_ += token;
    }
    std::u32string& word() { return word_; }

private:
    std::u32string word_;
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

// The word with another text where the range stood.
std::u32string with_range(std::u32string_view word, const std::vector<EditToken>& tokens, TokenRange range,
                          std::u32string_view text) {
    const std::size_t begin = range.begin < tokens.size() ? tokens[range.begin].begin : word.size();
    const std::size_t end = range.begin == range.end ? begin : tokens[range.end - 1].end;
    std::u32string out;
    out.reserve(word.size() - (end - begin) + text.size());
    out += word.substr(0, begin);
    out += text;
    out += word.substr(end);
    return out;
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

std::u32string add_words(std::u32string_view a, std::u32string_view b) {
    std::u32string out(a);
    out += b;
    return out;
}

std::u32string breed(std::u32string_view a, std::u32string_view b) {
    const std::vector<EditToken> tokens_a = edit_tokens(a);
    const std::vector<EditToken> tokens_b = edit_tokens(b);
    std::u32string out;
    out.reserve(a.size() + b.size());
    for (std::size_t i = 0; i < std::max(tokens_a.size(), tokens_b.size()); ++i) {
        if (i < tokens_a.size()) out += token_text(a, tokens_a[i]);
        if (i < tokens_b.size()) out += token_text(b, tokens_b[i]);
    }
    return out;
}

Result<std::u32string> breed_carrying_headings(std::u32string_view a, std::u32string_view b,
                                               std::uint64_t most_symbols) {
    HeadedReader parents[] = {HeadedReader(a), HeadedReader(b)};
    HeadedWriter out;
    for (bool any = true; any;) {
        any = false;
        for (HeadedReader& parent : parents) {
            const std::u32string_view token = parent.next();
            if (token.empty()) continue;
            out.put(token, parent.heading());
            any = true;
        }
        if (out.word().size() > most_symbols) return too_large_word(out.word().size(), most_symbols);
    }
    return std::move(out.word());
}

Result<std::u32string> remove_range(std::u32string_view word, TokenRange range) {
    const std::vector<EditToken> tokens = edit_tokens(word);
    if (Diagnostics errors = range_errors("the word", word, tokens, range); !errors.empty()) return errors;
    return with_range(word, tokens, range, {});
}

std::u32string remove_branches(std::u32string_view word, const BranchSelector& selector) {
    if (selector.with_trunk) return {};
    const std::vector<EditToken> tokens = edit_tokens(word);
    std::u32string out;
    std::uint32_t kept_from = 0;  // tokens before it are done with
    for (const WordBranch& branch : branches_of(word, tokens, selector.objects)) {
        if (branch.range.begin < kept_from || (selector.where && !selector.where(branch))) continue;
        out += range_text(word, tokens, {kept_from, branch.range.begin});
        kept_from = branch.range.end;
    }
    out += range_text(word, tokens, {kept_from, static_cast<std::uint32_t>(tokens.size())});
    return out;
}

Result<WordPair> crossover(std::u32string_view a, TokenRange range_a, std::u32string_view b, TokenRange range_b) {
    const std::vector<EditToken> tokens_a = edit_tokens(a);
    const std::vector<EditToken> tokens_b = edit_tokens(b);
    Diagnostics errors = range_errors(first_word, a, tokens_a, range_a);
    append(errors, range_errors(second_word, b, tokens_b, range_b));
    if (!errors.empty()) return errors;
    return WordPair{with_range(a, tokens_a, range_a, range_text(b, tokens_b, range_b)),
                    with_range(b, tokens_b, range_b, range_text(a, tokens_a, range_a))};
}

Result<WordPair> crossover_branches(std::u32string_view a, std::uint32_t branch_a, std::u32string_view b,
                                    std::uint32_t branch_b) {
    const Result<TokenRange> range_a = range_of_branch(first_word, a, edit_tokens(a), branch_a);
    if (!range_a) return range_a.diagnostics();
    const Result<TokenRange> range_b = range_of_branch(second_word, b, edit_tokens(b), branch_b);
    if (!range_b) return range_b.diagnostics();
    return crossover(a, *range_a, b, *range_b);
}

}  // namespace filigree::rewriting
