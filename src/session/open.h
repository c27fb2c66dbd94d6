// Opening a document: its text, with the edits of the command line written in, every file that it reads, and the
// documents that it embeds.
//
// A document is a `.fil` file, or an SVG that carries one. It reads only files below its own folder, or below
// folders that the caller allows. What comes out is the effective document: carried inside an export, it
// gives the same bytes again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "derivation/embedding.h"
#include "derivation/inputs.h"
#include "formats/svg_write.h"
#include "language/document.h"

namespace filigree {

struct OpenOptions {
    std::optional<std::uint64_t> seed;                          // --seed
    std::vector<std::pair<std::string, std::string>> settings;  // --set PATH=VALUE, in order
    std::vector<std::filesystem::path> allowed_folders;         // --allow
    std::string choices;  // --choices: what `list_choices` wrote, to be taken instead of drawing; empty: none
};

struct OpenedDocument;

// What `embed` may name: a system, or another file. Each is opened once, however many ways lead to it.
struct EmbeddedDocument {
    EmbeddableDocument info;
    std::shared_ptr<const OpenedDocument> opened;  // null where it could not be opened, which is reported
};

struct OpenedDocument {
    std::string name;                          // as it is carried: the file's own name; a system's name
    Document document;                         // parsed from the effective text
    Inputs inputs;                             // all files it read, under the names that it uses for them
    Diagnostics diagnostics;                   // errors of the language, and warnings; of embedded documents too
    std::vector<std::filesystem::path> files;  // on disk: the document first; what --watch looks at
    std::string choices;                       // as in OpenOptions; an SVG carries them on
    std::vector<EmbeddedDocument> embedded;    // its systems and those around it; the files that its rules embed
    std::vector<std::filesystem::path> allowed_folders;  // beside its own, as it was opened
    std::filesystem::path folder;                        // where its files are looked up
    bool carries_inputs = false;                         // they came with it: nothing is looked up
    // All texts that diagnostics may point into: its own, then those of the files that it embeds.
    Sources sources;
    std::uint32_t first_source = 0;  // of its own among those of the document that is opened
    SourceSpan place;                // what is said of it as a whole: a system's name, a file's beginning; else nowhere
    bool has_failed = false;  // whether an error was found in its own text or files; it stands with the outermost's
};

// A span or diagnostics of an embedded document, as places of `OpenedDocument::sources` of the outermost one.
Diagnostics at_first_source(Diagnostics diagnostics, const OpenedDocument& opened);

// Fails only where there is no text at all (Fault::file, or a damaged SVG); errors of the text are in
// OpenedDocument::diagnostics, beside what could be understood.
Result<OpenedDocument> open_document(const std::filesystem::path& file, const OpenOptions& options);

// The same for a text in memory, with its inputs given.
OpenedDocument open_text(std::string name, std::string text, Inputs inputs);

// The document with another text, as an edit makes it; files are read where `opened` read them.
OpenedDocument reopened(const OpenedDocument& opened, std::string text);

CarriedDocument carried(const OpenedDocument& opened);

}  // namespace filigree
