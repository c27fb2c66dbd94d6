#include "engines/rewriting/word.h"

#include <algorithm>

#include "base/unicode.h"

namespace filigree::rewriting {

std::string to_text(const Word& word, const Alphabet& alphabet) {
    std::vector<std::string> texts(alphabet.size());
    for (std::size_t s = 0; s < texts.size(); ++s) {
        unicode::append_utf8(texts[s], alphabet[static_cast<Symbol>(s)].letter);
    }
    std::string text;
    const bool are_bytes = std::all_of(texts.begin(), texts.end(), [](const std::string& t) { return t.size() == 1; });
    if (are_bytes) {
        text.resize(word.size());
        std::transform(word.symbols.begin(), word.symbols.end(), text.begin(),
                       [&](Symbol symbol) { return texts[symbol][0]; });
        return text;
    }
    text.reserve(word.size());
    for (const Symbol symbol : word.symbols) text += texts[symbol];
    return text;
}

}  // namespace filigree::rewriting
