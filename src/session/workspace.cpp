#include "session/workspace.h"

namespace filigree {
namespace {

Result<std::shared_ptr<const DocumentState>> state_of(OpenedDocument opened, RunOptions options, Executor& executor,
                                                      const Job& job) {
    auto state = std::make_shared<DocumentState>();
    state->opened = std::move(opened);
    state->checked = check_document(state->opened, options.replay);
    if (has_errors(state->checked.diagnostics)) return state->checked.diagnostics;
    Result<Run> run = run_document(state->opened, state->checked, options, executor, job);
    if (!run) return std::move(run).diagnostics();
    state->run = std::move(*run);
    return std::shared_ptr<const DocumentState>(std::move(state));
}

// To the text that `history` is at; the workspace takes both over, or neither.
Diagnostics move_to(Workspace& workspace, History history, Executor& executor, const Job& job) {
    RunOptions options = workspace.options;
    options.previous = &workspace.state->run.tangle;
    Result<std::shared_ptr<const DocumentState>> state =
        state_of(reopened(workspace.state->opened, history.text), options, executor, job);
    if (!state) return std::move(state).diagnostics();
    Diagnostics warnings = (*state)->checked.diagnostics;
    append(warnings, (*state)->run.diagnostics);
    workspace.history = std::move(history);
    workspace.state = std::move(*state);
    return warnings;
}

}  // namespace

Result<Workspace> open_workspace(OpenedDocument opened, const RunOptions& options, Executor& executor, const Job& job) {
    Workspace workspace;
    workspace.options = options;
    workspace.history = begin(opened.document.text());
    Result<std::shared_ptr<const DocumentState>> state = state_of(std::move(opened), options, executor, job);
    if (!state) return std::move(state).diagnostics();
    workspace.state = std::move(*state);
    return workspace;
}

Diagnostics change(Workspace& workspace, const std::string& label, std::string text, Executor& executor,
                   const Job& job) {
    History history = workspace.history;
    if (!edit(history, label, std::move(text))) return {};
    return move_to(workspace, std::move(history), executor, job);
}

Diagnostics step_back(Workspace& workspace, Executor& executor, const Job& job) {
    History history = workspace.history;
    if (!undo(history)) return {};
    return move_to(workspace, std::move(history), executor, job);
}

Diagnostics step_forward(Workspace& workspace, Executor& executor, const Job& job) {
    History history = workspace.history;
    if (!redo(history)) return {};
    return move_to(workspace, std::move(history), executor, job);
}

Diagnostics visit(Workspace& workspace, std::uint32_t edit, Executor& executor, const Job& job) {
    History history = workspace.history;
    if (!go_to(history, edit)) return {};
    return move_to(workspace, std::move(history), executor, job);
}

}  // namespace filigree
