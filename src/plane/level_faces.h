// The second half of a level cut: arcs and chords become faces, in order, each with its holes.
//
// From the far side of a chord its level's side goes on to infinity outside the face, so a face's border that
// has a chord is always an outer ring; holes of faces are the rings that no level crosses, and the loops of
// rings that touch themselves. Points are not copied here: rings are runs of the trail's and chords' points.
#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

#include "plane/level_walk.h"
#include "plane/ring_loops.h"

namespace filigree {

// Some points in a row, forwards or backwards.
struct LevelRun {
    const Point* first = nullptr;
    std::uint32_t count = 0;
    bool reversed = false;

    std::size_t size() const { return count; }
    Point point(std::size_t i) const { return first[reversed ? count - 1 - i : i]; }
};

// A ring of runs; runs may meet in equal points.
struct LevelRing {
    std::uint32_t first_run = 0, end_run = 0;
    Point least{INT64_MAX, INT64_MAX};
    std::uint32_t least_run = 0;
    std::uint32_t least_offset = 0;  // points after its run's first, as the run is read
    bool least_repeats = false;      // perhaps: the least point may come again
};

struct LevelFace {
    LevelRing ring;
    std::int32_t strip = 0;
    double u_low = std::numeric_limits<double>::infinity();
    double u_high = -std::numeric_limits<double>::infinity();
    Point low_point;  // where u is least, and of several the one with least v
};

struct LevelHole {
    LevelRing ring;
    std::int32_t strip = 0;
    double u = 0;  // of its least point
    std::uint32_t face = no_face;

    static constexpr std::uint32_t no_face = UINT32_MAX;
};

// Kept from cut to cut for its memory. What it holds is valid while trail, links and field are.
class LevelFaces {
public:
    void assemble(const LevelTrail& trail, const LevelLinks& links, const LevelField& field);

    const std::vector<LevelFace>& faces() const { return faces_; }
    const std::vector<LevelHole>& holes() const { return holes_; }  // by strip, then by their least points
    // The numbers of the faces by strip, then by their lowest u, then v.
    const std::vector<std::uint32_t>& order() const { return order_; }
    std::size_t point_count() const;  // of all rings, at most
    // Appends the ring from its least point on, without repeats.
    void append(std::vector<Point>& out, const LevelRing& ring) const;

private:
    void trace_faces();
    void add_arc(LevelFace& face, std::uint32_t begin, std::uint32_t end, bool around);
    void add_places(LevelFace& face, std::uint32_t begin, std::uint32_t end);
    void add_chord(LevelFace& face, const LevelChord& chord, bool reversed);
    void consider_low(LevelFace& face, Point p, double u) const;
    void consider_least(LevelRing& ring, Point p, std::uint32_t offset) const;
    bool split_pinched(const LevelFace& face);
    void add_loose(LevelFace& face, const std::vector<Point>& ring);
    void take_whole_rings();
    void add_hole(const Point* first, const Point* last, std::int32_t strip);
    void sort_faces();
    void find_faces_of_holes();
    void find_in_strip(std::size_t begin, std::size_t end);
    std::uint32_t only_face_around(double u, const std::uint32_t* order, std::size_t count) const;
    Point point_after_least(const LevelRing& ring, std::size_t steps) const;
    void add_edges(RingFinder& finder, const LevelRing& ring, std::int64_t number) const;
    void add_run(LevelRun run) {
        if (run_count_ == runs_.size()) runs_.resize(2 * runs_.size() + 64);
        runs_[run_count_++] = run;
    }

    const LevelTrail* trail_ = nullptr;  // while assembling
    const LevelLinks* links_ = nullptr;
    const LevelField* field_ = nullptr;
    std::vector<LevelRun> runs_;
    std::size_t run_count_ = 0;
    std::vector<LevelFace> faces_;
    std::vector<LevelHole> holes_;
    std::deque<std::vector<Point>> loose_;
    std::vector<std::uint8_t> done_;           // of each event: its arc is in a face
    std::vector<std::uint32_t> next_event_;    // around the ring
    std::vector<std::uint32_t> order_;         // of faces
    std::vector<std::uint32_t> strip_begins_;  // in order_
    std::vector<std::uint32_t> strip_ends_;    // while filling
};

}  // namespace filigree
