// A design as rules see it: where it lies, and what of it each left side matches.
//
// A rule's matches are searched when they are first asked for, and kept while the design changes: then only what lies
// near the change is searched (curves/kept_matches.h).
#pragma once

#include <optional>
#include <vector>

#include "curves/algebra.h"
#include "curves/kept_matches.h"
#include "curves/match_index.h"
#include "engines/shape/grammar.h"

namespace filigree::shape {

class SeenDesign {
public:
    // Of a maximal shape, which must outlive it. `steps`: how many lie behind it.
    SeenDesign(const Grammar& grammar, const curves::Shape& design, std::uint32_t steps);

    // After a step has changed the design.
    void follow(const curves::Change& change);
    // After it has become another.
    void start_anew(std::uint32_t steps);

    const curves::Shape& shape() const { return *design_; }
    const curves::MatchIndex& index();
    // All of it that comes near a shape, or into a box, and some that does not; in order.
    curves::Shape near(const curves::Shape& shape);
    curves::Shape within(const curves::Bounds& box);
    std::uint32_t steps() const { return steps_; }
    // Of a rule whose group is not affine.
    const curves::KeptMatches& matches_of(std::uint32_t rule, const Job& job);

private:
    curves::Shape on(std::vector<std::uint32_t> slots);

    struct OfRule {
        std::optional<curves::KeptMatches> kept;
        curves::MatchIndex::Change since;  // what has changed since these were right
    };

    const Grammar* grammar_;
    const curves::Shape* design_;
    std::optional<curves::MatchIndex> index_;  // when it is first asked for
    std::uint32_t steps_ = 0;
    std::vector<OfRule> of_rules_;
};

}  // namespace filigree::shape
