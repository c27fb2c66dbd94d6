#include <algorithm>

#include "plane/level_walk.h"

namespace filigree {
namespace {

constexpr std::size_t greatest_point_count = std::size_t{1} << 31;

}  // namespace

const LevelLinks& LevelLinker::link(LevelTrail& trail, const LevelField& field) {
    trail_ = &trail;
    field_ = &field;
    result_.links.assign(trail.events.size(), {});
    result_.chords.clear();
    result_.too_large = false;
    is_pass_.clear();
    at_points_.clear();
    chord_nodes_.clear();
    chord_levels_.clear();
    resolve_passes();
    sort_crossings();
    pair_crossings();
    add_chord_points();
    return result_;
}

// Counter-clockwise from the curve's right side. A curve is a graph, so straight down is never above it.
bool LevelLinker::comes_before(Point centre, const Spoke& a, const Spoke& b) {
    if (a.above != b.above) return a.above;
    if (a.right != b.right) return a.right == a.above;
    const int turn = orientation(centre, a.to, b.to);
    if (turn != 0) return turn > 0;
    return a.leaves != b.leaves ? b.leaves : a.event < b.event;
}

void LevelLinker::resolve_passes() {
    std::vector<std::uint32_t> passes = trail_->passes;
    if (passes.empty()) return;
    std::sort(passes.begin(), passes.end(), [&](std::uint32_t a, std::uint32_t b) {
        const std::int32_t level_a = trail_->events[a].level, level_b = trail_->events[b].level;
        if (level_a != level_b) return level_a < level_b;
        const Point p = point_of(a), q = point_of(b);
        return p != q ? p < q : a < b;
    });
    is_pass_.assign(trail_->events.size(), 0);
    for (const std::uint32_t e : passes) is_pass_[e] = 1;
    for (std::size_t i = 0; i < passes.size();) {
        std::size_t end = i + 1;
        while (end < passes.size() && trail_->events[passes[end]].level == trail_->events[passes[i]].level &&
               point_of(passes[end]) == point_of(passes[i])) {
            ++end;
        }
        resolve_point(passes.data() + i, end - i);
        i = end;
    }
}

// All passes through one point on one level: the shape's inside there is sectors between an edge that
// leaves and the next edge, counter-clockwise, that arrives. Faces follow sectors, not rings; a sector
// that holds the curve's continuation to the left or right is cut there.
void LevelLinker::resolve_point(const std::uint32_t* passes, std::size_t count) {
    spokes_.clear();
    const Point centre = point_of(passes[0]);
    for (std::size_t i = 0; i < count; ++i) {
        const LevelEvent& event = trail_->events[passes[i]];
        add_spoke(centre, passes[i], false, event.in_above);
        add_spoke(centre, passes[i], true, event.out_above);
    }
    std::sort(spokes_.begin(), spokes_.end(),
              [&](const Spoke& p, const Spoke& q) { return comes_before(centre, p, q); });
    // Counter-clockwise from the right. The inside lies to the right where more edges arrive than left.
    std::size_t open = 0, depth = 0;
    leaving_.clear();
    arriving_.clear();
    for (std::size_t i = 0; i < spokes_.size(); ++i) {
        if (spokes_[i].leaves) {
            leaving_.push_back(i);
            ++depth;
        } else {
            arriving_.push_back(i);
            if (depth == 0) {
                ++open;
            } else {
                --depth;
            }
        }
    }
    const bool shared = count > 1;
    for (std::size_t j = 0; j < count; ++j) {
        add_sector(spokes_[leaving_[(j + count - open) % count]], spokes_[arriving_[j]], j < open, shared);
    }
}

void LevelLinker::add_spoke(Point centre, std::uint32_t event, bool leaves, bool above) {
    const std::uint32_t place = trail_->events[event].place;
    const auto after =
        std::upper_bound(trail_->rings.begin(), trail_->rings.end(), place,
                         [](std::uint32_t at, const LevelTrail::Ring& ring) { return at < ring.end_point; });
    std::uint32_t at = place;
    do {  // the last point of a trail may equal its first
        if (leaves) {
            at = at + 1 == after->end_point ? after->first_point : at + 1;
        } else {
            at = at == after->first_point ? after->end_point - 1 : at - 1;
        }
    } while (trail_->points[at] == centre && at != place);
    const Point to = trail_->points[at];
    const Vec direction{static_cast<double>(to.x - centre.x), static_cast<double>(to.y - centre.y)};
    spokes_.push_back({to, event, leaves, above, dot(direction, field_->along) >= 0});
}

void LevelLinker::add_sector(const Spoke& leaving, const Spoke& arriving, bool wraps, bool shared) {
    const std::uint32_t in = arriving.event, out = leaving.event;
    const bool same_side = leaving.above == arriving.above;
    const bool holds_right = same_side ? wraps : arriving.above;
    const bool holds_left = same_side ? wraps : leaving.above;
    if (holds_right && holds_left) {
        const auto between = static_cast<std::uint32_t>(trail_->events.size());
        const LevelEvent at = trail_->events[in];
        // An arc of one point on the other side of the level.
        trail_->events.push_back({at.place, at.level, !leaving.above, !leaving.above});
        result_.links.push_back({between, LevelLink::no_chord, false, true, true});
        is_pass_.push_back(1);
        add_crossing(at.level, true, leaving.above ? between : in, leaving.above ? out : between);
        add_crossing(at.level, false, leaving.above ? in : between, leaving.above ? between : out);
        result_.links[in].pinched = result_.links[out].pinched = true;
        return;
    }
    if (holds_right || holds_left) {
        add_crossing(trail_->events[in].level, holds_left, in, out);
    } else {
        result_.links[in].next = out;
        result_.links[in].live = shared;
    }
    if (shared) result_.links[in].pinched = result_.links[out].pinched = true;
}

void LevelLinker::add_crossing(std::int32_t level, bool rising, std::uint32_t in, std::uint32_t out) {
    result_.links[in].live = result_.links[out].live = true;
    at_points_.push_back({2 * level + (rising ? 1 : 0), {u_of(in), in, out}});
}

// Into buckets by level and direction, each by u.
void LevelLinker::sort_crossings() {
    const std::size_t bucket_count = 2 * static_cast<std::size_t>(field_->level_count());
    ends_.assign(bucket_count + 1, 0);
    const std::size_t ring_events = trail_->rings.empty() ? 0 : trail_->rings.back().end_event;
    const bool any_pass = !is_pass_.empty();
    const auto bucket = [&](const LevelEvent& event) {
        return 2 * static_cast<std::size_t>(event.level) + (event.out_above ? 1 : 0);
    };
    for (std::size_t e = 0; e < ring_events; ++e) {
        if (!any_pass || is_pass_[e] == 0) ++ends_[bucket(trail_->events[e]) + 1];
    }
    for (const auto& [key, crossing] : at_points_) ++ends_[static_cast<std::size_t>(key) + 1];
    for (std::size_t b = 0; b < bucket_count; ++b) ends_[b + 1] += ends_[b];
    crossings_.resize(ends_[bucket_count]);
    for (std::size_t e = 0; e < ring_events; ++e) {
        if (any_pass && is_pass_[e] != 0) continue;
        const auto event = static_cast<std::uint32_t>(e);
        result_.links[e].live = true;
        crossings_[ends_[bucket(trail_->events[e])]++] = {u_of(event), event, event};
    }
    for (const auto& [key, crossing] : at_points_) crossings_[ends_[static_cast<std::size_t>(key)]++] = crossing;
    // Filling moved each bucket's start to its end: ends_[b] is now one past bucket b.
    std::uint32_t begin = 0;
    for (std::size_t b = 0; b < bucket_count; ++b) {
        sort_bucket(crossings_.data() + begin, ends_[b] - begin);
        begin = ends_[b];
    }
}

void LevelLinker::sort_bucket(Crossing* first, std::size_t count) const {
    const auto before = [&](const Crossing& a, const Crossing& b) {
        if (a.u != b.u) return a.u < b.u;
        const Point p = point_of(a.in), q = point_of(b.in);
        return p != q ? p < q : a.in < b.in;
    };
    if (count > 32) {
        std::sort(first, first + count, before);
        return;
    }
    for (std::size_t i = 1; i < count; ++i) {
        const Crossing crossing = first[i];
        std::size_t j = i;
        for (; j > 0 && before(crossing, first[j - 1]); --j) first[j] = first[j - 1];
        first[j] = crossing;
    }
}

// Along a level the inside starts and ends by turns, so the i-th start belongs to the i-th end, whichever way
// rounding has put neighbours.
void LevelLinker::pair_crossings() {
    const std::size_t level_count = static_cast<std::size_t>(field_->level_count());
    const bool straight = field_->nodes.empty();
    std::size_t begin = 0;
    for (std::size_t k = 0; k < level_count; ++k) {
        const std::size_t middle = ends_[2 * k], end = ends_[2 * k + 1];
        for (std::size_t i = begin; i < middle && middle + (i - begin) < end; ++i) {
            const Crossing& start = crossings_[i];
            const Crossing& stop = crossings_[middle + (i - begin)];
            const auto chord = static_cast<std::uint32_t>(result_.chords.size());
            join(start.in, stop.out, chord, false);
            join(stop.in, start.out, chord, true);
            result_.chords.emplace_back();
            if (straight) continue;
            chord_nodes_.push_back(nodes_between(*field_, start.u, stop.u));
            chord_levels_.push_back(static_cast<std::int32_t>(k));
        }
        begin = end;
    }
}

void LevelLinker::add_chord_points() {
    std::size_t point_count = 0;
    for (const NodeRange& nodes : chord_nodes_) point_count += nodes.end - nodes.begin;
    if (2 * (point_count + crossings_.size()) + trail_->points.size() > greatest_point_count) {
        result_.too_large = true;
        return;
    }
    if (result_.points.size() < point_count) result_.points.resize(point_count);
    std::uint32_t next = 0;
    for (std::size_t c = 0; c < chord_nodes_.size(); ++c) {
        LevelChord& chord = result_.chords[c];
        chord.first_point = chord.least_point = next;
        Point* points = result_.points.data();
        field_->curve_points(chord_levels_[c], chord_nodes_[c].begin, chord_nodes_[c].end, points + next);
        chord.end_point = next += static_cast<std::uint32_t>(chord_nodes_[c].end - chord_nodes_[c].begin);
        for (std::uint32_t i = chord.first_point; i < chord.end_point; ++i) {
            if (points[i] < points[chord.least_point]) chord.least_point = i;
        }
    }
}

void LevelLinker::join(std::uint32_t in, std::uint32_t out, std::uint32_t chord, bool reversed) {
    LevelLink& link = result_.links[in];
    link.next = out;
    link.chord = chord;
    link.reversed = reversed;
}

}  // namespace filigree
