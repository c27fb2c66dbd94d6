// From a document's `image` and `data` to maps, and from the successors that look at them to lookups.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "derivation/inputs.h"
#include "engines/rewriting/grammar.h"
#include "language/document.h"
#include "language/settings.h"

namespace filigree::rewriting {

// All that the document declares, also those with `problems`: they have no cells. A file that is not among the inputs
// is no problem here, since whoever loaded them has said so.
std::vector<Map> read_maps(const Settings& settings, const Document& document, const Inputs& inputs,
                           Diagnostics& problems);

Result<Lookup> read_lookup(const WordLookup& said, std::span<const Map> maps, const Settings& settings,
                           const Document& document, bool frees_braces);

// What the expressions of a rule may name of the maps that it looks at, of each kind once; all where a map is unknown.
std::vector<std::string_view> names_looked_up(const Rule& rule, std::span<const Map> maps);

}  // namespace filigree::rewriting
