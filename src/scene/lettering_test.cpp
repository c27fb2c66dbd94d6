#include "scene/lettering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "base/unicode.h"
#include "plane/verify.h"

namespace filigree {
namespace {

const std::string pangrams[] = {
    "The quick brown fox jumps over the lazy dog.",
    "SPHINX OF BLACK QUARTZ, JUDGE MY VOW!",
    "Pack my box with five dozen liquor jugs: 0123456789",
    "AVATAR Tattoo illicit vow, yaw (j) [f] {g} <k> |l| \\m/ __init__ 1.5..2.5 #7 ~ 3% @ $4 & \"5\" `6' ?",
};

std::string printable() {
    std::string text;
    for (char c = ' '; c <= '~'; ++c) text += c;
    return text;
}

double squared_distance(Vec p, Vec a, Vec b) {
    const Vec along = b - a;
    const double length2 = dot(along, along);
    const double s = length2 > 0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0;
    const Vec off = p - (a + s * along);
    return dot(off, off);
}

double distance(Vec p, const std::vector<Polyline>& strokes) {
    double least = std::numeric_limits<double>::infinity();
    for (const Polyline& stroke : strokes) {
        const std::size_t count = stroke.points.size();
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_last = i + 1 == count;
            if (is_last && !stroke.closed && count > 1) continue;
            least = std::min(least, squared_distance(p, stroke.points[i], stroke.points[is_last ? 0 : i + 1]));
        }
    }
    return std::sqrt(least);
}

bool is_covered(const Polygons& polygons, Vec p) {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        if (locate(polygons[i], snap(p)) >= 0) return true;
    }
    return false;
}

void expect_clean(const Polygons& polygons, const std::string& what) {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const auto flaw = find_flaw(polygons[i]);
        EXPECT_FALSE(flaw) << what << ": " << *flaw;
    }
    const auto overlap = find_overlap(polygons);
    EXPECT_FALSE(overlap) << what << ": " << *overlap;
}

std::string random_text(CaseRandom& random, std::uint32_t longest) {
    std::string text;
    for (std::uint32_t n = random.below(longest + 1); n > 0; --n) text += static_cast<char>(' ' + random.below(95));
    return text;
}

TEST(Lettering, EveryCharacterHasStrokesInItsBox) {
    const Vec at{100, 200};
    const double height = 20;
    std::vector<std::vector<Polyline>> all;
    for (const char c : printable() + '\x01') {
        const std::string text(1, c);
        const auto strokes = lettering_strokes(text, at, height);
        EXPECT_EQ(strokes.empty(), c == ' ') << text;
        const double end = at.x + lettering_width(text, height);
        EXPECT_GT(end, at.x + 4) << text;
        for (const Polyline& stroke : strokes) {
            EXPECT_FALSE(stroke.points.empty()) << text;
            for (const Vec p : stroke.points) {
                EXPECT_GT(p.x, at.x) << text;
                EXPECT_LT(p.x, end) << text;
                EXPECT_GE(p.y, at.y - lettering_ascent * height) << text;
                EXPECT_LE(p.y, at.y + lettering_descent * height) << text;
            }
        }
        EXPECT_EQ(std::count(all.begin(), all.end(), strokes), 0) << "another character looks like " << text;
        all.push_back(strokes);
    }
}

TEST(Lettering, CapitalsAndFiguresStandOnTheBaselineAndReachTheHeight) {
    for (const char c : std::string("ABCDEFGHIJKLMNOPRSTUVWXYZ0123456789")) {  // Q has a tail
        double top = 0, bottom = -100;
        for (const Polyline& stroke : lettering_strokes(std::string(1, c), {0, 0}, 20)) {
            for (const Vec p : stroke.points) {
                top = std::min(top, p.y);
                bottom = std::max(bottom, p.y);
            }
        }
        EXPECT_NEAR(top, -20, 0.05) << c;
        EXPECT_NEAR(bottom, 0, 0.05) << c;
    }
}

TEST(Lettering, WidthsAddUp) {
    for (std::uint64_t n = 0; n < case_count(300); ++n) {
        CaseRandom random(n);
        const std::string a = random_text(random, 20), b = random_text(random, 20);
        const double height = random.between(0.5, 100);
        const Vec at{random.between(-500, 500), random.between(-500, 500)};
        const double width = lettering_width(a, height);
        EXPECT_NEAR(lettering_width(a + b, height), width + lettering_width(b, height), 1e-9 * height);
        auto apart = lettering_strokes(a, at, height);
        for (const Polyline& stroke : lettering_strokes(b, at + Vec{width, 0}, height)) apart.push_back(stroke);
        const auto together = lettering_strokes(a + b, at, height);
        ASSERT_EQ(together.size(), apart.size());
        for (std::size_t s = 0; s < apart.size(); ++s) {
            EXPECT_EQ(together[s].closed, apart[s].closed);
            EXPECT_NEAR(length(together[s].points.front() - apart[s].points.front()), 0, 1e-9 * (height + 500));
            EXPECT_NEAR(length(together[s].points.back() - apart[s].points.back()), 0, 1e-9 * (height + 500));
        }
    }
}

TEST(Lettering, NeighboursKeepApart) {
    // A pen of a tenth of the height stays inside every character's own box, so no two neighbours can meet.
    for (const char c : printable()) {
        const std::string text(1, c);
        const Polygons polygons = lettering(text, {0, 0}, {20, 2});
        if (polygons.empty()) continue;
        EXPECT_GT(to_px(bounds(polygons).min).x, 0) << text;
        EXPECT_LT(to_px(bounds(polygons).max).x, lettering_width(text, 20)) << text;
    }
    for (const std::string& text : pangrams) {
        double x = 0;
        Box before;
        for (const char c : text) {
            const std::string one(1, c);
            const Box box = bounds(lettering(one, {x, 0}, {9, 0.9}));
            if (!is_empty(before) && !is_empty(box)) {
                EXPECT_LT(before.max.x, box.min.x) << text << " at " << c;
            }
            if (!is_empty(box)) before = box;
            x += lettering_width(one, 9);
        }
    }
}

TEST(Lettering, PolygonsAreClean) {
    for (const char c : printable() + '\x01') {
        for (const double pen : {0.05, 0.35, 1.0, 2.0, 5.0}) {
            const Polygons polygons = lettering(std::string(1, c), {0, 0}, {10, pen});
            EXPECT_EQ(polygons.empty(), c == ' ');
            expect_clean(polygons, std::string(1, c));
        }
    }
    for (const std::string& text : pangrams) expect_clean(lettering(text, {-40.25, 17}, {9, 0.8}), text);
    for (std::uint64_t n = 0; n < case_count(100); ++n) {
        CaseRandom random(n);
        const std::string text = random_text(random, 12);
        const LetteringStyle style{random.between(1, 40), random.between(0.05, 6)};
        expect_clean(lettering(text, {random.between(-90, 90), random.between(-90, 90)}, style), text);
    }
}

TEST(Lettering, PolygonsAreWhatARoundPenCovers) {
    for (std::uint64_t n = 0; n < case_count(200); ++n) {
        CaseRandom random(n);
        std::string text = random_text(random, 3);
        if (n < 95) text = static_cast<char>(' ' + n);
        const double height = 10, pen = random.between(0.1, 4);
        const auto strokes = lettering_strokes(text, {0, 0}, height);
        const Polygons polygons = lettering(text, {0, 0}, {height, pen});
        const double width = lettering_width(text, height);
        // Round ends and corners are polygons inside the circle, true to the same tolerance as the curves.
        const double tolerance = 0.003 * height;
        for (int k = 0; k < 200; ++k) {
            const Vec p{random.between(-2, width + 2), random.between(-14, 6)};
            const double d = distance(p, strokes);
            if (d < pen / 2 - tolerance) {
                EXPECT_TRUE(is_covered(polygons, p)) << text << " pen " << pen << " at " << p.x << ", " << p.y;
            } else if (d > pen / 2 + 1e-6) {
                EXPECT_FALSE(is_covered(polygons, p)) << text << " pen " << pen << " at " << p.x << ", " << p.y;
            }
        }
    }
}

TEST(Lettering, ADotIsRound) {
    const Polygons dot = lettering(".", {0, 0}, {10, 1});
    ASSERT_EQ(dot.size(), 1U);
    EXPECT_EQ(dot[0].ring_count(), 1U);
    EXPECT_NEAR(area(dot), elementary::pi * 0.7 * 0.7, 0.05);
}

TEST(Lettering, WhatTheAlphabetLacksIsABox) {
    const auto box = lettering_strokes("\x01", {0, 0}, 10);
    ASSERT_EQ(box.size(), 1U);
    EXPECT_TRUE(box[0].closed);
    EXPECT_EQ(box[0].points.size(), 4U);
    for (const char* text : {"\n", "\x7f", "\xc3\xa9", "\xe2\x80\xa6", "\xff", "\xc3"}) {
        EXPECT_EQ(lettering_strokes(text, {0, 0}, 10), box);
    }
    EXPECT_EQ(lettering_strokes("\xff\xff", {0, 0}, 10).size(), 2U);
}

TEST(Lettering, AnyBytesWillDo) {
    const double box = lettering_width("\x01", 10);
    for (std::uint64_t n = 0; n < case_count(300); ++n) {
        CaseRandom random(n);
        std::string bytes;
        for (std::uint32_t k = random.below(24); k > 0; --k) bytes += static_cast<char>(0x80 + random.below(128));
        std::size_t count = 0;
        for (std::size_t at = 0; at < bytes.size(); at += unicode::decode(bytes, at).length) ++count;
        EXPECT_NEAR(lettering_width(bytes, 10), static_cast<double>(count) * box, 1e-9);
        EXPECT_EQ(lettering(bytes, {3, 4}, {}).size(), count);
    }
}

TEST(Lettering, HasNothingWithoutAHeightOrAPen) {
    const double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (const double wrong : {0.0, -3.0, nan, infinite}) {
        EXPECT_TRUE(lettering_strokes("abc", {0, 0}, wrong).empty());
        EXPECT_TRUE(lettering("abc", {0, 0}, {wrong, 1}).empty());
        EXPECT_TRUE(lettering("abc", {0, 0}, {10, wrong}).empty());
    }
    EXPECT_TRUE(lettering_strokes("abc", {nan, 0}, 10).empty());
    EXPECT_TRUE(lettering_strokes("abc", {0, infinite}, 10).empty());
    EXPECT_TRUE(lettering("", {0, 0}, {}).empty());
    EXPECT_EQ(lettering_width("", 10), 0);
    expect_clean(lettering("abc", {0, 0}, {1e-3, 1e6}), "a pen far larger than the letters");
}

}  // namespace
}  // namespace filigree
