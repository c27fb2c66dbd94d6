// From values to shapes: what path(...), circle(...), file(...), transforms and the operations + - & * over them come
// to (language/shape_forms.h describes them).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "curves/ambiguity.h"
#include "curves/shape.h"
#include "derivation/shape_source.h"
#include "engines/shape/drawn_rules.h"
#include "engines/shape/region.h"
#include "language/document.h"
#include "language/value.h"
#include "plane/transform.h"

namespace filigree::shape {

struct ValueReading {
    const Document& document;
    const ShapeSource& files;
    double tolerance = 0;                                    // px; of sums, differences and products
    std::map<std::uint32_t, std::string>* labels = nullptr;  // gets the labels that are met, by layer
    Diagnostics* warnings = nullptr;                         // gets what was left out
    curves::Ambiguities* doubts = nullptr;                   // gets decisions that were near ones
};

// Maximal. Errors have the place of the value.
Result<curves::Shape> shape_of(const Value& value, const ValueReading& reading);
// Of translate(...), rotate(...), scale(...), mirror(...) and their products.
Result<Transform> transform_of(const Value& value, const ValueReading& reading);
// Of box(...), disc(...) and inside(...).
Result<Region> region_of(const Value& value, const ValueReading& reading);

// What is drawn in an SVG file, as elements.
std::vector<curves::Element> elements_of(const DrawnSide& side, const ValueReading& reading);
// The inside of one closed outline; none where it is no such path.
std::optional<Region> region_inside(const Path& border);

// Whether it is a region, so that `unless` means that it be void.
bool is_region(const Value& value);

}  // namespace filigree::shape
