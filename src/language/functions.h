// The functions of the language: one table for evaluating, checking and describing.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "language/expression.h"
#include "language/value.h"

namespace filigree {

struct FunctionArgument {
    Quantity quantity;
    Unit unit = Unit::px;  // of a bare length
};

// Why a function has no value here: which argument, and what is wrong with it.
struct FunctionProblem {
    std::string code;     // language.wrong-kind, language.not-finite, language.empty-range
    std::string message;  // "cannot compare an angle with a length"
    std::size_t argument = 0;
};
using FunctionResult = std::variant<Quantity, FunctionProblem>;

struct Function {
    std::string_view name;
    std::string_view signature;  // "max(a, b, ...)"
    std::string_view help;       // one line, lower case, no full stop
    std::size_t least_arguments = 1;
    std::size_t most_arguments = 1;  // any_number for "..."
    // `unit` is what a bare length means where the call stands; lengths are rounded in it.
    FunctionResult (*call)(std::span<const FunctionArgument> arguments, Unit unit) = nullptr;

    static constexpr std::size_t any_number = SIZE_MAX;
};

std::span<const Function> functions();
const Function* find_function(std::string_view name);  // null where there is none
// one_of, normal and each: calls with rules of their own.
bool is_special_form(std::string_view name);

}  // namespace filigree
