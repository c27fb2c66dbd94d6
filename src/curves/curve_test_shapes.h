// For tests and benchmarks alone: shapes that are maximal as they are written, and the petals of the paper's figures
// 9 to 15.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "curves/shape.h"

namespace filigree::curves::test_shapes {

// No two of the elements may touch on one descriptor.
inline Shape shape_of(std::vector<Element> elements, double tolerance = 1e-9) {
    Shape shape;
    for (const Element& e : elements) {
        if (const auto normal = normal_form(e, tolerance)) shape.elements.push_back(*normal);
    }
    std::sort(shape.elements.begin(), shape.elements.end(), comes_before);
    return shape;
}
inline Shape moved(const Shape& shape, const Transform& by, double tolerance = 1e-9) {
    std::vector<Element> elements;
    for (const Element& e : shape.elements) elements.push_back(transformed(e, by));
    return shape_of(std::move(elements), tolerance);
}

inline Shape petal() {
    return shape_of({parabola_element({-1, -1}, {1, -3}, {3, 3}), parabola_element({-1, -1}, {-3, 1}, {3, 3})});
}
// Four arcs, four petals.
inline Shape flower() {
    return shape_of({parabola_element({-3, 3}, {0, -6}, {3, 3}), parabola_element({-3, -3}, {6, 0}, {-3, 3}),
                     parabola_element({3, -3}, {0, 6}, {-3, -3}), parabola_element({3, 3}, {-6, 0}, {3, -3})});
}
// The flower with two opposite petals drawn out by `out` along both axes. It is maximal where out is not 0 and no
// remainder touches what it was cut from.
inline std::vector<Element> opened_flower(double out) {
    const auto at = [&](double x, double y, double by) { return Vec{x + by, y + by}; };
    std::vector<Element> elements;
    for (const double side : {1.0, -1.0}) {
        const auto petal_arc = [&](Vec b0, Vec b1, Vec b2) {
            elements.push_back(parabola_element(at(side * b0.x, side * b0.y, side * out),
                                                at(side * b1.x, side * b1.y, side * out),
                                                at(side * b2.x, side * b2.y, side * out)));
        };
        petal_arc({-1, -1}, {1, -3}, {3, 3});
        petal_arc({-1, -1}, {-3, 1}, {3, 3});
    }
    elements.push_back(parabola_element({-3, 3}, {-2, 0}, {-1, -1}));
    elements.push_back(parabola_element({1, 1}, {0, 2}, {-3, 3}));
    elements.push_back(parabola_element({3, -3}, {2, 0}, {1, 1}));
    elements.push_back(parabola_element({-1, -1}, {0, -2}, {3, -3}));
    return elements;
}

}  // namespace filigree::curves::test_shapes
