// Text to document. Every problem is reported, not only the first: a broken statement gives one error and is
// skipped to its end.
//
// Guarantees: never throws for any input; every diagnostic has a code of the area `language` (or what the
// include loader gave) and a span inside its text; a span of the document's parts covers their bytes exactly.
// Time and memory are linear in the texts. Refused: text that is no valid UTF-8, and what is beyond the bounds
// below, which keep every later walk over an expression within a small stack.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "language/document.h"

namespace filigree {

// The text of an included file by the name in the document, or why there is none (a diagnostic without span;
// the parser adds the place of the `include`).
using IncludeLoader = std::function<Result<std::string>(std::string_view name)>;

struct Parsed {
    Document document;        // what could be understood; complete if there are no errors
    Diagnostics diagnostics;  // errors and warnings
};

// Parses a document and what it includes: each file once at most; a cycle is an error. Of an included file the
// statements filigree, grammar, seed, unit, page, start and limit are checked and left out; its lengths keep
// its own unit. Without a loader an `include` is an error.
Parsed parse_document(std::string_view name, std::string_view text, const IncludeLoader& include);

// One part of a statement and nothing else. Spans point into source `file`, whose text is `text`.
Result<ExpressionPtr> parse_expression(std::string_view text, std::uint32_t file = SourceSpan::no_file);
Result<ChoicePath> parse_path(std::string_view text, std::uint32_t file = SourceSpan::no_file);

// What `apply` and rules have in common: [NAME =] operator(arguments), and tags with or without brackets.
struct OperatorCall {
    std::optional<Name> name;
    Name operator_name;
    std::vector<CallArgument> arguments;
    SourceSpan span;
};
Result<OperatorCall> parse_call(std::string_view text, std::uint32_t file = SourceSpan::no_file);
// An edit of a word: insert("T+", at: "a"). A pair, as in compress("aaa" -> "b"), is an argument whose key is a text.
Result<OperatorCall> parse_edit_call(std::string_view text, std::uint32_t file = SourceSpan::no_file);
Result<std::vector<OutputTag>> parse_outputs(std::string_view text, std::uint32_t file = SourceSpan::no_file);

// PATH=VALUE as a command line gives it, both without blanks around and neither read: split at the first '=' outside
// brackets and quotes that is no part of '==', '<=', '>=' or '!='. Errors are of the kind Fault::usage.
struct Assignment {
    std::string path, value;
};
Result<Assignment> split_assignment(std::string_view text);

constexpr std::size_t max_document_bytes = 64U << 20;  // of a document and what it includes, together
constexpr int max_nesting = 200;                       // brackets, and `?` inside `?`, within each other
constexpr int max_expression_height = 500;             // of an expression's tree, as in a chain of so many signs
constexpr std::size_t max_name_bytes = 1000;           // of one name or tag
constexpr std::size_t max_include_depth = 32;          // files that include each other
constexpr std::size_t max_system_depth = 32;           // systems inside each other
constexpr std::uint32_t max_rerolls = 1'000'000'000;   // the N of `reroll PATH x N`
constexpr std::size_t max_diagnostics = 1000;          // after so many, one last error says so

}  // namespace filigree
