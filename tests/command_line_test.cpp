// The command line's contract: statuses, outputs, statistics, what is never touched.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/program.h"

namespace filigree {
namespace {

const std::string leaf = std::string(FILIGREE_SOURCE_DIR) + "/examples/tangle/leaf.fil";

constexpr const char* small_document =
    "grammar tangle\nseed 3\nparam spacing = 12 in 5..40 \"distance\"\nstart a = circle(60)\n"
    "regular_split(line, spacing) : a -> strip\noutline(2) : strip -> in, out  # a comment\n";

TEST(CommandLine, RendersTheReadmesExample) {
    const TestFolder folder;
    const Ran ran = run_program("render " + leaf + " -o " + folder / "leaf.svg" + " -o " + folder / "leaf.png" +
                                " --stats " + folder / "leaf.json" + " --verify");
    EXPECT_EQ(ran.status, 0) << ran.out;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(folder.read("leaf.png").substr(1, 3), "PNG");
    const auto stats = nlohmann::json::parse(folder.read("leaf.json"));
    EXPECT_EQ(stats["engine"], "tangle");
    EXPECT_EQ(stats["rules"], 12);
    EXPECT_EQ(stats["verified"], true);
    EXPECT_GT(stats["elements"], 1000);
    EXPECT_NEAR(stats["area"]["leaves"].get<double>(), stats["area"]["start"].get<double>(),
                1e-9 * stats["area"]["start"].get<double>());
    for (const char* phase : {"parse", "derive", "draw", "write", "total"}) EXPECT_GE(stats["seconds"][phase], 0);
}

TEST(CommandLine, AnExportedSvgOpensAgainToTheSameBytes) {
    const TestFolder folder;
    ASSERT_EQ(
        run_program("render " + leaf + " --seed 77 -o " + folder / "one.svg" + " -o " + folder / "one.png").status, 0);
    ASSERT_EQ(
        run_program("render " + folder / "one.svg" + " -o " + folder / "two.svg" + " -o " + folder / "two.png").status,
        0);
    EXPECT_EQ(folder.read("one.svg"), folder.read("two.svg"));
    EXPECT_EQ(folder.read("one.png"), folder.read("two.png"));
    EXPECT_NE(folder.read("one.svg").find("seed 77"), std::string::npos);
}

TEST(CommandLine, SetEditsTheParamLineAndNothingElse) {
    const TestFolder folder;
    const std::string document = folder.write("a.fil", small_document);
    ASSERT_EQ(run_program("render " + document + " --set spacing=20 -o " + folder / "a.svg").status, 0);
    const std::string svg = folder.read("a.svg");
    EXPECT_NE(svg.find("param spacing = 20 in 5..40 \"distance\""), std::string::npos);
    EXPECT_NE(svg.find("# a comment"), std::string::npos);
    EXPECT_EQ(folder.read("a.fil"), small_document);
    const Ran unknown = run_program("render " + document + " --set spacin=20 -o " + folder / "b.svg");
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.out.find("did you mean 'spacing'"), std::string::npos) << unknown.out;
    EXPECT_EQ(run_program("render " + document + " --set spacing=90 -o " + folder / "b.svg").status, 1);
    EXPECT_EQ(run_program("render " + document + " --set spacing -o " + folder / "b.svg").status, 2);
    EXPECT_FALSE(folder.has("b.svg"));
}

TEST(CommandLine, Statuses) {
    const TestFolder folder;
    const std::string good = folder.write("good.fil", small_document);
    const std::string wrong =
        folder.write("wrong.fil", "grammar tangle\nstart a = circle(60)\noutlin(3) : a -> b, c\n");
    const std::string missing = folder.write("missing.fil", "grammar tangle\nstart a = file(\"none.svg\")\n");
    const std::string large = folder.write(
        "large.fil", "grammar tangle\nlimit elements 100\nstart a = circle(60)\nregular_split(line, 0.1) : a -> b\n");
    const std::string endless =
        folder.write("endless.fil", "grammar tangle\nstart a = circle(60)\nungroup() : a -> a\n");
    const std::string out = " -o " + folder / "out.svg";
    EXPECT_EQ(run_program("render " + good + out).status, 0);
    std::filesystem::remove(folder / "out.svg");
    EXPECT_EQ(run_program("render " + wrong + out).status, 1);
    EXPECT_EQ(run_program("render " + missing + out).status, 1);
    EXPECT_EQ(run_program("render").status, 2);
    EXPECT_EQ(run_program("").status, 2);
    EXPECT_EQ(run_program("render " + good + " -o " + folder / "out.xyz").status, 2);
    EXPECT_EQ(run_program("frobnicate").status, 2);
    EXPECT_EQ(run_program("render " + folder / "none.fil" + out).status, 3);
    EXPECT_EQ(run_program("render " + good + " -o " + folder / "no/such/folder/out.svg").status, 3);
    EXPECT_EQ(run_program("render " + large + out).status, 4);
    EXPECT_EQ(run_program("render " + endless + out).status, 4);
    EXPECT_FALSE(folder.has("out.svg"));
    EXPECT_EQ(run_program("--help").status, 0);
    EXPECT_EQ(run_program("--version").status, 0);
}

// Beside a document that is named without a folder, a file without a name has no path at all.
TEST(CommandLine, AFileWithoutANameIsAnError) {
    const TestFolder folder;
    folder.write("shape.fil", "grammar shape\nstart a = file(\"\")\n");
    folder.write("include.fil", "include \"\"\ngrammar tangle\nstart a = circle(5)\n");
    folder.write("start.fil", "grammar tangle\nstart from \"\"\n");
    const std::filesystem::path here = std::filesystem::current_path();
    std::filesystem::current_path(folder / "");
    for (const std::string name : {"shape.fil", "include.fil", "start.fil"}) {
        const Ran ran = run_program("check " + name);
        EXPECT_EQ(ran.status, 1) << ran.out;
        EXPECT_NE(ran.out.find("input.missing"), std::string::npos) << ran.out;
    }
    std::filesystem::current_path(here);
}

TEST(CommandLine, WhatADocumentReadsIsNeverOverwritten) {
    const TestFolder folder;
    const std::string picture =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"100\"><rect width=\"80\" "
        "height=\"80\"/></svg>";
    folder.write("start.svg", picture);
    const std::string document =
        folder.write("a.fil", "grammar tangle\nstart a = file(\"start.svg\")\nregular_split(9) : a -> b\n");
    const Ran ran = run_program("render " + document + " -o " + folder / "start.svg");
    EXPECT_EQ(ran.status, 2) << ran.out;
    EXPECT_EQ(folder.read("start.svg"), picture);
    EXPECT_EQ(run_program("render " + document + " -o " + folder / "x.svg" + " -o " + folder / "./x.svg").status, 2);
}

TEST(CommandLine, AWrongDocumentLeavesOldOutputsAlone) {
    const TestFolder folder;
    const std::string document = folder.write("a.fil", "grammar tangle\nstart a = circle(60)\noutline(3) : a -> b c\n");
    folder.write("a.svg", "old");
    EXPECT_EQ(run_program("render " + document + " -o " + folder / "a.svg").status, 1);
    EXPECT_EQ(folder.read("a.svg"), "old");
}

TEST(CommandLine, DocumentsReadOnlyBelowTheirFolder) {
    const TestFolder folder;
    folder.write("secret.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><rect width=\"80\" height=\"80\"/></svg>");
    const std::string document = folder.write("sub/a.fil", "grammar tangle\nstart a = file(\"../secret.svg\")\n");
    const Ran refused = run_program("check " + document);
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.out.find("input.outside"), std::string::npos) << refused.out;
    EXPECT_EQ(run_program("check " + document + " --allow " + folder / ".").status, 0);
}

TEST(CommandLine, DeriveListsSteps) {
    const TestFolder folder;
    const std::string document = folder.write("a.fil", small_document);
    const Ran text = run_program("derive " + document);
    EXPECT_EQ(text.status, 0);
    EXPECT_NE(text.out.find("1  a/regular_split  (line 5)  1 -> "), std::string::npos) << text.out;
    const auto json = nlohmann::json::parse(run_program("derive " + document + " --format json").out);
    EXPECT_EQ(json["steps"].size(), 2);
    EXPECT_EQ(json["steps"][1]["operator"], "outline");
    EXPECT_EQ(json["steps"][1]["path"], "a/regular_split/strip/outline");
    const auto one = nlohmann::json::parse(run_program("derive " + document + " --steps 1 --format json").out);
    EXPECT_EQ(one["steps"].size(), 1);
    EXPECT_EQ(one["steps"][0]["key"], json["steps"][0]["key"]);
}

TEST(CommandLine, TitlesOfExamplesAreListedAsTheyAre) {
    const Ran ran = run_program("list");
    EXPECT_NE(ran.out.find("in a rim of beads; figure-16-target.fil"), std::string::npos) << ran.out;
}

TEST(CommandLine, EveryOperatorHasAPage) {
    for (const char* name : {"outline", "regularSplit", "stipling", "place", "circle", "tangle"}) {
        const Ran page = run_program(std::string("describe ") + name);
        EXPECT_EQ(page.status, 0);
        EXPECT_GT(page.out.size(), 80U);
    }
    const Ran unknown = run_program("describe outlin");
    EXPECT_EQ(unknown.status, 2);
    EXPECT_NE(unknown.out.find("did you mean 'outline'"), std::string::npos);
    EXPECT_TRUE(nlohmann::json::accept(run_program("describe --json").out));
}

TEST(CommandLine, TheReferenceIsUpToDate) {
    std::ifstream file(std::string(FILIGREE_SOURCE_DIR) + "/docs/reference.md");
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_EQ(text.str(), run_program("describe --markdown").out) << "run scripts/reference";
}

TEST(CommandLine, WatchRendersAgainAndEndsOnAnInterrupt) {
    const TestFolder folder;
    const std::string document = folder.write("a.fil", small_document);
    const std::string output = folder / "a.svg";
    const pid_t child = fork();
    if (child == 0) {
        freopen("/dev/null", "w", stderr);
        execl(FILIGREE_PROGRAM, FILIGREE_PROGRAM, "render", document.c_str(), "-o", output.c_str(), "--watch", nullptr);
        _exit(127);
    }
    const auto wait_for = [&](const auto& condition) {
        for (int i = 0; i < 600 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
        return condition();
    };
    EXPECT_TRUE(wait_for([&] { return folder.has("a.svg"); }));
    const std::string first = folder.read("a.svg");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    folder.write("a.fil", std::string("# edited\n") + small_document);
    EXPECT_TRUE(wait_for([&] { return folder.read("a.svg") != first; }));
    kill(child, SIGINT);
    int ended = 0;
    waitpid(child, &ended, 0);
    EXPECT_TRUE(WIFEXITED(ended) && WEXITSTATUS(ended) == 0);
}

}  // namespace
}  // namespace filigree
