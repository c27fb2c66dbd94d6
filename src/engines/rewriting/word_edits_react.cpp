#include <algorithm>
#include <map>

#include "base/number_text.h"
#include "engines/rewriting/word_edits.h"
#include "engines/rewriting/word_edits_checks.h"
#include "engines/rewriting/word_edits_writer.h"

namespace filigree::rewriting {
namespace {

// A token without the '=' behind it: as contexts see it.
std::u32string_view thawed(std::u32string_view token) {
    const std::size_t last = token.find_last_not_of(U'=');
    return token.substr(0, last == std::u32string_view::npos ? 1 : last + 1);
}

struct Neighbours {
    std::vector<std::uint32_t> left, right;  // along the branch; no_token at its end
};

// Those of all tokens in two sweeps, so that rows of branches cost no more than rows of symbols.
Neighbours neighbours_of(std::u32string_view word, const std::vector<EditToken>& tokens) {
    Neighbours all;
    all.left.resize(tokens.size());
    all.right.resize(tokens.size());
    std::vector<std::uint32_t> outer;
    std::uint32_t last = no_token;
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        const char32_t symbol = token_symbol(word, tokens[i]);
        if (symbol == U']' && !outer.empty()) {
            last = outer.back();
            outer.pop_back();
        }
        all.left[i] = last;
        if (symbol == U'[') outer.push_back(last);
        if (!is_bracket(symbol)) last = i;
    }
    outer.clear();
    std::uint32_t next = no_token;
    for (std::uint32_t i = static_cast<std::uint32_t>(tokens.size()); i-- > 0;) {
        const char32_t symbol = token_symbol(word, tokens[i]);
        if (symbol == U'[' && !outer.empty()) {
            next = outer.back();
            outer.pop_back();
        }
        all.right[i] = next;
        if (symbol == U']') {
            outer.push_back(next);
            next = no_token;
        }
        if (!is_bracket(symbol)) next = i;
    }
    return all;
}

// One of the two words, with what reactions ask of it.
struct Partner {
    std::u32string_view word;
    std::vector<EditToken> tokens;
    std::vector<SymbolAttributes> attributes;
    Neighbours neighbours;

    std::u32string_view text(std::uint32_t token) const { return token_text(word, tokens[token]); }
};

Partner partner_of(std::u32string_view word, std::span<const std::uint32_t> ages, const ObjectTest& objects) {
    Partner partner;
    partner.word = word;
    partner.tokens = edit_tokens(word);
    partner.attributes = attributes_of(word, partner.tokens, ages, objects);
    partner.neighbours = neighbours_of(word, partner.tokens);
    return partner;
}

using ContextTokens = std::vector<std::u32string_view>;  // the nearest first

struct Environment {
    ContextTokens left, right;
};

bool stands_in(const Partner& partner, std::uint32_t token, const Environment& wanted) {
    const auto follows = [&](const ContextTokens& context, const std::vector<std::uint32_t>& links) {
        std::uint32_t at = token;
        return std::all_of(context.begin(), context.end(), [&](std::u32string_view one) {
            at = links[at];
            if (at == no_token) return false;
            return thawed(partner.text(at)) == one;
        });
    };
    return follows(wanted.left, partner.neighbours.left) && follows(wanted.right, partner.neighbours.right);
}

// The reactions by what they are between, in the order of the list for each.
class ReactionTable {
public:
    explicit ReactionTable(std::span<const Reaction> reactions) : reactions_(reactions) {
        for (std::uint32_t r = 0; r < reactions.size(); ++r) {
            const Reaction& one = reactions[r];
            check(one);
            x_.push_back(environment(one.x));
            y_.push_back(environment(one.y));
            by_tokens_[{one.x.token, one.y.token}].push_back({r, false});
            by_tokens_[{one.y.token, one.x.token}].push_back({r, true});
        }
    }
    const Diagnostics& errors() const { return errors_; }

    // What the tokens of a pair come to; null where they do not react.
    const std::u32string* product(const Partner& a, const Partner& b, std::uint32_t pair) const {
        const auto found = by_tokens_.find({a.text(pair), b.text(pair)});
        if (found == by_tokens_.end()) return nullptr;
        for (const Entry& entry : found->second) {
            const Reaction& one = reactions_[entry.reaction];
            const Partner& x = entry.is_swapped ? b : a;
            const Partner& y = entry.is_swapped ? a : b;
            if (!stands_in(x, pair, x_[entry.reaction]) || !stands_in(y, pair, y_[entry.reaction])) continue;
            if (one.condition && !one.condition(x.attributes[pair], y.attributes[pair])) continue;
            if (one.happens && !one.happens(pair)) continue;
            return &one.product;
        }
        return nullptr;
    }

private:
    struct Entry {
        std::uint32_t reaction = 0;
        bool is_swapped = false;  // the token of the first word is its y
    };

    Environment environment(const Reactant& reactant) {
        Environment out{context(reactant.left), context(reactant.right)};
        std::reverse(out.left.begin(), out.left.end());
        return out;
    }
    ContextTokens context(std::u32string_view text) {
        ContextTokens tokens;
        for (const EditToken token : edit_tokens(text)) {
            tokens.push_back(thawed(token_text(text, token)));
            if (!is_bracket(tokens.back().front())) continue;
            errors_.push_back(error("rewriting.bracket-in-context",
                                    "the context " + quoted(text) + " of a reaction holds a bracket"));
            break;
        }
        if (tokens.size() > longest_reaction_context) {
            errors_.push_back(
                error("rewriting.long-context", "the context " + quoted(text) + " of a reaction has more than " +
                                                    to_text(std::uint64_t{longest_reaction_context}) + " symbols"));
        }
        return tokens;
    }
    void check(const Reaction& reaction) {
        for (const std::u32string_view token :
             {std::u32string_view(reaction.x.token), std::u32string_view(reaction.y.token)}) {
            if (edit_tokens(token).size() == 1 && !is_bracket(token.front())) continue;
            errors_.push_back(error("rewriting.no-reactant", quoted(token) + " is not one symbol that can react", {},
                                    {"a reactant is one symbol with its modifiers and '=', and no bracket"}));
        }
        if (!is_balanced(reaction.product)) errors_.push_back(unbalanced_text("the product", reaction.product));
    }

    std::span<const Reaction> reactions_;
    std::vector<Environment> x_, y_;
    std::map<std::pair<std::u32string_view, std::u32string_view>, std::vector<Entry>> by_tokens_;
    Diagnostics errors_;
};

}  // namespace

Result<std::u32string> react(std::u32string_view a, std::u32string_view b, std::span<const Reaction> reactions,
                             const ReactOptions& options) {
    const ReactionTable table(reactions);
    if (!table.errors().empty()) return table.errors();
    const Partner first = partner_of(a, options.ages_a, options.objects);
    const Partner second = partner_of(b, options.ages_b, options.objects);
    const bool keeps_a = options.unreacted == Unreacted::both || options.unreacted == Unreacted::a;
    const bool keeps_b = options.unreacted == Unreacted::both || options.unreacted == Unreacted::b;
    EditWriter out(a, options.trace);
    for (std::uint32_t i = 0; i < std::max(first.tokens.size(), second.tokens.size()); ++i) {
        const bool has_a = i < first.tokens.size();
        const bool has_b = i < second.tokens.size();
        const std::u32string* const product = has_a && has_b ? table.product(first, second, i) : nullptr;
        if (product != nullptr) {
            out.add(*product);
        } else {
            if (has_a && keeps_a) out.keep(first.tokens[i]);
            if (has_b && keeps_b) out.add(second.text(i));
        }
        if (out.text().size() > options.most_symbols) return too_large_word(out.text().size(), options.most_symbols);
    }
    return out.take();
}

}  // namespace filigree::rewriting
