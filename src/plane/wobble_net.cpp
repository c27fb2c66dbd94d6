#include "plane/wobble_net.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace filigree {
namespace {

constexpr double samples_per_wave = 10;
constexpr double shortest_step = 0.5;            // px
constexpr double most_samples = 4096;            // on one edge
constexpr double steepest_amplitude = 1.0 / 20;  // of the wavelength: noise does not fold the plane over
constexpr double soft_reach = 2;                 // how far from a corner its softening begins, in amplitudes
constexpr double soft_pull = 0.5;                // of the way to the middle between the two places where it begins
constexpr double least_turn_cos = 0.9063;        // 25 degrees: less is no corner but a curve
constexpr double most_turn_cos = -0.8660;        // 150 degrees: tips stay sharp
constexpr double shortest_edge = 0x1p-10;        // px; shorter ones get no vertices

constexpr double unknown = std::numeric_limits<double>::infinity();

class NetBuilder {
public:
    NetBuilder(BorderMap map, std::span<const Wobble> wobbles, std::size_t faces) {
        net_.map = std::move(map);
        const std::size_t edges = net_.map.edges.size();
        amplitudes_.assign(edges, unknown);
        net_.wavelengths.assign(edges, 0);
        net_.is_outline.assign(edges, 0);
        for (std::size_t i = 0; i < faces; ++i) add_face(i, wobbles[i]);
        add_borders(wobbles, faces);
    }

    WobbleNet build(Detail detail) && {
        settle_vertices();
        if (detail == Detail::more) find_corners();
        add_inner(detail);
        return std::move(net_);
    }

private:
    template <class Visit>
    void for_each_edge(std::size_t polygon, Visit visit) const {
        for (const std::uint32_t side : net_.map.sides_of(polygon)) {
            if (side != BorderMap::none) visit(BorderMap::edge_of(side));
        }
    }

    void meet(std::uint32_t edge, double amplitude, double wavelength) {
        amplitudes_[edge] = std::min(amplitudes_[edge], amplitude);
        if (amplitude > 0) net_.wavelengths[edge] = std::max(net_.wavelengths[edge], wavelength);
    }

    void add_face(std::size_t polygon, const Wobble& wobble) {
        const double amplitude = amplitude_of(wobble), wavelength = wavelength_of(wobble);
        const bool decides = wobble.amplitude != unknown;
        for_each_edge(polygon, [&](std::uint32_t edge) {
            net_.is_outline[edge] ^= 1;
            if (decides) meet(edge, amplitude, wavelength);
        });
    }

    // Borders decide where no face does.
    void add_borders(std::span<const Wobble> wobbles, std::size_t faces) {
        std::vector<std::uint8_t> is_decided;
        if (faces < wobbles.size()) {
            is_decided.resize(amplitudes_.size());
            for (std::size_t e = 0; e < amplitudes_.size(); ++e) is_decided[e] = amplitudes_[e] != unknown ? 1 : 0;
        }
        for (std::size_t i = faces; i < wobbles.size(); ++i) {
            const double amplitude = amplitude_of(wobbles[i]), wavelength = wavelength_of(wobbles[i]);
            for_each_edge(i, [&](std::uint32_t edge) {
                if (is_decided[edge] == 0) meet(edge, amplitude, wavelength);
            });
        }
        for (double& amplitude : amplitudes_) amplitude = amplitude == unknown ? 0 : amplitude;
    }

    void settle_vertices() {
        net_.places = net_.map.vertices;
        net_.wishes.assign(net_.places.size(), unknown);
        net_.waves.assign(net_.places.size(), 0);
        for (std::size_t e = 0; e < amplitudes_.size(); ++e) {
            for (const std::uint32_t v : {net_.map.edges[e].low, net_.map.edges[e].high}) {
                net_.wishes[v] = std::min(net_.wishes[v], amplitudes_[e]);
                net_.waves[v] = std::max(net_.waves[v], net_.wavelengths[e]);
            }
        }
    }

    // Where two edges meet alone and turn.
    void find_corners() {
        net_.pulls.assign(net_.places.size(), {});
        softened_.assign(net_.places.size(), 0);
        std::vector<std::uint32_t> degrees(net_.places.size(), 0), first(net_.places.size()), last(net_.places.size());
        for (std::uint32_t e = 0; e < net_.map.edges.size(); ++e) {
            for (const std::uint32_t v : {net_.map.edges[e].low, net_.map.edges[e].high}) {
                if (degrees[v]++ == 0) first[v] = e;
                last[v] = e;
            }
        }
        for (std::uint32_t v = 0; v < degrees.size(); ++v) {
            if (degrees[v] != 2 || !(net_.wishes[v] > 0)) continue;
            const Vec a = away(first[v], v), b = away(last[v], v);
            const double a_length = length(a), b_length = length(b);
            if (!(a_length > shortest_edge && b_length > shortest_edge)) continue;
            const double turn_cos = -dot(a, b) / (a_length * b_length);
            if (turn_cos > least_turn_cos || turn_cos < most_turn_cos) continue;
            softened_[v] = 1;
            const Vec from = a * (soft_length(first[v], a_length) / a_length),
                      to = b * (soft_length(last[v], b_length) / b_length);
            net_.pulls[v] = 0.5 * soft_pull * (from + to);
        }
    }

    Vec away(std::uint32_t edge, std::uint32_t from) const {
        const BorderMap::Edge& ends = net_.map.edges[edge];
        const Point a = net_.places[from], b = net_.places[ends.low == from ? ends.high : ends.low];
        return to_px(Point{b.x - a.x, b.y - a.y});
    }

    double soft_length(std::uint32_t edge, double edge_length) const {
        return std::min(soft_reach * amplitudes_[edge], edge_length / 3);
    }

    void add_inner(Detail detail) {
        net_.first_inner.reserve(net_.map.edges.size() + 1);
        for (std::uint32_t e = 0; e < net_.map.edges.size(); ++e) {
            net_.first_inner.push_back(static_cast<std::uint32_t>(net_.places.size()));
            if (detail == Detail::more && amplitudes_[e] > 0) add_samples(e);
        }
        net_.first_inner.push_back(static_cast<std::uint32_t>(net_.places.size()));
        net_.wishes.resize(net_.places.size());
        net_.waves.resize(net_.places.size());
        net_.pulls.resize(net_.places.size());
        for (std::uint32_t e = 0; e < net_.map.edges.size(); ++e) {
            for (std::uint32_t v = net_.first_inner[e]; v < net_.first_inner[e + 1]; ++v) {
                net_.wishes[v] = amplitudes_[e];
                net_.waves[v] = net_.wavelengths[e];
            }
        }
    }

    // Vertices lie where the edge crosses upright or level lines of one lattice, so that edges close together get
    // theirs side by side and bend alike.
    void add_samples(std::uint32_t e) {
        const BorderMap::Edge& edge = net_.map.edges[e];
        const Point low = net_.places[edge.low];
        const Vec along = away(e, edge.low);
        const double edge_length = length(along);
        if (!(edge_length > shortest_edge)) return;
        const bool by_x = std::fabs(along.x) >= std::fabs(along.y);
        const double run = by_x ? along.x : along.y, start = by_x ? to_px(low).x : to_px(low).y;
        double step = std::max(net_.wavelengths[e] / samples_per_wave, shortest_step);
        while (std::fabs(run) > most_samples * step) step *= 2;

        const double soft = soft_length(e, edge_length) / edge_length, aside = step / 16 / edge_length;
        const double first_soft = softened_[edge.low] != 0 ? soft : 0,
                     last_soft = softened_[edge.high] != 0 ? 1 - soft : 1;
        const auto add = [&](double at) {
            const Vec off = at * along;
            const Point p = snap(off);
            net_.places.push_back({low.x + p.x, low.y + p.y});
        };
        if (first_soft > 0) add(first_soft);
        const double from = std::ceil(std::min(start, start + run) / step),
                     to = std::floor(std::max(start, start + run) / step);
        const auto lines = static_cast<std::int64_t>(to - from) + 1;
        for (std::int64_t i = 0; i < lines; ++i) {
            const double line = run > 0 ? from + static_cast<double>(i) : to - static_cast<double>(i);
            const double at = (line * step - start) / run;
            if (at > first_soft + aside && at < last_soft - aside) add(at);
        }
        if (last_soft < 1) add(last_soft);
    }

    WobbleNet net_;
    std::vector<double> amplitudes_;      // of edges
    std::vector<std::uint8_t> softened_;  // of the map's vertices
};

}  // namespace

double wavelength_of(const Wobble& wobble) {
    return std::isfinite(wobble.wavelength) ? std::max(wobble.wavelength, shortest_wave) : shortest_wave;
}
double amplitude_of(const Wobble& wobble) {
    if (!(wobble.amplitude > 0)) return 0;
    return std::min(wobble.amplitude, steepest_amplitude * wavelength_of(wobble));
}

std::uint32_t WobbleNet::edge_of_inner(std::uint32_t vertex) const {
    const auto after = std::upper_bound(first_inner.begin(), first_inner.end(), vertex);
    return static_cast<std::uint32_t>(after - first_inner.begin()) - 1;
}

WobbleNet wobble_net(BorderMap map, std::span<const Wobble> wobbles, std::size_t faces, Detail detail) {
    return NetBuilder(std::move(map), wobbles, faces).build(detail);
}

}  // namespace filigree
