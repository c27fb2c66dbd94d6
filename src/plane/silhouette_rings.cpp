#include "plane/silhouette_rings.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace filigree {
namespace {

constexpr std::size_t border = 2;  // white pixels around the picture, so that the blur fades out

// The picture with its border, blurred by (1 6 1) / 8 both ways: enough to bend stairs, and a line of one pixel still
// reaches three quarters of its darkness.
class Blurred {
public:
    explicit Blurred(const GreyImage& image)
        : width(image.width + 2 * border), height(image.height + 2 * border), values_(width * height) {
        for (std::size_t y = 0; y < image.height; ++y) {
            const float* const from = image.darkness.data() + y * image.width;
            float* const to = values_.data() + (y + border) * width + border;
            for (std::size_t x = 0; x < image.width; ++x) to[x] = from[x];
        }
        std::vector<float> before(width), here(width);
        for (std::size_t y = 0; y < height; ++y) {  // in place: the row before is kept as it was
            float* const row = values_.data() + y * width;
            for (std::size_t x = 0; x < width; ++x) here[x] = row[x];
            for (std::size_t x = 0; x < width; ++x) {
                const float below = y + 1 < height ? row[x + width] : 0;
                row[x] = (before[x] + 6 * here[x] + below) * 0.125F;
            }
            before.swap(here);
            float left = 0;
            for (std::size_t x = 0; x < width; ++x) {
                const float centre = row[x], right = x + 1 < width ? row[x + 1] : 0;
                row[x] = (left + 6 * centre + right) * 0.125F;
                left = centre;
            }
        }
    }

    double at(std::size_t x, std::size_t y) const { return static_cast<double>(values_[y * width + x]); }

    const std::size_t width, height;

private:
    std::vector<float> values_;
};

// Corners and sides of a cell (x, y) are numbered clockwise from the top left and the top; side s joins the
// corners s and s + 1. Rings walk with the dark on their right.
struct Node {
    std::size_t x = 0, y = 0;
};
Node corner(Node cell, unsigned c) { return {cell.x + (c == 1 || c == 2), cell.y + (c >= 2)}; }

class Tracer {
public:
    Tracer(const Blurred& values, double threshold)
        : values_(values), threshold_(threshold), is_walked_(values.width * values.height) {}

    std::vector<std::vector<Vec>> trace() && {
        std::vector<std::vector<Vec>> rings;
        for (std::size_t y = 0; y + 1 < values_.height; ++y) {
            for (std::size_t x = 0; x + 1 < values_.width; ++x) {
                // Every ring goes down somewhere, from dark on the left to light on the right.
                if (is_dark({x, y}) && !is_dark({x + 1, y}) && !is_walked_[y * values_.width + x]) {
                    rings.push_back(walk({x, y}));
                }
            }
        }
        return rings;
    }

private:
    double at(Node n) const { return values_.at(n.x, n.y); }
    bool is_dark(Node n) const { return at(n) >= threshold_; }

    std::vector<Vec> walk(Node start) {
        std::vector<Vec> ring;
        Node cell = start;
        unsigned side = 0;  // through which the cell is entered
        do {
            if (side == 0) is_walked_[cell.y * values_.width + cell.x] = true;
            const Vec p = crossing(corner(cell, side), corner(cell, (side + 1) % 4));
            if (ring.empty() || !(ring.back() == p)) ring.push_back(p);
            const unsigned exit = way_out(cell, side);
            cell = beyond(cell, exit);
            side = (exit + 2) % 4;
        } while (!(side == 0 && cell.x == start.x && cell.y == start.y));
        while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
        return ring;
    }

    unsigned way_out(Node cell, unsigned side) const {
        const bool is_near_dark = is_dark(corner(cell, (side + 3) % 4)),
                   is_far_dark = is_dark(corner(cell, (side + 2) % 4));
        if (is_near_dark) return (side + (is_far_dark ? 1 : 2)) % 4;
        if (!is_far_dark) return (side + 3) % 4;
        double sum = 0;
        for (unsigned c = 0; c < 4; ++c) sum += at(corner(cell, c));
        return (side + (sum / 4 >= threshold_ ? 1 : 3)) % 4;
    }

    static Node beyond(Node cell, unsigned side) {
        static constexpr std::array<int, 4> dx = {0, 1, 0, -1}, dy = {-1, 0, 1, 0};
        return {cell.x + static_cast<std::size_t>(dx[side]), cell.y + static_cast<std::size_t>(dy[side])};
    }

    // In px of the picture: a node stands for the middle of its pixel.
    Vec crossing(Node dark, Node light) const {
        const double inside = at(dark), outside = at(light);
        const double part = (inside - threshold_) / (inside - outside);
        const auto place = [&](std::size_t from, std::size_t to) {
            return static_cast<double>(from) + part * (static_cast<double>(to) - static_cast<double>(from)) + 0.5 -
                   static_cast<double>(border);
        };
        return {place(dark.x, light.x), place(dark.y, light.y)};
    }

    const Blurred& values_;
    const double threshold_;
    std::vector<bool> is_walked_;
};

}  // namespace

std::vector<std::vector<Vec>> dark_rings(const GreyImage& image, double threshold) {
    const Blurred blurred(image);
    return Tracer(blurred, threshold).trace();
}

double ring_area(std::span<const Vec> ring) {
    double doubled = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        doubled += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
    }
    return doubled / 2;
}

}  // namespace filigree
