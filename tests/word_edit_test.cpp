// Edits of words as a person meets them: as statements of a document, and on the command line.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "language/wrong_documents.h"
#include "session/check.h"
#include "tests/program.h"

namespace filigree {
namespace {

using nlohmann::json;

// The word that a document derives; else the status and what is said.
std::string derived(const TestFolder& folder, const std::string& text) {
    const Ran ran = run_program("derive " + folder.write("derived.fil", "grammar rewriting\n" + text));
    if (ran.status != 0) return std::to_string(ran.status) + " " + ran.out;
    return ran.out.substr(0, ran.out.find('\n'));
}

std::string shell_quoted(const std::string& text) { return "'" + text + "'"; }

// An edit of the vectors as a statement's call, and as arguments of the command.
struct Asked {
    std::string call, command;
};
Asked asked(const std::string& op, const json& args) {
    const auto text = [&](std::size_t i) { return args[i].get<std::string>(); };
    const std::string other = args.size() > 1 && args[1].is_string() ? text(1) : "";
    if (op == "breed") return {"breed(with_word: \"" + other + "\")", "breed --with-word " + shell_quoted(other)};
    if (op == "breed_carry") {
        return {"breed(with_word: \"" + other + "\", carry)", "breed --carry --with-word " + shell_quoted(other)};
    }
    if (op == "insert_before") {
        return {"insert(\"" + other + "\", at: \"" + text(2) + "\")",
                "insert " + shell_quoted(other) + " --at " + shell_quoted(text(2))};
    }
    if (op == "append_begin")
        return {"append(\"" + other + "\", to: begin)", "append --to begin " + shell_quoted(other)};
    Asked out;
    if (op == "compress") {
        for (const json& pair : args[1]) {
            const std::string from = pair[0], to = pair[1];
            out.call += (out.call.empty() ? "compress(\"" : ", \"") + from + "\" -> \"" + to + "\"";
            out.command += " " + shell_quoted(from + " -> " + to);
        }
        return {out.call + ")", "compress" + out.command};
    }
    if (op == "react") {
        out = {"react(with_word: \"" + other + "\", unreacted: " + text(3),
               "react --with-word " + other + " --unreacted " + text(3)};
        for (const auto& [pair, product] : args[2].items()) {
            out.call += ", \"" + pair + "\" -> \"" + product.get<std::string>() + "\"";
            out.command += " --pair " + shell_quoted(pair + "->" + product.get<std::string>());
        }
        out.call += ")";
    }
    return out;
}

TEST(WordEdit, TheVectorsByStatementAndByCommand) {
    std::ifstream file(FILIGREE_SOURCE_DIR "/tests/data/rewriting_vectors.json");
    int rows = 0;
    for (const json& row : json::parse(file)) {
        if (row["kind"].get<std::string>() != "edit" || !row["result"].is_string()) continue;
        ++rows;
        const TestFolder folder;
        const Asked edit = asked(row["op"], row["args"]);
        const std::string axiom = "axiom \"" + row["args"][0].get<std::string>() + "\"\n";
        EXPECT_EQ(derived(folder, axiom + "once " + edit.call + "\n"), row["result"].get<std::string>()) << row;
        const std::string document = folder.write("a.fil", "grammar rewriting\n" + axiom);
        const Ran ran = run_program("edit " + document + " " + edit.command);
        EXPECT_EQ(ran.out, row["result"].get<std::string>() + "\n") << edit.command;
    }
    EXPECT_EQ(rows, 12);
}

constexpr const char* drawn =
    "grammar rewriting\nseed 3   # of mutations, too\naxiom \"a\"   # the beginning\niterations 4; a -> \"a[T+b]a\"\n"
    "each iteration substitute(\"bT+\" -> \"b\")\nb -> \"bb\"\n";

TEST(WordEdit, TheCommandDoesWhatTheStatementDoes) {
    for (const auto& [call, command] : std::initializer_list<std::pair<const char*, const char*>>{
             {"mutate(replace: 30%, remove: 10%, swap: 0.1, by: \"cd\")",
              "mutate --replace 30% --remove 10% --swap 0.1 --by cd"},
             {"bend(-1..1, where: depth > 0 && age < 3)", "bend --where 'depth > 0 && age < 3' -- -1..1"},
             {"shrink(1 - 0.1 * depth, \"b\")", "shrink --factor '1 - 0.1 * depth' --at b"},
             {"remove(where: density < 3)", "remove --where 'density < 3'"},
             {"compress(by_rules)", "compress --by-rules"},
         }) {
        const TestFolder folder;
        const std::string document = folder.write("a.fil", drawn);
        const Ran edited = run_program("edit " + document + " " + command);
        const Ran said = run_program("derive " + folder.write("b.fil", drawn + std::string("once ") + call + "\n"));
        EXPECT_EQ(said.status, 0) << said.out;
        EXPECT_EQ(edited.out, said.out) << command;
        EXPECT_NE(edited.out, run_program("derive " + document).out) << command;
        EXPECT_EQ(run_program("edit --seed 3 " + document + " " + command).out, edited.out);
    }
}

TEST(WordEdit, TheWordBecomesADocument) {
    const TestFolder folder;
    const std::string document = folder.write("a.fil", drawn);
    const Ran edited = run_program("edit " + document + " --steps 2 insert 'T+' --at b");
    ASSERT_EQ(edited.status, 0) << edited.out;
    const std::string word = edited.out.substr(0, edited.out.size() - 1);
    const Ran written = run_program("edit " + document + " insert 'T+' --at b --steps 2 -o " + folder / "b.fil");
    EXPECT_EQ(written.status, 0);
    EXPECT_EQ(written.out, "");
    EXPECT_EQ(folder.read("b.fil"), "grammar rewriting\nseed 3   # of mutations, too\naxiom \"" + word +
                                        "\"   # the beginning\na -> \"a[T+b]a\"\nb -> \"bb\"\n");
    EXPECT_EQ(run_program("derive " + folder / "b.fil").out, edited.out);
    EXPECT_GT(run_program("derive --steps 1 " + folder / "b.fil").out.size(), edited.out.size());
    // Nothing that is read is written over.
    EXPECT_EQ(run_program("edit " + document + " clean -o " + document).status, 2);
    EXPECT_EQ(run_program("edit " + document + " add --with " + folder / "b.fil" + " -o " + folder / "b.fil").status,
              2);
    EXPECT_EQ(run_program("edit " + document + " clean -o " + folder / "a.svg").status, 2);
    EXPECT_EQ(folder.read("a.fil"), drawn);
    // Letters that a text would read otherwise.
    const std::string odd = folder.write("odd.fil", "grammar rewriting\nfree \"{}\"\naxiom \"{\\\"\\\\}\"\n");
    EXPECT_EQ(run_program("edit " + odd + " clean -o " + folder / "odd_again.fil").status, 0);
    EXPECT_EQ(run_program("derive " + folder / "odd_again.fil").out, "{\"\\}\n");
    const std::string tilde = folder.write("tilde.fil", "grammar rewriting\naxiom \"~\"\n");
    const Ran unwritable =
        run_program("edit " + tilde + " add --with " + folder.write("n.fil", "grammar rewriting\naxiom \"n\"\n") +
                    " -o " + folder / "none.fil");
    EXPECT_EQ(unwritable.status, 1);
    EXPECT_NE(unwritable.out.find("edit.unwritable-word"), std::string::npos) << unwritable.out;
    EXPECT_FALSE(folder.has("none.fil"));
    folder.write("part.fil", "grammar rewriting\naxiom \"ab\"\n");
    const Ran included = run_program("edit " + folder.write("whole.fil", "grammar rewriting\ninclude \"part.fil\"\n") +
                                     " clean -o " + folder / "none.fil");
    EXPECT_EQ(included.status, 1);
    EXPECT_NE(included.out.find("edit.included-word"), std::string::npos) << included.out;
}

TEST(WordEdit, JsonSaysWhatWasDone) {
    const TestFolder folder;
    const std::string document = folder.write("a.fil", "grammar rewriting\nseed 9\naxiom \"aaaab]\"\n");
    const json chunks = json::parse(run_program("edit " + document + " compress 'aa -> c' --format json").out);
    EXPECT_EQ(chunks["document"], "a.fil");
    EXPECT_EQ(chunks["seed"], 9);
    EXPECT_EQ(chunks["edit"], "compress(\"aa\" -> \"c\")");
    EXPECT_EQ(chunks["symbols"], json::parse(R"({"before": 6, "removed": 4, "added": 2, "after": 4})"));
    EXPECT_EQ(chunks["chunks"], json::parse(R"({"replaced": 2, "passes": 1})"));
    EXPECT_EQ(chunks["word"], "ccb]");
    const json cleaned = json::parse(run_program("edit " + document + " clean --format json").out);
    EXPECT_EQ(cleaned["changes"], json::parse(R"(["removed 1 ']' that closes nothing, at 5"])"));
    EXPECT_EQ(cleaned["symbols"]["removed"], 1);
    const json crossed = json::parse(
        run_program("edit " + document + " crossover --from 0 --to 1 --other-to 2 --with-word xyz --format json").out);
    EXPECT_EQ(crossed["word"], "xyaaab]");
    EXPECT_EQ(crossed["other"], "az");
}

TEST(WordEdit, OtherDocumentsAreReadLikeEmbeddedOnes) {
    const TestFolder folder;
    const std::string other = "grammar rewriting\naxiom \"b\"\niterations 2\nb -> \"bc\"\nonce add(with_word: \"d\")\n";
    folder.write("parts/other.fil", other);
    EXPECT_EQ(derived(folder, "axiom \"aaa\"\nonce breed(\"parts/other.fil\")\n"), "abacacd");
    EXPECT_EQ(run_program("edit " + folder.write("a.fil", "grammar rewriting\naxiom \"aaa\"\n") + " breed --with " +
                          folder / "parts/other.fil")
                  .out,
              "abacacd\n");
    const std::string system =
        folder.write("s.fil", "grammar rewriting\naxiom \"aa\"\nsystem B { axiom \"b\"; iterations 1; b -> \"bc\" }\n");
    EXPECT_EQ(run_program("edit " + system + " breed --with B").out, "abac\n");
    // A chain of documents ends, or is refused.
    folder.write("one.fil", "grammar rewriting\naxiom \"a\"\nonce add(\"two.fil\")\n");
    folder.write("two.fil", "grammar rewriting\naxiom \"b\"\nonce add(\"one.fil\")\n");
    EXPECT_NE(run_program("derive " + folder / "one.fil").out.find("embed.cycle"), std::string::npos);
    folder.write("two.fil", "grammar rewriting\naxiom \"b\"\nonce add(\"parts/other.fil\")\n");
    EXPECT_EQ(run_program("derive " + folder / "one.fil").out, "abbccd\n");
    EXPECT_NE(derived(folder, "axiom \"a\"\nonce add(\"none.fil\")\n").find("input.missing"), std::string::npos);
    folder.write("tangle.fil", "grammar tangle\nstart a = circle(50)\n");
    EXPECT_NE(derived(folder, "axiom \"a\"\nonce add(\"tangle.fil\")\n").find("rewriting.no-word"), std::string::npos);
    folder.write("wrong.fil", "grammar rewriting\naxiom \"b\"\nonce bread(\"x\")\n");
    EXPECT_NE(derived(folder, "axiom \"a\"\nonce add(\"wrong.fil\")\n").find("wrong.fil:3:6: error"),
              std::string::npos);
}

TEST(WordEdit, WhatEditsPutIsNotExplainedByRules) {
    const TestFolder folder;
    const auto explained = [&](const std::string& edits, int steps) {
        const std::string text = "grammar rewriting\naxiom \"a\"\niterations 4\na -> \"ab\"\n" + edits;
        return run_program("derive " + folder.write("a.fil", text) + " --explain 1 --steps " + std::to_string(steps));
    };
    const std::string late = "after 3..5 insert(\"c\")\nafter 2 insert(\"d\")\n";
    EXPECT_EQ(explained(late, 1).status, 0);
    EXPECT_NE(explained(late, 1).out.find("iteration 1: b at 1, put by "), std::string::npos);
    const Ran wrong = explained(late, 4);
    EXPECT_EQ(wrong.status, 1);
    EXPECT_NE(wrong.out.find(":6:9: error: "), std::string::npos) << wrong.out;
    EXPECT_NE(wrong.out.find("rewriting.edited-word"), std::string::npos) << wrong.out;
    EXPECT_NE(wrong.out.find("the words up to --steps 1 can be explained"), std::string::npos) << wrong.out;
    EXPECT_EQ(explained(late, 2).status, 1);
    EXPECT_EQ(explained("once insert(\"c\")\n", 1).status, 1) << "it edits whatever is asked for";
}

TEST(WordEdit, WrongCommandsAreToldWhereTheyAreWrong) {
    const TestFolder folder;
    const std::string document = folder.write("a.fil", "grammar rewriting\naxiom \"a[b]\"\n");
    const auto said = [&](const std::string& command, const std::string& part) {
        const Ran ran = run_program("edit " + document + " " + command);
        EXPECT_NE(ran.status, 0) << command;
        EXPECT_NE(ran.out.find(part), std::string::npos) << command << "\n" << ran.out;
        return ran.status;
    };
    EXPECT_EQ(said("insert T+ --where 'detph > 1'", "edit:1:"), 1);
    EXPECT_EQ(said("insert T+ --where 'detph > 1'", "did you mean 'depth'"), 1);
    EXPECT_EQ(said("insert '['", "rewriting.unbalanced-text"), 1);
    EXPECT_EQ(said("insert T+ --place behind", "'before' or 'after'"), 1);
    EXPECT_EQ(said("remove --from 1 --to 3", "a whole range is 1 to 4"), 1);
    EXPECT_EQ(said("breed", "rewriting.other-word"), 1);
    EXPECT_EQ(said("breed --with none.fil", "none.fil"), 3);
    EXPECT_EQ(said("compress", "rewriting.missing-pairs"), 1);
    EXPECT_EQ(said("compress aaa", "edit.bad-pair"), 2);
    EXPECT_EQ(said("compress 'a->b->c'", "edit.bad-pair"), 2);
    EXPECT_EQ(said("compress 'a -> bb'", "rewriting.not-one-symbol"), 1);
    EXPECT_EQ(said("insert", "text"), 2);
    EXPECT_EQ(said("bread", "subcommand"), 2);
    EXPECT_EQ(said("", "subcommand"), 2);
    EXPECT_EQ(run_program("edit " + folder.write("t.fil", "grammar tangle\nstart a = circle(9)\n") + " clean").status,
              2);
    for (const char* edit : {"add", "breed", "react", "compress", "substitute", "insert", "append", "remove",
                             "crossover", "mutate", "clean", "shrink", "twist", "bend"}) {
        const Ran help = run_program("edit " + document + " " + edit + " --help");
        EXPECT_EQ(help.status, 0);
        EXPECT_EQ(run_program(std::string("describe ") + edit).status, 0) << edit;
    }
}

TEST(WordEdit, WrongStatementsAreToldWhereTheyAreWrong) {
    int checked = 0;
    for (const WrongDocument& wrong : read_wrong_documents(FILIGREE_SOURCE_DIR "/tests/data/wrong_word_edits.txt")) {
        const OpenedDocument opened = open_text("case.fil", wrong.text, {});
        EXPECT_EQ(difference(wrong, check_document(opened).diagnostics, opened.document.sources), "");
        EXPECT_EQ(wrong.malformed, "") << wrong.name;
        ++checked;
    }
    EXPECT_GE(checked, 25);
}

}  // namespace
}  // namespace filigree
