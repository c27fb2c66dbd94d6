#include "session/pick_symbol.h"

#include <algorithm>
#include <string>

#include "engines/rewriting/explain.h"
#include "plane/edge_tree.h"
#include "session/explain_word.h"

namespace filigree {
namespace {

using rewriting::TurtleDrawing;
using rewriting::TurtleSegment;

constexpr double line_reach = 1;  // px beside a line that still mean it

double line_distance(RingView line, Vec at) {
    double nearest = 1e300;
    for (std::size_t i = 1; i < line.size(); ++i) {
        nearest = std::min(nearest, squared_distance({to_px(line[i - 1]), to_px(line[i])}, at));
    }
    return std::sqrt(nearest);
}

bool is_hit(const Drawing& drawing, const DrawnShape& shape, Vec at) {
    const Style& style = drawing.styles[shape.style];
    const PolygonView polygon = polygon_of(drawing, shape);
    if (!style.is_open) return locate(polygon, snap(at)) >= 0;
    return line_distance(polygon.outer(), at) <= style.pen / 2 + line_reach;
}

// The shape that is painted last there.
std::optional<std::size_t> shape_at(const Drawing& drawing, Vec at) {
    for (std::size_t s = drawing.shapes.size(); s-- > 0;) {
        if (is_hit(drawing, drawing.shapes[s], at)) return s;
    }
    return std::nullopt;
}

// The symbol whose stretch of a line is nearest.
std::uint64_t nearest_symbol(const TurtleDrawing& turtled, const rewriting::PagePlace& place, Vec at) {
    double nearest = 1e300;
    std::uint64_t symbol = 0;
    for (const TurtleSegment& segment : turtled.segments) {
        const double distance = squared_distance({place(segment.from), place(segment.to)}, at);
        if (distance > nearest) continue;  // of two that lie on each other the later is seen
        nearest = distance;
        symbol = segment.symbol;
    }
    return symbol;
}

// The rules that put the symbol and those that it descends from, the last first. An edit of the word loses the track.
void add_ancestors(Picked& picked, const OpenedDocument& opened, const CheckedDocument& checked, const WordRun& word,
                   const WordPlace& place, std::uint64_t index) {
    if (!checked.words->edits.empty()) return;
    const rewriting::Derivation& derivation = word.derivation;
    rewriting::DeriveOptions options = word_options(opened, checked);
    options.seed = word.seed;
    options.root = place.root;
    options.choices = derivation.choices;
    const Result<rewriting::Explanation> explained =
        rewriting::explain(*checked.words, options, derivation.iteration, index, {});
    if (!explained) return;
    const std::vector<rewriting::SymbolMoment>& moments = explained->moments;
    for (std::size_t m = moments.size() - 1; m > 0; --m) {
        const rewriting::Rule* rule = moments[m - 1].rule;
        if (rule == nullptr) continue;
        const SaidRule said = said_at(opened, rule->span);
        PickedStep step;
        step.path = place.prefix + "iteration " + std::to_string(moments[m].iteration);
        step.document = opened.name;
        step.rule = rewriting::to_utf8(std::u32string(1, rule->letter));
        step.operation = said.text;
        step.line = said.line;
        step.key = rule->key;
        picked.steps.push_back(std::move(step));
    }
}

}  // namespace

std::optional<Picked> pick_symbol(const OpenedDocument& opened, const CheckedDocument& checked, const WordRun& word,
                                  const WordPlace& place, Vec at) {
    const rewriting::DrawRules& rules = *checked.draw_rules;
    const Settings& settings = *checked.settings;
    const rewriting::Derivation& derivation = word.derivation;
    const Result<rewriting::Picture> picture =
        rewriting::draw(derivation, rules, settings, opened.document, {place.root, checked.shapes.get(), {}});
    if (!picture) return std::nullopt;
    const std::optional<std::size_t> shape = shape_at(picture->drawing, at);
    if (!shape) return std::nullopt;
    const DrawnShape& drawn = picture->drawing.shapes[*shape];
    const bool is_line = picture->drawing.styles[drawn.style].is_open;
    std::uint64_t symbol = picture->symbols.empty() ? 0 : picture->symbols[*shape];
    if (is_line && !picture->is_in_space) {
        Diagnostics problems;
        const Result<TurtleDrawing> turtled = rewriting::turtle_drawing(
            derivation.word, derivation.alphabet,
            rewriting::turtle_settings(rules, derivation.iteration, settings, opened.document, problems));
        if (turtled) symbol = nearest_symbol(*turtled, picture->place, at);
    }
    const auto begin = derivation.word.symbols.begin();
    const auto freezes = std::count(begin, begin + static_cast<std::ptrdiff_t>(symbol), rewriting::Alphabet::freeze);
    const std::uint64_t index = symbol - static_cast<std::uint64_t>(freezes);
    const rewriting::SymbolEntry& entry = derivation.alphabet[derivation.word.symbols[symbol]];
    Picked picked;
    picked.path = place.prefix + "word/" + std::to_string(index + 1);
    picked.tag = rewriting::to_utf8(std::u32string(1, entry.letter));
    picked.key = drawn.key;
    if (!is_line) picked.area = area(polygon_of(picture->drawing, drawn));
    add_ancestors(picked, opened, checked, word, place, index);
    return picked;
}

}  // namespace filigree
