// Path data of polygons and curves in as few bytes as is sensible: relative commands, whole multiples of 10^-decimals.
//
// Guarantee: each point is the exact grid point, rounded half away from zero; every step is the difference of
// two rounded points, so rounding never adds up. No doubles take part. About 60 million coordinates a second.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "plane/path.h"
#include "plane/polygon.h"

namespace filigree {

// A text that grows by large steps, with room to write into directly.
class TextBuffer {
public:
    void reserve(std::size_t bytes) { grow_to(bytes); }
    // At least `bytes` writable characters; `advance` says how many were used.
    char* room(std::size_t bytes) {
        if (text_.size() - size_ < bytes) grow_to(size_ + bytes);
        return text_.data() + size_;
    }
    void advance_to(const char* end) { size_ = static_cast<std::size_t>(end - text_.data()); }
    void put(std::string_view text);
    void put(char c) { *room(1) = c, ++size_; }
    std::size_t size() const { return size_; }
    std::string take() &&;

private:
    void grow_to(std::size_t bytes);

    std::string text_;      // longer than what is written
    std::size_t size_ = 0;  // what is written
};

// A coordinate in units of 10^-decimals (0..6), rounded half away from zero.
std::int64_t rounded_coordinate(std::int64_t grid, int decimals);

// The data of one polygon: `m x y dx dy ... z` a ring. Points that round to the same place are written once; a
// hole that rounds to fewer than three points is left out, an outer ring never is. `from` is where the path stands
// (rounded; the first move is relative to it), the result where it stands then.
Point put_path_data(TextBuffer& out, PolygonView polygon, int decimals, Point from = {});

// The same of an open line, without a `z`; one that rounds to a single point is a line of no length.
Point put_line_data(TextBuffer& out, RingView line, int decimals, Point from = {});

// The same of a path, by its own commands; of arcs see svg_arcs.h. Its subpaths must begin with a move, and all points
// lie on the plane.
Point put_curve_data(TextBuffer& out, const Path& path, int decimals, Point from = {});

}  // namespace filigree
