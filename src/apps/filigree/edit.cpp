// filigree set, keep, reroll and apply: one document in, the edited document out.
#include <iostream>
#include <nlohmann/json.hpp>

#include "apps/filigree/commands.h"
#include "apps/filigree/output.h"
#include "apps/filigree/terminal.h"
#include "formats/files.h"
#include "session/check.h"

namespace filigree {
namespace {

// A document is written over itself, but never over a file that it reads, nor over a drawing that carries it with
// those.
Diagnostics output_problems(const EditCommand& command, const OpenedDocument& opened) {
    if (command.output.empty()) return {};
    std::vector<std::filesystem::path> read = opened.files;
    if (!opened.carries_inputs && !read.empty()) read.erase(read.begin());
    Diagnostics problems = overwrites({command.output}, read);
    if (problems.empty()) problems = not_a_document(command.output);
    return problems;
}

}  // namespace

int run_edit(const EditCommand& command) {
    Result<OpenedDocument> opened = open_document(command.document, command.open);
    if (!opened) return print_diagnostics(opened.diagnostics(), {});
    const CheckedDocument checked = check_document(*opened);
    if (has_errors(checked.diagnostics)) return print_diagnostics(checked.diagnostics, opened->sources);
    if (const Diagnostics problems = output_problems(command, *opened); !problems.empty()) {
        return print_diagnostics(problems, {});
    }
    nlohmann::ordered_json done = nlohmann::ordered_json::array();
    OpenedDocument document = std::move(*opened);
    for (const DocumentEdit& edit : command.edits) {
        Result<OpenedDocument> next = edited(document, edit);
        if (!next) return print_diagnostics(next.diagnostics(), {});
        document = std::move(*next);
        done.push_back(to_text(edit));
    }
    const std::string& text = document.document.text();
    if (!command.output.empty()) {
        const int status = print_diagnostics(write_files({{command.output, text}}), {});
        if (status != 0) return status;
    }
    if (command.json) {
        nlohmann::ordered_json json;
        json["document"] = document.name;
        json["edits"] = std::move(done);
        json["text"] = text;
        std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
    } else if (command.output.empty()) {
        std::cout << text;
    }
    return 0;
}

}  // namespace filigree
