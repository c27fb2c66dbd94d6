#include "session/run.h"

#include <chrono>

#include "engines/tangle/derive.h"
#include "engines/tangle/verify.h"

namespace filigree {

double now_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Result<Run> run_document(const OpenedDocument& opened, const CheckedDocument& checked, const RunOptions& options,
                         Executor& executor, const Job& job) {
    Run run;
    const Settings& settings = *checked.settings;
    const double begin = now_seconds();
    Result<tangle::Tangle> tangle =
        tangle::derive(*checked.grammar, *checked.start, settings, opened.document, {options.steps}, executor, job);
    if (!tangle) return tangle.diagnostics();
    run.tangle = std::move(*tangle);
    const double derived = now_seconds();
    run.times.derive = derived - begin;

    Result<Drawing> drawing = tangle::draw(run.tangle, *checked.grammar, settings, opened.document, options.colour_by);
    if (!drawing) return drawing.diagnostics();
    append(run.diagnostics, drawing.diagnostics());
    run.drawing = std::move(*drawing);
    run.times.draw = now_seconds() - derived;

    if (options.verify) {
        report(job, "verify", -1);
        run.broken = tangle::broken_invariants(run.tangle);
        run.verified = true;
    }
    return run;
}

}  // namespace filigree
