// What the groups and elements of a drawing are by their names, and which groups are rules (drawn_rules.h tells it
// whole).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "formats/svg_read.h"

namespace filigree::shape {

enum class DrawnRole : std::uint8_t { plain, left, right, condition, region, origin, notes };

DrawnRole role_said(std::string_view name);
// By its label, else by its id.
template <class Named>
DrawnRole role_of(const Named& named) {
    const DrawnRole role = role_said(named.label);
    return role == DrawnRole::plain ? role_said(named.id) : role;
}
// What something is within what is around it; plain, too, what is in a side.
DrawnRole role_within(DrawnRole around, DrawnRole own);

std::string name_of(const SvgGroup& group);

struct RuleGroups {  // indices
    std::size_t rule = 0, left = 0, right = 0;
};
// In the order of the drawing; what is wrong and what only looks like a rule is added to the diagnostics.
std::vector<RuleGroups> find_rules(const std::vector<SvgGroup>& groups, Diagnostics& diagnostics);

}  // namespace filigree::shape
