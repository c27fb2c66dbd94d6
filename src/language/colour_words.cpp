#include "language/colour_words.h"

#include <algorithm>
#include <array>

namespace filigree {

namespace {

struct NamedColour {
    std::string_view word;
    Colour colour;
};
constexpr std::array<NamedColour, 18> table = {{
    {"aqua", {0, 255, 255}},
    {"black", {0, 0, 0}},
    {"blue", {0, 0, 255}},
    {"fuchsia", {255, 0, 255}},
    {"gray", {128, 128, 128}},
    {"green", {0, 128, 0}},
    {"lime", {0, 255, 0}},
    {"maroon", {128, 0, 0}},
    {"navy", {0, 0, 128}},
    {"olive", {128, 128, 0}},
    {"orange", {255, 165, 0}},
    {"purple", {128, 0, 128}},
    {"red", {255, 0, 0}},
    {"silver", {192, 192, 192}},
    {"teal", {0, 128, 128}},
    {"transparent", {0, 0, 0, 0}},
    {"white", {255, 255, 255}},
    {"yellow", {255, 255, 0}},
}};
constexpr std::array<std::string_view, table.size()> words = [] {
    std::array<std::string_view, table.size()> out;
    for (std::size_t i = 0; i < table.size(); ++i) out[i] = table[i].word;
    return out;
}();

}  // namespace

std::span<const std::string_view> colour_words() { return words; }

std::vector<std::string_view> colour_words_beside(const Scope* scope) {
    std::vector<std::string_view> out;
    for (const std::string_view word : words) {
        if (scope == nullptr || scope->find(word) == nullptr) out.push_back(word);
    }
    return out;
}

Result<Colour> as_colour(const Value& value) {
    if (const Colour* colour = std::get_if<Colour>(&value.data)) return *colour;
    if (const Symbol* symbol = std::get_if<Symbol>(&value.data)) {
        const auto found = std::find(words.begin(), words.end(), symbol->name);
        if (found != words.end()) return table[static_cast<std::size_t>(found - words.begin())].colour;
        return error("language.unknown-name", "there is no colour '" + symbol->name + "'", value.span,
                     did_you_mean(symbol->name, {words.begin(), words.end()}));
    }
    std::vector<std::string> hints;
    if (std::holds_alternative<std::string>(value.data))
        hints.push_back("a colour is written without quotes, as #a03020");
    return error("language.wrong-kind", "a colour is needed here, but this is " + std::string(kind_of(value)),
                 value.span, std::move(hints));
}

}  // namespace filigree
