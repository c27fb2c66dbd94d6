// Any bytes as a document: parsing and editing never crash, never hang, and keep their promises.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

#include "language/choice_path.h"
#include "language/edit.h"
#include "language/edit_presets.h"
#include "language/parse.h"

namespace {

using namespace filigree;

void require(bool holds, std::string_view promise) {
    if (holds) return;
    std::cerr << "broken promise: " << promise << "\n";
    std::abort();
}

// Files that a document may include: one with everything, one wrong, and a circle.
Result<std::string> include(std::string_view name) {
    if (name == "a.fil") return std::string("unit mm\nseed 5\nlet included = 3mm\ninclude \"b.fil\"\n");
    if (name == "b.fil") return std::string("style leaf { fill: #a03 }\ninclude \"a.fil\"\n");
    if (name == "c.fil") return std::string("let = (\n");
    return error("files.missing", "there is no such file");
}

void check_spans(const Parsed& parsed) {
    for (const Diagnostic& diagnostic : parsed.diagnostics) {
        require(!diagnostic.code.empty() && !diagnostic.message.empty(), "a diagnostic has a code and a message");
        require(diagnostic.span.file < parsed.document.sources.size(), "a diagnostic has a file");
        const std::string& text = parsed.document.sources[diagnostic.span.file].text;
        require(diagnostic.span.begin <= diagnostic.span.end && diagnostic.span.end <= text.size(),
                "a diagnostic's span lies in its text");
    }
    for (const Statement& statement : parsed.document.statements) {
        require(statement.span.begin < statement.span.end &&
                    statement.span.end <= parsed.document.sources.at(statement.span.file).text.size(),
                "a statement's span lies in its text");
    }
    require(!to_text(parsed.diagnostics, parsed.document.sources).empty() || parsed.diagnostics.empty(),
            "diagnostics can be printed");
}

void check_edits(const Document& document) {
    const Parsed seeded = parse_document("fuzz.fil", with_seed(document, 7), include);
    require(seeded.diagnostics.empty(), "a document with another seed is right");
    std::size_t seeds = 0;
    for (const Statement& statement : seeded.document.statements) {
        const SeedStatement* seed = std::get_if<SeedStatement>(&statement.node);
        if (seed == nullptr) continue;
        ++seeds;
        require(seed->seed == 7, "the seed is the new one");
    }
    require(seeds == 1, "there is one seed");
    for (const Statement& statement : document.statements) {
        const ParamStatement* param = std::get_if<ParamStatement>(&statement.node);
        if (param == nullptr || param->name.span.file != 0) continue;
        const Result<std::string> text = with_parameter(document, param->name.text, "a ? 3 : 2mm in 1..5");
        if (!text) continue;
        const Parsed edited = parse_document("fuzz.fil", *text, include);
        require(edited.diagnostics.empty(), "a document with another parameter is right");
        require(edited.document.statements.size() == document.statements.size(), "an edit keeps the statements");
        break;
    }
}

// What is said of places of the derivation can be added to every right document.
void check_preset_edits(const Document& document) {
    const auto adds = [&](const Result<std::string>& text, std::string_view promise) {
        require(static_cast<bool>(text), promise);
        const Parsed edited = parse_document("fuzz.fil", *text, include);
        require(edited.diagnostics.empty(), promise);
    };
    adds(with_preset(document, "a/b[2]/**/c.size", "one_of(3, 5..9)"), "a `set` can be added");
    adds(with_default(document, "**.size~2", "4"), "a `default` can be added");
    adds(with_keep(document, "a/b#2"), "a `keep` can be added");
    adds(with_reroll(document, "a/*/b", 3), "a `reroll` can be added");
    adds(with_apply(document, "rim = outline(5)", {"a/b", "a/b/2,3"}, "in, <>"), "an `apply` can be added");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const Parsed parsed = parse_document("fuzz.fil", text, include);
    require(parsed.document.text() == text || size > max_document_bytes, "the text is untouched");
    require(parsed.document.units.size() == parsed.document.sources.size(), "every source has a unit");
    check_spans(parsed);
    if (parsed.diagnostics.empty()) {
        check_edits(parsed.document);
        check_preset_edits(parsed.document);
    }
    const Result<ChoicePath> path = parse_path(text);
    if (path) {
        const Result<ChoicePath> again = parse_path(to_text(*path));
        require(again && same_path(*path, *again), "a path's text says the same");
    }
    const Result<ExpressionPtr> expression = parse_expression(text);
    require(expression ? same_meaning(**expression, **parse_expression(text)) : has_errors(expression.diagnostics()),
            "an expression is read or an error says why not");
    return 0;
}
