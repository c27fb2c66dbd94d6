#include "scene/lettering.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/elementary.h"
#include "base/unicode.h"
#include "plane/clean.h"

namespace filigree {
namespace {

constexpr double units_a_capital = 20;
constexpr double tolerance_units = 0.04;

// What a side of a letter needs beside it for an even colour: a stem most, a bowl less, an open or slanting
// side least.
constexpr double stem = 3.5;
constexpr double bowl = 2.7;
constexpr double open = 1.8;
constexpr double slant = 1.2;

struct Glyph {
    char character;
    double left, ink, right;  // units: the side bearings, and the width of the strokes between them
    const char* strokes;      // SVG path data in units; x from the ink's left end, y from the baseline
};

// Capitals reach up to -20, small letters to -14, ascenders to -22; descenders to 6. Where a bowl leaves a stem it
// does so at an angle, by an arc of a larger radius, so that the two do not clot.
constexpr std::array<Glyph, 95> alphabet{{
    {' ', 0, 6.5, 0, ""},
    {'!', stem, 0, stem, "M0-20V-6.5M-.4-.4a.4.4 0 1 1 .8 0a.4.4 0 1 1-.8 0z"},
    {'"', stem, 4, stem, "M0-20V-14.5M4-20V-14.5"},
    {'#', open, 14, open, "M5-19.5L2.6-.5M11.4-19.5L9-.5M1-13.2H14M0-6.8H13"},
    {'$', bowl, 11.8, bowl,
     "M10.23-17.68A5 4.65 0 0 0 .9-15.35A5 4.65 0 0 0 4.07-11.02L8.26-9.49A5.9 4.95 0 0 1 5.9 0"
     "A5.9 4.95 0 0 1 .79-2.48M5.9-22.8V2.8"},
    {'%', bowl, 17, bowl,
     "M0-15.4A3.6 4.6 0 1 1 7.2-15.4A3.6 4.6 0 1 1 0-15.4ZM9.8-4.6A3.6 4.6 0 1 1 17-4.6A3.6 4.6 0 1 1 9.8-4.6Z"
     "M13.8-20L3.2 0"},
    {'&', bowl, 14, slant, "M14 0L3.45-13.54A4 4 0 1 1 8.14-12.31L3.52-10.38A5.4 5.4 0 1 0 10.67-3.55L12.3-8"},
    {'\'', stem, 0, stem, "M0-20V-14.5"},
    {'(', bowl, 4, open, "M4-22A26.5 26.5 0 0 0 4 6"},
    {')', open, 4, bowl, "M0-22A26.5 26.5 0 0 1 0 6"},
    {'*', open, 9, open, "M4.5-20V-10M.17-17.5L8.83-12.5M8.83-17.5L.17-12.5"},
    {'+', bowl, 11.6, bowl, "M0-8.5H11.6M5.8-14.3V-2.7"},
    {',', bowl, 1.3, stem, "M1.3-.8L0 3.4"},
    {'-', open, 7, open, "M0-7.5H7"},
    {'.', stem, 0, stem, "M-.4-.4a.4.4 0 1 1 .8 0a.4.4 0 1 1-.8 0z"},
    {'/', slant, 9, slant, "M0 3L9-22"},
    {'0', bowl, 12, bowl, "M0-10A6 10 0 1 1 12-10A6 10 0 1 1 0-10Z"},
    {'1', bowl, 5, stem, "M0-16.4L5-20V0"},
    {'2', open, 11.3, open, "M.08-15.54A5.4 5.4 0 0 1 10.8-14.6A5.4 5.4 0 0 1 9.5-11.09L0 0H11.3"},
    {'3', open, 10.9, bowl,
     "M.94-17.29A4.7 4.7 0 0 1 5.2-20A4.7 4.7 0 0 1 5.2-10.6H4M5.2-10.6A5.7 5.3 0 0 1 5.2 0A5.7 5.3 0 0 1 .03-3.06"},
    {'4', open, 13, open, "M9.4 0V-20L0-5.6H13"},
    {'5', open, 11.3, bowl, "M10.3-20H1.7L.49-10.68A6.2 6.4 0 1 1 .02-2.73"},
    {'6', bowl, 12, bowl, "M9.4-20A17 17 0 0 0 0-6.2A6 6.2 0 1 0 12-6.2A6 6.2 0 0 0 .6-8.9"},
    {'7', open, 11.4, slant, "M0-20H11.4L3.6 0"},
    {'8', bowl, 11.6, bowl,
     "M5.8-10.7A4.7 4.65 0 1 1 5.8-20A4.7 4.65 0 1 1 5.8-10.7ZM5.8-10.7A5.8 5.35 0 1 0 5.8 0A5.8 5.35 0 1 0 5.8-10.7Z"},
    {'9', bowl, 12, bowl, "M2.6 0A17 17 0 0 0 12-13.8A6 6.2 0 1 0 0-13.8A6 6.2 0 0 0 11.4-11.1"},
    {':', stem, 0, stem, "M-.4-.4a.4.4 0 1 1 .8 0a.4.4 0 1 1-.8 0zM-.4-10.8a.4.4 0 1 1 .8 0a.4.4 0 1 1-.8 0z"},
    {';', bowl, 1.3, stem, "M1.3-.8L0 3.4M.9-10.8a.4.4 0 1 1 .8 0a.4.4 0 1 1-.8 0z"},
    {'<', open, 11, open, "M11-14L0-8.5L11-3"},
    {'=', bowl, 11.6, bowl, "M0-11.1H11.6M0-5.9H11.6"},
    {'>', open, 11, open, "M0-14L11-8.5L0-3"},
    {'?', open, 9.9, bowl,
     "M.2-16A4.9 4.9 0 0 1 9.9-15.1A4.9 4.9 0 0 1 7.6-10.95A5 5 0 0 0 5.25-6.7M4.85-.4a.4.4 0 1 1 .8 0a.4.4 0 1 1-.8 "
     "0z"},
    {'@', bowl, 20, bowl,
     "M14.3-9A4.3 4.3 0 1 1 5.7-9A4.3 4.3 0 1 1 14.3-9ZM14.3-13.3V-7.6A2.85 2.85 0 0 0 20-7.6V-9A10 10 0 1 0 15-.34"},
    {'A', slant, 16, slant, "M0 0L8-20L16 0M2.6-6.5H13.4"},
    {'B', stem, 12, bowl, "M0 0V-20H5.9A4.9 4.9 0 0 1 5.9-10.2H0M5.9-10.2H6.9A5.1 5.1 0 0 1 6.9 0H0"},
    {'C', bowl, 15.2, open, "M15.2-16.86A8.8 10 0 1 0 15.2-3.14"},
    {'D', stem, 14.6, bowl, "M0-20V0H4.8A9.8 10 0 0 0 4.8-20Z"},
    {'E', stem, 11, open, "M11-20H0V0H11M0-10.2H9.6"},
    {'F', stem, 10.6, open, "M10.6-20H0V0M0-10.2H9.2"},
    {'G', bowl, 16, bowl, "M15.2-16.86A8.8 10 0 1 0 16-4.25V-9.4H10.2"},
    {'H', stem, 14, stem, "M0-20V0M14-20V0M0-10.2H14"},
    {'I', stem, 0, stem, "M0-20V0"},
    {'J', open, 7.5, stem, "M7.5-20V-5A5 5 0 0 1 0-.67"},
    {'K', stem, 13, slant, "M0-20V0M12.2-20L0-7.6M4-11.67L13 0"},
    {'L', stem, 10.4, open, "M0-20V0H10.4"},
    {'M', stem, 17, stem, "M0 0V-20L8.5-2.6L17-20V0"},
    {'N', stem, 14, stem, "M0 0V-20L14 0V-20"},
    {'O', bowl, 18, bowl, "M0-10A9 10 0 1 1 18-10A9 10 0 1 1 0-10Z"},
    {'P', stem, 11.8, bowl, "M0 0V-20H6.2A5.6 5.6 0 0 1 6.2-8.8H0"},
    {'Q', bowl, 18, bowl, "M0-10A9 10 0 1 1 18-10A9 10 0 1 1 0-10ZM10.6-5.4L17.4 2"},
    {'R', stem, 12.8, slant, "M0 0V-20H6.3A5.5 5.5 0 0 1 6.3-9H0M6.1-9L12.8 0"},
    {'S', bowl, 11.8, bowl,
     "M10.23-17.68A5 4.65 0 0 0 .9-15.35A5 4.65 0 0 0 4.07-11.02L8.26-9.49A5.9 4.95 0 0 1 5.9 0"
     "A5.9 4.95 0 0 1 .79-2.48"},
    {'T', slant, 14, slant, "M0-20H14M7-20V0"},
    {'U', stem, 14, stem, "M0-20V-7A7 7 0 0 0 14-7V-20"},
    {'V', slant, 15.6, slant, "M0-20L7.8 0L15.6-20"},
    {'W', slant, 22, slant, "M0-20L5.5 0L11-20L16.5 0L22-20"},
    {'X', slant, 13.6, slant, "M.5-20L13.6 0M13.1-20L0 0"},
    {'Y', slant, 14.4, slant, "M0-20L7.2-9.4V0M14.4-20L7.2-9.4"},
    {'Z', open, 13.2, open, "M.4-20H12.8L0 0H13.2"},
    {'[', stem, 4.2, open, "M4.2-22H0V6H4.2"},
    {'\\', slant, 9, slant, "M0-22L9 3"},
    {']', open, 4.2, stem, "M0-22H4.2V6H0"},
    {'^', open, 9.6, open, "M0-13.4L4.8-20L9.6-13.4"},
    {'_', slant, 12, slant, "M0 3H12"},
    {'`', open, 3.6, open, "M0-21.5L3.6-17.5"},
    {'a', open, 10.2, stem,
     "M.9-12.4A8 8 0 0 1 5.5-14A4.7 4.7 0 0 1 10.2-9.3V0M10.2-8.2H4.6A4.1 4.1 0 0 0 4.6 0A7.5 7.5 0 0 0 10.2-2.8"},
    {'b', stem, 12, bowl, "M0-22V0M0-11A7.5 7.5 0 0 1 6-14A6 7 0 0 1 6 0A7.5 7.5 0 0 1 0-3"},
    {'c', bowl, 10.6, open, "M10.6-11.93A6.2 7 0 1 0 10.6-2.07"},
    {'d', bowl, 12, stem, "M12-22V0M12-11A7.5 7.5 0 0 0 6-14A6 7 0 0 0 6 0A7.5 7.5 0 0 0 12-3"},
    {'e', bowl, 12, bowl, "M0-7H12A6 7 0 1 0 10.6-2.51"},
    {'f', slant, 7.6, slant, "M7.6-22H6.9A3.9 3.9 0 0 0 3-18.1V0M0-14H7"},
    {'g', bowl, 12, stem,
     "M12-11A7.5 7.5 0 0 0 6-14A6 7 0 0 0 6 0A7.5 7.5 0 0 0 12-3M12-14V.5A5.5 5.5 0 0 1 6.5 6A8 8 0 0 1 1.5 4.2"},
    {'h', stem, 10.8, stem, "M0-22V0M0-11A7.5 7.5 0 0 1 6-14A4.8 4.8 0 0 1 10.8-9.2V0"},
    {'i', stem, 0, stem, "M0-14V0M-.4-19.3a.4.4 0 1 1 .8 0a.4.4 0 1 1-.8 0z"},
    {'j', slant, 4.2, stem, "M4.2-14V2A4 4 0 0 1 .2 6H0M3.8-19.3a.4.4 0 1 1 .8 0a.4.4 0 1 1-.8 0z"},
    {'k', stem, 10.2, slant, "M0-22V0M9.4-14L0-5.2M3.3-8.29L10.2 0"},
    {'l', stem, 3.6, open, "M0-22V-3A3 3 0 0 0 3 0H3.6"},
    {'m', stem, 17.6, stem,
     "M0-14V0M0-11A5.34 5.34 0 0 1 4.8-14A4 4 0 0 1 8.8-10V0M8.8-10.6A5.09 5.09 0 0 1 13.6-14A4 4 0 0 1 17.6-10V0"},
    {'n', stem, 10.8, stem, "M0-14V0M0-11A7.5 7.5 0 0 1 6-14A4.8 4.8 0 0 1 10.8-9.2V0"},
    {'o', bowl, 12.4, bowl, "M0-7A6.2 7 0 1 1 12.4-7A6.2 7 0 1 1 0-7Z"},
    {'p', stem, 12, bowl, "M0-14V6M0-11A7.5 7.5 0 0 1 6-14A6 7 0 0 1 6 0A7.5 7.5 0 0 1 0-3"},
    {'q', bowl, 12, stem, "M12-14V6M12-11A7.5 7.5 0 0 0 6-14A6 7 0 0 0 6 0A7.5 7.5 0 0 0 12-3"},
    {'r', stem, 6.6, slant, "M0-14V0M0-10.5A6.07 6.07 0 0 1 5.5-14H6.6"},
    {'s', bowl, 9.2, bowl,
     "M7.98-12.38A3.9 3.25 0 0 0 .7-10.75A3.9 3.25 0 0 0 3.12-7.74L6.5-6.59A4.6 3.45 0 0 1 4.6 0"
     "A4.6 3.45 0 0 1 .62-1.73"},
    {'t', slant, 7.6, open, "M3-19V-3.8A3.8 3.8 0 0 0 6.8 0H7.6M0-14H7.2"},
    {'u', stem, 10.8, stem, "M0-14V-4.8A4.8 4.8 0 0 0 4.8 0A7.5 7.5 0 0 0 10.8-3M10.8-14V0"},
    {'v', open, 11.2, open, "M0-14L5.6 0L11.2-14"},
    {'w', open, 17.2, open, "M0-14L4.3 0L8.6-14L12.9 0L17.2-14"},
    {'x', open, 10.4, open, "M.3-14L10.4 0M10.1-14L0 0"},
    {'y', open, 11.2, open, "M0-14L5.6 0M11.2-14L3.2 6"},
    {'z', open, 9.8, open, "M.3-14H9.5L0 0H9.8"},
    {'{', open, 5, open, "M5-22A3 3 0 0 0 2-19V-10A2 2 0 0 1 0-8A2 2 0 0 1 2-6V3A3 3 0 0 0 5 6"},
    {'|', stem, 0, stem, "M0-22V6"},
    {'}', open, 5, open, "M0-22A3 3 0 0 1 3-19V-10A2 2 0 0 0 5-8A2 2 0 0 0 3-6V3A3 3 0 0 1 0 6"},
    {'~', bowl, 12, bowl, "M0-7A3.6 3.6 0 0 1 6-8.5A3.6 3.6 0 0 0 12-10"},
}};
constexpr Glyph missing{'\0', stem, 9, stem, "M0-14H9V0H0Z"};

constexpr bool is_in_order() {
    for (std::size_t i = 0; i < alphabet.size(); ++i) {
        if (alphabet[i].character != static_cast<char>(' ' + i)) return false;
    }
    return true;
}
static_assert(is_in_order());

constexpr double advance(const Glyph& glyph) { return glyph.left + glyph.ink + glyph.right; }

// Calls `use` with each character's glyph.
template <class Use>
void for_glyphs(std::string_view text, const Use& use) {
    for (std::size_t at = 0; at < text.size();) {
        const unicode::Decoded decoded = unicode::decode(text, at);
        at += decoded.length;
        const bool is_known = decoded.code_point >= ' ' && decoded.code_point <= '~';
        use(is_known ? alphabet[decoded.code_point - ' '] : missing);
    }
}

// The outline that a round pen leaves on each side of a line. On the inner side of a corner it goes through the
// corner itself: it is then the sum of the boundaries of all segments' rectangles and all corners' sectors, each
// turning the same way, so that exactly their union has a winding number other than zero.
class PenOutline {
public:
    PenOutline(double radius, double tolerance)
        : radius_(radius), step_(std::clamp(std::sqrt(8 * tolerance / radius), 0.01, elementary::pi / 3)) {}

    void outline(const Polyline& line, std::vector<Polyline>& out) {
        const std::vector<Vec>& points = line.points;
        const std::size_t count = points.size();
        if (count == 0) return;
        std::vector<Vec> back(points.rbegin(), points.rend());
        if (line.closed && count > 2) {
            for (const std::vector<Vec>& side : {points, back}) {
                for (std::size_t i = 0; i < count; ++i) {
                    add_corner(side[i], unit(side[(i + count - 1) % count], side[i]),
                               unit(side[i], side[(i + 1) % count]));
                }
                finish(out);
            }
            return;
        }
        // There and back again, with a half turn at each end.
        if (count == 1) {
            add_corner(points[0], {1, 0}, {-1, 0});
            add_corner(points[0], {-1, 0}, {1, 0});
        }
        for (const std::vector<Vec>& side : {points, back}) {
            for (std::size_t i = 1; i < count; ++i) {
                const Vec along = unit(side[i - 1], side[i]);
                add_corner(side[i], along, i + 1 < count ? unit(side[i], side[i + 1]) : -along);
            }
        }
        finish(out);
    }

private:
    static Vec unit(Vec from, Vec to) { return (to - from) * (1 / length(to - from)); }

    // The pen keeps to the left of the way.
    void add_corner(Vec corner, Vec before, Vec after) {
        const Vec from = -radius_ * perpendicular(before), to = -radius_ * perpendicular(after);
        const double turn = elementary::atan2(cross(before, after), dot(before, after));
        outline_.points.push_back(corner + from);
        if (turn < 0) {
            outline_.points.push_back(corner);
        } else {
            const double pieces = std::ceil(turn / step_);
            for (double i = 1; i < pieces; ++i) {
                const elementary::CosSin by = elementary::cos_sin(turn * (i / pieces));
                outline_.points.push_back(corner + by.cos * from + by.sin * perpendicular(from));
            }
        }
        outline_.points.push_back(corner + to);
    }

    void finish(std::vector<Polyline>& out) {
        outline_.closed = true;
        out.push_back(std::move(outline_));
        outline_ = {};
    }

    double radius_;
    double step_;  // radians
    Polyline outline_;
};

}  // namespace

std::vector<Polyline> lettering_strokes(std::string_view utf8, Vec at, double height) {
    std::vector<Polyline> strokes;
    if (!(height > 0) || !is_on_plane({height, 0}) || !is_on_plane(at)) return strokes;
    const double unit = height / units_a_capital;
    double x = 0;  // units
    for_glyphs(utf8, [&](const Glyph& glyph) {
        const Result<Path> path = parse_path_data(glyph.strokes);
        const Transform to_place{unit, 0, 0, unit, at.x + unit * (x + glyph.left), at.y};
        for (Polyline& line : flatten(transformed(*path, to_place), unit * tolerance_units)) {
            strokes.push_back(std::move(line));
        }
        x += advance(glyph);
    });
    return strokes;
}

double lettering_width(std::string_view utf8, double height) {
    double x = 0;
    for_glyphs(utf8, [&](const Glyph& glyph) { x += advance(glyph); });
    return x * (height / units_a_capital);
}

Polygons lettering(std::string_view utf8, Vec at, const LetteringStyle& style) {
    if (!(style.pen > 0) || !is_on_plane({style.pen, 0})) return {};
    std::vector<Polyline> outlines;
    PenOutline pen(style.pen / 2, style.height / units_a_capital * tolerance_units);
    for (const Polyline& stroke : lettering_strokes(utf8, at, style.height)) pen.outline(stroke, outlines);
    return clean(outlines, FillRule::nonzero);
}

}  // namespace filigree
