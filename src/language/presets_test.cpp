#include "language/presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "base/random.h"
#include "language/path_cases.h"

namespace filigree {
namespace {

// --- documents made of presets ----------------------------------------------------------------------------------

Statement set(std::string_view path) { return {{}, PresetStatement{false, path_of(path), nullptr, nullptr}}; }
Statement fallback(std::string_view path) { return {{}, PresetStatement{true, path_of(path), nullptr, nullptr}}; }
Statement keep(std::string_view path) { return {{}, KeepStatement{path_of(path)}}; }
Statement reroll(std::string_view path, std::uint32_t times = 1) {
    return {{}, RerollStatement{path_of(path), times, {}}};
}
Statement apply(const std::string& name, const std::vector<std::string>& targets) {
    ApplyStatement out;
    if (!name.empty()) out.name = Name{name, {}};
    for (const std::string& target : targets) out.targets.push_back(path_of(target));
    return {{}, out};
}

struct Written {
    explicit Written(std::vector<Statement> statements, const Presets& outer = {}) {
        document.statements = std::move(statements);
        presets = with_presets_of(outer, document, globals, 7);
    }
    Written(const Written&) = delete;
    Written& operator=(const Written&) = delete;

    Document document;
    Scope globals;
    Presets presets;
};

// --- walks ------------------------------------------------------------------------------------------------------

WalkSegment walk_segment(const PathSegment& segment) {
    const std::uint32_t number = segment.ordinals.empty() ? 0 : segment.ordinals.front();
    if (segment.kind == PathSegment::Kind::shapes) return {{}, 0, number};
    return {segment.name, number, 0};
}

PresetState state_at(const Presets& presets, std::string_view place) {
    PresetState state = begin_presets(presets, 0, nullptr);
    for (const PathSegment& segment : path_of(place).segments) state = advance(presets, state, walk_segment(segment));
    return state;
}

std::vector<std::uint32_t> accepted_at(const Presets& presets, std::string_view place) {
    return accepted(presets, state_at(presets, place));
}

using Indices = std::vector<std::uint32_t>;

TEST(Presets, MatchNamesNumbersAndGlobs) {
    const auto is_met = [](std::string_view path, std::string_view place) {
        const Written written({keep(path)});
        return accepted_at(written.presets, place) == Indices{0};
    };
    EXPECT_TRUE(is_met("a/outline/in", "a/outline/in"));
    EXPECT_FALSE(is_met("a/outline/in", "a/outline"));
    EXPECT_FALSE(is_met("a/outline", "a/outline/in"));
    EXPECT_FALSE(is_met("outline", "a/outline"));

    EXPECT_TRUE(is_met("a/quads", "a/quads[3]"));
    EXPECT_TRUE(is_met("a/quads[1,3]", "a/quads[3]"));
    EXPECT_FALSE(is_met("a/quads[1,3]", "a/quads[2]"));
    EXPECT_TRUE(is_met("a/quads[1]", "a/quads"));
    EXPECT_FALSE(is_met("a/quads[2]", "a/quads"));

    EXPECT_TRUE(is_met("a/2,5/outline", "a/5/outline"));
    EXPECT_FALSE(is_met("a/2,5/outline", "a/3/outline"));
    EXPECT_FALSE(is_met("a/2,5/outline", "a/outline"));

    EXPECT_TRUE(is_met("a/*/in", "a/outline/in"));
    EXPECT_TRUE(is_met("a/*/in", "a/2/in"));
    EXPECT_FALSE(is_met("a/*", "a"));
    EXPECT_FALSE(is_met("a/*", "a/b/c"));

    EXPECT_TRUE(is_met("a/**", "a"));
    EXPECT_TRUE(is_met("a/**", "a/2/b/c"));
    EXPECT_FALSE(is_met("a/**", "b/a"));
    EXPECT_TRUE(is_met("a/**/c", "a/c"));
    EXPECT_TRUE(is_met("a/**/c", "a/c/c/b/c"));
    EXPECT_FALSE(is_met("a/**/c", "a/c/c/b"));
    EXPECT_TRUE(is_met("**/b/*/c/**", "a/b/b/b/c"));
    EXPECT_FALSE(is_met("**/b/*/c/**", "a/b/c"));
}

TEST(Presets, GoByScopeThenLengthThenOrder) {
    const Written written({
        set("**.x"),                // 0: everything
        set("a/**.x"),              // 1: a branch
        set("**/circle.x"),         // 2: a module anywhere
        set("a/**/circle.x"),       // 3: a module within a branch
        set("a/*/c/circle.x"),      // 4: one segment left open
        set("a/b/c/circle.x"),      // 5: one call
        set("a/b/**.x"),            // 6: a longer branch
        set("**/c/circle.x"),       // 7: a longer module
        set("a/**/c/circle.x"),     // 8
        set("a/**/c[1]/circle.x"),  // 9: numbers make it longer
        set("a/b/c/circle.x"),      // 10: later
        set("*/*/**.x"),            // 11: everything too
        set("**/c/**.x"),           // 12: a branch
    });
    EXPECT_EQ(accepted_at(written.presets, "a/b/c/circle"), (Indices{10, 5, 4, 9, 8, 3, 7, 2, 6, 12, 1, 11, 0}));
}

TEST(Presets, OfOuterDocumentsGoFirst) {
    const Written outer({set("**.x"), set("a/b/**/c.x")});
    const Written inner({set("c.x"), set("**/b.x")}, outer.presets);
    const PresetState host = state_at(outer.presets, "a/b");
    const PresetState root = begin_presets(inner.presets, 2, host);
    EXPECT_EQ(accepted(inner.presets, root), Indices{0});
    EXPECT_EQ(accepted(inner.presets, advance(inner.presets, root, {"c"})), (Indices{1, 0, 2}));
    EXPECT_EQ(accepted(inner.presets, advance(inner.presets, root, {"b"})), (Indices{0, 3}));
    EXPECT_EQ(inner.presets.all[3].level, 1U);
    EXPECT_EQ(inner.presets.all[3].document, &inner.document);
    EXPECT_EQ(inner.presets.all[1].document, &outer.document);

    // A document without presets of its own goes on with the state of its host.
    const Written plain({}, outer.presets);
    EXPECT_EQ(begin_presets(plain.presets, 2, host), host);
    EXPECT_EQ(begin_presets(plain.presets, 2, nullptr), nullptr);
    const Written third({set("**.y")}, plain.presets);
    EXPECT_EQ(third.presets.all[2].level, 2U);
}

TEST(Presets, OfOneNameMeanDefinitions) {
    const Written written({set("gap"), fallback("let/gap"), set("gap.x"), keep("gap"), reroll("gap")});
    EXPECT_EQ(accepted_at(written.presets, "let/gap"), (Indices{1, 0}));
    EXPECT_EQ(accepted_at(written.presets, "gap"), (Indices{4, 3, 2}));
    const Presets copy = with_presets_of(written.presets, Document{}, written.globals, 0);
    EXPECT_EQ(to_text(*copy.all[0].path), "let/gap");
}

TEST(Presets, OfApplyAreOneATarget) {
    const Written written({apply("", {"a/2", "a/b"}), apply("", {"a/*"})});
    ASSERT_EQ(written.presets.all.size(), 3U);
    EXPECT_EQ(written.presets.all[1].kind, PresetKind::apply);
    EXPECT_EQ(written.presets.all[1].statement, 0U);
    EXPECT_EQ(accepted_at(written.presets, "a/2"), (Indices{0, 2}));
    EXPECT_EQ(accepted_at(written.presets, "a/b"), (Indices{1, 2}));
}

TEST(Presets, OfANamedApplyBeginWithItsName) {
    const std::vector<Statement> statements = {apply("fix", {"a"}), set("fix.x"),  set("fix/in/outline.x"),
                                               set("**/in.x"),      set("*/in.x"), set("other/in.x")};
    const Written written(statements);
    const PresetState before = state_at(written.presets, "a/b");
    const PresetState state = enter_named(written.presets, before, "fix");
    EXPECT_EQ(accepted(written.presets, state), Indices{1});
    EXPECT_EQ(accepted(written.presets, advance(written.presets, state, {"in"})), Indices{3});
    const PresetState below = advance(written.presets, advance(written.presets, state, {"in"}), {"outline"});
    EXPECT_EQ(accepted(written.presets, below), Indices{2});
    EXPECT_EQ(enter_named(written.presets, before, "other"), before);

    const Written inner({apply("fix", {"a"}), set("fix.x")}, written.presets);
    EXPECT_EQ(accepted(inner.presets, enter_named(inner.presets, nullptr, "fix")), (Indices{1, 7}));
    EXPECT_EQ(accepted(inner.presets, enter_named(inner.presets, nullptr, "fix", 1)), Indices{7});
    EXPECT_EQ(accepted(inner.presets, enter_named(inner.presets, nullptr, "fix", 0)), Indices{1});
}

TEST(Presets, TellWhatMayBeSkipped) {
    const Written plain({set("a/**.x"), keep("a/b[2].y~2"), apply("", {"a"})});
    EXPECT_TRUE(may_name(plain.presets, "x"));
    EXPECT_TRUE(may_name(plain.presets, "y"));
    EXPECT_FALSE(may_name(plain.presets, ""));
    EXPECT_FALSE(may_name(plain.presets, "a"));
    EXPECT_FALSE(has_shape_segments(plain.presets));
    EXPECT_FALSE(may_pick_shapes(plain.presets, state_at(plain.presets, "a")));
    EXPECT_FALSE(may_pick_shapes(plain.presets, nullptr));

    const Written with_shapes({set("a/b/2/c.x")}, plain.presets);
    EXPECT_TRUE(may_name(with_shapes.presets, "y"));
    EXPECT_TRUE(has_shape_segments(with_shapes.presets));
    EXPECT_FALSE(may_pick_shapes(with_shapes.presets, state_at(with_shapes.presets, "a")));
    EXPECT_TRUE(may_pick_shapes(with_shapes.presets, state_at(with_shapes.presets, "a/b")));
    const Written open({set("a/*.x")});
    EXPECT_TRUE(has_shape_segments(open.presets));
    EXPECT_TRUE(may_pick_shapes(open.presets, state_at(open.presets, "a")));
}

TEST(Presets, GiveSetsBeforeDefaults) {
    const Written written(
        {fallback("a/b.x"), set("**.x"), set("a/b.x~2"), set("a/b.y"), keep("a/b.x"), fallback("a/b.x")});
    std::vector<std::string> values;
    for (const Preset* preset : values_for(written.presets, accepted_at(written.presets, "a/b"), "x")) {
        values.push_back((preset->kind == PresetKind::set ? "set " : "default ") + to_text(*preset->path));
    }
    EXPECT_EQ(values, (std::vector<std::string>{"set a/b.x~2", "set **.x", "default a/b.x", "default a/b.x"}));
    EXPECT_TRUE(values_for(written.presets, {}, "x").empty());
}

// --- seeds ------------------------------------------------------------------------------------------------------

constexpr std::uint64_t document_seed = 7;

std::uint64_t rerolled(std::uint64_t seed, std::uint64_t times) { return fold(fold(seed, hash_text("reroll")), times); }

// The seed of a place, every node on the way having been passed.
std::uint64_t seed_of(const Presets& presets, std::string_view place, std::string_view parameter = "") {
    PresetState state = begin_presets(presets, 0, nullptr);
    NodeSeed seed{document_seed, nullptr};
    for (const PathSegment& segment : path_of(place).segments) {
        state = advance(presets, state, walk_segment(segment));
        seed = seed_at_node(presets, accepted(presets, state), seed);
    }
    if (parameter.empty()) return seed.value;
    return seed_of_parameter(presets, accepted(presets, state), parameter, seed);
}

TEST(Seeds, OfRerolledNodesAreFoldedWithTheTimes) {
    const Written written({reroll("a/b"), reroll("a/*", 3), set("a.x"), reroll("a/b/c.x", 2), reroll("a/b/c.x~2", 4)});
    const std::uint64_t b = rerolled(7, 4), c = rerolled(7, 3);
    EXPECT_EQ(seed_of(written.presets, "a"), 7U);
    EXPECT_EQ(seed_of(written.presets, "a/b"), b);
    EXPECT_EQ(seed_of(written.presets, "a/c"), c);
    EXPECT_EQ(seed_of(written.presets, "a/b/c"), b);
    EXPECT_EQ(seed_of(written.presets, "a/b/c", "x"), rerolled(b, 6));
    EXPECT_EQ(seed_of(written.presets, "a/b/c", "y"), b);
    EXPECT_NE(b, c);
}

TEST(Seeds, OfManyTimesDoNotWrapAround) {
    const Written written(std::vector<Statement>(5, reroll("a", 1000000000)));
    EXPECT_EQ(seed_of(written.presets, "a"), rerolled(7, 5000000000U));
}

TEST(Seeds, OfKeptNodesStayAsTheyWereWhenTheKeepWasSaid) {
    const Written before({keep("a/b"), reroll("a"), reroll("a/b/c")});
    EXPECT_EQ(seed_of(before.presets, "a"), rerolled(7, 1));
    EXPECT_EQ(seed_of(before.presets, "a/b"), 7U);
    EXPECT_EQ(seed_of(before.presets, "a/b/d"), 7U);
    EXPECT_EQ(seed_of(before.presets, "a/b/c"), rerolled(7, 1));
    // What was drawn again before is what is kept.
    const Written between({reroll("a"), reroll("a/b", 2), keep("a/b"), reroll("a", 5)});
    const Written without({reroll("a"), reroll("a/b", 2)});
    EXPECT_EQ(seed_of(between.presets, "a"), rerolled(7, 6));
    EXPECT_EQ(seed_of(between.presets, "a/b"), seed_of(without.presets, "a/b"));
    EXPECT_EQ(seed_of(between.presets, "a/b/c"), seed_of(without.presets, "a/b/c"));
}

TEST(Seeds, OfKeptBranchesStayAllTheWay) {
    const Written written({keep("a/b/**"), reroll("**")});
    EXPECT_EQ(seed_of(written.presets, "a"), rerolled(7, 1));
    EXPECT_EQ(seed_of(written.presets, "a/c"), rerolled(rerolled(7, 1), 1));
    EXPECT_EQ(seed_of(written.presets, "a/b"), 7U);
    EXPECT_EQ(seed_of(written.presets, "a/b/c/d"), 7U);
    const Written later({reroll("**"), keep("a/b/**"), reroll("a", 3)});
    const Written without({reroll("**")});
    EXPECT_EQ(seed_of(later.presets, "a/b"), seed_of(without.presets, "a/b"));
    EXPECT_EQ(seed_of(later.presets, "a/b/c/d"), seed_of(without.presets, "a/b/c/d"));
    EXPECT_NE(seed_of(later.presets, "a/c"), seed_of(without.presets, "a/c"));
}

TEST(Seeds, AreReRolledByTheNarrower) {
    // Both end at a/b. What lies above is kept off also where the narrower re-roll counts.
    const Written written({keep("**/b"), reroll("a"), reroll("a/b", 2), reroll("**", 5)});
    EXPECT_EQ(seed_of(written.presets, "a"), rerolled(7, 6));
    EXPECT_EQ(seed_of(written.presets, "a/b"), rerolled(7, 2));
    // Of one place kept and drawn again, the keep holds.
    EXPECT_EQ(seed_of(Written({reroll("a/b"), keep("a/b")}).presets, "a/b"), rerolled(7, 1));
    EXPECT_EQ(seed_of(Written({keep("a/b"), reroll("a/b")}).presets, "a/b"), 7U);
}

TEST(Seeds, OfKeptParametersStayToo) {
    const Written written(
        {reroll("a"), keep("a/b.x"), reroll("a/b"), reroll("a/b.y"), keep("**.z~2"), reroll("a/b.z")});
    const std::uint64_t a = rerolled(7, 1), b = rerolled(a, 1);
    EXPECT_EQ(seed_of(written.presets, "a/b"), b);
    EXPECT_EQ(seed_of(written.presets, "a/b", "x"), a);
    EXPECT_EQ(seed_of(written.presets, "a/b", "y"), rerolled(b, 1));
    EXPECT_EQ(seed_of(written.presets, "a/b", "z"), rerolled(b, 1));
    EXPECT_EQ(seed_of(written.presets, "a/c", "z"), a);
}

// --- against an oracle ------------------------------------------------------------------------------------------

bool is_matched(const PathSegment& wanted, const WalkSegment& found) {
    const auto has = [&](std::uint32_t number) {
        return std::find(wanted.ordinals.begin(), wanted.ordinals.end(), number) != wanted.ordinals.end();
    };
    if (wanted.kind == PathSegment::Kind::any) return true;
    if (wanted.kind == PathSegment::Kind::shapes) return found.shape != 0 && has(found.shape);
    return found.shape == 0 && wanted.name == found.name &&
           (wanted.ordinals.empty() || has(found.ordinal == 0 ? 1 : found.ordinal));
}

bool is_matched(std::span<const PathSegment> wanted, std::span<const WalkSegment> found) {
    if (wanted.empty()) return found.empty();
    if (wanted.front().kind == PathSegment::Kind::any_depth) {
        return is_matched(wanted.subspan(1), found) || (!found.empty() && is_matched(wanted, found.subspan(1)));
    }
    return !found.empty() && is_matched(wanted.front(), found.front()) &&
           is_matched(wanted.subspan(1), found.subspan(1));
}

// The less, the earlier it goes: the scope as a digit, then what makes a path longer, counted down.
std::string precedence(const Preset& preset, std::uint32_t index) {
    std::string kinds;
    int names = 0, numbered = 0;
    for (const PathSegment& segment : preset.path->segments) {
        kinds += segment.kind == PathSegment::Kind::any         ? '*'
                 : segment.kind == PathSegment::Kind::any_depth ? '/'
                                                                : 'n';
        names += kinds.back() == 'n' ? 1 : 0;
        numbered += kinds.back() == 'n' && !segment.ordinals.empty() ? 1 : 0;
    }
    char scope = kinds.find('*') == kinds.npos ? '0' : '1';
    if (const std::size_t deep = kinds.find('/'); deep != kinds.npos) {
        const std::string head = kinds.substr(0, deep), tail = kinds.substr(kinds.rfind('/'));
        if (names == 0) {
            scope = '5';
        } else if (tail.find('n') == tail.npos) {
            scope = '4';
        } else {
            scope = head.find('n') == head.npos ? '3' : '2';
        }
    }
    const auto down = [](int number) { return std::to_string(999 - number); };
    return std::to_string(preset.level) + scope + " " + down(names) + " " + down(numbered) + " " +
           std::to_string(999999 - index);
}

struct Oracle {
    Presets presets;
    // Where a level's paths, or those that begin with the name of an `apply`, began: segments of the walk before it.
    struct Beginning {
        std::uint32_t level = 0;
        std::size_t at = 0;
        bool is_named = false;
    };
    std::vector<Beginning> beginnings;
    std::vector<WalkSegment> walked;

    Indices accepted_here() const {
        Indices out;
        for (std::uint32_t i = 0; i < presets.all.size(); ++i) {
            const Preset& preset = presets.all[i];
            const bool is_accepted = std::any_of(beginnings.begin(), beginnings.end(), [&](const Beginning& beginning) {
                std::vector<WalkSegment> walk(walked.begin() + static_cast<std::ptrdiff_t>(beginning.at), walked.end());
                if (beginning.is_named) {
                    if (preset.path->segments.front().name.empty()) return false;
                    walk.insert(walk.begin(), WalkSegment{"fix"});
                }
                return beginning.level == preset.level && is_matched(preset.path->segments, walk);
            });
            if (is_accepted) out.push_back(i);
        }
        std::sort(out.begin(), out.end(), [&](std::uint32_t a, std::uint32_t b) {
            return precedence(presets.all[a], a) < precedence(presets.all[b], b);
        });
        return out;
    }
};

const std::vector<std::string> walk_names = {"a", "b", "fix"};

std::vector<Statement> random_presets(CaseRandom& random) {
    std::vector<Statement> out;
    const std::uint32_t count = random.below(9);
    for (std::uint32_t i = 0; i < count; ++i) {
        out.push_back({{}, KeepStatement{random_path(random, walk_names, 5)}});
    }
    if (random.coin()) out.push_back(apply("fix", {"a"}));
    return out;
}

bool has_apply(const Presets& presets, std::uint32_t level) {
    return std::any_of(presets.all.begin(), presets.all.end(),
                       [&](const Preset& preset) { return preset.level == level && preset.kind == PresetKind::apply; });
}

class RandomWalk {
public:
    RandomWalk(std::uint64_t seed, CaseRandom& random) : seed_(seed), random_(random) {}

    std::size_t met = 0, shared = 0;

    // All places below one, in which the presets are in `state`.
    void visit(const Oracle& oracle, const PresetState& state, std::uint32_t depth) {
        check(oracle, state);
        for (std::uint32_t child = random_.below(3); depth > 0 && child > 0; --child) {
            Oracle below = oracle;
            WalkSegment segment{walk_names[random_.index(walk_names.size())], random_.below(4), 0};
            if (random_.below(4) == 0) segment = {{}, 0, random_.whole(1U, 3U)};
            below.walked.push_back(segment);
            PresetState next = advance(oracle.presets, state, segment);
            check_sharing(state, next);
            if (random_.below(6) == 0) {
                const PresetState before = next;
                next = enter_named(oracle.presets, before, "fix");
                check_sharing(before, next);
                for (std::uint32_t level = 0; level < oracle.presets.trees.size(); ++level) {
                    if (!has_apply(oracle.presets, level)) continue;
                    below.beginnings.push_back({level, below.walked.size(), true});
                }
            }
            visit(below, next, depth - 1);
        }
        if (depth > 0 && oracle.presets.trees.size() < 3 && random_.below(6) == 0) {
            const Written inner(random_presets(random_), oracle.presets);
            Oracle below = oracle;
            below.presets = inner.presets;
            below.beginnings.push_back({static_cast<std::uint32_t>(oracle.presets.trees.size()), oracle.walked.size()});
            visit(below, begin_presets(inner.presets, static_cast<std::uint32_t>(oracle.presets.all.size()), state),
                  depth - 1);
        }
    }

private:
    void check(const Oracle& oracle, const PresetState& state) {
        const Indices found = accepted(oracle.presets, state);
        ASSERT_EQ(found, oracle.accepted_here()) << "seed " << seed_;
        met += found.size();
        if (!state) return;
        ASSERT_FALSE(state->empty()) << "seed " << seed_;
        ASSERT_TRUE(std::is_sorted(state->begin(), state->end(), std::less_equal<>())) << "seed " << seed_;
        // Whoever asks this first misses no preset of a single shape.
        for (const std::uint32_t shape : {1U, 2U, 3U}) {
            const PresetState at_shape = advance(oracle.presets, state, {{}, 0, shape});
            if (may_pick_shapes(oracle.presets, state) || !at_shape) continue;
            ASSERT_TRUE(std::includes(state->begin(), state->end(), at_shape->begin(), at_shape->end())) << seed_;
        }
    }

    void check_sharing(const PresetState& before, const PresetState& after) {
        if (!before || !after || *before != *after) return;
        ASSERT_EQ(before, after) << "seed " << seed_;
        ++shared;
    }

    std::uint64_t seed_;
    CaseRandom& random_;
};

TEST(PresetsAtRandom, AreAcceptedWhereTheirPathsEnd) {
    const std::uint64_t cases = case_count();
    std::size_t met = 0, shared = 0;
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        CaseRandom random(seed);
        const Written written(random_presets(random));
        const Oracle oracle{written.presets, {{0, 0}}, {}};
        RandomWalk walk(seed, random);
        walk.visit(oracle, begin_presets(written.presets, 0, nullptr), 7);
        if (HasFatalFailure()) return;
        met += walk.met;
        shared += walk.shared;
    }
    EXPECT_GT(met, cases * 3);
    EXPECT_GT(shared, cases / 4);
}

TEST(PresetsAtRandom, GoInOneOrder) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const Written written(random_presets(random));
        std::vector<Preset> presets = written.presets.all;
        std::sort(presets.begin(), presets.end(), [](const Preset& a, const Preset& b) { return a.rank < b.rank; });
        for (std::uint32_t i = 0; i < presets.size(); ++i) {
            ASSERT_EQ(presets[i].rank, i) << "seed " << seed;
            if (i == 0) continue;
            ASSERT_LT(precedence(presets[i - 1], presets[i - 1].statement),
                      precedence(presets[i], presets[i].statement))
                << "seed " << seed;
        }
    }
}

// --- many -------------------------------------------------------------------------------------------------------

// A tree with `width` groups below the only step of each group, down to `depth`.
std::size_t items_of_tree(const Presets& presets, const PresetState& state, std::uint32_t width, std::uint32_t depth,
                          std::size_t& met) {
    met += accepted(presets, state).size();
    std::size_t items = state ? state->size() : 0;
    if (depth == 0) return items;
    const PresetState step = advance(presets, state, {"split"});
    for (std::uint32_t group = 1; group <= width; ++group) {
        items += items_of_tree(presets, advance(presets, step, {"quads", group, 0}), width, depth - 1, met);
    }
    return items;
}

void add_paths(std::vector<Statement>& statements, const std::string& path, std::uint32_t width, std::uint32_t depth) {
    statements.push_back(set(path + ".x"));
    for (std::uint32_t group = 1; depth > 0 && group <= width; ++group) {
        add_paths(statements, path + "/split/quads[" + std::to_string(group) + "]", width, depth - 1);
    }
}

// Each node is one item of its state, however many presets there are: in a wide tree as in a deep one.
TEST(ManyPresets, StayCheap) {
    struct Tree {
        std::uint32_t width = 0, depth = 0;
    };
    for (const Tree tree : {Tree{10000, 1}, Tree{100, 2}, Tree{10, 4}, Tree{2, 12}, Tree{1, 300}}) {
        std::vector<Statement> statements;
        add_paths(statements, "a", tree.width, tree.depth);
        const std::size_t nodes = statements.size();
        const Written written(std::move(statements));
        const PresetState root = begin_presets(written.presets, 0, nullptr);
        EXPECT_EQ(root->size(), 1U);
        std::size_t met = 0;
        const PresetState start = advance(written.presets, root, {"a"});
        EXPECT_EQ(items_of_tree(written.presets, start, tree.width, tree.depth, met), nodes);
        EXPECT_EQ(met, nodes);
    }
}

}  // namespace
}  // namespace filigree
