#include "engines/rewriting/word_edits_checks.h"

#include "base/number_text.h"
#include "base/unicode.h"

namespace filigree::rewriting {

std::string quoted(std::u32string_view text) {
    constexpr std::size_t longest = 40;
    std::string out = "'";
    for (const char32_t c : text.substr(0, longest)) unicode::append_utf8(out, c);
    return out + (text.size() > longest ? "...'" : "'");
}

Diagnostic unbalanced_text(std::string_view what, std::u32string_view text) {
    return error("rewriting.unbalanced-text",
                 "the brackets of " + std::string(what) + " " + quoted(text) + " are not balanced", {},
                 {"every '[' needs a ']' behind it"});
}

Diagnostic too_large_word(std::uint64_t symbols, std::uint64_t most_symbols) {
    return fault(Fault::limit, "rewriting.edited-word-too-large",
                 "the edited word would have " + to_text(symbols) + " symbols, and at most " + to_text(most_symbols) +
                     " are allowed");
}

}  // namespace filigree::rewriting
