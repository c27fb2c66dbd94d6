// A job: long work that can report how far it is and be asked to stop.
//
// Cancelling is a request: the work looks at it between units, returns a diagnostic of Fault::limit with the
// code `job.cancelled`, and leaves what was there before untouched. A default job is never cancelled and
// reports to nobody.
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

#include "base/diagnostic.h"

namespace filigree {

struct Job {
    const std::atomic<bool>* cancel_flag = nullptr;
    // Called from one thread at a time, now and then: a phase's name and how much of it is done (0..1, or
    // below 0 where that is not known).
    std::function<void(std::string_view phase, double fraction)> on_progress;
};

inline bool is_cancelled(const Job& job) {
    return job.cancel_flag != nullptr && job.cancel_flag->load(std::memory_order_relaxed);
}
inline void report(const Job& job, std::string_view phase, double fraction) {
    if (job.on_progress) job.on_progress(phase, fraction);
}
inline Diagnostic cancelled_diagnostic() { return fault(Fault::limit, "job.cancelled", "the work was cancelled"); }

}  // namespace filigree
