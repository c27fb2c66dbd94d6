#include "plane/settle.h"

#include <algorithm>

#include "plane/near_points.h"

namespace filigree {

namespace {

constexpr int gentle_rounds = 8;
constexpr int raster_rounds = 10, exact_rounds = 6;  // at most, with a distance that must be kept
constexpr double gentleness = 0.2;                   // of what is missing, for each of two
constexpr double reach = 1.5;         // of the distances: how far away a point may be that comes into question
constexpr double longest_move = 0.2;  // of the distance, in one round
constexpr double steps_to_cell =
    64;  // of the grid that points are moved on, so that ever smaller changes do not spread
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
          moves_(points.size()),
          inside_(points.size(), 1),
          was_moved_(points.size(), 1),
          may_move_(points.size(), 1),
          is_gone_(points.size(), 0) {
        free_about_.reserve(points.size());
        for (const Vec p : points) {
            const bool is_free = raster.is_inside(raster.index_of(p)) && !border.is_any_nearer(p, enough_ + slack_);
            free_about_.push_back(is_free ? p : nowhere);
        }
    }

    std::vector<std::uint8_t> run() {
        if (options_.even > options_.apart) even_out();
        part_all();
        is_gone_ = too_near_ones();
        const bool any_gone = std::count(is_gone_.begin(), is_gone_.end(), 1) > 0;
        if (!any_gone || !(options_.even > options_.apart)) return those_that_stay();
        // What is left about a gap spreads into it.
        std::vector<std::uint8_t> may_move(points_.size(), 0);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!is_gone_[i]) continue;
            for (const std::uint32_t next : near_.of(i)) {
                may_move[next] = 1;
                for (const std::uint32_t beyond : near_.of(next)) may_move[beyond] = 1;
            }
        }
        std::swap(may_move_, may_move);
        even_out();
        may_move_.assign(points_.size(), 1);
        part_all();
        is_gone_ = too_near_ones();
        return those_that_stay();
    }

private:
    static constexpr Vec nowhere{1e300, 1e300};

    void even_out() {
        const std::vector<Vec> before(points_.begin(), points_.end());
        for (int round = 0; round < gentle_rounds; ++round) {
            move_on_raster(options_.even, gentleness, options_.even, gentleness);
        }
        return_from_outside(before);
    }

    // Until all keep apart, where that can be: at first by the raster, then with the true border.
    void part_all() {
        const double distance = options_.apart * room_for_steps;
        const std::vector<Vec> before(points_.begin(), points_.end());
        for (int round = 0; round < raster_rounds; ++round) {
            if (!move_on_raster(distance, 0.5, 2 * options_.clearance - raster_.cell(), 0.5)) break;
        }
        return_from_outside(before);
        for (int round = 0; round < exact_rounds; ++round) {
            if (!move_exactly(distance)) break;
        }
    }

    // All at once, by a part of what is missing to a distance, with the border as a mirror; whether any two were too
    // near. A point goes nowhere rather than outside, as far as the raster tells.
    bool move_on_raster(double distance, double part, double mirror_distance, double mirror_part) {
        bool any_too_near = false;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!may_move_[i] || is_gone_[i]) continue;
            const Vec apart = push(i, distance, part);
            any_too_near = any_too_near || !(apart == Vec{});
            moves_[i] = apart + push_of_border(points_[i], mirror_distance, mirror_part);
        }
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!may_move_[i] || is_gone_[i] || moves_[i] == Vec{}) continue;
            const Vec to = on_grid(points_[i] + moves_[i]);
            if (raster_.is_inside(raster_.index_of(to))) points_[i] = to;
        }
        return any_too_near;
    }
    Vec push_of_border(Vec p, double distance, double part) const {
        const std::uint32_t cell = raster_.index_of(p);
        if (!raster_.is_inside(cell)) return {};
        const double near = raster_.border_distance(cell);
        if (2 * near > distance + 2 * raster_.cell()) return {};
        const auto across = [&](std::uint32_t before, std::uint32_t after) {
            return (raster_.border(after) - raster_.border(before)) / (2.0 * RegionRaster::step);
        };
        const Vec away{across(cell - 1, cell + 1), across(cell - raster_.columns(), cell + raster_.columns())};
        const double missing = distance - 2 * (near + dot(p - raster_.centre(cell), away));
        return missing > 0 ? away * (part * missing) : Vec{};
    }
    // The raster does not know of holes thinner than a cell.
    void return_from_outside(const std::vector<Vec>& before) {
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (points_[i] == before[i]) continue;
            was_moved_[i] = 1;
            if (is_far_inside(i) || is_clear(points_[i]) || place_of(points_[i]).is_inside) continue;
            points_[i] = before[i];
        }
    }

    bool move_exactly(double distance) {
        for (std::size_t i = 0; i < points_.size(); ++i) moves_[i] = is_gone_[i] ? Vec{} : push(i, distance, 0.5);
        bool any_moved = false;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const bool is_pushed = !(moves_[i] == Vec{});
            if (is_gone_[i] || (!is_pushed && !was_moved_[i])) continue;
            const Vec before = points_[i];
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
            if (is_gone_[other]) continue;
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

    bool is_far_inside(std::size_t i) const {
        const Vec from_free = points_[i] - free_about_[i];
        return dot(from_free, from_free) < slack_ * slack_;
    }
    // The middle of its cell is inside and no farther than the border.
    bool is_clear(Vec p) const { return raster_.is_inside(raster_.index_of(p)) && !border_.is_any_nearer(p, enough_); }
    EdgeTree::Place place_of(Vec p) const { return border_.place(p, enough_, enough_); }

    // A point that is too near to the border goes away from it, unless it then is nearer to another part.
    void off_the_border(std::size_t i, Vec before) {
        if (is_far_inside(i) || is_clear(points_[i])) {
            inside_[i] = 1;
            return;
        }
        EdgeTree::Place place = place_of(points_[i]);
        if (!place.is_inside) {
            points_[i] = before;
            place = place_of(points_[i]);
        }
        inside_[i] = place.is_inside;
        if (!place.is_inside) return;
        const Vec from = points_[i] - place.nearest;
        const double missing = options_.clearance - place.distance + step_;
        if (missing <= step_ || !(place.distance > 0)) return;
        for (double part = 1; part > 0.2; part /= 2) {
            const Vec to = on_grid(points_[i] + from * (part * missing / place.distance));
            const EdgeTree::Place there = place_of(to);
            if (!there.is_inside || there.distance <= place.distance + 1e-3 * missing) continue;
            points_[i] = to;
            return;
        }
    }

    // In order: a point goes if it is outside or one that stays is too near.
    std::vector<std::uint8_t> too_near_ones() const {
        std::vector<std::uint8_t> goes(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i) goes[i] = !inside_[i] || is_gone_[i];
        const double least2 = options_.apart * options_.apart * (1 - 1e-12);
        const NearPoints near(points_, options_.apart);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            for (const std::uint32_t other : near.of(i)) {
                const Vec between = points_[i] - points_[other];
                if (other < i && !goes[other] && dot(between, between) < least2) goes[i] = 1;
            }
        }
        return goes;
    }
    std::vector<std::uint8_t> those_that_stay() const {
        std::vector<std::uint8_t> stays(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i) stays[i] = !is_gone_[i];
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
    std::vector<std::uint8_t> inside_, was_moved_, may_move_, is_gone_;
};

}  // namespace

std::vector<std::uint8_t> settle(std::span<Vec> points, const RegionRaster& raster, const EdgeTree& border,
                                 const SettleOptions& options) {
    return Settling(points, raster, border, options).run();
}

}  // namespace filigree
