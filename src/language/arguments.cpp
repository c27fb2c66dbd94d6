// Evaluating bound calls for one step; declared in bind.h.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "language/bind.h"
#include "language/parameter_value.h"

namespace filigree {

namespace {

// Some value of the parameter's type, for a step without shapes, which nothing is done with.
Value neutral(const ParameterDescription& parameter) {
    const double number = std::min(std::max(1.0, parameter.low), parameter.high);
    switch (parameter.type) {
        case ParameterType::whole:
        case ParameterType::real:
            return {Quantity{number, 0, false}, {}};
        case ParameterType::length:
            return {Quantity{number, 1, false}, {}};
        case ParameterType::angle:
        case ParameterType::direction:
            return {Quantity{number, 0, true}, {}};
        case ParameterType::flag:
            return {false, {}};
        case ParameterType::word:
            return {Symbol{std::string(parameter.words.empty() ? "" : parameter.words.front())}, {}};
        case ParameterType::lengths:
            return {ValueList{{Value{Quantity{number, 1, false}, {}}}}, {}};
        case ParameterType::text:
            return {std::string(), {}};
        case ParameterType::point:
            return {Vec{}, {}};
        case ParameterType::colour:
            return {Colour{}, {}};
    }
    return {};
}

class ArgumentsEvaluator {
public:
    ArgumentsEvaluator(const BoundCall& call, const Document& document, const Scope& step_scope, std::uint64_t seed,
                       Key step, std::span<const ShapeContext> shapes)
        : call_(call), document_(document), step_scope_(step_scope), seed_(seed), step_(step), shapes_(shapes) {}

    Result<Arguments> run() {
        arguments_.description = call_.description;
        const std::size_t count = call_.description->parameters.size();
        arguments_.values.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            if (call_.constants[i]) {
                arguments_.values[i].common = *call_.constants[i];
            } else if (call_.given[i] || diagnostics_.empty()) {  // a default may need what failed
                take(i);
            }
        }
        if (has_errors(diagnostics_)) return std::move(diagnostics_);
        return std::move(arguments_);
    }

private:
    const BoundCall& call_;
    const Document& document_;
    const Scope& step_scope_;
    const std::uint64_t seed_;
    const Key step_;
    const std::span<const ShapeContext> shapes_;
    Arguments arguments_;
    Diagnostics diagnostics_;

    // The parameters before i as names, for its default.
    Scope earlier(std::size_t i, std::size_t shape) const {
        Scope scope{&step_scope_};
        for (std::size_t k = 0; k < i; ++k) {
            scope.names.emplace(std::string(call_.description->parameters[k].name), arguments_.values[k].at(shape));
        }
        return scope;
    }
    bool varies_before(std::size_t i) const {
        for (std::size_t k = 0; k < i; ++k) {
            if (!arguments_.values[k].per_shape.empty()) return true;
        }
        return false;
    }

    void take(std::size_t i) {
        const bool is_default = !call_.given[i];
        ArgumentValue& argument = arguments_.values[i];
        if (!varies_by_shape(*call_.expressions[i]) && !(is_default && varies_before(i))) {
            if (std::optional<Value> value = one(i, nullptr, 0)) argument.common = std::move(*value);
            return;
        }
        if (shapes_.empty()) {
            argument.common = neutral(call_.description->parameters[i]);
            return;
        }
        argument.per_shape.reserve(shapes_.size());
        for (std::size_t shape = 0; shape < shapes_.size(); ++shape) {
            std::optional<Value> value = one(i, &shapes_[shape], shape);
            if (!value) return;  // the others would only say the same
            argument.per_shape.push_back(std::move(*value));
        }
    }

    std::optional<Value> one(std::size_t i, const ShapeContext* shape, std::size_t index) {
        const ParameterDescription& parameter = call_.description->parameters[i];
        const Expression& expression = *call_.expressions[i];
        Scope scope_of_default;
        Evaluation at = call_.expected[i];
        at.document = &document_;
        at.scope = &step_scope_;
        if (!call_.given[i]) {
            scope_of_default = earlier(i, index);
            at.scope = &scope_of_default;
        }
        at.site = {seed_, step_, std::string(parameter.name)};
        if (shape != nullptr) {
            at.shape_scope = &shape->scope;
            at.shape_key = shape->key;
        }
        const SourceSpan span = call_.given[i] ? expression.span : call_.span;
        Result<Value> value = evaluate(expression, at);
        if (!value) return fail(std::move(value).diagnostics());
        Result<Value> result = converted(parameter, *value, document_, span);
        if (!result) return fail(std::move(result).diagnostics());
        if (std::optional<Diagnostic> problem = out_of_range(parameter, *result, span)) return fail({*problem});
        return std::move(*result);
    }

    // Problems inside a default are problems of the call.
    std::nullopt_t fail(Diagnostics problems) {
        for (Diagnostic& problem : problems) {
            if (problem.span.file == SourceSpan::no_file) problem.span = call_.span;
        }
        append(diagnostics_, std::move(problems));
        return std::nullopt;
    }
};

// Asking for a parameter that the description does not have, or has with another type, is our own fault.
[[noreturn]] void broken(std::string_view name) {
    std::fprintf(stderr, "filigree: internal error: no parameter '%.*s' of this type\n", static_cast<int>(name.size()),
                 name.data());
    std::abort();
}

template <class T>
const T& data_of(const Arguments& arguments, std::string_view name, std::size_t shape) {
    const T* data = std::get_if<T>(&arguments.value(name, shape).data);
    if (data == nullptr) broken(name);
    return *data;
}

}  // namespace

Result<Arguments> evaluate_arguments(const BoundCall& call, const Document& document, const Scope& step_scope,
                                     std::uint64_t seed, Key step, std::span<const ShapeContext> shapes) {
    return ArgumentsEvaluator(call, document, step_scope, seed, step, shapes).run();
}

const Value& Arguments::value(std::string_view name, std::size_t shape) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (description->parameters[i].name == name) return values[i].at(shape);
    }
    broken(name);
}

double Arguments::number(std::string_view name, std::size_t shape) const {
    return data_of<Quantity>(*this, name, shape).value;
}

bool Arguments::flag(std::string_view name, std::size_t shape) const { return data_of<bool>(*this, name, shape); }

std::string_view Arguments::word(std::string_view name, std::size_t shape) const {
    return data_of<Symbol>(*this, name, shape).name;
}

std::vector<double> Arguments::lengths(std::string_view name, std::size_t shape) const {
    std::vector<double> out;
    for (const Value& item : data_of<ValueList>(*this, name, shape).items) {
        const Quantity* quantity = std::get_if<Quantity>(&item.data);
        if (quantity == nullptr) broken(name);
        out.push_back(quantity->value);
    }
    return out;
}

}  // namespace filigree
