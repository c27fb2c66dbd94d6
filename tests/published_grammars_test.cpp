// The grammars published with gTangle: every rule parses, and each grammar's graph has the figures that
// follow from the paper's definition (section 5).
#include <gtest/gtest.h>

#include <map>

#include "session/check.h"
#include "tests/program.h"

namespace filigree {
namespace {

// The sections of the file: a grammar's name, and its rules as a document.
std::map<std::string, std::string> published() {
    std::map<std::string, std::string> grammars;
    std::ifstream file(FILIGREE_SOURCE_DIR "/tests/data/published_grammars.txt");
    std::string name;
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("## ", 0) == 0) {
            name = line.substr(3, line.find(" (") - 3);
            grammars[name] = "grammar tangle\nstart big_poly = rectangle(400, 400)\n";
        } else if (!name.empty()) {
            grammars[name] += line + "\n";
        }
    }
    return grammars;
}

TEST(PublishedGrammars, EveryRuleParses) {
    std::size_t rules = 0;
    for (const auto& [name, text] : published()) {
        const OpenedDocument opened = open_text(name, text, {});
        EXPECT_FALSE(has_errors(opened.diagnostics)) << to_text(opened.diagnostics, opened.document.sources);
        rules += check_document(opened).rules.size();
    }
    EXPECT_EQ(rules, 186U);
}

TEST(PublishedGrammars, GraphsHaveTheFiguresOfTheDefinition) {
    struct Figures {
        std::size_t nodes, edges, longest_path;
    };
    const std::map<std::string, Figures> expected = {{"Tree", {22, 23, 7}},  {"Albert", {25, 30, 6}},
                                                     {"Tiger", {33, 29, 6}}, {"Teaser", {37, 42, 8}},
                                                     {"Leaf", {12, 11, 7}},  {"Figure 10", {28, 42, 7}}};
    const auto grammars = published();
    for (const auto& [name, figures] : expected) {
        const OpenedDocument opened = open_text(name, grammars.at(name), {});
        const CheckedDocument checked = check_document(opened);
        EXPECT_EQ(checked.rules.size(), figures.nodes) << name;
        EXPECT_EQ(checked.graph.edges, figures.edges) << name;
        EXPECT_EQ(checked.graph.longest_path, figures.longest_path) << name;
    }
}

// What its authors did not see: misspelt tags and rules that never apply.
TEST(PublishedGrammars, TheCheckerFindsTheirSlips) {
    const std::string text = published().at("Tiger");
    const OpenedDocument opened = open_text("tiger", text, {});
    std::vector<std::string> unreachable;
    for (const Diagnostic& diagnostic : check_document(opened).diagnostics) {
        if (diagnostic.code == "tangle.unreachable-rule") {
            unreachable.push_back(text.substr(diagnostic.span.begin, diagnostic.span.end - diagnostic.span.begin));
        }
    }
    EXPECT_EQ(unreachable, (std::vector<std::string>{"remainder_b", "slice_b", "outline"}));
}

TEST(PublishedGrammars, TheGraphIsPrintedBesideErrors) {
    const TestFolder folder;
    const Ran ran =
        run_program("check " + folder.write("tiger.fil", published().at("Tiger") + "frobnicate() : quads\n"));
    EXPECT_EQ(ran.status, 1);
    EXPECT_NE(ran.out.find("rules 34, edges 30, longest path 6"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("there is no operator 'frobnicate'"), std::string::npos);
}

TEST(PublishedGrammars, AllGrow) {
    const TestFolder folder;
    const auto grammars = published();
    for (const char* name : {"Tree", "Albert", "Tiger", "Teaser", "Leaf", "Figure 6", "Figure 7", "Figure 10"}) {
        for (int seed = 0; seed < 5; ++seed) {
            const Ran ran = run_program("render " + folder.write("a.fil", grammars.at(name)) + " --verify --seed " +
                                        std::to_string(seed) + " -o " + folder / "a.svg");
            EXPECT_EQ(ran.status, 0) << name << " " << seed << ran.out;
        }
    }
}

}  // namespace
}  // namespace filigree
