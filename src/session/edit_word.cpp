#include "session/edit_word.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engines/rewriting/read_edit.h"
#include "language/edit_text.h"
#include "language/parse.h"

namespace filigree {
namespace {

// The statements that say which word a document derives.
struct WordStatements {
    const ExpressionPtr* axiom = nullptr;
    std::vector<SourceSpan> dropped;  // iterations and edits
};

Result<WordStatements> find_word_statements(const Document& document) {
    WordStatements found;
    for (const Statement& statement : document.statements) {
        const auto* setting = std::get_if<SettingStatement>(&statement.node);
        const bool is_axiom = setting != nullptr && setting->name.text == "axiom";
        const bool is_dropped = std::holds_alternative<WordEditStatement>(statement.node) ||
                                (setting != nullptr && setting->name.text == "iterations");
        if (!is_axiom && !is_dropped) continue;
        if (statement.span.file != 0) {
            return error("edit.included-word", "this stands in an included file, which is not rewritten",
                         statement.span, {"axiom, iterations and edits must stand in the document itself"});
        }
        if (is_axiom) found.axiom = &setting->values[0];
        if (is_dropped) found.dropped.push_back(statement.span);
    }
    return found;
}

}  // namespace

std::string quoted_text(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + "\"";
}

EditedWord edit_word(const OpenedDocument& opened, const CheckedDocument& checked, const std::string& call,
                     std::optional<std::uint64_t> steps, const rewriting::OtherDocument& other, Executor& executor,
                     const Job& job) {
    EditedWord edited;
    // The call is one text more of the document.
    Document document = opened.document;
    const auto file = static_cast<std::uint32_t>(document.sources.size());
    document.sources.push_back({"edit", call});
    document.units.push_back(document.units.at(0));
    edited.sources = document.sources;
    const Result<OperatorCall> parsed = parse_edit_call(call, file);
    if (!parsed) {
        edited.diagnostics = parsed.diagnostics();
        return edited;
    }
    const Result<rewriting::WordEdit> edit = rewriting::read_edit(
        {parsed->operator_name, parsed->arguments, parsed->span}, *checked.words, document, checked.settings->globals);
    edited.diagnostics = edit.diagnostics();
    if (!edit) return edited;
    Result<rewriting::Derivation> derivation =
        derive_word(opened, checked, {steps, {}, UINT64_MAX, rewriting::asks_for_ages(*edit)}, executor, job);
    if (!derivation) {
        edited.diagnostics = derivation.diagnostics();
        edited.sources = opened.sources;
        return edited;
    }
    append(edited.diagnostics, derivation.diagnostics());
    rewriting::DeriveOptions options = word_options(opened, checked);
    options.document = &document;
    Result<rewriting::EditReport> report =
        rewriting::apply_edit(*derivation, *edit, *checked.words, options, other, job);
    append(edited.diagnostics, report.diagnostics());
    if (!report) return edited;
    edited.report = std::move(*report);
    edited.derivation = std::move(*derivation);
    return edited;
}

std::string edited_word_json(const OpenedDocument& opened, const CheckedDocument& checked, const std::string& call,
                             const EditedWord& edited) {
    using Json = nlohmann::ordered_json;
    const rewriting::EditReport& report = edited.report;
    Json json;
    json["document"] = opened.name;
    json["engine"] = checked.settings->engine;
    json["seed"] = checked.settings->seed;
    json["iteration"] = edited.derivation->iteration;
    json["edit"] = call;
    json["symbols"] = {{"before", report.before},
                       {"removed", report.before - report.kept},
                       {"added", report.after - report.kept},
                       {"after", report.after}};
    if (report.passes > 0) json["chunks"] = {{"replaced", report.replaced}, {"passes", report.passes}};
    json["changes"] = report.changes;
    if (!report.other.empty()) json["other"] = rewriting::to_utf8(report.other);
    json["word"] = rewriting::to_text(edited.derivation->word, edited.derivation->alphabet);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<std::string> document_of_word(const OpenedDocument& opened, const rewriting::Derivation& derivation) {
    Result<WordStatements> found = find_word_statements(opened.document);
    if (!found) return std::move(found).diagnostics();
    const std::string word = rewriting::to_text(derivation.word, derivation.alphabet);
    // From the end, so that the places before hold.
    std::string text = opened.document.text();
    const SourceSpan axiom = (*found->axiom)->span;
    std::vector<SourceSpan> places = found->dropped;
    places.push_back(axiom);
    std::sort(places.begin(), places.end(), [](SourceSpan a, SourceSpan b) { return a.begin > b.begin; });
    for (const SourceSpan place : places) {
        text = place == axiom ? spliced(text, place.begin, place.end, quoted_text(word))
                              : without_statement(text, place.begin, place.end);
    }
    const OpenedDocument again = reopened(opened, text);
    const CheckedDocument checked = check_document(again);
    if (has_errors(checked.diagnostics)) {
        return error("edit.unwritable-word",
                     "a document with this word for its axiom would be wrong: " + checked.diagnostics.front().message);
    }
    const Result<rewriting::Derivation> derived = rewriting::begin(*checked.words, word_options(again, checked));
    if (!derived || rewriting::to_text(derived->word, derived->alphabet) != word) {
        return error("edit.unwritable-word", "as an axiom, this word would be read as another one", {},
                     {"{ and } repeat, and ~n is \u00F1; 'free' makes ordinary letters of { and }"});
    }
    return text;
}

}  // namespace filigree
