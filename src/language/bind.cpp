#include "language/bind.h"

#include <algorithm>

#include "language/argument_check.h"
#include "language/names.h"
#include "language/parameter_value.h"
#include "language/parse.h"

namespace filigree {

namespace {

bool is_required(const ParameterDescription& parameter) { return parameter.default_text.empty(); }
std::string quoted(std::string_view name) { return "'" + std::string(name) + "'"; }

class Binder {
public:
    Binder(const OperatorDescription& description, SourceSpan call, const Document& document, const Scope& globals,
           const Scope* varying)
        : description_(description),
          document_(document),
          globals_(globals),
          between_(scope_between(globals, varying)),
          example_step_(example_scope(step_names(), &between_)),
          example_shape_(example_scope(shape_names(), nullptr)),
          varying_(varying_names(between_)) {
        const std::size_t count = description.parameters.size();
        bound_.description = &description;
        bound_.span = call;
        bound_.expressions.resize(count);
        bound_.given.resize(count);
        bound_.constants.resize(count);
        for (const ParameterDescription& parameter : description.parameters) {
            bound_.expected.push_back(expected_by(parameter, document, &between_));
            bound_.expected.back().scope = &globals;
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
    const Scope between_, example_step_, example_shape_;
    const std::vector<std::string_view> varying_;
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
    ArgumentCheck check(std::size_t i) const {
        return {parameter(i), document_, &globals_, varying_, example_evaluation(i)};
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
            if (check(i).fits(*argument)) {
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
        Diagnostics problems = check(i).problems(argument);
        if (problems.empty()) {
            problems.push_back(error(
                "language.wrong-kind",
                quoted(parameter(i).name) + " must be " + std::string(type_name(parameter(i).type)), argument.span));
        }
        append(diagnostics_, std::move(problems));
    }

    void finish(std::size_t i) {
        if (broken_[i]) return;
        if (!bound_.given[i]) {
            take_default(i);
            return;
        }
        if (!bound_.expressions[i]) return;
        const Expression& expression = *bound_.expressions[i];
        const ArgumentCheck checked = check(i);
        Diagnostics problems = checked.problems(expression);
        const bool wrong = !problems.empty();
        append(diagnostics_, std::move(problems));
        if (wrong || !checked.is_fixed(expression)) return;
        const Result<Value> value = evaluate(expression, bound_.expected[i]);
        if (!value) return append(diagnostics_, value.diagnostics());
        Result<Value> result = converted(parameter(i), *value, document_, expression.span);
        if (!result) return append(diagnostics_, std::move(result).diagnostics());
        bound_.constants[i] = std::move(*result);
    }

    std::vector<std::string_view> names_in_defaults() const {
        std::vector<std::string_view> names = varying_;
        for (const ParameterDescription& known : description_.parameters) names.push_back(known.name);
        return names;
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
        if (!is_constant(**parsed, at, nullptr, names_in_defaults())) return;
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
                       SourceSpan call, const Document& document, const Scope& globals, const Scope* varying) {
    return Binder(description, call, document, globals, varying).run(arguments);
}

}  // namespace filigree
