// Whether a symbol stands between the symbols that a rule asks for, branches left aside.
//
// To the left, whole branches beside the way are passed over and the way goes on at the parent; to the right, branches
// that the pattern does not name are passed over and the own branch is never left. A branch in the pattern must be how
// the next branch begins (Prusinkiewicz and Lindenmayer, The Algorithmic Beauty of Plants, 1.8).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engines/rewriting/symbols.h"
#include "engines/rewriting/word.h"

namespace filigree::rewriting {

class Contexts {
public:
    // Both must outlive this. O(n), once an iteration.
    Contexts(const Word& word, const Alphabet& alphabet);

    // Of the symbol at a place in Word::symbols. Letters in `ignored` are looked past; '=' always is.
    bool has_left(std::size_t place, std::u32string_view pattern, std::u32string_view ignored) const;
    bool has_right(std::size_t place, std::u32string_view pattern, std::u32string_view ignored) const;

    // What stands there instead, as letters in the word's order: up to so many, fewer where the way ends.
    std::u32string letters_left(std::size_t place, std::size_t most, std::u32string_view ignored) const;
    std::u32string letters_right(std::size_t place, std::size_t most, std::u32string_view ignored) const;
    // All that stands behind it but '=', branches and all.
    std::u32string letters_behind(std::size_t place, std::size_t most) const;

private:
    static constexpr std::uint32_t none = UINT32_MAX;

    char32_t letter(std::size_t place) const { return alphabet_[word_.symbols[place]].letter; }
    bool is_passed(char32_t letter, std::u32string_view ignored) const {
        return letter == U'=' || ignored.find(letter) != std::u32string_view::npos;
    }
    // The nearest symbol along the way before a place, or from a place on; none where the way ends.
    std::optional<std::size_t> before(std::size_t place, std::u32string_view ignored) const;
    std::optional<std::size_t> from(std::size_t place, std::u32string_view ignored) const;
    bool begins_with(std::size_t place, std::u32string_view pattern, std::u32string_view ignored, int depth) const;

    const Word& word_;
    const Alphabet& alphabet_;
    std::vector<std::uint32_t> partners_;  // of brackets; none where there is none
};

}  // namespace filigree::rewriting
