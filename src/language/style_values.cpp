#include "language/style_values.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/number_text.h"
#include "language/colour_words.h"

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

}  // namespace

std::optional<StylePropertyKind> find_style_property(std::string_view name) {
    const auto known = std::find_if(property_names.begin(), property_names.end(),
                                    [name](const PropertyName& property) { return property.name == name; });
    if (known == property_names.end()) return std::nullopt;
    return known->kind;
}

std::vector<std::string_view> style_property_names() {
    std::vector<std::string_view> names;
    for (const PropertyName& property : property_names) names.push_back(property.name);
    return names;
}

std::string_view name_of(StylePropertyKind kind) {
    return std::find_if(property_names.begin(), property_names.end(),
                        [kind](const PropertyName& property) { return property.kind == kind; })
        ->name;
}

Evaluation evaluation_for(const Document& document, const Scope& globals, const Scope& shape, Key key) {
    Evaluation at;
    at.document = &document;
    at.scope = &globals;
    at.shape_scope = &shape;
    at.shape_key = key;
    at.by_shape = true;
    return at;
}

std::vector<std::string_view> paint_words_beside(const Scope& globals) {
    std::vector<std::string_view> words = colour_words_beside(&globals);
    words.push_back("none");
    return words;
}

void expect(Evaluation& at, const std::vector<std::string_view>& paint_words, StylePropertyKind kind) {
    at.words.clear();
    if (kind == StylePropertyKind::corner) {
        for (const CornerName& name : corner_names) at.words.push_back(name.name);
    } else if (kind != StylePropertyKind::pen) {
        at.words = paint_words;
    }
}

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

StyleOverride::Paint paint_for_group(const std::vector<StyleOverride::Paint>& paints, const Scope& shape) {
    const Value* group = shape.find("group");
    const Quantity* number = group != nullptr ? std::get_if<Quantity>(&group->data) : nullptr;
    const double place = number != nullptr && std::isfinite(number->value) ? std::floor(number->value) - 1 : 0;
    const double count = static_cast<double>(paints.size());
    double index = std::fmod(place, count);
    if (index < 0) index += count;
    return paints[static_cast<std::size_t>(index)];
}

bool depends_on_group(StylePropertyKind kind, const Value& value) {
    const ValueList* list = std::get_if<ValueList>(&value.data);
    return list != nullptr && list->items.size() > 1 &&
           (kind == StylePropertyKind::fill || kind == StylePropertyKind::stroke);
}

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

}  // namespace filigree
