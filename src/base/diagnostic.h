// Diagnostics: what is wrong with a document or an input, as data.
//
// A diagnostic says where, what was found and what was expected, and what would mend it. A phase
// reports as many as it can find; warnings travel beside a success (result.h). Messages are in lower
// case, one sentence without a full stop; codes are `area.kebab-case` and never change meaning.
//
//   leaf.fil:6:1: error: there is no operator 'regularSpilt' [tangle.unknown-operator]
//       regularSpilt(line, 90, dual) : in -> quads
//       ^~~~~~~~~~~~
//     hint: did you mean 'regularSplit'?
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filigree {

// A half-open range of bytes in one source text. `file` indexes Sources; `no_file` means "nowhere".
struct SourceSpan {
    static constexpr std::uint32_t no_file = UINT32_MAX;
    std::uint32_t file = no_file;
    std::uint32_t begin = 0;  // byte offset, 0-based
    std::uint32_t end = 0;    // one past the last byte; equal to begin for a place between characters

    bool operator==(const SourceSpan&) const = default;
};

// The smallest span that holds both; they must lie in the same file.
SourceSpan span_over(SourceSpan first, SourceSpan last);

// One text that diagnostics may point into: a document, an included file, an SVG.
struct SourceFile {
    std::string name;  // as the user wrote it, for messages
    std::string text;  // the bytes, untouched
};
using Sources = std::vector<SourceFile>;

enum class Severity { warning, error };

// Whose fault an error is; it decides the exit status of the command line.
enum class Fault {
    document,  // the document or an input file is wrong (exit 1)
    usage,     // wrong usage of a command (exit 2)
    file,      // a file could not be read or written (exit 3)
    limit,     // a limit was reached or the work was cancelled (exit 4)
    internal,  // one of our own invariants is broken (exit 5)
};

struct Diagnostic {
    Severity severity = Severity::error;
    std::string code;                // "language.unknown-name"
    std::string message;             // "there is no operator 'regularSpilt'"
    SourceSpan span;                 // where; no_file if it has no place
    std::vector<std::string> hints;  // "did you mean 'regularSplit'?"
    Fault fault = Fault::document;

    bool operator==(const Diagnostic&) const = default;
};
using Diagnostics = std::vector<Diagnostic>;

Diagnostic error(std::string code, std::string message, SourceSpan span = {}, std::vector<std::string> hints = {});
Diagnostic warning(std::string code, std::string message, SourceSpan span = {}, std::vector<std::string> hints = {});
Diagnostic fault(Fault kind, std::string code, std::string message, SourceSpan span = {});

bool has_errors(const Diagnostics& diagnostics);
void append(Diagnostics& to, Diagnostics from);

// The place of a byte offset, as people count: both from 1; columns count code points (a byte that is
// no part of valid UTF-8 counts as one).
struct LineColumn {
    std::uint32_t line = 1;
    std::uint32_t column = 1;

    bool operator==(const LineColumn&) const = default;
};
LineColumn line_column(std::string_view text, std::uint32_t offset);

// As printed to a terminal: the head line, the source line with a marker under the span, the hints.
// Ends with a newline. Control characters of the source are shown as '?', long lines are cut around the span.
std::string to_text(const Diagnostic& diagnostic, const Sources& sources);

// All of them, in the order of files and places (stable for equal places), each once.
std::string to_text(const Diagnostics& diagnostics, const Sources& sources);

// The candidate nearest to `wanted` by edit distance (case-blind, transpositions count once), or an empty
// view where none is near enough to be what was meant. Ties go to the earlier candidate.
std::string_view nearest_name(std::string_view wanted, const std::vector<std::string_view>& candidates);

// "did you mean 'x'?" as a list of hints: one, or none where nothing is near.
std::vector<std::string> did_you_mean(std::string_view wanted, const std::vector<std::string_view>& candidates);

}  // namespace filigree
