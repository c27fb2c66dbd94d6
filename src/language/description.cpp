#include "language/description.h"

#include <algorithm>

namespace filigree {

bool has_name(const ParameterDescription& parameter, std::string_view name) {
    return parameter.name == name ||
           std::find(parameter.aliases.begin(), parameter.aliases.end(), name) != parameter.aliases.end();
}

const OperatorDescription* find_operator(std::span<const OperatorDescription> operators, std::string_view name) {
    for (const OperatorDescription& description : operators) {
        if (description.name == name) return &description;
    }
    for (const OperatorDescription& description : operators) {
        const auto& aliases = description.aliases;
        if (std::find(aliases.begin(), aliases.end(), name) != aliases.end()) return &description;
    }
    return nullptr;
}

std::string_view type_name(ParameterType type) {
    switch (type) {
        case ParameterType::whole:
            return "a whole number";
        case ParameterType::real:
            return "a number";
        case ParameterType::length:
            return "a length";
        case ParameterType::angle:
            return "an angle";
        case ParameterType::direction:
            return "a direction";
        case ParameterType::flag:
            return "true or false";
        case ParameterType::word:
            return "a word";
        case ParameterType::lengths:
            return "a length or a list of lengths";
        case ParameterType::text:
            return "a text";
        case ParameterType::point:
            return "a point";
        case ParameterType::colour:
            return "a colour";
        case ParameterType::form:
            return "a form";
        case ParameterType::any:
            return "a value";
    }
    return "a value";
}

}  // namespace filigree
