#include "session/workspace.h"

#include <gtest/gtest.h>

#include <atomic>

#include "formats/svg_write.h"
#include "session/edit_document.h"

namespace filigree {
namespace {

constexpr const char* document =
    "# a quilt\n"
    "grammar tangle\n"
    "start body = rectangle(120, 80)  # the cloth\n"
    "outline(4..8) : body -> in, rim\n"
    "regular_split(line, 15..30, dual: true) : in -> quads\n";

SerialExecutor serial;

Workspace opened() {
    Result<Workspace> workspace = open_workspace(open_text("quilt.fil", document, {}), {}, serial, {});
    EXPECT_TRUE(workspace) << to_text(workspace.diagnostics(), {});
    return std::move(*workspace);
}

std::string svg(const Workspace& workspace) { return to_svg(workspace.state->run.drawing, {}); }

Diagnostics set(Workspace& workspace, const std::string& path, const std::string& value, const Job& job = {}) {
    const Result<std::string> text =
        edited_text(workspace.state->opened.document, {DocumentEdit::Kind::set, path, value, {}, {}, 1});
    EXPECT_TRUE(text);
    return change(workspace, "set " + path, *text, serial, job);
}

TEST(Workspace, UndoIsATree) {
    Workspace workspace = opened();
    const std::string first = svg(workspace);
    EXPECT_TRUE(set(workspace, "body/outline.distance", "10").empty());
    const std::string second = svg(workspace);
    EXPECT_NE(first, second);
    step_back(workspace, serial, {});
    EXPECT_EQ(svg(workspace), first);
    EXPECT_EQ(workspace.state->opened.document.text(), document);
    EXPECT_TRUE(set(workspace, "body/outline.distance", "3").empty());
    const std::string third = svg(workspace);
    step_back(workspace, serial, {});
    step_forward(workspace, serial, {});  // to what was visited last
    EXPECT_EQ(svg(workspace), third);
    visit(workspace, 1, serial, {});  // the other branch is still there
    EXPECT_EQ(svg(workspace), second);
    EXPECT_EQ(workspace.history.edits.size(), 3U);
}

TEST(Workspace, AWrongEditChangesNothing) {
    Workspace workspace = opened();
    const auto state = workspace.state;
    EXPECT_TRUE(has_errors(set(workspace, "body/outline.distance", "-10")));
    EXPECT_TRUE(has_errors(set(workspace, "body/outlin.distance", "10")));
    EXPECT_EQ(workspace.state, state);
    EXPECT_EQ(workspace.history.edits.size(), 1U);
}

TEST(Workspace, CancellingChangesNothing) {
    Workspace workspace = opened();
    const auto state = workspace.state;
    const std::atomic<bool> cancelled = true;
    const Diagnostics reasons = set(workspace, "body/outline.distance", "10", {&cancelled, {}});
    ASSERT_TRUE(has_errors(reasons));
    EXPECT_EQ(reasons.back().code, "job.cancelled");
    EXPECT_EQ(workspace.state, state);
    EXPECT_EQ(workspace.history.current, 0U);
    EXPECT_TRUE(set(workspace, "body/outline.distance", "10").empty());
}

TEST(Workspace, AnEditThatMeetsNothingWarns) {
    Workspace workspace = opened();
    const Diagnostics warnings = set(workspace, "body/outline/in/regular_split/quads.is_random", "false");
    EXPECT_TRUE(warnings.empty());
    const Result<std::string> text =
        edited_text(workspace.state->opened.document,
                    {DocumentEdit::Kind::keep, "body/outline/in/regular_split/quads/900", {}, {}, {}, 1});
    ASSERT_TRUE(text);
    const Diagnostics unmatched = change(workspace, "keep", *text, serial, {});
    ASSERT_EQ(unmatched.size(), 1U);
    EXPECT_EQ(unmatched[0].code, "preset.unmatched");
}

}  // namespace
}  // namespace filigree
