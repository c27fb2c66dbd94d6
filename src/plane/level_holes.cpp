#include <algorithm>

#include "plane/level_faces.h"

namespace filigree {

void LevelFaces::find_faces_of_holes() {
    if (holes_.empty()) return;
    std::sort(holes_.begin(), holes_.end(), [](const LevelHole& a, const LevelHole& b) {
        return a.strip != b.strip ? a.strip < b.strip : a.ring.least < b.ring.least;
    });
    for (std::size_t begin = 0; begin < holes_.size();) {
        std::size_t end = begin + 1;
        while (end < holes_.size() && holes_[end].strip == holes_[begin].strip) ++end;
        find_in_strip(begin, end);
        begin = end;
    }
}

void LevelFaces::find_in_strip(std::size_t begin, std::size_t end) {
    const auto strip = static_cast<std::size_t>(holes_[begin].strip);
    const std::uint32_t* order = order_.data() + strip_begins_[strip];
    const std::size_t count = strip_begins_[strip + 1] - strip_begins_[strip];
    if (count == 0) return;
    std::vector<std::size_t> unclear;
    for (std::size_t h = begin; h < end; ++h) {
        holes_[h].face = count == 1 ? order[0] : only_face_around(holes_[h].u, order, count);
        if (holes_[h].face == LevelHole::no_face) unclear.push_back(h);
    }
    // A hole's point may lie on the face's border, where the two touch: another point then decides.
    for (std::size_t attempt = 0; attempt < 8 && !unclear.empty(); ++attempt) {
        std::vector<Point> points;
        for (const std::size_t h : unclear) points.push_back(point_after_least(holes_[h].ring, attempt));
        RingFinder finder(std::move(points));
        for (std::size_t i = 0; i < count; ++i) add_edges(finder, faces_[order[i]].ring, static_cast<std::int64_t>(i));
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
std::uint32_t LevelFaces::only_face_around(double u, const std::uint32_t* order, std::size_t count) const {
    constexpr std::size_t greatest_search = 16;
    if (count > greatest_search) return LevelHole::no_face;
    std::uint32_t found = LevelHole::no_face;
    for (std::size_t i = 0; i < count; ++i) {
        const LevelFace& face = faces_[order[i]];
        if (face.u_low > u || face.u_high < u) continue;
        if (found != LevelHole::no_face) return LevelHole::no_face;
        found = order[i];
    }
    return found;
}

Point LevelFaces::point_after_least(const LevelRing& ring, std::size_t steps) const {
    const LevelRun& run = runs_[ring.first_run];  // rings of holes are one run
    return run.first[(ring.least_offset + steps) % run.size()];
}

void LevelFaces::add_edges(RingFinder& finder, const LevelRing& ring, std::int64_t number) const {
    Point last = ring.least;
    bool started = false;
    Point first;
    for (std::uint32_t r = ring.first_run; r < ring.end_run; ++r) {
        const LevelRun& run = runs_[r];
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

}  // namespace filigree
