// Which elements may meet an element along a curve: those of which an end lies near it, since two that share a
// descriptor and touch or overlap have an end of one on the other. A whole circle or ellipse has one place on it for an
// end.
//
// Where many ends lie in the box of an element, it is looked along part by part, so that what lies in the corners is
// not found.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "curves/element.h"
#include "plane/edge_tree.h"

namespace filigree::curves {

class EndIndex {
public:
    explicit EndIndex(std::span<const Element> elements);

    // Calls visit(index) for every element with an end within `reach` of the element (and for some others, and some
    // twice), until one returns true; whether one did. In an order that hangs on the elements alone.
    template <class Visit>
    bool any(const Element& e, double reach, Visit visit) const {
        struct Part {
            Interval on;
            int depth = 0;
        };
        std::array<Part, most_depth + 1> open;
        std::size_t count = 0;
        open[count++] = {interval_of(e), 0};
        std::array<std::uint32_t, crowd> found;
        while (count > 0) {
            const auto [on, depth] = open[--count];
            const Bounds box = depth == 0 ? bounds_of(e) : bounds_of(piece_of(e, on));
            const VecBox around{box.min - Vec{reach, reach}, box.max + Vec{reach, reach}};
            if (depth == most_depth) {
                if (tree_.any(around, [&](std::uint32_t end) { return visit(element_of_[end]); })) return true;
                continue;
            }
            std::size_t size = 0;
            const bool is_crowded = tree_.any(around, [&](std::uint32_t end) {
                if (size == crowd) return true;
                found[size++] = element_of_[end];
                return false;
            });
            if (is_crowded) {
                const double middle = 0.5 * (on.from + on.to);
                open[count++] = {{middle, on.to}, depth + 1};
                open[count++] = {{on.from, middle}, depth + 1};
                continue;
            }
            for (std::size_t i = 0; i < size; ++i) {
                if (visit(found[i])) return true;
            }
        }
        return false;
    }

private:
    static constexpr std::size_t crowd = 32;  // so many ends in a box are worth looking at its halves instead
    static constexpr int most_depth = 12;

    std::vector<std::uint32_t> element_of_;
    EdgeTree tree_;
};

// All pairs of an element of `a` and one of `b`, of one kind and layer, of which an end of one lies within `reach` of
// the other, and some more; in order.
using Pair = std::pair<std::uint32_t, std::uint32_t>;
std::vector<Pair> pairs_near(std::span<const Element> a, std::span<const Element> b, double reach);

}  // namespace filigree::curves
