// filigree choices, pick and variations: what was decided in a derivation, what made a shape, what else it could be.
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "apps/filigree/commands.h"
#include "apps/filigree/output.h"
#include "apps/filigree/terminal.h"
#include "base/number_text.h"
#include "formats/files.h"
#include "language/quantity.h"
#include "scene/contact_sheet.h"
#include "session/list_choices.h"
#include "session/pick.h"

namespace filigree {
namespace {

// A document that was opened, checked and run, or the status to end with.
struct Looked {
    int status = 0;
    OpenedDocument opened;
    CheckedDocument checked;
    Run run;
};

std::unique_ptr<Looked> look_at(const std::filesystem::path& document, const OpenOptions& open,
                                const RunOptions& options, Executor& executor, const Job& job) {
    auto looked = std::make_unique<Looked>();
    Result<OpenedDocument> opened = open_document(document, open);
    if (!opened) {
        looked->status = print_diagnostics(opened.diagnostics(), {});
        return looked;
    }
    looked->opened = std::move(*opened);
    looked->checked = check_document(looked->opened);
    looked->status = print_diagnostics(looked->checked.diagnostics, looked->opened.sources);
    if (looked->status != 0) return looked;
    Result<Run> run = run_document(looked->opened, looked->checked, options, executor, job);
    looked->status = print_diagnostics(run ? run->diagnostics : run.diagnostics(), looked->opened.sources);
    if (run) looked->run = std::move(*run);
    return looked;
}

RunOptions listing_choices() {
    RunOptions options;
    options.lists_choices = true;
    return options;
}

}  // namespace

int run_choices(const ChoicesCommand& command) {
    const std::unique_ptr<Executor> executor = make_executor(command.threads);
    const std::unique_ptr<Looked> looked =
        look_at(command.document, command.open, listing_choices(), *executor, terminal_job());
    if (looked->status != 0) return looked->status;
    if (command.output.empty()) {
        list_choices(looked->opened, looked->checked, looked->run, [](std::string_view piece) {
            std::cout.write(piece.data(), static_cast<std::streamsize>(piece.size()));
        });
        return 0;
    }
    if (const auto wrong = overwrites({command.output}, looked->opened.files); !wrong.empty()) {
        return print_diagnostics(wrong, {});
    }
    std::string all;
    list_choices(looked->opened, looked->checked, looked->run, [&](std::string_view piece) { all += piece; });
    return print_diagnostics(write_files({{command.output, std::move(all)}}), {});
}

int run_pick(const PickCommand& command) {
    const std::size_t comma = command.at.find(',');
    const auto x = comma == std::string::npos ? std::nullopt : parse_number(command.at.substr(0, comma));
    const auto y = comma == std::string::npos ? std::nullopt : parse_number(command.at.substr(comma + 1));
    if (!x || !y) {
        return print_diagnostics({fault(Fault::usage, "pick.bad-point", "'" + command.at + "' is no point X,Y")}, {});
    }
    SerialExecutor executor;
    const std::unique_ptr<Looked> looked = look_at(command.document, command.open, {}, executor, terminal_job());
    if (looked->status != 0) return looked->status;
    const Unit unit = looked->opened.document.units.at(0);
    const Vec at{to_px(*x, unit), to_px(*y, unit)};
    if (!is_on_plane(at)) {
        return print_diagnostics({fault(Fault::usage, "pick.bad-point", "the point lies off the plane")}, {});
    }
    const std::optional<Picked> picked = pick(looked->opened, looked->checked, looked->run, at);
    if (command.json) {
        std::cout << (picked ? picked_json(*picked) : "null\n");
    } else {
        std::cout << (picked ? picked_text(*picked) : "nothing is drawn there\n");
    }
    return 0;
}

int run_variations(const VariationsCommand& command) {
    const std::unique_ptr<Executor> executor = make_executor(command.threads);
    const Job job = terminal_job();
    const bool takes_one = command.take != 0;
    if (!takes_one) {
        if (const auto wrong = unknown_formats({command.output}); !wrong.empty()) return print_diagnostics(wrong, {});
    }
    const std::unique_ptr<Looked> looked = look_at(command.document, command.open, listing_choices(), *executor, job);
    if (looked->status != 0) return looked->status;
    if (const auto wrong = overwrites({command.output}, looked->opened.files); !wrong.empty()) {
        return print_diagnostics(wrong, {});
    }
    VariationOptions options = command.options;
    if (takes_one) {
        options.first = command.take;
        options.count = 1;
    }
    const Result<std::vector<Variation>> all = variations(looked->opened, looked->checked, looked->run, options);
    if (!all) return print_diagnostics(all.diagnostics(), {});
    if (takes_one) return print_diagnostics(write_files({{command.output, all->front().text}}), {});

    std::vector<Drawing> drawings;
    std::vector<SheetCell> cells;
    std::vector<bool> is_drawn;
    drawings.reserve(all->size());
    for (const Variation& variation : *all) {
        const OpenedDocument opened = reopened(looked->opened, variation.text);
        const CheckedDocument checked = check_document(opened);
        if (has_errors(checked.diagnostics)) return print_diagnostics(checked.diagnostics, opened.sources);
        RunOptions run_options;
        run_options.previous = &looked->run.tangle;
        Result<Run> run = run_document(opened, checked, run_options, *executor, job);
        const bool is_too_large =
            !run && !is_cancelled(job) && !run.diagnostics().empty() && run.diagnostics().front().fault == Fault::limit;
        if (!run && !is_too_large) return print_diagnostics(run.diagnostics(), opened.sources);
        drawings.push_back(run ? std::move(run->drawing) : Drawing());
        cells.push_back({nullptr, variation.label + (run ? "" : "  (over a limit)")});
        is_drawn.push_back(static_cast<bool>(run));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (is_drawn[i]) cells[i].drawing = &drawings[i];
    }
    SheetOptions sheet;
    sheet.title = looked->opened.name;
    const Drawing drawing = contact_sheet(cells, sheet);
    Result<std::string> bytes =
        encoded(drawing, command.output, {command.dpi, false, nullptr, looked->opened.name, job});
    if (!bytes) return print_diagnostics(bytes.diagnostics(), {});
    return print_diagnostics(write_files({{command.output, std::move(*bytes)}}), {});
}

}  // namespace filigree
