// What of an earlier derivation still holds, so that an edit re-runs only what depends on it.
//
// A derivation keeps, as text, what its steps could read beside their shapes: each rule with the values of the names
// in it, each preset, and what all of them share (Reads). A group of a new derivation is the same as one of the
// earlier one if it comes from the same shapes by the same steps; if then the same rules may expand it, and the same
// presets are on their way to it, its whole step is taken over: it is what would have been derived, byte for byte.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "derivation/plane_start.h"
#include "engines/tangle/grammar.h"
#include "engines/tangle/tangle.h"
#include "language/preset_walk.h"

namespace filigree::tangle {

// What stands below a place of the presets' paths, in 128 bits.
struct Fingerprint {
    std::uint64_t first = 0, second = 0;

    bool operator==(const Fingerprint&) const = default;
};

struct Reads {
    std::string common;                     // seed, files, resolution, units: where it differs, every step is run again
    std::vector<std::string> rules_of_tag;  // of each tag
    std::vector<std::string> presets;       // of each preset in force
    std::vector<std::vector<Fingerprint>> places;  // of each node of each of the presets' trees
    PlaneStart start;
};
// `files`: a fingerprint of the files that forms may name.
Reads reads_of(const Grammar& grammar, const PlaneStart& start, const Settings& settings, const Document& document,
               const PresetWalk& walk, std::uint64_t files);

class Previous {
public:
    Previous() = default;  // nothing holds
    Previous(const Tangle* tangle, const Reads& now);

    const Tangle* tangle() const { return tangle_; }
    // Whether the groups of the starts are the same.
    bool has_same_start() const { return has_same_start_; }
    // Whether the same rules may expand groups of this tag as of that of the earlier derivation.
    bool has_same_rules(std::uint32_t tag, std::uint32_t old_tag) const;
    // Whether the same presets are on their way, equally far.
    bool has_same_presets(const PresetState& state, const PresetState& old_state) const;

private:
    const Tangle* tangle_ = nullptr;
    const Reads* now_ = nullptr;
    bool has_same_start_ = false;
    bool has_same_common_ = false;
};

}  // namespace filigree::tangle
