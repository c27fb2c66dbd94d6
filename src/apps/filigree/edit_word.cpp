// filigree edit: the word of a document, edited; as a document that derives it, where one is asked for.
#include <iostream>

#include "apps/filigree/commands.h"
#include "apps/filigree/output.h"
#include "apps/filigree/terminal.h"
#include "formats/files.h"
#include "session/edit_word.h"
#include "session/list_word.h"

namespace filigree {
namespace {

std::string_view without_blanks_around(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

// "aaa -> b" as "aaa" -> "b" in quotes. Where signs of a word look like an arrow, the one between blanks is it.
Result<std::string> quoted_pair(const std::string& pair) {
    for (const std::string_view arrow : {" -> ", "->"}) {
        const std::size_t at = pair.find(arrow);
        if (at == std::string::npos) continue;
        if (pair.find(arrow, at + arrow.size()) != std::string::npos) break;
        const std::string_view all = pair;
        return quoted_text(without_blanks_around(all.substr(0, at))) + " -> " +
               quoted_text(without_blanks_around(all.substr(at + arrow.size())));
    }
    Diagnostic wrong = fault(Fault::usage, "edit.bad-pair", "'" + pair + "' does not say what is replaced by what");
    wrong.hints.push_back("write it as in 'aaa -> b', with blanks around the arrow");
    return wrong;
}

// As it would stand in a document.
Result<std::string> call_of(const WordEditCommand& command) {
    std::string inside;
    const auto add = [&](const std::string& argument) { inside += (inside.empty() ? "" : ", ") + argument; };
    for (const std::string& pair : command.pairs) {
        const Result<std::string> quoted = quoted_pair(pair);
        if (!quoted) return quoted.diagnostics();
        add(*quoted);
    }
    if (!command.with.empty()) add("with: " + quoted_text(command.with));
    for (const auto& [parameter, value] : command.arguments) add(parameter + ": " + value);
    return command.edit + "(" + inside + ")";
}

// The other document of an edit of two words.
struct OtherWord {
    Result<std::u32string> word = std::u32string();
    Sources sources;
    std::vector<std::filesystem::path> files;
};
OtherWord other_word(const std::filesystem::path& document, const OpenOptions& options, Executor& executor,
                     const Job& job) {
    OtherWord other;
    const Result<OpenedDocument> opened = open_document(document, options);
    if (!opened) {
        other.word = opened.diagnostics();
        return other;
    }
    other.sources = opened->sources;
    other.files = opened->files;
    const CheckedDocument checked = check_document(*opened);
    if (has_errors(checked.diagnostics)) {
        other.word = checked.diagnostics;
    } else if (!checked.words) {
        other.word = fault(Fault::usage, "edit.no-word", "'" + document.string() + "' derives no word");
    } else {
        const Result<rewriting::Derivation> derived = derive_word(*opened, checked, {}, executor, job);
        other.word = derived ? Result(rewriting::letters_of(derived->word, derived->alphabet))
                             : Result<std::u32string>(derived.diagnostics());
    }
    return other;
}

}  // namespace

int run_word_edit(const WordEditCommand& command) {
    const std::unique_ptr<Executor> executor = make_executor(command.threads);
    const Job job = terminal_job();
    const Result<std::string> call = call_of(command);
    if (!call) return print_diagnostics(call.diagnostics(), {});
    const Result<OpenedDocument> opened = open_document(command.document, command.open);
    if (!opened) return print_diagnostics(opened.diagnostics(), {});
    const CheckedDocument checked = check_document(*opened);
    if (const int status = print_diagnostics(checked.diagnostics, opened->sources); status != 0) return status;
    if (!checked.words) {
        return print_diagnostics({fault(Fault::usage, "edit.no-word", "this document derives no word")}, {});
    }
    OtherWord other;
    if (!command.with.empty() && !rewriting::system_of_letter(*checked.words, command.with)) {
        OpenOptions options;
        options.allowed_folders = command.open.allowed_folders;
        other = other_word(command.with, options, *executor, job);
        if (!other.word) return print_diagnostics(other.word.diagnostics(), other.sources);
    }
    std::vector<std::filesystem::path> read = opened->files;
    read.insert(read.end(), other.files.begin(), other.files.end());
    if (!command.output.empty()) {
        Diagnostics problems = overwrites({command.output}, read);
        if (problems.empty()) problems = not_a_document(command.output);
        if (!problems.empty()) return print_diagnostics(problems, {});
    }
    const EditedWord edited = edit_word(
        *opened, checked, *call, command.steps, [&](const std::string&) { return other.word; }, *executor, job);
    if (const int status = print_diagnostics(edited.diagnostics, edited.sources); status != 0) return status;
    if (!command.output.empty()) {
        const Result<std::string> document = document_of_word(*opened, *edited.derivation);
        if (!document) return print_diagnostics(document.diagnostics(), opened->sources);
        const int status = print_diagnostics(write_files({{command.output, *document}}), {});
        if (status != 0) return status;
    }
    if (command.json) {
        std::cout << edited_word_json(*opened, checked, *call, edited);
    } else if (command.output.empty()) {
        std::cout << word_text(*edited.derivation);
    }
    return 0;
}

}  // namespace filigree
