#include "curves/path_elements.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "base/elementary.h"
#include "plane/arc.h"

namespace filigree::curves {
namespace {

using elementary::pi;

constexpr std::uint32_t none = UINT32_MAX;

// An end is twice its element's number, plus one where the element ends there.
Vec place_of(std::span<const Element> elements, std::uint32_t end) {
    const auto [first, last] = ends_of(elements[end / 2]);
    return end % 2 == 0 ? first : last;
}

// From an end into its element.
Vec direction_from(std::span<const Element> elements, std::uint32_t end) {
    const Element& e = elements[end / 2];
    if (e.kind == ElementKind::arc) {
        const Vec velocity = velocity_at(e, end % 2 == 0 ? e.from : e.to);
        return end % 2 == 0 ? velocity : -velocity;
    }
    const std::size_t count = e.kind == ElementKind::line ? 2 : e.kind == ElementKind::parabola ? 3 : 4;
    const auto control = [&](std::size_t i) { return e.at[end % 2 == 0 ? i : count - 1 - i]; };
    std::size_t next = 1;  // the first control point that does not lie on the end
    while (next + 1 < count && control(next) == control(0)) ++next;
    return control(next) - control(0);
}

// --- which ends meet

std::uint32_t root_of(std::vector<std::uint32_t>& parents, std::uint32_t end) {
    while (parents[end] != end) end = parents[end] = parents[parents[end]];
    return end;
}

struct PlacedEnd {
    std::uint32_t group = 0;
    double column = 0, row = 0;  // of a grid so fine that ends of one cell are equal
    std::uint32_t end = 0;
    Vec place;

    auto cell() const { return std::tuple(group, column, row); }
};

// The ends that meet, each list and each list's ends in order.
std::vector<std::vector<std::uint32_t>> joints_of(std::span<const Element> elements, double tolerance,
                                                  std::span<const std::uint32_t> groups) {
    std::vector<PlacedEnd> ends;
    for (std::uint32_t e = 0; e < elements.size(); ++e) {
        if (elements[e].kind == ElementKind::point || is_closed(elements[e])) continue;
        for (const std::uint32_t end : {2 * e, 2 * e + 1}) {
            const Vec p = place_of(elements, end);
            const auto cell = [&](double v) { return tolerance > 0 ? std::floor(v / (0.7 * tolerance)) : v; };
            ends.push_back({groups[e], cell(p.x), cell(p.y), end, p});
        }
    }
    std::sort(ends.begin(), ends.end(), [](const PlacedEnd& a, const PlacedEnd& b) {
        return std::pair(a.cell(), a.end) < std::pair(b.cell(), b.end);
    });
    std::vector<std::uint32_t> parents(2 * elements.size());
    std::iota(parents.begin(), parents.end(), 0U);
    const auto link = [&](std::uint32_t a, std::uint32_t b) {
        a = root_of(parents, a);
        b = root_of(parents, b);
        parents[std::max(a, b)] = std::min(a, b);
    };
    const auto run_of = [&](const PlacedEnd& key) {
        const auto in_order = [](const PlacedEnd& a, const PlacedEnd& b) { return a.cell() < b.cell(); };
        return std::equal_range(ends.begin(), ends.end(), key, in_order);
    };
    // Cells are whole, so one near pair links two of them.
    const auto link_cells = [&](auto first, auto second) {
        for (auto a = first.first; a != first.second; ++a) {
            for (auto b = second.first; b != second.second; ++b) {
                if (length(a->place - b->place) <= tolerance) return link(a->end, b->end);
            }
        }
    };
    constexpr std::pair<int, int> cells_ahead[] = {{0, 1}, {0, 2},  {1, -2}, {1, -1}, {1, 0}, {1, 1},
                                                   {1, 2}, {2, -2}, {2, -1}, {2, 0},  {2, 1}, {2, 2}};
    for (auto at = ends.begin(); at != ends.end();) {
        const auto run = run_of(*at);
        for (auto next = at + 1; next != run.second; ++next) link(at->end, next->end);
        if (tolerance > 0) {
            for (const auto& [columns, rows] : cells_ahead) {
                link_cells(run, run_of({at->group, at->column + columns, at->row + rows, 0, {}}));
            }
        }
        at = run.second;
    }

    std::vector<std::pair<std::uint32_t, std::uint32_t>> of_roots;
    for (const PlacedEnd& end : ends) {
        const std::uint32_t root = root_of(parents, end.end);
        // A line that is no longer than a joint would be joined to itself.
        const bool is_dot = elements[end.end / 2].kind == ElementKind::line && root == root_of(parents, end.end ^ 1U);
        if (!is_dot) of_roots.emplace_back(root, end.end);
    }
    std::sort(of_roots.begin(), of_roots.end());
    std::vector<std::vector<std::uint32_t>> joints;
    for (std::size_t i = 0; i < of_roots.size(); ++i) {
        if (i == 0 || of_roots[i].first != of_roots[i - 1].first) joints.emplace_back();
        joints.back().push_back(of_roots[i].second);
    }
    return joints;
}

// --- which of them are joined

// Joins those first that go on straightest.
void pair_many(std::span<const Element> elements, const std::vector<std::uint32_t>& joint,
               std::vector<std::uint32_t>& partners) {
    std::vector<double> angles;
    std::set<std::pair<double, std::size_t>> free;  // by the angle at which they leave
    for (std::size_t i = 0; i < joint.size(); ++i) {
        const Vec away = direction_from(elements, joint[i]);
        angles.push_back(elementary::atan2(away.y, away.x));
        free.emplace(angles.back(), i);
    }
    struct Turn {
        std::int64_t size = 0;  // in 1e-9 radians, so that rounding does not decide
        std::size_t from = 0, to = 0;

        auto operator<=>(const Turn&) const = default;
    };
    std::priority_queue<Turn, std::vector<Turn>, std::greater<>> turns;
    const auto add_best = [&](std::size_t i) {
        if (free.size() < 2) return;
        const double ahead = angles[i] > 0 ? angles[i] - pi : angles[i] + pi;
        const auto turn_to = [&](std::size_t j) {
            const double apart = std::fabs(angles[j] - ahead);
            return Turn{round_to_whole(std::min(apart, 2 * pi - apart) * 1e9), i, j};
        };
        const auto around = [&](auto at) { return at == free.end() ? free.begin() : at; };
        const auto before = [&](auto at) { return std::prev(at == free.begin() ? free.end() : at); };
        const auto split = free.lower_bound({ahead, 0});
        auto up = around(split), down = before(split);
        if (up->second == i) up = around(std::next(up));
        if (down->second == i) down = before(down);
        turns.push(std::min(turn_to(up->second), turn_to(down->second)));
    };
    for (std::size_t i = 0; i < joint.size(); ++i) add_best(i);
    while (!turns.empty()) {
        const auto [size, i, j] = turns.top();
        turns.pop();
        if (!free.contains({angles[i], i})) continue;
        if (!free.contains({angles[j], j})) {
            add_best(i);
            continue;
        }
        free.erase({angles[i], i});
        free.erase({angles[j], j});
        partners[joint[i]] = joint[j];
        partners[joint[j]] = joint[i];
    }
}

// The end that each end is joined to, or none.
std::vector<std::uint32_t> partners_of(std::span<const Element> elements, double tolerance,
                                       std::span<const std::uint32_t> groups) {
    std::vector<std::uint32_t> partners(2 * elements.size(), none);
    for (const std::vector<std::uint32_t>& joint : joints_of(elements, tolerance, groups)) {
        if (joint.size() == 2) {
            partners[joint[0]] = joint[1];
            partners[joint[1]] = joint[0];
        } else if (joint.size() > 2) {
            pair_many(elements, joint, partners);
        }
    }
    return partners;
}

// --- paths

void append_arc(Path& path, const Element& e, bool is_forward, Vec to) {
    const double turn = e.to - e.from;
    // SVG's arcs know their ends, and their centres badly near half a turn and near a whole one.
    const bool is_split = std::fabs(turn - pi) < 0.01 || turn > 2 * pi - 0.1;
    const Vec radii{length(e.at[1]), length(e.at[2])};
    const double rotation = elementary::atan2(e.at[1].y, e.at[1].x) * (180 / pi);
    const double flags = (!is_split && turn > pi ? 1 : 0) + (is_forward ? 2 : 0);
    const auto append = [&](Vec end) {
        path.verbs.push_back(Verb::arc);
        path.points.insert(path.points.end(), {radii, {rotation, flags}, end});
    };
    if (is_split) append(point_at(e, e.from + 0.5 * turn));
    append(to);
}

// From where the path ends; `to` is the element's end there, but for the tolerance.
void append_element(Path& path, const Element& e, bool is_forward, Vec to) {
    switch (e.kind) {
        case ElementKind::point:
            break;
        case ElementKind::line:
            path.verbs.push_back(Verb::line);
            path.points.push_back(to);
            break;
        case ElementKind::parabola:
            path.verbs.push_back(Verb::quadratic);
            path.points.insert(path.points.end(), {e.at[1], to});
            break;
        case ElementKind::cubic:
            path.verbs.push_back(Verb::cubic);
            path.points.insert(path.points.end(), {e.at[is_forward ? 1 : 2], e.at[is_forward ? 2 : 1], to});
            break;
        case ElementKind::arc:
            append_arc(path, e, is_forward, to);
            break;
    }
}

// Of ends that run on, each the beginning of its element on the way.
JoinedPath joined_path(std::span<const Element> elements, const std::vector<std::uint32_t>& begins, bool is_closed) {
    JoinedPath made;
    const Vec start = place_of(elements, begins.front());
    made.path.verbs.push_back(Verb::move);
    made.path.points.push_back(start);
    for (const std::uint32_t begin : begins) {
        made.joined.push_back(begin / 2);
        const Element& e = elements[begin / 2];
        const bool is_last = is_closed && made.joined.size() == begins.size();
        if (is_last && e.kind == ElementKind::line) break;  // what closes the path is this line
        append_element(made.path, e, begin % 2 == 0, is_last ? start : place_of(elements, begin ^ 1U));
    }
    if (is_closed) made.path.verbs.push_back(Verb::close);
    return made;
}

std::vector<std::uint32_t> groups_by_ink(std::span<const Element> elements) {
    std::vector<std::pair<std::uint32_t, double>> inks;
    for (const Element& e : elements) inks.emplace_back(e.layer, e.weight);
    std::sort(inks.begin(), inks.end());
    inks.erase(std::unique(inks.begin(), inks.end()), inks.end());
    std::vector<std::uint32_t> groups;
    for (const Element& e : elements) {
        const auto found = std::lower_bound(inks.begin(), inks.end(), std::pair(e.layer, e.weight));
        groups.push_back(static_cast<std::uint32_t>(found - inks.begin()));
    }
    return groups;
}

}  // namespace

std::vector<Element> elements_of(const Path& path, std::uint32_t layer, double weight) {
    std::vector<Element> elements;
    const auto add = [&](Element e) {
        e.layer = layer;
        e.weight = weight;
        elements.push_back(e);
    };
    const auto add_line = [&](Vec from, Vec to) {
        if (from != to) add(line_element(from, to));
    };
    Vec start, here;
    std::size_t at = 0;
    for (const Verb verb : path.verbs) {
        const std::size_t count = point_count(verb);
        if (path.points.size() - at < count) break;
        const Vec* const p = path.points.data() + at;
        switch (verb) {
            case Verb::move:
                start = p[0];
                break;
            case Verb::line:
                add_line(here, p[0]);
                break;
            case Verb::quadratic:
                add(parabola_element(here, p[0], p[1]));
                break;
            case Verb::cubic:
                add(cubic_element(here, p[0], p[1], p[2]));
                break;
            case Verb::arc: {
                const CentreArc arc = centre_arc(here, p, p[2]);
                if (arc.is_line) {
                    add_line(here, p[2]);
                } else {
                    const elementary::CosSin begin = elementary::cos_sin(arc.start);
                    const Vec centre = here - arc.across * begin.cos - arc.along * begin.sin;
                    add(arc_element(centre, arc.across, arc.along, arc.start, arc.start + arc.turn));
                }
                break;
            }
            case Verb::close:
                add_line(here, start);
                break;
        }
        at += count;
        here = verb == Verb::close ? start : path.points[at - 1];
    }
    return elements;
}

std::vector<JoinedPath> paths_of(std::span<const Element> elements, double tolerance,
                                 std::span<const std::uint32_t> groups) {
    std::vector<std::uint32_t> by_ink;
    if (groups.empty()) {
        by_ink = groups_by_ink(elements);
        groups = by_ink;
    }
    const std::vector<std::uint32_t> partners = partners_of(elements, tolerance, groups);
    std::vector<JoinedPath> paths;
    std::vector<bool> is_used(elements.size(), false);
    std::vector<std::uint32_t> begins;
    for (std::uint32_t e = 0; e < elements.size(); ++e) {
        if (is_used[e] || elements[e].kind == ElementKind::point) continue;
        std::uint32_t first = 2 * e;
        while (partners[first] != none && partners[first] / 2 != e) first = partners[first] ^ 1U;
        begins.clear();
        const bool is_cycle = partners[first] != none;
        std::uint32_t begin = is_cycle ? 2 * e : first;
        do {
            begins.push_back(begin);
            is_used[begin / 2] = true;
            begin = partners[begin ^ 1U];
        } while (begin != none && !is_used[begin / 2]);
        paths.push_back(joined_path(elements, begins, is_cycle || is_closed(elements[e])));
    }
    return paths;
}

}  // namespace filigree::curves
