#include "engines/rewriting/word_styles.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "language/walk.h"
#include "space/mesh.h"

namespace filigree::rewriting {
namespace {

constexpr Colour ink{0, 0, 0, 255}, paper{255, 255, 255, 255};

bool mentions(const ExpressionPtr& expression, std::string_view name) {
    if (!expression) return false;
    const std::vector<NameInExpression> names = names_in(*expression);
    return std::any_of(names.begin(), names.end(), [&](const NameInExpression& one) { return one.text == name; });
}
bool mentions(const StyleStatement& style, std::string_view name) {
    return mentions(style.condition, name) ||
           std::any_of(style.properties.begin(), style.properties.end(),
                       [&](const StyleProperty& property) { return mentions(property.value, name); });
}

Value bare(double value) { return Value{Quantity{value}, {}}; }
Value length_value(double px) { return Value{Quantity{px, 1, false}, {}}; }

}  // namespace

WordStyles::WordStyles(const Derivation& derivation, const DrawRules& rules, const Settings& settings, StyleSheet sheet,
                       Key root)
    : derivation_(derivation), rules_(rules), settings_(settings), sheet_(std::move(sheet)), root_(root) {
    for (std::size_t s = 0; s < derivation.alphabet.size(); ++s) {
        const char32_t letter = derivation.alphabet[static_cast<Symbol>(s)].letter;
        letters_.push_back(style_of_tag(sheet_, to_utf8(std::u32string(1, letter))));
    }
}

Colour WordStyles::colour_of(std::int64_t level) const {
    if (rules_.colours.empty()) return ink;
    const auto count = static_cast<std::int64_t>(rules_.colours.size());
    return rules_.colours[static_cast<std::size_t>((level % count + count) % count)];
}

Look WordStyles::look_of(Drawn kind, double width, std::int64_t colour, const StyleOverride& over) const {
    Look look;
    Style& style = look.style;
    style.pen = width;
    style.stroke = colour_of(colour);
    style.is_open = kind == Drawn::line;
    if (kind == Drawn::face) style.fill = rules_.colours.empty() ? paper : colour_of(colour);
    const bool is_solid = kind == Drawn::solid || kind == Drawn::tube;
    if (is_solid) {
        const Material usual;
        style.fill = rules_.colours.empty() ? usual.fill : colour_of(colour);
        style.stroke = usual.edge;
        style.pen = usual.pen;
    }
    if (over.fill) style.fill = *over.fill;
    if (over.stroke) style.stroke = *over.stroke;
    if (over.pen) style.pen = *over.pen;
    if (over.corner) style.corner = *over.corner;
    if (kind == Drawn::tube && !over.fill && over.stroke) {
        style.fill = *over.stroke;
        style.stroke = Material{}.edge;
    }
    look.is_by_hand = kind == Drawn::line && over.line == LineQuality::drawn;
    return look;
}

Look WordStyles::look_of(Drawn kind, const DrawnSymbol& symbol) {
    const TagStyle& of_letter = letters_[derivation_.word.symbols[symbol.place]];
    if (of_letter.is_constant) return look_of(kind, symbol.width, symbol.colour, of_letter.common);
    const std::uint64_t index = index_of(symbol.place);
    Scope scope;
    scope.outer = &settings_.globals;
    for (std::size_t f = 0; f < fact_names.size(); ++f) {
        scope.names.emplace(fact_names[f], bare(fact_of(static_cast<Fact>(f), index)));
    }
    scope.names.emplace("group", bare(facts().value(Fact::depth, index) + 1));
    scope.names.emplace("colour", bare(static_cast<double>(symbol.colour)));
    scope.names.emplace("width", length_value(symbol.width));
    scope.names.emplace("x", length_value(symbol.at.x));
    scope.names.emplace("y", length_value(symbol.at.y));
    scope.names.emplace("z", length_value(symbol.at.z));
    const Result<StyleOverride> over = style_of_shape(sheet_, of_letter, scope, key_of(symbol.place));
    if (over) return look_of(kind, symbol.width, symbol.colour, *over);
    if (errors.empty()) errors = over.diagnostics();
    return {};
}

double WordStyles::fact_of(Fact fact, std::uint64_t index) {
    if (fact == Fact::t) return derivation_.iteration;
    if (fact == Fact::age && derivation_.word.ages.empty()) return 1;  // nothing asks for it
    return facts().value(fact, index);
}

const SymbolFacts& WordStyles::facts() {
    if (facts_) return *facts_;
    FactSet all;
    all.fill(true);
    facts_ = std::make_unique<SymbolFacts>(derivation_.word, derivation_.alphabet, all);
    return *facts_;
}

std::uint64_t WordStyles::index_of(std::uint64_t place) {
    if (place < place_) place_ = index_ = 0;
    for (; place_ < place; ++place_) index_ += derivation_.word.symbols[place_] == Alphabet::freeze ? 0U : 1U;
    return index_;
}

Key WordStyles::key_of(std::uint64_t place) {
    const std::vector<std::uint64_t>& keys = derivation_.word.keys;
    const std::uint64_t index = index_of(place);
    return child(root_, index < keys.size() ? keys[index] : index);
}

const StyleOverride* WordStyles::common() const {
    const TagStyle* common = nullptr;
    for (const TagStyle& style : letters_) {
        if (!style.is_constant || (common != nullptr && !(style.common == common->common))) return nullptr;
        common = &style;
    }
    return common == nullptr || common->common.line == LineQuality::drawn ? nullptr : &common->common;
}

bool asks_for_ages(const DrawRules& rules, const Settings& settings) {
    return mentions(rules.formula, "age") ||
           std::any_of(settings.styles.begin(), settings.styles.end(),
                       [](const StyleStatement* style) { return mentions(*style, "age"); });
}

}  // namespace filigree::rewriting
