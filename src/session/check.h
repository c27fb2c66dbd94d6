// Checking a document: everything that can be known to be wrong before anything is derived, and the
// grammar's graph (gTangle, section 5), which is there even beside errors.
#pragma once

#include <memory>
#include <optional>

#include "derivation/plane_start.h"
#include "engines/rewriting/draw_rules.h"
#include "engines/rewriting/grammar.h"
#include "engines/shape/grammar.h"
#include "engines/tangle/grammar.h"
#include "engines/tangle/graph.h"
#include "language/settings.h"
#include "session/open.h"

namespace filigree {

struct CheckedDocument {
    std::optional<Settings> settings;                // none where they could not be read
    std::optional<tangle::Grammar> grammar;          // likewise
    std::optional<PlaneStart> start;                 // likewise
    std::optional<rewriting::Grammar> words;         // of a rewriting document, which has neither grammar nor start
    std::optional<rewriting::DrawRules> draw_rules;  // likewise
    std::optional<shape::Grammar> design;            // of a shape document, which has neither grammar nor start
    std::shared_ptr<const ShapeSource> shapes;       // what its forms mean; null where the settings could not be read
    std::vector<const GroupRule*> rules;             // as they stand in the document
    tangle::RuleGraph graph;
    std::shared_ptr<const Replay> replay;  // of OpenedDocument::choices; null where there are none
    // Of OpenedDocument::embedded, each checked once and shared like that; null where that is.
    std::vector<std::shared_ptr<const CheckedDocument>> embedded;
    // Of opening and checking, errors and warnings, with those of embedded documents; all stand with the outermost one.
    Diagnostics diagnostics;
};

// `opened` must outlive the result. `replay`: choices to be taken instead of drawing, before those of the document.
CheckedDocument check_document(const OpenedDocument& opened, const Replay* replay = nullptr);

// The tags of the starts, in the order of their mention; those of an SVG's layers behind them. `start`: as made from
// the document; null where it is not known yet.
std::vector<std::string> start_tags(const OpenedDocument& opened, const Settings& settings,
                                    const PlaneStart* start = nullptr);

// What words are made by: fills in `words` and `draw_rules` of a document whose settings are there.
Diagnostics read_words(const OpenedDocument& opened, CheckedDocument& checked);

// What designs are made by, likewise: fills in `design`.
Diagnostics read_design(const OpenedDocument& opened, CheckedDocument& checked);

// What the document's `embed` may name.
EmbeddableDocuments embeddable(const OpenedDocument& opened);

}  // namespace filigree
