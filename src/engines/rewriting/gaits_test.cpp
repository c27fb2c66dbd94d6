// The angles and steps that subsystems have of their own: where the turtle comes to.
#include <gtest/gtest.h>

#include "base/elementary.h"
#include "engines/rewriting/derive.h"
#include "engines/rewriting/read_grammar.h"
#include "engines/rewriting/turtle.h"
#include "language/parse.h"

namespace filigree::rewriting {
namespace {

struct Walked {
    std::string word, code;
    std::vector<Vec3> points;  // where segments end
};

Walked walked(const std::string& text, int iterations, const TurtleSettings& settings = {}) {
    const Parsed parsed = parse_document("a.fil", "grammar rewriting\n" + text, {});
    EXPECT_TRUE(parsed.diagnostics.empty()) << text;
    const Result<Settings> said = read_settings(parsed.document);
    const Result<Grammar> grammar = read_grammar(*said, parsed.document);
    if (!grammar) return {{}, grammar.diagnostics().front().code, {}};
    DeriveOptions options;
    options.document = &parsed.document;
    options.globals = &said->globals;
    Result<Derivation> derivation = begin(*grammar, options);
    for (; iterations > 0; --iterations) EXPECT_FALSE(step(*derivation, *grammar, options, {}));
    const Result<TurtleDrawing> drawing = turtle_drawing(derivation->word, derivation->alphabet, settings);
    Walked walked{to_text(derivation->word, derivation->alphabet), {}, {}};
    for (const TurtleSegment& segment : drawing->segments) walked.points.push_back(segment.to);
    return walked;
}

void expect_points(const Walked& walked, const std::string& word, const std::vector<Vec3>& wanted) {
    EXPECT_EQ(walked.word, word);
    ASSERT_EQ(walked.points.size(), wanted.size()) << walked.word;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_NEAR(walked.points[i].x, wanted[i].x, 1e-12) << "point " << i;
        EXPECT_NEAR(walked.points[i].y, wanted[i].y, 1e-12) << "point " << i;
    }
}

TurtleSettings quarter_turns() {
    TurtleSettings settings;
    settings.angle = 90;
    settings.plus = PlusTurn::counterclockwise;
    return settings;
}

const double root3 = std::sqrt(3.0);

TEST(Gaits, AreThoseOfTheSystemThatPutASymbol) {
    // The step behind A goes on where A's turn of 30 degrees has led.
    expect_points(walked("axiom \"aAa\"\nsystem A { axiom \"+a\"; angle 30; step 2 }", 1, quarter_turns()), "a+aa",
                  {{1, 0, 0}, {1 + root3, 1, 0}, {1 + 1.5 * root3, 1.5, 0}});
    expect_points(walked("axiom \"aA+a\"\nsystem A { axiom \"+a\"; angle 30; step 2 }", 1, quarter_turns()), "a+a+a",
                  {{1, 0, 0}, {1 + root3, 1, 0}, {0.5 + root3, 1 + root3 / 2, 0}});
}

TEST(Gaits, GoOnWithWhatDescendsFromThem) {
    // Put at once, the letters are the main system's, and its rules rewrite them; in a system that grows, its own do.
    const std::vector<Vec3> wanted = {{2, 0, 0}, {2 + root3, 1, 0}, {3 + root3, 1 + root3, 0}};
    expect_points(walked("axiom \"A\"\na -> \"b+a\"\nsystem A { axiom \"a\"; angle 30; step 2 }", 3, quarter_turns()),
                  "b+b+a", wanted);
    expect_points(
        walked("axiom \"A\"\nsystem A { mode grow; axiom \"a\"; iterations 2; a -> \"b+a\"; angle 30; step 2 }", 3,
               quarter_turns()),
        "b+b+a", wanted);
}

TEST(Gaits, LeaveOpenWhatIsAroundThem) {
    // B says a step alone and turns as A does, in whose word it stands; C, beside A, as the document.
    const std::string systems =
        "system A { axiom \"+aB\"; iterations 1; angle 60; system B { axiom \"+a\"; step 3 } }\n"
        "system C { axiom \"+a\" }";
    expect_points(walked("axiom \"AC\"\n" + systems, 1, quarter_turns()), "+a+a+a",
                  {{0.5, root3 / 2, 0}, {-1, 2 * root3, 0}, {-1 - root3 / 2, 2 * root3 - 0.5, 0}});
    // Letters of the main system that stand in A's place put C within A.
    expect_points(walked("axiom \"A\"\nsystem A { axiom \"C\"; angle 60 }\nsystem C { axiom \"+a\" }", 2), "+a",
                  {{0.5, -root3 / 2, 0}});
}

TEST(Gaits, SecondAnglesAreThoseOfTheDocumentOrTheFirst) {
    TurtleSettings settings = quarter_turns();
    const std::string document = "axiom \"A\"\nsystem A { axiom \"<a\"; angle 60 }";
    expect_points(walked(document, 1, settings), "<a", {{0.5, root3 / 2, 0}});
    settings.angle2 = 180;
    expect_points(walked(document, 1, settings), "<a", {{-1, 0, 0}});
    expect_points(walked("axiom \"A\"\nsystem A { axiom \"<a+a\"; angle2 60 }", 1, settings), "<a+a",
                  {{0.5, root3 / 2, 0}, {0.5 - root3 / 2, root3 / 2 + 0.5, 0}});
}

TEST(Gaits, TellTheTurtleAlone) {
    EXPECT_EQ(walked("axiom \"qqA\"\nsystem A { axiom \"q\"; angle 7 }", 3).word, "qqqqqq")
        << "one run, which grows by one";
    EXPECT_EQ(walked("axiom \"ab\"\na < b -> \"c\"\na -> \"A\"\nsystem A { axiom \"a\"; angle 7 }", 3).word, "Ac");
    EXPECT_EQ(walked("axiom \"A\"\na -> \"bb\" when count == 2\nsystem A { axiom \"aa\"; step 7 }", 2).word, "bbbb");
}

TEST(Gaits, AreLengthsOrSoManyTimesTheDefault) {
    const auto step_of = [](const std::string& text) {
        const Parsed parsed = parse_document("a.fil", "grammar rewriting\naxiom \"A\"\n" + text, {});
        const Result<Settings> settings = read_settings(parsed.document);
        const Result<Grammar> grammar = read_grammar(*settings, parsed.document);
        return grammar ? *grammar->systems[1].gait.step : 0;
    };
    EXPECT_EQ(step_of("system A { axiom \"a\"; step 2 }"), 2);
    EXPECT_EQ(step_of("unit mm\nsystem A { axiom \"a\"; step 2 }"), 2);
    EXPECT_NEAR(step_of("unit mm\nsystem A { axiom \"a\"; step 2cm }"), 20, 1e-12);
    EXPECT_NEAR(step_of("unit mm\nstep 1\nsystem A { axiom \"a\"; step 2 }"), 2 * 96 / 25.4, 1e-12);
    EXPECT_EQ(step_of("param s = 4\nsystem A { axiom \"a\"; step s / 2 }"), 2);
}

TEST(Gaits, WrongOnesAreTold) {
    EXPECT_EQ(walked("axiom \"A\"\nsystem A { axiom \"a\"; angle 3px }", 0).code, "language.wrong-kind");
    EXPECT_EQ(walked("axiom \"A\"\nsystem A { axiom \"a\"; angle 3; angle 4 }", 0).code, "rewriting.repeated-setting");
    EXPECT_EQ(walked("axiom \"A\"\nsystem A { axiom \"a\"; step 0 }", 0).code, "rewriting.out-of-range");
    EXPECT_EQ(walked("axiom \"A\"\nsystem A { axiom \"a\"; angle2 3 4 }", 0).code, "rewriting.bad-setting");
}

}  // namespace
}  // namespace filigree::rewriting
