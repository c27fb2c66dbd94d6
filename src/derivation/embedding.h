// Embedding: a document derived inside a shape of another one (docs/language.md, "Documents inside documents").
//
// Engines know nothing of each other: who runs a derivation hands the engine a function that derives an embedded
// document, and gets back a drawing in the host's coordinates with what is needed to trace its parts.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "base/result.h"
#include "language/preset_walk.h"
#include "plane/polygon.h"
#include "scene/drawing.h"

namespace filigree {

constexpr std::uint32_t max_embedding_depth = 16;

// What was derived, for whoever asked for it: the session knows the engine.
struct EmbeddedRun {
    virtual ~EmbeddedRun() = default;
};

// Immutable, so that derivations of the same document share it.
struct Embedded {
    Drawing drawing;  // in the host's coordinates
    std::shared_ptr<const EmbeddedRun> run;
    std::uint64_t elements = 0;  // shapes, symbols, ... that it made
    std::uint64_t memory_bytes = 0;
    std::vector<std::uint8_t> met;  // of each preset of the documents around it: whether it met something inside
};

struct EmbedRequest {
    std::string_view document;  // a system's name or a file's
    bool is_file = false;
    PolygonView host;
    DocumentSite site;
    std::uint64_t element_budget = 0;
};
// Null where the shape is too small for the document. Must be safe to call from several threads at a time.
using EmbedFunction = std::function<Result<std::shared_ptr<const Embedded>>(const EmbedRequest& request)>;

// What a grammar may embed, for checking: by the name that `embed` uses.
struct EmbeddableDocument {
    std::string name;
    bool is_file = false;                 // embed("name"), else embed(name)
    std::vector<std::string> parameters;  // that may be given by name
    std::vector<std::string> required;    // those of them that must be given
    std::string fingerprint;              // differs where the document, or a file that it reads, differs
};
using EmbeddableDocuments = std::vector<EmbeddableDocument>;

}  // namespace filigree
