// The first half of a level cut: walking the rings, and pairing the crossings of each level.
//
// A trail is a ring's points with the crossings between them; an event is a place of a trail where the strip
// may change. Events cut the trails into arcs, each within one strip; the chords along the levels join the
// arcs to faces (level_cut.cpp). What lies exactly on a level belongs to the side where the shape's inside
// is, so edges along a level make no crossings, no flat faces, and chords never run over a ring's points.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/level_field.h"

namespace filigree {

struct LevelEvent {
    std::uint32_t place = 0;  // in the trail
    std::int32_t level = 0;
    bool in_above = false, out_above = false;  // the side of the level before and after
};

struct LevelTrail {
    struct Ring {
        std::uint32_t first_point = 0, end_point = 0;
        std::uint32_t first_event = 0, end_event = 0;
        std::int32_t strip = 0;  // where the last stretch before the first point lies
    };
    std::vector<Point> points;  // of all rings, no two equal in a row
    std::vector<double> u;      // of each point
    std::vector<Ring> rings;
    std::vector<LevelEvent> events;     // ring by ring in order; after them, links that lie on no ring
    std::vector<std::uint32_t> passes;  // events at points that lie on their level; the others are crossings
};

// A point of a ring and where it stands.
struct LevelCorner {
    Point point;
    double u = 0, v = 0;  // px
    double phi = 0;       // px; within the tolerance of the level where the code says that it is on one
    LevelCode code = 0;
    std::uint32_t node = 0;  // the profile's breakpoint before it
};

struct LevelExtent {
    double u_low = 0, u_high = 0, v_low = 0, v_high = 0;  // px
};

// Walks shapes; kept from cut to cut for its memory. A field may still lack its nodes and levels when a shape
// is read, but not when it is walked.
class LevelWalker {
public:
    LevelExtent read(PolygonView shape, const LevelField& field);
    LevelTrail& walk(const LevelField& field);

private:
    void walk_ring(const LevelCorner* corners, std::size_t count);
    void walk_straight(const LevelCorner& from, const LevelCorner& to);
    void walk_bent(const LevelCorner& from, const LevelCorner& to);
    void sample(const LevelCorner& a, const LevelCorner& b, NodeRange nodes);
    template <class AddPoint>
    void walk_stretch(LevelCode a, LevelCode b, bool towards_greater_u, AddPoint&& add_point_at);
    void pass(LevelCode code, std::int32_t strip);
    void add_inside(const LevelCorner& a, const LevelCorner& b, double fraction, double rise_of_phi);
    void add_point(Point p, double u);
    std::uint32_t last_place() const { return static_cast<std::uint32_t>(trail_.points.size() - 1); }

    const LevelField* field_ = nullptr;  // while walking
    std::vector<LevelCorner> corners_;   // of all rings
    std::vector<std::size_t> ring_ends_;
    std::vector<FieldSample> samples_;
    LevelTrail trail_;
    std::size_t ring_begin_ = 0;
    std::int32_t strip_ = 0;
};

// How faces go on from the end of an arc, for every event: along `chord`, if any, then out of event `next`.
struct LevelLink {
    static constexpr std::uint32_t no_chord = UINT32_MAX;
    std::uint32_t next = 0;
    std::uint32_t chord = no_chord;
    bool reversed = false;  // against u
    bool live = false;      // false: nothing happens here, the ring goes on as it was
    bool pinched = false;   // faces may come twice to the same point here
};

// A stretch of a level inside the shape, from an entering to a leaving crossing.
struct LevelChord {
    std::uint32_t first_point = 0, end_point = 0;  // breakpoints strictly between the crossings
    std::uint32_t least_point = 0;                 // the lexicographically least of them, if any
};

struct LevelLinks {
    std::vector<LevelLink> links;  // of each event
    std::vector<LevelChord> chords;
    std::vector<Point> points;  // of the chords; some more may follow
    bool too_large = false;     // more than 2^31 points: nothing was made
};

class LevelLinker {
public:
    // Adds events to the trail, with a place but on no ring, where a level touches a corner from outside:
    // there the chord on the left leads straight to the chord on the right.
    const LevelLinks& link(LevelTrail& trail, const LevelField& field);

private:
    // A place on a level's curve where a chord ends: rising ones end the inside (as u grows), falling ones
    // start it. Faces reach it by the end of `in`'s arc and leave it by `out`'s.
    struct Crossing {
        double u = 0;
        std::uint32_t in = 0, out = 0;
    };
    // One end of a ring's edge at a point on a level, seen from that point.
    struct Spoke {
        Point to;
        std::uint32_t event = 0;
        bool leaves = false;  // the edge goes out from the point, so the inside lies counter-clockwise of it
        bool above = false;
        bool right = false;  // towards greater u
    };

    void resolve_passes();
    void resolve_point(const std::uint32_t* passes, std::size_t count);
    static bool comes_before(Point centre, const Spoke& a, const Spoke& b);
    void add_spoke(Point centre, std::uint32_t event, bool leaves, bool above);
    void add_sector(const Spoke& leaving, const Spoke& arriving, bool wraps, bool shared);
    void add_crossing(std::int32_t level, bool rising, std::uint32_t in, std::uint32_t out);
    void sort_crossings();
    void sort_bucket(Crossing* first, std::size_t count) const;
    void pair_crossings();
    void add_chord_points();
    void join(std::uint32_t in, std::uint32_t out, std::uint32_t chord, bool reversed);
    Point point_of(std::uint32_t event) const { return trail_->points[trail_->events[event].place]; }
    double u_of(std::uint32_t event) const { return trail_->u[trail_->events[event].place]; }

    LevelTrail* trail_ = nullptr;  // while linking
    const LevelField* field_ = nullptr;
    LevelLinks result_;
    std::vector<Spoke> spokes_;
    std::vector<std::size_t> leaving_, arriving_;
    std::vector<std::uint8_t> is_pass_;                         // of each event; empty where there are none
    std::vector<std::pair<std::int32_t, Crossing>> at_points_;  // bucket and crossing, at passes
    std::vector<Crossing> crossings_;
    std::vector<std::uint32_t> ends_;  // of the buckets: falling, rising, level by level
    std::vector<NodeRange> chord_nodes_;
    std::vector<std::int32_t> chord_levels_;
};

}  // namespace filigree
