#include "formats/svg_path_data.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "formats/svg_arcs.h"
#include "plane/arc.h"

namespace filigree {
namespace {

constexpr std::uint64_t grid_bits = 26;
constexpr std::uint64_t fraction_mask = (1U << grid_bits) - 1;
constexpr std::array<std::uint64_t, 7> powers_of_ten = {1, 10, 100, 1000, 10'000, 100'000, 1'000'000};
// The longest step is the difference of two coordinates: sign, 13 digits, point, 6 digits; and a separator.
constexpr std::size_t longest_number = 24;
constexpr std::size_t longest_verb = 256 * longest_number;  // an arc as forty cubics

struct Digits {
    char text[3];
    std::uint8_t without_zeros;  // how many remain when zeros at the end are cut
    std::uint8_t leading;        // where the first digit that is not zero stands (2 for 000)
};
constexpr std::array<Digits, 1000> make_digits() {
    std::array<Digits, 1000> table{};
    for (int i = 0; i < 1000; ++i) {
        Digits& d = table[static_cast<std::size_t>(i)];
        d.text[0] = static_cast<char>('0' + i / 100);
        d.text[1] = static_cast<char>('0' + i / 10 % 10);
        d.text[2] = static_cast<char>('0' + i % 10);
        d.without_zeros = i % 10 != 0 ? 3 : i % 100 != 0 ? 2 : 1;
        d.leading = i >= 100 ? 0 : i >= 10 ? 1 : 2;
    }
    return table;
}
constexpr std::array<Digits, 1000> digits = make_digits();

char* put_whole(char* to, std::uint64_t value) {
    if (value < 1000) {
        const Digits& d = digits[value];
        for (std::uint8_t i = d.leading; i < 3; ++i) *to++ = d.text[i];
        return to;
    }
    to = put_whole(to, value / 1000);
    std::memcpy(to, digits[value % 1000].text, 3);
    return to + 3;
}

// Puts the digits after the point; `fraction` is in units of 10^-decimals and not 0.
template <int decimals>
char* put_fraction(char* to, std::uint64_t fraction) {
    if constexpr (decimals <= 3) {
        const Digits& d = digits[fraction * powers_of_ten[3 - decimals]];
        std::memcpy(to, d.text, 3);
        return to + d.without_zeros;
    } else {
        const std::uint64_t scaled = fraction * powers_of_ten[6 - decimals];
        const Digits& high = digits[scaled / 1000];
        const Digits& low = digits[scaled % 1000];
        std::memcpy(to, high.text, 3);
        if (scaled % 1000 == 0) return to + high.without_zeros;
        std::memcpy(to + 3, low.text, 3);
        return to + 3 + low.without_zeros;
    }
}

template <int decimals>
std::int64_t rounded(std::int64_t grid) {
    constexpr std::uint64_t unit = powers_of_ten[decimals];
    const std::uint64_t size = grid < 0 ? 0 - static_cast<std::uint64_t>(grid) : static_cast<std::uint64_t>(grid);
    const std::uint64_t fraction = ((size & fraction_mask) * unit + (std::uint64_t{1} << (grid_bits - 1))) >> grid_bits;
    const auto result = static_cast<std::int64_t>((size >> grid_bits) * unit + fraction);
    return grid < 0 ? -result : result;
}

template <int decimals>
class PathDataWriter {
public:
    PathDataWriter(TextBuffer& out, Point from) : out_(out), current_(from) {}

    Point put(PolygonView polygon) {
        for (std::size_t r = 0; r < polygon.ring_count(); ++r) put(polygon.ring(r), r > 0);
        return current_;
    }
    Point put_line(RingView line) {
        if (!line.empty()) put_points(line, true);
        return current_;
    }
    Point put_curve(const Path& path) {
        Vec start, here;  // before rounding
        Point rounded_start = current_;
        bool is_dot = false;  // the subpath, so far
        std::size_t at = 0;
        const auto end_dot = [&] {  // else nothing would be drawn
            if (!std::exchange(is_dot, false)) return;
            to_ = out_.room(longest_number);
            command('h');
            number(0);
            out_.advance_to(to_);
        };
        for (const Verb verb : path.verbs) {
            const Vec* points = path.points.data() + at;
            at += point_count(verb);
            if (verb == Verb::move) end_dot();
            char* const begin = to_ = out_.room(longest_verb);
            const Vec to = verb == Verb::close ? start : points[point_count(verb) - 1];
            put(verb, here, points);
            if (verb == Verb::move) {
                start = to;
                rounded_start = current_;
            }
            if (verb == Verb::close) current_ = rounded_start;
            is_dot = verb == Verb::move || (is_dot && to_ == begin);
            here = to;
            out_.advance_to(to_);
        }
        end_dot();
        return current_;
    }

private:
    void put(Verb verb, Vec here, const Vec* points) {
        switch (verb) {
            case Verb::move:
                command('m');
                put_places(points, 1);
                command_ = 'l';  // what pairs after a move mean
                break;
            case Verb::line:
                put_line_to(points[0]);
                break;
            case Verb::quadratic:
                put_bezier('q', points, 2);
                break;
            case Verb::cubic:
                put_bezier('c', points, 3);
                break;
            case Verb::arc:
                put_arc(here, points, points[2]);
                break;
            case Verb::close:
                command('z');
                break;
        }
    }

    void put_line_to(Vec to) {
        const Point next = rounded_point(snap(to));
        step(next.x - current_.x, next.y - current_.y);
        current_ = next;
    }

    void put_bezier(char letter, const Vec* points, std::size_t count) {
        const bool is_point =
            std::all_of(points, points + count, [this](Vec p) { return rounded_point(snap(p)) == current_; });
        if (is_point) return;
        if (command_ != letter) command(letter);
        put_places(points, count);
    }

    void put_arc(Vec from, const Vec shape[2], Vec to) {
        const CentreArc arc = centre_arc(from, shape, to);
        if (arc.is_line) return put_line_to(to);
        if (const auto rounded = rounded_arcs(arc, shape[1].x, to, current_, decimals)) {
            for (const RoundedArc& piece : *rounded) put_arc(piece);
            return;
        }
        Path cubics;
        append_cubics(cubics, arc, to);
        for (std::size_t i = 0; i < cubics.points.size(); i += 3) put_bezier('c', &cubics.points[i], 3);
    }

    void put_arc(const RoundedArc& arc) {
        if (command_ != 'a') command('a');
        number(arc.rx);
        number(arc.ry);
        degrees(arc.rotation);
        constexpr auto one = static_cast<std::int64_t>(powers_of_ten[decimals]);
        number(arc.is_large ? one : 0);
        number(arc.is_sweep ? one : 0);
        number(arc.to.x - current_.x);
        number(arc.to.y - current_.y);
        current_ = arc.to;
    }

    // All from where the path stands, which is then the last.
    void put_places(const Vec* points, std::size_t count) {
        Point place;
        for (std::size_t i = 0; i < count; ++i) {
            place = rounded_point(snap(points[i]));
            number(place.x - current_.x);
            number(place.y - current_.y);
        }
        current_ = place;
    }

    void put(RingView ring, bool is_hole) {
        std::size_t count = ring.size();
        if (count == 0) return;
        const Point start = rounded_point(ring[0]);
        while (count > 1 && rounded_point(ring[count - 1]) == start) --count;
        if (is_hole && has_fewer_than_three_places(ring.first(count))) return;
        put_points(ring.first(count), false);
        current_ = start;
    }

    void put_points(RingView points, bool is_line) {
        const Point start = rounded_point(points[0]);
        to_ = out_.room(2 * longest_number * (points.size() + 1));
        command('m');
        number(start.x - current_.x);
        number(start.y - current_.y);
        command_ = 'l';  // what pairs after a move mean
        current_ = start;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Point next = rounded_point(points[i]);
            step(next.x - current_.x, next.y - current_.y);
            current_ = next;
        }
        if (!is_line) {
            command('z');
        } else if (command_ == 'l' && current_ == start) {  // else nothing would be drawn
            command('h');
            number(0);
        }
        out_.advance_to(to_);
    }

    static Point rounded_point(Point p) { return {rounded<decimals>(p.x), rounded<decimals>(p.y)}; }

    static bool has_fewer_than_three_places(RingView ring) {
        std::size_t places = 0;
        Point last;
        for (const Point p : ring) {
            const Point place = rounded_point(p);
            if (places > 0 && place == last) continue;
            last = place;
            if (++places == 3) return false;
        }
        return true;
    }

    void step(std::int64_t dx, std::int64_t dy) {
        if (dy == 0) {
            if (dx == 0) return;
            if (command_ != 'h') command('h');
            number(dx);
        } else if (dx == 0) {
            if (command_ != 'v') command('v');
            number(dy);
        } else {
            if (command_ != 'l') command('l');
            number(dx);
            number(dy);
        }
    }

    void command(char c) {
        *to_++ = c;
        command_ = c;
        after_ = After::command;
    }

    // A number ends where the next cannot belong to it: before a sign, and before a second point.
    void number(std::int64_t value) {
        constexpr std::uint64_t unit = powers_of_ten[decimals];
        std::uint64_t size = static_cast<std::uint64_t>(value);
        if (value < 0) {
            *to_++ = '-';
            size = 0 - size;
        }
        const std::uint64_t whole = size / unit, fraction = size % unit;
        const bool starts_with_point = whole == 0 && fraction != 0;
        if (value >= 0 && (after_ == After::whole || (after_ == After::fraction && !starts_with_point))) *to_++ = ' ';
        if (!starts_with_point) to_ = put_whole(to_, whole);
        if (fraction != 0) {
            *to_++ = '.';
            to_ = put_fraction<decimals>(to_, fraction);
        }
        after_ = fraction != 0 ? After::fraction : After::whole;
    }

    void degrees(double value) {
        std::string text;
        append_fixed(text, value, 9);
        if (text[0] != '-') *to_++ = ' ';
        std::memcpy(to_, text.data(), text.size());
        to_ += text.size();
        after_ = After::whole;
    }

    enum class After { command, whole, fraction };
    TextBuffer& out_;
    char* to_ = nullptr;
    Point current_;  // in units of 10^-decimals
    char command_ = 0;
    After after_ = After::command;
};

}  // namespace

void TextBuffer::put(std::string_view text) {
    if (text.empty()) return;
    std::memcpy(room(text.size()), text.data(), text.size());
    size_ += text.size();
}

std::string TextBuffer::take() && {
    text_.resize(size_);
    return std::move(text_);
}

void TextBuffer::grow_to(std::size_t bytes) {
    if (bytes > text_.size()) text_.resize(std::max(bytes, text_.size() * 2));
}

std::int64_t rounded_coordinate(std::int64_t grid, int decimals) {
    switch (decimals) {
        case 0:
            return rounded<0>(grid);
        case 1:
            return rounded<1>(grid);
        case 2:
            return rounded<2>(grid);
        case 3:
            return rounded<3>(grid);
        case 4:
            return rounded<4>(grid);
        case 5:
            return rounded<5>(grid);
        default:
            return rounded<6>(grid);
    }
}

namespace {

// Calls `put` with a writer for so many decimals.
template <class Put>
Point with_writer(TextBuffer& out, int decimals, Point from, Put put) {
    switch (decimals) {
        case 0:
            return put(PathDataWriter<0>(out, from));
        case 1:
            return put(PathDataWriter<1>(out, from));
        case 2:
            return put(PathDataWriter<2>(out, from));
        case 3:
            return put(PathDataWriter<3>(out, from));
        case 4:
            return put(PathDataWriter<4>(out, from));
        case 5:
            return put(PathDataWriter<5>(out, from));
        default:
            return put(PathDataWriter<6>(out, from));
    }
}

}  // namespace

Point put_path_data(TextBuffer& out, PolygonView polygon, int decimals, Point from) {
    return with_writer(out, decimals, from, [&](auto writer) { return writer.put(polygon); });
}
Point put_line_data(TextBuffer& out, RingView line, int decimals, Point from) {
    return with_writer(out, decimals, from, [&](auto writer) { return writer.put_line(line); });
}
Point put_curve_data(TextBuffer& out, const Path& path, int decimals, Point from) {
    return with_writer(out, decimals, from, [&](auto writer) { return writer.put_curve(path); });
}

}  // namespace filigree
