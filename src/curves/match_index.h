// A design made ready for the search for subshapes: its elements where they lie, and the descriptors of its curves in
// columns, so that a pass over all of them rules most out before any transform is made.
//
// Built once, then kept in step with the rules that are applied: an update costs by what it changes. Elements stand in
// slots, which stay while others come and go. Of a design that was not updated, slot i holds element i.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "curves/element_grid.h"
#include "curves/frame.h"
#include "curves/shape.h"

namespace filigree::curves {

// The parabola arcs of a design, a row each, in no particular order.
struct ParabolaTable {
    std::vector<double> low, high;                // the interval of slopes
    std::vector<double> per_px_low, per_px_high;  // slope per px there
    std::vector<double> radius;                   // of curvature at the vertex
    std::vector<std::uint32_t> slots;
};

// Of an element as much as is needed to see that it is no carrier, in one line of the cache.
struct alignas(64) Glimpse {
    Vec at, a, b;  // parabola: at + b t + a t^2; line: at + b t; else at alone
    double weight = 1;
    std::uint32_t layer = 0;
    ElementKind kind = ElementKind::line;
};
inline Vec point_at(const Glimpse& glimpse, double t) { return glimpse.at + (glimpse.b + glimpse.a * t) * t; }

class MatchIndex {
public:
    MatchIndex() = default;
    // A maximal shape, and the tolerance with which it will be searched, px.
    MatchIndex(const Shape& design, double tolerance);

    struct Change {
        std::vector<std::uint32_t> removed, added;  // slots; one may have been emptied and filled again
    };
    // Takes away elements (equal ones; what is not there is passed over) and puts others. Together the design must be
    // maximal again.
    Change update(std::span<const Element> removed, std::span<const Element> added);

    std::size_t slot_count() const { return elements_.size(); }
    bool is_taken(std::uint32_t slot) const { return row_[slot] != none; }
    const Element& element(std::uint32_t slot) const { return elements_[slot]; }
    const Glimpse& glimpse(std::uint32_t slot) const { return glimpses_[slot]; }
    const ParabolaFrame& frame(std::uint32_t slot) const { return frames_[slot]; }           // of a parabola
    const CubicFrame& cubic_frame(std::uint32_t slot) const { return cubics_[row_[slot]]; }  // of a cubic
    // The lines that a line touches or crosses, at some angle; the slots are in no particular order.
    const std::vector<std::uint32_t>& met_by(std::uint32_t slot) const { return met_[slot]; }
    // How many pairs of lines meet.
    std::size_t meetings() const { return meetings_; }
    const ElementGrid& grid() const { return grid_; }
    const ParabolaTable& parabolas() const { return parabolas_; }
    std::uint32_t row(std::uint32_t slot) const { return row_[slot]; }  // in the table of its kind
    // Ask the memory for what will be read soon.
    void fetch_glimpse(std::uint32_t slot) const { __builtin_prefetch(&glimpses_[slot]); }
    void fetch_frame(std::uint32_t slot) const { __builtin_prefetch(&frames_[slot]); }
    // In no particular order.
    const std::vector<std::uint32_t>& slots_of(ElementKind kind) const {
        return kind == ElementKind::parabola ? parabolas_.slots : slots_[static_cast<std::size_t>(kind)];
    }

private:
    static constexpr std::uint32_t none = UINT32_MAX;

    void enter(std::uint32_t slot);  // into the table of its kind
    void leave(std::uint32_t slot);
    void meet_others(std::uint32_t slot, bool below_only);
    void part_from_others(std::uint32_t slot);

    double tolerance_ = 0;

    std::vector<Element> elements_;
    std::vector<Glimpse> glimpses_;
    std::vector<ParabolaFrame> frames_;
    std::vector<std::uint32_t> row_;  // of each slot in the table of its kind; none where the slot is free
    std::vector<std::uint32_t> free_;
    std::array<std::vector<std::uint32_t>, 5> slots_;
    ParabolaTable parabolas_;
    std::vector<CubicFrame> cubics_;
    std::vector<std::vector<std::uint32_t>> met_;
    std::size_t meetings_ = 0;
    ElementGrid grid_;
};

}  // namespace filigree::curves
