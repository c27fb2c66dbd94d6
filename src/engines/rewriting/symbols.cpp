#include "engines/rewriting/symbols.h"

#include <algorithm>

#include "base/unicode.h"

namespace filigree::rewriting {
namespace {

bool contains(const std::u32string& letters, char32_t letter) { return letters.find(letter) != std::u32string::npos; }

}  // namespace

Role Roles::of(char32_t letter) const {
    if (letter == U'=') return Role::freeze;
    if (contains(counters, letter)) return Role::counter;
    if (contains(selves, letter)) return Role::self;
    if (contains(ordinals, letter)) return Role::ordinal;
    if (contains(followers, letter)) return Role::follower;
    if (contains(macros, letter)) return Role::macro;
    if (contains(subsystems, letter)) return Role::subsystem;
    return Role::ordinary;
}

void Roles::free(char32_t letter) {
    for (std::u32string* letters : {&counters, &inverters, &selves, &ordinals, &followers, &macros, &subsystems}) {
        std::erase(*letters, letter);
    }
}

std::optional<Symbol> Alphabet::find(const SymbolEntry& entry) const {
    const auto found = std::find(entries_.begin(), entries_.end(), entry);
    if (found == entries_.end()) return std::nullopt;
    return static_cast<Symbol>(found - entries_.begin());
}

std::optional<Symbol> Alphabet::number_of(const SymbolEntry& entry) {
    if (entry.role == Role::freeze) return freeze;
    if (const std::optional<Symbol> known = find(entry)) return known;
    if (entries_.size() == max_symbols) return std::nullopt;
    entries_.push_back(entry);
    return static_cast<Symbol>(entries_.size() - 1);
}

std::uint32_t Alphabet::number_of(const Gait& gait) {
    const auto found = std::find(gaits_.begin(), gaits_.end(), gait);
    const auto number = static_cast<std::uint32_t>(found - gaits_.begin());
    if (found == gaits_.end()) gaits_.push_back(gait);
    return number;
}

Gait within(const Gait& inner, const Gait& around) {
    return {inner.angle ? inner.angle : around.angle, inner.angle2 ? inner.angle2 : around.angle2,
            inner.step ? inner.step : around.step};
}

Diagnostic too_many_symbols() {
    return error("rewriting.too-many-symbols", "this grammar has more than 256 different symbols", {},
                 {"the same letter counts once in every subsystem, and once for each angle and step it is drawn by"});
}

Diagnostics with_span(Diagnostics diagnostics, SourceSpan span) {
    for (Diagnostic& diagnostic : diagnostics) {
        if (diagnostic.span.file == SourceSpan::no_file) diagnostic.span = span;
    }
    return diagnostics;
}

bool is_blank(char32_t letter) {
    return letter == U' ' || letter == U'\t' || letter == U'\r' || letter == U'\n' || letter == U'\u00A0';
}

std::u32string letters_of(std::string_view text, bool with_blanks) {
    const std::string normal = unicode::normalise(text);
    std::u32string letters;
    letters.reserve(normal.size());
    for (std::size_t at = 0; at < normal.size();) {
        const unicode::Decoded decoded = unicode::decode(normal, at);
        at += decoded.length;
        if (!with_blanks && is_blank(decoded.code_point)) continue;
        if (decoded.code_point == U'n' && !letters.empty() && letters.back() == U'~') {
            letters.back() = U'\u00F1';
        } else {
            letters.push_back(decoded.code_point);
        }
    }
    return letters;
}

std::string to_utf8(std::u32string_view letters) {
    std::string text;
    text.reserve(letters.size());
    for (const char32_t letter : letters) unicode::append_utf8(text, letter);
    return text;
}

}  // namespace filigree::rewriting
