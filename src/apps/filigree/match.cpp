// filigree match, step and designs: where the rules of a shape grammar apply, a match that is chosen, and all designs
// to a depth.
#include <iostream>

#include "apps/filigree/commands.h"
#include "apps/filigree/output.h"
#include "apps/filigree/terminal.h"
#include "base/number_text.h"
#include "formats/files.h"
#include "language/quantity.h"
#include "session/list_design.h"
#include "session/list_matches.h"

namespace filigree {
namespace {

// "X,Y" in the document's unit as px.
std::optional<Vec> place_of(const std::string& text, const Document& document) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) return std::nullopt;
    const std::optional<double> x = parse_number(text.substr(0, comma)), y = parse_number(text.substr(comma + 1));
    if (!x || !y) return std::nullopt;
    const Unit unit = unit_of(document);
    return Vec{to_px(*x, unit), to_px(*y, unit)};
}

// A shape document that is opened and checked, or the exit status.
struct ShapeDocument {
    Result<OpenedDocument> opened;
    CheckedDocument checked;
    int status = 0;
};
ShapeDocument open_shape(const std::filesystem::path& file, const OpenOptions& options) {
    ShapeDocument document{open_document(file, options), {}, 0};
    if (!document.opened) {
        document.status = print_diagnostics(document.opened.diagnostics(), {});
        return document;
    }
    document.checked = check_document(*document.opened);
    document.status = print_diagnostics(document.checked.diagnostics, document.opened->sources);
    if (document.status == 0 && !document.checked.design) {
        document.status = print_diagnostics(
            {fault(Fault::usage, "match.no-shapes", "this document is no shape grammar, so its rules match no shapes")},
            {});
    }
    return document;
}

Result<MatchQuestion> question_of(const std::string& rule, const std::string& at,
                                  const std::optional<std::uint64_t>& steps, const OpenedDocument& opened) {
    MatchQuestion question;
    question.rule = rule;
    question.steps = steps;
    if (!at.empty()) {
        question.at = place_of(at, opened.document);
        if (!question.at) return fault(Fault::usage, "match.bad-place", "a place is written X,Y, not '" + at + "'");
    }
    return question;
}

int write_drawing(const Result<Drawing>& drawing, const std::filesystem::path& output, const ShapeDocument& document,
                  double dpi) {
    if (!drawing) return print_diagnostics(drawing.diagnostics(), document.opened->sources);
    Result<std::string> bytes = encoded(*drawing, output, {dpi, false, nullptr, document.opened->name});
    if (!bytes) return print_diagnostics(bytes.diagnostics(), {});
    return print_diagnostics(write_files({{output, std::move(*bytes)}}), {});
}

// What is wrong with a drawing's target, as an exit status.
int check_output(const std::filesystem::path& output, const OpenedDocument& opened) {
    if (output.empty()) return 0;
    if (const Diagnostics wrong = unknown_formats({output}); !wrong.empty()) return print_diagnostics(wrong, {});
    return print_diagnostics(overwrites({output}, opened.files), {});
}

}  // namespace

int run_match(const MatchCommand& command) {
    const Job job = terminal_job();
    const ShapeDocument document = open_shape(command.document, command.open);
    if (document.status != 0) return document.status;
    const OpenedDocument& opened = *document.opened;
    if (const int status = check_output(command.output, opened); status != 0) return status;
    Result<MatchQuestion> question = question_of(command.rule, command.at, command.steps, opened);
    if (!question) return print_diagnostics(question.diagnostics(), {});
    question->by_hand_alone = command.by_hand;
    const Result<FoundMatches> found = find_matches(opened, document.checked, *question, job);
    if (!found) return print_diagnostics(found.diagnostics(), opened.sources);
    if (command.explain) {
        const Result<std::string> why = explain_match(opened, document.checked, *question, *found, command.json);
        if (why) std::cout << *why;
        return print_diagnostics(why.diagnostics(), opened.sources);
    }
    if (!command.output.empty()) {
        std::vector<shape::Application> shown;
        for (const shape::Applications& here : found->of_rules) {
            for (const shape::Application& at : here.all) {
                if (at.variant == 0) shown.push_back(at);
            }
        }
        const Result<Drawing> drawing =
            shape::draw_matches(found->derivation, *document.checked.design, surroundings_of(opened, document.checked),
                                shown, {{}, {job.cancel_flag, {}}});
        if (const int status = write_drawing(drawing, command.output, document, command.dpi); status != 0)
            return status;
    }
    std::cout << (command.json ? matches_json(opened, document.checked, *found)
                               : matches_text(opened, document.checked, *found));
    return 0;
}

int run_step(const StepCommand& command) {
    const Job job = terminal_job();
    const ShapeDocument document = open_shape(command.document, command.open);
    if (document.status != 0) return document.status;
    const OpenedDocument& opened = *document.opened;
    if (!command.output.empty()) {
        std::vector<std::filesystem::path> read = opened.files;
        if (!opened.carries_inputs && !read.empty()) read.erase(read.begin());
        Diagnostics problems = overwrites({command.output}, read);
        if (problems.empty()) problems = not_a_document(command.output);
        if (!problems.empty()) return print_diagnostics(problems, {});
    }
    if (document.checked.design->steps > 0 && !command.by_hand) {
        Diagnostic late =
            fault(Fault::usage, "step.after-the-machine", "steps by hand come before those of the machine ('steps')");
        late.hints = {"give --by-hand, to `match`, too: it lists what applies before them"};
        return print_diagnostics({late}, {});
    }
    Result<MatchQuestion> question = question_of(command.rule, {}, {}, opened);
    question->by_hand_alone = true;
    const Result<FoundMatches> found = find_matches(opened, document.checked, *question, job);
    if (!found) return print_diagnostics(found.diagnostics(), opened.sources);
    const Result<std::string> text = with_step(opened, document.checked, *found, command.match, command.orbit);
    if (!text) return print_diagnostics(text.diagnostics(), opened.sources);
    if (command.output.empty()) {
        std::cout << *text;
        return 0;
    }
    return print_diagnostics(write_files({{command.output, *text}}), {});
}

int run_designs(const DesignsCommand& command) {
    const Job job = terminal_job();
    const ShapeDocument document = open_shape(command.document, command.open);
    if (document.status != 0) return document.status;
    const OpenedDocument& opened = *document.opened;
    if (const int status = check_output(command.output, opened); status != 0) return status;
    shape::EnumerateOptions options;
    options.depth = command.depth;
    options.most = command.most;
    options.up_to = command.up_to == "translation"  ? curves::UpTo::translation
                    : command.up_to == "isometry"   ? curves::UpTo::isometry
                    : command.up_to == "similarity" ? curves::UpTo::similarity
                                                    : curves::UpTo::nothing;
    const Result<shape::FoundDesigns> found = find_designs(opened, document.checked, options, job);
    if (!found) return print_diagnostics(found.diagnostics(), opened.sources);
    if (!command.output.empty()) {
        std::vector<curves::Shape> designs;
        std::vector<std::string> labels;
        for (std::size_t d = 0; d < found->all.size(); ++d) {
            designs.push_back(found->all[d].design);
            labels.push_back(std::to_string(d));
        }
        const Result<Drawing> sheet =
            shape::draw_sheet(designs, labels, *document.checked.design, surroundings_of(opened, document.checked), 0,
                              {{}, {job.cancel_flag, {}}});
        if (const int status = write_drawing(sheet, command.output, document, command.dpi); status != 0) return status;
    }
    std::cout << (command.json ? designs_json(opened, document.checked, *found)
                               : designs_text(document.checked, *found));
    return 0;
}

}  // namespace filigree
