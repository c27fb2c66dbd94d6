#include "language/parameter_value.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "language/colour_words.h"
#include "language/form_value.h"
#include "language/names.h"

namespace filigree {

namespace {

constexpr double unlimited = 1e300;

Diagnostic wrong_kind(const ParameterDescription& parameter, const std::string& found, SourceSpan span,
                      std::vector<std::string> hints = {}) {
    return error("language.wrong-kind",
                 "'" + std::string(parameter.name) + "' must be " + std::string(type_name(parameter.type)) +
                     ", but this is " + found,
                 span, std::move(hints));
}
Diagnostic wrong_kind(const ParameterDescription& parameter, const Value& value, SourceSpan span,
                      std::vector<std::string> hints = {}) {
    return wrong_kind(parameter, std::string(kind_of(value)), span, std::move(hints));
}

Value bare(double value) { return {Quantity{value, 0, false}, {}}; }
Value length(double px) { return {Quantity{px, 1, false}, {}}; }
Value angle(double degrees) { return {Quantity{degrees, 0, true}, {}}; }

// The diagnostic of a conversion, said of the parameter.
template <class T>
Diagnostic retold(const ParameterDescription& parameter, const Value& value, Result<T> failed, SourceSpan span) {
    Diagnostic diagnostic = std::move(failed).diagnostics().front();
    if (diagnostic.code == "language.wrong-kind") {
        return wrong_kind(parameter, value, span, std::move(diagnostic.hints));
    }
    diagnostic.span = span;
    return diagnostic;
}

Result<Value> to_whole_number(const ParameterDescription& parameter, const Value& value, SourceSpan span) {
    const Result<double> number = as_number(value);
    if (!number) return retold(parameter, value, number, span);
    // Sums of decimals miss whole numbers by some last digits.
    const double nearest = std::round(*number);
    if (std::fabs(*number - nearest) <= 1e-9 * std::max(1.0, std::fabs(nearest))) return bare(nearest);
    return error("language.out-of-range",
                 "'" + std::string(parameter.name) + "' must be a whole number, but this is " + to_text(*number), span);
}

Result<Value> to_direction(const ParameterDescription& parameter, const Value& value, SourceSpan span) {
    if (const Symbol* symbol = std::get_if<Symbol>(&value.data)) {
        if (std::find(parameter.words.begin(), parameter.words.end(), symbol->name) != parameter.words.end()) {
            return Value{*symbol, {}};
        }
    }
    if (const SymbolicCall* call = std::get_if<SymbolicCall>(&value.data)) {
        if (std::find(parameter.calls.begin(), parameter.calls.end(), call->name) != parameter.calls.end()) {
            if (call->arguments.size() != 1 || !call->arguments[0].name.empty()) {
                return error("language.wrong-arguments", "'" + call->name + "' takes one argument without a name",
                             span);
            }
            SymbolicCall result = *call;
            if (std::holds_alternative<Quantity>(result.arguments[0].value.data)) {
                const Result<double> degrees = as_angle(result.arguments[0].value);
                if (!degrees) {
                    Diagnostic diagnostic = degrees.diagnostics().front();
                    diagnostic.span = span;
                    return diagnostic;
                }
                result.arguments[0].value = angle(*degrees);
            }
            return Value{std::move(result), {}};
        }
    }
    const Result<double> degrees = as_angle(value);
    if (degrees) return angle(*degrees);
    std::vector<std::string> hints;
    if (!parameter.words.empty()) hints.push_back("it may also be " + quoted_alternatives(parameter.words));
    return wrong_kind(parameter, value, span, std::move(hints));
}

Result<Value> to_word(const ParameterDescription& parameter, const Value& value, SourceSpan span) {
    const Symbol* symbol = std::get_if<Symbol>(&value.data);
    if (symbol != nullptr &&
        std::find(parameter.words.begin(), parameter.words.end(), symbol->name) != parameter.words.end()) {
        return Value{*symbol, {}};
    }
    return wrong_kind(parameter, value, span,
                      {"the words that may stand here are " + quoted_alternatives(parameter.words)});
}

Result<Value> to_lengths(const ParameterDescription& parameter, const Value& value, const Document& document,
                         SourceSpan span) {
    const ValueList* list = std::get_if<ValueList>(&value.data);
    if (list == nullptr) {
        const Result<double> px = as_length(value, document);
        if (!px) return retold(parameter, value, px, span);
        return Value{ValueList{{length(*px)}}, {}};
    }
    if (list->items.empty()) return wrong_kind(parameter, "an empty list", span);
    ValueList out;
    for (const Value& item : list->items) {
        const Result<double> px = as_length(item, document);
        if (!px) {
            return wrong_kind(parameter, "a list with " + std::string(kind_of(item)) + " in it", span);
        }
        out.items.push_back(length(*px));
    }
    return Value{std::move(out), {}};
}

}  // namespace

Evaluation expected_by(const ParameterDescription& parameter, const Document& document, const Scope* scope) {
    Evaluation at;
    at.document = &document;
    at.scope = scope;
    switch (parameter.type) {
        case ParameterType::word:
            at.words = parameter.words;
            break;
        case ParameterType::direction:
            at.words = parameter.words;
            at.calls = parameter.calls;
            break;
        case ParameterType::flag:
            at.words = parameter.aliases;
            at.words.insert(at.words.begin(), {parameter.name, "yes", "no"});
            at.whole = true;  // 0..1 is a choice between both
            break;
        case ParameterType::whole:
            at.whole = true;
            break;
        case ParameterType::colour:
            at.words = colour_words_beside(scope);
            break;
        case ParameterType::form:
            at.words = parameter.words;
            at.calls = form_names(parameter);
            at.words_in_calls = true;
            at.forms = parameter.forms;
            break;
        case ParameterType::any:
            at.words = {"*"};
            break;
        default:
            break;
    }
    return at;
}

Result<Value> converted(const ParameterDescription& parameter, const Value& value, const Document& document,
                        SourceSpan span) {
    switch (parameter.type) {
        case ParameterType::whole:
            return to_whole_number(parameter, value, span);
        case ParameterType::real: {
            const Result<double> number = as_number(value);
            if (!number) return retold(parameter, value, number, span);
            return bare(*number);
        }
        case ParameterType::length: {
            const Result<double> px = as_length(value, document);
            if (!px) return retold(parameter, value, px, span);
            return length(*px);
        }
        case ParameterType::angle: {
            const Result<double> degrees = as_angle(value);
            if (!degrees) return retold(parameter, value, degrees, span);
            return angle(*degrees);
        }
        case ParameterType::direction:
            return to_direction(parameter, value, span);
        case ParameterType::flag: {
            // Its own name stands for yes.
            if (const Symbol* word = std::get_if<Symbol>(&value.data)) {
                if (word->name == "no") return Value{false, {}};
                if (word->name == "yes" || has_name(parameter, word->name)) return Value{true, {}};
            }
            const Result<bool> flag = as_flag(value);
            if (!flag) return retold(parameter, value, flag, span);
            return Value{*flag, {}};
        }
        case ParameterType::word:
            return to_word(parameter, value, span);
        case ParameterType::lengths:
            return to_lengths(parameter, value, document, span);
        case ParameterType::text:
            if (const std::string* text = std::get_if<std::string>(&value.data)) return Value{*text, {}};
            return wrong_kind(parameter, value, span);
        case ParameterType::point:
            if (const Vec* point = std::get_if<Vec>(&value.data)) {
                if (std::isfinite(point->x) && std::isfinite(point->y)) return Value{*point, {}};
                return error("language.not-finite", "this has no finite value", span);
            }
            return wrong_kind(parameter, value, span, {"a point is written (x, y)"});
        case ParameterType::colour: {
            const Result<Colour> colour = as_colour(value);
            if (!colour) return retold(parameter, value, colour, span);
            return Value{*colour, {}};
        }
        case ParameterType::form:
            return to_form(parameter, value, document, span);
        case ParameterType::any:
            return value;
    }
    return wrong_kind(parameter, value, span);
}

Value example_of(const ParameterDescription& parameter) {
    const double number = std::min(std::max(1.0, parameter.low), parameter.high);
    switch (parameter.type) {
        case ParameterType::whole:
        case ParameterType::real:
        case ParameterType::any:
            return bare(number);
        case ParameterType::length:
            return length(number);
        case ParameterType::angle:
        case ParameterType::direction:
            return angle(number);
        case ParameterType::flag:
            return {false, {}};
        case ParameterType::word:
        case ParameterType::form:
            if (parameter.words.empty() && takes_numbers(parameter)) return bare(number);
            return {Symbol{std::string(parameter.words.empty() ? "" : parameter.words.front())}, {}};
        case ParameterType::lengths:
            return {ValueList{{length(number)}}, {}};
        case ParameterType::text:
            return {std::string(), {}};
        case ParameterType::point:
            return {Vec{}, {}};
        case ParameterType::colour:
            return {Colour{}, {}};
    }
    return {};
}

std::string allowed_range(const ParameterDescription& parameter) {
    std::string_view unit;
    if (parameter.type == ParameterType::length || parameter.type == ParameterType::lengths) unit = "px";
    if (parameter.type == ParameterType::angle || parameter.type == ParameterType::direction) unit = "deg";
    const auto bound = [unit](double value) { return to_text(value) + std::string(unit); };
    const bool has_low = parameter.low > -unlimited, has_high = parameter.high < unlimited;
    // Lengths of a list follow one another, so their low end must not be reached: it is usually zero.
    const bool open = parameter.type == ParameterType::lengths;
    if (has_low && has_high) {
        return open ? "above " + bound(parameter.low) + " and at most " + bound(parameter.high)
                    : "from " + bound(parameter.low) + " to " + bound(parameter.high);
    }
    if (has_low) return (open ? "above " : "at least ") + bound(parameter.low);
    if (has_high) return "at most " + bound(parameter.high);
    return {};
}

std::optional<Diagnostic> out_of_range(const ParameterDescription& parameter, const Value& value, SourceSpan span) {
    const auto outside = [&](const Quantity& quantity) -> std::optional<Diagnostic> {
        const bool open = parameter.type == ParameterType::lengths && parameter.low > -unlimited;
        const bool low_enough = open ? quantity.value > parameter.low : quantity.value >= parameter.low;
        if (low_enough && quantity.value <= parameter.high) return std::nullopt;
        std::string found = to_text(quantity.value);
        if (quantity.length_power == 1) found += "px";
        if (quantity.is_angle) found += "deg";
        return error(
            "language.out-of-range",
            "'" + std::string(parameter.name) + "' must be " + allowed_range(parameter) + ", but this is " + found,
            span);
    };
    if (const Quantity* quantity = std::get_if<Quantity>(&value.data)) return outside(*quantity);
    if (const ValueList* list = std::get_if<ValueList>(&value.data)) {
        for (const Value& item : list->items) {
            const Quantity* quantity = std::get_if<Quantity>(&item.data);
            if (quantity == nullptr) continue;
            if (std::optional<Diagnostic> problem = outside(*quantity)) return problem;
        }
    }
    return std::nullopt;
}

}  // namespace filigree
