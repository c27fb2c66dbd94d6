// All designs that a grammar can make in so many steps, each once.
//
// Breadth first, from the state that the document's own `apply` statements lead to, by all that the machine may do:
// rules without weight are not applied, and those of lower priority only where no other is. Designs that are the same,
// by the fingerprint and then by a comparison, are met once. Right sides that draw at random take the middle.
#pragma once

#include <cstdint>
#include <vector>

#include "curves/fingerprint.h"
#include "engines/shape/derive.h"

namespace filigree::shape {

struct FoundDesign {
    curves::Shape design;
    std::uint32_t before = 0;  // index of the design that it was first made from; the first one is its own
    std::uint32_t depth = 0;   // steps from the first one
    Application by;
    std::uint32_t ways = 1;  // in how many ways it was met
};

struct EnumerateOptions {
    std::uint32_t depth = 2;
    std::uint64_t most = 10'000;                 // designs
    curves::UpTo up_to = curves::UpTo::nothing;  // which designs are the same
};

struct FoundDesigns {
    std::vector<FoundDesign> all;
    bool is_complete = true;  // false: there were more than were asked for
};

Result<FoundDesigns> enumerate(const Grammar& grammar, const curves::Shape& from, const Surroundings& around,
                               const EnumerateOptions& options, const Job& job);

}  // namespace filigree::shape
