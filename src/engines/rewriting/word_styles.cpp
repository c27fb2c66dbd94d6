#include "engines/rewriting/word_styles.h"

#include <utility>

#include "space/mesh.h"

namespace filigree::rewriting {
namespace {

constexpr Colour ink{0, 0, 0, 255}, paper{255, 255, 255, 255};

// A list of colours goes by the group, and the group by the depth.
FactSet facts_asked(const Settings& settings) {
    FactSet asked{};
    asked[static_cast<std::size_t>(Fact::depth)] = true;
    for (const StyleStatement* style : settings.styles) {
        add_facts(asked, style->condition);
        for (const StyleProperty& property : style->properties) add_facts(asked, property.value);
    }
    return asked;
}

Value bare(double value) { return Value{Quantity{value}, {}}; }
Value length_value(double px) { return Value{Quantity{px, 1, false}, {}}; }

}  // namespace

WordStyles::WordStyles(const Derivation& derivation, const DrawRules& rules, const Settings& settings, StyleSheet sheet,
                       Key root)
    : derivation_(derivation),
      rules_(rules),
      settings_(settings),
      sheet_(std::move(sheet)),
      root_(root),
      asked_(facts_asked(settings)) {
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
    Scope scope;
    scope.outer = &settings_.globals;
    for (std::size_t f = 0; f < fact_names.size(); ++f) {
        if (asked_[f]) scope.names.emplace(fact_names[f], bare(fact_of(static_cast<Fact>(f), symbol.place)));
    }
    scope.names.emplace("group", bare(fact_of(Fact::depth, symbol.place) + 1));
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

double WordStyles::fact_of(Fact fact, std::uint64_t place) {
    if (fact == Fact::t) return derivation_.iteration;
    if (!facts_) facts_ = std::make_unique<SymbolFacts>(derivation_.word, derivation_.alphabet, asked_);
    if (fact == Fact::count) return static_cast<double>(facts_->count(derivation_.word.symbols[place]));
    return facts_->value(fact, index_of(place));
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
    FactSet asked = facts_asked(settings);
    add_facts(asked, rules.formula);
    return has(asked, Fact::age);
}

}  // namespace filigree::rewriting
