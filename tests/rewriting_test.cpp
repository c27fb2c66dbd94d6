// Rewriting documents as a person meets them: on the command line.
#include <gtest/gtest.h>

#include "tests/program.h"

namespace filigree {
namespace {

constexpr const char* koch = "grammar rewriting\naxiom \"F-F-F-F\"\niterations 3\nF -> \"F-F+F+FF-F-F+F\"\n";

std::string derived(const std::string& text, const std::string& options) {
    const TestFolder folder;
    const Ran ran = run_program("derive " + folder.write("a.fil", text) + " " + options);
    return ran.status == 0 ? ran.out : std::to_string(ran.status) + " " + ran.out;
}

TEST(Rewriting, DerivePrintsTheWord) {
    const std::string grammar = "grammar rewriting\naxiom \"aa===\"\niterations 4\na -> \"ab\"\n";
    EXPECT_EQ(derived(grammar, "--steps 2"), "abba=\n");
    EXPECT_EQ(derived(grammar, ""), "abbbbab\n");
    EXPECT_EQ(derived(koch, "--steps 0"), "F-F-F-F\n");
    EXPECT_NE(derived(grammar, "--steps 1 --format json").find("{\n      \"index\": 2,\n      \"symbol\": \"a\",\n"),
              std::string::npos);
}

TEST(Rewriting, LongWordsAreAskedWithoutMakingThem) {
    EXPECT_EQ(derived(koch, "--length"), "3803\n");
    EXPECT_EQ(derived(koch, "--counts"), "F 2048\n- 879\n+ 876\n");
    EXPECT_EQ(derived(koch, "--slice 3:5"), "+F+FF\n");
    // 4 * 8^60 symbols F, and every step adds 7 signs to each.
    EXPECT_EQ(derived(koch, "--steps 60 --counts").substr(0, 57),
              "F 6129982163463555433433388108601236734474956488734408704");
    EXPECT_EQ(derived(koch, "--steps 60 --slice 0:7"), "F-F+F+F\n");
    EXPECT_EQ(derived(koch, "--steps 60").substr(0, 2), "4 ");
    EXPECT_EQ(derived("grammar rewriting\naxiom \"q\"\n", "--length").substr(0, 2), "1 ");
    EXPECT_EQ(derived(koch, "--slice x").substr(0, 2), "2 ");
}

TEST(Rewriting, WhatIsNotThereYetIsSaid) {
    const TestFolder folder;
    const std::string words = folder.write("a.fil", koch);
    const Ran rendered = run_program("render " + words + " -o " + folder / "a.svg");
    EXPECT_EQ(rendered.status, 1);
    EXPECT_NE(rendered.out.find("document.no-drawing"), std::string::npos) << rendered.out;
    const Ran embedded = run_program(
        "check " + folder.write("b.fil", "grammar tangle\nstart a = circle(50)\nembed(\"a.fil\") : a -> b\n"));
    EXPECT_EQ(embedded.status, 1);
    EXPECT_NE(embedded.out.find("embed.no-drawing"), std::string::npos) << embedded.out;
    for (const char* command : {"choices ", "pick --at 0,0 ", "keep "}) {
        const Ran ran = run_program(command + words + (std::string(command) == "keep " ? " a" : ""));
        EXPECT_LE(ran.status, 4) << command << ran.out;
    }
}

}  // namespace
}  // namespace filigree
