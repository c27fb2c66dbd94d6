// Vectors and frames in space.
#pragma once

#include <cmath>

namespace filigree {

struct Vec3 {
    double x = 0, y = 0, z = 0;

    bool operator==(const Vec3&) const = default;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3 operator*(double s, Vec3 a) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
// Not a number where the length is 0.
inline Vec3 unit(Vec3 a) {
    const double all = length(a);
    return {a.x / all, a.y / all, a.z / all};
}

// Orthonormal and right-handed: heading x left = up.
struct Frame3 {
    Vec3 heading{1, 0, 0}, left{0, 1, 0}, up{0, 0, 1};

    bool operator==(const Frame3&) const = default;
};

}  // namespace filigree
