// The engines, in one closed table: what `list` and `describe` show.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "language/description.h"

namespace filigree {

struct EngineInfo {
    std::string_view name;
    std::string_view help;
    std::vector<const OperatorDescription*> operators;
};
std::span<const EngineInfo> engines();

}  // namespace filigree
