#include "language/form_value.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "language/names.h"
#include "language/parameter_value.h"
#include "language/parse.h"

namespace filigree {

namespace {

std::string quoted(std::string_view name) { return "'" + std::string(name) + "'"; }

class FormBinder {
public:
    FormBinder(const OperatorDescription& form, const Document& document, SourceSpan span)
        : form_(form), document_(document), span_(span), values_(form.parameters.size()) {}

    Result<Value> run(const SymbolicCall& call) {
        for (const NamedValue& argument : call.arguments) {
            if (!argument.name.empty() && !take_named(argument)) return std::move(*problem_);
        }
        std::size_t next = 0;
        for (const NamedValue& argument : call.arguments) {
            if (argument.name.empty() && !take_positional(argument.value, next)) return std::move(*problem_);
        }
        SymbolicCall out{std::string(form_.name), {}};
        for (std::size_t i = 0; i < values_.size(); ++i) {
            if (!values_[i] && !take_default(i)) return std::move(*problem_);
            out.arguments.push_back({std::string(form_.parameters[i].name), std::move(*values_[i]), {}});
        }
        return Value{std::move(out), {}};
    }

private:
    bool fail(Diagnostic problem) {
        problem_ = std::move(problem);
        return false;
    }

    bool take(std::size_t i, const Value& value) {
        const ParameterDescription& parameter = form_.parameters[i];
        Result<Value> result = converted(parameter, value, document_, span_);
        if (!result) return fail(result.diagnostics().front());
        if (auto outside = out_of_range(parameter, *result, span_)) return fail(std::move(*outside));
        if (!parameter.repeats) {
            values_[i] = std::move(*result);
        } else {
            if (!values_[i]) values_[i] = Value{ValueList{}, {}};
            std::get<ValueList>(values_[i]->data).items.push_back(std::move(*result));
        }
        return true;
    }
    // All values of a parameter that repeats, in one list.
    bool take_list(std::size_t i, const ValueList& list) {
        return std::all_of(list.items.begin(), list.items.end(), [&](const Value& item) { return take(i, item); });
    }

    bool take_named(const NamedValue& argument) {
        std::vector<std::string_view> known;
        for (std::size_t i = 0; i < form_.parameters.size(); ++i) {
            known.push_back(form_.parameters[i].name);
            if (!has_name(form_.parameters[i], argument.name)) continue;
            const auto* list = std::get_if<ValueList>(&argument.value.data);
            if (!values_[i] && list != nullptr && form_.parameters[i].repeats) return take_list(i, *list);
            if (!values_[i]) return take(i, argument.value);
            return fail(
                error("language.doubled-argument", quoted(argument.name) + " is given twice", argument.name_span));
        }
        return fail(error("language.unknown-argument", quoted(form_.name) + " has no argument " + quoted(argument.name),
                          argument.name_span, did_you_mean(argument.name, known)));
    }

    // A positional argument skips optional parameters that cannot take it, as in rules.
    bool take_positional(const Value& value, std::size_t& next) {
        std::optional<Diagnostic> first_problem;
        for (std::size_t i = next; i < form_.parameters.size(); ++i) {
            const bool repeats = form_.parameters[i].repeats;
            if (values_[i] && !repeats) continue;
            if (take(i, value)) {
                next = repeats ? i : i + 1;
                return true;
            }
            if (!first_problem) first_problem = problem_;
            if (form_.parameters[i].default_text.empty()) return false;
        }
        if (first_problem) return fail(std::move(*first_problem));
        return fail(error("language.surplus-argument", quoted(form_.name) + " takes no further argument", span_,
                          {"as in " + std::string(form_.example)}));
    }

    bool take_default(std::size_t i) {
        const ParameterDescription& parameter = form_.parameters[i];
        if (parameter.default_text.empty()) {
            return fail(error(
                "language.missing-argument",
                quoted(form_.name) + " needs " + quoted(parameter.name) + ", " + std::string(type_name(parameter.type)),
                span_));
        }
        const Result<ExpressionPtr> parsed = parse_expression(parameter.default_text);
        if (!parsed) return fail(parsed.diagnostics().front());
        const Result<Value> value = evaluate(**parsed, expected_by(parameter, document_, nullptr));
        if (!value) return fail(value.diagnostics().front());
        return take(i, *value);
    }

    const OperatorDescription& form_;
    const Document& document_;
    SourceSpan span_;
    std::vector<std::optional<Value>> values_;
    std::optional<Diagnostic> problem_;
};

}  // namespace

std::vector<std::string_view> form_names(const ParameterDescription& parameter) {
    std::vector<std::string_view> names;
    if (parameter.forms == nullptr) return names;
    for (const OperatorDescription& form : *parameter.forms) {
        names.push_back(form.name);
        names.insert(names.end(), form.aliases.begin(), form.aliases.end());
    }
    return names;
}

bool takes_numbers(const ParameterDescription& parameter) { return parameter.low > -1e300 && parameter.high < 1e300; }

Result<Value> to_form(const ParameterDescription& parameter, const Value& value, const Document& document,
                      SourceSpan span) {
    if (const auto* word = std::get_if<Symbol>(&value.data)) {
        const auto& words = parameter.words;
        if (std::find(words.begin(), words.end(), word->name) != words.end()) return Value{*word, {}};
    }
    if (const auto* call = std::get_if<SymbolicCall>(&value.data); call != nullptr && parameter.forms != nullptr) {
        if (const OperatorDescription* form = find_operator(*parameter.forms, call->name)) {
            return FormBinder(*form, document, span).run(*call);
        }
    }
    if (const auto* point = std::get_if<Vec>(&value.data); point != nullptr && parameter.takes_points) {
        if (std::isfinite(point->x) && std::isfinite(point->y)) return Value{*point, {}};
    }
    if (takes_numbers(parameter)) {
        if (const Result<double> number = as_number(value)) return Value{Quantity{*number, 0, false}, {}};
    }
    std::vector<std::string_view> known = parameter.words;
    for (const std::string_view name : form_names(parameter)) known.push_back(name);
    return error("language.wrong-kind", quoted(parameter.name) + " cannot be " + std::string(kind_of(value)), span,
                 {"it may be " + std::string(takes_numbers(parameter) ? "a number, " : "") +
                  (parameter.takes_points ? "a point (x, y), " : "") + quoted_alternatives(known)});
}

const Value& argument_of(const SymbolicCall& call, std::string_view name) {
    const auto found = std::find_if(call.arguments.begin(), call.arguments.end(),
                                    [name](const NamedValue& argument) { return argument.name == name; });
    return found->value;
}
double number_of(const SymbolicCall& call, std::string_view name) {
    return std::get<Quantity>(argument_of(call, name).data).value;
}
const std::string& text_of(const SymbolicCall& call, std::string_view name) {
    return std::get<std::string>(argument_of(call, name).data);
}
std::string_view word_of(const SymbolicCall& call, std::string_view name) {
    return std::get<Symbol>(argument_of(call, name).data).name;
}

}  // namespace filigree
