// filigree check, derive, list and describe: what a document and the language hold, without a picture.
#include <iostream>

#include "apps/filigree/commands.h"
#include "apps/filigree/terminal.h"
#include "base/number_text.h"
#include "session/describe.h"
#include "session/explain_word.h"
#include "session/list_design.h"
#include "session/list_steps.h"
#include "session/list_word.h"
#include "session/run.h"
#include "session/stats.h"

namespace filigree {
namespace {

WordQuestion question_of(const DeriveCommand& command) {
    WordQuestion question;
    if (command.counts) question.kind = WordQuestion::Kind::counts;
    if (command.slice.empty()) return question;
    question.kind = WordQuestion::Kind::slice;
    const std::size_t colon = command.slice.find(':');
    if (colon == std::string::npos) return question;
    const std::optional<double> count = parse_number(command.slice.substr(colon + 1));
    if (!count || !(*count >= 0 && *count < 1e18)) return question;
    question.first = command.slice.substr(0, colon);
    question.count = static_cast<std::uint64_t>(*count);
    return question;
}

}  // namespace

int run_check(const CheckCommand& command) {
    const Result<OpenedDocument> opened = open_document(command.document, command.open);
    if (!opened) return print_diagnostics(opened.diagnostics(), {});
    const CheckedDocument checked = check_document(*opened);
    if (command.json) {
        std::cout << check_json(*opened, checked);
        return exit_status(checked.diagnostics);
    }
    std::cout << check_text(checked, opened->document) << std::flush;
    return print_diagnostics(checked.diagnostics, opened->sources);
}

int run_derive(const DeriveCommand& command) {
    const std::unique_ptr<Executor> executor = make_executor(command.threads);
    const Job job = terminal_job();
    const Result<OpenedDocument> opened = open_document(command.document, command.open);
    if (!opened) return print_diagnostics(opened.diagnostics(), {});
    const Sources& sources = opened->sources;
    const CheckedDocument checked = check_document(*opened);
    if (const int status = print_diagnostics(checked.diagnostics, sources); status != 0) return status;
    const bool asks = command.length || command.counts || !command.slice.empty() || command.explain;
    if (asks && !checked.words) {
        return print_diagnostics({fault(Fault::usage, "derive.no-word", "this document derives no word")}, {});
    }
    if (asks) {
        const Result<std::string> answered =
            command.explain ? explain_word(*opened, checked, command.steps, *command.explain, command.json, job)
                            : answer(*opened, checked, command.steps, question_of(command));
        if (answered) std::cout << *answered;
        return print_diagnostics(answered.diagnostics(), sources);
    }
    if (checked.words) {
        const Result<rewriting::Derivation> word = derive_word(*opened, checked, {command.steps, {}}, *executor, job);
        const int status = print_diagnostics(word.diagnostics(), sources);
        if (word) std::cout << (command.json ? word_json(*opened, checked, *word) : word_text(*word));
        return status;
    }
    if (checked.design) {
        const Result<shape::Derivation> design = derive_design(*opened, checked, {command.steps, {}}, job);
        const int status = print_diagnostics(design.diagnostics(), sources);
        if (design) {
            std::cout << (command.json ? design_json(*opened, checked, *design)
                                       : design_text(*opened, checked, *design));
        }
        return status;
    }
    RunOptions options;
    options.steps = command.steps;
    const Result<tangle::Tangle> tangle = derive_document(*opened, checked, options, *executor, job);
    const int status = print_diagnostics(tangle.diagnostics(), sources);
    if (!tangle) return status;
    std::cout << (command.json ? steps_json(*opened, checked, *tangle) : steps_text(*opened, checked, *tangle));
    return status;
}

int run_list() {
    std::cout << list_text();
    return 0;
}

int run_describe(const DescribeCommand& command) {
    if (command.markdown) {
        std::cout << reference_markdown();
        return 0;
    }
    if (command.json) {
        std::cout << descriptions_json();
        return 0;
    }
    const Result<std::string> page = describe_text(command.name);
    if (!page) return print_diagnostics(page.diagnostics(), {});
    std::cout << *page;
    return 0;
}

}  // namespace filigree
