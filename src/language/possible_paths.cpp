#include "language/possible_paths.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/diagnostic.h"

namespace filigree {

namespace {

using Kind = PathSegment::Kind;

PathSegment named(std::string_view name) { return {Kind::name, std::string(name), {}}; }

// --- walking ----------------------------------------------------------------------------------------------------

// The graph with a place before the roots and one below each group for its single shapes. Places are numbers: nodes
// first, then the shapes of each node, then the start.
using Places = std::vector<std::uint32_t>;  // ascending, each once

class PathWalk {
public:
    explicit PathWalk(const PathGraph& graph)
        : graph_(graph), nodes_(static_cast<std::uint32_t>(graph.nodes.size())), start_(2 * nodes_) {}

    Places start() const { return {start_}; }
    bool is_node(std::uint32_t place) const { return place < nodes_; }
    bool is_shape(std::uint32_t place) const { return place >= nodes_ && place < start_; }
    std::uint32_t group_of(std::uint32_t shape) const { return shape - nodes_; }
    const PathNode& node(std::uint32_t place) const { return graph_.nodes[place]; }

    // The nodes below a place, in the order of the graph.
    const std::vector<std::uint32_t>& below(std::uint32_t place) const {
        if (place == start_) return graph_.roots;
        return node(is_node(place) ? place : group_of(place)).next;
    }

    bool matches(std::uint32_t node_place, const PathSegment& segment) const {
        const PathNode& found = node(node_place);
        if (segment.kind == Kind::any) return true;
        if (segment.kind != Kind::name || segment.name != found.segment) return false;
        // The only group of its kind is the first.
        return segment.ordinals.empty() || found.has_ordinals || (found.is_group && segment.ordinals.front() == 1);
    }

    // Where one segment leads from these places.
    Places follow(const Places& from, const PathSegment& segment) const {
        Places to;
        if (segment.kind == Kind::any_depth) return all_below(from);
        for (const std::uint32_t place : from) {
            for (const std::uint32_t next : below(place)) {
                if (matches(next, segment)) to.push_back(next);
            }
            const bool takes_shapes = segment.kind == Kind::shapes || segment.kind == Kind::any;
            if (takes_shapes && is_node(place) && node(place).is_group) to.push_back(nodes_ + place);
        }
        std::sort(to.begin(), to.end());
        to.erase(std::unique(to.begin(), to.end()), to.end());
        return to;
    }

private:
    Places all_below(const Places& from) const {
        std::vector<bool> is_reached(start_ + 1, false);
        Places open, to;
        const auto reach = [&](std::uint32_t place) {
            if (is_reached[place]) return;
            is_reached[place] = true;
            open.push_back(place);
        };
        for (const std::uint32_t place : from) reach(place);
        while (!open.empty()) {
            const std::uint32_t place = open.back();
            open.pop_back();
            to.push_back(place);
            for (const std::uint32_t next : below(place)) reach(next);
            if (is_node(place) && node(place).is_group) reach(nodes_ + place);
        }
        std::sort(to.begin(), to.end());
        return to;
    }

    const PathGraph& graph_;
    std::uint32_t nodes_ = 0, start_ = 0;
};

bool has_parameter(const PathNode& node, std::string_view parameter) {
    return std::find(node.parameters.begin(), node.parameters.end(), parameter) != node.parameters.end();
}

// --- repairing --------------------------------------------------------------------------------------------------

using Names = std::vector<std::string_view>;

// Names in the order in which they were added, each once.
class NameList {
public:
    void add(std::string_view name) {
        if (known_.insert(name).second) names.push_back(name);
    }
    Names names;

private:
    std::set<std::string_view> known_;
};

class PathRepair {
public:
    PathRepair(const PathGraph& graph, const ChoicePath& path) : walk_(graph), path_(path), reached_{walk_.start()} {}

    // There must be a root.
    ChoicePath repaired() {
        out_.span = path_.span;
        for (std::size_t i = 0; i < path_.segments.size(); ++i) {
            if (add(path_.segments[i])) continue;
            for (const PathSegment& segment : repairs(i)) add(segment);
        }
        if (out_.segments.empty()) add(named(names_below().front()));
        if (!path_.parameter.empty()) repair_parameter();
        return std::move(out_);
    }

private:
    // False where the segment leads nowhere. Dropping what stood between two `**` must not leave both.
    bool add(const PathSegment& segment) {
        const bool is_doubled =
            segment.kind == Kind::any_depth && !out_.segments.empty() && out_.segments.back().kind == Kind::any_depth;
        if (is_doubled) return true;
        Places next = walk_.follow(reached_.back(), segment);
        if (next.empty()) return false;
        reached_.push_back(std::move(next));
        out_.segments.push_back(segment);
        return true;
    }

    bool leads_on(const PathSegment& segment) const { return !walk_.follow(reached_.back(), segment).empty(); }

    Names names_below() const {
        NameList list;
        for (const std::uint32_t place : reached_.back()) {
            for (const std::uint32_t next : walk_.below(place)) list.add(walk_.node(next).segment);
        }
        return list.names;
    }

    // The first node below what is reached that the caller wants.
    template <typename Wanted>
    std::optional<std::uint32_t> first_below(const Wanted& wanted) const {
        for (const std::uint32_t place : reached_.back()) {
            for (const std::uint32_t next : walk_.below(place)) {
                if (wanted(next)) return next;
            }
        }
        return std::nullopt;
    }

    // What to put in the place of a segment that leads nowhere: one segment, two, or none.
    std::vector<PathSegment> repairs(std::size_t i) const {
        const PathSegment& segment = path_.segments[i];
        if (segment.kind != Kind::name) return {};
        if (leads_on(named(segment.name))) return {named(segment.name)};
        const Names names = names_below();
        if (names.empty()) return {};

        PathSegment nearest = segment;
        nearest.name = nearest_name(segment.name, names);
        if (!nearest.name.empty()) return {leads_on(nearest) ? nearest : named(nearest.name)};

        const auto left_out = first_below([&](std::uint32_t node) {
            const auto& below = walk_.below(node);
            return std::any_of(below.begin(), below.end(),
                               [&](std::uint32_t next) { return walk_.matches(next, segment); });
        });
        if (left_out) return {named(walk_.node(*left_out).segment), segment};

        const bool is_last = i + 1 == path_.segments.size();
        const bool is_surplus = !is_last && path_.segments[i + 1].kind == Kind::name && leads_on(path_.segments[i + 1]);
        if (is_surplus) return {};
        return {named(names.front())};
    }

    Names parameters_at(const Places& places) const {
        NameList list;
        for (const std::uint32_t place : places) {
            if (!walk_.is_node(place)) continue;
            for (const std::string& parameter : walk_.node(place).parameters) list.add(parameter);
        }
        return list.names;
    }

    // Segments are dropped from the end where nothing has parameters.
    void repair_parameter() {
        const std::string& wanted = path_.parameter;
        out_.draw = path_.draw;
        for (std::size_t count = out_.segments.size(); count > 0; --count) {
            const Names names = parameters_at(reached_[count]);
            const bool is_there = std::find(names.begin(), names.end(), wanted) != names.end();
            out_.parameter = is_there ? wanted : std::string(nearest_name(wanted, names));
            if (out_.parameter.empty() && count == out_.segments.size()) {
                const auto left_out =
                    first_below([&](std::uint32_t node) { return has_parameter(walk_.node(node), wanted); });
                if (left_out) {
                    out_.segments.push_back(named(walk_.node(*left_out).segment));
                    out_.parameter = wanted;
                    return;
                }
            }
            if (out_.parameter.empty() && !names.empty()) out_.parameter = names.front();
            if (!out_.parameter.empty()) {
                out_.segments.resize(count);
                return;
            }
        }
        out_.draw = 0;
    }

    const PathWalk walk_;
    const ChoicePath& path_;
    ChoicePath out_;
    std::vector<Places> reached_;  // behind each segment of out_; the first before all
};

// --- telling why ------------------------------------------------------------------------------------------------

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

// The segments before one, as text; empty at the start.
std::string text_before(const ChoicePath& path, std::size_t end) {
    ChoicePath before;
    before.segments.assign(path.segments.begin(), path.segments.begin() + static_cast<std::ptrdiff_t>(end));
    return to_text(before);
}

std::string why_not(const PathWalk& walk, const Places& reached, const ChoicePath& path, std::size_t failing) {
    const PathSegment& segment = path.segments[failing];
    const std::string before = text_before(path, failing);
    const std::string where = failing == 0 ? " at the start" : " below " + quoted(before);
    if (segment.kind == Kind::any) return "nothing stands" + where;
    if (segment.kind == Kind::shapes) {
        return failing == 0 ? "a path begins with a name, not with a shape's number"
                            : quoted(before) + " is no group, so it has no shapes";
    }
    if (!walk.follow(reached, named(segment.name)).empty()) {
        return "there are not several " + quoted(segment.name) + where + ", so they have no numbers";
    }
    return "nothing called " + quoted(segment.name) + " stands" + where;
}

}  // namespace

PathCheck check_path(const PathGraph& graph, const ChoicePath& path) {
    const PathWalk walk(graph);
    const std::size_t count = path.segments.size();
    PathCheck out;
    Places reached = walk.start();
    for (; out.failing < count; ++out.failing) {
        Places next = walk.follow(reached, path.segments[out.failing]);
        if (next.empty()) break;
        reached = std::move(next);
    }
    if (graph.roots.empty()) {
        out.failing = 0;
        out.why = "there is nothing that a path could name";
        return out;
    }
    if (out.failing < count) {
        out.why = why_not(walk, reached, path, out.failing);
    } else {
        for (const std::uint32_t place : reached) {
            if (walk.is_node(place)) {
                if (path.parameter.empty() || has_parameter(walk.node(place), path.parameter))
                    out.ends.push_back(place);
            } else if (walk.is_shape(place) && path.parameter.empty()) {
                out.shapes_of.push_back(walk.group_of(place));
            }
        }
        out.possible = !out.ends.empty() || !out.shapes_of.empty();
        if (!out.possible) {
            out.why = quoted(text_before(path, count)) + " has no parameter called " + quoted(path.parameter);
        }
    }
    if (!out.possible) out.nearest = to_text(nearest_path(graph, path));
    return out;
}

ChoicePath nearest_path(const PathGraph& graph, const ChoicePath& path) {
    return graph.roots.empty() ? ChoicePath{} : PathRepair(graph, path).repaired();
}

}  // namespace filigree
