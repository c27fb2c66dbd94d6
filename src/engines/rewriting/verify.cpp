#include "engines/rewriting/verify.h"

#include <algorithm>

#include "plane/verify.h"

namespace filigree::rewriting {

std::vector<std::string> broken_invariants(const Derivation& derivation) {
    std::vector<std::string> broken;
    const auto expect = [&](bool holds, const char* sentence) {
        if (!holds) broken.emplace_back(sentence);
    };
    const Word& word = derivation.word;
    const std::size_t known = derivation.alphabet.size();
    std::size_t awake = 0, followers = 0;
    bool are_known = true;
    for (const Symbol symbol : word.symbols) {
        are_known = are_known && symbol < known;
        if (symbol >= known || symbol == Alphabet::freeze) continue;
        ++awake;
        followers += derivation.alphabet[symbol].role == Role::follower ? 1U : 0U;
    }
    expect(are_known, "the word has a symbol that is none of the alphabet");
    expect(word.symbols.empty() || word.symbols.front() != Alphabet::freeze, "the word begins with '='");
    expect(word.keys.empty() || word.keys.size() == awake, "not every symbol has a key");
    expect(word.ages.empty() || word.ages.size() == awake, "not every symbol has an age");
    expect(std::find(word.ages.begin(), word.ages.end(), 0U) == word.ages.end(), "a symbol has the age 0");
    expect(word.origins.size() == followers, "not every \xC3\xB1 knows which n made it");
    return broken;
}

std::vector<std::string> broken_invariants(const Drawing& drawing) {
    std::vector<std::string> broken;
    for (const DrawnShape& shape : drawing.shapes) {
        const PolygonView polygon = polygon_of(drawing, shape);
        if (drawing.styles[shape.style].is_open) {
            if (polygon.ring_count() != 1 || polygon.outer().size() < 2) broken.emplace_back("a line is no line");
        } else if (const std::optional<std::string> flaw = find_flaw(polygon)) {
            broken.push_back("a drawn shape has a flaw: " + *flaw);
        }
        if (!broken.empty()) break;
    }
    return broken;
}

}  // namespace filigree::rewriting
