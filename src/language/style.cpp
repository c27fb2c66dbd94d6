#include "language/style.h"

#include <algorithm>

#include "language/style_values.h"

namespace filigree {

namespace {

void apply(StyleOverride& to, const StyleOverride& later) {
    if (later.fill) to.fill = later.fill;
    if (later.stroke) to.stroke = later.stroke;
    if (later.pen) to.pen = later.pen;
    if (later.corner) to.corner = later.corner;
    if (later.wobble) to.wobble = later.wobble;
    if (later.wobble_length) to.wobble_length = later.wobble_length;
    if (later.line) to.line = later.line;
}

// The styles of one shape, rule by rule.
class ShapeStyler {
public:
    ShapeStyler(const StyleSheet& sheet, const Scope& shape, Key key, const StyleChoices& choices)
        : sheet_(sheet),
          shape_(shape),
          key_(key),
          choices_(choices),
          at_(evaluation_for(*sheet.document, sheet.settings->globals, shape, key)) {}

    Result<StyleOverride> run(const TagStyle& of_tag) {
        StyleOverride out = of_tag.common;
        for (const std::uint32_t i : of_tag.rules) {
            const StyleRule& rule = sheet_.rules[i];
            StepChoices choices;
            choices.seed.value = sheet_.settings->seed;
            if (choices_) {
                Result<StepChoices> at_rule = choices_(rule.segment);
                if (!at_rule) return std::move(at_rule).diagnostics();
                choices = *at_rule;
                recorded_at_.key = child(key_, rule.segment);
                at_.site.recorded_at = &recorded_at_;
            }
            const Result<bool> holds = condition_holds(rule, choices);
            if (!holds) return holds.diagnostics();
            if (!*holds) continue;
            for (const StyleRuleProperty& property : rule.properties) {
                Result<StyleOverride> one = property_of(rule, property, choices);
                if (!one) return std::move(one).diagnostics();
                apply(out, *one);
            }
        }
        return out;
    }

private:
    const StyleSheet& sheet_;
    const Scope& shape_;
    const Key key_;
    const StyleChoices& choices_;
    ChoiceAddress recorded_at_;
    Evaluation at_;

    Result<std::optional<DecidedValue>> decided(const StyleRule& rule, std::string_view name, const Expression* own,
                                                const StepChoices& choices) {
        at_.site.name = rule.site + "." + std::string(name);
        recorded_at_.name = name;
        return decide(choices, name, own, at_);
    }

    Result<bool> condition_holds(const StyleRule& rule, const StepChoices& choices) {
        at_.words.clear();
        const Expression* own = rule.constant_condition ? nullptr : rule.condition.get();
        Result<std::optional<DecidedValue>> value = decided(rule, "when", own, choices);
        if (!value) return std::move(value).diagnostics();
        if (!*value) return rule.constant_condition.value_or(true);
        const Preset* preset = (*value)->preset;
        (*value)->value.span = preset != nullptr ? preset->value->span : rule.condition->span;
        return as_flag((*value)->value);
    }

    Result<StyleOverride> property_of(const StyleRule& rule, const StyleRuleProperty& property,
                                      const StepChoices& choices) {
        expect(at_, sheet_.paint_words, property.kind);
        const bool is_known = property.constant || !property.by_group.empty();
        const Expression* own = is_known ? nullptr : property.value.get();
        const Result<std::optional<DecidedValue>> value = decided(rule, name_of(property.kind), own, choices);
        if (!value) return value.diagnostics();
        if (*value) {
            const Preset* preset = (*value)->preset;
            return override_of(property.kind, (*value)->value, preset != nullptr ? *preset->document : *sheet_.document,
                               shape_, preset != nullptr ? preset->value->span : property.value->span);
        }
        if (property.constant) return *property.constant;
        StyleOverride out;
        (property.kind == StylePropertyKind::fill ? out.fill : out.stroke) = paint_for_group(property.by_group, shape_);
        return out;
    }
};

}  // namespace

TagStyle style_of_tag(const StyleSheet& sheet, std::string_view tag, bool may_be_preset) {
    TagStyle out;
    for (std::uint32_t i = 0; i < sheet.rules.size(); ++i) {
        const StyleRule& rule = sheet.rules[i];
        const bool matches = std::any_of(rule.tags.begin(), rule.tags.end(),
                                         [tag](const std::string& wanted) { return wanted == "*" || wanted == tag; });
        if (!matches || (rule.constant_condition == false && !may_be_preset)) continue;
        const bool always = !rule.condition || rule.constant_condition == true;
        const bool constant =
            always && !may_be_preset &&
            std::all_of(rule.properties.begin(), rule.properties.end(),
                        [](const StyleRuleProperty& property) { return property.constant.has_value(); });
        // Constant rules at the beginning are applied here; behind one that is not, order matters.
        if (constant && out.is_constant) {
            for (const StyleRuleProperty& property : rule.properties) apply(out.common, *property.constant);
        } else {
            out.is_constant = false;
            out.rules.push_back(i);
        }
    }
    return out;
}

Result<StyleOverride> style_of_shape(const StyleSheet& sheet, const TagStyle& of_tag, const Scope& shape, Key key,
                                     const StyleChoices& choices) {
    return ShapeStyler(sheet, shape, key, choices).run(of_tag);
}

}  // namespace filigree
