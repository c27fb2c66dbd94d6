// Identity under edits: what keeps its key keeps all that was drawn for it (docs/language.md, "Identity").
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <utility>

#include "tests/random_edit.h"

namespace filigree {
namespace {

using State = std::shared_ptr<DocumentState>;

State grown_now(const std::string& rules) {
    SerialExecutor serial;
    State state = grown("grammar tangle\nseed 7\n" + rules, {}, serial);
    EXPECT_TRUE(state) << rules;
    return state;
}

// The shapes of all groups of a tag, by their keys: their corners as text.
using Shapes = std::map<std::uint64_t, std::string>;
Shapes shapes_of(const DocumentState& state, std::string_view tag) {
    Shapes shapes;
    for (const tangle::Group& group : state.run.tangle.groups) {
        if (state.checked.grammar->tags[group.tag] != tag) continue;
        for (const tangle::Shape& shape : group.shapes) {
            std::string text;
            const PolygonView polygon = state.run.tangle.polygon(shape);
            for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
                for (const Point& point : polygon.ring(r)) {
                    text += std::to_string(point.x) + "," + std::to_string(point.y) + " ";
                }
            }
            EXPECT_TRUE(shapes.emplace(shape.key.value, text).second) << "two shapes of one key";
        }
    }
    return shapes;
}

// How many shapes are there in both: their keys, and of those the ones of one outline.
struct Shared {
    std::size_t keys = 0, outlines = 0;
};
Shared shared(const Shapes& a, const Shapes& b) {
    Shared both;
    for (const auto& [key, outline] : a) {
        const auto found = b.find(key);
        if (found == b.end()) continue;
        ++both.keys;
        if (found->second == outline) ++both.outlines;
    }
    return both;
}

// Every choice that both have, by where and what it is for, has come out the same; how many there are.
std::size_t expect_same_choices(const DocumentState& a, const DocumentState& b) {
    std::map<std::string, NamedChoice> of_a;
    for (const NamedChoice& choice : named_choices(a)) of_a.emplace(choice.identity(), choice);
    std::size_t count = 0;
    for (const NamedChoice& choice : named_choices(b)) {
        const auto found = of_a.find(choice.identity());
        if (found == of_a.end()) continue;
        ++count;
        EXPECT_EQ(to_text(value_of(*choice.choices, choice.row)),
                  to_text(value_of(*found->second.choices, found->second.row)))
            << choice.path;
    }
    return count;
}

// A rectangle from x = 0 to `width` and y = 0 to 60, in px.
std::string rectangle(int width) {
    return "start a = rectangle(" + std::to_string(width) + "px, 60px, at: (" + std::to_string(width) +
           "px / 2, 30px))\n";
}

TEST(Identity, OneStripMoreAtOneSideLeavesTheOthersTheirKeys) {
    const std::string rules =
        "regular_split(10px, angle: 90, anchor: page) : a -> strip\nungroup() : strip -> one\n"
        "thin = outline(1px..4px) : one -> in, out\nruled = regular_split(2px..3px) : one -> line\n";
    const State before = grown_now(rectangle(80) + rules), after = grown_now(rectangle(90) + rules);
    const Shapes old = shapes_of(*before, "strip"), now = shapes_of(*after, "strip");
    EXPECT_EQ(old.size(), 8U);
    EXPECT_EQ(now.size(), 9U);
    EXPECT_EQ(shared(old, now).outlines, 8U);
    // So nothing is drawn anew for them: the rule, its arguments, and what grew in them.
    EXPECT_GE(expect_same_choices(*before, *after), 16U);
    for (const char* tag : {"in", "out", "line"}) {
        const Shapes inner = shapes_of(*before, tag);
        EXPECT_EQ(shared(inner, shapes_of(*after, tag)).outlines, inner.size()) << tag;
    }
}

TEST(Identity, OneStripMoreInADualSplitLeavesTheFieldsTheirKeys) {
    const std::string rules = "regular_split(10px, angle: 90, dual: yes, anchor: page) : a -> field\n";
    const State before = grown_now(rectangle(80) + rules), after = grown_now(rectangle(100) + rules);
    const Shapes old = shapes_of(*before, "field"), now = shapes_of(*after, "field");
    EXPECT_EQ(old.size(), 8U * 6U);
    EXPECT_EQ(now.size(), 10U * 6U);
    EXPECT_EQ(shared(old, now).outlines, old.size());
}

TEST(Identity, StripsAreCountedFromTheMiddle) {
    const std::string rules =
        "regular_split(10px, angle: 90) : a -> strip\nungroup() : strip -> one\n"
        "thin = outline(1px..4px) : one -> in, out\nruled = regular_split(2px..3px) : one -> line\n";
    const State before = grown_now("start a = rectangle(80px, 60px)\n" + rules);
    const State after = grown_now("start a = rectangle(100px, 60px)\n" + rules);
    const Shapes old = shapes_of(*before, "strip"), now = shapes_of(*after, "strip");
    EXPECT_EQ(old.size(), 8U);
    EXPECT_EQ(now.size(), 10U);
    EXPECT_EQ(shared(old, now).outlines, old.size());
    EXPECT_GE(expect_same_choices(*before, *after), 16U);
}

// The strips by their keys: column and row in the lattice of their split.
std::map<std::uint64_t, std::pair<int, int>> places_of_strips(const DocumentState& state) {
    std::map<std::uint64_t, std::pair<int, int>> places;
    for (const tangle::Group& group : state.run.tangle.groups) {
        if (state.checked.grammar->tags[group.tag] != "strip") continue;
        for (const tangle::Shape& shape : group.shapes) places[shape.key.value] = {shape.column, shape.row};
    }
    return places;
}

TEST(Identity, ADraggedSliderDrawsNothingAnewForStripsThatStay) {
    const auto document = [](const std::string& spacing, const std::string& way) {
        return rectangle(160) + "param gap = " + spacing + " in 5px..40px\nregular_split(gap, angle: 90" + way +
               ") : a -> strip\nungroup() : strip -> one\n"
               "thin = outline(1px..2px) : one -> in, out\nruled = regular_split(2px..3px, angle: 0..180) : one -> "
               "line\n"
               "dotted = stipple(4px..5px) : one weight 0.5 -> ground, dots\n";
    };
    for (const std::string way : {"", ", anchor: page", ", fit: yes", ", dual: yes"}) {
        State before = grown_now(document("20px", way));
        for (const char* spacing : {"19px", "17px", "21.5px", "12px"}) {
            const State after = grown_now(document(spacing, way));
            const Shapes old = shapes_of(*before, "strip"), now = shapes_of(*after, "strip");
            EXPECT_EQ(shared(old, now).keys, std::min(old.size(), now.size())) << spacing << way;
            const auto old_places = places_of_strips(*before);
            for (const auto& [key, place] : places_of_strips(*after)) {
                const auto found = old_places.find(key);
                EXPECT_TRUE(found == old_places.end() || found->second == place) << spacing << way;
            }
            EXPECT_GE(expect_same_choices(*before, *after), 2 * std::min(old.size(), now.size())) << spacing << way;
            before = after;
        }
    }
}

TEST(Identity, ABorderFarAwayMovesNothingThatIsPlaced) {
    const std::string rules = "place(6px, 10px, variation: 0.3) : a -> disc, rest\n";
    const State before = grown_now(rectangle(200) + rules), after = grown_now(rectangle(300) + rules);
    std::size_t far = 0;
    const Shapes now = shapes_of(*after, "disc");
    const tangle::Tangle& tangle = before->run.tangle;
    for (const tangle::Group& group : tangle.groups) {
        if (before->checked.grammar->tags[group.tag] != "disc") continue;
        for (const tangle::Shape& shape : group.shapes) {
            if (to_px(bounds(tangle.polygon(shape)).max).x > 120) continue;
            ++far;
            EXPECT_EQ(now.count(shape.key.value), 1U);
        }
    }
    EXPECT_GT(far, 40U);
    const Shared both = shared(shapes_of(*before, "disc"), now);
    EXPECT_GE(both.outlines, far);
}

TEST(Identity, ALabelHoldsARuleWhereverItStands) {
    const std::string head = rectangle(80) + "regular_split(10px, angle: 90) : a -> strip\nungroup() : strip -> one\n";
    const std::string thin = "thin = outline(1px..4px) : one -> in, out\n", dark = "dark = invert() : one -> in\n";
    const State before = grown_now(head + thin + dark), after = grown_now(head + dark + thin);
    EXPECT_EQ(shared(shapes_of(*before, "in"), shapes_of(*after, "in")).outlines, shapes_of(*before, "in").size());
    EXPECT_GE(expect_same_choices(*before, *after), 12U);
}

TEST(Identity, ARuleIsHeldByItsOperatorAndNumberAmongThoseOfItsTag) {
    const std::string head = rectangle(80) + "regular_split(10px, angle: 90) : a -> strip\nungroup() : strip -> one\n";
    const std::string thin = "outline(1px..4px) : one -> in, out\n", dark = "invert() : one -> in\n";
    const State before = grown_now(head + thin + dark);
    // Another operator's rules, and those of other tags, may come and go before it.
    for (const std::string& text : {head + dark + thin, head + "outline(3px) : in -> x, y\n" + thin + dark,
                                    head + thin + dark + "stipple() : one weight 0 -> dots\n"}) {
        const State after = grown_now(text);
        EXPECT_EQ(shared(shapes_of(*before, "out"), shapes_of(*after, "out")).outlines,
                  shapes_of(*before, "out").size());
        EXPECT_GE(expect_same_choices(*before, *after), 8U) << text;
    }
}

TEST(Identity, StartsAreHeldByTheirNumberAndWhatTheyAreCalledDoesNotMatter) {
    const std::string split = "regular_split(6px..12px, angle: 0..180) : ";
    const State before = grown_now(rectangle(80) + split + "a -> strip\n");
    const State renamed = grown_now("start leaf" + rectangle(80).substr(7) + split + "leaf -> vein\n");
    const Shapes strips = shapes_of(*before, "strip");
    EXPECT_EQ(shared(strips, shapes_of(*renamed, "vein")).outlines, strips.size());
    const State more = grown_now(rectangle(80) + "start b = circle(20px, at: (300px, 0px))\n" + split + "a -> strip\n");
    EXPECT_EQ(shared(strips, shapes_of(*more, "strip")).outlines, strips.size());
}

TEST(Identity, AnAppliedStepKeepsItsNameWhateverComesBeforeIt) {
    const std::string head = rectangle(80) + "regular_split(10px, angle: 90, anchor: page) : a -> strip\n";
    const std::string hand = "apply hand = outline(1px..4px) to a/regular_split/strip/3 -> in, out\n";
    const State before = grown_now(head + hand);
    const State after =
        grown_now(head + "apply invert() to a/regular_split/strip/5 -> dark\n" + hand + "set hand.join = round\n");
    EXPECT_GE(expect_same_choices(*before, *after), 1U);
    EXPECT_EQ(shared(shapes_of(*before, "in"), shapes_of(*after, "in")).keys, 1U);
    EXPECT_TRUE(after->run.unmatched.empty());
}

}  // namespace
}  // namespace filigree
