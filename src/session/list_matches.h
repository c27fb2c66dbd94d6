// The matches of a shape rule, as text and JSON; why one that was expected is none; and a match that is chosen, as a
// new document.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/job.h"
#include "base/result.h"
#include "scene/drawing.h"
#include "session/check.h"
#include "session/derive_design.h"

namespace filigree {

struct MatchQuestion {
    std::string rule;                    // empty: every rule
    std::optional<std::uint64_t> steps;  // in which state of the derivation
    bool by_hand_alone = false;          // behind the steps by hand, before the machine's
    std::optional<Vec> at;               // px: where a match is expected that explain_match() explains
};

// The applications in the design that the document leads to, with where the derivation stands.
struct FoundMatches {
    shape::Derivation derivation;
    std::vector<std::uint32_t> rules;
    std::vector<shape::Applications> of_rules;  // in the order of `rules`
};
Result<FoundMatches> find_matches(const OpenedDocument& opened, const CheckedDocument& checked,
                                  const MatchQuestion& question, const Job& job);

std::string matches_text(const OpenedDocument& opened, const CheckedDocument& checked, const FoundMatches& found);
std::string matches_json(const OpenedDocument& opened, const CheckedDocument& checked, const FoundMatches& found);

// Why a rule does not apply (there): the nearest embedding, element by element.
Result<std::string> explain_match(const OpenedDocument& opened, const CheckedDocument& checked,
                                  const MatchQuestion& question, const FoundMatches& found, bool as_json);

// The document with one `apply` more, as its last line: that of the K-th application, counted from 1 as matches are
// listed.
Result<std::string> with_step(const OpenedDocument& opened, const CheckedDocument& checked, const FoundMatches& found,
                              std::uint64_t number, bool is_orbit);

// "apply slide at (3, 3) angle 90 mirrored", as the document would write it.
std::string apply_text(const OpenedDocument& opened, const CheckedDocument& checked, const shape::Applications& among,
                       const shape::Application& at, bool is_orbit);

}  // namespace filigree
