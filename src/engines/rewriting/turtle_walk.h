// The walk of the turtle through a word, which tells what happens as it goes.
//
// `Told` is told before(symbol, walk) of every symbol, step(symbol, act, from, walk) when the step is done, and
// begin_polygon(symbol, walk) and end_polygon(); the walk says where it stands.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "base/number_text.h"
#include "engines/rewriting/turtle.h"
#include "engines/rewriting/turtle_frames.h"
#include "engines/rewriting/turtle_letters.h"
#include "engines/rewriting/turtle_turns.h"

namespace filigree::rewriting {

// All that brackets keep. The frame is `base` turned about `turned_about`, so that turns about one axis add up exactly.
struct TurtleState {
    Vec3 position;
    Frame base;
    Turn turn;
    Axis turned_about = Axis::up;
    Axis selected = Axis::up;
    double scale = 1;
    double width = 1;
    std::int64_t width_level = 0, colour = 0;
};

// Directions that were asked for before, where they are few enough to keep.
class TurtleDirections {
public:
    explicit TurtleDirections(const TurnScale& scale) : scale_(scale) {
        if (scale_.per_turn <= most_kept) known_.resize(scale_.per_turn, {unknown, unknown});
    }
    elementary::CosSin of(const Turn& turn) {
        if (turn.rest != 0 || known_.empty()) return direction(turn, scale_);
        elementary::CosSin& known = known_[static_cast<std::size_t>(turn.amount)];
        if (known.cos == unknown) known = direction(turn, scale_);
        return known;
    }

private:
    static constexpr std::uint32_t most_kept = 1 << 14;
    static constexpr double unknown = 2;  // no cosine
    const TurnScale& scale_;
    std::vector<elementary::CosSin> known_;
};

template <class Told>
class TurtleWalk {
public:
    TurtleWalk(const Word& word, const TurtleLetters& letters, const TurtleCounts& counts,
               const TurtleSettings& settings, Told& told)
        : word_(word),
          letters_(letters),
          counts_(counts),
          settings_(settings),
          told_(told),
          directions_(letters.scale) {
        outer_.reserve(counts.deepest);
        state_.width = settings.width;
    }

    std::optional<Diagnostic> run() {
        for (std::size_t at = 0; at < word_.size() && !problem_; ++at) {
            told_.before(at, *this);
            if (at >= shrink_end_) act(at, letters_.acts[word_.symbols[at]]);
            if (word_.symbols[at] != Alphabet::freeze) ++unfrozen_;
        }
        return problem_;
    }

    const TurtleState& state() const { return state_; }
    const Frame& frame() {
        if (!is_known_) {
            frame_ = state_.turn.is_none() ? state_.base : turned(state_.base, state_.turned_about, here());
            is_known_ = true;
        }
        return frame_;
    }

private:
    elementary::CosSin here() { return directions_.of(state_.turn); }

    void step(std::size_t at, Act act) {
        const Vec3 from = state_.position;
        state_.position = from + frame().heading * (letters_.lengths[word_.symbols[at]] * state_.scale);
        const auto& [x, y, z] = state_.position;
        if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) problem_ = out_of_range(at);
        told_.step(at, act, from, *this);
    }

    // Before a turn about what is selected.
    void face_turn() {
        is_known_ = false;
        if (state_.turned_about == state_.selected) return;
        if (!state_.turn.is_none()) state_.base = orthonormal(turned(state_.base, state_.turned_about, here()));
        state_.turn = {};
        state_.turned_about = state_.selected;
    }
    void turn(std::size_t at) {
        face_turn();
        add_amount(state_.turn, letters_.scale, letters_.turns[word_.symbols[at]]);
    }
    void turn_by_formula(std::size_t at) {
        AngleFacts facts{asked_++, outer_.size(), 1, state_.position.x, state_.position.y, state_.position.z};
        if (unfrozen_ < word_.ages.size()) facts.age = word_.ages[unfrozen_];
        double degrees = 0;
        if (settings_.formula) {
            degrees = settings_.formula(facts);
        } else if (!settings_.angles.empty()) {
            degrees = settings_.angles[facts.k % settings_.angles.size()];
        }
        if (!std::isfinite(degrees)) {
            problem_ = error("rewriting.angle-not-finite", "the formula of '?' gives no number for number " +
                                                               filigree::to_text(facts.k + 1) + " of them, at symbol " +
                                                               filigree::to_text(static_cast<std::uint64_t>(at + 1)));
            return;
        }
        face_turn();
        add_degrees(state_.turn, settings_.plus == PlusTurn::clockwise ? -degrees : degrees);
    }
    void head(const Frame& frame) {
        state_.base = frame;
        state_.turn = {};
        is_known_ = false;
    }
    void widen(std::size_t at, int times) {
        state_.width_level += times;
        state_.width = width_of(settings_, state_.width_level);
        if (!std::isfinite(state_.width)) problem_ = out_of_range(at);
    }

    void shrink(std::size_t at) {
        if (shrinks_ == counts_.shrinks.size() || counts_.shrinks[shrinks_].begin != at) return;
        state_.scale *= counts_.shrinks[shrinks_].factor;
        shrink_end_ = counts_.shrinks[shrinks_++].end;
    }

    void act(std::size_t at, Act act) {
        switch (act) {
            case Act::nothing:
                return;
            case Act::line:
            case Act::move:
            case Act::corner:
            case Act::shape:
                return step(at, act);
            case Act::head_x:
                return head(frame_along_x);
            case Act::head_y:
                return head(frame_along_y);
            case Act::head_z:
                return head(frame_along_z);
            case Act::select_up:
                state_.selected = Axis::up;
                return;
            case Act::select_left:
                state_.selected = Axis::left;
                return;
            case Act::select_heading:
                state_.selected = Axis::heading;
                return;
            case Act::plus:
            case Act::minus:
            case Act::less:
            case Act::greater:
                return turn(at);
            case Act::formula:
                return turn_by_formula(at);
            case Act::push:
                outer_.push_back(state_);
                return;
            case Act::pop:
                if (outer_.empty()) return;
                state_ = outer_.back();
                outer_.pop_back();
                is_known_ = false;
                return;
            case Act::wider:
                return widen(at, 1);
            case Act::narrower:
                return widen(at, -1);
            case Act::next_colour:
                ++state_.colour;
                return;
            case Act::previous_colour:
                --state_.colour;
                return;
            case Act::begin_polygon:
                told_.begin_polygon(at, *this);
                return;
            case Act::end_polygon:
                told_.end_polygon();
                return;
            case Act::shrink:
                return shrink(at);
        }
    }

    const Word& word_;
    const TurtleLetters& letters_;
    const TurtleCounts& counts_;
    const TurtleSettings& settings_;
    Told& told_;
    TurtleDirections directions_;
    TurtleState state_;
    Frame frame_;
    bool is_known_ = false;  // frame_
    std::vector<TurtleState> outer_;
    std::size_t shrinks_ = 0, shrink_end_ = 0;
    std::uint64_t asked_ = 0;     // '?' so far
    std::uint64_t unfrozen_ = 0;  // symbols so far that are no '='
    std::optional<Diagnostic> problem_;
};

}  // namespace filigree::rewriting
