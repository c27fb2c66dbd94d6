// The engines and the examples, in closed tables: what `list` and `describe` show.
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
    std::string_view operators_are = "Operators";  // what its documents call them
};
std::span<const EngineInfo> engines();

struct ExampleInfo {
    std::string_view file;  // below the repository's root
    std::string_view title;
};
std::span<const ExampleInfo> examples();

}  // namespace filigree
