#include "language/quantity.h"

#include "base/elementary.h"

namespace filigree {

namespace {

struct Ratio {  // px = value * numerator / denominator; whole numbers, so that little is rounded
    double numerator = 1, denominator = 1;
};
Ratio ratio_of(Unit unit) {
    switch (unit) {
        case Unit::mm:
            return {480, 127};
        case Unit::cm:
            return {4800, 127};
        case Unit::m:
            return {480000, 127};
        case Unit::inch:
            return {96, 1};
        case Unit::pt:
            return {96, 72};
        default:
            return {1, 1};
    }
}

}  // namespace

bool is_length_unit(Unit unit) {
    switch (unit) {
        case Unit::mm:
        case Unit::cm:
        case Unit::m:
        case Unit::inch:
        case Unit::pt:
        case Unit::px:
            return true;
        default:
            return false;
    }
}

double px_per(Unit unit) { return to_px(1, unit); }

double to_px(double value, Unit unit) {
    const Ratio ratio = ratio_of(unit);
    return value * ratio.numerator / ratio.denominator;
}

double from_px(double px, Unit unit) {
    const Ratio ratio = ratio_of(unit);
    return px * ratio.denominator / ratio.numerator;
}

Unit bare_unit(const Document* document, const SourceSpan& span) {
    if (document == nullptr || span.file >= document->units.size()) return Unit::px;
    const Unit unit = document->units[span.file];
    return is_length_unit(unit) ? unit : Unit::px;
}

Unit unit_of(const Document& document) { return document.units.empty() ? Unit::px : document.units[0]; }

Quantity quantity_of(const NumberLiteral& literal) {
    const double value = literal.value;
    switch (literal.unit) {
        case Unit::deg:
            return {value, 0, true};
        case Unit::rad:
            return {value * 180 / elementary::pi, 0, true};
        case Unit::turn:
            return {value * 360, 0, true};
        case Unit::percent:
            return {value / 100, 0, false};
        case Unit::kilobyte:
            return {value * 1e3, 0, false};
        case Unit::megabyte:
            return {value * 1e6, 0, false};
        case Unit::gigabyte:
            return {value * 1e9, 0, false};
        case Unit::none:
        case Unit::second:
            return {value, 0, false};
        default:
            return {to_px(value, literal.unit), 1, false};
    }
}

std::string_view kind_of(const Quantity& quantity) {
    if (quantity.is_angle) return "an angle";
    switch (quantity.length_power) {
        case 0:
            return "a number";
        case 1:
            return "a length";
        case 2:
            return "an area";
        case -1:
            return "a number per length";
        case -2:
            return "a number per area";
        default:
            return "a power of a length";
    }
}

std::optional<Quantity> adapted(const Quantity& quantity, Unit unit, const Quantity& like) {
    if (same_dimension(quantity, like)) return quantity;
    if (!is_bare(quantity)) return std::nullopt;
    Quantity result = like;
    result.value = quantity.value;
    for (int i = 0; i < like.length_power; ++i) result.value = to_px(result.value, unit);
    for (int i = 0; i > like.length_power; --i) result.value = from_px(result.value, unit);
    return result;
}

std::optional<AdaptedPair> adapted(const Quantity& first, Unit first_unit, const Quantity& second, Unit second_unit) {
    const Quantity& like = is_bare(first) ? second : first;
    const std::optional<Quantity> a = adapted(first, first_unit, like);
    const std::optional<Quantity> b = adapted(second, second_unit, like);
    if (!a || !b) return std::nullopt;
    return AdaptedPair{*a, *b};
}

namespace {

std::optional<Quantity> with_dimension(double value, int power, bool is_angle) {
    if (power > max_length_power || power < -max_length_power) return std::nullopt;
    return Quantity{value, static_cast<std::int8_t>(power), is_angle};
}

}  // namespace

std::optional<Quantity> multiplied(const Quantity& a, const Quantity& b) {
    const bool is_angle = a.is_angle || b.is_angle;
    if (is_angle && !is_bare(a) && !is_bare(b)) return std::nullopt;
    return with_dimension(a.value * b.value, a.length_power + b.length_power, is_angle);
}

std::optional<Quantity> divided(const Quantity& a, const Quantity& b) {
    if (b.is_angle && !a.is_angle) return std::nullopt;
    if (a.is_angle && !b.is_angle && !is_bare(b)) return std::nullopt;
    return with_dimension(a.value / b.value, a.length_power - b.length_power, a.is_angle && !b.is_angle);
}

}  // namespace filigree
