#include "apps/filigree/terminal.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <iostream>
#include <thread>

#include "base/thread_pool.h"
#include "session/run.h"

namespace filigree {
namespace {

std::atomic<bool> interrupted = false;
std::atomic<bool> progress_shown = false;

void on_interrupt(int) {
    // A second interrupt ends the program at once.
    if (interrupted.exchange(true)) std::_Exit(130);
}

}  // namespace

int exit_status(const Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) {
        if (diagnostic.severity != Severity::error) continue;
        switch (diagnostic.fault) {
            case Fault::document:
                return 1;
            case Fault::usage:
                return 2;
            case Fault::file:
                return 3;
            case Fault::limit:
                return 4;
            case Fault::internal:
                return 5;
        }
    }
    return 0;
}

int print_diagnostics(const Diagnostics& diagnostics, const Sources& sources) {
    clear_progress();
    std::cerr << to_text(diagnostics, sources) << std::flush;
    return exit_status(diagnostics);
}

Job terminal_job() {
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
    Job job;
    job.cancel_flag = &interrupted;
    if (isatty(STDERR_FILENO) != 0) {
        const double begin = now_seconds();
        double last = begin;
        job.on_progress = [begin, last](std::string_view phase, double fraction) mutable {
            const double now = now_seconds();
            if (now - begin < 0.5 || now - last < 0.1) return;
            last = now;
            progress_shown = true;
            std::cerr << "\r\x1b[Kfiligree: " << phase;
            if (fraction >= 0) std::cerr << " " << static_cast<int>(100 * fraction) << " %";
            std::cerr << " (" << static_cast<int>(now - begin) << " s)" << std::flush;
        };
    }
    return job;
}

bool was_interrupted() { return interrupted; }

void clear_progress() {
    if (progress_shown.exchange(false)) std::cerr << "\r\x1b[K" << std::flush;
}

std::unique_ptr<Executor> make_executor(std::size_t threads) {
    if (threads == 0) threads = std::max<std::size_t>(1, std::thread::hardware_concurrency());
    if (threads == 1) return std::make_unique<SerialExecutor>();
    return std::make_unique<ThreadPool>(threads);
}

}  // namespace filigree
