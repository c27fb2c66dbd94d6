#include "curves/algebra.h"

#include <algorithm>

#include "curves/end_index.h"
#include "curves/overlap.h"

namespace filigree::curves {
namespace {

double reach_for(double tolerance, const Ambiguities* ambiguities) {
    return (ambiguities != nullptr ? doubtful : 2) * tolerance;
}

enum class Hiding : std::uint8_t { by_no_lighter, by_any };

// What is left of a's elements where none of b's hides them; not merged.
std::vector<Element> rests(std::span<const Element> a, std::span<const Element> b, double tolerance,
                           Ambiguities* ambiguities, Hiding hiding) {
    std::vector<Element> left;
    std::vector<Stretch> hidden;
    const std::vector<Pair> pairs = pairs_near(a, b, reach_for(tolerance, ambiguities));
    auto pair = pairs.begin();
    for (std::uint32_t i = 0; i < a.size(); ++i) {
        hidden.clear();
        for (; pair != pairs.end() && pair->first == i; ++pair) {
            const Element& other = b[pair->second];
            if (hiding == Hiding::by_no_lighter && other.weight < a[i].weight) continue;
            const auto stretches = covered(a[i], other, tolerance, ambiguities);
            for (const Stretch& stretch : stretches.span()) {
                hidden.push_back(stretch);
            }
        }
        for (const Element& rest : uncovered(a[i], hidden, tolerance, ambiguities)) left.push_back(rest);
    }
    return left;
}

}  // namespace

Shape sum(const Shape& a, const Shape& b, double tolerance, Ambiguities* ambiguities) {
    std::vector<Element> all = a.elements;
    all.insert(all.end(), b.elements.begin(), b.elements.end());
    return merged(std::move(all), tolerance, ambiguities);
}

Shape difference(const Shape& a, const Shape& b, double tolerance, Ambiguities* ambiguities) {
    return merged(rests(a.elements, b.elements, tolerance, ambiguities, Hiding::by_no_lighter), tolerance);
}

Shape erased(const Shape& a, const Shape& b, double tolerance, Ambiguities* ambiguities) {
    return merged(rests(a.elements, b.elements, tolerance, ambiguities, Hiding::by_any), tolerance);
}

Shape product(const Shape& a, const Shape& b, double tolerance, Ambiguities* ambiguities) {
    std::vector<Element> shared;
    for (const auto& [i, j] : pairs_near(a.elements, b.elements, reach_for(tolerance, ambiguities))) {
        for (const Element& e : common(a.elements[i], b.elements[j], tolerance, ambiguities)) shared.push_back(e);
    }
    return merged(std::move(shared), tolerance);
}

bool is_part_of(const Shape& a, const Shape& b, double tolerance, Ambiguities* ambiguities) {
    return rests(a.elements, b.elements, tolerance, ambiguities, Hiding::by_no_lighter).empty();
}

bool are_equal(const Shape& a, const Shape& b, double tolerance, Ambiguities* ambiguities) {
    return is_part_of(a, b, tolerance, ambiguities) && is_part_of(b, a, tolerance, ambiguities);
}

Shape transformed(const Shape& shape, const Transform& by) {
    Shape moved;
    moved.elements.reserve(shape.elements.size());
    // At no tolerance: the order of the ends alone is restored.
    for (const Element& e : shape.elements) {
        if (const auto form = own_form(transformed(e, by), 0)) moved.elements.push_back(*form);
    }
    std::sort(moved.elements.begin(), moved.elements.end(), comes_before);
    return moved;
}

}  // namespace filigree::curves
