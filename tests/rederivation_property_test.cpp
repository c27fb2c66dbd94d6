// Law: deriving a document with what is left of an earlier derivation gives what deriving it from nothing gives, over
// random documents and random sequences of edits.
#include <gtest/gtest.h>

#include <atomic>

#include "base/thread_pool.h"
#include "formats/svg_write.h"
#include "tests/random_document.h"
#include "tests/random_edit.h"
#include "tests/same_tangle.h"

namespace filigree {
namespace {

constexpr double scale = 2;  // fewer and larger shapes than in the tests of operators

struct Counts {
    std::uint64_t derived = 0, refused = 0, failed = 0, taken_over = 0, too_large = 0;
};

class Rederivation {
public:
    Rederivation(std::uint64_t seed, Counts& counts) : random_(seed * 2 + 1), edits_(seed * 2), counts_(counts) {
        text_ = RandomDocument(seed, scale * document_scale()).text();
    }

    // The first difference that an edit makes, with the documents; empty where all are as they should be.
    std::string difference_after_edits(std::uint64_t seed) {
        std::shared_ptr<DocumentState> state = grown(text_, {}, serial_);
        if (!state) {
            ++counts_.too_large;
            return "";
        }
        states_.push_back(state);
        const std::uint64_t count = random_.whole(3, 6);
        for (std::uint64_t e = 0; e < count; ++e) {
            const bool is_undo = states_.size() > 1 && random_.below(8) == 0;
            const RandomEdits::Made made =
                is_undo ? RandomEdits::Made{"undo", states_[states_.size() - 2]->opened.document.text()}
                        : edits_.next(*states_.back());
            const std::string found = difference_after(made.text, previous(seed));
            if (!found.empty()) {
                return found + "\n--- edit: " + made.what + "\n--- before:\n" + earlier_->opened.document.text() +
                       "--- after:\n" + made.text;
            }
        }
        return "";
    }

private:
    // Mostly the last derivation; else an older one, how it began, or one of quite another document.
    const tangle::Tangle* previous(std::uint64_t seed) {
        earlier_ = states_.back();
        const std::uint64_t which = random_.below(12);
        if (which == 0) earlier_ = states_[random_.index(states_.size())];
        if (which == 1) {
            RunOptions options;
            options.steps = random_.below(static_cast<std::uint32_t>(earlier_->run.tangle.steps.size() + 1));
            if (const auto prefix = grown(earlier_->opened.document.text(), options, serial_)) earlier_ = prefix;
        }
        if (which == 2) {
            if (const auto other = grown(RandomDocument(seed + 1, scale * document_scale()).text(), {}, serial_))
                earlier_ = other;
        }
        return &earlier_->run.tangle;
    }

    std::string difference_after(const std::string& text, const tangle::Tangle* previous) {
        auto state = std::make_shared<DocumentState>();
        state->opened = open_text("random.fil", text, {});
        state->checked = check_document(state->opened);
        if (has_errors(state->checked.diagnostics)) {
            ++counts_.refused;
            return "";
        }
        RunOptions options;
        const Result<Run> fresh = run_document(state->opened, state->checked, options, serial_, {});
        options.previous = previous;
        Result<Run> again = run_document(state->opened, state->checked, options, serial_, {});
        if (!fresh || !again) {
            ++counts_.failed;
            return !fresh == !again ? "" : "one of both fails";
        }
        ++counts_.derived;
        for (const auto& geometry : again->tangle.geometry) {
            const auto& old = previous->geometry;
            if (std::find(old.begin(), old.end(), geometry) != old.end()) ++counts_.taken_over;
        }
        std::string found = difference(*again, *fresh);
        state->run = std::move(*again);
        states_.push_back(std::move(state));
        return found;
    }

    CaseRandom random_;
    RandomEdits edits_;
    Counts& counts_;
    SerialExecutor serial_;
    std::string text_;
    std::vector<std::shared_ptr<DocumentState>> states_;
    std::shared_ptr<DocumentState> earlier_;
};

TEST(RederivationProperty, WhatIsTakenOverIsWhatWouldBeDerived) {
    Counts counts;
    const std::uint64_t first = first_seed(), count = case_count(1000);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const std::string found = Rederivation(seed, counts).difference_after_edits(seed);
        EXPECT_TRUE(found.empty()) << "seed " << seed << ": " << found;
    }
    EXPECT_GT(counts.derived, 2 * count) << "too many random edits are wrong to tell anything";
    EXPECT_GT(counts.taken_over, counts.derived) << "too little is taken over to tell anything";
    EXPECT_LE(counts.too_large, count / 100) << "too many random documents reach their limit";
    std::cout << counts.derived << " derivations after edits, " << counts.refused << " refused, " << counts.failed
              << " failed; " << counts.taken_over << " geometries taken over\n";
}

// --- workspaces -------------------------------------------------------------------------------------------------

std::string svg_of(const Workspace& workspace) { return to_svg(workspace.state->run.drawing, {}); }

// All that a change that fails must leave as it is.
struct Before {
    explicit Before(const Workspace& workspace)
        : state(workspace.state.get()),
          edits(workspace.history.edits.size()),
          current(workspace.history.current),
          text(workspace.history.text) {}
    bool operator==(const Before&) const = default;

    const DocumentState* state;
    std::size_t edits;
    std::uint32_t current;
    std::string text;
};

TEST(RederivationProperty, AWorkspaceGoesBackAndForthToTheSameBytes) {
    SerialExecutor serial;
    std::atomic<bool> cancelled = true;
    Job stopped;
    stopped.cancel_flag = &cancelled;
    const std::uint64_t first = first_seed(), count = case_count(1000);
    std::uint64_t changed = 0, refused = 0, stopped_early = 0, too_large = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        CaseRandom random(seed);
        RandomEdits edits(seed);
        Result<Workspace> opened = open_workspace(
            open_text("random.fil", RandomDocument(seed, scale * document_scale()).text(), {}), {}, serial, {});
        if (!opened) {
            ASSERT_EQ(opened.diagnostics().front().fault, Fault::limit);
            ++too_large;
            continue;
        }
        Workspace& workspace = *opened;
        std::vector<std::string> svgs = {svg_of(workspace)};  // of each edit of the history
        const int moves = random.whole(4, 8);
        for (int m = 0; m < moves; ++m) {
            const Before before(workspace);
            const std::uint32_t way = random.below(8);
            if (way < 4) {
                const RandomEdits::Made made = edits.next(*workspace.state);
                if (way == 0) {
                    const Diagnostics none = change(workspace, made.what, made.text, serial, stopped);
                    if (made.text != before.text) {
                        ++stopped_early;
                        EXPECT_TRUE(has_errors(none)) << made.what;
                    }
                    ASSERT_TRUE(Before(workspace) == before) << made.what;
                    continue;
                }
                const std::string label = "edit " + std::to_string(m);
                if (has_errors(change(workspace, label, made.text, serial, {}))) {
                    ++refused;
                    ASSERT_TRUE(Before(workspace) == before) << made.what;
                    continue;
                }
                ++changed;
                ASSERT_EQ(workspace.history.text, made.text);
                ASSERT_EQ(workspace.state->opened.document.text(), made.text);
                if (workspace.history.current == svgs.size()) svgs.push_back(svg_of(workspace));
            } else if (way == 4) {
                step_forward(workspace, serial, {});
            } else if (way == 5) {
                visit(workspace, random.below(static_cast<std::uint32_t>(svgs.size() + 1)), serial, {});
            } else if (way == 6 && before.current != 0) {
                EXPECT_TRUE(has_errors(step_back(workspace, serial, stopped)));
                ASSERT_TRUE(Before(workspace) == before);
            } else {
                step_back(workspace, serial, {});
                EXPECT_EQ(workspace.history.current,
                          before.current == 0 ? 0 : workspace.history.edits[before.current].parent);
            }
            ASSERT_LT(workspace.history.current, svgs.size());
            ASSERT_EQ(workspace.state->opened.document.text(), workspace.history.text);
            EXPECT_TRUE(svg_of(workspace) == svgs[workspace.history.current]) << workspace.history.text;
        }
        while (workspace.history.current != 0) step_back(workspace, serial, {});
        EXPECT_TRUE(svg_of(workspace) == svgs[0]) << workspace.history.text;
    }
    EXPECT_GT(changed, count);
    EXPECT_GT(refused + stopped_early, count / 8);
    EXPECT_LE(too_large, count / 100);
}

// --- what the texts do not say ----------------------------------------------------------------------------------

// A document that reads files, derived after one of them has changed.
std::string difference_after_files(const std::string& text, const Inputs& before, const Inputs& after) {
    SerialExecutor serial;
    const OpenedDocument old_opened = open_text("a.fil", text, before), opened = open_text("a.fil", text, after);
    const CheckedDocument old_checked = check_document(old_opened), checked = check_document(opened);
    EXPECT_FALSE(has_errors(old_checked.diagnostics)) << to_text(old_checked.diagnostics, old_opened.sources);
    EXPECT_FALSE(has_errors(checked.diagnostics)) << to_text(checked.diagnostics, opened.sources);
    const auto old = run_document(old_opened, old_checked, {}, serial, {});
    RunOptions options;
    const auto fresh = run_document(opened, checked, options, serial, {});
    EXPECT_TRUE(old && fresh);
    options.previous = &old->tangle;
    const auto again = run_document(opened, checked, options, serial, {});
    EXPECT_TRUE(again);
    EXPECT_NE(to_svg(old->drawing, {}), to_svg(fresh->drawing, {})) << "the change shows nowhere";
    return difference(*again, *fresh);
}

TEST(Rederivation, FilesThatHaveChangedAreReadAgain) {
    const std::string embeds = "grammar tangle\nstart a = rectangle(90px, 60px)\nembed(\"inner.fil\") : a -> b\n";
    const std::string inner = "grammar tangle\nstart g = host()\noutline(3px) : g -> x, y\n";
    EXPECT_EQ(
        difference_after_files(embeds, {{"inner.fil", inner}}, {{"inner.fil", inner + "outline(2px) : x -> z, y\n"}}),
        "");
    // What an embedded document includes, grows from, or embeds itself.
    const std::string including = "grammar tangle\nstart g = host()\ninclude \"more.fil\"\n";
    EXPECT_EQ(difference_after_files(embeds, {{"inner.fil", including}, {"more.fil", "outline(3px) : g -> x, y\n"}},
                                     {{"inner.fil", including}, {"more.fil", "outline(4px) : g -> x, y\n"}}),
              "");
    const std::string embedding = "grammar tangle\nstart g = host()\nembed(\"innermost.fil\") : g -> h\n";
    EXPECT_EQ(difference_after_files(embeds, {{"inner.fil", embedding}, {"innermost.fil", inner}},
                                     {{"inner.fil", embedding}, {"innermost.fil", inner + "invert() : x -> z\n"}}),
              "");
    const auto picture = [](int width) {
        return "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0H" + std::to_string(width) + "V40H0Z'/></svg>";
    };
    const std::string growing = "grammar tangle\nstart g = file(\"p.svg\")\noutline(3px) : g -> x, y\n";
    EXPECT_EQ(difference_after_files(embeds, {{"inner.fil", growing}, {"p.svg", picture(50)}},
                                     {{"inner.fil", growing}, {"p.svg", picture(60)}}),
              "");
    EXPECT_EQ(difference_after_files(growing, {{"p.svg", picture(50)}}, {{"p.svg", picture(60)}}), "");
    // Names and rules of an included file, and its unit.
    const std::string includes =
        "grammar tangle\ninclude \"names.fil\"\nstart a = rectangle(90px, 60px)\noutline(wide) : a -> b, c\n";
    EXPECT_EQ(
        difference_after_files(includes, {{"names.fil", "let wide = 3px\n"}}, {{"names.fil", "let wide = 4px\n"}}), "");
    EXPECT_EQ(
        difference_after_files(includes, {{"names.fil", "let wide = 2\n"}}, {{"names.fil", "unit mm\nlet wide = 2\n"}}),
        "");
    EXPECT_EQ(difference_after_files(includes, {{"names.fil", "let wide = 3px\noutline(2) : b -> d, e\n"}},
                                     {{"names.fil", "unit mm\nlet wide = 3px\noutline(2) : b -> d, e\n"}}),
              "");
}

// --- what has been wrong ----------------------------------------------------------------------------------------

std::string difference_after(const std::string& before, const std::string& after) {
    SerialExecutor serial;
    const auto old = grown(before, {}, serial), fresh = grown(after, {}, serial);
    EXPECT_TRUE(old && fresh);
    RunOptions options;
    options.previous = &old->run.tangle;
    const auto again = run_document(fresh->opened, fresh->checked, options, serial, {});
    EXPECT_TRUE(again);
    return difference(*again, fresh->run);
}

TEST(Rederivation, AStepAppliedByHandMayHaveTheSegmentOfARule) {
    const std::string text =
        "grammar tangle\nstart a = rectangle(100px, 60px)\noutline(3px) : a -> b, c\napply outline(9px) to a -> d, e\n";
    EXPECT_EQ(difference_after(text, text + "# the same once more\n"), "");
}

TEST(Rederivation, WhatPresetsMeetInsideEmbeddedDocumentsIsKnownByTheirNumbersNow) {
    const std::string head =
        "grammar tangle\nstart a = rectangle(90px, 90px)\nstart b = rectangle(90px, 90px, at: (200px, 0px))\n"
        "system dots { grammar tangle; start h = host(); outline(2px..5px) : h -> in, out }\n"
        "embed(dots) : a -> x\noutline(7px) : b when count < 5 -> y, z\nstipple(7px) : b when count > 5\n";
    const std::string nowhere = "set b/stipple.spacing = 3px\n", inside = "set a/embed/h/outline.distance = 3px\n";
    EXPECT_EQ(difference_after(head + inside, head + nowhere + inside), "");
    EXPECT_EQ(difference_after(head + nowhere + inside, head + inside), "");
}

// Both times `a` is drawn again twice, but only what is said before the keep counts for what is kept.
TEST(Rederivation, WhatAKeepGoesBackToHangsOnTheRerollsBeforeIt) {
    const std::string head =
        "grammar tangle\nseed 3\nstart a = rectangle(100px, 100px)\noutline(5px) : a -> b, c\n"
        "regular_split(20px, angle: 0) : b -> d\noutline(1px..9px) : d -> e, f\n";
    for (const std::string keep : {"keep a/outline/b/regular_split/d/outline\n", "keep **/outline.distance\n"}) {
        EXPECT_EQ(difference_after(head + "reroll a x 2\n" + keep, head + "reroll a\n" + keep + "reroll a\n"), "");
        EXPECT_EQ(difference_after(head + "reroll a\n" + keep + "reroll a\n", head + "reroll a x 2\n" + keep), "");
    }
}

}  // namespace
}  // namespace filigree
