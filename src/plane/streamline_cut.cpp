#include "plane/streamline_cut.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/random.h"
#include "plane/boundary_field.h"
#include "plane/curve_cut.h"
#include "plane/distance_field.h"
#include "plane/streamline_levels.h"
#include "plane/streamlines.h"
#include "plane/strip_field.h"

namespace filigree {
namespace {

constexpr double least_contact = 0.2;  // of an offset: pieces that share less of their borders are no neighbours

// The strip of a piece, from the values at its corners; a piece that reaches only one level asks what is beside it.
std::int32_t strip_of(PolygonView piece, Point origin, const StreamlineLevels& levels, double offset) {
    double low = 1e300, high = -1e300;
    constexpr std::size_t enough = 40;  // corners of a ring; a piece has few rings and sides
    for (std::size_t r = 0; r < piece.ring_count(); ++r) {
        const RingView ring = piece.ring(r);
        for (std::size_t i = 0; i < ring.size(); i += 1 + ring.size() / enough) {
            const double value = levels.value(to_px(ring[i], origin));
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    double middle = (low + high) / 2;
    if (high - low < 0.25 * offset) {
        const RingView ring = piece.outer();
        constexpr std::size_t places = 8;
        double sum = 0;
        for (std::size_t k = 0; k < places; ++k) {
            const std::size_t i = k * ring.size() / places;
            const Vec a = to_px(ring[i], origin), b = to_px(ring[(i + 1) % ring.size()], origin);
            const double side = length(b - a);
            if (side > 0) sum += levels.value(0.5 * (a + b) + (0.1 * offset / side) * perpendicular(b - a)) - middle;
        }
        middle += sum / places;
    }
    const auto below = std::upper_bound(levels.levels.begin(), levels.levels.end(), middle) - levels.levels.begin();
    return levels.first_strip + static_cast<std::int32_t>(below);
}

// Two pieces that share a part of their borders, once each way.
struct Contact {
    std::uint32_t from = 0, to = 0;
    double shared = 0;  // px

    auto operator<=>(const Contact&) const = default;
};
// All that share at least so much, by their first piece, then their second.
std::vector<Contact> contacts_of(const Polygons& pieces, double least) {
    struct Side {
        Point low, high;
        std::uint32_t piece = 0;
        auto operator<=>(const Side&) const = default;
    };
    std::vector<Side> sides;
    sides.reserve(pieces.points.size());
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t r = 0; r < pieces[i].ring_count(); ++r) {
            const RingView ring = pieces[i].ring(r);
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const auto [low, high] = std::minmax(ring[k], ring[(k + 1) % ring.size()]);
                sides.push_back({low, high, i});
            }
        }
    }
    std::sort(sides.begin(), sides.end());
    std::vector<Contact> contacts;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const Side &a = sides[i], &b = sides[i + 1];
        if (!(a.low == b.low) || !(a.high == b.high) || a.piece == b.piece) continue;
        const double shared = length(to_px(Point{a.high.x - a.low.x, a.high.y - a.low.y}));
        contacts.push_back({a.piece, b.piece, shared});
        contacts.push_back({b.piece, a.piece, shared});
    }
    std::sort(contacts.begin(), contacts.end());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (kept > 0 && contacts[kept - 1].from == contacts[i].from && contacts[kept - 1].to == contacts[i].to) {
            contacts[kept - 1].shared += contacts[i].shared;
        } else {
            contacts[kept++] = contacts[i];
        }
    }
    contacts.resize(kept);
    std::erase_if(contacts, [&](const Contact& contact) { return contact.shared < least; });
    return contacts;
}

// How many steps each piece is away from the first of those that it can be reached from; going from one to
// another counts as a step or not.
template <class IsStep>
std::vector<std::int32_t> steps_away(std::size_t count, const std::vector<Contact>& contacts, const IsStep& is_step) {
    std::vector<std::int32_t> steps(count, -1);
    std::vector<std::size_t> begin(count + 1, 0);
    for (const Contact& contact : contacts) ++begin[contact.from + 1];
    for (std::size_t i = 0; i < count; ++i) begin[i + 1] += begin[i];
    std::vector<std::uint32_t> now, next;
    for (std::uint32_t first = 0; first < count; ++first) {
        if (steps[first] >= 0) continue;
        next.assign(1, first);
        for (std::int32_t away = 0; !next.empty(); ++away) {
            now.swap(next);
            next.clear();
            for (std::size_t done = 0; done < now.size(); ++done) {
                const std::uint32_t from = now[done];
                if (steps[from] >= 0) continue;
                steps[from] = away;
                for (std::size_t i = begin[from]; i < begin[from + 1]; ++i) {
                    const std::uint32_t to = contacts[i].to;
                    if (steps[to] < 0) (is_step(from, to) ? next : now).push_back(to);
                }
            }
        }
    }
    return steps;
}

// A number for where a piece lies: the square of the plane, one offset wide, that holds the middle of its box.
std::uint64_t place_key(PolygonView piece, double offset) {
    const Box box = bounds(piece);
    const Vec middle = 0.5 * (to_px(box.min) + to_px(box.max));
    const auto cell = [&](double x) { return static_cast<std::uint64_t>(std::llround(x / offset)); };
    return fold(cell(middle.x), cell(middle.y));
}

// Makes keys that occur several times differ: the k-th becomes that of the k-th piece.
void tell_apart(std::vector<StreamlineCut::Place>& places) {
    std::vector<std::uint32_t> order(places.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return places[a].key != places[b].key ? places[a].key < places[b].key : a < b;
    });
    std::uint64_t last = 0, piece = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        StreamlineCut::Place& place = places[order[i]];
        piece = i > 0 && place.key == last ? piece + 1 : 0;
        last = place.key;
        place.key = fold(place.key, piece);
    }
}

// Vectors at the border for the field of a kind.
std::vector<Vec> border_vectors(const BorderSamples& samples, const EdgeTree& border, Vec size, double inside,
                                Vec centre, StreamlineKind kind, double offset) {
    if (kind == StreamlineKind::smooth) return samples.tangents;
    std::vector<Vec> vectors;
    vectors.reserve(samples.points.size());
    const auto add_unit = [&](Vec v) {
        const double norm = length(v);
        vectors.push_back(norm > 0 ? (1 / norm) * v : Vec{});
    };
    if (kind == StreamlineKind::circular) {
        for (const Vec p : samples.points) add_unit(perpendicular(centre - p));
        return vectors;
    }
    // Inwards where lines enter and outwards where they leave: which is which, the shape's own length tells.
    const StripField strips = strip_field(border, size, inside, offset / 3);
    for (const Vec p : samples.points) add_unit(perpendicular(strips.along.jet(p).gradient));
    return vectors;
}

}  // namespace

StreamlineCut cut_by_streamlines(PolygonView shape, const StreamlineCutOptions& options) {
    StreamlineCut result;
    const Box box = bounds(shape);
    const Point origin{box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
    const Vec size = to_px(box.max, box.min), centre = options.centre - to_px(origin);
    const EdgeTree border(edges_of(shape, origin));
    const double offset = std::accumulate(options.offsets.begin(), options.offsets.end(), 0.0) /
                          static_cast<double>(options.offsets.size());
    constexpr double most_cells = 4e6;
    constexpr double finest_field = 96;  // steps of the field across the shape
    if (options.by_field || options.dual) {
        const double cells = size.x * size.y / (offset * offset);
        result.is_too_fine =
            !(cells < most_cells && area(shape) / (offset * offset) < 4 * static_cast<double>(options.limit) + 100);
    }
    // Level lines may be few and yet as long as that.
    constexpr double longest_lines = 3e8;  // offsets
    result.is_too_fine = result.is_too_fine || !(area(shape) / (offset * offset) < longest_lines);
    if (result.is_too_fine) return result;

    StreamlineLevels levels;
    std::vector<Polyline> lines;
    std::function<Vec(Vec)> across;
    GridField distances;
    BorderSamples samples;
    if (options.by_field || options.dual) {
        const Grid grid = grid_over(size, std::min(offset, std::max(size.x, size.y) / 8), 4);
        const std::vector<double> at_nodes = signed_distances(border, grid);
        distances = spline_of(grid, at_nodes);
        samples = sampled_border(shape, origin, offset);
        if (options.by_field) {
            // The field is as smooth as the shape is wide, so fine lines in a wide shape need no finer grid for it.
            const double step = std::max(offset, std::max(size.x, size.y) / finest_field);
            const Grid coarse = step > offset ? grid_over(size, step, 4) : grid;
            const std::vector<double> at_coarse = step > offset ? signed_distances(border, coarse) : at_nodes;
            const BorderSamples around = step > offset ? sampled_border(shape, origin, step) : samples;
            const std::vector<Vec> vectors =
                border_vectors(around, border, size, area(shape), centre, options.kind, step);
            // Vectors that turn round a centre have a sign; along a border, and across, it only cancels.
            std::function<Vec(Vec)> direction;
            if (options.kind == StreamlineKind::circular) {
                direction = [field = boundary_field(around, vectors, coarse, at_coarse)](Vec p) { return field.at(p); };
            } else {
                direction = [field = direction_field(around, vectors, coarse, at_coarse)](Vec p) {
                    return field.at(p);
                };
            }
            StreamlineOptions even;
            even.separation = offset;
            even.tolerance = 0.25 * options.tolerance;
            even.follows_border = options.kind == StreamlineKind::smooth;
            std::vector<Vec> seeds;
            for (std::size_t i = 0; i < samples.points.size() && even.follows_border; ++i) {
                seeds.push_back(samples.points[i] + offset * perpendicular(samples.tangents[i]));
            }
            lines = streamlines(direction, distances, seeds, even);
            across = [direction](Vec p) { return perpendicular(direction(p)); };
        }
    }
    if (!options.by_field) {
        levels = streamline_levels(shape, origin, border, options);
        if (levels.is_too_fine) {
            result.is_too_fine = true;
            return result;
        }
        lines = std::move(levels.lines);
        across = levels.gradient;
        if (options.kind == StreamlineKind::circular) {
            // Rays end before they meet.
            across = [centre, hub = 0.6 * offset](Vec p) { return length(p - centre) < hub ? Vec{} : p - centre; };
        }
    }
    if (options.dual) {
        StreamlineOptions even;
        even.separation = offset;
        even.tolerance = 0.25 * options.tolerance;
        even.merges = false;
        even.climbs = !options.by_field && options.kind != StreamlineKind::circular;
        even.follows_border = options.kind == StreamlineKind::strip;
        std::vector<Vec> seeds;
        for (std::size_t i = 0; i < samples.points.size(); ++i) {
            seeds.push_back(samples.points[i] + (0.5 * offset) * perpendicular(samples.tangents[i]));
        }
        if (options.kind != StreamlineKind::smooth) seeds.clear();
        for (Polyline& line : streamlines(across, distances, seeds, even)) lines.push_back(std::move(line));
    }
    for (Polyline& line : lines) {
        for (Vec& p : line.points) p = p + to_px(origin);
    }
    result.pieces = cut_by_curves(shape, lines);
    const auto count = static_cast<std::uint32_t>(result.pieces.size());
    if (count > options.limit) {
        result.is_too_fine = true;
        result.pieces = {};
        return result;
    }

    result.places.resize(count);
    for (std::uint32_t i = 0; i < count && !options.by_field; ++i) {
        result.places[i].column = strip_of(result.pieces[i], origin, levels, offset);
        result.places[i].key = static_cast<std::uint32_t>(result.places[i].column);
    }
    if (options.by_field || options.dual) {
        const std::vector<Contact> contacts = contacts_of(result.pieces, least_contact * offset);
        const std::vector<std::int32_t> away = steps_away(count, contacts, [&](std::uint32_t a, std::uint32_t b) {
            return options.by_field || result.places[a].column == result.places[b].column;
        });
        for (std::uint32_t i = 0; i < count; ++i) {
            (options.by_field ? result.places[i].column : result.places[i].row) = away[i];
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint64_t strip = options.by_field ? 0 : result.places[i].key;
            result.places[i].key = fold(strip, place_key(result.pieces[i], offset));
        }
    }
    tell_apart(result.places);
    return result;
}

}  // namespace filigree
