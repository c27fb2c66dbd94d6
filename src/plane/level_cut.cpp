#include "plane/level_cut.h"

#include <algorithm>
#include <deque>
#include <limits>

#include "plane/level_walk.h"
#include "plane/ring_loops.h"

namespace filigree {
namespace {

// Some points in a row, forwards or backwards.
struct Run {
    const Point* first = nullptr;
    std::uint32_t count = 0;
    bool reversed = false;

    std::size_t size() const { return count; }
    Point point(std::size_t i) const { return first[reversed ? count - 1 - i : i]; }
};

// A ring of runs; runs may meet in equal points.
struct RunRing {
    std::uint32_t first_run = 0, end_run = 0;
    Point least{INT64_MAX, INT64_MAX};
    std::uint32_t least_run = 0;
    std::uint32_t least_offset = 0;  // points after its run's first, as the run is read
    bool least_repeats = false;      // perhaps: the least point may come again
};

struct Face {
    RunRing ring;
    std::int32_t strip = 0;
    double u_low = std::numeric_limits<double>::infinity();
    double u_high = -std::numeric_limits<double>::infinity();
    Point low_point;  // where u is least, and of several the one with least v
    std::uint32_t hole_count = 0;
};

struct Hole {
    RunRing ring;
    std::int32_t strip = 0;
    double u = 0;  // of its least point
    std::uint32_t face = no_face;

    static constexpr std::uint32_t no_face = UINT32_MAX;
};

// Joins arcs and chords to faces and writes them in order; kept from cut to cut for its memory.
class Assembler {
public:
    LevelCut assemble(const LevelTrail& trail, const LevelLinks& links, const LevelField& field,
                      std::int64_t first_strip) {
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
        return write(first_strip);
    }

private:
    // ---- faces ----

    void trace_faces() {
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
            Face face;
            const LevelEvent& first = trail_->events[start];
            face.strip = first.level + (first.out_above ? 1 : 0);
            face.ring.first_run = static_cast<std::uint32_t>(run_count_);
            bool pinched = false;
            std::uint32_t event = start;
            do {
                done_[event] = 1;
                const std::uint32_t end = next_event_[event];
                add_arc(face, trail_->events[event].place, trail_->events[end].place,
                        event < ring_events && end <= event);
                const LevelLink& link = links_->links[end];
                if (link.chord != LevelLink::no_chord) add_chord(face, links_->chords[link.chord], link.reversed);
                pinched |= link.pinched;
                event = link.next;
            } while (done_[event] == 0);
            face.ring.end_run = static_cast<std::uint32_t>(run_count_);
            if (!pinched || !split_pinched(face)) faces_.push_back(face);
        }
    }

    void add_arc(Face& face, std::uint32_t begin, std::uint32_t end, bool around) {
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

    void add_places(Face& face, std::uint32_t begin, std::uint32_t end) {
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

    void add_chord(Face& face, const LevelChord& chord, bool reversed) {
        if (chord.first_point == chord.end_point) return;
        const Point* points = links_->points.data();
        const std::uint32_t offset =
            reversed ? chord.end_point - 1 - chord.least_point : chord.least_point - chord.first_point;
        consider_least(face.ring, points[chord.least_point], offset);
        add_run({points + chord.first_point, chord.end_point - chord.first_point, reversed});
    }

    void consider_low(Face& face, Point p, double u) const {
        if (u > face.u_low) return;
        if (u == face.u_low && !(field_->coordinates(p).y < field_->coordinates(face.low_point).y)) return;
        face.u_low = u;
        face.low_point = p;
    }
    void consider_least(RunRing& ring, Point p, std::uint32_t offset) const {
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
    bool split_pinched(const Face& face) {
        std::vector<Point> ring;
        append(ring, face.ring);
        const std::vector<std::vector<Point>> loops = split_loops(ring);
        if (loops.size() == 1 && loops[0].size() == ring.size()) return false;
        for (const std::vector<Point>& loop : loops) {
            const Int128 twice_area = doubled_area(loop);
            if (twice_area == 0) continue;
            const std::vector<Point>& kept = loose_.emplace_back(loop);
            if (twice_area > 0) {
                Face part;
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

    void add_loose(Face& face, const std::vector<Point>& ring) {
        for (std::uint32_t i = 0; i < ring.size(); ++i) {
            const double u = field_->coordinates(ring[i]).x;
            face.u_high = std::max(face.u_high, u);
            consider_low(face, ring[i], u);
            consider_least(face.ring, ring[i], i);
        }
        add_run({ring.data(), static_cast<std::uint32_t>(ring.size()), false});
    }

    // ---- rings that no level crosses ----

    void take_whole_rings() {
        for (const LevelTrail::Ring& ring : trail_->rings) {
            bool crossed = false;
            for (std::uint32_t e = ring.first_event; e < ring.end_event; ++e) crossed |= links_->links[e].live;
            if (crossed) continue;
            const Point* first = trail_->points.data() + ring.first_point;
            const Point* last = trail_->points.data() + ring.end_point;
            const Int128 twice_area = doubled_area({first, last});
            if (twice_area == 0) continue;
            if (twice_area > 0) {
                Face face;
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

    void add_hole(const Point* first, const Point* last, std::int32_t strip) {
        Hole hole;
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

    // ---- order ----

    void sort_faces() {
        const std::size_t strip_count = static_cast<std::size_t>(field_->level_count()) + 1;
        strip_begins_.assign(strip_count + 1, 0);
        for (const Face& face : faces_) ++strip_begins_[static_cast<std::size_t>(face.strip) + 1];
        for (std::size_t s = 0; s < strip_count; ++s) strip_begins_[s + 1] += strip_begins_[s];
        order_.resize(faces_.size());
        strip_ends_.assign(strip_begins_.begin(), strip_begins_.end() - 1);
        for (std::uint32_t f = 0; f < faces_.size(); ++f)
            order_[strip_ends_[static_cast<std::size_t>(faces_[f].strip)]++] = f;
        const auto before = [&](std::uint32_t a, std::uint32_t b) {
            const Face& f = faces_[a];
            const Face& g = faces_[b];
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

    // ---- holes ----

    void find_faces_of_holes() {
        if (holes_.empty()) return;
        std::sort(holes_.begin(), holes_.end(), [](const Hole& a, const Hole& b) {
            return a.strip != b.strip ? a.strip < b.strip : a.ring.least < b.ring.least;
        });
        for (std::size_t begin = 0; begin < holes_.size();) {
            std::size_t end = begin + 1;
            while (end < holes_.size() && holes_[end].strip == holes_[begin].strip) ++end;
            find_in_strip(begin, end);
            begin = end;
        }
    }

    void find_in_strip(std::size_t begin, std::size_t end) {
        const auto strip = static_cast<std::size_t>(holes_[begin].strip);
        const std::uint32_t* order = order_.data() + strip_begins_[strip];
        const std::size_t count = strip_begins_[strip + 1] - strip_begins_[strip];
        if (count == 0) return;
        std::vector<std::size_t> unclear;
        for (std::size_t h = begin; h < end; ++h) {
            holes_[h].face = count == 1 ? order[0] : only_face_around(holes_[h].u, order, count);
            if (holes_[h].face == Hole::no_face) unclear.push_back(h);
        }
        // A hole's point may lie on the face's border, where the two touch: another point then decides.
        for (std::size_t attempt = 0; attempt < 8 && !unclear.empty(); ++attempt) {
            std::vector<Point> points;
            for (const std::size_t h : unclear) points.push_back(point_after_least(holes_[h].ring, attempt));
            RingFinder finder(std::move(points));
            for (std::size_t i = 0; i < count; ++i)
                add_edges(finder, faces_[order[i]].ring, static_cast<std::int64_t>(i));
            std::vector<std::size_t> still_unclear;
            for (std::size_t i = 0; i < unclear.size(); ++i) {
                const std::int64_t found = finder.ring_of(i);
                if (found >= 0 && found < static_cast<std::int64_t>(count)) {
                    holes_[unclear[i]].face = order[found];
                } else {
                    still_unclear.push_back(unclear[i]);
                }
            }
            unclear = std::move(still_unclear);
        }
    }

    // The one face whose range of u holds the value, where a short search says that there is only one.
    std::uint32_t only_face_around(double u, const std::uint32_t* order, std::size_t count) const {
        constexpr std::size_t greatest_search = 16;
        if (count > greatest_search) return Hole::no_face;
        std::uint32_t found = Hole::no_face;
        for (std::size_t i = 0; i < count; ++i) {
            const Face& face = faces_[order[i]];
            if (face.u_low > u || face.u_high < u) continue;
            if (found != Hole::no_face) return Hole::no_face;
            found = order[i];
        }
        return found;
    }

    Point point_after_least(const RunRing& ring, std::size_t steps) const {
        const Run& run = runs_[ring.first_run];  // rings of holes are one run
        return run.first[(ring.least_offset + steps) % run.size()];
    }

    void add_edges(RingFinder& finder, const RunRing& ring, std::int64_t number) const {
        Point last = ring.least;
        bool started = false;
        Point first;
        for (std::uint32_t r = ring.first_run; r < ring.end_run; ++r) {
            const Run& run = runs_[r];
            for (std::size_t i = 0; i < run.size(); ++i) {
                const Point p = run.point(i);
                if (started) {
                    finder.add_edge(last, p, number);
                } else {
                    first = p;
                    started = true;
                }
                last = p;
            }
        }
        if (started) finder.add_edge(last, first, number);
    }

    // ---- output ----

    // Appends the ring from its least point on, without repeats.
    void append(std::vector<Point>& out, const RunRing& ring) const {
        const std::size_t begin = out.size();
        const auto add = [&](const Run& run, std::size_t from, std::size_t to) {
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
        const Run& split = runs_[ring.least_run];
        add(split, ring.least_offset, split.size());
        for (std::uint32_t r = ring.least_run + 1; r < ring.end_run; ++r) add(runs_[r], 0, runs_[r].size());
        for (std::uint32_t r = ring.first_run; r < ring.least_run; ++r) add(runs_[r], 0, runs_[r].size());
        add(split, 0, ring.least_offset);
        while (out.size() > begin + 1 && out.back() == out[begin]) out.pop_back();
        if (ring.least_repeats) start_at_least({out.data() + begin, out.data() + out.size()});
    }

    // Whether a ring that starts at its least point has a positive area. The turn at that point tells a
    // simple ring's direction; small ones, where rounding may count, are computed.
    bool is_positive(RingView ring) const {
        if (ring.size() < 3) return false;
        if (ring.size() > 16 && !field_->may_flip && orientation(ring.back(), ring[0], ring[1]) > 0) return true;
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

    LevelCut write(std::int64_t first_strip) {
        LevelCut result;
        std::size_t point_count = 0;
        for (std::size_t r = 0; r < run_count_; ++r) point_count += runs_[r].size();
        result.pieces.points.reserve(point_count);
        result.pieces.ring_ends.reserve(faces_.size() + holes_.size());
        result.pieces.polygon_ends.reserve(faces_.size());
        result.strips.reserve(faces_.size());
        std::vector<std::vector<std::uint32_t>> holes_of;
        if (!holes_.empty()) {
            holes_of.resize(faces_.size());
            for (std::uint32_t h = 0; h < holes_.size(); ++h) {
                if (holes_[h].face != Hole::no_face) holes_of[holes_[h].face].push_back(h);
            }
        }
        std::vector<Point>& points = result.pieces.points;
        for (const std::uint32_t f : order_) {
            const std::size_t begin = points.size();
            append(points, faces_[f].ring);
            if (!is_positive({points.data() + begin, points.data() + points.size()})) {
                points.resize(begin);
                continue;
            }
            result.pieces.end_ring();
            if (!holes_of.empty()) {
                for (const std::uint32_t h : holes_of[f]) {
                    append(points, holes_[h].ring);
                    result.pieces.end_ring();
                }
            }
            result.pieces.end_polygon();
            result.strips.push_back(static_cast<std::int32_t>(
                first_strip + field_->strip_numbers[static_cast<std::size_t>(faces_[f].strip)]));
        }
        return result;
    }

    void add_run(Run run) {
        if (run_count_ == runs_.size()) runs_.resize(2 * runs_.size() + 64);
        runs_[run_count_++] = run;
    }

    const LevelTrail* trail_ = nullptr;  // while assembling
    const LevelLinks* links_ = nullptr;
    const LevelField* field_ = nullptr;
    std::vector<Run> runs_;
    std::size_t run_count_ = 0;
    std::vector<Face> faces_;
    std::vector<Hole> holes_;
    std::deque<std::vector<Point>> loose_;
    std::vector<std::uint8_t> done_;           // of each event: its arc is in a face
    std::vector<std::uint32_t> next_event_;    // around the ring
    std::vector<std::uint32_t> order_;         // of faces
    std::vector<std::uint32_t> strip_begins_;  // in order_
    std::vector<std::uint32_t> strip_ends_;    // while filling
};

// All that a cut works with, kept for the next one: most shapes are small, and their cuts then allocate
// nothing but the result.
struct Workshop {
    LevelField field;
    LevelWalker walker;
    LevelLinker linker;
    Assembler assembler;
};
constexpr std::size_t greatest_kept_size = std::size_t{1} << 18;  // points of a result, roughly

Workshop& workshop() {
    thread_local Workshop instance;
    return instance;
}

}  // namespace

LevelCut cut(PolygonView shape, const LevelFamily& family) {
    if (shape.point_count() == 0) return {};
    auto& [field, walker, linker, assembler] = workshop();
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
    LevelCut result = assembler.assemble(*trail, *links, field, family.first_strip);
    if (result.pieces.points.size() > greatest_kept_size || shape.point_count() > greatest_kept_size) workshop() = {};
    return result;
}

LevelRange level_range(PolygonView shape, const Frame& frame, const Profile& profile) {
    if (shape.point_count() == 0) return {};
    auto& [field, walker, linker, assembler] = workshop();
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
