#include "engines/rewriting/verify.h"

#include <gtest/gtest.h>

#include <memory>

namespace filigree::rewriting {
namespace {

TEST(VerifyWords, WhatDoesNotHoldIsSaid) {
    Derivation derivation;
    const Symbol a = *derivation.alphabet.number_of({U'a', Role::ordinary, 0});
    const Symbol follower = *derivation.alphabet.number_of({U'\u00F1', Role::follower, 0});
    derivation.word.symbols = {a, Alphabet::freeze, follower};
    derivation.word.origins = {1};
    derivation.word.ages = {1, 2};
    EXPECT_TRUE(broken_invariants(derivation).empty());
    derivation.word.ages = {1};
    EXPECT_EQ(broken_invariants(derivation).size(), 1U);
    derivation.word.ages = {1, 0};
    EXPECT_EQ(broken_invariants(derivation).size(), 1U);
    derivation.word.ages = {};
    derivation.word.keys = {1, 2, 3};
    EXPECT_EQ(broken_invariants(derivation).size(), 1U);
    derivation.word.keys = {};
    derivation.word.symbols.insert(derivation.word.symbols.begin(), Alphabet::freeze);
    EXPECT_EQ(broken_invariants(derivation).size(), 1U);
    derivation.word.symbols = {a, 99};
    EXPECT_EQ(broken_invariants(derivation).size(), 2U);  // a symbol unknown, an ñ gone
}

TEST(VerifyWords, LinesHaveTwoPointsAndFacesAreClean) {
    Polygons geometry;
    geometry.points = {snap({0, 0}), snap({5, 0})};
    geometry.end_ring();
    geometry.end_polygon();
    Drawing drawing;
    drawing.geometry = {std::make_shared<const Polygons>(geometry)};
    drawing.styles = {{{}, Colour{}, 1, Corner::round, true}, {Colour{}, {}, 1, Corner::round, false}};
    drawing.shapes = {{0, 0, 0, {}}};
    EXPECT_TRUE(broken_invariants(drawing).empty());
    drawing.shapes[0].style = 1;
    EXPECT_EQ(broken_invariants(drawing).size(), 1U);
}

}  // namespace
}  // namespace filigree::rewriting
