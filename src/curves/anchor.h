// What of a left side fixes the transform that carries it: a curve with a frame, two places, a place and a line, or
// three lines. A left side that has none of them lies on a design in infinitely many ways (family.h), or not at all.
//
// Places are labelled points and the centres of circles. Ends are none: the end of a left element need not be an end in
// the design, but where lines cross they cross in the design, too.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "curves/embedding.h"
#include "curves/frame.h"

namespace filigree::curves {

enum class AnchorKind : std::uint8_t {
    parabola,
    cubic,
    ellipse,
    places,          // two that are apart
    place_and_line,  // of a labelled point off the line, or of a circle; within isometries of any place
    lines,           // the first crosses the second and the third in two places
    crossing,        // two lines that cross: fixes an isometry
    place,           // fixes a translation
};

struct Anchor {
    AnchorKind kind = AnchorKind::parabola;
    std::array<std::uint32_t, 3> elements{};  // as many as the kind says
    // How far each left element may be off its carrier, px, before the transform is mended by all of them.
    std::vector<double> reach;
    ParabolaFrame parabola;  // where it is one
    CubicFrame cubic;
    bool is_loose = false;          // its own noise moves it so far that it serves only where there is no other
    bool is_on_line = false;        // place_and_line: the place lies on the line
    std::array<bool, 2> do_meet{};  // lines, crossing: whether the second and third touch the first
};

// Elements of a design on which an anchor's may lie. They leave two or four transforms, which `is_reflected` and
// `is_turned` tell apart: whether it reflects; whether an ellipse or a line runs the other way.
struct Seat {
    std::array<std::uint32_t, 3> slots{};
    bool is_reflected = false, is_turned = false;
};

bool is_circle(const Element& e);
// Of a labelled point or a circle.
inline bool is_place(const Element& e) { return e.kind == ElementKind::point || is_circle(e); }

// Two places that are no farther apart fix no direction.
inline double least_distance(const MatchOptions& options) { return 20 * options.tolerance; }

// All curves that are anchors, and others that are worth trying; the best conditioned ones first.
std::vector<Anchor> anchors_of(const Embedding& embedding);
inline bool is_curve(const Anchor& anchor) { return anchor.kind <= AnchorKind::ellipse; }

// What carries the anchor's elements onto a seat within the group, not checked any further. Not finite where the seat
// is none.
Similarity carrying(const Embedding& embedding, const Anchor& anchor, const Seat& seat);
// The same onto slots of which it is known roughly how.
Similarity carrying(const Embedding& embedding, const Anchor& anchor, const std::array<std::uint32_t, 3>& slots,
                    const Similarity& roughly);

}  // namespace filigree::curves
