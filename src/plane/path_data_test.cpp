#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/test_cases.h"
#include "plane/clean_test_oracle.h"
#include "plane/path.h"

namespace filigree {
namespace {

std::string canonical(std::string_view data) {
    const Result<Path> path = parse_path_data(data);
    if (!path) return "error: " + path.diagnostics()[0].message;
    return to_path_data(*path);
}

TEST(PathData, EveryCommand) {
    EXPECT_EQ(canonical("M1 2L3 4H5V6C1 2 3 4 5 6S7 8 9 10Q1 2 3 4T5 6A1 2 3 0 1 7 8Z"),
              "M1 2L3 4L5 4L5 6C1 2 3 4 5 6C7 8 7 8 9 10Q1 2 3 4Q5 6 5 6A1 2 3 0 1 7 8Z");
    EXPECT_EQ(canonical("m1 2l3 4h5v6c1 2 3 4 5 6s7 8 9 10q1 2 3 4t5 6a1 2 3 1 0 7 8z"),
              "M1 2L4 6L9 6L9 12C10 14 12 16 14 18C16 20 21 26 23 28Q24 30 26 32Q28 34 31 38A1 2 3 1 0 38 46Z");
}

TEST(PathData, ImplicitRepeats) {
    EXPECT_EQ(canonical("M1 2 3 4 5 6"), "M1 2L3 4L5 6");
    EXPECT_EQ(canonical("m1 2 3 4 5 6"), "M1 2L4 6L9 12");
    EXPECT_EQ(canonical("M0 0H1 2 3"), "M0 0L1 0L2 0L3 0");
    EXPECT_EQ(canonical("M0 0v1 2"), "M0 0L0 1L0 3");
    EXPECT_EQ(canonical("M0 0T1 1 2 2"), "M0 0Q0 0 1 1Q2 2 2 2");
    EXPECT_EQ(canonical("M0 0q1 0 1 1 1 0 1 1"), "M0 0Q1 0 1 1Q2 1 2 2");
}

TEST(PathData, CompactNumbersAndFlags) {
    EXPECT_EQ(canonical("M0 0a1 1 0 01.5.5"), "M0 0A1 1 0 0 1 0.5 0.5");
    EXPECT_EQ(canonical("M0,0a1,1,0,1,0,2,3"), "M0 0A1 1 0 1 0 2 3");
    EXPECT_EQ(canonical("M0 0a1 1 0 1110-1a1 1 0 000 1"), "M0 0A1 1 0 1 1 10-1A1 1 0 0 0 10 0");
    EXPECT_EQ(canonical("M.5.5.25-.25+3-4"), "M0.5 0.5L0.25-0.25L3-4");
    EXPECT_EQ(canonical("M1.L2 3"), "error: path data has 'L' where it needs y of 'M'");
    EXPECT_EQ(canonical("M1. 2.e1 5E-1 -1e+2"), "M1 20L0.5-100");
    EXPECT_EQ(canonical("\t\n M 1 , 2 \r L\f3\n,4 "), "M1 2L3 4");
    EXPECT_EQ(canonical("M1e-999 0"), "M0 0");
}

TEST(PathData, CurrentPointAfterClose) {
    EXPECT_EQ(canonical("m5 5h10v10zl1 1"), "M5 5L15 5L15 15ZL6 6");
    EXPECT_EQ(canonical("m5 5h10v10zm1 1"), "M5 5L15 5L15 15ZM6 6");
    EXPECT_EQ(canonical("M5 5zzz"), "M5 5ZZZ");
    EXPECT_EQ(canonical("M0 0C0 1 1 1 1 0ZS2 2 3 3"), "M0 0C0 1 1 1 1 0ZC0 0 2 2 3 3") << "no control point to mirror";
    EXPECT_EQ(canonical("M0 0C0 1 1 1 1 0T3 3"), "M0 0C0 1 1 1 1 0Q1 0 3 3");
}

TEST(PathData, NothingIsAPath) {
    EXPECT_EQ(canonical(""), "");
    EXPECT_EQ(canonical(" \n"), "");
}

struct Wrong {
    std::string_view data;
    std::uint32_t begin, end;
    std::string_view message;
};

TEST(PathData, ErrorsSayWhereAndWhat) {
    const Wrong wrongs[] = {
        {"L1 2", 0, 1, "path data has 'L' where it needs 'M'"},
        {"5", 0, 1, "path data has '5' where it needs 'M'"},
        {"M1", 2, 2, "path data ends where it needs y of 'M'"},
        {"M1 2L", 5, 5, "path data ends where it needs x of 'L'"},
        {"M1 2,", 5, 5, "path data ends where it needs x of 'M'"},
        {"M,1 2", 1, 2, "path data has ',' where it needs x of 'M'"},
        {"M1,,2", 3, 4, "path data has ',' where it needs y of 'M'"},
        {"M1 2 q1 2 3", 11, 11, "path data ends where it needs y of 'q'"},
        {"M1 2X", 4, 5, "path data has 'X' where it needs a command"},
        {"M1 2z3", 5, 6, "path data has '3' where it needs a command"},
        {"M1 2 3-", 6, 7, "path data has '-' where it needs y of 'M'"},
        {"M0 0A1 1 0 2 0 1 1", 11, 12, "path data has '2' where it needs the large-arc flag of 'A', 0 or 1"},
        {"M0 0A1 1 0 1", 12, 12, "path data ends where it needs the sweep flag of 'A', 0 or 1"},
        {"M1e999 0", 1, 6, "path data has a number that is too large"},
        {"M1e308 0l1e308 0", 9, 16, "path data leads to a coordinate that is too large"},
        {"M1 2\xC3\xA9", 4, 5, "path data has byte 0xc3 where it needs a command"},
        {"Mnan 0", 1, 2, "path data has 'n' where it needs x of 'M'"},
        {"M0x10 0", 2, 3, "path data has 'x' where it needs y of 'M'"},
    };
    for (const Wrong& wrong : wrongs) {
        const Result<Path> path = parse_path_data(wrong.data);
        ASSERT_FALSE(path) << wrong.data;
        ASSERT_EQ(path.diagnostics().size(), 1U);
        const Diagnostic& reason = path.diagnostics()[0];
        EXPECT_EQ(reason.message, wrong.message);
        EXPECT_EQ(reason.span, (SourceSpan{SourceSpan::no_file, wrong.begin, wrong.end})) << wrong.data;
    }
}

double random_number(CaseRandom& random) {
    switch (random.whole(0, 4)) {
        case 0:
            return static_cast<double>(random.whole(-20, 20));
        case 1:
            return 0;
        case 2:
            return random.between(-1000, 1000);
        case 3:
            return std::ldexp(random.between(-1, 1), random.whole(-1000, 1000));
        default:
            return static_cast<double>(random.whole(-999, 999)) / 100;
    }
}

TEST(PathData, RoundTrips) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        Path path;
        for (std::int64_t i = random.whole(0, 12); i > 0; --i) {
            const Verb verb = path.verbs.empty() ? Verb::move : static_cast<Verb>(random.whole(0, 5));
            path.verbs.push_back(verb);
            for (std::size_t k = 0; k < point_count(verb); ++k) {
                const double x = random_number(random), y = random_number(random);
                path.points.push_back({x, y});
            }
            if (verb == Verb::arc) path.points[path.points.size() - 2].y = static_cast<double>(random.whole(0, 3));
        }
        const std::string data = to_path_data(path);
        const Result<Path> again = parse_path_data(data);
        ASSERT_TRUE(again) << "seed " << seed << ": " << data;
        ASSERT_EQ(*again, path) << "seed " << seed << ": " << data;
        ASSERT_EQ(to_path_data(*again), data) << "seed " << seed;
    }
}

TEST(PathData, SurvivesAnyBytes) {
    constexpr std::string_view letters = "MmLlHhVvCcSsQqTtAaZz0123456789.-+eE, \n\xC3xn";
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        std::string data = random.unit() < 0.9 ? "M0 0" : "";
        for (std::int64_t i = random.whole(0, 40); i > 0; --i) {
            data += letters[random.index(letters.size())];
        }
        const Result<Path> path = parse_path_data(data);
        if (path) {
            const Result<Path> again = parse_path_data(to_path_data(*path));
            ASSERT_TRUE(again) << "seed " << seed << ": " << data;
            ASSERT_EQ(*again, *path) << "seed " << seed << ": " << data;
        } else {
            ASSERT_LE(path.diagnostics()[0].span.end, data.size()) << "seed " << seed << ": " << data;
        }
    }
}

}  // namespace
}  // namespace filigree
