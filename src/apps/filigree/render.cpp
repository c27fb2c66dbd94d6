// filigree render: derive, draw and write; once, or again whenever a file changes.
#include <algorithm>
#include <chrono>
#include <iostream>
#include <thread>

#include "apps/filigree/commands.h"
#include "apps/filigree/terminal.h"
#include "formats/files.h"
#include "formats/png_write.h"
#include "formats/svg_write.h"
#include "session/run.h"
#include "session/stats.h"

namespace filigree {
namespace fs = std::filesystem;
namespace {

Diagnostic usage_error(std::string code, std::string message, std::vector<std::string> hints = {}) {
    Diagnostic wrong = fault(Fault::usage, std::move(code), std::move(message));
    wrong.hints = std::move(hints);
    return wrong;
}

std::string ending_of(const fs::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

// Whether two paths name one file, existing or not.
bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code failed;
    if (fs::equivalent(a, b, failed) && !failed) return true;
    return fs::weakly_canonical(a, failed) == fs::weakly_canonical(b, failed) && !failed;
}

Diagnostics output_problems(const RenderCommand& command) {
    Diagnostics problems;
    std::vector<fs::path> targets = command.outputs;
    if (!command.stats.empty()) targets.push_back(command.stats);
    for (const fs::path& output : command.outputs) {
        const std::string ending = ending_of(output);
        if (ending == ".svg" || ending == ".png") continue;
        problems.push_back(usage_error("render.unknown-format",
                                       "'" + output.string() + "' has an ending that is no known format",
                                       {"known are .svg and .png"}));
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (!same_file(targets[i], targets[k])) continue;
            problems.push_back(
                usage_error("render.same-output", "'" + targets[i].string() + "' is given twice as an output"));
        }
    }
    return problems;
}

// A document and what it reads are never overwritten by what they make.
Diagnostics overwrite_problems(const RenderCommand& command, const OpenedDocument& opened) {
    Diagnostics problems;
    std::vector<fs::path> targets = command.outputs;
    if (!command.stats.empty()) targets.push_back(command.stats);
    for (const fs::path& target : targets) {
        for (const fs::path& file : opened.files) {
            if (!same_file(target, file)) continue;
            problems.push_back(
                usage_error("render.overwrites-input",
                            "'" + target.string() + "' is read by the document, so it is not overwritten",
                            {"choose another name for the output"}));
            break;
        }
    }
    return problems;
}

struct Outcome {
    int status = 0;
    std::vector<fs::path> files;  // what was read: to watch
};

Outcome render_once(const RenderCommand& command, Executor& executor, const Job& job) {
    const double begin = now_seconds();
    const Result<OpenedDocument> opened = open_document(command.document, command.open);
    if (!opened) return {print_diagnostics(opened.diagnostics(), {}), {command.document}};
    const Sources& sources = opened->document.sources;
    if (const Diagnostics problems = overwrite_problems(command, *opened); !problems.empty()) {
        return {print_diagnostics(problems, {}), opened->files};
    }
    const CheckedDocument checked = check_document(*opened);
    const int check_status = print_diagnostics(checked.diagnostics, sources);
    if (check_status != 0) return {check_status, opened->files};
    const double parsed = now_seconds();

    const RunOptions options{command.steps, command.colour_by, command.verify};
    Result<Run> run = run_document(*opened, checked, options, executor, job);
    if (!run) return {print_diagnostics(run.diagnostics(), sources), opened->files};
    if (const int status = print_diagnostics(run->diagnostics, sources); status != 0) return {status, opened->files};
    run->times.parse = parsed - begin;

    const double drawn = now_seconds();
    std::vector<OutputFile> files;
    const CarriedDocument document = carried(*opened);
    for (const fs::path& output : command.outputs) {
        if (is_cancelled(job)) return {print_diagnostics({cancelled_diagnostic()}, {}), opened->files};
        report(job, "write", -1);
        if (ending_of(output) == ".svg") {
            SvgOptions svg;
            svg.lean = command.lean;
            svg.carried = &document;
            svg.title = fs::path(opened->name).stem().string();
            files.push_back({output, to_svg(run->drawing, svg)});
            continue;
        }
        Result<std::string> png = to_png(run->drawing, {command.dpi / 96});
        if (!png) return {print_diagnostics(png.diagnostics(), {}), opened->files};
        files.push_back({output, std::move(*png)});
    }
    if (is_cancelled(job)) return {print_diagnostics({cancelled_diagnostic()}, {}), opened->files};
    if (const Diagnostics failed = write_files(files); !failed.empty()) {
        return {print_diagnostics(failed, {}), opened->files};
    }
    if (!command.stats.empty()) {  // after the pictures: how long writing took is part of it
        run->times.write = now_seconds() - drawn;
        run->times.total = now_seconds() - begin;
        const Diagnostics failed = write_files({{command.stats, stats_json(*opened, checked, *run)}});
        if (!failed.empty()) return {print_diagnostics(failed, {}), opened->files};
    }
    clear_progress();
    Diagnostics broken;
    for (const std::string& invariant : run->broken)
        broken.push_back(fault(Fault::internal, "verify.broken", invariant));
    return {print_diagnostics(broken, {}), opened->files};
}

std::vector<fs::file_time_type> times_of(const std::vector<fs::path>& files) {
    std::vector<fs::file_time_type> times;
    for (const fs::path& file : files) {
        std::error_code missing;
        times.push_back(fs::last_write_time(file, missing));
    }
    return times;
}

int watch(const RenderCommand& command, Executor& executor, const Job& job) {
    while (!was_interrupted()) {
        const Outcome outcome = render_once(command, executor, job);
        if (was_interrupted()) break;
        std::cerr << "filigree: " << (outcome.status == 0 ? "rendered" : "not rendered") << "; watching "
                  << command.document.string() << " (interrupt to end)\n";
        const std::vector<fs::file_time_type> before = times_of(outcome.files);
        while (!was_interrupted() && times_of(outcome.files) == before) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
    }
    return 0;
}

}  // namespace

int run_render(const RenderCommand& command) {
    if (const Diagnostics problems = output_problems(command); !problems.empty())
        return print_diagnostics(problems, {});
    const std::unique_ptr<Executor> executor = make_executor(command.threads);
    const Job job = terminal_job();
    if (command.watch) return watch(command, *executor, job);
    return render_once(command, *executor, job).status;
}

}  // namespace filigree
