// filigree render: derive, draw and write; once, or again whenever a file changes.
#include <algorithm>
#include <chrono>
#include <iostream>
#include <thread>

#include "apps/filigree/commands.h"
#include "apps/filigree/output.h"
#include "apps/filigree/terminal.h"
#include "formats/files.h"
#include "session/run.h"
#include "session/stats.h"
#include "session/word_obj.h"

namespace filigree {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> targets_of(const RenderCommand& command) {
    std::vector<fs::path> targets = command.outputs;
    for (const fs::path& output : command.outputs) {
        if (is_mesh_format(output)) targets.push_back(materials_beside(output));
    }
    if (!command.stats.empty()) targets.push_back(command.stats);
    return targets;
}

// With --strict a preset that meets nothing is an error.
void refuse_unmatched(Diagnostics& diagnostics) {
    for (Diagnostic& diagnostic : diagnostics) {
        if (diagnostic.code == "preset.unmatched") diagnostic.severity = Severity::error;
    }
}

struct Outcome {
    int status = 0;
    std::vector<fs::path> files;  // what was read: to watch
};

Outcome render_once(const RenderCommand& command, Executor& executor, const Job& job) {
    const double begin = now_seconds();
    std::vector<fs::path> read = {command.document};
    OpenOptions open = command.open;
    if (!command.choices.empty()) {
        read.push_back(command.choices);
        Result<std::string> choices = read_file(command.choices);
        if (!choices) return {print_diagnostics(choices.diagnostics(), {}), read};
        open.choices = std::move(*choices);
        if (open.choices.empty()) open.choices.assign(1, '\n');  // an empty file is no list of choices
    }
    const Result<OpenedDocument> opened = open_document(command.document, open);
    if (!opened) return {print_diagnostics(opened.diagnostics(), {}), read};
    const Sources& sources = opened->sources;
    read.insert(read.end(), opened->files.begin(), opened->files.end());
    if (const Diagnostics problems = overwrites(targets_of(command), read); !problems.empty()) {
        return {print_diagnostics(problems, {}), read};
    }
    const CheckedDocument checked = check_document(*opened);
    const int check_status = print_diagnostics(checked.diagnostics, sources);
    if (check_status != 0) return {check_status, read};
    const double parsed = now_seconds();

    RunOptions options;
    options.steps = command.steps;
    options.colour_by = command.colour_by;
    options.verify = command.verify;
    options.draws = !std::all_of(command.outputs.begin(), command.outputs.end(), is_mesh_format);
    Result<Run> run = run_document(*opened, checked, options, executor, job);
    if (!run) return {print_diagnostics(run.diagnostics(), sources), read};
    if (command.strict) refuse_unmatched(run->diagnostics);
    if (const int status = print_diagnostics(run->diagnostics, sources); status != 0) return {status, read};
    run->times.parse = parsed - begin;

    const double drawn = now_seconds();
    std::vector<OutputFile> files;
    const CarriedDocument document = carried(*opened);
    for (const fs::path& output : command.outputs) {
        if (is_cancelled(job)) return {print_diagnostics({cancelled_diagnostic()}, {}), read};
        report(job, "write", -1);
        if (is_mesh_format(output)) {
            if (!run->word) {
                return {print_diagnostics(
                            {fault(Fault::usage, "render.no-mesh",
                                   "only words are drawn in space, so '" + output.string() + "' cannot be written")},
                            {}),
                        read};
            }
            const fs::path materials = materials_beside(output);
            Result<ObjFiles> mesh = word_obj(*opened, checked, *run->word, materials.filename().string());
            if (!mesh) return {print_diagnostics(mesh.diagnostics(), sources), read};
            files.push_back({output, std::move(mesh->obj)});
            files.push_back({materials, std::move(mesh->mtl)});
            continue;
        }
        Result<std::string> bytes = encoded(
            run->drawing, output, {command.dpi, command.lean, &document, fs::path(opened->name).stem().string(), job});
        if (!bytes) return {print_diagnostics(bytes.diagnostics(), {}), read};
        files.push_back({output, std::move(*bytes)});
    }
    if (is_cancelled(job)) return {print_diagnostics({cancelled_diagnostic()}, {}), read};
    if (const Diagnostics failed = write_files(files); !failed.empty()) {
        return {print_diagnostics(failed, {}), read};
    }
    if (!command.stats.empty()) {  // after the pictures: how long writing took is part of it
        run->times.write = now_seconds() - drawn;
        run->times.total = now_seconds() - begin;
        const Diagnostics failed = write_files({{command.stats, stats_json(*opened, checked, *run)}});
        if (!failed.empty()) return {print_diagnostics(failed, {}), read};
    }
    clear_progress();
    Diagnostics broken;
    for (const std::string& invariant : run->broken)
        broken.push_back(fault(Fault::internal, "verify.broken", invariant));
    return {print_diagnostics(broken, {}), read};
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
    Diagnostics problems = unknown_formats(command.outputs, true);
    append(problems, same_outputs(targets_of(command)));
    if (!problems.empty()) return print_diagnostics(problems, {});
    const std::unique_ptr<Executor> executor = make_executor(command.threads);
    const Job job = terminal_job();
    if (command.watch) return watch(command, *executor, job);
    return render_once(command, *executor, job).status;
}

}  // namespace filigree
