#include "language/bind.h"

#include <algorithm>

#include "base/number_text.h"
#include "language/check.h"
#include "language/names.h"
#include "language/parameter_value.h"
#include "language/parse.h"
#include "language/walk.h"

namespace filigree {

namespace {

using Kind = Alternative::Kind;

bool has_name(const ParameterDescription& parameter, std::string_view name) {
    return parameter.name == name ||
           std::find(parameter.aliases.begin(), parameter.aliases.end(), name) != parameter.aliases.end();
}
bool is_required(const ParameterDescription& parameter) { return parameter.default_text.empty(); }
bool takes_numbers(const ParameterDescription& parameter) {
    switch (parameter.type) {
        case ParameterType::whole:
        case ParameterType::real:
        case ParameterType::length:
        case ParameterType::angle:
        case ParameterType::direction:
        case ParameterType::lengths:
            return true;
        default:
            return false;
    }
}
std::string quoted(std::string_view name) { return "'" + std::string(name) + "'"; }

class Binder {
public:
    Binder(const OperatorDescription& description, SourceSpan call, const Document& document, const Scope& globals)
        : description_(description),
          document_(document),
          globals_(globals),
          example_step_(example_scope(step_names(), &globals)),
          example_shape_(example_scope(shape_names(), nullptr)) {
        const std::size_t count = description.parameters.size();
        bound_.description = &description;
        bound_.span = call;
        bound_.expressions.resize(count);
        bound_.given.resize(count);
        bound_.constants.resize(count);
        for (const ParameterDescription& parameter : description.parameters) {
            bound_.expected.push_back(expected_by(parameter, document, &globals));
        }
        broken_.resize(count);
    }

    Result<BoundCall> run(const std::vector<CallArgument>& arguments) {
        for (const CallArgument& argument : arguments) {
            if (argument.key) take_named(argument);
        }
        std::size_t next = 0;
        for (const CallArgument& argument : arguments) {
            if (!argument.key) next = take_positional(argument.value, next);
        }
        for (std::size_t i = 0; i < description_.parameters.size(); ++i) finish(i);
        if (has_errors(diagnostics_)) return std::move(diagnostics_);
        return {std::move(bound_), std::move(diagnostics_)};
    }

private:
    const OperatorDescription& description_;
    const Document& document_;
    const Scope& globals_;
    const Scope example_step_, example_shape_;
    BoundCall bound_;
    std::vector<bool> broken_;  // given, but already reported
    Diagnostics diagnostics_;

    const ParameterDescription& parameter(std::size_t i) const { return description_.parameters[i]; }
    void report(Diagnostic diagnostic) { diagnostics_.push_back(std::move(diagnostic)); }

    Evaluation example_evaluation(std::size_t i) const {
        Evaluation at = bound_.expected[i];
        at.scope = &example_step_;
        at.shape_scope = &example_shape_;
        at.shape_key = Key{};
        return at;
    }
    bool is_fixed(const Expression& expression, const Evaluation& at) const {
        return is_constant(expression, at, &globals_, step_names());
    }

    void take_named(const CallArgument& argument) {
        const auto* name = std::get_if<NameReference>(&argument.key->node);
        if (name == nullptr) {
            report(error("language.wrong-arguments", "the name of an argument is a bare word", argument.key->span));
            return;
        }
        for (std::size_t i = 0; i < description_.parameters.size(); ++i) {
            if (!has_name(parameter(i), name->name)) continue;
            if (bound_.given[i]) {
                report(error("language.doubled-argument", quoted(parameter(i).name) + " is given twice",
                             argument.key->span));
                return;
            }
            give(i, argument.value);
            return;
        }
        std::vector<std::string_view> names;
        for (const ParameterDescription& known : description_.parameters) {
            names.push_back(known.name);
            names.insert(names.end(), known.aliases.begin(), known.aliases.end());
        }
        std::vector<std::string> hints = did_you_mean(name->name, names);
        if (hints.empty()) hints.push_back(signature_hint());
        report(error("language.unknown-argument", quoted(description_.name) + " has no argument " + quoted(name->name),
                     argument.key->span, std::move(hints)));
    }

    std::string signature_hint() const {
        if (description_.parameters.empty()) return quoted(description_.name) + " takes no arguments";
        std::vector<std::string_view> names;
        for (const ParameterDescription& known : description_.parameters) names.push_back(known.name);
        std::string out = "its arguments are ";
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (i > 0) out += i + 1 == names.size() ? " and " : ", ";
            out += quoted(names[i]);
        }
        return out;
    }

    void give(std::size_t i, const ExpressionPtr& value) {
        bound_.given[i] = true;
        bound_.expressions[i] = value;
    }

    // The parameter behind the one that the argument went to.
    std::size_t take_positional(const ExpressionPtr& argument, std::size_t next) {
        if (!argument) return next;
        const std::size_t count = description_.parameters.size();
        for (std::size_t i = next; i < count; ++i) {
            if (bound_.given[i]) continue;
            if (fits(i, *argument)) {
                give(i, argument);
                return i + 1;
            }
            if (is_required(parameter(i))) {
                report_misfit(i, next, *argument);
                give(i, argument);
                broken_[i] = true;
                return i + 1;
            }
        }
        std::size_t first_free = next;
        while (first_free < count && bound_.given[first_free]) ++first_free;
        if (first_free < count) {
            report_misfit(first_free, next, *argument);
        } else {
            report(error("language.surplus-argument", quoted(description_.name) + " takes no further argument",
                         argument->span, {signature_hint()}));
        }
        return next;
    }

    // Why the argument does not go to parameter i, nor to the optional ones from `first` on.
    void report_misfit(std::size_t i, std::size_t first, const Expression& argument) {
        const auto* name = std::get_if<NameReference>(&argument.node);
        if (name != nullptr && example_step_.find(name->name) == nullptr) {
            Evaluation at = example_evaluation(i);
            for (std::size_t k = first; k < description_.parameters.size(); ++k) {
                if (k == i || bound_.given[k]) continue;
                const auto& words = bound_.expected[k].words;
                at.words.insert(at.words.end(), words.begin(), words.end());
            }
            report(unknown_name(name->name, argument.span, at, Place{}));
            return;
        }
        Diagnostics problems = problems_of(i, argument);
        if (problems.empty()) {
            problems.push_back(error(
                "language.wrong-kind",
                quoted(parameter(i).name) + " must be " + std::string(type_name(parameter(i).type)), argument.span));
        }
        append(diagnostics_, std::move(problems));
    }

    // Whether every alternative of the argument is of the parameter's type. Its range is looked at later, so
    // that a value out of range is reported and not passed on to the next parameter.
    bool fits(std::size_t i, const Expression& argument) const {
        Evaluation at = example_evaluation(i);
        for (const Alternative& alternative : alternatives_of(argument)) {
            if (alternative.kind == Kind::range) continue;
            at.by_shape = alternative.by_shape;
            const bool fixed = is_fixed(*alternative.expression, at);
            const Result<Value> value = evaluate(*alternative.expression, at);
            if (!value) {
                const Diagnostics& problems = value.diagnostics();
                if (takes_numbers(parameter(i)) && std::all_of(problems.begin(), problems.end(), depends_on_values)) {
                    continue;
                }
                return false;
            }
            if (!all_fit(i, alternative, *value, fixed)) return false;
        }
        return true;
    }
    bool all_fit(std::size_t i, const Alternative& alternative, const Value& value, bool fixed) const {
        const ValueList* list = std::get_if<ValueList>(&value.data);
        if (alternative.kind == Kind::items && list != nullptr) {
            return std::all_of(list->items.begin(), list->items.end(), [&](const Value& item) {
                return all_fit(i, {alternative.expression, Kind::value}, item, fixed);
            });
        }
        if (parameter(i).type == ParameterType::flag && !fixed && std::holds_alternative<Quantity>(value.data)) {
            return false;
        }
        const Result<Value> result = converted(parameter(i), value, document_, alternative.expression->span);
        if (result) return true;
        const bool free = !fixed || alternative.kind == Kind::range_end;
        return parameter(i).type != ParameterType::flag && free && depends_on_values(result.diagnostics().front());
    }

    Diagnostics problems_of(std::size_t i, const Expression& argument) const {
        Evaluation at = example_evaluation(i);
        Diagnostics out = check_expression(argument, at);
        if (!out.empty()) return out;
        for (const Alternative& alternative : alternatives_of(argument)) {
            at.by_shape = alternative.by_shape;
            const bool fixed = is_fixed(*alternative.expression, at);
            const bool fixed_choice =
                alternative.kind == Kind::range && uses_only(*alternative.expression, at, &globals_, step_names());
            Result<Value> value = evaluate(*alternative.expression, at);
            Diagnostics found;
            if (!value) {
                found = std::move(value).diagnostics();
            } else if (alternative.kind != Kind::range) {
                found = problems_of_value(i, alternative, *value);
            }
            if (!fixed && !fixed_choice) std::erase_if(found, depends_on_values);
            for (Diagnostic& problem : found) {
                if (std::find(out.begin(), out.end(), problem) == out.end()) out.push_back(std::move(problem));
            }
        }
        return out;
    }
    Diagnostics problems_of_value(std::size_t i, const Alternative& alternative, const Value& value) const {
        const ValueList* list = std::get_if<ValueList>(&value.data);
        if (alternative.kind == Kind::items && list != nullptr) {
            Diagnostics out;
            for (const Value& item : list->items) {
                out = problems_of_value(i, {alternative.expression, Kind::value}, item);
                if (!out.empty()) break;
            }
            return out;
        }
        const SourceSpan span = alternative.expression->span;
        Result<Value> result = converted(parameter(i), value, document_, span);
        if (!result) {
            Diagnostics out = std::move(result).diagnostics();
            // The ends of a whole range need not be whole themselves.
            if (alternative.kind == Kind::range_end) std::erase_if(out, depends_on_values);
            return out;
        }
        if (std::optional<Diagnostic> problem = out_of_range(parameter(i), *result, span)) return {*problem};
        return {};
    }

    void finish(std::size_t i) {
        if (broken_[i]) return;
        if (!bound_.given[i]) {
            take_default(i);
            return;
        }
        if (!bound_.expressions[i]) return;
        const Expression& expression = *bound_.expressions[i];
        Diagnostics problems = problems_of(i, expression);
        const bool wrong = !problems.empty();
        append(diagnostics_, std::move(problems));
        if (wrong || !is_fixed(expression, bound_.expected[i])) return;
        const Result<Value> value = evaluate(expression, bound_.expected[i]);
        if (!value) return append(diagnostics_, value.diagnostics());
        Result<Value> result = converted(parameter(i), *value, document_, expression.span);
        if (!result) return append(diagnostics_, std::move(result).diagnostics());
        bound_.constants[i] = std::move(*result);
    }

    void take_default(std::size_t i) {
        if (is_required(parameter(i))) {
            report(error("language.missing-argument",
                         quoted(description_.name) + " needs " + quoted(parameter(i).name) + ", " +
                             std::string(type_name(parameter(i).type)),
                         bound_.span, {signature_hint()}));
            return;
        }
        const auto broken_default = [&](const std::string& why) {
            report(fault(Fault::internal, "language.broken-description",
                         "the default of " + quoted(parameter(i).name) + " of " + quoted(description_.name) +
                             " is broken: " + why,
                         bound_.span));
        };
        Result<ExpressionPtr> parsed = parse_expression(parameter(i).default_text);
        if (!parsed) return broken_default(parsed.diagnostics().front().message);
        bound_.expressions[i] = *parsed;
        // Defaults know the parameters before them and the step, but no name of the document.
        bound_.expected[i] = expected_by(parameter(i), document_, nullptr);
        const Evaluation& at = bound_.expected[i];
        if (!is_constant(**parsed, at, nullptr, {})) return;
        const Result<Value> value = evaluate(**parsed, at);
        if (!value) return broken_default(value.diagnostics().front().message);
        Result<Value> result = converted(parameter(i), *value, document_, bound_.span);
        if (!result) return broken_default(result.diagnostics().front().message);
        if (const auto problem = out_of_range(parameter(i), *result, bound_.span)) {
            return broken_default(problem->message);
        }
        bound_.constants[i] = std::move(*result);
    }
};

}  // namespace

Result<BoundCall> bind(const OperatorDescription& description, const std::vector<CallArgument>& arguments,
                       SourceSpan call, const Document& document, const Scope& globals) {
    return Binder(description, call, document, globals).run(arguments);
}

}  // namespace filigree
