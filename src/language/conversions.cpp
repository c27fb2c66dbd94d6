// Conversions of values to what parameters and settings need; declared in evaluate.h.
#include "language/evaluate.h"

#include <cmath>

namespace filigree {

namespace {

Diagnostic wrong_kind(std::string_view wanted, const Value& found, std::vector<std::string> hints = {}) {
    return error("language.wrong-kind",
                 std::string(wanted) + " is needed here, but this is " + std::string(kind_of(found)), found.span,
                 std::move(hints));
}

Diagnostic not_finite(const Value& found) {
    return error("language.not-finite", "this has no finite value", found.span);
}

}  // namespace

Result<double> as_length(const Value& value, const Document& document) {
    const Quantity* quantity = std::get_if<Quantity>(&value.data);
    if (quantity == nullptr) return wrong_kind("a length", value);
    const auto length = adapted(*quantity, bare_unit(&document, value.span), Quantity{0, 1, false});
    if (!length) return wrong_kind("a length", value);
    if (!std::isfinite(length->value)) return not_finite(value);
    return length->value;
}

Result<double> as_angle(const Value& value) {
    const Quantity* quantity = std::get_if<Quantity>(&value.data);
    if (quantity == nullptr || quantity->length_power != 0) return wrong_kind("an angle", value);
    if (!std::isfinite(quantity->value)) return not_finite(value);
    return quantity->value;
}

Result<double> as_number(const Value& value) {
    const Quantity* quantity = std::get_if<Quantity>(&value.data);
    if (quantity == nullptr || !is_bare(*quantity)) {
        std::vector<std::string> hints;
        if (quantity != nullptr && quantity->length_power == 1) {
            hints.push_back("a length divided by a length is a plain number, as in width / 1mm");
        }
        return wrong_kind("a plain number", value, std::move(hints));
    }
    if (!std::isfinite(quantity->value)) return not_finite(value);
    return quantity->value;
}

Result<bool> as_flag(const Value& value) {
    if (const bool* flag = std::get_if<bool>(&value.data)) return *flag;
    const Quantity* quantity = std::get_if<Quantity>(&value.data);
    if (quantity != nullptr && is_bare(*quantity)) {
        if (quantity->value == 0) return false;
        if (quantity->value == 1) return true;
        return error("language.out-of-range", "true or false is needed here, but this is a number other than 0 and 1",
                     value.span);
    }
    return wrong_kind("true or false", value);
}

}  // namespace filigree
