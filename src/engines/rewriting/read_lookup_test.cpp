#include "engines/rewriting/read_lookup.h"

#include <gtest/gtest.h>

#include "engines/rewriting/plain.h"
#include "engines/rewriting/read_grammar_test.h"
#include "engines/rewriting/turtle.h"
#include "formats/png_encode.h"

namespace filigree::rewriting {
namespace {

std::string png_of(std::uint32_t width, const std::vector<Colour>& pixels) {
    std::vector<std::uint32_t> words;
    for (const Colour c : pixels) {
        words.push_back(0xFF000000U | std::uint32_t{c.red} << 16 | std::uint32_t{c.green} << 8 | std::uint32_t{c.blue});
    }
    const Result<std::string> bytes =
        encode_png({width, static_cast<std::uint32_t>(pixels.size() / width),
                    reinterpret_cast<const unsigned char*>(words.data()), std::size_t{4} * width, false},
                   1);
    EXPECT_TRUE(bytes);
    return bytes ? *bytes : "";
}
Colour grey(std::uint8_t level) { return {level, level, level}; }

// A row of greys, four colours under them, and a table.
const Inputs& files() {
    static const Inputs all = {
        {"row.png", png_of(3, {grey(0), grey(128), grey(255)})},
        {"colours.png", png_of(2, {{200, 10, 30}, {20, 220, 40}, {60, 50, 240}, grey(7)})},
        {"heights.csv", "0, 1.5\n1.5000001, 9\n"},
        {"ragged.csv", "1,2\n3\n"},
        {"nan.csv", "1,nan\n"},
        {"empty.csv", ""},
        {"a.gif", "GIF89a..."},
    };
    return all;
}

constexpr const char* row_map = "image wall \"row.png\" over 0, 0, 3, 1\n";
constexpr const char* colour_map = "image wall \"colours.png\" over 0, 0, 2, 2\n";
constexpr const char* table_map = "data heights \"heights.csv\" over 0, 0, 2, 2\n";

// The words of iterations 0 to n, between blanks; or the code of what went wrong. An i does not step here.
std::string words(const std::string& text, int n, std::uint64_t* asked = nullptr) {
    const Read said = read(text, files());
    if (!said.problems.empty()) return said.problems.front().code;
    DeriveOptions options = options_of(said);
    options.positions = [&](const Derivation& at) {
        if (asked != nullptr) ++*asked;
        TurtleSettings turtle;
        turtle.letters = {{U'i', Act::nothing}};
        return symbol_positions(at.word, at.alphabet, turtle);
    };
    Result<Derivation> derivation = begin(said.grammar, options);
    if (!derivation) return derivation.diagnostics().front().code;
    EXPECT_TRUE(said.grammar.maps.empty() || !plain_substitution(*derivation, said.grammar));
    std::string all = to_text(derivation->word, derivation->alphabet);
    for (int i = 0; i < n; ++i) {
        if (const auto problem = step(*derivation, said.grammar, options, {})) return all + " " + problem->code;
        all += " " + to_text(derivation->word, derivation->alphabet);
    }
    return all;
}
std::string last(const std::string& text, int n = 1) {
    const std::string all = words(text, n);
    return all.substr(all.find_last_of(' ') + 1);
}

TEST(ReadLookup, TheWallOfThePaper) {
    const std::string rows = "i -> image wall L { 0..85 \"T+b\"; 86..170 \"b\"; 171..255 \"T---b\" }\n";
    EXPECT_EQ(words(row_map + rows + "axiom \"iaiaia\"", 1), "iaiaia T+babaT---ba");
    EXPECT_EQ(words(row_map + rows + "axiom \"iaqia=\"", 1), "iaqia= T+baia") << "an inverter is no such i";
    EXPECT_EQ(words("axiom \"iaia\"", 1), "iaia iaia") << "without a rule it stays";
}

TEST(ReadLookup, EveryChannel) {
    const auto found = [](const std::string& channel) {
        return last(std::string(colour_map) + "i -> image wall " + channel +
                    " { 0..20 \"p\"; 21..60 \"t\"; 61..150 \"u\"; 151..255 \"v\" }\naxiom \"[ifi][Yfii]\"");
    };
    // The lower row: 60 50 240, then 7 7 7; above it on the left 200 10 30, twice.
    EXPECT_EQ(found("R"), "[tfp][Yfvv]");
    EXPECT_EQ(found("G"), "[tfp][Yfpp]");
    EXPECT_EQ(found("B"), "[vfp][Yftt]");
    EXPECT_EQ(found("A"), "[vfv][Yfvv]");
    EXPECT_EQ(found("L"), "[ufp][Yftt]") << "66 and 7, and 52 above";
}

TEST(ReadLookup, RowsInTheirOrderWithBothEnds) {
    const auto at_grey_128 = [](const std::string& rows) {
        return last(row_map + ("b -> image wall L { " + rows + " }\naxiom \"fb\""));
    };
    EXPECT_EQ(at_grey_128("0..127 \"x\"; 128..200 \"y\"; 128 \"z\""), "fy");
    EXPECT_EQ(at_grey_128("0..128 \"x\"; 128..200 \"y\""), "fx");
    EXPECT_EQ(at_grey_128("0..127 \"x\"; 129..255 \"y\""), "fb") << "a gap: it stays";
    EXPECT_EQ(at_grey_128("128 \"\""), "f");
    EXPECT_EQ(at_grey_128("128 \"{$L v}\"").size(), 129U);
    EXPECT_EQ(at_grey_128("128 \"{(L / 32) v}{(R - G) v}{(A - 254) x}\""), "fvvvvx");
    EXPECT_EQ(last(std::string("let least = 100\n") + row_map +
                   "b -> image wall L { least..least + 28 \"x\" }\naxiom \"fb\""),
              "fx");
    EXPECT_EQ(at_grey_128("128 \"{$value v}\""), "language.unknown-name");
}

TEST(ReadLookup, Tables) {
    const std::string rule = "b -> data heights { -1..1.5 \"p\", 1.5..8 \"u\"\n 9 \"{$value v}\" }\n";
    EXPECT_EQ(last(table_map + rule + "axiom \"[bfb][Yf[b]Xfb]\""), "[ufvvvvvvvvv][Yf[p]Xfp]");
}

TEST(ReadLookup, BesideTheMap) {
    const std::string rule =
        "i -> image wall L { 0..85 \"d\"; 86..170 \"m\"; 171..255 \"l\" }\ni -> \"x\"\naxiom \"iFFiFFi[TXf]\"\n";
    EXPECT_EQ(last("image wall \"row.png\" over 0, 0, 3, 1\n" + rule), "dFFlFFl[TXf]");
    EXPECT_EQ(last("image wall \"row.png\" over 0, 0, 3, 1 outside wrap\n" + rule), "dFFlFFm[TXf]");
    EXPECT_EQ(last("image wall \"row.png\" over 0, 0, 3, 1 outside none\n" + rule), "dFFlFFx[TXf]")
        << "another rule may apply there";
    EXPECT_EQ(last("image wall \"row.png\" over -2, -5, 3, 10\n" + rule), "lFFlFFl[TXf]");
    EXPECT_EQ(last("image wall \"row.png\" over 0 -5 3 10\n" + rule), "rewriting.bad-setting") << "0 - 5";
    EXPECT_EQ(last("unit in\nimage wall \"row.png\" over 0, 0, 6px, 96px\n" + rule), "dFFmFFl[TXf]");
}

TEST(ReadLookup, ClausesAndOtherSuccessors) {
    const std::string map = row_map;
    EXPECT_EQ(last(map + "i -> image wall L { 0..255 \"x\" } when L > 100 && index > 2\ni -> \"y\"\naxiom \"ifififf\""),
              "yfyfxff");
    EXPECT_EQ(words(map + "i -> image wall L { 0..255 \"xi\" } loop 2\naxiom \"i\"", 3), "i xi xxi xxi");
    EXPECT_EQ(words(map + "register sum\ni -> image wall L { 128 \"x\" } { sum = sum + L }\nr@2 -> \"{(sum / 50) y}\"\n"
                          "axiom \"ififir\"",
                    2),
              "ififir ifxfir ifxfiyyyyy")
        << "a rule that has applied without a row assigns, too";
    EXPECT_EQ(last(map + "i -> image wall L { 0..255 \"x\" } * L, \"y\" * (255 - L)\naxiom \"i[ff]ffi\""), "y[ff]ffx");
    EXPECT_EQ(last(map + "J -> goto i@1\ni -> image wall L { 0..85 \"d\"; 86..170 \"m\" }\naxiom \"JfJfJ\""), "dfmfJ");
    EXPECT_EQ(last(map + table_map +
                   "i -> image wall L { 0..255 \"x\" } * L, data heights { 0..9 \"{$value y}{(R + 1) z}\" } * value\n"
                   "axiom \"if\""),
              "yzf")
        << "both maps are known everywhere";
}

TEST(ReadLookup, WithOtherSymbols) {
    const std::string map = row_map;
    EXPECT_EQ(words(map + "i -> image wall L { 0..255 \"x\" }\naxiom \"i=fi\"", 2), "i=fi ifx xfx");
    EXPECT_EQ(words(map + "~n -> \"y\"\nn -> image wall L { 128 \"\u00F1\" }\naxiom \"[n]f[n]\"", 2),
              "[n]f[n] [n]f[\u00F1\u00F1] [n]f[yyyy]")
        << "the second n puts two, and each follows it";
    const std::string rule = "i -> image wall L { 128 \"m\"; 255 \"l\" } }\naxiom \"fA\"";
    EXPECT_EQ(last(map + "system A { axiom \"fi\"; iterations 1; " + rule), "ffm")
        << "the word of a system that is put at once stands by itself";
    EXPECT_EQ(last(map + "system A { axiom \"fi\"; iterations 3; mode grow; " + rule, 2), "ffl")
        << "one that grows stands where it is";
}

TEST(ReadLookup, ExpressionsAreCheckedBeforehand) {
    const auto checked = [](const std::string& rule) {
        return words(std::string(row_map) + table_map + rule + "\naxiom \"i\"", 0);
    };
    EXPECT_EQ(checked("param L = 0\ni -> image wall L { 0..9 \"a\" } when L > 3"), "i") << "not the document's L";
    EXPECT_EQ(checked("i -> image wall L { 0..9 \"a\" } when value > 3"), "language.unknown-name");
    EXPECT_EQ(checked("i -> data heights { 0..9 \"{$L a}\" }"), "language.unknown-name");
    EXPECT_EQ(checked("i -> data heights { 0..9 \"{$value a}{(age) b}\" }"), "i");
    EXPECT_EQ(checked("i -> \"{$L a}\""), "language.unknown-name");
    EXPECT_EQ(last(std::string(row_map) + "i -> image wall L { 0..9 \"{(depth + index) a}\" }\naxiom \"[i]\""), "[aa]");
}

TEST(ReadLookup, PositionsAreAskedOnceAnIterationAndOnlyWhereNeeded) {
    std::uint64_t asked = 0;
    const std::string rules = std::string(row_map) + "i@3 -> image wall L { 0..255 \"xi\" }\na -> \"b\" when age > 0\n";
    words(rules + "axiom \"ififi\"", 2, &asked);
    EXPECT_EQ(asked, 0U);
    words(rules + "axiom \"ififi\"", 4, &asked);
    EXPECT_EQ(asked, 1U);
    words(rules + "axiom \"ff\"", 4, &asked);
    EXPECT_EQ(asked, 1U) << "no i";
    words(std::string(row_map) + "x < i -> image wall L { 0..255 \"xi\" }\naxiom \"ififi\"", 4, &asked);
    EXPECT_EQ(asked, 1U) << "nowhere behind an x";
}

// The code of the first problem, the text that it points to, and its first hint.
std::string problem(const std::string& text) {
    const Read said = read("axiom \"i\"\n" + text, files());
    if (said.problems.empty()) return "none";
    const Diagnostic& first = said.problems.front();
    return first.code + "@" + said.document.text().substr(first.span.begin, first.span.end - first.span.begin) +
           (first.hints.empty() ? "" : " (" + first.hints.front() + ")");
}

TEST(ReadLookup, WrongMaps) {
    const std::string usage =
        "rewriting.bad-setting@image (write it as in 'image wall \"photo.png\" over 0, 0, 400, 300')";
    EXPECT_EQ(problem("image wall \"row.png\""), usage);
    EXPECT_EQ(problem("image wall \"row.png\" over 0, 0, 3"), usage);
    EXPECT_EQ(problem("image wall \"row.png\" under 0, 0, 3, 1"), usage);
    EXPECT_EQ(problem("image wall \"row.png\" over 0, 0, 3, 1 beside wrap"), usage);
    EXPECT_EQ(problem("image \"row.png\" wall over 0, 0, 3, 1"), usage);
    EXPECT_EQ(problem("image wall \"row.png\" over 0, 0, 3, 1 outside wall"), "rewriting.bad-word@wall");
    EXPECT_EQ(problem("image wall \"row.png\" over 0, 0, 0, 1"),
              "rewriting.empty-map@0 (behind 'over' stand x, y, width and height)");
    EXPECT_EQ(problem("image wall \"row.png\" over 0, 0, 3, -1"),
              "rewriting.empty-map@-1 (behind 'over' stand x, y, width and height)");
    EXPECT_EQ(problem("image wall \"row.png\" over 0, 1e20, 3, 1"), "rewriting.out-of-range@1e20");
    EXPECT_EQ(problem("image wall \"row.png\" over 0, 30deg, 3, 1").substr(0, 9), "language.");
    EXPECT_EQ(problem("image wall \"a.gif\" over 0, 0, 3, 1"), "image.unknown-format@\"a.gif\" (convert it to PNG)");
    EXPECT_EQ(problem("image wall \"heights.csv\" over 0, 0, 3, 1"),
              "image.unknown-format@\"heights.csv\" (convert it to PNG)");
    EXPECT_EQ(problem("data wall \"ragged.csv\" over 0, 0, 3, 1"), "csv.ragged@\"ragged.csv\"");
    EXPECT_EQ(problem("data wall \"nan.csv\" over 0, 0, 3, 1"), "rewriting.no-number@\"nan.csv\"");
    EXPECT_EQ(problem("data wall \"empty.csv\" over 0, 0, 3, 1"), "csv.empty@\"empty.csv\"");
    EXPECT_EQ(problem("data wall \"row.png\" over 0, 0, 3, 1"), "csv.not-utf8@\"row.png\"");
    EXPECT_EQ(problem(std::string(row_map) + "data wall \"heights.csv\" over 0, 0, 3, 1"),
              "rewriting.doubled-name@wall");
    EXPECT_EQ(problem("system A { axiom \"a\"; " + std::string(row_map) + "}"), "rewriting.misplaced-setting@image");
    EXPECT_EQ(problem(row_map), "none");
}

TEST(ReadLookup, WrongRules) {
    const std::string maps = std::string(row_map) + table_map;
    const auto wrong = [&](const std::string& successor) { return problem(maps + "i -> " + successor); };
    EXPECT_EQ(wrong("image wall L { 0..255 \"a\" }"), "none");
    EXPECT_EQ(wrong("image well L { 0..255 \"a\" }"), "rewriting.unknown-map@well (did you mean 'wall'?)");
    EXPECT_EQ(wrong("data height { 0..255 \"a\" }"), "rewriting.unknown-map@height (did you mean 'heights'?)");
    EXPECT_EQ(problem("i -> data wall { 0..255 \"a\" }"),
              "rewriting.unknown-map@wall (declare it as in 'data heights \"heights.csv\" over 0, 0, 400, 300')");
    EXPECT_EQ(wrong("data wall { 0..255 \"a\" }"), "rewriting.wrong-map@wall (write 'image wall L { ... }')");
    EXPECT_EQ(wrong("image heights L { 0..255 \"a\" }"), "rewriting.wrong-map@heights (write 'data heights { ... }')");
    EXPECT_EQ(wrong("image wall H { 0..255 \"a\" }"),
              "rewriting.unknown-channel@H (channels are R, G, B, A and L, the brightness)");
    EXPECT_EQ(wrong("image wall L { 9..1 \"a\" }"), "rewriting.empty-range@9..1");
    EXPECT_EQ(wrong("image wall L { 1..k \"a\" }"), "language.unknown-name@k");
    EXPECT_EQ(wrong("image wall L { 1 \"{3 a\" }"), "rewriting.unmatched-brace@\"{3 a\"");
    // A map that is wrong is not said to be missing as well.
    const Read said = read("axiom \"i\"\nimage wall \"a.gif\" over 0, 0, 1, 1\ni -> image wall L { 1 \"a\" }", files());
    EXPECT_EQ(said.problems.size(), 1U);
}

}  // namespace
}  // namespace filigree::rewriting
