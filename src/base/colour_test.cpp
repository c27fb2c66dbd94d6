#include "base/colour.h"

#include <gtest/gtest.h>

namespace filigree {
namespace {

TEST(Colour, IsWrittenAsInStyleSheets) {
    EXPECT_EQ(to_text(Colour{}), "#000000");
    EXPECT_EQ(to_text(Colour{255, 128, 9}), "#ff8009");
    EXPECT_EQ(to_text(Colour{1, 2, 3, 254}), "#010203fe");
    EXPECT_EQ(to_text(Colour{255, 255, 255, 0}), "#ffffff00");
}

}  // namespace
}  // namespace filigree
