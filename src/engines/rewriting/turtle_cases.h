// For tests alone: words for turtles from texts, and settings at random.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

#include "base/test_cases.h"
#include "engines/rewriting/turtle.h"

namespace filigree::rewriting {

struct TurtleWord {
    Alphabet alphabet;
    Word word;
};

// Letters for which there is no room are left out. `gaits`: of each letter, or none.
inline TurtleWord turtle_word(std::u32string_view letters, const std::vector<Gait>& gaits = {}) {
    TurtleWord made;
    for (std::size_t at = 0; at < letters.size(); ++at) {
        const Role role = letters[at] == U'=' ? Role::freeze : Role::ordinary;
        const std::uint32_t gait = gaits.empty() ? 0 : made.alphabet.number_of(gaits[at]);
        const auto symbol = made.alphabet.number_of({letters[at], role, 0, gait});
        if (symbol) made.word.symbols.push_back(*symbol);
    }
    return made;
}
inline TurtleWord turtle_word(std::string_view text) { return turtle_word(letters_of(text)); }

inline TurtleDrawing drawn(std::u32string_view letters, const TurtleSettings& settings = {}) {
    const TurtleWord of = turtle_word(letters);
    Result<TurtleDrawing> drawing = turtle_drawing(of.word, of.alphabet, settings);
    EXPECT_TRUE(drawing) << to_utf8(letters);
    return drawing ? *std::move(drawing) : TurtleDrawing{};
}
inline TurtleDrawing drawn(std::string_view text, const TurtleSettings& settings = {}) {
    return drawn(letters_of(text), settings);
}

inline void expect_near(Vec3 a, Vec3 b, double error = 1e-12) {
    EXPECT_NEAR(a.x, b.x, error);
    EXPECT_NEAR(a.y, b.y, error);
    EXPECT_NEAR(a.z, b.z, error);
}

// Signs that mean nothing by themselves, for all that letters may be made to do.
inline std::vector<LetterUse> signs_for_everything() {
    return {
        {U'{', Act::begin_polygon}, {U'}', Act::end_polygon}, {U'.', Act::corner},          {U'#', Act::wider},
        {U'!', Act::narrower},      {U',', Act::next_colour}, {U';', Act::previous_colour}, {U'o', Act::shape, "leaf"},
        {U'u', Act::shape, "cone"}, {U'e', Act::move},        {U'5', Act::next_colour}};
}

inline double random_angle(CaseRandom& random) {
    static constexpr std::array<double, 16> angles = {
        30, 90, 45, 25.7, 22.5, 360.0 / 7, 137.50776405003785, 1, 360.0 / 17, 0, -60, 400, 0.1, 90.0 / 7, 33.333, 180};
    return random.below(4) == 0 ? random.between(-400, 400) : angles[random.index(angles.size())];
}

inline TurtleSettings random_turtle_settings(CaseRandom& random) {
    TurtleSettings settings;
    settings.angle = random_angle(random);
    if (random.coin()) settings.angle2 = random_angle(random);
    if (random.coin()) settings.plus = PlusTurn::counterclockwise;
    settings.step = random.coin() ? 1 : random.between(-3, 8);
    settings.letters = signs_for_everything();
    return settings;
}

inline std::u32string random_letters(CaseRandom& random, std::u32string_view of, std::uint32_t most) {
    std::u32string letters;
    for (std::uint32_t left = random.below(most + 1); left > 0; --left) letters += of[random.index(of.size())];
    return letters;
}

// One of a few for each letter; mostly none.
inline std::vector<Gait> random_gaits(CaseRandom& random, std::size_t count, bool may_have_steps = true) {
    std::vector<Gait> known(1 + random.below(5));
    for (std::size_t g = 1; g < known.size(); ++g) {
        if (random.coin()) known[g].angle = random_angle(random);
        if (random.coin()) known[g].angle2 = random_angle(random);
        if (may_have_steps && random.coin()) known[g].step = random.between(0.1, 8);
    }
    std::vector<Gait> gaits(count);
    for (Gait& gait : gaits) gait = known[random.index(known.size())];
    return gaits;
}

}  // namespace filigree::rewriting
