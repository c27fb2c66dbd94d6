// Quantities: numbers with dimensions, and the algebra that expressions follow.
//
// Dimensions are powers of length, or an angle. A bare number adapts where it meets a dimension: beside a
// length it is a length in the unit of its file, beside an area an area in that unit squared, beside an angle
// degrees. It never adapts in products: 2 * 3mm is 6mm, and a length divided by a length is bare.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "language/document.h"
#include "language/value.h"

namespace filigree {

constexpr int max_length_power = 8;  // higher powers are errors; intermediate results need at most 3 or 4

bool is_length_unit(Unit unit);
double px_per(Unit unit);               // of length units; 1 for others
double to_px(double value, Unit unit);  // multiplies before it divides, so that 25.4mm is exactly 1in
double from_px(double px, Unit unit);

// What a bare length means in the source file of a span: px where it has none.
Unit bare_unit(const Document* document, const SourceSpan& span);

// That of the document's own file.
Unit unit_of(const Document& document);

Quantity quantity_of(const NumberLiteral& literal);

inline bool is_bare(const Quantity& q) { return q.length_power == 0 && !q.is_angle; }
inline bool same_dimension(const Quantity& a, const Quantity& b) {
    return a.length_power == b.length_power && a.is_angle == b.is_angle;
}
std::string_view kind_of(const Quantity& quantity);

// The quantity in the dimension of `like`, where it has that already or is bare and takes it in `unit`.
std::optional<Quantity> adapted(const Quantity& quantity, Unit unit, const Quantity& like);

// Two quantities brought to one dimension: both bare, or both of the dimension of the one that is not.
struct AdaptedPair {
    Quantity first, second;
};
std::optional<AdaptedPair> adapted(const Quantity& first, Unit first_unit, const Quantity& second, Unit second_unit);

// None where the dimensions make no sense together (angles multiply and divide only with bare numbers) or
// leave the allowed powers. Division by zero gives an infinity or NaN: whoever computes looks for those.
std::optional<Quantity> multiplied(const Quantity& a, const Quantity& b);
std::optional<Quantity> divided(const Quantity& a, const Quantity& b);

}  // namespace filigree
