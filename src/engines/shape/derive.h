// Deriving a design: rules are applied to the subshapes that can be seen in it, one after another.
//
// An application of left -> right under a map T takes T(left) away from the design and adds T(right); the result is
// maximal again, so that what comes to lie in line becomes one, and subshapes that nobody put can be seen. Papers:
// Jowers and Earl, sections 2.2 and 3.3; the modes are Chase's (2002): the machine picks rule and match (`steps`), or
// lists them for a person to choose from (`apply`).
//
// States form a tree: a derivation can go back to any state and take another way. State 0 is the start.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/job.h"
#include "base/result.h"
#include "curves/algebra.h"
#include "engines/shape/applications.h"

namespace filigree::shape {

// One rule application, or several at once; state k lies behind steps[k - 1].
struct Step {
    std::uint32_t before = 0;  // the state that it changes
    std::uint32_t rule = 0;
    std::vector<Application> applied;
    curves::Change change;                            // of the design
    std::vector<std::uint32_t> removed_by, added_by;  // the states that its elements came with; what is left of an
                                                      // element keeps that one's
    std::uint32_t number = 0;                         // of automatic steps, from 1; 0 of those by hand
    std::uint32_t by_hand = 0;                        // of those by hand, from 1
    SourceSpan by;                                    // the `apply` that says it
    std::string name;                                 // as `back to` calls the state behind it; else empty
    std::size_t first_choice = 0, end_choice = 0;
};

struct Derivation {
    std::vector<Step> steps;
    std::uint32_t state = 0;             // where it stands
    curves::Shape design;                // there
    std::vector<std::uint32_t> made_by;  // of each element: the state that it came with
    Choices choices;
    std::size_t end_definition_choice = 0;
    std::vector<std::uint8_t> met;  // of each preset in force: whether it met a step
    curves::Ambiguities ambiguities;
    bool is_finished = false;  // the document's steps ended early, since no rule applies
};

struct DeriveOptions {
    std::optional<std::uint64_t> steps;  // so many in all, by hand or not; none: as the document says
    DocumentSite site = {};
    bool by_hand_alone = false;  // without automatic steps
};

// The steps that the document says by hand, then automatic ones.
Result<Derivation> derive(const Grammar& grammar, const Surroundings& around, const DeriveOptions& options,
                          const Job& job);

// The initial shape, as a derivation without steps.
Derivation begin(const Grammar& grammar);

// A derivation's design in another of its states, and there the states that its elements came with.
void go_to(Derivation& derivation, std::uint32_t state);
// The states from the start to one, both included.
std::vector<std::uint32_t> way_to(const Derivation& derivation, std::uint32_t state);

// The design where a derivation stands; of a derivation that stays where it is in memory.
SeenDesign seen_design(const Grammar& grammar, const Derivation& derivation);

// What an application puts. Choices in the right side are made at the step's key, from the second application of a
// step on (`number`, from 0) at keys below it.
Result<curves::Shape> put_by(const Grammar& grammar, const Application& at, std::uint32_t number, Key step,
                             const Surroundings& around, const StepChoices& choices);

// Applies a rule at some places at once, as a new step of the state that the derivation stands in, and goes there.
// `puts`: what each application puts.
Step& apply_rule(Derivation& derivation, const Grammar& grammar, std::vector<Application> at,
                 const std::vector<curves::Shape>& puts);

// The rules that the machine may apply, those of the highest priority first; rules without weight are none.
std::vector<std::uint32_t> automatic_rules(const Grammar& grammar);

// What the machine does next: a rule, drawn among those of the highest priority that apply, and where. None where no
// rule applies. Recorded as the choices `rule` and `match` of the step.
struct NextStep {
    std::vector<Application> at;
};
Result<std::optional<NextStep>> draw_step(const Grammar& grammar, SeenDesign& design, const PresetWalk& walk,
                                          const PresetNode& node, Key key, const Surroundings& around, const Job& job,
                                          ChoiceBuffer& record);

}  // namespace filigree::shape
