#include "language/shape_checks.h"

#include <cmath>

#include "language/check.h"
#include "language/shape_forms.h"

namespace filigree {
namespace {

class ExpressionChecks {
public:
    ExpressionChecks(const Document& document, const Scope& globals, const Scope* varying)
        : between_(scope_between(globals, varying)) {
        at_.document = &document;
        at_.scope = &globals;
        varying_ = at_;
        varying_.scope = &between_;
        for (const auto& [name, value] : between_.names) varying_names_.push_back(name);
    }

    Diagnostics diagnostics;

    void look_at(const StartStatement& start) {
        if (start.value) check_shape(*start.value, "a start", false);
    }
    void look_at(const ShapeRule& rule) {
        if (rule.derivation) return;
        check_shape(*rule.left, "the left side of a rule", false);
        check_shape(*rule.right, "the right side of a rule", false);
        for (const ExpressionPtr& forbidden : rule.unless) check_shape(*forbidden, "what is behind 'unless'", true);
        check(rule.weight, varying_, [](const Value& value) { return at_least(value, 0, "a weight"); });
        check(rule.priority, varying_, [](const Value& value) { return as_number(value).diagnostics(); });
        check(rule.condition, varying_, [](const Value& value) { return as_flag(value).diagnostics(); });
    }
    void look_at(const MatchStatement& match) {
        check(match.at, at_, [](const Value& value) {
            if (std::holds_alternative<Vec>(value.data)) return Diagnostics{};
            return Diagnostics{error("language.wrong-kind",
                                     "a match lies at a point, but this is " + std::string(kind_of(value)), {},
                                     {"a point is written (x, y)"})};
        });
        check_angle(match.angle);
        check(match.scale, at_, [](const Value& value) { return at_least(value, 1e-9, "a factor"); });
    }
    void look_at(const SettingStatement& setting) {
        if (setting.name.text == "steps") {
            check(setting.values.front(), at_, [](const Value& value) { return whole_from(value, 0, "'steps'"); });
        } else if (setting.name.text == "tolerance") {
            check(setting.values.front(), at_, [this](const Value& value) {
                const Result<double> px = as_length(value, *at_.document);
                if (!px || *px > 0) return px.diagnostics();
                return Diagnostics{error("language.out-of-range", "a tolerance must be above zero")};
            });
        }
    }
    template <class Other>
    void look_at(const Other&) {}

    void check_angle(const ExpressionPtr& angle) {
        check(angle, at_, [](const Value& value) { return as_angle(value).diagnostics(); });
    }

private:
    Scope between_;
    std::vector<std::string_view> varying_names_;
    Evaluation at_, varying_;

    static Diagnostics at_least(const Value& value, double least, std::string_view what) {
        const Result<double> number = as_number(value);
        if (!number || *number >= least) return number.diagnostics();
        return {error("language.out-of-range",
                      std::string(what) + (least > 0 ? " must be above zero" : " cannot be below zero"))};
    }
    static Diagnostics whole_from(const Value& value, double least, std::string_view what) {
        const Result<double> number = as_number(value);
        if (!number || (*number >= least && *number == std::floor(*number))) return number.diagnostics();
        return {error("language.out-of-range",
                      std::string(what) + " must be a whole number from " + (least > 0 ? "1" : "0"))};
    }

    template <class Convert>
    void check(const ExpressionPtr& expression, const Evaluation& at, Convert convert) {
        if (!expression) return;
        Diagnostics problems = check_expression(*expression, at);
        if (problems.empty()) {
            const Result<Value> value = evaluate(*expression, at);
            problems = value ? convert(*value) : value.diagnostics();
            if (value) {
                for (Diagnostic& problem : problems) problem.span = expression->span;
            }
            if (!is_certain(*expression, at)) std::erase_if(problems, depends_on_values);
        }
        append(diagnostics, std::move(problems));
    }
    // Whether its value is the same wherever it is evaluated.
    bool is_certain(const Expression& expression, const Evaluation& at) const {
        return !has_choice(expression) && uses_only(expression, at, at_.scope, varying_names_);
    }

    void check_shape(const Expression& expression, std::string_view what, bool takes_regions) {
        const Evaluation at = with_shapes(at_);
        Diagnostics problems = check_expression(expression, at);
        for (const Alternative& alternative : alternatives_of(expression)) {
            if (!problems.empty()) break;
            const Result<Value> value = evaluate(*alternative.expression, at);
            if (!value) continue;
            const std::optional<ShapeKind> kind = shape_kind(*value);
            if (kind == ShapeKind::shape || (kind == ShapeKind::region && takes_regions)) continue;
            problems.push_back(wrong_kind(*value, what, alternative.expression->span, takes_regions));
        }
        append(diagnostics, std::move(problems));
    }
    static Diagnostic wrong_kind(const Value& value, std::string_view what, SourceSpan span, bool takes_regions) {
        std::vector<std::string> hints;
        const std::optional<ShapeKind> kind = shape_kind(value);
        if (kind == ShapeKind::transform) hints = {"a transform is applied by '*', as in 'rotate(90) * shape'"};
        if (kind == ShapeKind::region) hints = {"a region stands behind 'unless'"};
        return error("language.wrong-kind",
                     std::string(what) + " must be a shape" + (takes_regions ? " or a region" : "") + ", but this is " +
                         std::string(kind_among_shapes(value)),
                     span, std::move(hints));
    }
};

}  // namespace

Diagnostics check_shape_expressions(const Document& document, const ShapeRules& rules, const Scope& globals,
                                    const Scope* varying) {
    ExpressionChecks checks(document, globals, varying);
    for (const NamedShapeRule& rule : rules.rules) checks.check_angle(rule.angle);
    for (const Statement& statement : document.statements) {
        std::visit([&checks](const auto& node) { checks.look_at(node); }, statement.node);
    }
    return std::move(checks.diagnostics);
}

}  // namespace filigree
