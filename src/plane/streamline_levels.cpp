#include "plane/streamline_levels.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "base/elementary.h"
#include "plane/distance_field.h"
#include "plane/outline_field.h"
#include "plane/strip_field.h"

namespace filigree {
namespace {

constexpr double sliver = 0.25;       // of an offset: the thinnest strip at an end
constexpr double thin_island = 0.35;  // of an offset: twice the area over the perimeter of the smallest island
constexpr double finer = 0.25;        // lines keep so much of the tolerance: they are drawn by what is cut, too
constexpr double most_nodes = 200'000;

// Where the lines lie: line n, of either sign, behind n offsets.
class Spacing {
public:
    explicit Spacing(const std::vector<double>& offsets)
        : offsets_(offsets), period_(std::accumulate(offsets.begin(), offsets.end(), 0.0)) {}

    double mean() const { return period_ / static_cast<double>(offsets_.size()); }
    double at(std::int64_t n) const {
        const auto size = static_cast<std::int64_t>(offsets_.size());
        std::int64_t cycle = n / size, rest = n % size;
        if (rest < 0) {
            rest += size;
            --cycle;
        }
        return static_cast<double>(cycle) * period_ + std::accumulate(offsets_.begin(), offsets_.begin() + rest, 0.0);
    }
    // Those strictly between low and high, both shifted by `anchor`; false if there are more than `limit`.
    bool fill(StreamlineLevels& result, double low, double high, double anchor, std::uint64_t limit) const {
        if (!((high - low) / mean() < static_cast<double>(std::min<std::uint64_t>(limit, 1'000'000)))) return false;
        auto n = static_cast<std::int64_t>(std::floor((low - anchor) / period_)) *
                 static_cast<std::int64_t>(offsets_.size());
        while (anchor + at(n) <= low) ++n;
        result.first_strip = static_cast<std::int32_t>(n - 1);
        for (; anchor + at(n) < high; ++n) result.levels.push_back(anchor + at(n));
        return true;
    }

private:
    const std::vector<double>& offsets_;
    double period_ = 1;
};

void take_field(StreamlineLevels& result, GridField field) {
    const auto shared = std::make_shared<const GridField>(std::move(field));
    result.value = [shared](Vec p) { return shared->at(p); };
    result.gradient = [shared](Vec p) { return shared->jet(p).gradient; };
}

bool is_thin(const Polyline& line, double least) {
    double doubled = 0, around = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const Vec a = line.points[i], b = line.points[(i + 1) % line.points.size()];
        doubled += cross(a, b);
        around += length(b - a);
    }
    return std::fabs(doubled) < least * around;
}

void outlines(StreamlineLevels& result, Vec size, const EdgeTree& border, const Spacing& spacing,
              const StreamlineCutOptions& options) {
    const double narrow = std::min(size.x, size.y), mean = spacing.mean();
    if (!spacing.fill(result, 0, std::max(narrow / 2, 1e-9), 0, options.limit)) {
        result.is_too_fine = true;
        return;
    }
    result.first_strip = 0;
    if (result.levels.empty()) {
        result.value = [](Vec) { return 0.0; };
        result.gradient = [](Vec) { return Vec{}; };
        return;
    }
    const double step = std::max(std::min(mean / 2, narrow / 8), std::sqrt(size.x * size.y / most_nodes));
    const Grid grid = grid_over(size, step, 3);
    const std::vector<double> distances = signed_distances(border, grid);
    GridField field = outline_field(grid, distances, options.smoothing * mean);
    const double highest = *std::max_element(field.coefficients.begin(), field.coefficients.end());
    while (!result.levels.empty() && result.levels.back() >= highest) result.levels.pop_back();
    for (Isoline& line : isolines(field, result.levels, finer * options.tolerance)) {
        const auto n = static_cast<std::int64_t>(line.level) + 1;
        if (line.line.closed && is_thin(line.line, thin_island * (spacing.at(n + 1) - spacing.at(n)))) continue;
        result.lines.push_back(std::move(line.line));
    }
    take_field(result, std::move(field));
}

void strips(StreamlineLevels& result, Vec size, double inside, const EdgeTree& border, const Spacing& spacing,
            const StreamlineCutOptions& options) {
    StripField field = strip_field(border, size, inside, spacing.mean() / 3);
    const double thin = sliver * *std::min_element(options.offsets.begin(), options.offsets.end());
    const double low = field.low + thin, high = field.high - thin;
    if (low < high && !spacing.fill(result, low, high, (field.low + field.high) / 2, options.limit)) {
        result.is_too_fine = true;
        return;
    }
    for (Isoline& line : isolines(field.along, result.levels, finer * options.tolerance)) {
        result.lines.push_back(std::move(line.line));
    }
    take_field(result, std::move(field.along));
}

// A circle, or the part of it that can meet a disc around (0, 0).
Polyline circle(Vec centre, double radius, double reach, double tolerance) {
    const double away = length(centre);
    const double flat = std::min(tolerance, radius / 16);
    const double chord = std::sqrt(8 * flat / radius);
    Polyline line;
    // The half angle of an arc: asin(x) is at most x pi / 2.
    const double half = away > 2 * reach ? elementary::pi / 2 * (1.01 * reach / away) : elementary::pi;
    line.closed = half == elementary::pi;
    const double count = std::clamp(std::ceil(2 * half / chord), 24.0, 100'000.0);
    const double towards = elementary::atan2(-centre.y, -centre.x);
    for (double i = 0; i < count + (line.closed ? 0 : 1); ++i) {
        const elementary::CosSin at = elementary::cos_sin(towards + half * (2 * i / count - 1));
        line.points.push_back(centre + radius * Vec{at.cos, at.sin});
    }
    return line;
}

void circles(StreamlineLevels& result, Vec size, Vec centre, const EdgeTree& border, const Spacing& spacing,
             const StreamlineCutOptions& options) {
    double nearest2 = 1e300, farthest = 0;
    for (const Edge& edge : border.edges()) {
        nearest2 = std::min(nearest2, squared_distance(edge, centre));
        farthest = std::max(farthest, length(edge.from - centre));
    }
    const bool is_around = border.is_inside(centre);
    const double thin = sliver * *std::min_element(options.offsets.begin(), options.offsets.end());
    const double low = is_around ? 0 : std::sqrt(nearest2) + thin, high = farthest - thin;
    result.value = [centre](Vec p) { return length(p - centre); };
    result.gradient = [centre](Vec p) { return p - centre; };
    if (low < high && !spacing.fill(result, low, high, 0, options.limit)) {
        result.is_too_fine = true;
        return;
    }
    for (const double radius : result.levels) {
        result.lines.push_back(circle(centre, radius, length(size) / 2, finer * options.tolerance));
    }
}

}  // namespace

StreamlineLevels streamline_levels(PolygonView shape, Point origin, const EdgeTree& border,
                                   const StreamlineCutOptions& options) {
    StreamlineLevels result;
    const Spacing spacing(options.offsets);
    const Box box = bounds(shape);
    const Vec size = to_px(box.max, box.min);
    switch (options.kind) {
        case StreamlineKind::smooth:
            outlines(result, size, border, spacing, options);
            break;
        case StreamlineKind::strip:
            strips(result, size, area(shape), border, spacing, options);
            break;
        case StreamlineKind::circular:
            circles(result, size, options.centre - to_px(origin), border, spacing, options);
            break;
    }
    return result;
}

}  // namespace filigree
