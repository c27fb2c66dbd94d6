// Rewriting documents as a person meets them: on the command line.
#include <gtest/gtest.h>

#include "base/unicode.h"
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

TEST(Rewriting, ControlCharactersAreShownAsTheLanguageWritesThem) {
    const std::string grammar = "grammar rewriting\naxiom \"a\\u{1b}\\u{7}\\u{9b}\\u{e9}\"\n";
    EXPECT_EQ(derived(grammar, ""), "a\\u{1b}\\u{7}\\u{9b}\u00E9\n");
    EXPECT_EQ(derived(grammar, "--slice 1:1"), "\\u{1b}\n");
    EXPECT_EQ(derived(grammar, "--counts"), "a 1\n\\u{1b} 1\n\\u{7} 1\n\\u{9b} 1\n\u00E9 1\n");
    EXPECT_EQ(derived(grammar, "--explain 1"),
              "iteration 0: \\u{1b} at 1, of the axiom\niteration 1: kept, since no rule applies; "
              "it becomes \"\\u{1b}\"\n");
    EXPECT_NE(derived(grammar, "--format json").find("\"word\": \"a\\u001b\\u0007\xC2\x9B\u00E9\""), std::string::npos);
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

TEST(Rewriting, ExplainsASymbol) {
    const std::string grammar =
        "grammar rewriting\naxiom \"ba[a=]c\"\niterations 2\na@1 -> \"ab\"\nc < a -> \"x\"\na > \"[c]\" -> \"d\"\n"
        "a -> \"y\" when age > 3 && depth < 2\na@5..7 -> \"z\"\nb -> \"ba\"\na -> \"aa\" when index > 0\n";
    EXPECT_EQ(derived(grammar, "--steps 1"), "baab[a]c\n");
    const TestFolder folder;
    const std::string file = folder.write("a.fil", grammar);
    const Ran ran = run_program("derive " + file + " --steps 1 --explain 2");
    const auto at = [&](int line) { return file + ":" + std::to_string(line) + ": "; };
    EXPECT_EQ(ran.out, "iteration 0: a at 1, of the axiom\niteration 1: a at 2, put by " + at(4) +
                           "a@1 -> \"ab\"\niteration 2: it becomes \"aa\"\n"
                           "  " +
                           at(4) +
                           "a@1 -> \"ab\"\n    serves iteration 1, and this is 2\n"
                           "  " +
                           at(5) +
                           "c < a -> \"x\"\n    'c' does not stand before it, but 'a'\n"
                           "  " +
                           at(6) +
                           "a > \"[c]\" -> \"d\"\n    '[c]' does not stand behind it, but 'b[a'\n"
                           "  " +
                           at(7) +
                           "a -> \"y\" when age > 3 && depth < 2\n"
                           "    its condition does not hold: age = 1, depth = 0\n"
                           "  " +
                           at(8) +
                           "a@5..7 -> \"z\"\n    serves iterations 5..7, and this is 2\n"
                           "  " +
                           at(10) + "a -> \"aa\" when index > 0\n    applies\n");
    const std::string json = derived(grammar, "--steps 0 --explain 3 --format json");
    EXPECT_NE(json.find("\"turns\": 1,\n      \"then\": \"asleep\",\n      \"rule\": null"), std::string::npos) << json;
    EXPECT_NE(json.find("\"becomes\": \"a\""), std::string::npos) << json;
    EXPECT_NE(json.find("\"verdict\": \"applies\""), std::string::npos) << json << "were it awake";
    const std::string held = folder.write("b.fil", grammar + "mask b@2\nsleep c until t > 2\n");
    EXPECT_EQ(run_program("derive " + held + " --steps 1 --explain 7").out,
              "iteration 0: c at 5, of the axiom\niteration 1: c at 7, from the one before, kept by " + held +
                  ":12: sleep c until t > 2\niteration 2: kept by " + held +
                  ":12: sleep c until t > 2; it becomes \"c\"\n");
    EXPECT_EQ(derived(grammar, "--steps 1 --explain 9").substr(0, 2), "2 ");
    EXPECT_EQ(derived("grammar tangle\nstart a = circle(50)\n", "--explain 0").substr(0, 2), "2 ");
}

TEST(Rewriting, ArraysAreReadFromFiles) {
    const TestFolder folder;
    folder.write("rules.csv", "ab,ac\r\nba,\"\"\r\n");
    const std::string head = "grammar rewriting\naxiom \"aA\"\niterations 1\na -> M[0][1]\n";
    const std::string inner = "system A { axiom \"b\"; iterations 1; array N from \"rules.csv\"; b -> N[1][0] }\n";
    const std::string file = folder.write("a.fil", head + "array M from \"rules.csv\"\n" + inner);
    EXPECT_EQ(run_program("derive " + file).out, "acba\n");
    const Ran missing = run_program("derive " + folder.write("b.fil", head + "array M from \"none.csv\"\n"));
    EXPECT_EQ(missing.status, 1);
    EXPECT_EQ(missing.out.find("input.missing"), missing.out.rfind("input.missing")) << missing.out;
    const Ran outside = run_program("derive " + folder.write("c.fil", head + "array M from \"../x.csv\"\n"));
    EXPECT_NE(outside.out.find("input.outside"), std::string::npos) << outside.out;
}

TEST(Rewriting, WordsAreDrawnInEveryFormat) {
    const TestFolder folder;
    const std::string words = folder.write("a.fil", koch);
    const std::string outputs = " -o " + folder / "a.svg" + " -o " + folder / "a.png" + " -o " + folder / "a.pdf";
    const Ran rendered = run_program("render " + words + outputs + " --stats " + folder / "a.json");
    ASSERT_EQ(rendered.status, 0) << rendered.out;
    // One line, and as many points as symbols F, the first again at the end.
    const std::string svg = folder.read("a.svg");
    EXPECT_EQ(svg.find("<path "), svg.rfind("<path "));
    EXPECT_NE(folder.read("a.json").find("\"length\": " + std::string("3803")), std::string::npos)
        << folder.read("a.json");
    // What was written is opened again to the same bytes.
    ASSERT_EQ(run_program("render " + folder / "a.svg" + " -o " + folder / "b.svg").status, 0);
    EXPECT_EQ(folder.read("b.svg"), svg);
}

TEST(Rewriting, PagesAreFilledInSpaceAsInTheWall) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil",
                                          "grammar rewriting\npage 300 x 200 margin 10\naxiom \"a+aPa+a\"\n"
                                          "view 30, 25\nangle 90\nwidth 6\n");
    const Ran ran = run_program("render " + file + " -o " + folder / "a.svg");
    EXPECT_EQ(ran.out.find("warning"), std::string::npos) << ran.out;
    const std::string svg = folder.read("a.svg");
    EXPECT_NE(svg.find(" 300 200\""), std::string::npos);
    EXPECT_NE(svg.find("d=\"m-13.784-90 "), std::string::npos) << "pens take no room:\n" << svg;
}

TEST(Rewriting, StylesAskWhatIsKnownOfASymbol) {
    const TestFolder folder;
    const auto colours = [&](const std::string& style) {
        const std::string file =
            folder.write("a.fil", "grammar rewriting\naxiom \"aa[a]\"\niterations 1\n" + style + "\n");
        const Ran ran = run_program("render " + file + " -o " + folder / "a.svg");
        EXPECT_EQ(ran.status, 0) << ran.out;
        const std::string svg = folder.read("a.svg");
        return std::pair(svg.find("stroke=\"#ff0000") != std::string::npos,
                         svg.find("stroke=\"#000000") != std::string::npos);
    };
    EXPECT_EQ(colours("style a when depth > 0 { stroke: #ff0000 }"), std::pair(true, true));
    EXPECT_EQ(colours("style a when age > 1 { stroke: #ff0000 }"), std::pair(true, false));
    EXPECT_EQ(colours("style a when age > 2 { stroke: #ff0000 }"), std::pair(false, true));
    EXPECT_EQ(colours("let old = 1\nstyle a { stroke: index > old ? #ff0000 : #000000 }"), std::pair(true, true));
    EXPECT_EQ(colours("style a when t > 0 && x < 1000 { stroke: #ff0000 }"), std::pair(true, false));
    EXPECT_EQ(colours("style a when count == 3 { stroke: #ff0000 }"), std::pair(true, false));
    EXPECT_EQ(colours("style a { stroke: [#ff0000, #000000] }"), std::pair(true, true));
    EXPECT_EQ(colours("style a when density > 1 { stroke: #ff0000 }"), std::pair(true, true));
}

TEST(Rewriting, WhatPutASymbolIsTold) {
    const TestFolder folder;
    const std::string file =
        folder.write("a.fil", "grammar rewriting\naxiom \"a\"\niterations 2\na@1 -> \"bb\"\nb -> \"cF\"\nstep 10\n");
    const std::string out = run_program("pick " + file + " --at 35,0").out;
    EXPECT_EQ(out.substr(0, 6), "word/4") << out;
    EXPECT_NE(out.find("made by iteration 2  (a.fil, line 5)\n    b -> \"cF\"\n"), std::string::npos) << out;
    EXPECT_NE(out.find("made by iteration 1  (a.fil, line 4)\n    a@1 -> \"bb\"\n"), std::string::npos) << out;
    EXPECT_EQ(run_program("pick " + file + " --at 35,9").out, "nothing is drawn there\n");
    const std::string host =
        folder.write("b.fil", "grammar tangle\nstart s = rectangle(40, 10)\nembed(\"a.fil\") : s\n");
    const std::string inner = run_program("pick " + host + " --at 0,0").out;
    EXPECT_NE(inner.find("b -> \"cF\""), std::string::npos) << inner;
    EXPECT_NE(inner.find("embed(document: \"a.fil\")"), std::string::npos) << inner;
}

TEST(Rewriting, SubsystemsGoTheirOwnWay) {
    const TestFolder folder;
    const std::string file = folder.write(
        "a.fil", "grammar rewriting\naxiom \"aA\"\niterations 1\nsystem A { axiom \"[+b]\"; step 3; angle 90 }\n");
    ASSERT_EQ(run_program("render " + file + " -o " + folder / "a.svg" + " -o " + folder / "a.obj").out, "");
    // A third to the right and three thirds down, scaled to 400 px.
    const std::string svg = folder.read("a.svg"), obj = folder.read("a.obj");
    EXPECT_NE(svg.find("d=\"m-66.667-200h133.334v400\""), std::string::npos) << svg;
    EXPECT_NE(obj.find("v 1 0 0\nv 1 -3 0\n"), std::string::npos) << obj;
    EXPECT_EQ(run_program("pick " + file + " --at 66.667,100").out.substr(0, 6), "word/4");
}

TEST(Rewriting, LettersPlaceWhatFilesHold) {
    const TestFolder folder;
    folder.write("leaf.svg", "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0h10v5h-10z'/></svg>");
    const std::string file =
        folder.write("a.fil", "grammar rewriting\naxiom \"lll\"\nstep 20\nletter l file(\"leaf.svg\")\n");
    ASSERT_EQ(run_program("render " + file + " -o " + folder / "a.svg").out, "");
    const std::string svg = folder.read("a.svg");
    EXPECT_NE(svg.find("h10v5h-10z"), std::string::npos) << svg;
    // Three of them, and the file itself is carried.
    EXPECT_NE(svg.find("leaf.svg"), std::string::npos) << svg;
    std::filesystem::remove(folder / "leaf.svg");
    EXPECT_EQ(run_program("render " + folder / "a.svg" + " -o " + folder / "b.svg").out, "");
    EXPECT_EQ(folder.read("b.svg"), svg);
}

TEST(Rewriting, WhatIsTooLargeToDrawIsSaid) {
    const TestFolder folder;
    const auto code = [&](const std::string& text) {
        const std::string file = folder.write("a.fil", "grammar rewriting\n" + text);
        const Ran ran = run_program("render " + file + " -o " + folder / "a.svg");
        return std::to_string(ran.status) + ran.out;
    };
    EXPECT_NE(code("axiom \"{100000 b}\"\nletter b star(1000, 10, 4)\nlimit memory 100MB\n").find("limit.memory"),
              std::string::npos);
    EXPECT_NE(code("axiom \"{10 ~(10)}aP+a\"\nview 1, 1\n").find("rewriting.too-far"), std::string::npos);
}

TEST(Rewriting, WhatIsTooMuchIsSaidWhereTheDocumentSaysIt) {
    const TestFolder folder;
    folder.write("empty.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\"/>");
    const auto said = [&](const std::string& command, const std::string& text, std::string_view part) {
        const std::string file = folder.write("a.fil", "grammar rewriting\n" + text);
        const Ran ran = run_program(command + " " + file + (command == "render" ? " -o " + folder / "a.svg" : ""));
        EXPECT_NE(ran.status, 0) << text;
        EXPECT_NE(ran.out.find(part), std::string::npos) << part << "\n" << ran.out;
    };
    const std::string limit = "axiom \"a\"\nlimit elements 100\niterations 20\n";
    said("derive", limit + "a -> \"aa\"\n", ":3:1: error: step 7 makes a word of 128 symbols");
    said("derive", limit + "a -> \"aa\" when t > 0\n", ":3:1: error: iteration 7 would make a word of ");
    said("derive", "axiom \"a\"\niterations 60\na -> \"aa\"\n", ":3:1: error: step 23 makes a word of ");
    said("check", limit + "a -> \"b{10 {11 c}}\"\n", ":5:6: error: this text has more symbols than the 100");
    said("check", limit + "a -> \"b\"\nb -> \"{1000000000000000000000000000000 {9e c}}\"\n",
         ":6:6: error: this text has");
    said("derive", limit + "register k 101\na -> \"{$k b}\"\n",
         ":6:6: error: a text with its repeats has more symbols");
    std::string letters;
    for (char32_t letter = 0x4E00; letter < 0x4E00 + 300; ++letter) unicode::append_utf8(letters, letter);
    said("derive", "iterations 1\naxiom \"" + letters + "\"\n", ":3:7: error: this grammar has more than 256");
    said("derive", "iterations 1\naxiom \"a\"\na -> \"" + letters + "\"\n",
         ":4:6: error: this grammar has more than 256");
    said("render", "axiom \"b\"\nletter b file(\"empty.svg\")\n", ":3:10: error: ");
}

TEST(Rewriting, WordsGrowInsideShapes) {
    const TestFolder folder;
    folder.write("a.fil", koch);
    const std::string host = folder.write("b.fil", "grammar tangle\nstart a = circle(50)\nembed(\"a.fil\") : a -> b\n");
    ASSERT_EQ(run_program("render " + host + " -o " + folder / "b.svg").status, 0);
    const std::string svg = folder.read("b.svg");
    EXPECT_NE(svg.find("stroke-linecap"), std::string::npos) << svg;
    EXPECT_EQ(run_program("render " + host + " --threads 2 -o " + folder / "c.svg").status, 0);
    EXPECT_EQ(folder.read("c.svg"), svg);
}

TEST(Rewriting, SettingsOfDrawingThatAreWrong) {
    const auto said = [](const std::string& text) {
        const TestFolder folder;
        const Ran ran = run_program("check " + folder.write("a.fil", "grammar rewriting\naxiom \"b\"\n" + text));
        return std::to_string(ran.status) + " " + ran.out;
    };
    const auto expect = [&](const std::string& text, std::string_view code) {
        const std::string out = said(text);
        EXPECT_EQ(out[0], '1') << text << out;
        EXPECT_NE(out.find(code), std::string::npos) << text << out;
    };
    EXPECT_EQ(said("letter b box(20, 10, 6)\nletter \"!\" wider\nview 30, -25\ncolours [#000, red]\n")[0], '0');
    expect("letter b widr\n", "did you mean 'wider'");
    EXPECT_EQ(said("letter b box(0.9, 0.2)\nletter c circle(0.3)\n")[0], '0');
    expect("letter b box(20)\n", "language.missing-argument");
    expect("letter b file(\"none.svg\")\n", "none.svg");
    expect("letter bb line\n", "rewriting.bad-letter");
    expect("letter \"=\" line\n", "'=' lets the symbol before it sleep");
    expect("angle 3 4\n", "rewriting.bad-setting");
    expect("angle 3px\n", "language.wrong-kind");
    expect("angle 3\nangle 4\n", "rewriting.repeated-setting");
    expect("step 0\n", "rewriting.out-of-range");
    expect("view 30, 100\n", "rewriting.out-of-range");
    expect("formula kk * 3\n", "did you mean 'k'");
    expect("colours []\n", "rewriting.bad-setting");
    expect("plus up\n", "rewriting.bad-word");
    expect("system A { axiom \"b\"; width 3 }\n", "rewriting.misplaced-setting");
    expect("system A { axiom \"b\"; angle 3px }\n", "language.wrong-kind");
    expect("style b when area > 3 { pen: 2 }\n", "area");
    const std::string wobble = said("style b { pen: 2; wobble: 0.2 }\n");
    EXPECT_EQ(wobble[0], '0');
    EXPECT_NE(wobble.find(":3:19: warning: what words draw does not waver [style.no-wobble]"), std::string::npos)
        << wobble;
}

}  // namespace
}  // namespace filigree
