#include "plane/settle.h"

#include <algorithm>

#include "plane/near_points.h"

namespace filigree {

namespace {

constexpr int gentle_rounds = 8;
constexpr int most_rounds = 24;
constexpr double gentleness = 0.2;  // of what is missing, for each of two
constexpr double reach = 1.5;  // of the distances: how far away a point may be that comes into question
constexpr double longest_move = 0.2;  // of the distance, in one round
constexpr double steps_to_cell = 64;  // of the grid that points are moved on, so that ever smaller changes do not spread
constexpr double room_for_steps = 1.008;  // so much farther than asked points are pushed apart

class Settling {
public:
    Settling(std::span<Vec> points, const RegionRaster& raster, const EdgeTree& border, const SettleOptions& options)
        : points_(points),
          raster_(raster),
          border_(border),
          options_(options),
          step_(raster.cell() / steps_to_cell),
          enough_(std::max(options.clearance, raster.cell()) + 2 * step_),
          scale_(std::max(options.apart, 0.8 * options.even)),
          slack_(0.5 * scale_),
          near_(points, std::max(reach * options.apart, 1.1 * options.even)),
          inside_(points.size(), 1),
          was_moved_(points.size(), 1) {
        free_about_.reserve(points.size());
        for (const Vec p : points) {
            const bool is_free =
                raster.is_inside(raster.index_of(p)) && !border.is_any_nearer(p, enough_ + slack_);
            free_about_.push_back(is_free ? p : nowhere);
        }
    }

    std::vector<std::uint8_t> run() {
        const int gentle = options_.even > options_.apart ? gentle_rounds : 0;
        for (int round = 0; round < gentle; ++round) move_all(options_.even, gentleness);
        for (int round = 0; round < most_rounds; ++round) {
            if (!move_all(options_.apart * room_for_steps, 0.5)) break;
        }
        return apart_ones();
    }

private:
    static constexpr Vec nowhere{1e300, 1e300};

    bool move_all(double distance, double part) {
        moves_.resize(points_.size());
        bool any_moved = false;
        for (std::size_t i = 0; i < points_.size(); ++i) moves_[i] = push(i, distance, part);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const Vec before = points_[i];
            const bool is_pushed = !(moves_[i] == Vec{});
            if (!is_pushed && !was_moved_[i]) continue;
            if (is_pushed) points_[i] = on_grid(before + moves_[i]);
            off_the_border(i, before);
            was_moved_[i] = !(points_[i] == before);
            any_moved = any_moved || was_moved_[i];
        }
        return any_moved;
    }

    Vec on_grid(Vec p) const { return {std::round(p.x / step_) * step_, std::round(p.y / step_) * step_}; }

    // Away from all that are too near, by a part of what is missing.
    Vec push(std::size_t i, double distance, double part) const {
        Vec sum;
        for (const std::uint32_t other : near_.of(i)) {
            const Vec between = points_[i] - points_[other];
            const double now2 = dot(between, between);
            if (now2 >= distance * distance) continue;
            const double now = std::sqrt(now2);
            // Two in one place part along x, the earlier one to the left.
            const Vec away = now > 0 ? between * (1 / now) : Vec{i < other ? -1.0 : 1.0, 0};
            sum = sum + away * (part * (distance - now));
        }
        const double far = length(sum), most = longest_move * scale_;
        return far > most ? sum * (most / far) : sum;
    }

    // A point that is too near to the border goes away from it, unless it then is nearer to another part.
    void off_the_border(std::size_t i, Vec before) {
        const Vec from_free = points_[i] - free_about_[i];
        if (dot(from_free, from_free) < slack_ * slack_) return;
        const double sight = enough_ + 2 * raster_.cell();
        EdgeTree::Place place = border_.place(points_[i], sight, sight);
        if (!place.is_inside) {
            points_[i] = before;
            place = border_.place(points_[i], sight, sight);
            inside_[i] = place.is_inside;
            if (!place.is_inside) return;
        }
        const Vec from = points_[i] - place.nearest;
        if (place.distance >= options_.clearance || !(place.distance > 0)) return;
        const double missing = options_.clearance + step_ - place.distance;
        for (double part = 1; part > 0.2; part /= 2) {
            const Vec to = on_grid(points_[i] + from * (part * missing / place.distance));
            const EdgeTree::Place there = border_.place(to, sight, sight);
            if (!there.is_inside || there.distance <= place.distance + 1e-3 * missing) continue;
            points_[i] = to;
            return;
        }
    }

    // In order: a point goes if one that stays is too near.
    std::vector<std::uint8_t> apart_ones() const {
        std::vector<std::uint8_t> stays = inside_;
        const double least2 = options_.apart * options_.apart * (1 - 1e-12);
        const NearPoints near(points_, options_.apart);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            for (const std::uint32_t other : near.of(i)) {
                const Vec between = points_[i] - points_[other];
                if (other < i && stays[other] && dot(between, between) < least2) stays[i] = 0;
            }
        }
        return stays;
    }

    std::span<Vec> points_;
    const RegionRaster& raster_;
    const EdgeTree& border_;
    const SettleOptions& options_;
    double step_, enough_, scale_, slack_;
    NearPoints near_;
    std::vector<Vec> moves_;
    std::vector<Vec> free_about_;  // a place with no border near it, or nowhere
    std::vector<std::uint8_t> inside_, was_moved_;
};

}  // namespace

std::vector<std::uint8_t> settle(std::span<Vec> points, const RegionRaster& raster, const EdgeTree& border,
                                 const SettleOptions& options) {
    return Settling(points, raster, border, options).run();
}

}  // namespace filigree
