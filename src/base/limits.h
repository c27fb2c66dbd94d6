// Limits that count work, not seconds, so that a run ends at the same place on every machine.
#pragma once

#include <cstdint>

namespace filigree {

struct Limits {
    std::uint64_t elements = 5'000'000;          // shapes, symbols, curves or faces made, all steps together
    std::uint64_t memory_bytes = 4'000'000'000;  // what the results of all steps may take
    std::uint32_t depth = 200;                   // steps from the start to an element

    bool operator==(const Limits&) const = default;
};

}  // namespace filigree
