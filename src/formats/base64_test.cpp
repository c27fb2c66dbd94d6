#include "formats/base64.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/test_cases.h"

namespace filigree {
namespace {

TEST(Base64, KnownTexts) {  // RFC 4648, section 10
    EXPECT_EQ(to_base64(""), "");
    EXPECT_EQ(to_base64("f"), "Zg==");
    EXPECT_EQ(to_base64("fo"), "Zm8=");
    EXPECT_EQ(to_base64("foo"), "Zm9v");
    EXPECT_EQ(to_base64("foob"), "Zm9vYg==");
    EXPECT_EQ(to_base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(to_base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(to_base64("\xfb\xff\xfe"), "+//+");
    EXPECT_EQ(to_base64("foobar", 4), "Zm9v\nYmFy");
    EXPECT_EQ(from_base64(" Zm9v\n Ym\tFy\r\n"), "foobar");
}

TEST(Base64, RefusesWhatIsDamaged) {
    for (const char* text :
         {"Z", "Zg", "Zg=", "Zg===", "=", "====", "Zm9v=", "Zh==", "Zm9=", "Zm9*", "Zg==Zg==", "Zm8-"}) {
        EXPECT_FALSE(from_base64(text).has_value()) << text;
    }
}

TEST(Base64, RoundTrip) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        std::string bytes;
        const std::uint64_t length = to_whole(random_bits(seed, Key{}, "length"), 200);
        for (std::uint64_t i = 0; i < length; ++i) bytes += static_cast<char>(random_bits(seed, Key{i}, "byte"));
        const std::size_t line = to_whole(random_bits(seed, Key{}, "line"), 80);
        ASSERT_EQ(from_base64(to_base64(bytes, line)), bytes) << "seed " << seed;
    }
}

}  // namespace
}  // namespace filigree
