// Evaluating bound calls for one step; declared in bind.h.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "language/bind.h"
#include "language/parameter_value.h"
#include "language/walk.h"

namespace filigree {

namespace {

bool mentions(const Expression& expression, std::span<const std::string_view> wanted) {
    if (wanted.empty()) return false;
    const std::vector<NameInExpression> names = names_in(expression);
    return std::any_of(names.begin(), names.end(), [wanted](const NameInExpression& name) {
        return std::find(wanted.begin(), wanted.end(), name.text) != wanted.end();
    });
}

bool has_each(const Preset& preset) {
    return varies_by_shape(*preset.value) || (preset.condition && varies_by_shape(*preset.condition));
}

class ArgumentsEvaluator {
public:
    ArgumentsEvaluator(const BoundCall& call, const Document& document, const Scope& step_scope,
                       const StepChoices& choices, Key step, std::span<const ShapeContext> shapes)
        : call_(call), document_(document), step_scope_(step_scope), choices_(choices), step_(step), shapes_(shapes) {}

    Result<Arguments> run() {
        arguments_.description = call_.description;
        const std::size_t count = call_.description->parameters.size();
        arguments_.values.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::vector<const Preset*> presets = presets_in_force(choices_, parameter(i).name);
            if (call_.constants[i] && presets.empty() && !is_said_of_shapes(i)) {
                arguments_.values[i].common = *call_.constants[i];
            } else if ((call_.given[i] && presets.empty()) || diagnostics_.empty()) {  // others may need what failed
                take(i, presets);
            }
        }
        if (has_errors(diagnostics_)) return std::move(diagnostics_);
        return std::move(arguments_);
    }

private:
    const BoundCall& call_;
    const Document& document_;
    const Scope& step_scope_;
    const StepChoices& choices_;
    const Key step_;
    const std::span<const ShapeContext> shapes_;
    std::vector<const ShapeChoices*> choices_of_shapes_;  // null where there are none
    Arguments arguments_;
    Diagnostics diagnostics_;

    const ParameterDescription& parameter(std::size_t i) const { return call_.description->parameters[i]; }

    // The parameters before i as names, for its default and its presets.
    Scope earlier(std::size_t i, std::size_t shape) const {
        Scope scope{&step_scope_};
        for (std::size_t k = 0; k < i; ++k) {
            scope.names.emplace(std::string(parameter(k).name), arguments_.values[k].at(shape));
        }
        return scope;
    }
    std::vector<std::string_view> varying_before(std::size_t i) const {
        std::vector<std::string_view> names;
        for (std::size_t k = 0; k < i; ++k) {
            if (!arguments_.values[k].per_shape.empty()) names.push_back(parameter(k).name);
        }
        return names;
    }
    // Whether a preset of a single shape gives it a value.
    bool is_said_of_shapes(std::size_t i) const {
        return !shapes_.empty() &&
               std::any_of(choices_.shapes.begin(), choices_.shapes.end(), [&](const ShapeChoices& one) {
                   const auto said = values_for(*choices_.presets, one.accepted, parameter(i).name);
                   return said.size() > values_for(*choices_.presets, choices_.accepted, parameter(i).name).size();
               });
    }
    bool varies(std::size_t i, const std::vector<const Preset*>& presets) const {
        if (is_said_of_shapes(i)) return true;
        const std::vector<std::string_view> varying = varying_before(i);
        if (!call_.given[i] && !varying.empty()) return true;
        return varies_by_shape(*call_.expressions[i]) ||
               std::any_of(presets.begin(), presets.end(), [&](const Preset* preset) {
                   return has_each(*preset) || mentions(*preset->value, varying) ||
                          (preset->condition && mentions(*preset->condition, varying));
               });
    }

    const ShapeChoices* choices_of(std::size_t shape) {
        if (choices_.shapes.empty()) return nullptr;
        if (choices_of_shapes_.empty()) {
            choices_of_shapes_.resize(shapes_.size());
            for (const ShapeChoices& one : choices_.shapes) {
                if (one.shape < shapes_.size()) choices_of_shapes_[one.shape] = &one;
            }
        }
        return choices_of_shapes_[shape];
    }

    void take(std::size_t i, const std::vector<const Preset*>& presets) {
        ArgumentValue& argument = arguments_.values[i];
        if (!varies(i, presets)) {
            if (std::optional<Value> value = one(i, nullptr, 0, !presets.empty())) argument.common = std::move(*value);
            return;
        }
        if (shapes_.empty()) {
            argument.common = example_of(parameter(i));
            return;
        }
        std::vector<std::string> seen;  // names of the choices that are common to all shapes
        argument.per_shape.reserve(shapes_.size());
        for (std::size_t shape = 0; shape < shapes_.size(); ++shape) {
            const std::size_t recorded = choices_.record != nullptr ? choices_.record->rows.size() : 0;
            const bool has_presets = !presets.empty() || choices_of(shape) != nullptr;
            std::optional<Value> value = one(i, &shapes_[shape], shape, has_presets);
            if (!value) return;  // the others would only say the same
            argument.per_shape.push_back(std::move(*value));
            if (choices_.record != nullptr) drop_repeated(*choices_.record, recorded, seen);
        }
    }

    // Choices outside of each(...) are made at the step's key for every shape, with the same result.
    void drop_repeated(ChoiceBuffer& buffer, std::size_t first, std::vector<std::string>& seen) const {
        const auto is_repeated = [&](const ChoiceBuffer::Row& row) {
            if (row.key != step_) return false;
            const std::string& name = buffer.places[row.place].name;
            if (std::find(seen.begin(), seen.end(), name) != seen.end()) return true;
            seen.push_back(name);
            return false;
        };
        const auto fresh = buffer.rows.begin() + static_cast<std::ptrdiff_t>(first);
        buffer.rows.erase(std::remove_if(fresh, buffer.rows.end(), is_repeated), buffer.rows.end());
    }

    std::optional<Value> one(std::size_t i, const ShapeContext* shape, std::size_t index, bool has_presets) {
        const Expression* own = call_.constants[i] ? nullptr : call_.expressions[i].get();
        Evaluation at = call_.expected[i];
        at.document = &document_;
        at.site = {0, step_, std::string(parameter(i).name)};
        if (shape != nullptr) {
            at.shape_scope = &shape->scope;
            at.shape_key = shape->key;
        }
        Scope with_earlier;
        if (!call_.given[i] || has_presets) with_earlier = earlier(i, index);
        at.scope = call_.given[i] ? &step_scope_ : &with_earlier;
        if (!has_presets) return taken(i, decide(choices_, parameter(i).name, own, at));

        Evaluation of_presets = at;
        of_presets.scope = &with_earlier;
        Scope of_shape{&with_earlier};
        if (shape != nullptr) {
            of_shape.names = shape->scope.names;
            of_presets.shape_scope = &of_shape;
        }
        return taken(i, decide(choices_, parameter(i).name, own, at, &of_presets,
                               shape != nullptr ? choices_of(index) : nullptr));
    }

    // In the parameter's type.
    std::optional<Value> taken(std::size_t i, Result<std::optional<DecidedValue>> decided) {
        if (!decided) return fail(std::move(decided).diagnostics());
        if (!*decided) return *call_.constants[i];
        const Preset* preset = (*decided)->preset;
        const Document& document = preset != nullptr ? *preset->document : document_;
        const SourceSpan own_span = call_.given[i] ? call_.expressions[i]->span : call_.span;
        const SourceSpan span = preset != nullptr ? preset->value->span : own_span;
        Result<Value> result = converted(parameter(i), (*decided)->value, document, span);
        if (!result) return fail(std::move(result).diagnostics());
        if (std::optional<Diagnostic> problem = out_of_range(parameter(i), *result, span)) return fail({*problem});
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
                                     const StepChoices& choices, Key step, std::span<const ShapeContext> shapes) {
    return ArgumentsEvaluator(call, document, step_scope, choices, step, shapes).run();
}

bool presets_vary_by_shape(const BoundCall& call, const StepChoices& choices) {
    const auto& parameters = call.description->parameters;
    return std::any_of(parameters.begin(), parameters.end(), [&](const ParameterDescription& parameter) {
        const std::vector<const Preset*> presets = presets_in_force(choices, parameter.name);
        return std::any_of(presets.begin(), presets.end(), [](const Preset* preset) { return has_each(*preset); });
    });
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
