#include "engines/rewriting/word_attributes.h"

#include <map>

#include "base/unicode.h"

namespace filigree::rewriting {

bool is_object(char32_t symbol) { return unicode::is_letter(symbol) && !is_axis_letter(symbol); }

std::vector<SymbolAttributes> attributes_of(std::u32string_view word, const std::vector<EditToken>& tokens,
                                            std::span<const std::uint32_t> ages, const ObjectTest& objects) {
    std::vector<SymbolAttributes> attributes;
    attributes.reserve(tokens.size());
    WordWalk walk;
    std::size_t aged = 0;
    for (const EditToken token : tokens) {
        SymbolAttributes one;
        one.symbol = token_symbol(word, token);
        one.is_object = objects(one.symbol);
        const WordWalk::Place place = walk.next(one.symbol, one.is_object);
        one.depth = place.depth;
        one.distance = place.distance;
        if (aged < ages.size() && one.symbol != U'=') one.age = ages[aged];
        for (const char32_t c : token_text(word, token)) aged += c != U'=' ? 1 : 0;
        attributes.push_back(one);
    }
    return attributes;
}

std::uint32_t density(std::u32string_view word, const std::vector<EditToken>& tokens, TokenRange range,
                      const ObjectTest& objects) {
    std::uint32_t count = 0;
    for (std::uint32_t i = range.begin; i < range.end; ++i) count += objects(token_symbol(word, tokens[i])) ? 1U : 0U;
    return count;
}

Homogeneity homogeneity(std::u32string_view word, const std::vector<EditToken>& tokens, TokenRange range,
                        const ObjectTest& objects) {
    std::map<char32_t, std::uint32_t> counts;
    std::uint64_t all = 0;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
        const char32_t symbol = token_symbol(word, tokens[i]);
        if (!objects(symbol)) continue;
        ++counts[symbol];
        ++all;
    }
    Homogeneity result;
    if (all == 0) return result;
    double squares = 0;  // a whole number up to 2^53 for the words that limits let through, so exact
    for (const auto& [symbol, count] : counts) {
        result.frequencies.push_back({symbol, count, static_cast<double>(count) / static_cast<double>(all)});
        squares += static_cast<double>(count) * static_cast<double>(count);
    }
    result.scalar = squares / (static_cast<double>(all) * static_cast<double>(all));
    return result;
}

std::vector<WordBranch> branches_of(std::u32string_view word, const std::vector<EditToken>& tokens,
                                    const ObjectTest& objects) {
    const std::vector<SymbolAttributes> attributes = attributes_of(word, tokens, {}, objects);
    const std::vector<std::uint32_t> partners = bracket_partners(word, tokens);
    std::vector<std::uint32_t> objects_before(tokens.size() + 1, 0);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        objects_before[i + 1] = objects_before[i] + (attributes[i].is_object ? 1U : 0U);
    }
    std::vector<WordBranch> branches;
    std::uint32_t paired_depth = 0;  // brackets without a partner around it do not count
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        if (partners[i] == no_token) continue;
        if (partners[i] < i) {
            --paired_depth;
            continue;
        }
        WordBranch branch;
        branch.range = {i, partners[i] + 1};
        branch.ordinal = static_cast<std::uint32_t>(branches.size());
        branch.depth = ++paired_depth;
        branch.distance = attributes[i].distance;
        branch.density = objects_before[partners[i]] - objects_before[i];
        branches.push_back(branch);
    }
    return branches;
}

}  // namespace filigree::rewriting
