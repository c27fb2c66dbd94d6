#include "curves/registration.h"

#include <algorithm>
#include <set>

#include "curves/contacts.h"

namespace filigree::curves {
namespace {

constexpr double shallow_sine = 0.02;

bool is_inside(const Element& e, Vec at, double reach) {
    const auto [first, last] = ends_of(e);
    return is_closed(e) || (length(first - at) > reach && length(last - at) > reach);
}

void add(Registrations& registrations, const Registration& point) {
    const auto number = static_cast<std::uint32_t>(registrations.points.size());
    registrations.points.push_back(point);
    registrations.on[point.elements[0]].push_back(number);
    if (point.is_contact) registrations.on[point.elements[1]].push_back(number);
}

void add_contacts(Registrations& registrations, const Element& a, std::uint32_t number_a, const Element& b,
                  std::uint32_t number_b, double tolerance, double reach, double least_sine) {
    const double tenth_a = 0.1 * rough_length(a), tenth_b = 0.1 * rough_length(b);
    for (const Contact& contact : contacts_of(a, b, reach, least_sine)) {
        add(registrations, {contact.at,
                            {number_a, number_b},
                            {contact.way, contact.other_way},
                            {is_inside(a, contact.at, 2 * tolerance), is_inside(b, contact.at, 2 * tolerance)},
                            {is_inside(a, contact.at, tenth_a), is_inside(b, contact.at, tenth_b)},
                            true,
                            contact.is_tangential});
    }
}

// A labelled point, or an arc's centre.
void add_place(Registrations& registrations, const Element& e, std::uint32_t number) {
    if (e.kind != ElementKind::point && e.kind != ElementKind::arc) return;
    add(registrations, {e.at[0], {number, number}, {}, {}, {}, false, false});
}

using Type = std::pair<ElementKind, std::uint32_t>;  // with the layer
Type type_of(const Element& e) { return {e.kind, e.layer}; }

}  // namespace

Registrations registrations_of(const Shape& shape, double tolerance) {
    const std::vector<Element>& elements = shape.elements;
    Registrations found;
    found.on.resize(elements.size());
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
        add_place(found, elements[i], i);
        for (std::uint32_t j = 0; j < i; ++j)
            add_contacts(found, elements[j], j, elements[i], i, tolerance, 2 * tolerance, shallow_sine);
    }
    return found;
}

Registrations registrations_of(const MatchIndex& design, const Shape& left, const Registrations& of_left,
                               double tolerance) {
    std::set<Type> places, touching;
    std::set<std::pair<Type, Type>> pairs;
    for (const Registration& point : of_left.points) {
        const Type first = type_of(left.elements[point.elements[0]]), last = type_of(left.elements[point.elements[1]]);
        if (!point.is_contact) {
            places.insert(first);
            continue;
        }
        touching.insert(first);
        touching.insert(last);
        pairs.insert({first, last});
        pairs.insert({last, first});
    }
    // What touches in the left side to within the tolerance may be apart by more here, where both are carried to within
    // the tolerance, at a small angle.
    const double reach = 20 * tolerance;
    // Angles become smaller where the map flattens.
    const double flat_sine = 0.1 * shallow_sine;
    Registrations found;
    found.on.resize(design.slot_count());
    for (std::uint32_t slot = 0; slot < design.slot_count(); ++slot) {
        if (!design.is_taken(slot)) continue;
        const Element& e = design.element(slot);
        const Type type = type_of(e);
        if (places.contains(type)) add_place(found, e, slot);
        if (!touching.contains(type)) continue;
        for (const std::uint32_t other : design.grid().found_along(e, reach)) {
            if (other >= slot || !pairs.contains({type, type_of(design.element(other))})) continue;
            add_contacts(found, design.element(other), other, e, slot, tolerance, reach, flat_sine);
        }
    }
    return found;
}

}  // namespace filigree::curves
