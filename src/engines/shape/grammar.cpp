#include "engines/shape/grammar.h"

#include "base/random.h"

namespace filigree::shape {

std::uint32_t layer_of_colour(std::optional<Colour> colour) {
    if (!colour) return 0;
    // Of transparent black there is nothing to see, so that it may be any other transparent colour.
    const std::uint32_t bits = std::uint32_t{colour->red} << 24 | std::uint32_t{colour->green} << 16 |
                               std::uint32_t{colour->blue} << 8 | colour->alpha;
    return bits == 0 ? 0x01000000U : bits;
}

std::optional<Colour> colour_of_layer(std::uint32_t layer) {
    if (layer == 0) return std::nullopt;
    return Colour{static_cast<std::uint8_t>(layer >> 24), static_cast<std::uint8_t>(layer >> 16),
                  static_cast<std::uint8_t>(layer >> 8), static_cast<std::uint8_t>(layer)};
}

std::uint32_t layer_of_label(std::string_view label) { return static_cast<std::uint32_t>(hash_text(label)); }

std::optional<std::uint32_t> find_rule(const Grammar& grammar, std::string_view name) {
    for (std::uint32_t r = 0; r < grammar.rules.size(); ++r) {
        if (grammar.rules[r].name == name) return r;
    }
    return std::nullopt;
}

std::string label_of(const Grammar& grammar, std::uint32_t layer) {
    const auto known = grammar.labels.find(layer);
    return known == grammar.labels.end() ? "?" : known->second;
}

}  // namespace filigree::shape
