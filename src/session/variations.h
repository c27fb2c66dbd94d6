// Neighbours of a document: the same document with some of its choices drawn again.
//
// A neighbour is a document, with `reroll` statements for what differs, so that it can be kept, read and varied again.
// What is set, kept or not random stays.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "session/run.h"

namespace filigree {

struct VariationOptions {
    std::uint32_t count = 12;
    std::uint32_t first = 1;  // number of the first neighbour: others than those before
    double distance = 0.3;    // 0..1: the share of the choices that is drawn again; at least one is
};

struct Variation {
    std::uint32_t number = 1;
    std::string label;                 // "3  quads.rule, outline.distance +2"
    std::vector<std::string> rerolls;  // paths of what is drawn again
    std::string text;                  // of the document
};

// Where a document has more than a hundred free choices, they are drawn again in classes: `**/outline.distance`.
// The error variations.nothing-free where every choice is set or kept, or there is none.
Result<std::vector<Variation>> variations(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run,
                                          const VariationOptions& options);

}  // namespace filigree
