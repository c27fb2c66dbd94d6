#include "plane/cubics.h"

#include "plane/arc.h"

namespace filigree {

Path in_cubics(const Path& path) {
    Path out;
    out.verbs.reserve(path.verbs.size());
    out.points.reserve(path.points.size());
    Vec start, here;
    std::size_t at = 0;
    for (const Verb verb : path.verbs) {
        const std::size_t count = point_count(verb);
        if (path.points.size() - at < count) break;
        const Vec* points = path.points.data() + at;
        at += count;
        const Vec to = verb == Verb::close ? start : points[count - 1];
        if (verb == Verb::quadratic) {
            const Vec control = points[0];
            out.verbs.push_back(Verb::cubic);
            out.points.insert(out.points.end(), {here + 2.0 / 3 * (control - here), to + 2.0 / 3 * (control - to), to});
        } else if (verb == Verb::arc) {
            const CentreArc arc = centre_arc(here, points, to);
            if (arc.is_line) {
                out.verbs.push_back(Verb::line);
                out.points.push_back(to);
            } else {
                append_cubics(out, arc, to);
            }
        } else {
            out.verbs.push_back(verb);
            out.points.insert(out.points.end(), points, points + count);
        }
        if (verb == Verb::move) start = to;
        here = to;
    }
    return out;
}

}  // namespace filigree
