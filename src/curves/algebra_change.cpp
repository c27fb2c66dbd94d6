#include <algorithm>
#include <cmath>
#include <iterator>

#include "curves/algebra.h"
#include "curves/along.h"
#include "curves/end_index.h"
#include "curves/join.h"

namespace filigree::curves {
namespace {

// A box that is quickly known and holds the element.
Bounds rough_bounds(const Element& e) {
    Bounds box;
    switch (e.kind) {
        case ElementKind::cubic:
            extend(box, e.at[3]);
            [[fallthrough]];
        case ElementKind::parabola:
            extend(box, e.at[2]);
            [[fallthrough]];
        case ElementKind::line:
            extend(box, e.at[1]);
            [[fallthrough]];
        case ElementKind::point:
            extend(box, e.at[0]);
            break;
        case ElementKind::arc: {
            const Vec reach{std::fabs(e.at[1].x) + std::fabs(e.at[2].x), std::fabs(e.at[1].y) + std::fabs(e.at[2].y)};
            extend(box, e.at[0] - reach);
            extend(box, e.at[0] + reach);
            break;
        }
    }
    return box;
}

std::vector<std::uint32_t> near_by_scan(const Shape& design, const Shape& taken, const Shape& put, double reach) {
    std::vector<Bounds> boxes;
    Bounds all;
    for (const Shape* shape : {&taken, &put}) {
        for (const Element& e : shape->elements) {
            boxes.push_back(bounds_of(e));
            extend(all, boxes.back());
        }
    }
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < design.elements.size(); ++i) {
        const Bounds own = rough_bounds(design.elements[i]);
        if (!do_overlap(own, all, reach)) continue;
        if (std::any_of(boxes.begin(), boxes.end(), [&](const Bounds& box) { return do_overlap(own, box, reach); })) {
            near.push_back(i);
        }
    }
    return near;
}

std::vector<Vec> end_places(std::span<const Element> elements) {
    std::vector<Vec> places;
    for (const Element& e : elements) {
        if (e.kind == ElementKind::point || is_closed(e)) continue;
        const auto [first, last] = ends_of(e);
        places.push_back(first);
        places.push_back(last);
    }
    return places;
}

bool is_less(Vec a, Vec b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

// The place nearest to a point within the tolerance, and of equally near ones the least; the point where there is none.
// Of places in order.
Vec nearest_place(std::span<const Vec> places, Vec p, double tolerance) {
    Vec best = p;
    double least = tolerance;
    bool is_found = false;
    for (auto at = std::lower_bound(places.begin(), places.end(), p - Vec{tolerance, 1e300}, is_less);
         at != places.end() && at->x <= p.x + tolerance; ++at) {
        const double off = length(*at - p);
        if (off > least || (is_found && off == least)) continue;
        best = *at;
        least = off;
        is_found = true;
    }
    return best;
}

Element snapped_ends(const Element& e, std::span<const Vec> places, double tolerance) {
    if (e.kind == ElementKind::point || is_closed(e)) return e;
    const double noticeable = as_good_as_exact * tolerance;
    Stretch to{interval_of(e), ends_of(e).first, ends_of(e).second};
    bool is_moved = false;
    for (const auto& [t, end] : {std::pair(&to.on.from, &to.first), std::pair(&to.on.to, &to.last)}) {
        const Vec place = nearest_place(places, *end, tolerance);
        if (place == *end) continue;
        const double there = parameter_near(e, place, *t);
        const Vec foot = point_at(e, there);
        // Where the curve only passes by, it ends already where it is nearest.
        if (length(foot - place) > noticeable && length(foot - *end) <= noticeable) continue;
        *t = there;
        *end = place;
        is_moved = true;
    }
    return is_moved ? piece_between(e, to, tolerance).value_or(e) : e;
}

void put_in_order(std::vector<Vec>& places) { std::sort(places.begin(), places.end(), is_less); }

}  // namespace

Shape snapped(const Shape& shape, std::span<const Vec> places, double tolerance) {
    std::vector<Vec> sorted(places.begin(), places.end());
    put_in_order(sorted);
    std::vector<Element> moved;
    for (const Element& e : shape.elements) moved.push_back(snapped_ends(e, sorted, tolerance));
    return merged(std::move(moved), tolerance);
}

Change change_by(const Shape& design, const Shape& taken, const Shape& put, double tolerance,
                 Ambiguities* ambiguities) {
    return change_by(design, near_by_scan(design, taken, put, 2 * tolerance), taken, put, tolerance, ambiguities);
}

Change change_by(const Shape& design, std::span<const std::uint32_t> near, const Shape& taken, const Shape& put,
                 double tolerance, Ambiguities* ambiguities) {
    Shape before;
    for (const std::uint32_t i : near) before.elements.push_back(design.elements[i]);
    std::vector<Element> after = erased(before, taken, tolerance, ambiguities).elements;
    std::vector<Vec> places = end_places(before.elements);
    put_in_order(places);
    for (Element& e : after) e = snapped_ends(e, places, tolerance);
    for (const Vec place : end_places(after)) places.push_back(place);
    put_in_order(places);
    for (const Element& e : put.elements) after.push_back(snapped_ends(e, places, tolerance));
    const Shape result = merged(std::move(after), tolerance);

    Change change;
    const auto take_difference = [](const Shape& a, const Shape& b, std::vector<Element>& rest) {
        std::set_difference(a.elements.begin(), a.elements.end(), b.elements.begin(), b.elements.end(),
                            std::back_inserter(rest), comes_before);
    };
    take_difference(before, result, change.removed);
    take_difference(result, before, change.added);
    if (ambiguities != nullptr) {
        for (const auto& [i, j] : pairs_near(change.added, result.elements, doubtful * tolerance)) {
            const Element &e = change.added[i], &other = result.elements[j];
            const bool is_new = std::binary_search(change.added.begin(), change.added.end(), other, comes_before);
            if (e == other || (is_new && comes_before(other, e))) continue;
            note_nearly_joined(e, other, tolerance, *ambiguities);
        }
    }
    return change;
}

void apply(const Change& change, Shape& design) {
    std::vector<Element>& all = design.elements;
    auto kept = all.begin(), from = all.begin();
    for (const Element& gone : change.removed) {
        const auto at = std::lower_bound(from, all.end(), gone, comes_before);
        if (at == all.end() || *at != gone) continue;
        kept = kept == from ? at : std::move(from, at, kept);
        from = at + 1;
    }
    if (kept != from) all.erase(std::move(from, all.end(), kept), all.end());
    // From the back, so that each element moves once.
    auto end = static_cast<std::ptrdiff_t>(all.size());
    all.resize(all.size() + change.added.size());
    auto to = static_cast<std::ptrdiff_t>(all.size());
    for (auto added = change.added.rbegin(); added != change.added.rend(); ++added) {
        const auto place = std::upper_bound(all.begin(), all.begin() + end, *added, comes_before) - all.begin();
        std::move_backward(all.begin() + place, all.begin() + end, all.begin() + to);
        to -= end - place;
        end = place;
        all[static_cast<std::size_t>(--to)] = *added;
    }
}

Change inverse(Change change) {
    std::swap(change.removed, change.added);
    return change;
}

Shape replaced(Shape design, const Shape& taken, const Shape& put, double tolerance, Ambiguities* ambiguities) {
    apply(change_by(design, taken, put, tolerance, ambiguities), design);
    return design;
}

}  // namespace filigree::curves
