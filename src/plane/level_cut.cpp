#include "plane/level_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plane/level_faces.h"

namespace filigree {
namespace {

// Whether a ring that starts at its least point has a positive area. The turn at that point tells a
// simple ring's direction; small ones, where rounding may count, are computed.
bool is_positive(RingView ring, bool may_flip) {
    if (ring.size() < 3) return false;
    if (ring.size() > 16 && !may_flip && orientation(ring.back(), ring[0], ring[1]) > 0) return true;
    double sum = 0, size = 0;  // the doubled area from the first point, and a bound on what it is made of
    double x = static_cast<double>(ring[1].x - ring[0].x), y = static_cast<double>(ring[1].y - ring[0].y);
    for (std::size_t i = 2; i < ring.size(); ++i) {
        const double next_x = static_cast<double>(ring[i].x - ring[0].x);
        const double next_y = static_cast<double>(ring[i].y - ring[0].y);
        const double a = x * next_y, b = next_x * y;
        sum += a - b;
        size += std::fabs(a) + std::fabs(b);
        x = next_x;
        y = next_y;
    }
    const double error = size * 0x1p-52 * static_cast<double>(ring.size() + 8);
    if (sum > error) return true;
    if (sum < -error) return false;
    return doubled_area(ring) > 0;
}

LevelCut write(const LevelFaces& parts, const LevelField& field, std::int64_t first_strip) {
    const std::vector<LevelFace>& faces = parts.faces();
    const std::vector<LevelHole>& holes = parts.holes();
    LevelCut result;
    result.pieces.points.reserve(parts.point_count());
    result.pieces.ring_ends.reserve(faces.size() + holes.size());
    result.pieces.polygon_ends.reserve(faces.size());
    result.strips.reserve(faces.size());
    std::vector<std::vector<std::uint32_t>> holes_of;
    if (!holes.empty()) {
        holes_of.resize(faces.size());
        for (std::uint32_t h = 0; h < holes.size(); ++h) {
            if (holes[h].face != LevelHole::no_face) holes_of[holes[h].face].push_back(h);
        }
    }
    std::vector<Point>& points = result.pieces.points;
    for (const std::uint32_t f : parts.order()) {
        const std::size_t begin = points.size();
        parts.append(points, faces[f].ring);
        if (!is_positive({points.data() + begin, points.data() + points.size()}, field.may_flip)) {
            points.resize(begin);
            continue;
        }
        result.pieces.end_ring();
        if (!holes_of.empty()) {
            for (const std::uint32_t h : holes_of[f]) {
                parts.append(points, holes[h].ring);
                result.pieces.end_ring();
            }
        }
        result.pieces.end_polygon();
        result.strips.push_back(
            static_cast<std::int32_t>(first_strip + field.strip_numbers[static_cast<std::size_t>(faces[f].strip)]));
    }
    return result;
}

// All that a cut works with, kept for the next one: most shapes are small, and their cuts then allocate
// nothing but the result.
struct Workshop {
    LevelField field;
    LevelWalker walker;
    LevelLinker linker;
    LevelFaces faces;
};
constexpr std::size_t greatest_kept_size = std::size_t{1} << 18;  // points, all told: some 20 MB

Workshop& workshop() {
    thread_local Workshop instance;
    return instance;
}

}  // namespace

LevelCut cut(PolygonView shape, const LevelFamily& family) {
    if (shape.point_count() == 0) return {};
    auto& [field, walker, linker, faces] = workshop();
    const bool sound = field.aim(family.frame, family.profile);
    const LevelExtent extent = walker.read(shape, field);
    if (!sound || !field.cover(family.profile, extent.u_low, extent.u_high) ||
        !field.choose_levels(family.levels, extent.v_low, extent.v_high)) {
        field.cut_nothing();
    }
    LevelTrail* trail = &walker.walk(field);
    const LevelLinks* links = &linker.link(*trail, field);
    if (links->too_large) {
        field.cut_nothing();
        trail = &walker.walk(field);
        links = &linker.link(*trail, field);
    }
    faces.assemble(*trail, *links, field);
    LevelCut result = write(faces, field, family.first_strip);
    const std::size_t size = shape.point_count() + trail->points.size() + field.nodes.size() + links->points.size();
    if (size > greatest_kept_size) workshop() = {};
    return result;
}

LevelRange level_range(PolygonView shape, const Frame& frame, const Profile& profile) {
    if (shape.point_count() == 0) return {};
    auto& [field, walker, linker, faces] = workshop();
    if (!field.aim(frame, profile)) return {};
    const LevelExtent extent = walker.read(shape, field);
    if (profile.samples.empty()) return {extent.v_low, extent.v_high};
    if (!field.cover(profile, extent.u_low, extent.u_high)) {
        // Too many breakpoints to look at, or values that are none.
        const auto [low, high] = std::minmax_element(profile.samples.begin(), profile.samples.end());
        const LevelRange wide{extent.v_low - *high, extent.v_high - *low};
        return std::isfinite(wide.low) && std::isfinite(wide.high) ? wide : LevelRange{};
    }
    LevelRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    const auto include = [&](double phi) {
        range.low = std::min(range.low, phi);
        range.high = std::max(range.high, phi);
    };
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        const RingView ring = shape.ring(r);
        if (ring.empty()) continue;
        Vec a = field.coordinates(ring.back());
        for (const Point p : ring) {
            const Vec b = field.coordinates(p);
            include(b.y - field.profile(b.x));
            const NodeRange nodes = nodes_between(field, std::min(a.x, b.x), std::max(a.x, b.x));
            for (std::size_t i = nodes.begin; i < nodes.end; ++i) {
                const FieldNode& node = field.nodes[i];
                include(a.y + (node.u - a.x) / (b.x - a.x) * (b.y - a.y) - node.value);
            }
            a = b;
        }
    }
    return range;
}

}  // namespace filigree
