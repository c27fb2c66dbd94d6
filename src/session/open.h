// Opening a document: its text, with the edits of the command line written in, and every file that it reads.
//
// A document is a `.fil` file, or an SVG that carries one. It reads only files below its own folder, or below
// folders that the caller allows. What comes out is the effective document: carried inside an export, it
// gives the same bytes again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "derivation/inputs.h"
#include "formats/svg_write.h"
#include "language/document.h"

namespace filigree {

struct OpenOptions {
    std::optional<std::uint64_t> seed;                          // --seed
    std::vector<std::pair<std::string, std::string>> settings;  // --set NAME=VALUE, in order
    std::vector<std::filesystem::path> allowed_folders;         // --allow
};

struct OpenedDocument {
    std::string name;                          // as it is carried: the file's own name
    Document document;                         // parsed from the effective text
    Inputs inputs;                             // all files it read, in the order of their mention
    Diagnostics diagnostics;                   // errors of the language, and warnings
    std::vector<std::filesystem::path> files;  // on disk: the document first; what --watch looks at
};

// Fails only where there is no text at all (Fault::file, or a damaged SVG); errors of the text are in
// OpenedDocument::diagnostics, beside what could be understood.
Result<OpenedDocument> open_document(const std::filesystem::path& file, const OpenOptions& options);

// The same for a text in memory, with its inputs given.
OpenedDocument open_text(std::string name, std::string text, Inputs inputs);

CarriedDocument carried(const OpenedDocument& opened);

}  // namespace filigree
