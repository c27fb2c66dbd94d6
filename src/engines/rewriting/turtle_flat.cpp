#include "engines/rewriting/turtle_flat.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "engines/rewriting/turtle_letters.h"
#include "engines/rewriting/turtle_turns.h"

namespace filigree::rewriting {
namespace {

using Symbols = std::span<const Symbol>;

// Headings are fractions of a full turn in 2^64 and wrap by themselves. What a symbol does in the fast loop is one
// number: its turn, with flags in the lowest bits. Adding it as it is takes less than 4 of those fractions too much,
// and a heading begins in the middle of those that stand for its direction: for up to 2^16 directions, it would take
// 2^44 symbols to leave it.
constexpr std::uint64_t line_flag = 1, special_flag = 2, flags = 3;

struct FlatPlan {
    std::array<std::uint64_t, max_symbols> turns{};
    std::uint32_t per_turn = 4;
    std::vector<Vec> steps;  // by direction

    std::uint64_t heading_of(std::uint64_t units) const {
        __extension__ typedef unsigned __int128 Wide;
        return static_cast<std::uint64_t>((static_cast<Wide>(units) << 64) / per_turn) + half_unit();
    }
    std::uint64_t direction_of(std::uint64_t heading) const { return (heading >> 32) * per_turn >> 32; }
    std::uint64_t half_unit() const { return (std::uint64_t{1} << 63) / per_turn; }
};

constexpr std::uint32_t most_directions = 1 << 16;

std::optional<FlatPlan> flat_plan(Symbols word, const TurtleLetters& letters, const TurtleSettings& settings) {
    const TurnScale& scale = letters.scale;
    if (!letters.have_one_length) return std::nullopt;
    if (scale.per_turn == 0 || scale.per_turn > most_directions) return std::nullopt;
    if (scale.per_turn > 1024 && scale.per_turn > word.size()) return std::nullopt;  // more to make than to use
    if (!(std::fabs(settings.step) * static_cast<double>(word.size()) < 1e300)) return std::nullopt;
    FlatPlan plan;
    plan.per_turn = scale.per_turn;
    plan.steps.resize(scale.per_turn);
    for (std::uint32_t units = 0; units < scale.per_turn; ++units) {
        const auto [c, s] = direction_of_units(units, scale.per_turn);
        plan.steps[units] = {settings.step * c, settings.step * s};
    }
    for (std::size_t s = 0; s < max_symbols; ++s) {
        switch (letters.acts[s]) {
            case Act::nothing:
            case Act::select_up:
                break;
            case Act::line:
                plan.turns[s] = line_flag;
                break;
            case Act::plus:
            case Act::minus:
            case Act::less:
            case Act::greater: {
                const auto units = static_cast<std::uint64_t>(letters.turns[s]);
                plan.turns[s] = (plan.heading_of(units) - plan.half_unit()) & ~flags;
                break;
            }
            default:
                plan.turns[s] = special_flag;
        }
    }
    return plan;
}

bool is_flat(Act act) {
    switch (act) {
        case Act::corner:
        case Act::shape:
        case Act::head_z:
        case Act::select_left:
        case Act::select_heading:
        case Act::formula:
        case Act::shrink:
        case Act::begin_polygon:
        case Act::end_polygon:
            return false;
        default:
            return true;
    }
}

// How many symbols draw, may end a line, or are not flat.
struct FlatCounts {
    std::uint64_t lines = 0, breaks = 0, others = 0;
};

// Three sums in one, each of 21 bits.
FlatCounts count_flat(Symbols word, const std::array<Act, max_symbols>& acts) {
    constexpr std::size_t together = 1 << 20;
    constexpr std::uint64_t field = 21, most = (std::uint64_t{1} << field) - 1;
    std::array<std::uint64_t, max_symbols> weights{};
    for (std::size_t s = 0; s < max_symbols; ++s) {
        const Act act = acts[s];
        if (act == Act::line) weights[s] = 1;
        if (act == Act::pop || act == Act::move || act == Act::wider || act == Act::narrower ||
            act == Act::next_colour || act == Act::previous_colour) {
            weights[s] = std::uint64_t{1} << field;
        }
        if (!is_flat(act)) weights[s] = std::uint64_t{1} << 2 * field;
    }
    FlatCounts counts;
    for (std::size_t begin = 0; begin < word.size(); begin += together) {
        const Symbols part = word.subspan(begin, std::min(together, word.size() - begin));
        std::uint64_t a = 0, b = 0, c = 0, d = 0;
        std::size_t i = 0;
        for (; i + 4 <= part.size(); i += 4) {
            a += weights[part[i]], b += weights[part[i + 1]], c += weights[part[i + 2]], d += weights[part[i + 3]];
        }
        for (; i < part.size(); ++i) a += weights[part[i]];
        const std::uint64_t sum = a + b + c + d;
        counts.lines += sum & most;
        counts.breaks += sum >> field & most;
        counts.others += sum >> 2 * field;
    }
    return counts;
}

class FlatWalk {
public:
    FlatWalk(Symbols word, const std::array<Act, max_symbols>& acts, const FlatPlan& plan,
             const TurtleSettings& settings, FlatDrawing& drawing, Vec* points)
        : word_(word), acts_(acts), plan_(plan), settings_(settings), drawing_(drawing), points_(points) {
        state_.width = settings.width;
        state_.heading = plan.heading_of(0);
    }

    std::optional<Diagnostic> run() {
        for (std::size_t at = 0; at < word_.size();) {
            const Symbol symbol = word_[at];
            if ((plan_.turns[symbol] & special_flag) == 0) {
                at = lines_from(at);
            } else if (!act(acts_[symbol])) {
                return out_of_range(at);
            } else {
                ++at;
            }
        }
        end_run();
        drawing_.end = state_.position;
        drawing_.unclosed = outer_.size();
        drawing_.point_count = count_;
        return std::nullopt;
    }

private:
    struct State {
        Vec position;
        std::uint64_t heading = 0;
        double width = 1;
        std::int64_t width_level = 0, colour = 0;
    };
    static constexpr std::size_t together = 1024;  // symbols whose headings lie in the nearest cache

    // Draws what comes before the next special symbol, or a part of it; gives the symbol behind that. Headings go
    // before positions, since additions of doubles wait for each other.
    std::size_t lines_from(std::size_t begin) {
        std::array<std::uint64_t, together> headings;
        const std::uint64_t* const turns = plan_.turns.data();
        const Symbol *symbol = word_.data() + begin, *const end = symbol + std::min(together, word_.size() - begin);
        std::uint64_t heading = state_.heading;
        std::size_t lines = 0;
        for (; symbol != end; ++symbol) {
            const std::uint64_t turn = turns[*symbol];
            if ((turn & special_flag) != 0) break;
            headings[lines] = heading;
            lines += turn & line_flag;
            heading += turn;
        }
        state_.heading = heading;
        if (lines != 0) draw({headings.data(), lines});
        return static_cast<std::size_t>(symbol - word_.data());
    }

    void draw(std::span<const std::uint64_t> headings) {
        begin_run();
        const Vec* const steps = plan_.steps.data();
        const std::uint64_t per_turn = plan_.per_turn;
        Vec* to = points_ + count_;
        double x = state_.position.x, y = state_.position.y;
        for (const std::uint64_t heading : headings) {
            const Vec step = steps[(heading >> 32) * per_turn >> 32];
            x += step.x;
            y += step.y;
            *to++ = {x, y};
        }
        count_ += headings.size();
        state_.position = {x, y};
    }

    void begin_run() {
        if (is_drawing_ && points_[count_ - 1] == state_.position && run_.width == state_.width &&
            run_.colour == state_.colour) {
            return;
        }
        end_run();
        run_ = {count_, 0, state_.width, state_.colour};
        points_[count_++] = state_.position;
        is_drawing_ = true;
    }
    void end_run() {
        if (!is_drawing_) return;
        run_.count = count_ - run_.first;
        drawing_.runs.push_back(run_);
        is_drawing_ = false;
    }

    bool widen(int times) {
        state_.width_level += times;
        state_.width = width_of(settings_, state_.width_level);
        return std::isfinite(state_.width);
    }

    bool act(Act act) {  // false: numbers do not suffice
        switch (act) {
            case Act::move:
                state_.position = state_.position + plan_.steps[plan_.direction_of(state_.heading)];
                return true;
            case Act::head_x:
                state_.heading = plan_.heading_of(0);
                return true;
            case Act::head_y:
                state_.heading = plan_.heading_of(plan_.per_turn / 4);
                return true;
            case Act::push:
                outer_.push_back(state_);
                return true;
            case Act::pop:
                if (outer_.empty()) {
                    ++drawing_.stray_closings;
                    return true;
                }
                state_ = outer_.back();
                outer_.pop_back();
                return true;
            case Act::wider:
                return widen(1);
            case Act::narrower:
                return widen(-1);
            case Act::next_colour:
                ++state_.colour;
                return true;
            case Act::previous_colour:
                --state_.colour;
                return true;
            default:
                return true;
        }
    }

    Symbols word_;
    const std::array<Act, max_symbols>& acts_;
    const FlatPlan& plan_;
    const TurtleSettings& settings_;
    FlatDrawing& drawing_;
    Vec* points_;
    std::uint64_t count_ = 0;
    State state_;
    std::vector<State> outer_;
    FlatRun run_;
    bool is_drawing_ = false;
};

}  // namespace

Result<std::optional<FlatDrawing>> flat_drawing(Symbols word, const Alphabet& alphabet, const TurtleSettings& settings,
                                                std::uint64_t most_elements, FlatDrawing reuse) {
    if (auto wrong = check_settings(settings, alphabet)) return *std::move(wrong);
    const TurtleLetters letters = turtle_letters(alphabet, settings);
    const FlatCounts counts = count_flat(word, letters.acts);
    if (counts.others != 0) return std::optional<FlatDrawing>();
    const std::optional<FlatPlan> plan = flat_plan(word, letters, settings);
    if (!plan) return std::optional<FlatDrawing>();
    if (counts.lines > most_elements) return too_much_to_draw(counts.lines, "segments", most_elements);

    FlatDrawing drawing;
    drawing.memory = std::move(reuse.memory);
    drawing.runs = std::move(reuse.runs);
    drawing.runs.clear();
    const std::uint64_t most_runs = std::min(counts.lines, counts.breaks + 1);
    if (!drawing.memory.make((counts.lines + most_runs) * sizeof(Vec))) {
        return fault(Fault::limit, "limit.memory",
                     "there is too little memory to draw " + filigree::to_text(counts.lines) + " segments");
    }
    drawing.runs.reserve(most_runs);
    drawing.segments = counts.lines;
    FlatWalk walk(word, letters.acts, *plan, settings, drawing, reinterpret_cast<Vec*>(drawing.memory.data()));
    if (auto problem = walk.run()) return *std::move(problem);
    return std::make_optional(std::move(drawing));
}

}  // namespace filigree::rewriting
