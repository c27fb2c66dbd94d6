// What the commands share towards the terminal: diagnostics, exit status, progress, interrupts.
#pragma once

#include <memory>

#include "base/diagnostic.h"
#include "base/executor.h"
#include "base/job.h"

namespace filigree {

// Exit status by the first error: 0 done, 1 document, 2 usage, 3 file, 4 limit or cancelled, 5 internal.
int exit_status(const Diagnostics& diagnostics);

// Prints all diagnostics to standard error and returns their exit status.
int print_diagnostics(const Diagnostics& diagnostics, const Sources& sources);

// A job that an interrupt cancels and that shows its progress where standard error is a terminal.
Job terminal_job();
bool was_interrupted();
void clear_progress();

// An executor of `threads` threads; 0 means as many as the machine has.
std::unique_ptr<Executor> make_executor(std::size_t threads);

}  // namespace filigree
