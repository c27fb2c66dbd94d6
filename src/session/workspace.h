// An open document: its text, what is derived from it, and all edits that were made, as a tree.
//
// Each edit is a new text; what of the derivation still holds is taken over (engines/tangle/reuse.h). An edit that
// makes the document wrong, is cancelled or reaches a limit changes nothing: the state before it is whole.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/executor.h"
#include "base/job.h"
#include "session/history.h"
#include "session/run.h"

namespace filigree {

// A document with all that was made of it. Immutable, and at one address, since its parts point into each other.
struct DocumentState {
    OpenedDocument opened;
    CheckedDocument checked;
    Run run;
};

struct Workspace {
    History history;
    std::shared_ptr<const DocumentState> state;
    RunOptions options;  // for every run; `previous` is set here
};

// Errors as those of opening, checking and running.
Result<Workspace> open_workspace(OpenedDocument opened, const RunOptions& options, Executor& executor, const Job& job);

// Changes the text; the label says what was done, for people. Warnings and errors of the new document; where there are
// errors nothing has changed.
Diagnostics change(Workspace& workspace, const std::string& label, std::string text, Executor& executor,
                   const Job& job);

// To the state before the last edit, to the one after it that was visited last, to any. Nothing where there is none.
Diagnostics step_back(Workspace& workspace, Executor& executor, const Job& job);
Diagnostics step_forward(Workspace& workspace, Executor& executor, const Job& job);
Diagnostics visit(Workspace& workspace, std::uint32_t edit, Executor& executor, const Job& job);

}  // namespace filigree
