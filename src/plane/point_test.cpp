#include "plane/point.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/test_cases.h"

namespace filigree {
namespace {

TEST(Point, RoundsHalvesAwayFromZero) {
    for (const double v : {0.0, -0.0, 0.5, -0.5, 1.5, -1.5, 0.49999999999999994, -0.49999999999999994, 2.4, -2.6,
                           0x1p51 + 0.5, -0x1p51 - 0.5, 0x1p52 + 1, -0x1p56, 0x1p56}) {
        EXPECT_EQ(round_to_whole(v), std::llround(v)) << v;
    }
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const double v = std::ldexp(random.between(-1, 1), random.whole(0, 56));
        ASSERT_EQ(round_to_whole(v), std::llround(v)) << "seed " << seed;
    }
}

}  // namespace
}  // namespace filigree
