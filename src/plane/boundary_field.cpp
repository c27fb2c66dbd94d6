#include "plane/boundary_field.h"

#include <algorithm>
#include <cmath>

namespace filigree {

BorderSamples sampled_border(PolygonView shape, Point origin, double spacing) {
    constexpr double fewest = 12, most = 2000;
    BorderSamples border;
    // From each ring's least point on, and the holes in the order of theirs: sums do not depend on how they are given.
    std::vector<RingView> rings;
    for (std::size_t r = 0; r < shape.ring_count(); ++r) rings.push_back(shape.ring(r));
    const auto least = [](RingView ring) { return std::min_element(ring.begin(), ring.end()); };
    std::sort(rings.begin() + 1, rings.end(), [&](RingView a, RingView b) { return *least(a) < *least(b); });
    for (const RingView& given : rings) {
        std::vector<Point> ring(given.begin(), given.end());
        std::rotate(ring.begin(), ring.begin() + (least(given) - given.begin()), ring.end());
        double total = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            total += length(to_px(ring[(i + 1) % ring.size()], origin) - to_px(ring[i], origin));
        }
        const double count = std::clamp(std::ceil(total / spacing), fewest, most);
        const std::size_t first = border.points.size();
        // The k-th point lies at (k + 1/2) / count of the way round.
        double reached = 0, next = 0.5;
        for (std::size_t i = 0; i < ring.size() && next < count; ++i) {
            const Vec from = to_px(ring[i], origin), to = to_px(ring[(i + 1) % ring.size()], origin);
            const double side = length(to - from);
            for (; next < count && next * total / count <= reached + side; ++next) {
                const double part = side > 0 ? (next * total / count - reached) / side : 0;
                border.points.push_back(from + std::clamp(part, 0.0, 1.0) * (to - from));
            }
            reached += side;
        }
        const std::size_t size = border.points.size() - first;
        for (std::size_t i = 0; i < size; ++i) {
            const Vec along = border.points[first + (i + 1) % size] - border.points[first + (i + size - 1) % size];
            const double norm = length(along);
            border.tangents.push_back(norm > 0 ? (1 / norm) * along : Vec{});
        }
        border.ring_ends.push_back(border.points.size());
    }
    return border;
}

Vec mean_value(const BorderSamples& border, const std::vector<Vec>& vectors, Vec p) {
    double weights = 0;
    Vec sum;
    std::size_t first = 0;
    for (const std::size_t end : border.ring_ends) {
        if (end - first < 3) {
            first = end;
            continue;
        }
        Vec a = border.points[end - 1] - p;
        double to_a = length(a);
        Vec last = vectors[end - 1];
        for (std::size_t i = first; i < end; ++i) {
            if (to_a == 0) return last;
            const Vec b = border.points[i] - p;
            const double to_b = length(b);
            const double turn = cross(a, b), facing = dot(a, b), product = to_a * to_b;
            // On the side from a to b, where the weights are infinite.
            if (std::fabs(turn) <= 1e-12 * product && facing < 0) {
                return last + (to_a / (to_a + to_b)) * (vectors[i] - last);
            }
            if (turn != 0 && to_b > 0) {
                const double tangent = (product - facing) / turn;  // of half the angle
                const double of_a = tangent / to_a, of_b = tangent / to_b;
                weights += of_a + of_b;
                sum = sum + of_a * last + of_b * vectors[i];
            }
            a = b;
            to_a = to_b;
            last = vectors[i];
        }
        first = end;
    }
    return weights != 0 ? (1 / weights) * sum : Vec{};
}

VectorField boundary_field(const BorderSamples& border, const std::vector<Vec>& vectors, const Grid& grid,
                           const std::vector<double>& distances) {
    std::vector<double> x(grid.size(), 0.0), y(grid.size(), 0.0);
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
        for (std::uint32_t column = 0; column < grid.columns; ++column) {
            const std::size_t at = grid.index(column, row);
            if (distances[at] < -2 * grid.step) continue;
            const Vec vector = mean_value(border, vectors, grid.node(column, row));
            x[at] = vector.x;
            y[at] = vector.y;
        }
    }
    return {spline_of(grid, x), spline_of(grid, y)};
}

DirectionField direction_field(const BorderSamples& border, const std::vector<Vec>& directions, const Grid& grid,
                               const std::vector<double>& distances) {
    std::vector<Vec> doubled;
    doubled.reserve(directions.size());
    for (const Vec v : directions) {
        const double square = dot(v, v);
        doubled.push_back(square > 0 ? (1 / square) * Vec{v.x * v.x - v.y * v.y, 2 * v.x * v.y} : Vec{});
    }
    return {boundary_field(border, doubled, grid, distances)};
}

Vec DirectionField::at(Vec p) const {
    const Vec twice = doubled.at(p);
    const double norm = length(twice);
    if (!(norm > 1e-9)) return {};
    const double x = std::sqrt(std::max(0.0, (1 + twice.x / norm) / 2));
    const double y = std::sqrt(std::max(0.0, (1 - twice.x / norm) / 2));
    return {x, twice.y < 0 ? -y : y};
}

}  // namespace filigree
