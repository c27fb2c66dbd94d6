#include "engines/rewriting/word.h"

#include <gtest/gtest.h>

#include "base/test_cases.h"

namespace filigree::rewriting {
namespace {

TEST(Word, SymbolsThatStandInIt) {
    const std::uint64_t cases = case_count(300);
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        CaseRandom random(seed);
        const std::size_t known = 1 + random.below(random.coin() ? 10 : 256);
        Word word;
        word.symbols.assign(random.below(60'000), static_cast<Symbol>(random.index(known)));
        for (std::uint32_t left = word.symbols.empty() ? 0 : random.below(12); left > 0; --left) {
            const std::size_t place = random.coin() ? word.size() - 1 : random.index(word.size());
            word.symbols[place] = static_cast<Symbol>(random.index(known));
        }
        std::array<bool, max_symbols> wanted{};
        for (const Symbol symbol : word.symbols) wanted[symbol] = true;
        EXPECT_EQ(symbols_in(word, known), wanted) << "case " << seed;
    }
}

}  // namespace
}  // namespace filigree::rewriting
