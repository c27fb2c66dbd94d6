#include "plane/level_faces.h"

#include <algorithm>

namespace filigree {

void LevelFaces::assemble(const LevelTrail& trail, const LevelLinks& links, const LevelField& field) {
    trail_ = &trail;
    links_ = &links;
    field_ = &field;
    run_count_ = 0;
    faces_.clear();
    holes_.clear();
    loose_.clear();
    trace_faces();
    take_whole_rings();
    sort_faces();
    find_faces_of_holes();
}

std::size_t LevelFaces::point_count() const {
    std::size_t count = 0;
    for (std::size_t r = 0; r < run_count_; ++r) count += runs_[r].size();
    return count;
}

void LevelFaces::trace_faces() {
    const auto event_count = static_cast<std::uint32_t>(trail_->events.size());
    done_.assign(event_count, 0);
    next_event_.resize(event_count);
    for (const LevelTrail::Ring& ring : trail_->rings) {
        for (std::uint32_t e = ring.first_event; e < ring.end_event; ++e) next_event_[e] = e + 1;
        if (ring.first_event < ring.end_event) next_event_[ring.end_event - 1] = ring.first_event;
    }
    const std::uint32_t ring_events = trail_->rings.empty() ? 0 : trail_->rings.back().end_event;
    for (std::uint32_t e = ring_events; e < event_count; ++e) next_event_[e] = e;
    for (std::uint32_t start = 0; start < event_count; ++start) {
        if (done_[start] != 0 || !links_->links[start].live) continue;
        LevelFace face;
        const LevelEvent& first = trail_->events[start];
        face.strip = first.level + (first.out_above ? 1 : 0);
        face.ring.first_run = static_cast<std::uint32_t>(run_count_);
        bool pinched = false;
        std::uint32_t event = start;
        do {
            done_[event] = 1;
            const std::uint32_t end = next_event_[event];
            add_arc(face, trail_->events[event].place, trail_->events[end].place, event < ring_events && end <= event);
            const LevelLink& link = links_->links[end];
            if (link.chord != LevelLink::no_chord) add_chord(face, links_->chords[link.chord], link.reversed);
            pinched |= link.pinched;
            event = link.next;
        } while (done_[event] == 0);
        face.ring.end_run = static_cast<std::uint32_t>(run_count_);
        if (!pinched || !split_pinched(face)) faces_.push_back(face);
    }
}

void LevelFaces::add_arc(LevelFace& face, std::uint32_t begin, std::uint32_t end, bool around) {
    if (!around) {
        add_places(face, begin, end + 1);
        return;
    }
    const auto ring =
        std::upper_bound(trail_->rings.begin(), trail_->rings.end(), begin,
                         [](std::uint32_t place, const LevelTrail::Ring& r) { return place < r.end_point; });
    add_places(face, begin, ring->end_point);
    add_places(face, ring->first_point, end + 1);
}

void LevelFaces::add_places(LevelFace& face, std::uint32_t begin, std::uint32_t end) {
    const Point* points = trail_->points.data();
    const double* u = trail_->u.data();
    Point least = points[begin];
    std::uint32_t at = begin;
    bool repeats = false;
    for (std::uint32_t i = begin; i < end; ++i) {
        if (u[i] > face.u_high) face.u_high = u[i];
        if (u[i] <= face.u_low) consider_low(face, points[i], u[i]);
        if (points[i].x > least.x) continue;
        if (points[i] < least) {
            least = points[i];
            at = i;
            repeats = false;
        } else {
            repeats |= points[i] == least && i != at;
        }
    }
    consider_least(face.ring, least, at - begin);
    face.ring.least_repeats |= repeats && face.ring.least == least;
    add_run({points + begin, end - begin, false});
}

void LevelFaces::add_chord(LevelFace& face, const LevelChord& chord, bool reversed) {
    if (chord.first_point == chord.end_point) return;
    const Point* points = links_->points.data();
    const std::uint32_t offset =
        reversed ? chord.end_point - 1 - chord.least_point : chord.least_point - chord.first_point;
    consider_least(face.ring, points[chord.least_point], offset);
    add_run({points + chord.first_point, chord.end_point - chord.first_point, reversed});
}

void LevelFaces::consider_low(LevelFace& face, Point p, double u) const {
    if (u > face.u_low) return;
    if (u == face.u_low && !(field_->coordinates(p).y < field_->coordinates(face.low_point).y)) return;
    face.u_low = u;
    face.low_point = p;
}
void LevelFaces::consider_least(LevelRing& ring, Point p, std::uint32_t offset) const {
    if (!(p < ring.least)) {
        ring.least_repeats |= p == ring.least;
        return;
    }
    ring.least = p;
    ring.least_repeats = false;
    ring.least_run = static_cast<std::uint32_t>(run_count_);
    ring.least_offset = offset;
}

// Where a face comes to a point twice, loops of it become holes, or faces of their own. False where it
// does not.
bool LevelFaces::split_pinched(const LevelFace& face) {
    std::vector<Point> ring;
    append(ring, face.ring);
    const std::vector<std::vector<Point>> loops = split_loops(ring);
    if (loops.size() == 1 && loops[0].size() == ring.size()) return false;
    for (const std::vector<Point>& loop : loops) {
        const Int128 twice_area = doubled_area(loop);
        if (twice_area == 0) continue;
        const std::vector<Point>& kept = loose_.emplace_back(loop);
        if (twice_area > 0) {
            LevelFace part;
            part.strip = face.strip;
            part.ring.first_run = static_cast<std::uint32_t>(run_count_);
            add_loose(part, kept);
            part.ring.end_run = static_cast<std::uint32_t>(run_count_);
            faces_.push_back(part);
        } else {
            add_hole(kept.data(), kept.data() + kept.size(), face.strip);
        }
    }
    return true;
}

void LevelFaces::add_loose(LevelFace& face, const std::vector<Point>& ring) {
    for (std::uint32_t i = 0; i < ring.size(); ++i) {
        const double u = field_->coordinates(ring[i]).x;
        face.u_high = std::max(face.u_high, u);
        consider_low(face, ring[i], u);
        consider_least(face.ring, ring[i], i);
    }
    add_run({ring.data(), static_cast<std::uint32_t>(ring.size()), false});
}

void LevelFaces::take_whole_rings() {
    for (const LevelTrail::Ring& ring : trail_->rings) {
        bool crossed = false;
        for (std::uint32_t e = ring.first_event; e < ring.end_event; ++e) crossed |= links_->links[e].live;
        if (crossed) continue;
        const Point* first = trail_->points.data() + ring.first_point;
        const Point* last = trail_->points.data() + ring.end_point;
        const Int128 twice_area = doubled_area({first, last});
        if (twice_area == 0) continue;
        if (twice_area > 0) {
            LevelFace face;
            face.strip = ring.strip;
            face.ring.first_run = static_cast<std::uint32_t>(run_count_);
            add_places(face, ring.first_point, ring.end_point);
            face.ring.end_run = static_cast<std::uint32_t>(run_count_);
            faces_.push_back(face);
        } else {
            add_hole(first, last, ring.strip);
        }
    }
}

void LevelFaces::add_hole(const Point* first, const Point* last, std::int32_t strip) {
    LevelHole hole;
    hole.strip = strip;
    hole.ring.first_run = static_cast<std::uint32_t>(run_count_);
    for (const Point* p = first; p != last; ++p) {
        consider_least(hole.ring, *p, static_cast<std::uint32_t>(p - first));
    }
    hole.u = field_->coordinates(hole.ring.least).x;
    add_run({first, static_cast<std::uint32_t>(last - first), false});
    hole.ring.end_run = static_cast<std::uint32_t>(run_count_);
    holes_.push_back(hole);
}

void LevelFaces::sort_faces() {
    const std::size_t strip_count = static_cast<std::size_t>(field_->level_count()) + 1;
    strip_begins_.assign(strip_count + 1, 0);
    for (const LevelFace& face : faces_) ++strip_begins_[static_cast<std::size_t>(face.strip) + 1];
    for (std::size_t s = 0; s < strip_count; ++s) strip_begins_[s + 1] += strip_begins_[s];
    order_.resize(faces_.size());
    strip_ends_.assign(strip_begins_.begin(), strip_begins_.end() - 1);
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
        order_[strip_ends_[static_cast<std::size_t>(faces_[f].strip)]++] = f;
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const LevelFace& f = faces_[a];
        const LevelFace& g = faces_[b];
        if (f.u_low != g.u_low) return f.u_low < g.u_low;
        const double v = field_->coordinates(f.low_point).y, w = field_->coordinates(g.low_point).y;
        if (v != w) return v < w;
        if (f.ring.least != g.ring.least) return f.ring.least < g.ring.least;
        return f.u_high != g.u_high ? f.u_high < g.u_high : a < b;
    };
    for (std::size_t s = 0; s < strip_count; ++s) {
        std::sort(order_.begin() + strip_begins_[s], order_.begin() + strip_begins_[s + 1], before);
    }
}

void LevelFaces::append(std::vector<Point>& out, const LevelRing& ring) const {
    const std::size_t begin = out.size();
    const auto add = [&](const LevelRun& run, std::size_t from, std::size_t to) {
        if (from < to && out.size() > begin) {
            if (out.back() == run.point(from)) ++from;
        }
        if (from >= to) return;
        if (run.reversed) {
            const Point* last = run.first + run.count;
            out.insert(out.end(), std::make_reverse_iterator(last - from), std::make_reverse_iterator(last - to));
        } else {
            out.insert(out.end(), run.first + from, run.first + to);
        }
    };
    const LevelRun& split = runs_[ring.least_run];
    add(split, ring.least_offset, split.size());
    for (std::uint32_t r = ring.least_run + 1; r < ring.end_run; ++r) add(runs_[r], 0, runs_[r].size());
    for (std::uint32_t r = ring.first_run; r < ring.least_run; ++r) add(runs_[r], 0, runs_[r].size());
    add(split, 0, ring.least_offset);
    while (out.size() > begin + 1 && out.back() == out[begin]) out.pop_back();
    if (ring.least_repeats) start_at_least({out.data() + begin, out.data() + out.size()});
}

}  // namespace filigree
