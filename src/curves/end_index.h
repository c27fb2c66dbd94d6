// Which elements may meet an element along a curve: those of which an end lies near it, since two that share a
// descriptor and touch or overlap have an end of one on the other. A whole circle or ellipse has one place on it for an
// end.
//
// Long elements are looked along stretch by stretch, so that what lies in the corners of their boxes is not found.
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

    // Calls visit(index) for every element with an end within `reach` of the element (and for some others; mostly
    // twice), until one returns true; whether one did. In an order that hangs on the elements alone.
    template <class Visit>
    bool any(const Element& e, double reach, Visit visit) const {
        std::array<Bounds, most_stretches> boxes;
        const std::size_t count = boxes_along(e, boxes);
        for (std::size_t i = 0; i < count; ++i) {
            const VecBox around{boxes[i].min - Vec{reach, reach}, boxes[i].max + Vec{reach, reach}};
            if (tree_.any(around, [&](std::uint32_t end) { return visit(element_of_[end]); })) return true;
        }
        return false;
    }

private:
    static constexpr std::size_t most_stretches = 64;
    std::size_t boxes_along(const Element& e, std::array<Bounds, most_stretches>& boxes) const;

    std::vector<std::uint32_t> element_of_;
    EdgeTree tree_;
    double ends_per_area_ = 0;
};

// All pairs of an element of `a` and one of `b`, of one kind and layer, of which an end of one lies within `reach` of
// the other, and some more; in order.
using Pair = std::pair<std::uint32_t, std::uint32_t>;
std::vector<Pair> pairs_near(std::span<const Element> a, std::span<const Element> b, double reach);

}  // namespace filigree::curves
