// Reading and checking styles; declared in style.h.
#include <algorithm>
#include <span>

#include "base/number_text.h"
#include "language/check.h"
#include "language/names.h"
#include "language/style_values.h"

namespace filigree {

namespace {

bool has_choice_anywhere(const StyleStatement& statement) {
    if (statement.condition && has_choice(*statement.condition)) return true;
    return std::any_of(statement.properties.begin(), statement.properties.end(),
                       [](const StyleProperty& property) { return has_choice(*property.value); });
}

// Errors that depend on values count only where every shape has the same.
Diagnostics certain(Diagnostics problems, bool is_fixed) {
    if (!is_fixed) std::erase_if(problems, depends_on_values);
    return problems;
}

void append_new(Diagnostics& to, Diagnostics from) {
    for (Diagnostic& problem : from) {
        if (std::find(to.begin(), to.end(), problem) == to.end()) to.push_back(std::move(problem));
    }
}

// Checks expressions of styles; `at` has the names of an example shape.
class StyleCheck {
public:
    StyleCheck(const Document& document, const Scope& globals, std::span<const std::string_view> names)
        : document_(document),
          globals_(globals),
          names_(names),
          paint_words_(paint_words_beside(globals)),
          shape_(example_scope(names, nullptr)) {}

    const std::vector<std::string_view>& paint_words() const { return paint_words_; }
    const Scope& example_shape() const { return shape_; }
    Evaluation example() const { return evaluation_for(document_, globals_, shape_, Key{}); }
    Evaluation example(StylePropertyKind kind) const {
        Evaluation at = example();
        expect(at, paint_words_, kind);
        return at;
    }
    bool is_fixed(const Expression& expression, const Evaluation& at) const {
        return is_constant(expression, at, &globals_, names_);
    }

    // And what the condition is, where all shapes have the same.
    Diagnostics problems_of_condition(const Expression& condition, std::optional<bool>& constant) const {
        const Evaluation at = example();
        Diagnostics problems = check_expression(condition, at);
        if (!problems.empty()) return problems;
        const bool fixed = is_fixed(condition, at);
        Result<Value> value = evaluate(condition, at);
        if (!value) return certain(std::move(value).diagnostics(), fixed);
        value->span = condition.span;
        const Result<bool> flag = as_flag(*value);
        if (!flag) return certain(flag.diagnostics(), fixed);
        if (fixed) constant = *flag;
        return {};
    }

    Diagnostics problems_of(StylePropertyKind kind, const Expression& expression) const {
        Evaluation at = example(kind);
        Diagnostics problems = check_expression(expression, at);
        if (!problems.empty()) return problems;
        for (const Alternative& alternative : alternatives_of(expression, true)) {
            const bool fixed = is_fixed(*alternative.expression, at);
            const bool fixed_choice = alternative.kind == Alternative::Kind::range &&
                                      uses_only(*alternative.expression, at, &globals_, names_);
            const Result<Value> value = evaluate(*alternative.expression, at);
            if (!value) {
                append_new(problems, certain(value.diagnostics(), fixed || fixed_choice));
            } else if (alternative.kind != Alternative::Kind::range) {
                const Result<StyleOverride> result =
                    override_of(kind, *value, document_, shape_, alternative.expression->span);
                if (!result) append_new(problems, certain(result.diagnostics(), fixed));
            }
        }
        return problems;
    }

private:
    const Document& document_;
    const Scope& globals_;
    const std::span<const std::string_view> names_;  // of what a style is asked for
    const std::vector<std::string_view> paint_words_;
    const Scope shape_;
};

class StyleReader {
public:
    StyleReader(const Settings& settings, const Document& document)
        : settings_(settings),
          document_(document),
          check_(document, settings.globals, settings.engine == "rewriting" ? word_style_names() : style_names()) {}

    Result<StyleSheet> run() {
        StyleSheet sheet{&document_, &settings_, {}, check_.paint_words()};
        std::uint64_t number = 0, drawing = 0;
        for (const StyleStatement* statement : settings_.styles) {
            StyleRule rule;
            for (const Name& tag : statement->tags) rule.tags.push_back(tag.text);
            if (has_choice_anywhere(*statement)) ++drawing;
            rule.segment = style_segment(++number);
            rule.site = "style#" + to_text(drawing);
            if (statement->condition) {
                rule.condition = statement->condition;
                append_new(diagnostics_, check_.problems_of_condition(*rule.condition, rule.constant_condition));
            }
            for (const StyleProperty& property : statement->properties) read_property(rule, property);
            sheet.rules.push_back(std::move(rule));
        }
        if (has_errors(diagnostics_)) return std::move(diagnostics_);
        return {std::move(sheet), std::move(diagnostics_)};
    }

private:
    const Settings& settings_;
    const Document& document_;
    const StyleCheck check_;
    Diagnostics diagnostics_;

    void read_property(StyleRule& rule, const StyleProperty& property) {
        const std::string& name = property.name.text;
        const std::optional<StylePropertyKind> kind = find_style_property(name);
        if (!kind) {
            std::vector<std::string> hints = did_you_mean(name, style_property_names());
            if (hints.empty())
                hints.push_back("the properties are fill, stroke, pen, corner, line, wobble and wobble_length");
            diagnostics_.push_back(error("language.unknown-property", "there is no property '" + name + "'",
                                         property.name.span, std::move(hints)));
            return;
        }
        Diagnostics problems = check_.problems_of(*kind, *property.value);
        if (!problems.empty()) return append_new(diagnostics_, std::move(problems));
        // Of two that say the same, the later counts.
        std::erase_if(rule.properties, [kind](const StyleRuleProperty& earlier) { return earlier.kind == *kind; });
        rule.properties.push_back(completed({*kind, property.value}));
    }

    // With what is the same for all shapes, or for all of a group.
    StyleRuleProperty completed(StyleRuleProperty property) {
        const Evaluation at = check_.example(property.kind);
        if (!check_.is_fixed(*property.value, at)) return property;
        const Result<Value> value = evaluate(*property.value, at);
        if (!value) {
            append_new(diagnostics_, value.diagnostics());
            return property;
        }
        const SourceSpan span = property.value->span;
        if (depends_on_group(property.kind, *value)) {
            Result<Paints> paints = paints_of(property.kind, *value, span);
            if (paints) property.by_group = std::move(paints->items);
        } else {
            Result<StyleOverride> constant =
                override_of(property.kind, *value, document_, check_.example_shape(), span);
            if (constant) property.constant = *constant;
        }
        return property;
    }
};

}  // namespace

std::string style_segment(std::size_t number) {
    return number == 1 ? "style" : "style#" + to_text(std::uint64_t{number});
}

Result<StyleSheet> read_styles(const Settings& settings, const Document& document) {
    return StyleReader(settings, document).run();
}

Diagnostics check_style_preset(std::string_view property, const Expression& value, const Document& document,
                               const Scope& globals) {
    const StyleCheck check(document, globals, style_names());
    std::optional<bool> constant;
    if (property == "when") return check.problems_of_condition(value, constant);
    const std::optional<StylePropertyKind> kind = find_style_property(property);
    return kind ? check.problems_of(*kind, value) : Diagnostics{};
}

}  // namespace filigree
