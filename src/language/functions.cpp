#include "language/functions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/elementary.h"
#include "language/quantity.h"

namespace filigree {

namespace {

using Arguments = std::span<const FunctionArgument>;

FunctionProblem wrong_kind(std::size_t argument, std::string message) {
    return {"language.wrong-kind", std::move(message), argument};
}
FunctionProblem not_finite(std::size_t argument, std::string message) {
    return {"language.not-finite", std::move(message), argument};
}

FunctionProblem not_bare(std::size_t argument, const Quantity& found) {
    return wrong_kind(argument, "a plain number is needed here, but this is " + std::string(kind_of(found)));
}

// All of one dimension: that of the first argument that is not bare.
std::variant<std::vector<Quantity>, FunctionProblem> in_one_dimension(Arguments arguments) {
    Quantity like = arguments[0].quantity;
    for (const FunctionArgument& argument : arguments) {
        if (is_bare(like)) like = argument.quantity;
    }
    std::vector<Quantity> out;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::optional<Quantity> one = adapted(arguments[i].quantity, arguments[i].unit, like);
        if (!one) {
            return wrong_kind(i, "cannot compare " + std::string(kind_of(arguments[i].quantity)) + " with " +
                                     std::string(kind_of(like)));
        }
        out.push_back(*one);
    }
    return out;
}

template <class Body>
FunctionResult together(Arguments arguments, Body body) {
    auto adapted_arguments = in_one_dimension(arguments);
    if (auto* problem = std::get_if<FunctionProblem>(&adapted_arguments)) return *problem;
    return body(std::get<0>(adapted_arguments));
}

FunctionResult with_value(Quantity like, double value) {
    like.value = value;
    return like;
}

FunctionResult min(Arguments arguments, Unit) {
    return together(arguments, [](const std::vector<Quantity>& all) -> FunctionResult {
        return *std::min_element(all.begin(), all.end(),
                                 [](const Quantity& a, const Quantity& b) { return a.value < b.value; });
    });
}
FunctionResult max(Arguments arguments, Unit) {
    return together(arguments, [](const std::vector<Quantity>& all) -> FunctionResult {
        return *std::max_element(all.begin(), all.end(),
                                 [](const Quantity& a, const Quantity& b) { return a.value < b.value; });
    });
}
FunctionResult abs(Arguments arguments, Unit) {
    return with_value(arguments[0].quantity, std::fabs(arguments[0].quantity.value));
}

// Lengths are rounded as the document counts them: floor(12.3mm) is 12mm where the unit is mm.
template <class Rounding>
FunctionResult rounded(const Quantity& quantity, Unit unit, Rounding rounding) {
    if (quantity.length_power == 0 || unit == Unit::px) return with_value(quantity, rounding(quantity.value));
    double counted = quantity.value;
    for (int i = 0; i < quantity.length_power; ++i) counted = from_px(counted, unit);
    for (int i = 0; i > quantity.length_power; --i) counted = to_px(counted, unit);
    // Converting to px and back is off by some last digits, which must not make 12mm into 11.
    const double nearest = std::round(counted);
    if (std::fabs(counted - nearest) <= 1e-9 * std::max(1.0, std::fabs(counted))) counted = nearest;
    return *adapted(Quantity{rounding(counted), 0, false}, unit, quantity);
}
FunctionResult floor(Arguments arguments, Unit unit) {
    return rounded(arguments[0].quantity, unit, [](double x) { return std::floor(x); });
}
FunctionResult ceil(Arguments arguments, Unit unit) {
    return rounded(arguments[0].quantity, unit, [](double x) { return std::ceil(x); });
}
FunctionResult round(Arguments arguments, Unit unit) {
    return rounded(arguments[0].quantity, unit, [](double x) { return std::round(x); });
}

FunctionResult sqrt(Arguments arguments, Unit) {
    const Quantity& x = arguments[0].quantity;
    if (x.is_angle || x.length_power % 2 != 0) {
        return wrong_kind(0, "sqrt takes a number or an area, but this is " + std::string(kind_of(x)));
    }
    if (x.value < 0) return not_finite(0, "a number below zero has no square root");
    return Quantity{std::sqrt(x.value), static_cast<std::int8_t>(x.length_power / 2), false};
}

FunctionResult mod(Arguments arguments, Unit) {
    return together(arguments, [](const std::vector<Quantity>& all) -> FunctionResult {
        const double divisor = all[1].value;
        if (divisor == 0) return not_finite(1, "division by zero");
        double rest = std::fmod(all[0].value, divisor);  // exact on every machine
        if (rest != 0 && (rest < 0) != (divisor < 0)) rest += divisor;
        return with_value(all[0], rest);
    });
}

FunctionResult pow(Arguments arguments, Unit) {
    const Quantity& base = arguments[0].quantity;
    const Quantity& exponent = arguments[1].quantity;
    if (!is_bare(exponent)) return not_bare(1, exponent);
    if (base.is_angle) return not_bare(0, base);
    const double power = base.length_power * exponent.value;
    if (power != std::round(power) || std::fabs(power) > max_length_power) {
        return FunctionProblem{"language.out-of-range", "a length cannot have this exponent", 1};
    }
    return Quantity{elementary::power(base.value, exponent.value), static_cast<std::int8_t>(power), false};
}

// Of a bare number in degrees, or an angle.
template <class Body>
FunctionResult of_angle(Arguments arguments, Body body) {
    const Quantity& angle = arguments[0].quantity;
    if (angle.length_power != 0) {
        return wrong_kind(0, "an angle is needed here, but this is " + std::string(kind_of(angle)));
    }
    const elementary::CosSin turn = elementary::cos_sin_degrees(angle.value);
    return Quantity{body(turn), 0, false};
}
FunctionResult sin(Arguments arguments, Unit) {
    return of_angle(arguments, [](elementary::CosSin turn) { return turn.sin; });
}
FunctionResult cos(Arguments arguments, Unit) {
    return of_angle(arguments, [](elementary::CosSin turn) { return turn.cos; });
}
FunctionResult tan(Arguments arguments, Unit) {
    return of_angle(arguments, [](elementary::CosSin turn) { return turn.sin / turn.cos; });
}

Quantity degrees(double radians) { return {radians * 180 / elementary::pi, 0, true}; }

FunctionResult asin(Arguments arguments, Unit) {
    const Quantity& x = arguments[0].quantity;
    if (!is_bare(x)) return not_bare(0, x);
    if (!(std::fabs(x.value) <= 1)) return not_finite(0, "asin is known from -1 to 1");
    return degrees(elementary::asin(x.value));
}
FunctionResult acos(Arguments arguments, Unit) {
    const Quantity& x = arguments[0].quantity;
    if (!is_bare(x)) return not_bare(0, x);
    if (!(std::fabs(x.value) <= 1)) return not_finite(0, "acos is known from -1 to 1");
    return degrees(elementary::acos(x.value));
}
FunctionResult atan2(Arguments arguments, Unit) {
    return together(arguments, [](const std::vector<Quantity>& all) -> FunctionResult {
        return degrees(elementary::atan2(all[0].value, all[1].value));
    });
}
FunctionResult exp(Arguments arguments, Unit) {
    const Quantity& x = arguments[0].quantity;
    if (!is_bare(x)) return not_bare(0, x);
    return Quantity{elementary::exp(x.value), 0, false};
}
FunctionResult log(Arguments arguments, Unit) {
    const Quantity& x = arguments[0].quantity;
    if (!is_bare(x)) return not_bare(0, x);
    if (!(x.value > 0)) return not_finite(0, "only a number above zero has a logarithm");
    return Quantity{elementary::log(x.value), 0, false};
}
FunctionResult hypot(Arguments arguments, Unit) {
    return together(arguments, [](const std::vector<Quantity>& all) -> FunctionResult {
        const double a = std::fabs(all[0].value), b = std::fabs(all[1].value);
        const double larger = std::max(a, b), smaller = std::min(a, b);
        if (larger == 0) return with_value(all[0], 0);
        const double ratio = smaller / larger;  // so that squares neither overflow nor vanish
        return with_value(all[0], larger * std::sqrt(1 + ratio * ratio));
    });
}
FunctionResult clamp(Arguments arguments, Unit) {
    return together(arguments, [](const std::vector<Quantity>& all) -> FunctionResult {
        if (all[1].value > all[2].value) {
            return FunctionProblem{"language.empty-range", "the low end of clamp lies above the high end", 1};
        }
        return with_value(all[0], std::clamp(all[0].value, all[1].value, all[2].value));
    });
}
FunctionResult lerp(Arguments arguments, Unit) {
    const Quantity& t = arguments[2].quantity;
    if (!is_bare(t)) return not_bare(2, t);
    return together(arguments.first(2), [&t](const std::vector<Quantity>& all) -> FunctionResult {
        return with_value(all[0], all[0].value + (all[1].value - all[0].value) * t.value);
    });
}

constexpr std::size_t many = Function::any_number;
constexpr Function table[] = {
    {"min", "min(a, b, ...)", "the least of several", 2, many, min},
    {"max", "max(a, b, ...)", "the greatest of several", 2, many, max},
    {"abs", "abs(x)", "without the sign", 1, 1, abs},
    {"floor", "floor(x)", "the next whole number below; lengths are counted in the document's unit", 1, 1, floor},
    {"ceil", "ceil(x)", "the next whole number above; lengths are counted in the document's unit", 1, 1, ceil},
    {"round", "round(x)", "the nearest whole number, halves away from zero; lengths in the document's unit", 1, 1,
     round},
    {"sqrt", "sqrt(x)", "the square root; of an area it is a length", 1, 1, sqrt},
    {"mod", "mod(a, b)", "the rest of a divided by b, with the sign of b", 2, 2, mod},
    {"pow", "pow(a, b)", "a to the power of b", 2, 2, pow},
    {"sin", "sin(angle)", "the sine; a bare number is in degrees", 1, 1, sin},
    {"cos", "cos(angle)", "the cosine; a bare number is in degrees", 1, 1, cos},
    {"tan", "tan(angle)", "the tangent; a bare number is in degrees", 1, 1, tan},
    {"asin", "asin(x)", "the angle with this sine, from -90 to 90 degrees", 1, 1, asin},
    {"acos", "acos(x)", "the angle with this cosine, from 0 to 180 degrees", 1, 1, acos},
    {"atan2", "atan2(y, x)", "the angle of the direction (x, y)", 2, 2, atan2},
    {"exp", "exp(x)", "e to the power of x", 1, 1, exp},
    {"log", "log(x)", "the natural logarithm", 1, 1, log},
    {"hypot", "hypot(a, b)", "the square root of a * a + b * b", 2, 2, hypot},
    {"clamp", "clamp(x, low, high)", "x, or the nearer end where it lies outside", 3, 3, clamp},
    {"lerp", "lerp(a, b, t)", "from a (t = 0) to b (t = 1) in a straight line", 3, 3, lerp},
};

}  // namespace

std::span<const Function> functions() { return table; }

const Function* find_function(std::string_view name) {
    for (const Function& function : table) {
        if (function.name == name) return &function;
    }
    return nullptr;
}

bool is_special_form(std::string_view name) { return name == "one_of" || name == "normal" || name == "each"; }

}  // namespace filigree
