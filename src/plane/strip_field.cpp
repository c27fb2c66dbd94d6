#include "plane/strip_field.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/elementary.h"
#include "plane/distance_field.h"

namespace filigree {
namespace {

constexpr double most_nodes = 1000, least_nodes = 150;
constexpr int rounds = 10;           // of the search for the slowest vibration
constexpr double shift = 1e-6;       // makes the matrix regular: free borders leave a constant open
constexpr double thin_link = 0.02;   // between nodes that lie partly outside
constexpr double inner_link = 0.25;  // between nodes inside: what is narrower than the grid stays joined
constexpr std::uint32_t not_in = UINT32_MAX;

// The nodes in and around the shape, numbered along the shorter side of the grid, and their links to later ones.
struct Mesh {
    Grid grid;
    std::vector<std::uint32_t> number;  // of each node of the grid, or not_in
    std::vector<std::size_t> node;      // of each number
    std::vector<double> mass;           // how much of a node's square is inside, about
    struct Link {
        std::uint32_t from = 0, to = 0;
        bool is_row = false;
        double width = 0;  // the part of the side between both squares that is inside
    };
    std::vector<Link> links;
    std::size_t band = 1;  // the greatest difference of linked numbers
};

// How much of a side is inside, from the distances of its ends.
double part_inside(double a, double b) {
    return a > 0 && b > 0 ? 1 : a <= 0 && b <= 0 ? 0 : std::max(a, b) / std::fabs(a - b);
}

// `corners`: the distances half a step right of and below each node.
Mesh mesh_of(const Grid& grid, const std::vector<double>& distances, const std::vector<double>& corners) {
    Mesh mesh{grid, std::vector<std::uint32_t>(grid.size(), not_in), {}, {}, {}, 1};
    const bool by_rows = grid.columns <= grid.rows;
    const std::uint32_t outer = by_rows ? grid.rows : grid.columns, inner = by_rows ? grid.columns : grid.rows;
    for (std::uint32_t i = 1; i + 1 < outer; ++i) {
        for (std::uint32_t j = 1; j + 1 < inner; ++j) {
            const std::size_t at = by_rows ? grid.index(j, i) : grid.index(i, j);
            if (distances[at] <= -0.5 * grid.step) continue;
            mesh.number[at] = static_cast<std::uint32_t>(mesh.node.size());
            mesh.node.push_back(at);
            const double c[] = {corners[at - 1 - grid.columns], corners[at - grid.columns], corners[at - 1],
                                corners[at]};
            const double square = std::max(part_inside(c[0], c[2]), part_inside(c[1], c[3])) *
                                  std::max(part_inside(c[0], c[1]), part_inside(c[2], c[3]));
            mesh.mass.push_back(std::clamp(std::min(0.5 + distances[at] / grid.step, square), 0.02, 1.0));
        }
    }
    for (std::uint32_t from = 0; from < mesh.node.size(); ++from) {
        const std::size_t at = mesh.node[from];
        for (const bool is_row : {true, false}) {
            const std::size_t next = at + (is_row ? 1 : grid.columns);
            const std::uint32_t to = mesh.number[next];
            if (to == not_in) continue;
            const double width = std::max(part_inside(corners[at], corners[at - (is_row ? grid.columns : 1)]),
                                          distances[at] > 0 && distances[next] > 0 ? inner_link : thin_link);
            mesh.links.push_back({from, to, is_row, width});
            mesh.band = std::max<std::size_t>(mesh.band, to > from ? to - from : from - to);
        }
    }
    return mesh;
}

// The links' matrix, factorised once: L D L' in bands.
class Stiffness {
public:
    explicit Stiffness(const Mesh& mesh) : count_(mesh.node.size()), width_(mesh.band + 1), rows_(count_ * width_) {
        for (std::size_t i = 0; i < count_; ++i) at(i, i) = shift * mesh.mass[i];
        for (const Mesh::Link& link : mesh.links) {
            at(link.from, link.from) += link.width;
            at(link.to, link.to) += link.width;
            at(std::max(link.from, link.to), std::min(link.from, link.to)) -= link.width;
        }
        std::vector<double> scaled(width_);
        for (std::size_t i = 0; i < count_; ++i) {
            const std::size_t first = i >= width_ - 1 ? i - (width_ - 1) : 0;
            double* const row = &rows_[i * width_ + (width_ - 1) - i + first];  // from column `first` on
            for (std::size_t j = first; j < i; ++j) {
                const std::size_t shared = std::max(first, j >= width_ - 1 ? j - (width_ - 1) : 0);
                const double* const other = &rows_[j * width_ + (width_ - 1) - j + shared];
                double sum = row[j - first];
                for (std::size_t k = 0; k < j - shared; ++k) sum -= scaled[shared - first + k] * other[k];
                scaled[j - first] = sum;
                row[j - first] = sum;
            }
            double pivot = row[i - first];
            for (std::size_t j = first; j < i; ++j) {
                row[j - first] = scaled[j - first] / at(j, j);
                pivot -= scaled[j - first] * row[j - first];
            }
            row[i - first] = pivot;
        }
    }
    void solve(std::vector<double>& x) const {
        for (std::size_t i = 0; i < count_; ++i) {
            const std::size_t first = i >= width_ - 1 ? i - (width_ - 1) : 0;
            for (std::size_t j = first; j < i; ++j) x[i] -= at(i, j) * x[j];
        }
        for (std::size_t i = 0; i < count_; ++i) x[i] /= at(i, i);
        for (std::size_t i = count_; i-- > 0;) {
            const std::size_t first = i >= width_ - 1 ? i - (width_ - 1) : 0;
            for (std::size_t j = first; j < i; ++j) x[j] -= at(i, j) * x[i];
        }
    }

private:
    double& at(std::size_t i, std::size_t j) { return rows_[i * width_ + (width_ - 1) - (i - j)]; }
    double at(std::size_t i, std::size_t j) const { return rows_[i * width_ + (width_ - 1) - (i - j)]; }

    std::size_t count_ = 0, width_ = 1;
    std::vector<double> rows_;
};

// Coordinates along the direction in which the shape extends most.
std::vector<double> first_guess(const Mesh& mesh) {
    double xx = 0, yy = 0, xy = 0;
    const auto place = [&](std::size_t i) {
        return mesh.grid.node(static_cast<std::uint32_t>(mesh.node[i] % mesh.grid.columns),
                              static_cast<std::uint32_t>(mesh.node[i] / mesh.grid.columns));
    };
    Vec middle;
    double mass = 0;
    for (std::size_t i = 0; i < mesh.node.size(); ++i) {
        middle = middle + mesh.mass[i] * place(i);
        mass += mesh.mass[i];
    }
    if (mass > 0) middle = (1 / mass) * middle;
    for (std::size_t i = 0; i < mesh.node.size(); ++i) {
        const Vec p = place(i) - middle;
        xx += mesh.mass[i] * p.x * p.x;
        yy += mesh.mass[i] * p.y * p.y;
        xy += mesh.mass[i] * p.x * p.y;
    }
    Vec axis{1, 0};
    const double spread = std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy);
    if (spread > 1e-3 * (xx + yy)) {
        const elementary::CosSin at = elementary::cos_sin(elementary::atan2(2 * xy, xx - yy) / 2);
        axis = {at.cos, at.sin};
    }
    std::vector<double> guess(mesh.node.size());
    for (std::size_t i = 0; i < guess.size(); ++i) guess[i] = dot(place(i) - middle, axis);
    return guess;
}

void centre_and_scale(const Mesh& mesh, std::vector<double>& values) {
    double sum = 0, mass = 0, square = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += mesh.mass[i] * values[i];
        mass += mesh.mass[i];
    }
    for (double& value : values) value -= sum / mass;
    for (std::size_t i = 0; i < values.size(); ++i) square += mesh.mass[i] * values[i] * values[i];
    if (!(square > 0)) return;
    for (double& value : values) value /= std::sqrt(square / mass);
}

// What each node's links should gain in all, if the gradient of `values` had unit length everywhere.
std::vector<double> gains_of(const Mesh& mesh, const std::vector<double>& values) {
    std::array<std::vector<double>, 2> sum, weight;  // of the slopes at each node along rows and columns
    for (std::size_t k = 0; k < 2; ++k) {
        sum[k].assign(values.size(), 0.0);
        weight[k].assign(values.size(), 0.0);
    }
    for (const Mesh::Link& link : mesh.links) {
        const std::size_t k = link.is_row ? 0 : 1;
        const double rise = values[link.to] - values[link.from];
        for (const std::uint32_t end : {link.from, link.to}) {
            sum[k][end] += link.width * rise;
            weight[k][end] += link.width;
        }
    }
    std::vector<double> gains(values.size(), 0.0);
    for (const Mesh::Link& link : mesh.links) {
        const std::size_t other = link.is_row ? 1 : 0;
        const double rise = values[link.to] - values[link.from];
        const double sums = sum[other][link.from] + sum[other][link.to];
        const double weights = weight[other][link.from] + weight[other][link.to];
        const double side = weights > 0 ? sums / weights : 0;
        const double length = std::sqrt(rise * rise + side * side);
        if (!(length > 0)) continue;
        const double gain = link.width * mesh.grid.step * rise / length;
        gains[link.to] += gain;
        gains[link.from] -= gain;
    }
    return gains;
}

// The values on the whole grid: straight on beyond the nodes that have one, layer by layer.
std::vector<double> continued(const Mesh& mesh, const std::vector<double>& values) {
    constexpr int layers = 5;
    const Grid& grid = mesh.grid;
    std::vector<double> all(grid.size(), 0.0);
    std::vector<bool> is_known(grid.size(), false);
    for (std::size_t i = 0; i < values.size(); ++i) {
        all[mesh.node[i]] = values[i];
        is_known[mesh.node[i]] = true;
    }
    for (int layer = 0; layer < layers; ++layer) {
        std::vector<std::size_t> added;
        for (std::uint32_t row = 0; row < grid.rows; ++row) {
            for (std::uint32_t column = 0; column < grid.columns; ++column) {
                const std::size_t at = grid.index(column, row);
                if (is_known[at]) continue;
                double sum = 0, count = 0, level_sum = 0, level_count = 0;
                for (int dy = -1; dy <= 1; ++dy) {
                    for (int dx = -1; dx <= 1; ++dx) {
                        const auto known = [&](int times) -> const double* {
                            const std::int64_t x = std::int64_t{column} + times * dx,
                                               y = std::int64_t{row} + times * dy;
                            if (x < 0 || y < 0 || x >= grid.columns || y >= grid.rows) return nullptr;
                            const std::size_t i =
                                grid.index(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
                            return is_known[i] ? &all[i] : nullptr;
                        };
                        const double* const near = known(1);
                        if (near == nullptr) continue;
                        level_sum += *near;
                        ++level_count;
                        if (const double* const far = known(2); far != nullptr) {
                            sum += 2 * *near - *far;
                            ++count;
                        }
                    }
                }
                if (level_count == 0) continue;
                all[at] = count > 0 ? sum / count : level_sum / level_count;
                added.push_back(at);
            }
        }
        for (const std::size_t at : added) is_known[at] = true;
    }
    return all;
}

}  // namespace

StripField strip_field(const EdgeTree& border, Vec size, double area, double detail) {
    const double fine = std::sqrt(area / most_nodes), coarse = std::sqrt(area / least_nodes);
    const double step = std::max(std::clamp(detail, fine, coarse), std::max(size.x, size.y) / 500);
    const Grid grid = grid_over(size, step, 5);
    const std::vector<double> distances = signed_distances(border, grid);
    Grid between = grid;
    between.low = grid.low + Vec{step / 2, step / 2};
    const Mesh mesh = mesh_of(grid, distances, signed_distances(border, between));
    StripField field;
    if (mesh.node.empty()) {
        field.along = {grid, std::vector<double>(grid.size(), 0.0)};
        return field;
    }
    const Stiffness stiffness(mesh);
    std::vector<double> values = first_guess(mesh);
    const std::vector<double> guess = values;
    centre_and_scale(mesh, values);
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] *= mesh.mass[i];
        stiffness.solve(values);
        centre_and_scale(mesh, values);
    }
    std::vector<double> along = gains_of(mesh, values);
    stiffness.solve(along);
    double agreement = 0, sum = 0, mass = 0;
    for (std::size_t i = 0; i < along.size(); ++i) {
        agreement += mesh.mass[i] * along[i] * guess[i];
        sum += mesh.mass[i] * along[i];
        mass += mesh.mass[i];
    }
    for (double& value : along) value = (value - sum / mass) * (agreement < 0 ? -1 : 1);
    field.along = spline_of(grid, continued(mesh, along));
    field.low = 1e300;
    field.high = -1e300;
    for (std::size_t i = 0; i < along.size(); ++i) {
        if (!(distances[mesh.node[i]] > 0)) continue;
        field.low = std::min(field.low, along[i]);
        field.high = std::max(field.high, along[i]);
    }
    for (const Edge& edge : border.edges()) {
        for (const double part : {0.0, 0.25, 0.5, 0.75}) {
            const double value = field.along.at(edge.from + part * (edge.to - edge.from));
            field.low = std::min(field.low, value);
            field.high = std::max(field.high, value);
        }
    }
    return field;
}

}  // namespace filigree
