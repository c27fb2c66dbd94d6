// radial: cut shapes into sectors and rings around a centre, straight or swirling, with the hub left whole.
//
// gTangle's regular split of a circle (section 4.2) with angles instead of distances: rosettes, wheels, fans and
// swirls. Everything is cut in one go, so that sectors, rings and the hub share all of their vertices.
#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/elementary.h"
#include "engines/tangle/operators/operators.h"
#include "engines/tangle/orientation.h"
#include "engines/tangle/split_family.h"

namespace filigree::tangle {
namespace {

enum Port { sectors_port, hub_port };

constexpr double sliver = 0.25;         // of a ring's width: a thinner last ring joins its neighbour
constexpr std::int32_t hub_ring = -1;   // rings outside of it count from 0
constexpr double inside_the_hub = 0.9;  // where rays start: what of them lies in the hub is a loose end

struct Wheel {
    double count = 0, rings = 0, ring_width = 0, twist = 0, hub = 0;
};

std::vector<double> ring_radii(const Wheel& wheel, double reach) {
    std::vector<double> radii;
    if (wheel.hub > 0) radii.push_back(wheel.hub);
    const bool by_width = wheel.ring_width > 0;
    const double width = by_width ? wheel.ring_width : (reach - wheel.hub) / wheel.rings;
    const double most = by_width ? std::ceil((reach - wheel.hub) / width) : wheel.rings;
    for (double ring = 1; ring < most; ++ring) {
        const double radius = wheel.hub + ring * width;
        if (by_width && radius > reach - sliver * width) break;
        radii.push_back(radius);
    }
    return radii;
}

Result<OperatorOutput> run(const OperatorInput& input) {
    const Arguments& arguments = input.arguments;
    std::atomic<bool> too_many = false;
    Result<OperatorOutput> output = for_each_shape(input, [&](std::size_t index, const Shape& shape,
                                                              PolygonView polygon, Batch& batch) {
        if (too_many.load(std::memory_order_relaxed)) return;
        const Wheel wheel{arguments.number("count", index), arguments.number("rings", index),
                          arguments.number("ring_width", index), arguments.number("twist", index),
                          arguments.number("hub", index)};
        const Vec centre = centre_of(arguments.value("centre", index), centroid(polygon));
        const LevelRange range = distance_range(polygon, centre);
        const double breadth = std::max(range.high - wheel.hub, 0.0);
        const double rings = wheel.ring_width > 0 ? breadth / wheel.ring_width : wheel.rings;
        // Where the centre lies inside, an eighth of all fields at least is met.
        const bool is_around = range.low == 0;
        if (rings > 1e6 || (is_around && wheel.count * rings / 8 > static_cast<double>(input.element_budget))) {
            too_many = true;
            return;
        }
        const Vec first = direction_of(arguments.value("angle", index), shape, polygon);
        const double first_degrees = elementary::atan2(first.y, first.x) * 180 / elementary::pi;
        const double curl = breadth > 0 ? wheel.twist / breadth : 0;
        Circles circles{.centre = centre,
                        .radii = breadth > 0 ? ring_radii(wheel, range.high) : std::vector<double>{wheel.hub},
                        .first_ring = wheel.hub > 0 ? hub_ring : 0,
                        .tolerance = input.resolution};
        Rays rays{.centre = centre, .curl = curl, .from = inside_the_hub * wheel.hub, .tolerance = input.resolution};
        for (double i = 0; i < wheel.count; ++i) {
            rays.degrees.push_back(first_degrees - curl * wheel.hub + 360 * (i / wheel.count));
        }
        const CurveFamily across = std::move(circles);
        const FamilyCut fields = cut_by_families(polygon, std::move(rays), &across);
        if (fields.too_large) too_many = true;
        std::uint64_t piece = 0;  // of one sector in one ring, or of the hub
        std::uint64_t hub_piece = 0;
        for (std::size_t i = 0; i < fields.pieces.size(); ++i) {
            const std::int32_t sector = fields.columns[i], ring = fields.rows[i];
            const bool goes_on = i > 0 && fields.columns[i - 1] == sector && fields.rows[i - 1] == ring;
            piece = goes_on ? piece + 1 : 0;
            const bool is_hub = ring == hub_ring;
            const std::uint64_t local = is_hub ? fold(hub_port, hub_piece++)
                                               : fold(fold(fold(sectors_port, static_cast<std::uint32_t>(sector)),
                                                           static_cast<std::uint32_t>(ring)),
                                                      piece);
            Shape made = piece_of(shape, input.step, local, batch.geometry.size());
            made.column = is_hub ? 0 : sector;
            made.row = is_hub ? 0 : ring;
            const Vec out = centroid(fields.pieces[i]) - centre;
            if (!is_hub && wheel.count > 1 && length(out) > 0) made.direction = out * (1 / length(out));
            batch.ports[is_hub ? hub_port : sectors_port].push_back(made);
            batch.geometry.add(fields.pieces[i]);
        }
    });
    if (too_many) return too_many_shapes(input);
    return output;
}

}  // namespace

Operator radial_operator() {
    return {{.name = "radial",
             .aliases = {"rosette"},
             .help = "cut into sectors and rings around a centre, straight or swirling, with the hub left whole",
             .source = "gTangle, section 4.2, along circles and rays",
             .parameters = {{.name = "count",
                             .type = ParameterType::whole,
                             .help = "how many sectors go once around",
                             .default_text = "12",
                             .low = 1,
                             .high = 10000},
                            {.name = "rings",
                             .type = ParameterType::whole,
                             .help = "how many rings lie between the hub and the farthest point of the border",
                             .default_text = "1",
                             .low = 1,
                             .high = 10000},
                            {.name = "hub",
                             .type = ParameterType::length,
                             .help = "radius of the hub, which is left whole; 0 for none",
                             .default_text = "0",
                             .low = 0,
                             .high = 1e6},
                            {.name = "twist",
                             .type = ParameterType::angle,
                             .help = "how far the rays turn on their way out, in degrees from x towards y",
                             .default_text = "0",
                             .low = -36000,
                             .high = 36000},
                            {.name = "ring_width",
                             .type = ParameterType::length,
                             .help = "width of a ring, instead of a number of rings; 0 to go by their number",
                             .default_text = "0",
                             .low = 0,
                             .high = 1e6},
                            {.name = "angle",
                             .type = ParameterType::direction,
                             .help = "direction of the first ray, in degrees from x towards y, or relative to the "
                                     "shape's own",
                             .default_text = "keep",
                             .words = {"keep", "across", "axis"},
                             .calls = {"turn", "towards"}},
                            centre_parameter()},
             .ports = {{"sectors", "the sectors, ring by ring where there are several"},
                       {"hub", "what lies within the hub's radius"}},
             .example = "radial(16, rings: 3, hub: 10, twist: 40) : medallion -> petals, eye"},
            run};
}

}  // namespace filigree::tangle
