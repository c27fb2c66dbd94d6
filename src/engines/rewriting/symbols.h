// The symbols of a grammar, and the numbers by which words hold them.
//
// A symbol is any character of Unicode but a blank. What letters mean depends on the system that they belong to: in
// gdesign `= { } s n q g i` and ñ are special unless freed, `A B C R S W` only where they are declared (Roncoroni and
// Crousse, "Expansion of the symbolic language"). The same letter of two systems is two symbols that print alike, and
// an `i` behind `q` or `g` (the inverter) is another symbol than any other `i`. A letter that a subsystem with a gait
// of its own has put is another symbol, too, which is rewritten alike. A word holds one byte a symbol, so one document
// may have 256 of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace filigree::rewriting {

using Symbol = std::uint8_t;
constexpr std::size_t max_symbols = 256;

enum class Role : std::uint8_t {
    ordinary,
    freeze,     // '=': its predecessor sleeps a turn
    counter,    // q, g: a run of them grows
    inverter,   // i right behind such a run, which it makes shrink
    self,       // s: the whole word
    ordinal,    // n: the k-th of them becomes k copies
    follower,   // ñ: as many copies as the n that made it
    macro,      // R, S, W: random letters
    subsystem,  // A, B, C: the word of another system
};

// The letters of one system that have a role there.
struct Roles {
    std::u32string counters = U"qg", inverters = U"i", selves = U"s", ordinals = U"n", followers = U"\u00F1";
    std::u32string macros, subsystems;

    Role of(char32_t letter) const;  // an inverter only by its place: `ordinary` here
    void free(char32_t letter);      // without a role from now on
};

// How a subsystem lets the turtle go where it has put symbols, as far as it says so: what it leaves open is as around
// it.
struct Gait {
    std::optional<double> angle = {}, angle2 = {};  // degrees, as in TurtleSettings
    std::optional<double> step = {};                // px

    bool operator==(const Gait&) const = default;
};
Gait within(const Gait& inner, const Gait& around);

struct SymbolEntry {
    char32_t letter = 0;  // as it is printed
    Role role = Role::ordinary;
    std::uint32_t scope = 0;  // in which it is rewritten: Derivation::scopes
    std::uint32_t gait = 0;   // how it is drawn: Alphabet::gaits

    bool operator==(const SymbolEntry&) const = default;
};

class Alphabet {
public:
    static constexpr Symbol freeze = 0;

    Alphabet() { entries_.push_back({U'=', Role::freeze}); }

    // The number of a symbol, a new one where there is none; none where there are too many.
    std::optional<Symbol> number_of(const SymbolEntry& entry);
    std::optional<Symbol> find(const SymbolEntry& entry) const;
    const SymbolEntry& operator[](Symbol symbol) const { return entries_[symbol]; }
    std::size_t size() const { return entries_.size(); }

    // The number of a gait, a new one where there is none. The first is the document's own, which says nothing.
    std::uint32_t number_of(const Gait& gait);
    const std::vector<Gait>& gaits() const { return gaits_; }

private:
    std::vector<SymbolEntry> entries_;
    std::vector<Gait> gaits_ = std::vector<Gait>(1);
};

Diagnostic too_many_symbols();

// What has no place of its own gets this one.
Diagnostics with_span(Diagnostics diagnostics, SourceSpan span);

// A text's letters in normal form C, where `~n` is ñ; without blanks, unless they are wanted.
std::u32string letters_of(std::string_view text, bool with_blanks = false);
bool is_blank(char32_t letter);

std::string to_utf8(std::u32string_view letters);

}  // namespace filigree::rewriting
