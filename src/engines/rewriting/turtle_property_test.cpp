// Laws of the turtle, and another turtle of a few lines that multiplies matrices, on random words.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>

#include "base/elementary.h"
#include "engines/rewriting/turtle_cases.h"
#include "engines/rewriting/turtle_flat.h"
#include "engines/rewriting/word_cases.h"

namespace filigree::rewriting {
namespace {

constexpr std::u32string_view everything = U"FFFaab=++--<>?TPDXYZQ[[]]#!,;o{}.f";

bool are_near(Vec3 a, Vec3 b, double error) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) <= error; }

// Columns: heading, left, up.
using Matrix = std::array<std::array<double, 3>, 3>;

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
        }
    }
    return c;
}

struct SimpleTurtle {
    struct State {
        Matrix frame{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        Vec3 position;
        char32_t axis = U'T';
        double scale = 1;
    };
    State state;
    std::vector<State> outer;
    std::vector<std::array<Vec3, 2>> segments;

    void turn(double degrees) {
        const double c = std::cos(degrees * elementary::pi / 180), s = std::sin(degrees * elementary::pi / 180);
        const Matrix by = state.axis == U'T'   ? Matrix{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}
                          : state.axis == U'P' ? Matrix{{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}}
                                               : Matrix{{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
        state.frame = product(state.frame, by);
    }

    // `gaits`: of each letter.
    void draw(std::u32string_view letters, const std::vector<Gait>& gaits, const TurtleSettings& settings) {
        const double sign = settings.plus == PlusTurn::clockwise ? -1 : 1;
        std::size_t asked = 0;
        for (std::size_t at = 0; at < letters.size(); ++at) {
            const Gait& gait = gaits[at];
            const double angle = gait.angle ? *gait.angle : settings.angle;
            const double angle2 = gait.angle2 ? *gait.angle2 : settings.angle2 ? *settings.angle2 : angle;
            switch (const char32_t letter = letters[at]) {
                case U'T':
                case U'P':
                case U'D':
                    state.axis = letter;
                    break;
                case U'X':
                    state.frame = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
                    break;
                case U'Y':
                    state.frame = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
                    break;
                case U'Z':
                    state.frame = {{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}};
                    break;
                case U'+':
                    turn(sign * angle);
                    break;
                case U'-':
                    turn(-sign * angle);
                    break;
                case U'<':
                    turn(sign * angle2);
                    break;
                case U'>':
                    turn(-sign * angle2);
                    break;
                case U'?':
                    turn(sign * settings.angles[asked++ % settings.angles.size()]);
                    break;
                case U'[':
                    outer.push_back(state);
                    break;
                case U'h':
                    state.scale *= 0.5;
                    break;
                case U']':
                    if (outer.empty()) break;
                    state = outer.back();
                    outer.pop_back();
                    break;
                case U'F':
                case U'f':
                case U'a': {
                    const Vec3 from = state.position;
                    const double step = (gait.step ? *gait.step : settings.step) * state.scale;
                    state.position = {from.x + step * state.frame[0][0], from.y + step * state.frame[1][0],
                                      from.z + step * state.frame[2][0]};
                    if (letter != U'f') segments.push_back({from, state.position});
                    break;
                }
                default:
                    break;
            }
        }
    }
};

TEST(TurtleProperty, DrawsWhatASimpleTurtleDraws) {
    for (std::uint64_t i = first_seed(); i < first_seed() + case_count(); ++i) {
        SCOPED_TRACE(i);
        CaseRandom random(i);
        TurtleSettings settings = random_turtle_settings(random);
        settings.angles = {random_angle(random), random_angle(random), random_angle(random)};
        std::u32string letters = random_letters(random, U"FFFFaaf+++---<>?=TTPPDXYZ[[]]hQ", 200);
        std::vector<Gait> gaits = random_gaits(random, letters.size());
        SimpleTurtle simple;
        simple.draw(letters, gaits, settings);
        for (std::size_t at; (at = letters.find(U'h')) != letters.npos;) {
            letters.replace(at, 1, U"~(0.5)");
            gaits.insert(gaits.begin() + static_cast<std::ptrdiff_t>(at), 5, gaits[at]);
        }
        const TurtleWord of = turtle_word(letters, gaits);
        const Result<TurtleDrawing> told = turtle_drawing(of.word, of.alphabet, settings);
        ASSERT_TRUE(told);
        const TurtleDrawing& drawing = *told;
        ASSERT_EQ(drawing.segments.size(), simple.segments.size());
        for (std::size_t k = 0; k < simple.segments.size(); ++k) {
            ASSERT_TRUE(are_near(drawing.segments[k].from, simple.segments[k][0], 1e-9)) << "segment " << k;
            ASSERT_TRUE(are_near(drawing.segments[k].to, simple.segments[k][1], 1e-9)) << "segment " << k;
        }
        ASSERT_TRUE(are_near(drawing.end, simple.state.position, 1e-9));
        const auto& frame = simple.state.frame;
        EXPECT_TRUE(are_near(drawing.end_frame.heading, {frame[0][0], frame[1][0], frame[2][0]}, 1e-11));
        EXPECT_TRUE(are_near(drawing.end_frame.up, {frame[0][2], frame[1][2], frame[2][2]}, 1e-11));
    }
}

TEST(TurtleProperty, FramesStayOrthonormal) {
    for (std::uint64_t i = first_seed(); i < first_seed() + case_count(100); ++i) {
        CaseRandom random(i);
        const TurtleSettings settings = random_turtle_settings(random);
        const Frame frame = drawn(random_letters(random, U"+-<>TPDF", 5000), settings).end_frame;
        EXPECT_NEAR(dot(frame.heading, frame.heading), 1, 2e-15);
        EXPECT_NEAR(dot(frame.left, frame.left), 1, 2e-15);
        EXPECT_NEAR(dot(frame.up, frame.up), 1, 2e-15);
        EXPECT_NEAR(dot(frame.heading, frame.left), 0, 2e-15);
        EXPECT_NEAR(dot(frame.heading, frame.up), 0, 2e-15);
        EXPECT_NEAR(dot(frame.left, frame.up), 0, 2e-15);
    }
}

TEST(TurtleProperty, BracketsRestoreEverything) {
    for (std::uint64_t i = first_seed(); i < first_seed() + case_count(); ++i) {
        SCOPED_TRACE(i);
        CaseRandom random(i);
        TurtleSettings settings = random_turtle_settings(random);
        settings.angles = {random_angle(random)};
        const std::u32string before = random_letters(random, U"FFa++-<?TPDXYZ[#!,;o", 40);
        std::u32string branch = random_letters(random, U"FFaf++-<>?TPDXYZ[]#!,;o", 60);
        const BracketShape shape = bracket_shape(branch);
        branch = std::u32string(shape.closing, U'[') + branch + std::u32string(shape.opening, U']');
        const std::u32string after = random_letters(random, U"FFa++-<?TPDXYZ[]#!,;o", 40);
        const TurtleDrawing without = drawn(before + after, settings);
        const TurtleDrawing with = drawn(before + U"[" + branch + U"]" + after, settings);
        EXPECT_EQ(with.end, without.end);
        EXPECT_EQ(with.end_frame, without.end_frame);
        EXPECT_EQ(with.stray_closings, without.stray_closings);
        EXPECT_EQ(with.unclosed, without.unclosed);
        const std::size_t more = with.segments.size() - without.segments.size();
        for (std::size_t k = 0; k < without.segments.size(); ++k) {
            const TurtleSegment& wanted = without.segments[k];
            const bool is_before = wanted.symbol < before.size();
            const TurtleSegment& segment = with.segments[is_before ? k : k + more];
            ASSERT_EQ(segment.to, wanted.to) << "segment " << k;
            ASSERT_EQ(segment.frame, wanted.frame);
            ASSERT_EQ(segment.width, wanted.width);
            ASSERT_EQ(segment.colour, wanted.colour);
            ASSERT_EQ(segment.symbol, wanted.symbol + (is_before ? 0 : branch.size() + 2));
        }
    }
}

// Of turns about up and heading; those about left are their own mirror images.
TEST(TurtleProperty, MirroredSignsMirrorTheDrawing) {
    for (std::uint64_t i = first_seed(); i < first_seed() + case_count(); ++i) {
        SCOPED_TRACE(i);
        CaseRandom random(i);
        const TurtleSettings settings = random_turtle_settings(random);
        std::u32string word, mirrored;
        const bool is_flat = random.coin();
        for (std::uint32_t left = random.below(60); left > 0; --left) {
            const std::u32string axis(1, is_flat ? U'T' : U"TPD"[random.below(3)]);
            std::u32string turns = random_letters(random, U"++--<>", 5);
            const std::u32string steps = random_letters(random, is_flat ? U"FFafX[]" : U"FFafXZ[]", 5);
            word += axis + turns + steps;
            if (axis != U"P") {
                for (char32_t& sign : turns) {
                    sign = sign == U'+' ? U'-' : sign == U'-' ? U'+' : sign == U'<' ? U'>' : U'<';
                }
            }
            mirrored += axis + turns + steps;
        }
        const TurtleDrawing drawing = drawn(word, settings), image = drawn(mirrored, settings);
        ASSERT_EQ(drawing.segments.size(), image.segments.size());
        for (std::size_t k = 0; k < image.segments.size(); ++k) {
            const Vec3 to = drawing.segments[k].to;
            ASSERT_EQ(image.segments[k].to, (Vec3{to.x, -to.y, to.z})) << "segment " << k;
        }
        TurtleSettings other = settings;
        other.plus = settings.plus == PlusTurn::clockwise ? PlusTurn::counterclockwise : PlusTurn::clockwise;
        if (is_flat) {
            EXPECT_EQ(drawn(word, other).end, image.end);
        }
    }
}

TEST(TurtleProperty, PositionsAreThoseOfTheDrawing) {
    for (std::uint64_t i = first_seed(); i < first_seed() + case_count(); ++i) {
        CaseRandom random(i);
        TurtleSettings settings = random_turtle_settings(random);
        settings.angles = {random_angle(random)};
        std::u32string letters = random_letters(random, everything, 200);
        std::erase(letters, U'=');
        const TurtleWord of = turtle_word(letters);
        const Result<std::vector<Vec>> positions = symbol_positions(of.word, of.alphabet, settings);
        ASSERT_TRUE(positions);
        ASSERT_EQ(positions->size(), of.word.size());
        for (const TurtleSegment& segment : drawn(letters, settings).segments) {
            ASSERT_EQ((*positions)[segment.symbol], (Vec{segment.from.x, segment.from.y}));
        }
    }
}

// Words of anything with letters that do anything: nothing breaks, and what was counted before is what comes.
TEST(TurtleProperty, GarbageIsDrawn) {
    constexpr Act last = Act::end_polygon;
    for (std::uint64_t i = first_seed(); i < first_seed() + case_count(); ++i) {
        SCOPED_TRACE(i);
        CaseRandom random(i);
        TurtleSettings settings = random_turtle_settings(random);
        settings.angles = {random_angle(random), random_angle(random)};
        std::u32string letters = random.coin() ? random_garbage(random, 200) : random_letters(random, everything, 200);
        for (std::uint32_t left = random.below(6); left > 0; --left) {
            settings.letters.push_back({everything[random.index(everything.size())],
                                        static_cast<Act>(random.whole(0, static_cast<int>(last)))});
        }
        const TurtleWord of = turtle_word(letters);
        const Result<TurtleDrawing> drawing = turtle_drawing(of.word, of.alphabet, settings);
        ASSERT_TRUE(drawing);
        ASSERT_TRUE(symbol_positions(of.word, of.alphabet, settings));
        ASSERT_TRUE(flat_drawing(of.word.symbols, of.alphabet, settings));
        std::uint64_t corners = 0;
        for (const TurtlePolygon& polygon : drawing->polygons) {
            ASSERT_GE(polygon.count, 3U);
            ASSERT_EQ(polygon.first, corners);
            corners += polygon.count;
        }
        ASSERT_EQ(drawing->corners.size(), corners);
        for (const TurtleSegment& segment : drawing->segments) ASSERT_LT(segment.symbol, of.word.size());
        for (const TurtleShape& shape : drawing->shapes) ASSERT_LT(shape.name, drawing->shape_names.size());
    }
}

TEST(TurtleProperty, BracketsAreCountedAsInWords) {
    for (std::uint64_t i = first_seed(); i < first_seed() + case_count(); ++i) {
        CaseRandom random(i);
        std::u32string letters = random_garbage(random, 200);
        const BracketShape shape = bracket_shape(letters);
        const TurtleDrawing drawing = drawn(letters, {});
        EXPECT_EQ(drawing.stray_closings, shape.closing);
        EXPECT_EQ(drawing.unclosed, shape.opening);
    }
}

}  // namespace
}  // namespace filigree::rewriting
