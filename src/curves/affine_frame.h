// The points of a left side by which an affine map is found, and where in a design they may lie.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>

#include "curves/match.h"
#include "curves/registration.h"

namespace filigree::curves {

// Three points that an affine map keeps. The first two are registration points, the third is one, too, or is made of
// them and the tangents there.
struct AffineFrame {
    enum class Third : std::uint8_t {
        point,    // a registration point
        meeting,  // where a tangent at the first meets a tangent at the second
        beside,   // from the first along one tangent there, from the second against the other
    };
    Third third = Third::point;
    std::array<std::uint32_t, 3> points{};  // registration points of the left side
    std::array<std::size_t, 2> ways{};      // meeting: the tangents at the first and second; beside: at the first
    std::array<Vec, 3> at{};
    double cost = 0;       // roughly how many triples of a design are to be tried
    double roundness = 0;  // of the triangle: its height over its longest side
};

// The best frame: with few places to try, and a triangle that is not flat. None where the shape fixes no affine map.
std::optional<AffineFrame> frame_of(const Shape& left, const Registrations& own, const Registrations& design);

// The third point of a frame in a design, from registration points with elements in the left side's order. Nothing
// where there is none.
std::optional<Vec> third_of(const AffineFrame& frame, const Registration& first, const Registration& second);

// The affine map between two triangles; of the first the area must not be zero.
Transform carrying(const std::array<Vec, 3>& from, const std::array<Vec, 3>& to);

// A place of a frame in a design: where its points lie, and on which of the design's elements those of the left side
// that meet there; the others are `unbound`.
struct AffineSeat {
    static constexpr std::uint32_t unbound = UINT32_MAX;
    std::array<Vec, 3> at{};
    std::vector<std::uint32_t> carriers;
};

// Which left element may lie on which element of the design, as far as kinds, layers and weights tell.
using MayCarry = std::function<bool(std::uint32_t own, std::uint32_t slot)>;

// Calls take(seat) for every place, until it says false.
void find_seats(const AffineFrame& frame, const Registrations& own, const Registrations& design,
                const MayCarry& may_carry, const std::function<bool(const AffineSeat&)>& take);

}  // namespace filigree::curves
