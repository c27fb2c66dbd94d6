// For tests of silhouettes alone: shapes drawn into greys, and measures of what comes back.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "base/elementary.h"
#include "plane/grey_image.h"
#include "plane/path.h"

namespace filigree {

using Rings = std::vector<std::vector<Vec>>;

inline std::vector<Vec> disc_ring(Vec centre, double radius, std::size_t count = 720) {
    std::vector<Vec> ring;
    for (std::size_t i = 0; i < count; ++i) {
        const auto turn = elementary::cos_sin_degrees(360.0 * static_cast<double>(i) / static_cast<double>(count));
        ring.push_back(centre + radius * Vec{turn.cos, turn.sin});
    }
    return ring;
}

// A ring of points turned about a place.
inline std::vector<Vec> turned_ring(std::vector<Vec> ring, double degrees, Vec about) {
    const auto turn = elementary::cos_sin_degrees(degrees);
    for (Vec& p : ring) {
        const Vec d = p - about;
        p = about + Vec{d.x * turn.cos - d.y * turn.sin, d.x * turn.sin + d.y * turn.cos};
    }
    return ring;
}

inline bool is_inside(const Rings& rings, Vec p) {  // even-odd
    bool inside = false;
    for (const std::vector<Vec>& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec a = ring[i], b = ring[(i + 1) % ring.size()];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
        }
    }
    return inside;
}

// `samples` a pixel and side: 1 draws black and white, more smooth edges.
inline GreyImage drawn(const Rings& rings, std::uint32_t width, std::uint32_t height, int samples) {
    GreyImage image{width, height, {}};
    std::vector<int> counts(std::size_t{width} * height);
    for (std::uint32_t row = 0; row < height * static_cast<std::uint32_t>(samples); ++row) {
        const double y = (row + 0.5) / samples;
        std::vector<double> crossings;
        for (const std::vector<Vec>& ring : rings) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Vec a = ring[i], b = ring[(i + 1) % ring.size()];
                if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
            }
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const double first = std::ceil(crossings[i] * samples - 0.5), end = crossings[i + 1] * samples - 0.5;
            for (double s = std::max(first, 0.0); s < end && s < static_cast<double>(width) * samples; ++s) {
                const auto x = static_cast<std::size_t>(s) / static_cast<std::size_t>(samples);
                ++counts[row / static_cast<std::uint32_t>(samples) * width + x];
            }
        }
    }
    for (const int count : counts)
        image.darkness.push_back(static_cast<float>(count) / static_cast<float>(samples * samples));
    return image;
}

inline double signed_area(const std::vector<Vec>& ring) {
    double doubled = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) doubled += cross(ring[i], ring[(i + 1) % ring.size()]);
    return doubled / 2;
}

// How far the directions of a ring turn in all, either way: 360 degrees for what is convex.
inline double whole_turn(const std::vector<Vec>& ring) {
    double turn = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec a = ring[(i + 1) % ring.size()] - ring[i];
        const Vec b = ring[(i + 2) % ring.size()] - ring[(i + 1) % ring.size()];
        turn += std::fabs(elementary::atan2(cross(a, b), dot(a, b)));
    }
    return turn * 180 / elementary::pi;
}

inline double distance_to_segment(Vec p, Vec a, Vec b) {
    const Vec along = b - a;
    const double size = dot(along, along);
    const double t = size > 0 ? std::clamp(dot(p - a, along) / size, 0.0, 1.0) : 0;
    return length(p - a - t * along);
}
inline double distance_to_rings(Vec p, const Rings& rings) {
    double least = HUGE_VAL;
    for (const std::vector<Vec>& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            least = std::min(least, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
        }
    }
    return least;
}
// The farthest that a point of `from` lies from the edges of `to`, edges sampled every half px.
inline double farthest(const Rings& from, const Rings& to) {
    double most = 0;
    for (const std::vector<Vec>& ring : from) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec a = ring[i], b = ring[(i + 1) % ring.size()];
            const int steps = 1 + static_cast<int>(2 * length(b - a));
            for (int s = 0; s < steps; ++s)
                most = std::max(most, distance_to_rings(a + (b - a) * (double(s) / steps), to));
        }
    }
    return most;
}

inline Rings rings_of(const std::vector<Polyline>& outlines) {
    Rings rings;
    for (const Polyline& line : outlines) rings.push_back(line.points);
    return rings;
}
// The most that any of the corners is missed by.
inline double corner_miss(const std::vector<Vec>& corners, const Rings& rings) {
    double most = 0;
    for (const Vec corner : corners) most = std::max(most, distance_to_rings(corner, rings));
    return most;
}

}  // namespace filigree
