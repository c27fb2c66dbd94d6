// Laws of recorded choices and of what documents say of them, over random documents: an edit changes what it names and
// nothing else.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "base/thread_pool.h"
#include "formats/svg_write.h"
#include "tests/program.h"
#include "tests/random_document.h"
#include "tests/random_edit.h"
#include "tests/same_tangle.h"

namespace filigree {
namespace {

constexpr double scale = 2;  // fewer and larger shapes than in the tests of operators

using State = std::shared_ptr<DocumentState>;

State grown_now(const std::string& text) {
    SerialExecutor serial;
    return grown(text, {}, serial);
}

// A random document after a few random edits; null where it reaches a limit.
State random_state(std::uint64_t seed, std::uint64_t edits) {
    State state = grown_now(RandomDocument(seed, scale * document_scale()).text());
    RandomEdits random(seed * 2 + 1);
    for (std::uint64_t e = 0; e < edits && state; ++e) {
        if (State next = grown_now(random.next(*state).text)) state = next;
    }
    return state;
}

std::string svg_of(const Run& run) { return to_svg(run.drawing, {}); }

State with_edit(const DocumentState& state, DocumentEdit::Kind kind, const std::string& path,
                const std::string& value = "") {
    DocumentEdit edit;
    edit.kind = kind;
    edit.path = path;
    edit.value = value;
    const Result<std::string> text = edited_text(state.opened.document, edit);
    return text ? grown_now(*text) : nullptr;
}

std::vector<std::string> segments_of(const std::string& path) {
    std::vector<std::string> segments(1);
    for (const char c : path) {
        if (c == '/') {
            segments.emplace_back();
        } else {
            segments.back() += c;
        }
    }
    return segments;
}
bool is_number(const std::string& segment) { return segment.find_first_not_of("0123456789") == std::string::npos; }

// Whether a place is another one or lies below it. Single shapes belong to the steps and styles of their groups.
bool is_at_or_below(const std::string& place, const std::string& above) {
    const std::vector<std::string> here = segments_of(place), wanted = segments_of(above);
    std::size_t w = 0;
    for (std::size_t h = 0; h < here.size() && w < wanted.size(); ++h) {
        if (here[h] == wanted[w]) {
            ++w;
        } else if (!is_number(here[h])) {
            return false;
        }
    }
    return w == wanted.size();
}

// What a choice came out as, by where and what it is for.
struct Outcome {
    NamedChoice choice;
    bool operator==(const Outcome& other) const {
        return choice.value() == other.choice.value() && choice.domain() == other.choice.domain();
    }
};
std::map<std::string, Outcome> outcomes(const DocumentState& state) {
    std::map<std::string, Outcome> all;
    for (NamedChoice& choice : named_choices(state)) {
        std::string identity = choice.identity();
        all.insert_or_assign(std::move(identity), Outcome{std::move(choice)});
    }
    return all;
}

bool is_free_range(const NamedChoice& choice) {
    return choice.domain().kind == ChoiceDomain::Kind::range && choice.source() == ChoiceSource::drawn &&
           choice.domain().low < choice.domain().high;
}

// Whether the document itself keeps a choice: one that is embedded may.
bool is_kept(const DocumentState& state, const NamedChoice& choice) {
    return state.opened.document.text().find("keep let/" + choice.name()) != std::string::npos;
}

// Some group or step of a derivation that has a name all the way.
struct Place {
    std::string path;
    std::string group;  // that of the group: a step's conditions and weights decide what becomes of it
};
Place random_place(const DocumentState& state, CaseRandom& random) {
    const tangle::Tangle& tangle = state.run.tangle;
    const tangle::Grammar& grammar = *state.checked.grammar;
    const auto group = static_cast<std::uint32_t>(random.index(tangle.groups.size()));
    const std::string path = path_of_group(tangle, grammar, group);
    if (path.back() == '/' || path.find("//") != std::string::npos) return random_place(state, random);
    const std::uint32_t step = tangle.groups[group].consumer;
    if (step != tangle::none && random.coin()) return {path_of_step(tangle, grammar, step), path};
    return {path, path};
}

// --- one document, one picture ----------------------------------------------------------------------------------

void expect_replay(const DocumentState& state, std::uint64_t seed) {
    SerialExecutor serial;
    std::string listing;
    list_choices(state.opened, state.checked, state.run, [&](std::string_view piece) { listing += piece; });
    const Result<Replay> replay = read_choices(listing);
    ASSERT_TRUE(replay);
    RunOptions options;
    options.replay = &*replay;
    const State again = grown(with_seed(state.opened.document, 987654321 + seed), options, serial);
    ASSERT_TRUE(again) << state.opened.document.text();
    EXPECT_TRUE(svg_of(again->run) == svg_of(state.run)) << state.opened.document.text();
}

void expect_same_renamed(const DocumentState& state, CaseRandom& random) {
    const std::string tag = "t" + std::to_string(random.below(5)), other = "another_name";
    const std::string text = with_word(state.opened.document.text(), tag, other);
    const State renamed = grown_now(text);
    ASSERT_TRUE(renamed) << text;
    EXPECT_EQ(renamed->run.tangle.choices.keys, state.run.tangle.choices.keys) << text;
    EXPECT_EQ(renamed->run.tangle.choices.values, state.run.tangle.choices.values) << text;
    EXPECT_TRUE(with_word(svg_of(renamed->run), other, tag) == svg_of(state.run)) << text;
}

void expect_same_with_threads(const DocumentState& state, ThreadPool& threads) {
    const auto run = run_document(state.opened, state.checked, {}, threads, {});
    ASSERT_TRUE(run);
    EXPECT_EQ(difference(*run, state.run), "") << state.opened.document.text();
}

// With files: one to grow from, one that is included, one that is embedded.
const Inputs files = {
    {"shape.svg",
     "<svg xmlns='http://www.w3.org/2000/svg' width='60' height='40'><path id='a' d='M0 0H60V40H0Z'/></svg>"},
    {"names.fil", "let thin = 2px..3px\nstyle t3 { pen: 0.4px }\n"},
    {"inner.fil", "grammar tangle\nstart ground = host()\nregular_split(line, 6px..9px, angle: 30) : ground -> a, b\n"},
};

// Whether the document, with files, was one to export.
bool expect_carried(const DocumentState& state, CaseRandom& random, const TestFolder& folder) {
    SerialExecutor serial;
    std::string text = state.opened.document.text();
    if (random.coin()) text += "start t1 = file(\"shape.svg\", id: \"a\")\n";
    if (random.coin()) text += "include \"names.fil\"\noutline(thin) : t0 -> t2, t3\n";
    if (random.coin()) text += "embed(\"inner.fil\") : t1 -> t4\n";
    if (random.below(4) == 0) text += "# a comment with ]]> and \xC3\xA9\n";
    const OpenedDocument first = open_text("random.fil", text, files);
    const CheckedDocument checked_first = check_document(first);
    if (has_errors(checked_first.diagnostics)) return false;
    const auto run = run_document(first, checked_first, {}, serial, {});
    if (!run) return false;
    SvgOptions options;
    const CarriedDocument carried_first = carried(first);
    options.carried = &carried_first;
    const std::string svg = to_svg(run->drawing, options);

    const Result<OpenedDocument> opened = open_document(folder.write("picture.svg", svg), {});
    EXPECT_TRUE(opened) << text;
    if (!opened) return false;
    const CheckedDocument checked = check_document(*opened);
    EXPECT_FALSE(has_errors(checked.diagnostics)) << to_text(checked.diagnostics, opened->sources);
    if (has_errors(checked.diagnostics)) return false;
    const auto again = run_document(*opened, checked, {}, serial, {});
    EXPECT_TRUE(again) << text;
    if (!again) return false;
    const CarriedDocument carried_again = carried(*opened);
    EXPECT_EQ(carried_again, carried_first) << text;
    options.carried = &carried_again;
    EXPECT_TRUE(to_svg(again->drawing, options) == svg) << text;
    return true;
}

// A run replays from its choices alone, under another seed too; a renamed tag changes no picture; two threads give what
// one does; and an exported picture opens again to the same bytes.
TEST(ChoicesProperty, WhatADocumentSaysMakesItsPicture) {
    ThreadPool threads(2);
    const TestFolder folder;
    const std::uint64_t first = first_seed(), count = case_count(1000);
    std::uint64_t seen = 0, exported = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const State state = random_state(seed, 2);
        if (!state) continue;
        CaseRandom random(seed);
        ++seen;
        expect_replay(*state, seed);
        expect_same_renamed(*state, random);
        expect_same_with_threads(*state, threads);
        exported += expect_carried(*state, random, folder) ? 1 : 0;
    }
    EXPECT_GT(seen * 10, count * 9);
    EXPECT_GT(exported * 4, count * 3);
}

// --- one more rule ----------------------------------------------------------------------------------------------

// A rule of weight w among others of weight W in all wins each draw with the chance w / (W + w), and no draw that it
// does not win comes out differently. Over n draws the number of wins lies within five standard deviations of n w /
// (W + w) but for one test in two million.
TEST(ChoicesProperty, AnAppendedRuleTakesItsShareOfTheDrawsAndNoOther) {
    const std::uint64_t first = first_seed(), count = std::max<std::uint64_t>(1, case_count(1000) / 20);
    double surplus = 0, variance_of_all = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        CaseRandom random(seed);
        std::string text =
            "grammar tangle\nseed " + std::to_string(seed) +
            "\nstart cloth = rectangle(300px, 300px)\n"
            "regular_split(line, 6px, dual: yes, angle: 0) : cloth -> cells\nungroup() : cells -> cell\n";
        double sum = 0;
        const auto rule = [&](int number, double& weight) {
            weight = std::round(random.between(0.25, 4) * 100) / 100;
            std::string weight_text;
            append_fixed(weight_text, weight, 2);
            return (random.coin() ? "" : "label" + std::to_string(number) + " = ") + "invert() : cell weight " +
                   weight_text + " -> out" + std::to_string(number) + "\n";
        };
        const int rules = random.whole(1, 5);
        double weight = 0;
        for (int r = 0; r < rules; ++r) {
            text += rule(r, weight);
            sum += weight;
        }
        const State before = grown_now(text);
        const State after = grown_now(text + rule(rules, weight));
        ASSERT_TRUE(before && after) << text;
        ASSERT_EQ(before->run.tangle.steps.size(), after->run.tangle.steps.size());
        const auto added = static_cast<std::uint32_t>(2 + rules);
        double draws = 0, wins = 0;
        for (std::size_t s = 2; s < before->run.tangle.steps.size(); ++s) {
            ++draws;
            const tangle::Step &old = before->run.tangle.steps[s], &now = after->run.tangle.steps[s];
            ASSERT_EQ(old.group, now.group);
            if (now.rule == added) {
                ++wins;
            } else {
                ASSERT_EQ(old.rule, now.rule) << "seed " << seed << ": the draw of group " << old.group;
                ASSERT_EQ(old.key, now.key);
            }
        }
        ASSERT_GT(draws, 2000);
        const double chance = weight / (sum + weight), variance = draws * chance * (1 - chance);
        EXPECT_NEAR(wins, draws * chance, 5 * std::sqrt(variance)) << "seed " << seed << "\n" << text;
        surplus += wins - draws * chance;
        variance_of_all += variance;
    }
    EXPECT_NEAR(surplus, 0, 5 * std::sqrt(variance_of_all));
}

// --- reroll and keep --------------------------------------------------------------------------------------------

TEST(ChoicesProperty, ARerollDrawsAgainWhatLiesBelowAndNothingElse) {
    const std::uint64_t first = first_seed(), count = case_count(1000);
    std::uint64_t redrawn = 0, alternatives = 0, other_alternatives = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const State state = random_state(seed, 0);
        if (!state) continue;
        CaseRandom random(seed);
        const Place drawn = random_place(*state, random);
        const std::string& place = drawn.path;
        const State again = with_edit(*state, DocumentEdit::Kind::reroll, place);
        if (!again) continue;  // a limit
        const auto before = outcomes(*state), after = outcomes(*again);
        for (const auto& [identity, old] : before) {
            const auto now = after.find(identity);
            if (!is_at_or_below(old.choice.place, place)) {
                // The weight of a step's rule is drawn again too, which may give the group another rule.
                const bool hangs_on_it = is_at_or_below(old.choice.place, drawn.group);
                if (hangs_on_it && (now == after.end() || !(now->second.choice.domain() == old.choice.domain())))
                    continue;
                ASSERT_TRUE(now != after.end()) << seed << " " << place << " lost " << old.choice.path << "\n"
                                                << again->opened.document.text();
                EXPECT_TRUE(now->second == old) << seed << " reroll " << place << " changed " << old.choice.path << "\n"
                                                << again->opened.document.text();
                continue;
            }
            if (now == after.end() || !(now->second.choice.domain() == old.choice.domain())) continue;
            if (old.choice.source() != ChoiceSource::drawn || is_kept(*state, old.choice)) continue;
            if (old.choice.domain().kind == ChoiceDomain::Kind::alternatives) {
                ++alternatives;
                if (now->second.choice.value() != old.choice.value()) ++other_alternatives;
            } else if (is_free_range(old.choice) && !old.choice.domain().whole) {
                ++redrawn;
                EXPECT_NE(now->second.choice.value(), old.choice.value())
                    << seed << " reroll " << place << ": " << old.choice.path << "\n"
                    << again->opened.document.text();
            }
        }
        for (const auto& [identity, now] : after) {
            EXPECT_TRUE(before.count(identity) > 0 || is_at_or_below(now.choice.place, drawn.group))
                << seed << " reroll " << place << " added " << now.choice.path;
        }
    }
    EXPECT_GT(redrawn, count);
    // Of two or three alternatives another one wins in a third of the draws at least.
    EXPECT_GT(other_alternatives * 4, alternatives);
}

TEST(ChoicesProperty, WhatIsKeptStaysWhenWhatLiesAboveItIsRerolled) {
    const std::uint64_t first = first_seed(), count = case_count(1000);
    std::uint64_t kept = 0, redrawn = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const State state = random_state(seed, 0);
        if (!state || state->run.tangle.steps.empty()) continue;
        CaseRandom random(seed);
        std::string place = random_place(*state, random).path;
        for (int tried = 0; tried < 10 && place.find('/') == std::string::npos; ++tried)
            place = random_place(*state, random).path;
        const std::vector<std::string> segments = segments_of(place);
        std::string above = segments[0];
        for (std::size_t i = 1, end = random.index(segments.size()); i < end; ++i) above += "/" + segments[i];
        if (above == place) continue;
        const State held = with_edit(*state, DocumentEdit::Kind::keep, place);
        ASSERT_TRUE(held) << seed << " keep " << place;
        EXPECT_TRUE(svg_of(held->run) == svg_of(state->run)) << seed << " keep " << place << " changes the picture";
        const State again = with_edit(*held, DocumentEdit::Kind::reroll, above);
        if (!again) continue;  // a limit
        const auto before = outcomes(*held), after = outcomes(*again);
        for (const auto& [identity, old] : before) {
            const auto now = after.find(identity);
            if (now == after.end() || !(now->second.choice.domain() == old.choice.domain())) continue;
            // Shapes that another rule now hands on keep their keys, and their styles, in another place.
            if (now->second.choice.place != old.choice.place) continue;
            if (is_at_or_below(old.choice.place, place)) {
                ++kept;
                EXPECT_EQ(now->second.choice.value(), old.choice.value()) << seed << " " << old.choice.path << "\n"
                                                                          << again->opened.document.text();
            } else if (is_at_or_below(old.choice.place, above) && is_free_range(old.choice) &&
                       !old.choice.domain().whole && !is_kept(*state, old.choice)) {
                ++redrawn;
                EXPECT_NE(now->second.choice.value(), old.choice.value()) << seed << " " << old.choice.path;
            }
        }
    }
    EXPECT_GT(kept, count / 2);
    EXPECT_GT(redrawn, count / 4);
}

// --- ranges -----------------------------------------------------------------------------------------------------

TEST(ChoicesProperty, ANarrowerRangeMovesItsValueAndDrawsNothingAnew) {
    const std::uint64_t first = first_seed(), count = case_count(1000);
    std::uint64_t moved = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const State state = random_state(seed, 0);
        if (!state) continue;
        CaseRandom random(seed);
        RandomEdits edits(seed);
        std::vector<NamedChoice> ranges;
        for (NamedChoice& choice : named_choices(*state)) {
            if (is_free_range(choice)) ranges.push_back(std::move(choice));
        }
        if (ranges.empty()) continue;
        const NamedChoice& choice = ranges[random.index(ranges.size())];
        // The first draw of an argument is meant alone by ~1; what `when` comes out as is no range itself.
        std::string path = choice.path;
        const bool is_first = path.find('~') == std::string::npos;
        const bool whole_value = is_first && choice.name() != "when" && choice.path.find("let/") == std::string::npos;
        if (is_first && !(whole_value && random.coin())) path += "~1";
        const State narrowed = with_edit(*state, DocumentEdit::Kind::set, path, edits.range_for(choice));
        if (!narrowed) continue;  // a limit
        const auto before = outcomes(*state), after = outcomes(*narrowed);
        for (const auto& [identity, old] : before) {
            const auto now = after.find(identity);
            if (identity != choice.identity()) {
                if (now == after.end() || !(now->second.choice.domain() == old.choice.domain())) continue;
                EXPECT_EQ(now->second.choice.value(), old.choice.value())
                    << seed << " narrowing " << path << " changed " << old.choice.path << "\n"
                    << narrowed->opened.document.text();
                continue;
            }
            ASSERT_TRUE(now != after.end()) << seed << " " << path << "\n" << narrowed->opened.document.text();
            const ChoiceDomain &wide = old.choice.domain(), &narrow = now->second.choice.domain();
            ++moved;
            const double at = (old.choice.value() - wide.low) / (wide.high - wide.low + (wide.whole ? 1 : 0));
            const double value = now->second.choice.value();
            if (!wide.whole) {
                EXPECT_NEAR(value, narrow.low + at * (narrow.high - narrow.low), 1e-9 * (1 + std::fabs(value)))
                    << seed << " " << path << "\n"
                    << narrowed->opened.document.text();
                continue;
            }
            // The value of a whole range tells its quantile to one part in so many.
            const double step = 1 / (wide.high - wide.low + 1), size = narrow.high - narrow.low + 1;
            EXPECT_GE(value, narrow.low + std::floor(at * size) - 1e-6 * size) << seed << " " << path;
            EXPECT_LE(value, narrow.low + std::floor((at + step) * size) + 1e-6 * size) << seed << " " << path;
        }
    }
    EXPECT_GT(moved * 2, count);
}

// --- branches ---------------------------------------------------------------------------------------------------

// The shapes of all groups that do not descend from one, with what has grown in them.
using Shapes = std::map<std::uint64_t, std::string>;
Shapes shapes_beside(const DocumentState& state, Key branch) {
    const tangle::Tangle& tangle = state.run.tangle;
    std::vector<bool> inside(tangle.groups.size());
    Shapes shapes;
    for (std::size_t g = 0; g < tangle.groups.size(); ++g) {
        const tangle::Group& group = tangle.groups[g];
        inside[g] =
            group.key == branch || (group.producer != tangle::none && inside[tangle.steps[group.producer].group]);
        if (inside[g]) continue;
        for (const tangle::Shape& shape : group.shapes) {
            std::string& text = shapes[fold(group.key.value, shape.key.value)];
            text = state.checked.grammar->tags[group.tag] + (shape.inked ? " inked" : "") +
                   (shape.fill ? to_text(Value{*shape.fill, {}}) : "");
            const PolygonView polygon = tangle.polygon(shape);
            for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
                for (const Point& point : polygon.ring(r)) {
                    text += " " + std::to_string(point.x) + "," + std::to_string(point.y);
                }
            }
        }
        if (group.consumer == tangle::none) continue;
        for (std::size_t i = 0; i < tangle.steps[group.consumer].embedded.size(); ++i) {
            const auto& embedded = tangle.steps[group.consumer].embedded[i];
            if (embedded) shapes[fold(fold(group.key.value, 1), i)] = to_svg(embedded->drawing, {});
        }
    }
    return shapes;
}

TEST(ChoicesProperty, EditingOneBranchLeavesTheOthers) {
    const std::uint64_t first = first_seed(), count = case_count(1000);
    std::uint64_t edited_branches = 0, changed = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const State state = random_state(seed, 1);
        if (!state) continue;
        CaseRandom random(seed);
        const tangle::Tangle& tangle = state->run.tangle;
        // A branch that has siblings, and a path of its own.
        const auto branch = static_cast<std::uint32_t>(random.index(tangle.groups.size()));
        const std::string path = path_of_group(tangle, *state->checked.grammar, branch);
        std::uint64_t siblings = 0;
        bool is_shared = false;
        for (std::uint32_t g = 0; g < tangle.groups.size(); ++g) {
            if (g == branch) continue;
            if (tangle.groups[g].producer == tangle.groups[branch].producer) ++siblings;
            const std::string other = path_of_group(tangle, *state->checked.grammar, g);
            // A single shape that was picked out stands below its group's path.
            const bool is_picked = tangle.groups[g].picked != 0 && other.rfind(path + "/", 0) == 0;
            is_shared = is_shared || other == path || is_picked;
        }
        const bool has_name = path.back() != '/' && path.find("//") == std::string::npos;
        if (siblings == 0 || is_shared || !has_name || tangle.groups[branch].picked != 0) continue;
        std::vector<NamedChoice> below;
        for (NamedChoice& choice : named_choices(*state)) {
            // Neither conditions nor what lies below an unnamed tag can be said in a document.
            const bool is_nameable =
                choice.name().find('?') == std::string::npos && choice.path.find("//") == std::string::npos;
            if (is_nameable && is_at_or_below(choice.place, path)) below.push_back(std::move(choice));
        }
        RandomEdits edits(seed);
        DocumentEdit edit;
        edit.path = path;
        edit.kind = DocumentEdit::Kind::reroll;
        if (random.below(3) == 0) {
            edit.kind = DocumentEdit::Kind::apply;
            edit.targets = {path};
            edit.value = random.coin() ? "outline(2px..4px)" : "regular_split(line, 9px)";
            edit.outputs = "fresh";
        } else if (!below.empty() && random.coin()) {
            const NamedChoice& choice = below[random.index(below.size())];
            edit.kind = DocumentEdit::Kind::set;
            edit.path = choice.path;
            edit.value = edits.value_for(choice);
        }
        const Result<std::string> text = edited_text(state->opened.document, edit);
        ASSERT_TRUE(text) << seed << " " << to_text(edit);
        const State after = grown_now(*text);
        if (!after) continue;
        ++edited_branches;
        if (svg_of(after->run) != svg_of(state->run)) ++changed;
        const Key key = tangle.groups[branch].key;
        EXPECT_TRUE(shapes_beside(*state, key) == shapes_beside(*after, key)) << seed << " " << to_text(edit) << "\n"
                                                                              << state->opened.document.text();
    }
    EXPECT_GT(edited_branches * 8, count);
    EXPECT_GT(changed * 3, edited_branches);
}

// --- what has been wrong ----------------------------------------------------------------------------------------

// `ungroup` hands shapes on with their keys, so the styles of both groups draw for one shape, each for itself.
TEST(Choices, StylesOfAShapeInTwoGroupsReplayBoth) {
    const State state = grown_now(
        "grammar tangle\nseed 2\nstart a = rectangle(100px, 100px)\nregular_split(20px, angle: 0) : a -> b\n"
        "ungroup() : b -> c\nstyle b, c { stroke: one_of(black, #204080) }\nreroll a/regular_split/b/ungroup\n");
    ASSERT_TRUE(state);
    expect_replay(*state, 1);
}

// A square that one of two rules expands, with what a document says of that; by seeds.
State with_rule_preset(std::uint64_t seed, const std::string& preset) {
    return grown_now("grammar tangle\nseed " + std::to_string(seed) +
                     "\nstart a = rectangle(100px, 100px)\noutline(5px) : a -> b, c\ninvert() : a -> b\n" + preset +
                     "\n");
}

TEST(Choices, TheConditionOfARulesPresetReplays) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const State state = with_rule_preset(seed, "set a.rule = \"invert\" when (0..1) < 0.5");
        ASSERT_TRUE(state);
        expect_replay(*state, seed);
    }
}

TEST(Choices, AChoiceInTheValueOfARulesPresetReplays) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const State state = with_rule_preset(seed, "set a.rule = (0..1) < 0.5 ? \"invert\" : \"outline\"");
        ASSERT_TRUE(state);
        expect_replay(*state, seed);
    }
}

TEST(Choices, WeightsInARulesPresetAreDrawnEachForItself) {
    std::set<double> weights;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const State state = with_rule_preset(seed, "set a.rule = one_of(\"invert\": 1..9, \"outline\": 1..9)");
        ASSERT_TRUE(state);
        for (const NamedChoice& choice : named_choices(*state)) {
            if (choice.name() == "rule") weights.insert(choice.domain().weights.begin(), choice.domain().weights.end());
        }
        expect_replay(*state, seed);
    }
    EXPECT_EQ(weights.size(), 8U);
}

// The style of the first leaf is wrong, and steps come behind it that have not been drawn.
TEST(Drawing, AStyleThatIsWrongForAShapeIsAnErrorAndNothingElse) {
    SerialExecutor serial;
    const OpenedDocument opened =
        open_text("a.fil",
                  "grammar tangle\nstart a = rectangle(100px, 100px)\noutline(5px) : a -> b, leaf\n"
                  "regular_split(line, 20px, angle: 0) : b -> c\nungroup() : c -> d\noutline(2px) : d -> e, f\n"
                  "style leaf { pen: x - 1000px }\n",
                  {});
    const CheckedDocument checked = check_document(opened);
    ASSERT_FALSE(has_errors(checked.diagnostics)) << to_text(checked.diagnostics, opened.sources);
    const auto run = run_document(opened, checked, {}, serial, {});
    ASSERT_FALSE(run);
    EXPECT_EQ(run.diagnostics().front().code, "language.out-of-range");
}

}  // namespace
}  // namespace filigree
