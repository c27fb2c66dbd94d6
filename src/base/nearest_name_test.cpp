#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/random.h"
#include "base/test_cases.h"

namespace filigree {
namespace {

using Names = std::vector<std::string_view>;

const Names operators = {"outline", "place", "regular_split", "regroup", "embed", "stream_split", "smooth", "fill"};

TEST(NearestName, FindsSlipsOfTheHand) {
    EXPECT_EQ(nearest_name("outlnie", operators), "outline");
    EXPECT_EQ(nearest_name("outine", operators), "outline");
    EXPECT_EQ(nearest_name("outlinee", operators), "outline");
    EXPECT_EQ(nearest_name("oytline", operators), "outline");
    EXPECT_EQ(nearest_name("regularSpilt", operators), "regular_split");
    EXPECT_EQ(nearest_name("fil", operators), "fill");
    EXPECT_EQ(nearest_name("plcae", operators), "place");
}

TEST(NearestName, IsBlindToCaseAndUnderscores) {
    EXPECT_EQ(nearest_name("OUTLINE", operators), "outline");
    EXPECT_EQ(nearest_name("regularSplit", operators), "regular_split");
    EXPECT_EQ(nearest_name("RegularSplit", operators), "regular_split");
    EXPECT_EQ(nearest_name("re_gu_lar_split", operators), "regular_split");
    EXPECT_EQ(nearest_name("ab_c_d_e", Names{"abcd", "abcde"}), "abcde");
    // All differences in underscores count as one, the same as one other slip: the earlier candidate stays.
    EXPECT_EQ(nearest_name("abcdef", Names{"abcdeg", "a_b_c_d_e_f"}), "abcdeg");
    EXPECT_EQ(nearest_name("abcdef", Names{"a_b_c_d_e_f", "abcdeg"}), "a_b_c_d_e_f");
    EXPECT_EQ(nearest_name("abcdef", Names{"a_b_c_d_e_f", "ABCDEF"}), "ABCDEF");
    EXPECT_EQ(nearest_name("\xC3\x89TOILE", Names{"e\xCC\x81toile"}), "e\xCC\x81toile");  // in any normal form
}

TEST(NearestName, RefusesWhatIsFar) {
    EXPECT_EQ(nearest_name("triangle", operators), "");
    EXPECT_EQ(nearest_name("", operators), "");
    EXPECT_EQ(nearest_name("x", Names{"y", "in", ""}), "");
    EXPECT_EQ(nearest_name("outline", {}), "");
    EXPECT_EQ(nearest_name("___", Names{"_", "abc"}), "");
    EXPECT_EQ(nearest_name("abc", Names{"abxy"}), "");  // 2 of 3
    EXPECT_EQ(nearest_name("abcdef", Names{"abcdxy"}), "abcdxy");
    EXPECT_EQ(nearest_name("abcdef", Names{"abcxyz"}), "");
}

TEST(NearestName, TiesGoToTheEarlier) {
    EXPECT_EQ(nearest_name("cat", Names{"bat", "car", "cats"}), "bat");
    EXPECT_EQ(nearest_name("cat", Names{"cats", "bat"}), "cats");
    EXPECT_EQ(nearest_name("cats", Names{"bats", "Cats"}), "Cats");
}

TEST(NearestName, LongNamesTakeNoTime) {
    const std::string long_name(200'000, 'a');
    const std::string other = long_name + "b";
    EXPECT_EQ(nearest_name(long_name, Names{other}), "");
    const std::string with_underscore = "a_" + long_name.substr(1);
    EXPECT_EQ(nearest_name(long_name, Names{other, with_underscore}), with_underscore);
}

TEST(NearestName, AnyBytesMayBeNames) {
    EXPECT_EQ(nearest_name("ab\xFF"
                           "d",
                           Names{"ab\xFE"
                                 "d"}),
              "ab\xFE"
              "d");
    EXPECT_EQ(nearest_name(std::string_view("a\0c", 3), Names{"abc"}), "abc");
}

TEST(NearestName, OneSlipIsAlwaysFound) {
    for (std::uint64_t i = 1; i <= case_count(); ++i) {
        CaseRandom random(i);
        std::string name;
        for (std::uint32_t k = 3 + random.below(12); k > 0; --k) name += static_cast<char>('a' + random.below(26));
        std::string slipped = name;
        const std::size_t at = random.below(static_cast<std::uint32_t>(name.size() - 1));
        switch (random.below(4)) {
            case 0:
                slipped.erase(at, 1);
                break;
            case 1:
                slipped.insert(at, 1, static_cast<char>('A' + random.below(26)));
                break;
            case 2:
                slipped[at] = '1';
                break;
            default:
                std::swap(slipped[at], slipped[at + 1]);
                break;
        }
        // Candidates that share no letter with it stand before and after.
        ASSERT_EQ(nearest_name(slipped, Names{"0000000", name, "0"}), name) << "case " << i << ": " << slipped;
    }
}

TEST(NearestName, BecomesAHint) {
    EXPECT_EQ(did_you_mean("outlnie", operators), std::vector<std::string>{"did you mean 'outline'?"});
    EXPECT_TRUE(did_you_mean("triangle", operators).empty());
}

}  // namespace
}  // namespace filigree
