#include "language/argument_check.h"

#include <algorithm>

#include "language/form_value.h"
#include "language/names.h"
#include "language/parameter_value.h"
#include "language/walk.h"

namespace filigree {

namespace {

using Kind = Alternative::Kind;

// Whether a value of some other size might still be right.
bool takes_numbers(ParameterType type) {
    switch (type) {
        case ParameterType::whole:
        case ParameterType::real:
        case ParameterType::length:
        case ParameterType::angle:
        case ParameterType::direction:
        case ParameterType::lengths:
        case ParameterType::form:
        case ParameterType::any:
            return true;
        default:
            return false;
    }
}

}  // namespace

bool ArgumentCheck::fits(const Expression& argument) const {
    Evaluation here = at;
    const std::vector<std::string_view> forms = form_names(parameter);
    for (const Alternative& alternative : alternatives_of(argument)) {
        if (alternative.kind == Kind::range) continue;
        // Whoever writes star(5, 10) means this parameter, whatever is wrong inside.
        const auto* call = std::get_if<CallExpression>(&alternative.expression->node);
        if (call != nullptr && std::find(forms.begin(), forms.end(), call->name) != forms.end()) return true;
        here.by_shape = alternative.by_shape;
        const bool fixed_value = is_constant(*alternative.expression, here, fixed, varying);
        const Result<Value> value = evaluate(*alternative.expression, here);
        if (!value) {
            const Diagnostics& found = value.diagnostics();
            if (takes_numbers(parameter.type) && std::all_of(found.begin(), found.end(), depends_on_values)) continue;
            return false;
        }
        if (!all_fit(alternative, *value, fixed_value)) return false;
    }
    return true;
}

bool ArgumentCheck::all_fit(const Alternative& alternative, const Value& value, bool fixed_value) const {
    const ValueList* list = std::get_if<ValueList>(&value.data);
    if (alternative.kind == Kind::items && list != nullptr) {
        return std::all_of(list->items.begin(), list->items.end(), [&](const Value& item) {
            return all_fit({alternative.expression, Kind::value}, item, fixed_value);
        });
    }
    if (parameter.type == ParameterType::flag && !fixed_value && std::holds_alternative<Quantity>(value.data)) {
        return false;
    }
    const Result<Value> result = converted(parameter, value, document, alternative.expression->span);
    if (result) return true;
    const bool free = !fixed_value || alternative.kind == Kind::range_end;
    return parameter.type != ParameterType::flag && free && depends_on_values(result.diagnostics().front());
}

Diagnostics ArgumentCheck::problems(const Expression& argument) const {
    Evaluation here = at;
    Diagnostics out = check_expression(argument, here);
    if (!out.empty()) return out;
    for (const Alternative& alternative : alternatives_of(argument, at.by_shape)) {
        here.by_shape = alternative.by_shape;
        const bool fixed_value = is_constant(*alternative.expression, here, fixed, varying);
        const bool fixed_choice =
            alternative.kind == Kind::range && uses_only(*alternative.expression, here, fixed, varying);
        Result<Value> value = evaluate(*alternative.expression, here);
        Diagnostics found;
        if (!value) {
            found = std::move(value).diagnostics();
        } else if (alternative.kind != Kind::range) {
            found = problems_of_value(alternative, *value);
        }
        if (!fixed_value && !fixed_choice) std::erase_if(found, depends_on_values);
        for (Diagnostic& problem : found) {
            if (std::find(out.begin(), out.end(), problem) == out.end()) out.push_back(std::move(problem));
        }
    }
    return out;
}

Diagnostics ArgumentCheck::problems_of_value(const Alternative& alternative, const Value& value) const {
    const ValueList* list = std::get_if<ValueList>(&value.data);
    if (alternative.kind == Kind::items && list != nullptr) {
        Diagnostics out;
        for (const Value& item : list->items) {
            out = problems_of_value({alternative.expression, Kind::value}, item);
            if (!out.empty()) break;
        }
        return out;
    }
    const SourceSpan span = alternative.expression->span;
    Result<Value> result = converted(parameter, value, document, span);
    if (!result) {
        Diagnostics out = std::move(result).diagnostics();
        // The ends of a whole range need not be whole themselves.
        if (alternative.kind == Kind::range_end) std::erase_if(out, depends_on_values);
        return out;
    }
    if (std::optional<Diagnostic> problem = out_of_range(parameter, *result, span)) return {*problem};
    return {};
}

namespace {

// What a preset's expressions know: the parameters before this one, then the step, then the document.
struct PresetExamples {
    Scope between, step, shape, parameters;
    std::vector<std::string_view> varying, of_any_kind;

    PresetExamples(const ParameterDescription& parameter, const Scope& globals,
                   std::span<const ParameterDescription> all, const Scope* varying_scope)
        : between(scope_between(globals, varying_scope)),
          step(example_scope(step_names(), &between)),
          shape(example_scope(shape_names(), nullptr)),
          parameters{&step},
          varying(varying_names(between)) {
        for (const ParameterDescription& earlier : all) {
            if (earlier.name == parameter.name) break;
            Value example = example_of(earlier);
            // No two alike, so that differences are hardly ever zero.
            if (Quantity* quantity = std::get_if<Quantity>(&example.data)) {
                quantity->value += 0.37 * static_cast<double>(parameters.names.size());
            }
            parameters.names.emplace(std::string(earlier.name), std::move(example));
            varying.push_back(earlier.name);
            if (earlier.type == ParameterType::any || earlier.type == ParameterType::direction ||
                earlier.type == ParameterType::form) {
                of_any_kind.push_back(earlier.name);
            }
        }
        shape.outer = &parameters;
    }
    PresetExamples(const PresetExamples&) = delete;
    PresetExamples& operator=(const PresetExamples&) = delete;

    void complete(Evaluation& at) const {
        at.scope = &parameters;
        at.shape_scope = &shape;
        at.shape_key = Key{};
    }
    // A wrong kind says nothing where the kind of a name is not known.
    Diagnostics certain(Diagnostics problems, const Expression& expression) const {
        const std::vector<NameInExpression> names = names_in(expression);
        const bool is_vague = std::any_of(names.begin(), names.end(), [this](const NameInExpression& name) {
            return std::find(of_any_kind.begin(), of_any_kind.end(), name.text) != of_any_kind.end();
        });
        if (is_vague) {
            std::erase_if(problems, [](const Diagnostic& one) { return one.code == "language.wrong-kind"; });
        }
        return problems;
    }
};

}  // namespace

Diagnostics check_preset_value(const ParameterDescription& parameter, const Expression& value, const Document& document,
                               const Scope& globals, std::span<const ParameterDescription> parameters,
                               const Scope* varying) {
    const PresetExamples examples(parameter, globals, parameters, varying);
    Evaluation at = expected_by(parameter, document, &examples.between);
    examples.complete(at);
    const ArgumentCheck check{parameter, document, &globals, examples.varying, at};
    return examples.certain(check.problems(value), value);
}

Diagnostics check_preset_condition(const ParameterDescription& parameter, const Expression& condition,
                                   const Document& document, const Scope& globals,
                                   std::span<const ParameterDescription> parameters, const Scope* varying) {
    const PresetExamples examples(parameter, globals, parameters, varying);
    Evaluation at;
    at.document = &document;
    examples.complete(at);
    return examples.certain(check_condition(condition, at, globals, examples.varying), condition);
}

}  // namespace filigree
