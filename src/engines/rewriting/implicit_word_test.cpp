#include "engines/rewriting/implicit_word.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "base/executor.h"
#include "base/test_cases.h"

namespace filigree::rewriting {
namespace {

std::vector<std::uint8_t> bytes(std::string_view text) { return {text.begin(), text.end()}; }
std::string text(std::span<const std::uint8_t> symbols) { return {symbols.begin(), symbols.end()}; }

Substitution koch() {
    Substitution result;
    result.images['F'] = bytes("F-F+F+FF-F-F+F");
    return result;
}

constexpr std::uint64_t megabyte = 1 << 20;

TEST(ImplicitWord, IsReadWhereItIsTooLongToWrite) {
    const Result<ImplicitWord> word = implicit_word(koch(), bytes("F-F-F-F"), 60, megabyte);
    ASSERT_TRUE(word);
    EXPECT_EQ(to_text(word->length()), "11384252589289460090662006487402296792596347764792473307");
    SerialExecutor serial;
    const Result<ByteWord> start = power(koch(), bytes("F"), 6, UINT64_MAX, serial);
    ASSERT_TRUE(start);
    const std::size_t size = start->size();
    EXPECT_EQ(text(word->slice(0, size)), text(start->symbols()));

    // The word ends as it starts, and so does what comes of each image of each F.
    BigInt last = word->length();
    subtract(last, size);
    EXPECT_EQ(text(word->slice(last, size + 7)), text(start->symbols()));
    for (const std::uint64_t height : {60, 59, 40, 22, 21, 20, 7}) {
        BigInt length = length_of_word(koch(), bytes("F"), height);
        EXPECT_EQ(word->at(length), '-') << height;
        add(length, 1);
        EXPECT_EQ(text(word->slice(length, size)), text(start->symbols())) << height;
        subtract(length, 4);
        EXPECT_EQ(text(word->slice(length, 6)), "F+F-F-") << height;
    }
    EXPECT_EQ(word->at(word->length()), std::nullopt);
    EXPECT_TRUE(word->slice(word->length(), 5).empty());
    subtract(last, 1);
    EXPECT_TRUE(word->slice(last, 0).empty());
}

TEST(ImplicitWord, MayHaveALongStart) {
    CaseRandom random(1);
    std::string start;
    for (int i = 0; i < 1000; ++i) start += random.coin() ? 'F' : '+';
    for (const std::uint64_t steps : {0, 1, 30}) {
        const Result<ImplicitWord> word = implicit_word(koch(), bytes(start), steps, megabyte);
        ASSERT_TRUE(word);
        const BigInt image = length_of_word(koch(), bytes("F"), steps);
        BigInt place;
        for (const char c : start) {
            EXPECT_EQ(word->at(place), c);
            add(place, c == 'F' ? image : BigInt(1));
        }
        EXPECT_EQ(place, word->length());
    }
}

TEST(ImplicitWord, OfNothingIsNothing) {
    EXPECT_EQ(implicit_word(koch(), {}, 60, megabyte)->length(), BigInt());
    EXPECT_EQ(implicit_word(koch(), {}, 60, megabyte)->at(0), std::nullopt);
    Substitution dying;
    dying.images['a'] = bytes("bb");
    dying.images['b'] = {};
    EXPECT_TRUE(implicit_word(dying, bytes("aaa"), 50, megabyte)->slice(0, 3).empty());
    EXPECT_EQ(text(implicit_word(dying, bytes("acac"), UINT64_MAX, megabyte)->slice(0, 9)), "cc");
}

// Branches of 8^22 symbols that die out: what is empty must not be gone through.
TEST(ImplicitWord, PassesOverWhatDiesOut) {
    Substitution rules;
    rules.images['s'] = bytes("sxe");
    for (std::uint8_t age = 0; age < 22; ++age) {
        rules.images[age == 0 ? 'x' : 'x' + 99 + age].assign(8, static_cast<std::uint8_t>('x' + 100 + age));
    }
    rules.images['x' + 99 + 22] = {};
    const Result<ImplicitWord> word = implicit_word(rules, bytes("s"), 1000, megabyte);
    ASSERT_TRUE(word);
    EXPECT_FALSE(to_u64(word->length()));
    EXPECT_EQ(text(word->slice(0, 3)), "sxe");
    BigInt place = word->length();
    subtract(place, 1000 - 23);
    EXPECT_EQ(text(word->slice(place, 2000)), std::string(1000 - 23, 'e'));
    subtract(place, 2);
    EXPECT_EQ(word->at(place), 'x' + 99 + 22);
}

TEST(ImplicitWord, IsRefusedWhereItsTablesAreTooLarge) {
    EXPECT_TRUE(implicit_word(koch(), bytes("F"), 1000, 10 * megabyte));
    const Result<ImplicitWord> refused = implicit_word(koch(), bytes("F"), 100'000, megabyte);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.diagnostics().front().code, "limit.memory");
}

}  // namespace
}  // namespace filigree::rewriting
