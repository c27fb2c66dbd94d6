// One symbol after the other into what the plan of the iteration makes of it.
//
// What becomes of a symbol hangs on few symbols behind it: on the next, which may be '='; of a macro, on the next two;
// of a run's last members, on how it ends. Beside that it hangs on how many symbols that are counted stand before it
// (Progress). So any part of a word can be rewritten by itself that counts nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "engines/rewriting/decide.h"

namespace filigree::rewriting {

constexpr std::uint64_t too_many = UINT64_MAX / 2;  // symbols: from there on they are not counted

// What most symbols become most of the time, so that one look and one wide store do for each: short fixed images, and
// symbols that stay. Others are `slow`.
struct QuickTable {
    static constexpr std::size_t width = 32;
    static constexpr std::uint8_t slow = 255;

    // By symbol, and whether '=' stands behind it.
    static std::size_t index_of(Symbol symbol, bool has_freeze) {
        return symbol + max_symbols * static_cast<std::size_t>(has_freeze);
    }
    static std::size_t index_at(const Symbol* at) { return index_of(at[0], at[1] == Alphabet::freeze); }

    std::array<std::array<Symbol, width>, 2 * max_symbols> images;
    std::array<std::uint8_t, 2 * max_symbols> sizes;

    QuickTable(const StepPlan& plan, const Alphabet& alphabet);
};

// What an iteration works on.
struct Rewriting {
    const Word& word;
    const Alphabet& alphabet;
    const StepPlan& plan;
    QuickTable quick;
    bool may_put_followers = false;
    bool has_gaits = false;  // symbols that are rewritten alike may differ

    Rewriting(const Word& of, const Alphabet& by, const StepPlan& as_planned)
        : word(of), alphabet(by), plan(as_planned), quick(as_planned, by) {
        for (std::size_t s = 0; s < alphabet.size(); ++s) {
            may_put_followers = may_put_followers || alphabet[static_cast<Symbol>(s)].role == Role::follower;
            has_gaits = has_gaits || alphabet[static_cast<Symbol>(s)].gait != 0;
        }
    }

    bool has_freeze(std::size_t place) const { return place < word.size() && word.symbols[place] == Alphabet::freeze; }
    std::size_t followers_in(const std::vector<Symbol>& symbols) const {
        if (!may_put_followers) return 0;
        return static_cast<std::size_t>(std::count_if(
            symbols.begin(), symbols.end(), [&](Symbol symbol) { return alphabet[symbol].role == Role::follower; }));
    }
};

// What has been counted up to a place.
struct Progress {
    std::size_t index = 0;      // symbols that are no '=', where columns are written
    std::size_t decided = 0;    // decisions that were taken
    std::size_t followers = 0;  // ñ
    std::uint32_t ordinal = 0;  // n

    // Of the run of q or g that was met last.
    std::size_t run_end = 0;
    std::size_t run_kept = 0;  // where what stays of it ends
    std::uint32_t run_gain = 0;
};

// Where the stretch of a symbol that begins at a place ends.
inline std::size_t end_of_stretch(const std::vector<Symbol>& symbols, std::size_t place) {
    const Symbol symbol = symbols[place];
    const std::uint64_t eight_alike = symbol * 0x0101010101010101U;
    std::size_t end = place + 1;
    for (; end + 8 <= symbols.size(); end += 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, &symbols[end], 8);
        if (eight != eight_alike) break;
    }
    while (end < symbols.size() && symbols[end] == symbol) ++end;
    return end;
}

// Where the run of the symbol at a place ends: however it is drawn.
inline std::size_t end_of_run(const Rewriting& in, std::size_t place) {
    const std::vector<Symbol>& symbols = in.word.symbols;
    std::size_t end = end_of_stretch(symbols, place);
    const auto goes_on = [&] {
        const SymbolEntry &here = in.alphabet[symbols[end - 1]], &next = in.alphabet[symbols[end]];
        return next.letter == here.letter && next.role == here.role && next.scope == here.scope;
    };
    while (in.has_gaits && end < symbols.size() && goes_on()) end = end_of_stretch(symbols, end);
    return end;
}

// Looks at the run of q or g that stands at a place. Only its last member can be frozen or rest, which ends the run and
// holds it.
inline void meet_run(const Rewriting& in, std::size_t place, Progress& progress) {
    const std::vector<Symbol>& symbols = in.word.symbols;
    const Symbol symbol = symbols[place];
    const std::uint32_t gain = in.plan.entries[symbol].gain;
    std::size_t end = end_of_run(in, place);
    for (std::size_t member = place; !in.plan.resting.empty() && member + 1 < end; ++member) {
        if (in.plan.rests(member)) end = member + 1;
    }
    const bool is_held = in.has_freeze(end) || in.plan.rests(end - 1);
    const bool has_inverter = end < symbols.size() && in.plan.entries[symbols[end]].kind == StepPlan::Kind::invert &&
                              in.alphabet[symbols[end]].scope == in.alphabet[symbol].scope;
    const bool shrinks = !is_held && has_inverter && !in.has_freeze(end + 1) && !in.plan.rests(end);
    progress.run_end = end;
    progress.run_kept = shrinks ? end - std::min<std::size_t>(end, gain) : end;
    progress.run_gain = shrinks || is_held ? 0 : gain;
}

// The members of a run up to `end`, or where it ends before; returns where that was.
template <class Out>
std::size_t rewrite_run(const Rewriting& in, std::size_t place, std::size_t end, Progress& progress, Out& out) {
    if (place >= progress.run_end) meet_run(in, place, progress);
    const std::size_t behind = std::min(end, progress.run_end);
    const std::size_t kept_behind = std::clamp(progress.run_kept, place, behind);
    out.keep_run(place, kept_behind, progress.index);
    progress.index += behind - place;
    out.at(progress.index - 1);
    if (behind == progress.run_end) out.repeat(in.word.symbols[behind - 1], progress.run_gain);
    return behind;
}

// What is no '=' and no member of a run.
template <class Out>
void rewrite_symbol(const Rewriting& in, std::size_t place, Progress& progress, Out& out) {
    using Kind = StepPlan::Kind;
    const Symbol symbol = in.word.symbols[place];
    const StepPlan::Entry& entry = in.plan.entries[symbol];
    const Role role = in.alphabet[symbol].role;
    const std::size_t index = progress.index++;
    out.at(index);
    if (role == Role::ordinal) ++progress.ordinal;
    const std::uint32_t made_by = role == Role::follower ? in.word.origins[progress.followers++] : 0;
    const std::size_t freezes = !in.has_freeze(place + 1) ? 0 : !in.has_freeze(place + 2) ? 1 : 2;  // or more
    const bool stays = entry.kind == Kind::keep || entry.kind == Kind::invert;
    if (stays || is_asleep(in.alphabet[symbol], freezes)) return out.keep(place, made_by);
    if (in.plan.rests(place)) {
        out.keep(place, made_by);
        if (freezes > 0) out.put_freeze();  // what asks a macro to recall stays, too
        return;
    }
    if (entry.kind == Kind::repeat) return out.copy_all(place);

    const Image& image =
        in.plan.images[entry.image == StepPlan::decided ? in.plan.decisions[progress.decided++] : entry.image];
    if (image.is_kept) return out.keep(place, made_by);
    if (entry.kind == Kind::put) return out.put(image.symbols, 1, place, 1);
    const std::uint32_t times = entry.kind == Kind::follow ? made_by : progress.ordinal;
    out.put(image.symbols, times, place, times);
}

// The part of the word from one place to another.
template <class Out>
void rewrite_symbols(const Rewriting& in, std::size_t begin, std::size_t end, Progress& progress, Out& out) {
    for (std::size_t place = begin;; ++place) {
        if constexpr (Out::is_quick) place = out.put_quick_ones(place, std::min(end, in.word.size() - 1));
        if (place >= end) return;
        const Symbol symbol = in.word.symbols[place];
        if (in.plan.entries[symbol].kind == StepPlan::Kind::count) {
            place = rewrite_run(in, place, end, progress, out) - 1;
        } else if (symbol != Alphabet::freeze) {
            rewrite_symbol(in, place, progress, out);
        } else if (in.has_freeze(place + 1)) {
            out.put_freeze();  // the last '=' of a row is the turn that is over
        }
    }
}

}  // namespace filigree::rewriting
