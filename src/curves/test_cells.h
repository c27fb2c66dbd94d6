// For tests alone: shapes told as cells of a few known curves, where every operation is one on arrays. What is drawn of
// them is pieces in any number, order and direction, one over the other; what the algebra makes of the pieces must be
// what the arrays say.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "curves/test_shapes.h"

namespace filigree::curves {

// Random curves no two of which share a descriptor, each cut into cells of equal parameter; some start where another
// ends.
struct World {
    static constexpr std::size_t cells = 16;
    std::vector<Element> curves;
};

inline bool may_share_descriptor(const Element& a, const Element& b) {
    if (a.kind != b.kind) return false;
    if (a.kind == ElementKind::line) {
        return std::fabs(cross(a.at[1] - a.at[0], b.at[0] - a.at[0])) < 0.1 &&
               std::fabs(cross(a.at[1] - a.at[0], b.at[1] - a.at[0])) < 0.1;
    }
    return length(a.at[0] - b.at[0]) < 0.01 &&
           (a.kind == ElementKind::point || (a.kind == ElementKind::arc && length(a.at[1] - b.at[1]) < 0.01));
}

inline World random_world(CaseRandom& random, Coordinates in) {
    World world;
    const std::size_t count = 1 + random.index(5);
    for (std::size_t i = 0; i < count; ++i) {
        Element e = random_element(random, all_kinds[random.index(5)], in);
        if (!world.curves.empty() && e.kind != ElementKind::point && random.coin()) {
            e = transformed(e, translation(ends_of(world.curves.back()).second - ends_of(e).first));
        }
        e.layer = random.below(2);
        const auto is_apart = [&](const Element& other) { return !may_share_descriptor(e, other); };
        if (std::all_of(world.curves.begin(), world.curves.end(), is_apart)) world.curves.push_back(e);
    }
    return world;
}

// The weight of each cell of each curve, 0 where there is nothing; of a point the first cell alone.
using Cells = std::vector<std::vector<double>>;

inline Cells random_cells(CaseRandom& random, const World& world, std::uint32_t weights = 1) {
    Cells cells;
    for (const Element& curve : world.curves) {
        std::vector<double> own(World::cells, 0);
        if (curve.kind == ElementKind::point) {
            own[0] = random.below(weights + 1);
        } else {
            for (int run = static_cast<int>(random.below(4)); run >= 0; --run) {
                const std::size_t from = random.index(World::cells), to = from + random.index(World::cells - from + 1);
                const double weight = random.below(weights + 1);
                std::fill(own.begin() + static_cast<std::ptrdiff_t>(from),
                          own.begin() + static_cast<std::ptrdiff_t>(to), weight);
            }
        }
        cells.push_back(std::move(own));
    }
    return cells;
}

inline Cells combined(const Cells& a, const Cells& b, const std::function<double(double, double)>& by) {
    Cells cells = a;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t k = 0; k < a[i].size(); ++k) cells[i][k] = by(a[i][k], b[i][k]);
    }
    return cells;
}

inline Element cell_piece(const World& world, std::size_t curve, double from, double to, double weight) {
    const Element& e = world.curves[curve];
    const Interval own = interval_of(e);
    const double size = (own.to - own.from) / World::cells;
    Element piece = e.kind == ElementKind::point ? e : piece_of(e, {own.from + from * size, own.from + to * size});
    piece.weight = weight;
    return piece;
}

// The maximal elements, as runs of cells of one weight.
inline std::vector<Element> runs_of(const World& world, const Cells& cells) {
    std::vector<Element> runs;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::vector<double>& own = cells[i];
        if (world.curves[i].kind == ElementKind::point) {
            if (own[0] > 0) runs.push_back(cell_piece(world, i, 0, 1, own[0]));
            continue;
        }
        const bool is_ring = is_closed(world.curves[i]);
        const std::size_t count = own.size();
        std::size_t first = 0;  // where some run begins
        if (is_ring) {
            while (first < count && own[first] == own[(first + count - 1) % count]) ++first;
            if (first == count) {
                if (own[0] > 0) runs.push_back(cell_piece(world, i, 0, World::cells, own[0]));
                continue;
            }
        }
        for (std::size_t k = first; k < first + count;) {
            std::size_t end = k + 1;
            while (end < first + count && own[end % count] == own[k % count]) ++end;
            if (own[k % count] > 0) {
                runs.push_back(cell_piece(world, i, static_cast<double>(k), static_cast<double>(end), own[k % count]));
            }
            k = end;
        }
    }
    return runs;
}

// Pieces that show the cells: parts of the runs that overlap or touch, and lighter ones under them.
inline std::vector<Element> drawn(CaseRandom& random, const World& world, const Cells& cells, double shake = 0) {
    std::vector<Element> pieces;
    const auto add = [&](std::size_t curve, double from, double to, double weight) {
        Element piece = cell_piece(world, curve, from, to, weight);
        if (random.coin()) piece = reversed(piece);
        if (shake > 0) piece = shaken(piece, random, shake);
        pieces.push_back(piece);
        if (random.below(8) == 0) pieces.push_back(piece);
    };
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::vector<double>& own = cells[i];
        if (world.curves[i].kind == ElementKind::point) {
            if (own[0] > 0) add(i, 0, 1, own[0]);
            if (own[0] > 1) add(i, 0, 1, 1);
            continue;
        }
        // A run with the cells around it that are at least as heavy.
        for (std::size_t k = 0; k < own.size();) {
            std::size_t end = k + 1;
            while (end < own.size() && own[end] == own[k]) ++end;
            if (own[k] > 0) {
                double low = static_cast<double>(k), high = static_cast<double>(end);
                while (low > 0 && own[static_cast<std::size_t>(low) - 1] >= own[k] && random.coin()) --low;
                while (high < static_cast<double>(own.size()) && own[static_cast<std::size_t>(high)] >= own[k] &&
                       random.coin()) {
                    ++high;
                }
                // Cuts that may lie anywhere, each piece going on a little over the next cut.
                double at = low;
                while (at < high) {
                    const double quarter = 0.25 * (1 + random.below(20));
                    const double next = random.below(3) == 0 ? high : std::min(high, at + quarter);
                    add(i, at, std::min(high, next + (random.coin() ? 0 : 0.125 * random.below(8))), own[k]);
                    at = next;
                }
            }
            k = end;
        }
    }
    for (std::size_t i = pieces.size(); i > 1; --i) std::swap(pieces[i - 1], pieces[random.index(i)]);
    return pieces;
}

inline std::string told(const Element& e) {
    std::string text = "kind " + std::to_string(static_cast<int>(e.kind)) + " layer " + std::to_string(e.layer) +
                       " weight " + to_text(e.weight) + ":";
    for (const Vec p : e.at) text += " (" + to_text(p.x) + "," + to_text(p.y) + ")";
    return text + " " + to_text(e.from) + ".." + to_text(e.to);
}

// What is wrong with elements that should be these, in any order and to within a distance; empty where nothing is.
inline std::string difference_to(const std::vector<Element>& found, const std::vector<Element>& wanted, double within) {
    std::string text;
    const auto is_same = [&](const Element& a, const Element& b) {
        if (a.kind != b.kind || a.layer != b.layer || a.weight != b.weight || is_closed(a) != is_closed(b))
            return false;
        const auto [a0, a1] = ends_of(a);
        const auto [b0, b1] = ends_of(b);
        if (!is_closed(a) && std::max(length(a0 - b0), length(a1 - b1)) > within &&
            std::max(length(a0 - b1), length(a1 - b0)) > within) {
            return false;
        }
        for (const auto& [e, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
            const Interval on = interval_of(*e);
            for (int i = 1; i < 4; ++i) {
                if (!lies_on(*other, point_at(*e, on.from + (on.to - on.from) * i / 4), within)) return false;
            }
        }
        return true;
    };
    std::vector<bool> is_taken(found.size());
    for (const Element& e : wanted) {
        std::size_t i = 0;
        while (i < found.size() && (is_taken[i] || !is_same(e, found[i]))) ++i;
        if (i == found.size()) {
            text += "missing " + told(e) + "\n";
        } else {
            is_taken[i] = true;
        }
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!is_taken[i]) text += "not wanted " + told(found[i]) + "\n";
    }
    return text;
}

}  // namespace filigree::curves
