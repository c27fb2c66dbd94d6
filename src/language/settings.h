// What a document says that every engine reads the same way, evaluated: parameters and `let` names, unit,
// resolution, page, limits, palettes, and which statements are rules and styles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/limits.h"
#include "base/result.h"
#include "language/document.h"
#include "language/evaluate.h"
#include "language/preset_walk.h"

namespace filigree {

struct Page {
    PageStatement::Kind kind = PageStatement::Kind::fit;
    double width = 0, height = 0;  // px; 0 for `fit`
    std::optional<double> margin;  // px
    bool in_mm = false;            // whether it was given in a metric unit or by name
};

struct Settings {
    std::string engine;  // "tangle"
    SourceSpan engine_span;
    std::uint64_t seed = 0;
    double resolution = 0.1;  // px: tolerance for flattening curves
    Page page;
    Limits limits;
    std::optional<Name> symmetry;               // the group as written; the engine knows which it can
    Scope globals;                              // params, lets, palettes (as lists), page.width, page.height
    std::vector<const StyleStatement*> styles;  // in order; point into the document (style.h reads them)
    std::vector<const GroupRule*> rules;        // likewise
    std::vector<SourceSpan> rule_spans;
    std::vector<const ApplyStatement*> applies;       // likewise
    std::vector<const OperatorStatement*> operators;  // likewise
    std::vector<const SystemStatement*> systems;      // likewise
    ChoiceBuffer definitions;                         // the choices of params, lets and palettes
};

// `document` must outlive the result. Reports: two or no `grammar`, doubled names (param, let, palette share
// one space), values outside a parameter's domain, wrong kinds, unknown limits, pages and units, and names that are
// defined later than they are used. Warns of names that rules and styles use for something else (area, x, ...).
// Choices in `param` and `let` are drawn once, at the key of "let/NAME"; presets of that path are obeyed.
// Named pages: a0..a6, letter, legal, tabloid; portrait.
Result<Settings> read_settings(const Document& document, const DocumentSite& site = {});

// Where choices in the definition of a name are drawn: at this key, under the name itself.
Key definition_key(std::string_view name);

}  // namespace filigree
