#include "language/style.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/number_text.h"
#include "language/check.h"
#include "language/colour_words.h"
#include "language/names.h"

namespace filigree {

namespace {

struct PropertyName {
    std::string_view name;
    StylePropertyKind kind;
};
constexpr std::array<PropertyName, 6> property_names = {{
    {"fill", StylePropertyKind::fill},
    {"stroke", StylePropertyKind::stroke},
    {"pen", StylePropertyKind::pen},
    {"stroke-width", StylePropertyKind::pen},
    {"corner", StylePropertyKind::corner},
    {"stroke-linejoin", StylePropertyKind::corner},
}};

struct CornerName {
    std::string_view name;
    Corner corner;
};
constexpr std::array<CornerName, 4> corner_names = {{
    {"round", Corner::round},
    {"mitre", Corner::mitre},
    {"miter", Corner::mitre},
    {"bevel", Corner::bevel},
}};

constexpr double largest_pen = 1e6;  // px

std::string quoted(std::string_view name) { return "'" + std::string(name) + "'"; }

// An evaluation for one shape: the whole expression stands inside each(...).
Evaluation evaluation_for(const StyleSheet& sheet, const Scope& shape, Key key) {
    Evaluation at;
    at.document = sheet.document;
    at.scope = &sheet.settings->globals;
    at.shape_scope = &shape;
    at.shape_key = key;
    at.by_shape = true;
    at.site.seed = sheet.settings->seed;
    return at;
}

void expect(Evaluation& at, const StyleSheet& sheet, StylePropertyKind kind) {
    at.words.clear();
    if (kind == StylePropertyKind::corner) {
        for (const CornerName& name : corner_names) at.words.push_back(name.name);
    } else if (kind != StylePropertyKind::pen) {
        at.words = sheet.paint_words;
    }
}

std::string_view name_of(StylePropertyKind kind) {
    return std::find_if(property_names.begin(), property_names.end(),
                        [kind](const PropertyName& property) { return property.kind == kind; })
        ->name;
}

// One colour or none, or a list of them.
struct Paints {
    std::vector<StyleOverride::Paint> items;
    bool is_list = false;
};
Result<Paints> paints_of(StylePropertyKind kind, const Value& value, SourceSpan span) {
    const auto one = [&](const Value& item) -> Result<StyleOverride::Paint> {
        const Symbol* symbol = std::get_if<Symbol>(&item.data);
        if (symbol != nullptr && symbol->name == "none") return StyleOverride::Paint{};
        const Result<Colour> colour = as_colour(item);
        if (colour) return StyleOverride::Paint{*colour};
        return error("language.wrong-kind",
                     quoted(name_of(kind)) + " must be a colour or none, but this is " + std::string(kind_of(item)),
                     span, colour.diagnostics().front().hints);
    };
    Paints out;
    const ValueList* list = std::get_if<ValueList>(&value.data);
    if (list == nullptr) {
        Result<StyleOverride::Paint> paint = one(value);
        if (!paint) return std::move(paint).diagnostics();
        out.items.push_back(*paint);
        return out;
    }
    out.is_list = true;
    for (const Value& item : list->items) {
        Result<StyleOverride::Paint> paint = one(item);
        if (!paint) return std::move(paint).diagnostics();
        out.items.push_back(*paint);
    }
    if (out.items.empty()) {
        return error("language.wrong-kind", quoted(name_of(kind)) + " must be a colour, but this list is empty", span);
    }
    return out;
}

// The group's own colour of a list: the first one for group 1, over and over.
StyleOverride::Paint paint_for_group(const std::vector<StyleOverride::Paint>& paints, const Scope& shape) {
    const Value* group = shape.find("group");
    const Quantity* number = group != nullptr ? std::get_if<Quantity>(&group->data) : nullptr;
    const double place = number != nullptr && std::isfinite(number->value) ? std::floor(number->value) - 1 : 0;
    const double count = static_cast<double>(paints.size());
    double index = std::fmod(place, count);
    if (index < 0) index += count;
    return paints[static_cast<std::size_t>(index)];
}

Result<double> pen_of(const Value& value, const Document& document, SourceSpan span) {
    const Result<double> px = as_length(value, document);
    if (!px) {
        Diagnostic diagnostic = px.diagnostics().front();
        if (diagnostic.code == "language.wrong-kind") {
            diagnostic.message = "'pen' must be a length, but this is " + std::string(kind_of(value));
        }
        diagnostic.span = span;
        return diagnostic;
    }
    if (*px >= 0 && *px <= largest_pen) return *px;
    return error("language.out-of-range", "'pen' must be from 0px to 1000000px, but this is " + to_text(*px) + "px",
                 span);
}

Result<Corner> corner_of(const Value& value, SourceSpan span) {
    if (const Symbol* symbol = std::get_if<Symbol>(&value.data)) {
        for (const CornerName& name : corner_names) {
            if (name.name == symbol->name) return name.corner;
        }
    }
    return error("language.wrong-kind",
                 "'corner' must be round, mitre or bevel, but this is " + std::string(kind_of(value)), span);
}

// Whether the same value gives every shape the same property.
bool depends_on_group(StylePropertyKind kind, const Value& value) {
    const ValueList* list = std::get_if<ValueList>(&value.data);
    return list != nullptr && list->items.size() > 1 &&
           (kind == StylePropertyKind::fill || kind == StylePropertyKind::stroke);
}

// The property as an override of its own.
Result<StyleOverride> override_of(StylePropertyKind kind, const Value& value, const Document& document,
                                  const Scope& shape, SourceSpan span) {
    StyleOverride out;
    switch (kind) {
        case StylePropertyKind::fill:
        case StylePropertyKind::stroke: {
            Result<Paints> paints = paints_of(kind, value, span);
            if (!paints) return std::move(paints).diagnostics();
            (kind == StylePropertyKind::fill ? out.fill : out.stroke) =
                paints->is_list ? paint_for_group(paints->items, shape) : paints->items[0];
            return out;
        }
        case StylePropertyKind::pen: {
            Result<double> pen = pen_of(value, document, span);
            if (!pen) return std::move(pen).diagnostics();
            out.pen = *pen;
            return out;
        }
        case StylePropertyKind::corner: {
            Result<Corner> corner = corner_of(value, span);
            if (!corner) return std::move(corner).diagnostics();
            out.corner = *corner;
            return out;
        }
    }
    return out;
}

void apply(StyleOverride& to, const StyleOverride& later) {
    if (later.fill) to.fill = later.fill;
    if (later.stroke) to.stroke = later.stroke;
    if (later.pen) to.pen = later.pen;
    if (later.corner) to.corner = later.corner;
}

bool has_choice_anywhere(const StyleStatement& statement) {
    if (statement.condition && has_choice(*statement.condition)) return true;
    return std::any_of(statement.properties.begin(), statement.properties.end(),
                       [](const StyleProperty& property) { return has_choice(*property.value); });
}

class StyleReader {
public:
    StyleReader(const Settings& settings, const Document& document)
        : example_shape_(example_scope(style_names(), nullptr)) {
        sheet_.settings = &settings;
        sheet_.document = &document;
        sheet_.paint_words = colour_words_beside(&settings.globals);
        sheet_.paint_words.push_back("none");
    }

    Result<StyleSheet> run() {
        std::uint64_t drawing = 0;
        for (const StyleStatement* statement : sheet_.settings->styles) {
            StyleRule rule;
            for (const Name& tag : statement->tags) rule.tags.push_back(tag.text);
            // Numbered among those that draw, so that plain statements between them change no picture.
            if (has_choice_anywhere(*statement)) ++drawing;
            rule.site = "style#" + to_text(drawing);
            if (statement->condition) read_condition(rule, statement->condition);
            for (const StyleProperty& property : statement->properties) read_property(rule, property);
            sheet_.rules.push_back(std::move(rule));
        }
        if (has_errors(diagnostics_)) return std::move(diagnostics_);
        return {std::move(sheet_), std::move(diagnostics_)};
    }

private:
    StyleSheet sheet_;
    const Scope example_shape_;
    Diagnostics diagnostics_;

    Evaluation example() const { return evaluation_for(sheet_, example_shape_, Key{}); }
    bool is_fixed(const Expression& expression, const Evaluation& at) const {
        return is_constant(expression, at, &sheet_.settings->globals, style_names());
    }
    // Adds what is wrong; of what varies from shape to shape only what is wrong for all of them.
    bool is_clean(Diagnostics problems, bool is_fixed) {
        if (!is_fixed) std::erase_if(problems, depends_on_values);
        for (Diagnostic& problem : problems) {
            if (std::find(diagnostics_.begin(), diagnostics_.end(), problem) == diagnostics_.end()) {
                diagnostics_.push_back(std::move(problem));
            }
        }
        return problems.empty();
    }

    void read_condition(StyleRule& rule, const ExpressionPtr& condition) {
        rule.condition = condition;
        const Evaluation at = example();
        if (!is_clean(check_expression(*condition, at), true)) return;
        const bool fixed = is_fixed(*condition, at);
        Result<Value> value = evaluate(*condition, at);
        if (!value) {
            is_clean(std::move(value).diagnostics(), fixed);
            return;
        }
        value->span = condition->span;
        const Result<bool> flag = as_flag(*value);
        if (!flag) {
            is_clean(flag.diagnostics(), fixed);
        } else if (fixed) {
            rule.constant_condition = *flag;
        }
    }

    void read_property(StyleRule& rule, const StyleProperty& property) {
        const auto known = std::find_if(property_names.begin(), property_names.end(),
                                        [&](const PropertyName& name) { return name.name == property.name.text; });
        if (known == property_names.end()) {
            std::vector<std::string_view> names;
            for (const PropertyName& name : property_names) names.push_back(name.name);
            std::vector<std::string> hints = did_you_mean(property.name.text, names);
            if (hints.empty()) hints.push_back("the properties are fill, stroke, pen and corner");
            diagnostics_.push_back(error("language.unknown-property",
                                         "there is no property " + quoted(property.name.text), property.name.span,
                                         std::move(hints)));
            return;
        }
        StyleRuleProperty out{known->kind, property.value};
        Evaluation at = example();
        expect(at, sheet_, known->kind);
        if (!is_clean(check_expression(*property.value, at), true)) return;
        if (!check_alternatives(known->kind, *property.value, at)) return;
        if (is_fixed(*property.value, at)) {
            const Result<Value> value = evaluate(*property.value, at);
            if (!value) {
                is_clean(value.diagnostics(), true);
                return;
            }
            if (depends_on_group(known->kind, *value)) {
                Result<Paints> paints = paints_of(known->kind, *value, property.value->span);
                if (paints) out.by_group = std::move(paints->items);
            } else {
                Result<StyleOverride> constant =
                    override_of(known->kind, *value, *sheet_.document, example_shape_, property.value->span);
                if (constant) out.constant = *constant;
            }
        }
        rule.properties.push_back(std::move(out));
    }

    bool check_alternatives(StylePropertyKind kind, const Expression& expression, Evaluation at) {
        bool clean = true;
        for (const Alternative& alternative : alternatives_of(expression, true)) {
            const bool fixed = is_fixed(*alternative.expression, at);
            const bool fixed_choice = alternative.kind == Alternative::Kind::range &&
                                      uses_only(*alternative.expression, at, &sheet_.settings->globals, style_names());
            const Result<Value> value = evaluate(*alternative.expression, at);
            if (!value) {
                clean = is_clean(value.diagnostics(), fixed || fixed_choice) && clean;
            } else if (alternative.kind != Alternative::Kind::range) {
                const Result<StyleOverride> result =
                    override_of(kind, *value, *sheet_.document, example_shape_, alternative.expression->span);
                if (!result) clean = is_clean(result.diagnostics(), fixed) && clean;
            }
        }
        return clean;
    }
};

}  // namespace

Result<StyleSheet> read_styles(const Settings& settings, const Document& document) {
    return StyleReader(settings, document).run();
}

TagStyle style_of_tag(const StyleSheet& sheet, std::string_view tag) {
    TagStyle out;
    for (std::uint32_t i = 0; i < sheet.rules.size(); ++i) {
        const StyleRule& rule = sheet.rules[i];
        const bool matches = std::any_of(rule.tags.begin(), rule.tags.end(),
                                         [tag](const std::string& wanted) { return wanted == "*" || wanted == tag; });
        if (!matches || rule.constant_condition == false) continue;
        const bool always = !rule.condition || rule.constant_condition == true;
        const bool constant =
            always && std::all_of(rule.properties.begin(), rule.properties.end(),
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

Result<StyleOverride> style_of_shape(const StyleSheet& sheet, const TagStyle& of_tag, const Scope& shape, Key key) {
    StyleOverride out = of_tag.common;
    Evaluation at = evaluation_for(sheet, shape, key);
    for (const std::uint32_t i : of_tag.rules) {
        const StyleRule& rule = sheet.rules[i];
        if (rule.condition && !rule.constant_condition) {
            at.words.clear();
            at.site.name = rule.site + ".when";
            Result<Value> value = evaluate(*rule.condition, at);
            if (!value) return std::move(value).diagnostics();
            value->span = rule.condition->span;
            Result<bool> flag = as_flag(*value);
            if (!flag) return std::move(flag).diagnostics();
            if (!*flag) continue;
        }
        for (const StyleRuleProperty& property : rule.properties) {
            if (property.constant) {
                apply(out, *property.constant);
                continue;
            }
            if (!property.by_group.empty()) {
                (property.kind == StylePropertyKind::fill ? out.fill : out.stroke) =
                    paint_for_group(property.by_group, shape);
                continue;
            }
            expect(at, sheet, property.kind);
            at.site.name = rule.site + "." + std::string(name_of(property.kind));
            Result<Value> value = evaluate(*property.value, at);
            if (!value) return std::move(value).diagnostics();
            Result<StyleOverride> one =
                override_of(property.kind, *value, *sheet.document, shape, property.value->span);
            if (!one) return std::move(one).diagnostics();
            apply(out, *one);
        }
    }
    return out;
}

}  // namespace filigree
