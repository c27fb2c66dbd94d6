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
constexpr std::array<PropertyName, 10> property_names = {{
    {"fill", StylePropertyKind::fill},
    {"stroke", StylePropertyKind::stroke},
    {"pen", StylePropertyKind::pen},
    {"stroke-width", StylePropertyKind::pen},
    {"corner", StylePropertyKind::corner},
    {"stroke-linejoin", StylePropertyKind::corner},
    {"line", StylePropertyKind::line},
    {"wobble", StylePropertyKind::wobble},
    {"wobble_length", StylePropertyKind::wobble_length},
    {"wobble-length", StylePropertyKind::wobble_length},
}};

template <class Meaning>
struct Word {
    std::string_view name;
    Meaning means;
};
constexpr std::array<Word<Corner>, 4> corner_words = {{
    {"round", Corner::round},
    {"mitre", Corner::mitre},
    {"miter", Corner::mitre},
    {"bevel", Corner::bevel},
}};
constexpr std::array<Word<LineQuality>, 2> line_words = {{
    {"even", LineQuality::even},
    {"drawn", LineQuality::drawn},
}};

constexpr double largest_length = 1e6;  // px

std::string quoted(std::string_view name) { return "'" + std::string(name) + "'"; }

// Of properties that are lengths, the least in px.
double least_length(StylePropertyKind kind) { return kind == StylePropertyKind::wobble_length ? 1 : 0; }

Result<double> length_of(StylePropertyKind kind, const Value& value, const Document& document, SourceSpan span) {
    const Result<double> px = as_length(value, document);
    const std::string name = quoted(name_of(kind));
    if (!px) {
        Diagnostic diagnostic = px.diagnostics().front();
        if (diagnostic.code == "language.wrong-kind") {
            diagnostic.message = name + " must be a length, but this is " + std::string(kind_of(value));
        }
        diagnostic.span = span;
        return diagnostic;
    }
    const double least = least_length(kind);
    if (*px >= least && *px <= largest_length) return *px;
    return error("language.out-of-range",
                 name + " must be from " + to_text(least) + "px to 1000000px, but this is " + to_text(*px) + "px",
                 span);
}

template <class Words>
auto meaning_of(StylePropertyKind kind, const Words& words, std::string_view choice, const Value& value,
                SourceSpan span) -> Result<decltype(words[0].means)> {
    if (const Symbol* symbol = std::get_if<Symbol>(&value.data)) {
        for (const auto& word : words) {
            if (word.name == symbol->name) return word.means;
        }
    }
    return error(
        "language.wrong-kind",
        quoted(name_of(kind)) + " must be " + std::string(choice) + ", but this is " + std::string(kind_of(value)),
        span);
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
        for (const auto& word : corner_words) at.words.push_back(word.name);
    } else if (kind == StylePropertyKind::line) {
        for (const auto& word : line_words) at.words.push_back(word.name);
    } else if (kind == StylePropertyKind::fill || kind == StylePropertyKind::stroke) {
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
        case StylePropertyKind::pen:
        case StylePropertyKind::wobble:
        case StylePropertyKind::wobble_length: {
            Result<double> px = length_of(kind, value, document, span);
            if (!px) return std::move(px).diagnostics();
            (kind == StylePropertyKind::pen      ? out.pen
             : kind == StylePropertyKind::wobble ? out.wobble
                                                 : out.wobble_length) = *px;
            return out;
        }
        case StylePropertyKind::corner: {
            Result<Corner> corner = meaning_of(kind, corner_words, "round, mitre or bevel", value, span);
            if (!corner) return std::move(corner).diagnostics();
            out.corner = *corner;
            return out;
        }
        case StylePropertyKind::line: {
            Result<LineQuality> line = meaning_of(kind, line_words, "even or drawn", value, span);
            if (!line) return std::move(line).diagnostics();
            out.line = *line;
            return out;
        }
    }
    return out;
}

}  // namespace filigree
