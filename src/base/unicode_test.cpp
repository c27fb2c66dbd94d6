#include "base/unicode.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "base/random.h"
#include "base/test_cases.h"

namespace filigree::unicode {
namespace {

constexpr std::size_t npos = std::string_view::npos;

TEST(Unicode, EveryScalarValueGoesThereAndBack) {
    for (char32_t code_point = 0; code_point <= 0x10FFFF; ++code_point) {
        if (code_point >= 0xD800 && code_point <= 0xDFFF) continue;
        std::string text;
        append_utf8(text, code_point);
        const Decoded decoded = decode(text, 0);
        ASSERT_TRUE(decoded.valid) << std::hex << static_cast<std::uint32_t>(code_point);
        ASSERT_EQ(decoded.code_point, code_point);
        ASSERT_EQ(decoded.length, text.size());
        ASSERT_EQ(text.size(), code_point < 0x80 ? 1U : code_point < 0x800 ? 2U : code_point < 0x10000 ? 3U : 4U);
    }
}

TEST(Unicode, WritesTheReplacementForWhatIsNoScalarValue) {
    for (const char32_t code_point : {char32_t{0xD800}, char32_t{0xDFFF}, char32_t{0x110000}, char32_t{0xFFFFFFFF}}) {
        std::string text;
        append_utf8(text, code_point);
        EXPECT_EQ(text, "\xEF\xBF\xBD");
    }
}

TEST(Unicode, RefusesWhatIsNoUtf8) {
    const std::string_view cases[] = {"\x80",
                                      "\xBF",
                                      "\xC0\x80",
                                      "\xC1\xBF",
                                      "\xC3",
                                      "\xC3(",
                                      "\xE0\x80\x80",
                                      "\xE0\x9F\xBF",
                                      "\xE2\x82",
                                      "\xE2(\xA1",
                                      "\xED\xA0\x80",
                                      "\xED\xBF\xBF",
                                      "\xF0\x80\x80\x80",
                                      "\xF0\x8F\xBF\xBF",
                                      "\xF0\x9F\x98",
                                      "\xF4\x90\x80\x80",
                                      "\xF5\x80\x80\x80",
                                      "\xF8\x88\x80\x80",
                                      "\xFE",
                                      "\xFF"};
    for (const std::string_view text : cases) {
        const Decoded decoded = decode(text, 0);
        EXPECT_FALSE(decoded.valid);
        EXPECT_EQ(decoded.length, 1U);
        EXPECT_EQ(decoded.code_point, char32_t{0xFFFD});
        EXPECT_EQ(find_invalid(text), 0U);
        EXPECT_EQ(find_invalid("a\xC3\xA9" + std::string(text)), 3U);
        EXPECT_EQ(normalise(text), text);
    }
    EXPECT_EQ(find_invalid(""), npos);
    EXPECT_EQ(find_invalid("caf\xC3\xA9"), npos);
    EXPECT_TRUE(decode("\xEF\xBF\xBD", 0).valid);
    EXPECT_EQ(decode("a\xC3\xA9", 1).code_point, char32_t{0xE9});
}

TEST(Unicode, DecodingAnyBytesComesToTheEnd) {
    for (std::uint64_t i = 1; i <= case_count(); ++i) {
        CaseRandom random(i);
        std::string text;
        const std::uint32_t length = random.below(40);
        for (std::uint32_t k = 0; k < length; ++k) text += static_cast<char>(random.bits() | (random.below(2) * 0x80));
        std::string rebuilt;
        std::size_t at = 0;
        bool is_valid = true;
        while (at < text.size()) {
            const Decoded decoded = decode(text, at);
            if (decoded.valid) {
                append_utf8(rebuilt, decoded.code_point);
            } else {
                rebuilt += text[at];
                is_valid = false;
            }
            ASSERT_GE(decoded.length, 1U);
            at += decoded.length;
        }
        ASSERT_EQ(at, text.size()) << "case " << i;
        ASSERT_EQ(rebuilt, text) << "case " << i;
        ASSERT_EQ(find_invalid(text) == npos, is_valid) << "case " << i;
    }
}

TEST(Unicode, LettersAndDigits) {
    for (const char32_t letter : {U'a', U'z', U'A', U'Z', U'é', U'ß', U'ж', U'λ', U'中', U'あ', U'א', U'ع', U'ह',
                                  char32_t{0x093F}, char32_t{0x0301}, char32_t{0x1D4D0}}) {
        EXPECT_TRUE(is_letter(letter)) << static_cast<std::uint32_t>(letter);
    }
    for (const char32_t other : {U'_',
                                 U'0',
                                 U'9',
                                 U' ',
                                 U'-',
                                 U'$',
                                 U'@',
                                 U'[',
                                 U'`',
                                 U'{',
                                 char32_t{0x7F},
                                 char32_t{0},
                                 char32_t{0x661},
                                 U'½',
                                 U'²',
                                 U'…',
                                 U'→',
                                 U'€',
                                 char32_t{0x1F600},
                                 char32_t{0xD800},
                                 char32_t{0x110000},
                                 char32_t{0xFFFFFFFF},
                                 char32_t{0xFFFD},
                                 char32_t{0x200D}}) {
        EXPECT_FALSE(is_letter(other)) << static_cast<std::uint32_t>(other);
    }
    for (char32_t c = 0; c < 0x300; ++c) EXPECT_EQ(is_digit(c), c >= '0' && c <= '9');
    EXPECT_FALSE(is_digit(0x661));
}

TEST(Unicode, LowerCase) {
    EXPECT_EQ(to_lower(U'A'), U'a');
    EXPECT_EQ(to_lower(U'Z'), U'z');
    EXPECT_EQ(to_lower(U'a'), U'a');
    EXPECT_EQ(to_lower(U'['), U'[');
    EXPECT_EQ(to_lower(U'É'), U'é');
    EXPECT_EQ(to_lower(U'Ж'), U'ж');
    EXPECT_EQ(to_lower(U'中'), U'中');
    EXPECT_EQ(to_lower(0xD800), char32_t{0xD800});
    EXPECT_EQ(to_lower(0xFFFFFFFF), char32_t{0xFFFFFFFF});
}

TEST(Unicode, NormalFormC) {
    EXPECT_EQ(normalise(""), "");
    EXPECT_EQ(normalise("plain"), "plain");
    EXPECT_EQ(normalise("e\xCC\x81"), "\xC3\xA9");  // e + acute
    EXPECT_EQ(normalise("\xC3\xA9"), "\xC3\xA9");
    EXPECT_EQ(normalise("\xE1\x84\x80\xE1\x85\xA1"), "\xEA\xB0\x80");  // Hangul jamo
    EXPECT_EQ(normalise("\xE2\x84\xAB"), "\xC3\x85");                  // angstrom sign
    EXPECT_EQ(normalise("q\xCC\x87\xCC\xA3"), "q\xCC\xA3\xCC\x87");    // marks in their order
    EXPECT_EQ(normalise("\xEF\xAC\x81"), "\xEF\xAC\x81");              // a ligature stays: no compatibility form
    EXPECT_EQ(normalise(std::string_view("\0e\xCC\x81", 4)), std::string_view("\0\xC3\xA9", 3));
    EXPECT_EQ(normalise("e\xCC\x81\xFF"), "e\xCC\x81\xFF");
    std::string many;
    for (int i = 0; i < 5000; ++i) many += "e\xCC\x81";
    EXPECT_EQ(normalise(many).size(), 10'000U);
}

TEST(Unicode, NormalisingTwiceChangesNothing) {
    for (std::uint64_t i = 1; i <= case_count(); ++i) {
        CaseRandom random(i);
        std::string text;
        for (std::uint32_t k = random.below(12); k > 0; --k) {
            constexpr char32_t starts[] = {U'a', 0xC0, 0x300, 0x1100, 0x1E00, 0x3040, 0xAC00, 0xF900, 0x1D15E};
            append_utf8(text, starts[random.below(9)] + random.below(64));
        }
        const std::string once = normalise(text);
        ASSERT_EQ(normalise(once), once) << "case " << i;
        ASSERT_EQ(find_invalid(once), npos) << "case " << i;
    }
}

}  // namespace
}  // namespace filigree::unicode
