#include "plane/box_grid.h"

#include <gtest/gtest.h>

#include "base/test_cases.h"

namespace filigree {
namespace {

std::vector<std::uint32_t> find(const BoxGrid& grid, const Box& box) {
    std::vector<std::uint32_t> found;
    grid.find(box, found);
    return found;
}

TEST(BoxGrid, FindsNothingAmongNothing) {
    const BoxGrid none({});
    EXPECT_TRUE(find(none, {{-5, -5}, {5, 5}}).empty());
    const std::vector<Box> empty_boxes(3);
    EXPECT_TRUE(find(BoxGrid(empty_boxes), {{INT64_MIN, INT64_MIN}, {INT64_MAX, INT64_MAX}}).empty());
}

TEST(BoxGrid, CountsBorders) {
    const std::vector<Box> boxes = {{{0, 0}, {10, 10}}, {{10, 0}, {20, 10}}, {{21, 0}, {30, 10}}, {}};
    const BoxGrid grid(boxes);
    EXPECT_EQ(find(grid, {{10, 10}, {10, 10}}), (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(find(grid, {{20, 10}, {21, 99}}), (std::vector<std::uint32_t>{1, 2}));
    EXPECT_TRUE(find(grid, {{0, 11}, {30, 12}}).empty());
    EXPECT_TRUE(find(grid, {}).empty());
}

TEST(BoxGrid, AppendsToWhatIsThere) {
    const std::vector<Box> boxes = {{{0, 0}, {1, 1}}};
    std::vector<std::uint32_t> found = {7};
    BoxGrid(boxes).find({{0, 0}, {5, 5}}, found);
    EXPECT_EQ(found, (std::vector<std::uint32_t>{7, 0}));
}

TEST(BoxGrid, HoldsTheWholeRangeOfIntegers) {
    const std::vector<Box> boxes = {{{INT64_MIN, INT64_MIN}, {INT64_MAX, INT64_MAX}},
                                    {{INT64_MIN, INT64_MIN}, {INT64_MIN, INT64_MIN}},
                                    {{INT64_MAX, INT64_MAX}, {INT64_MAX, INT64_MAX}},
                                    {{0, 0}, {0, 0}}};
    const BoxGrid grid(boxes);
    EXPECT_EQ(find(grid, {{0, 0}, {INT64_MAX, INT64_MAX}}), (std::vector<std::uint32_t>{0, 2, 3}));
    EXPECT_EQ(find(grid, {{INT64_MIN, INT64_MIN}, {-1, -1}}), (std::vector<std::uint32_t>{0, 1}));
}

TEST(BoxGrid, TakesManyBoxesAtOnePlace) {
    const std::vector<Box> boxes(10'000, Box{{3, 3}, {3, 3}});
    EXPECT_EQ(find(BoxGrid(boxes), {{3, 3}, {3, 3}}).size(), boxes.size());
}

// Concentric boxes lie in all cells; the lists must stay linear.
TEST(BoxGrid, TakesManyLargeBoxes) {
    std::vector<Box> boxes;
    for (std::int64_t i = 1; i <= 50'000; ++i) boxes.push_back({{-i, -i}, {i, i}});
    const BoxGrid grid(boxes);
    EXPECT_EQ(find(grid, {{49'990, 0}, {60'000, 1}}).size(), 11u);
}

TEST(BoxGrid, AgreesWithLookingAtAll) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const std::int64_t range = std::int64_t{1} << random.whole(2, 30);
        const std::int64_t size = std::int64_t{1} << random.whole(0, 28);
        std::vector<Box> boxes(static_cast<std::size_t>(random.whole(0, 120)));
        for (Box& box : boxes) {
            if (random.whole(0, 9) == 0) continue;
            box.min = {random.whole(-range, range), random.whole(-range, range)};
            box.max = {box.min.x + random.whole(0, size), box.min.y + random.whole(0, size)};
        }
        const BoxGrid grid(boxes);
        for (int query = 0; query < 10; ++query) {
            Box box{{random.whole(-range, range), random.whole(-range, range)}, {}};
            box.max = {box.min.x + random.whole(0, size), box.min.y + random.whole(0, size)};
            std::vector<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < boxes.size(); ++i) {
                if (!is_empty(boxes[i]) && overlaps(boxes[i], box)) expected.push_back(i);
            }
            ASSERT_EQ(find(grid, box), expected) << "seed " << seed;
        }
    }
}

}  // namespace
}  // namespace filigree
