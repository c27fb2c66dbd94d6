#include "engines/rewriting/substitution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/test_cases.h"
#include "base/thread_pool.h"
#include "engines/rewriting/implicit_word.h"
#include "engines/rewriting/sha256_test_helper.h"

namespace filigree::rewriting {
namespace {

using Symbols = std::span<const std::uint8_t>;
using Rules = std::initializer_list<std::pair<char, std::string_view>>;

constexpr std::uint64_t unlimited = UINT64_MAX;

std::vector<std::uint8_t> bytes(std::string_view text) { return {text.begin(), text.end()}; }
std::string text(Symbols symbols) { return {symbols.begin(), symbols.end()}; }

Substitution substitution(Rules rules) {
    Substitution result;
    for (const auto& [symbol, image] : rules) result.images[static_cast<std::uint8_t>(symbol)] = bytes(image);
    return result;
}

// One symbol after another: what the fast ways must agree with.
std::vector<std::uint8_t> step(const Substitution& substitution, Symbols word) {
    std::vector<std::uint8_t> result;
    for (const std::uint8_t s : word) {
        const Symbols image = image_of(substitution, s);
        result.insert(result.end(), image.begin(), image.end());
    }
    return result;
}

std::string after(const Substitution& substitution, std::string_view word, std::uint64_t steps) {
    SerialExecutor serial;
    const Result<ByteWord> result = power(substitution, bytes(word), steps, 1 << 24, serial);
    return result ? text(result->symbols()) : result.diagnostics().front().message;
}

std::uint64_t count_of(const std::array<BigInt, 256>& counts, std::string_view symbols) {
    BigInt sum;
    for (const char c : symbols) add(sum, counts[static_cast<std::uint8_t>(c)]);
    return to_u64(sum).value();
}

TEST(Sha256, HasItsVectors) {
    EXPECT_EQ(sha256({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256(bytes("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256(bytes("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Substitution, HasTheVectors) {
    std::ifstream file(FILIGREE_SOURCE_DIR "/tests/data/rewriting_vectors.json");
    const nlohmann::json rows = nlohmann::json::parse(file);
    SerialExecutor serial;
    int found = 0;
    for (const nlohmann::json& row : rows) {
        if (row["kind"] != "d0l") continue;
        ++found;
        SCOPED_TRACE(row["name"].get<std::string>());
        Substitution rules;
        for (const auto& [symbol, image] : row["rules"].items()) {
            rules.images[static_cast<std::uint8_t>(symbol.at(0))] = bytes(image.get<std::string>());
        }
        const std::vector<std::uint8_t> axiom = bytes(row["axiom"].get<std::string>());
        const auto steps = row["n"].get<std::uint64_t>();
        const auto length = row["len"].get<std::uint64_t>();

        const Result<ByteWord> word = power(rules, axiom, steps, length, serial);
        ASSERT_TRUE(word);
        EXPECT_EQ(word->size(), length);
        EXPECT_EQ(sha256(word->symbols()).substr(0, 16), row["sha"].get<std::string>());
        const auto head = row["head"].get<std::string>();
        EXPECT_EQ(text(word->symbols().first(head.size())), head);
        EXPECT_FALSE(power(rules, axiom, steps, length - 1, serial));

        EXPECT_EQ(length_of_word(rules, axiom, steps), BigInt(length));
        if (row.contains("turtle2d")) {
            const std::array<BigInt, 256> counts = counts_of_symbols(rules, axiom, steps);
            EXPECT_EQ(count_of(counts, "Flr"), row["turtle2d"]["segs"].get<std::uint64_t>());
        }
        std::vector<std::uint8_t> stepwise = axiom;
        for (std::uint64_t i = 0; i < steps; ++i) stepwise = step(rules, stepwise);
        EXPECT_EQ(text(word->symbols()), text(stepwise));
        const Result<ImplicitWord> implicit = implicit_word(rules, axiom, steps, 1 << 20);
        ASSERT_TRUE(implicit);
        EXPECT_EQ(text(implicit->slice(0, length + 1)), text(stepwise));
    }
    EXPECT_EQ(found, 14);
}

TEST(Substitution, LeavesAsItIsWhatHasNoImage) {
    EXPECT_EQ(after({}, "ab+", 3), "ab+");
    EXPECT_EQ(after({}, "ab+", 1'000'000'000'000), "ab+");
    Substitution few;
    few.images.assign('b', {});
    few.images['a'] = bytes("abz");
    EXPECT_EQ(after(few, "ab+", 1), "abzb");
    EXPECT_EQ(text(image_of(few, 'z')), "z");
    EXPECT_EQ(to_text(lengths_of_symbols(few, 2)['a']), "5");
    EXPECT_EQ(after(substitution({{'a', "b"}}), "", 5), "");
}

TEST(Substitution, WordsMayDieOutStayAndTurn) {
    EXPECT_EQ(after(substitution({{'a', ""}}), "aba", 1), "b");
    EXPECT_EQ(after(substitution({{'a', "bb"}, {'b', "c"}, {'c', ""}}), "a", 2), "cc");
    EXPECT_EQ(after(substitution({{'a', "bb"}, {'b', "c"}, {'c', ""}}), "a", 3), "");
    EXPECT_EQ(after(substitution({{'a', "bb"}, {'b', "c"}, {'c', ""}}), "a", UINT64_MAX), "");
    const Substitution turning = substitution({{'a', "b"}, {'b', "c"}, {'c', "a"}});
    EXPECT_EQ(after(turning, "abcd", 3'000'000'000'001), "bcad");
    const Substitution late = substitution({{'x', "yy"}, {'y', "aab"}, {'a', "b"}, {'b', "a"}});
    EXPECT_EQ(after(late, "x", 1'000'000'003), "bbabba");
    EXPECT_EQ(length_of_word(late, bytes("x"), 1'000'000'003), BigInt(6));
    EXPECT_EQ(implicit_word(late, bytes("x"), 1'000'000'003, 1 << 20)->slice(1, 4), bytes("babb"));
}

TEST(Substitution, GrowsByOneAStep) {
    const Substitution linear = substitution({{'a', "ab"}});
    for (const std::uint64_t steps : {0, 1, 2, 17, 16'384, 500'000}) {
        EXPECT_TRUE(after(linear, "ca", steps) == "ca" + std::string(steps, 'b')) << steps;
        EXPECT_EQ(length_of_word(linear, bytes("ca"), steps), BigInt(steps + 2));
    }
    const Substitution quadratic = substitution({{'a', "ab"}, {'b', "bc"}});
    std::string expected = "a";
    for (std::size_t i = 0; i < 3000; ++i) expected += "b" + std::string(i, 'c');
    EXPECT_TRUE(after(quadratic, "a", 3000) == expected);
}

TEST(Substitution, CountsWhatIsLongerThanAnyMemory) {
    const Substitution koch = substitution({{'F', "F-F+F+FF-F-F+F"}});
    const std::array<BigInt, 256> counts = counts_of_symbols(koch, bytes("F-F-F-F"), 60);
    // 4 8^60, and 3 of a word and 3 (8^60 - 1) / 7 of each of its four
    EXPECT_EQ(to_text(counts['F']), "6129982163463555433433388108601236734474956488734408704");
    EXPECT_EQ(to_text(counts['-']), "2627135212912952328614309189400530029060695638029032303");
    EXPECT_EQ(to_text(lengths_of_symbols(koch, 64)['F']),
              "11657474651432407132837894643099951915618660111147492666806");
    SerialExecutor serial;
    const Result<ByteWord> refused = power(koch, bytes("F-F-F-F"), 60, 1'000'000'000, serial);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.diagnostics().front().code, "limit.elements");
    EXPECT_EQ(refused.diagnostics().front().fault, Fault::limit);
    EXPECT_EQ(refused.diagnostics().front().message,
              "step 10 makes a word of 7976367835 symbols, which is more than the limit of 1000000000");
    EXPECT_FALSE(power(koch, bytes("F"), UINT64_MAX, UINT64_MAX - 1, serial));
}

TEST(Substitution, RefusesAWordThatIsTooLong) {
    SerialExecutor serial;
    const Substitution doubling = substitution({{'a', "aa"}});
    EXPECT_TRUE(apply(doubling, bytes("aaa"), 6, serial));
    const Result<ByteWord> refused = apply(doubling, bytes("aaa"), 5, serial);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.diagnostics().front().message,
              "a step makes a word of 6 symbols, which is more than the limit of 5");
    // As one step after another: a word in between counts, too.
    const Substitution shrinking = substitution({{'a', "bbbb"}, {'b', "c"}, {'c', ""}});
    EXPECT_TRUE(power(shrinking, bytes("a"), 3, 4, serial));
    EXPECT_FALSE(power(shrinking, bytes("a"), 3, 3, serial));
    EXPECT_FALSE(power({}, bytes("aaa"), 0, 2, serial));
}

TEST(Substitution, TakesTheMemoryThatItIsGiven) {
    SerialExecutor serial;
    ByteWord given;
    ASSERT_TRUE(given.make(1000));
    const std::uint8_t* const memory = given.data();
    Result<ByteWord> word = power(substitution({{'a', "ab"}}), bytes("a"), 999, 1000, serial, std::move(given));
    ASSERT_TRUE(word);
    EXPECT_EQ(word->data(), memory);
    EXPECT_EQ(word->size(), 1000U);
    word = apply({}, bytes("xyz"), 3, serial, *std::move(word));
    EXPECT_EQ(word->data(), memory);
    EXPECT_EQ(text(word->symbols()), "xyz");
}

// Each way of writing has its greatest size, of an image or of two together.
TEST(Substitution, WritesImagesOfAnySize) {
    ThreadPool two(2);
    std::vector<std::uint8_t> word = bytes("c");
    for (int i = 0; i < 40'000; ++i) word.insert(word.end(), {'a', 'b'});
    for (std::size_t size = 0; size <= 140; ++size) {
        Substitution rules;
        rules.images['a'].resize(size / 2);
        rules.images['b'].resize(size - size / 2);
        std::uint8_t next = 1;
        for (const char symbol : {'a', 'b'}) {
            for (std::uint8_t& s : rules.images[static_cast<std::uint8_t>(symbol)]) s = next++;
        }
        const Result<ByteWord> made = apply(rules, word, unlimited, two);
        ASSERT_TRUE(made && std::ranges::equal(made->symbols(), step(rules, word))) << size;
    }
}

// --- random substitutions --------------------------------------------------------------------------------------------

// Images short or of up to some hundred symbols, among them empty ones and symbols that have none.
Substitution random_substitution(CaseRandom& random, std::uint32_t letters) {
    constexpr std::uint32_t longest[] = {1, 2, 3, 5, 16, 17, 32, 33, 64, 65, 300};
    const std::uint32_t most = longest[random.below(std::size(longest))];
    Substitution result;
    for (std::uint32_t i = 0; i < letters; ++i) {
        if (random.below(4) == 0) continue;
        std::vector<std::uint8_t>& image = result.images['a' + i];
        image.resize(random.coin() ? random.below(most + 1) : random.below(std::min(most, 3U) + 1));
        for (std::uint8_t& s : image) s = static_cast<std::uint8_t>('a' + random.below(letters));
    }
    return result;
}
std::vector<std::uint8_t> random_word(CaseRandom& random, std::uint32_t letters, std::size_t size) {
    std::vector<std::uint8_t> result(size);
    for (std::uint8_t& s : result) s = static_cast<std::uint8_t>('a' + random.below(letters));
    return result;
}

TEST(Substitution, PowerIsOneStepAfterAnother) {
    ThreadPool threads(3);
    for (std::uint64_t c = first_seed(); c < first_seed() + case_count(300); ++c) {
        SCOPED_TRACE(c);
        CaseRandom random(c);
        const std::uint32_t letters = 1 + random.below(6);
        const Substitution rules = random_substitution(random, letters);
        const std::vector<std::uint8_t> axiom = random_word(random, letters, random.below(random.coin() ? 4 : 200));
        std::vector<std::uint8_t> word = axiom;
        for (std::uint64_t steps = 0; steps < 20; ++steps) {
            const BigInt length = length_of_word(rules, axiom, steps);
            if (length > 10'000) break;
            if (steps > 0) {
                const Result<ByteWord> next = apply(rules, word, unlimited, threads);
                word = step(rules, word);
                ASSERT_TRUE(next && text(next->symbols()) == text(word));
            }
            ASSERT_EQ(length, BigInt(word.size()));
            const Result<ByteWord> at_once = power(rules, axiom, steps, unlimited, threads);
            ASSERT_TRUE(at_once && text(at_once->symbols()) == text(word)) << steps;

            const std::array<BigInt, 256> counts = counts_of_symbols(rules, axiom, steps);
            const std::array<BigInt, 256> lengths = lengths_of_symbols(rules, steps);
            BigInt sum;
            for (const std::uint8_t s : axiom) add(sum, lengths[s]);
            ASSERT_EQ(sum, length);
            std::array<std::uint64_t, 256> counted{};
            for (const std::uint8_t s : word) ++counted[s];
            for (std::size_t s = 0; s < 256; ++s) ASSERT_EQ(counts[s], BigInt(counted[s]));

            const Result<ImplicitWord> implicit = implicit_word(rules, axiom, steps, unlimited);
            ASSERT_TRUE(implicit && implicit->length() == length);
            ASSERT_TRUE(implicit->slice(0, word.size() + 5) == word) << steps;
            const std::uint64_t first = random.whole(std::size_t{0}, word.size());
            const std::uint64_t last = random.whole(first, word.size());
            ASSERT_EQ(text(implicit->slice(first, last - first)), text(Symbols(word).subspan(first, last - first)));
            ASSERT_EQ(implicit->at(first), first < word.size() ? std::optional(word[first]) : std::nullopt);
        }
    }
}

// Words of several parts, with the images of each way of writing; a symbol may be so rare that samples miss it.
TEST(Substitution, LongWordsAreTheSameForAnyNumberOfThreads) {
    SerialExecutor serial;
    ThreadPool two(2), many(7);
    for (std::uint64_t c = first_seed(); c < first_seed() + case_count(60); ++c) {
        SCOPED_TRACE(c);
        CaseRandom random(c);
        const std::uint32_t letters = random.below(5) == 0 ? 30 : 1 + random.below(8);
        Substitution rules = random_substitution(random, letters);
        rules.images['!'] = random_word(random, letters, random.below(40));
        std::vector<std::uint8_t> word = random_word(random, letters, random.whole(30'000, 200'000));
        for (std::uint32_t rare = random.below(4); rare > 0; --rare) word[random.index(word.size())] = '!';
        const std::vector<std::uint8_t> expected = step(rules, word);
        for (Executor* const executor :
             {static_cast<Executor*>(&serial), static_cast<Executor*>(&two), static_cast<Executor*>(&many)}) {
            const Result<ByteWord> made = apply(rules, word, unlimited, *executor);
            ASSERT_TRUE(made && std::ranges::equal(made->symbols(), expected));
        }
    }
}

}  // namespace
}  // namespace filigree::rewriting
