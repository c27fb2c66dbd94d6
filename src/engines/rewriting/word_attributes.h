// What is known of each symbol of a word beside its letter: age, distance, depth; and of a piece of it: density and
// homogeneity (Roncoroni and Crousse, "Editing").
//
// Objects are the symbols that draw something. A word's own letters do not say which do, so it is a predicate; unless
// told otherwise, every letter is an object that is no axis letter. Brackets, turns and shrinks get attributes like all
// other tokens. Words with brackets that have no partner are taken as they are: a stray `]` ends nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "engines/rewriting/word_tokens.h"

namespace filigree::rewriting {

bool is_object(char32_t symbol);  // every letter of any script that is no axis letter
using ObjectTest = std::function<bool(char32_t)>;

// Where the symbols of a word stand, told one after another.
class WordWalk {
public:
    struct Place {
        std::uint32_t depth = 0, distance = 0;  // as in SymbolAttributes
    };
    Place next(char32_t symbol, bool is_object) {
        if (symbol == U']' && !outer_.empty()) {
            distance_ = outer_.back();
            outer_.pop_back();
        }
        const Place place{static_cast<std::uint32_t>(outer_.size()), distance_};
        if (symbol == U'[') outer_.push_back(distance_);
        if (is_object) ++distance_;
        return place;
    }

private:
    std::vector<std::uint32_t> outer_;  // the distances at which the open branches began
    std::uint32_t distance_ = 0;
};

struct SymbolAttributes {
    char32_t symbol = 0;
    std::uint32_t age = 1;
    std::uint32_t distance = 0;  // objects on the way from the root to it, those of branches beside the way left out
    std::uint32_t depth = 0;     // brackets around it
    bool is_object = false;
};

// One for each token. Ages come from the derivation that made the word: one for every symbol that is no '=', in the
// order of the word (Word::ages); the age of a token is that of its first symbol. Where there is none it is 1.
std::vector<SymbolAttributes> attributes_of(std::u32string_view word, const std::vector<EditToken>& tokens,
                                            std::span<const std::uint32_t> ages = {},
                                            const ObjectTest& objects = is_object);

// How many objects there are in a piece, or in a branch, which is a piece from `[` to `]`.
std::uint32_t density(std::u32string_view word, const std::vector<EditToken>& tokens, TokenRange range,
                      const ObjectTest& objects = is_object);

struct SymbolFrequency {
    char32_t symbol = 0;
    std::uint32_t count = 0;
    double share = 0;  // of all objects

    bool operator==(const SymbolFrequency&) const = default;
};
struct Homogeneity {
    std::vector<SymbolFrequency> frequencies;  // in the order of code points
    double scalar = 0;                         // the sum of squared shares: 1 where all are alike; 0 without objects
};
Homogeneity homogeneity(std::u32string_view word, const std::vector<EditToken>& tokens, TokenRange range,
                        const ObjectTest& objects = is_object);

// A pair of brackets with what it encloses.
struct WordBranch {
    TokenRange range;            // from `[` to `]`, both included
    std::uint32_t ordinal = 0;   // in the order of opening brackets, from 0
    std::uint32_t depth = 1;     // 1 for branches of the trunk
    std::uint32_t distance = 0;  // objects on the way from the root
    std::uint32_t density = 0;   // objects inside, those of branches in it included
};
// In the order of their opening brackets; brackets without a partner make none.
std::vector<WordBranch> branches_of(std::u32string_view word, const std::vector<EditToken>& tokens,
                                    const ObjectTest& objects = is_object);

}  // namespace filigree::rewriting
