#include "engines/rewriting/turtle.h"

#include <utility>

#include "engines/rewriting/turtle_letters.h"
#include "engines/rewriting/turtle_walk.h"

namespace filigree::rewriting {
namespace {

class Drawer {
public:
    Drawer(TurtleDrawing& drawing, const TurtleLetters& letters, const Word& word)
        : drawing_(drawing), letters_(letters), word_(word) {}

    template <class Walk>
    void before(std::size_t, Walk&) {}

    template <class Walk>
    void step(std::size_t at, Act act, Vec3 from, Walk& walk) {
        const TurtleState& state = walk.state();
        if (act == Act::line) {
            drawing_.segments.push_back({from, state.position, walk.frame(), state.width, state.colour, at});
        } else if (act == Act::shape) {
            drawing_.shapes.push_back(
                {from, walk.frame(), state.scale, letters_.names[word_.symbols[at]], state.width, state.colour, at});
        }
        if (!open_.empty()) corners_.push_back(state.position);
    }

    template <class Walk>
    void begin_polygon(std::size_t at, Walk& walk) {
        const TurtleState& state = walk.state();
        open_.push_back({corners_.size(), 0, state.width, state.colour, at});
        corners_.push_back(state.position);
    }

    // An inner polygon's corners lie behind those of the outer one so far.
    void end_polygon() {
        if (open_.empty()) return;
        TurtlePolygon polygon = open_.back();
        open_.pop_back();
        const auto first = corners_.begin() + static_cast<std::ptrdiff_t>(polygon.first);
        auto last = corners_.end();
        while (last - first > 1 && *(last - 1) == *first) --last;
        if (last - first >= 3) {
            polygon.first = drawing_.corners.size();
            polygon.count = static_cast<std::uint64_t>(last - first);
            drawing_.corners.insert(drawing_.corners.end(), first, last);
            drawing_.polygons.push_back(polygon);
        }
        corners_.erase(first, corners_.end());
    }
    void end() {
        while (!open_.empty()) end_polygon();
    }

private:
    TurtleDrawing& drawing_;
    const TurtleLetters& letters_;
    const Word& word_;
    std::vector<TurtlePolygon> open_;
    std::vector<Vec3> corners_;  // of all that are open
};

struct Places {
    const Word& word;
    std::vector<Vec> positions;

    template <class Walk>
    void before(std::size_t at, Walk& walk) {
        if (word.symbols[at] == Alphabet::freeze) return;
        positions.push_back({walk.state().position.x, walk.state().position.y});
    }
    template <class Walk>
    void step(std::size_t, Act, Vec3, Walk&) {}
    template <class Walk>
    void begin_polygon(std::size_t, Walk&) {}
    void end_polygon() {}
};

}  // namespace

Result<TurtleDrawing> turtle_drawing(const Word& word, const Alphabet& alphabet, const TurtleSettings& settings,
                                     std::uint64_t most_elements, TurtleDrawing reuse) {
    if (auto wrong = check_settings(settings, alphabet)) return *std::move(wrong);
    TurtleLetters letters = turtle_letters(alphabet, settings);
    const TurtleCounts counts = count_acts(word, alphabet, letters);
    const std::uint64_t elements = counts.segments + counts.shapes + counts.corners;
    if (elements > most_elements) return too_much_to_draw(elements, "segments, shapes and corners", most_elements);
    if (counts.deepest > most_elements) return too_much_to_draw(counts.deepest, "nested brackets", most_elements);

    TurtleDrawing drawing;
    const auto take = [](auto& into, auto& from) {
        into = std::move(from);
        into.clear();
    };
    take(drawing.segments, reuse.segments);
    take(drawing.shapes, reuse.shapes);
    take(drawing.polygons, reuse.polygons);
    take(drawing.corners, reuse.corners);
    drawing.segments.reserve(counts.segments);
    drawing.shapes.reserve(counts.shapes);
    drawing.polygons.reserve(counts.polygons);
    drawing.corners.reserve(counts.corners);
    drawing.stray_closings = counts.stray_closings;
    drawing.unclosed = counts.unclosed;
    drawing.stray_polygon_ends = counts.stray_polygon_ends;
    drawing.unclosed_polygons = counts.unclosed_polygons;
    Drawer drawer(drawing, letters, word);
    TurtleWalk<Drawer> walk(word, letters, counts, settings, drawer);
    if (auto problem = walk.run()) return *std::move(problem);
    drawer.end();
    drawing.shape_names = std::move(letters.shape_names);
    drawing.end = walk.state().position;
    drawing.end_frame = walk.frame();
    return drawing;
}

Result<std::vector<Vec>> symbol_positions(const Word& word, const Alphabet& alphabet, const TurtleSettings& settings,
                                          std::uint64_t most_elements) {
    if (auto wrong = check_settings(settings, alphabet)) return *std::move(wrong);
    const TurtleLetters letters = turtle_letters(alphabet, settings);
    const TurtleCounts counts = count_acts(word, alphabet, letters);
    if (word.size() > most_elements) return too_much_to_draw(word.size(), "symbols", most_elements);
    Places places{word, {}};
    places.positions.reserve(word.size());
    TurtleWalk<Places> walk(word, letters, counts, settings, places);
    if (auto problem = walk.run()) return *std::move(problem);
    return std::move(places.positions);
}

}  // namespace filigree::rewriting
