// Points of the plane: exact ones on the fixed grid, and vectors of doubles in px.
//
// Every coordinate that outlives an operation lies on one grid of 2^-26 px with |x| <= 2^30 px, so that
// equality is equality, neighbours share their vertices exactly, and predicates are exact in 128-bit
// integers. y grows downwards, as in SVG.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

namespace filigree {

__extension__ typedef __int128 Int128;

constexpr double grid_per_px = 67108864.0;                  // 2^26
constexpr std::int64_t grid_limit = std::int64_t{1} << 56;  // 2^30 px

struct Point {  // on the grid
    std::int64_t x = 0;
    std::int64_t y = 0;

    auto operator<=>(const Point&) const = default;
};

struct Vec {  // px
    double x = 0;
    double y = 0;

    bool operator==(const Vec&) const = default;
};

constexpr Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec operator*(Vec a, double s) { return {a.x * s, a.y * s}; }
constexpr Vec operator*(double s, Vec a) { return {a.x * s, a.y * s}; }
constexpr Vec operator-(Vec a) { return {-a.x, -a.y}; }
constexpr double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
constexpr Vec perpendicular(Vec a) { return {-a.y, a.x}; }  // a quarter turn from +x to +y
inline double length(Vec a) { return std::sqrt(dot(a, a)); }

constexpr Vec to_px(Point p) {
    return {static_cast<double>(p.x) / grid_per_px, static_cast<double>(p.y) / grid_per_px};
}
// The nearest whole number, halves away from zero; without a call, as std::llround is one.
constexpr std::int64_t round_to_whole(double v) {
    const auto whole = static_cast<std::int64_t>(v);
    const double rest = v - static_cast<double>(whole);  // exact
    return whole + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
}
// The nearest grid point, halves away from zero. The vector must lie inside the grid's limit.
constexpr Point snap(Vec v) { return {round_to_whole(v.x * grid_per_px), round_to_whole(v.y * grid_per_px)}; }
// Whether a vector is finite and may be snapped.
inline bool is_on_plane(Vec v) {
    return std::fabs(v.x) <= 0x1p30 && std::fabs(v.y) <= 0x1p30;  // false for NaN
}

// (b - a) x (c - a), exact.
constexpr Int128 cross(Point a, Point b, Point c) {
    return static_cast<Int128>(b.x - a.x) * (c.y - a.y) - static_cast<Int128>(b.y - a.y) * (c.x - a.x);
}
// The sign of it: +1 where a, b, c turn from +x towards +y, 0 where they are collinear.
constexpr int orientation(Point a, Point b, Point c) {
    const Int128 turn = cross(a, b, c);
    return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

struct Box {  // on the grid, closed; empty while min > max
    Point min{INT64_MAX, INT64_MAX};
    Point max{INT64_MIN, INT64_MIN};

    bool operator==(const Box&) const = default;
};
constexpr bool is_empty(const Box& box) { return box.min.x > box.max.x; }
constexpr void extend(Box& box, Point p) {
    if (p.x < box.min.x) box.min.x = p.x;
    if (p.y < box.min.y) box.min.y = p.y;
    if (p.x > box.max.x) box.max.x = p.x;
    if (p.y > box.max.y) box.max.y = p.y;
}
constexpr bool overlaps(const Box& a, const Box& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

}  // namespace filigree
