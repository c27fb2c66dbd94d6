#include "plane/inset_front.h"

#include <algorithm>
#include <cstdint>

namespace filigree {

namespace {

// Below this |n1 + n2|^2, two lines run against each other and their corner is at no certain place.
constexpr double opposite = 1e-18;

struct FrontEdge {
    Vec direction, normal;
    // The corner where it starts: at `start` by the time `since`, then moving.
    Vec start, velocity;
    double since = 0;
    std::uint32_t previous = 0, next = 0;
    std::uint32_t version = 0;  // raised whenever one of its corners changes
};

struct Event {
    double time = 0;
    std::uint32_t edge = 0, version = 0;

    bool operator<(const Event& other) const {  // the heap keeps the greatest on top: the first event
        return time != other.time ? time > other.time : edge > other.edge;
    }
};

class Advance {
public:
    Advance(std::span<const Vec> ring, double distance, const JoinRule& rule) : distance_(distance) {
        build(ring, rule);
        start();
    }

    Front run() {
        while (!heap_.empty() && count_ > 0) {
            const Event event = heap_.front();
            std::pop_heap(heap_.begin(), heap_.end());
            heap_.pop_back();
            if (edges_[event.edge].version != event.version) continue;
            collapse(event.edge, event.time);
        }
        if (count_ > 0) {
            front_.ring.reserve(count_);
            std::uint32_t e = some_;
            for (std::uint32_t i = 0; i < count_; ++i, e = edges_[e].next)
                front_.ring.push_back(start_at(e, distance_));
        }
        return std::move(front_);
    }

private:
    void build(std::span<const Vec> ring, const JoinRule& rule) {
        edges_.reserve(ring.size() + ring.size() / 4);
        std::vector<Vec> fill;
        const Vec closing = ring.front() - ring.back();
        const Vec first_in = closing * (1 / length(closing));
        Vec in = first_in;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec along = (i + 1 < ring.size() ? ring[i + 1] : ring[0]) - ring[i];
            const Vec out = i + 1 < ring.size() ? along * (1 / length(along)) : first_in;
            fill.clear();
            append_fill(in, out, rule, fill);
            for (const Vec normal : fill) add(-perpendicular(normal), normal, ring[i]);
            add(out, perpendicular(out), ring[i]);
            in = out;
        }
    }

    void add(Vec direction, Vec normal, Vec at) {
        FrontEdge edge;
        edge.direction = direction;
        edge.normal = normal;
        edge.start = at;
        edges_.push_back(edge);
    }

    void start() {
        count_ = static_cast<std::uint32_t>(edges_.size());
        std::vector<std::uint32_t> spikes;
        for (std::uint32_t e = 0; e < count_; ++e) {
            FrontEdge& edge = edges_[e];
            edge.previous = e == 0 ? count_ - 1 : e - 1;
            edge.next = e + 1 == count_ ? 0 : e + 1;
            const Vec sum = edges_[edge.previous].normal + edge.normal;
            if (dot(sum, sum) <= opposite) {
                spikes.push_back(e);
            } else {
                edge.velocity = corner_velocity(edges_[edge.previous].normal, edge.normal);
            }
        }
        for (const std::uint32_t e : spikes) {
            if (is_out(e) || count_ == 0) continue;
            join(edges_[e].previous, e, edges_[e].start, 0);
        }
        if (count_ == 0) return;
        std::uint32_t e = some_;
        for (std::uint32_t i = 0; i < count_; ++i, e = edges_[e].next) schedule(e);
    }

    Vec start_at(std::uint32_t e, double time) const {
        return edges_[e].start + edges_[e].velocity * (time - edges_[e].since);
    }
    bool is_out(std::uint32_t e) const { return edges_[e].next == e; }

    void take_out(std::uint32_t e, Vec at, double time) {
        FrontEdge& edge = edges_[e];
        edges_[edge.previous].next = edge.next;
        edges_[edge.next].previous = edge.previous;
        if (some_ == e) some_ = edge.next;
        edge.next = e;
        ++edge.version;
        --count_;
        front_.events.push_back({at, time});
    }

    void schedule(std::uint32_t e) {
        const FrontEdge& edge = edges_[e];
        const FrontEdge& next = edges_[edge.next];
        const double growth = dot(next.velocity - edge.velocity, edge.direction);
        if (!(growth < 0)) return;
        const double now = std::max(edge.since, next.since);
        const double extent = dot(start_at(edge.next, now) - start_at(e, now), edge.direction);
        const double time = extent > 0 ? now - extent / growth : now;
        if (!(time <= distance_)) return;
        heap_.push_back({time, e, edge.version});
        std::push_heap(heap_.begin(), heap_.end());
    }

    void collapse(std::uint32_t e, double time) {
        const std::uint32_t previous = edges_[e].previous;
        const std::uint32_t next = edges_[e].next;
        // Of the two corners that meet, the slower one is the more certain.
        const bool first_is_slower =
            dot(edges_[e].velocity, edges_[e].velocity) <= dot(edges_[next].velocity, edges_[next].velocity);
        const Vec at = first_is_slower ? start_at(e, time) : start_at(next, time);
        take_out(e, at, time);
        join(previous, next, at, time);
    }

    // Makes a corner of two edges that have come together.
    void join(std::uint32_t a, std::uint32_t b, Vec at, double time) {
        while (true) {
            if (count_ < 3) {
                count_ = 0;
                return;
            }
            const Vec sum = edges_[a].normal + edges_[b].normal;
            if (dot(sum, sum) > opposite) break;
            // Two walls of a corridor have met: all of it is gone up to where the shorter one ends.
            const Vec start = start_at(a, time);
            const Vec end = start_at(edges_[b].next, time);
            if (dot(at - start, at - start) <= dot(end - at, end - at)) {
                const std::uint32_t before = edges_[a].previous;
                take_out(a, start, time);
                a = before;
                at = start;
            } else {
                const std::uint32_t after = edges_[b].next;
                take_out(b, end, time);
                b = after;
                at = end;
            }
        }
        edges_[b].start = at;
        edges_[b].velocity = corner_velocity(edges_[a].normal, edges_[b].normal);
        edges_[b].since = time;
        ++edges_[a].version;
        ++edges_[b].version;
        schedule(a);
        schedule(b);
    }

    double distance_;
    std::vector<FrontEdge> edges_;
    std::vector<Event> heap_;
    Front front_;
    std::uint32_t count_ = 0;  // of the edges still there; 0 once the ring has vanished
    std::uint32_t some_ = 0;   // one of them
};

}  // namespace

Front advance_front(std::span<const Vec> ring, double distance, const JoinRule& rule) {
    return Advance(ring, distance, rule).run();
}

}  // namespace filigree
