// A derived word as text and as JSON: what `derive` prints of a rewriting document.
#pragma once

#include <string>
#include <string_view>

#include "session/run.h"

namespace filigree {

// Letters for people to read: control characters as the language writes them in quotes, \u{1b}, since a terminal would
// obey them. JSON has all letters as they are.
std::string shown(std::u32string_view letters);

// The word as it is shown, and a line end.
std::string word_text(const rewriting::Derivation& derivation);

// With the symbols that wait, how many turns they have left, and the registers.
std::string word_json(const OpenedDocument& opened, const CheckedDocument& checked,
                      const rewriting::Derivation& derivation);

// What can be said of a word that may be far too long to be made: its length, how many there are of each symbol, or
// `count` symbols from a place on (from 0, in decimal digits). Only where the grammar is no more than a substitution.
struct WordQuestion {
    enum class Kind { length, counts, slice };
    Kind kind = Kind::length;
    std::string first = {};   // slice
    std::uint64_t count = 0;  // slice
};
Result<std::string> answer(const OpenedDocument& opened, const CheckedDocument& checked,
                           std::optional<std::uint64_t> steps, const WordQuestion& question);

}  // namespace filigree
