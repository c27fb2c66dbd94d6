// Every example renders, holds its invariants and warns of nothing.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program.h"

namespace filigree {
namespace {

TEST(Examples, RenderVerifiedWithoutAWord) {
    int examples = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::string(FILIGREE_SOURCE_DIR) + "/examples")) {
        if (entry.path().extension() != ".fil") continue;
        ++examples;
        const TestFolder folder;
        const Ran ran = run_program("render " + entry.path().string() + " --verify -o " + folder / "a.svg" + " -o " +
                                    folder / "a.png" + " --stats " + folder / "a.json");
        EXPECT_EQ(ran.status, 0) << entry.path() << ran.out;
        EXPECT_EQ(ran.out, "") << entry.path();
        EXPECT_EQ(nlohmann::json::parse(folder.read("a.json"))["verified"], true);
        for (const char* colours : {"tag", "group", "step"}) {
            EXPECT_EQ(
                run_program("render " + entry.path().string() + " --colour-by " + colours + " -o " + folder / "b.svg")
                    .status,
                0);
        }
    }
    EXPECT_GE(examples, 3);
}

}  // namespace
}  // namespace filigree
