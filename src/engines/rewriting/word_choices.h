// How the random choices of a word are made where more is asked for than to draw: what presets say of them, what is
// replayed, and what is recorded.
//
// A symbol's choices are `rule`, one of the successors of its rule; `target`, the same for a rule that a `goto` takes
// from another symbol; and `letters`, what a macro becomes. They are addressed by the symbol's key: its lineage, or its
// place where draws go by place. An edit chooses at its own key (`scatter`, and what its arguments choose).
//
// Who derives without asking for any of this has no WordChoices, and pays nothing for it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "engines/rewriting/grammar.h"
#include "engines/rewriting/spots.h"
#include "engines/rewriting/symbol_facts.h"
#include "language/choices.h"
#include "language/preset_walk.h"

namespace filigree::rewriting {

constexpr std::uint64_t most_recorded_choices = 1'000'000;  // of one document

constexpr std::string_view no_successor = "none";  // what presets say instead of one: the symbol stays

struct WordChoiceOptions {
    bool follows_presets = true;  // whether any preset may reach the word
    bool records = false;
};

// A symbol that chooses, or an edit.
struct ChoosingSymbol {
    Key key;                  // whatever the seed
    Spot spot = Spots::root;  // where nobody asked for spots, no matter
    std::uint32_t times = 0;  // that it has chosen before, and stayed all the same
    const Scope& names;       // what is known where it stands
    // What it draws: by the seed, and by the number of the draw.
    std::function<std::uint64_t(std::uint64_t seed, std::uint64_t draw)> bits;
};

class WordChoices {
public:
    WordChoices(PresetWalk walk, WordChoiceOptions options);
    WordChoices(const WordChoices&) = delete;
    WordChoices& operator=(const WordChoices&) = delete;

    Spots& spots() { return spots_; }
    bool needs_spots() const { return needs_spots_; }
    // What the presets ask of symbols.
    FactSet facts_asked() const;

    // The index of one of a rule's successors; their number where none is taken. `name`: of the choice.
    Result<std::size_t> successor(const Rule& rule, std::span<const double> weights, std::string_view name,
                                  const ChoosingSymbol& symbol);
    Result<std::u32string> letters(const Macro& macro, const ChoosingSymbol& symbol);
    // For what an edit chooses; valid until the next call. What it records is kept by `take_record`.
    Result<StepChoices> of_edit(Spot spot, const Scope& names);
    void take_record(Spot spot);

    // A derivation is over: who goes on with it, or makes it again to explain it, adds nothing.
    void stop_recording() { options_.records = false; }
    // What was recorded: the choices in the order in which they were made, and of each the spot.
    const Choices& made() const { return recorder_.choices; }
    const std::vector<Spot>& spots_of_made() const { return spots_of_made_; }
    std::uint64_t left_out() const { return left_out_; }  // choices that were too many to be recorded
    std::string path_of(Spot spot) const { return spots_.path_of(spot); }

    const Presets& presets() const { return walk_.presets; }
    // By preset: whether it has met a place of this derivation, and there what it names.
    std::vector<std::uint8_t> met() const;

private:
    struct Named;  // successors that a preset names

    ChoiceBuffer* buffer() { return options_.records ? &buffer_ : nullptr; }
    const PresetNode& node_of(const ChoosingSymbol& symbol) const;
    void meet(const PresetNode& node, std::string_view parameter);
    Result<StepChoices> choices_of(const ChoosingSymbol& symbol, std::string_view parameter);
    Result<Named> named_by(const Preset& preset, const Value& value, const Rule& rule, const StepChoices& choices,
                           std::span<const double> weights, std::string_view name, const ChoosingSymbol& symbol);
    void record_choice(const void* text, std::string_view name, const ChoiceDomain& domain, Key key, double value,
                       ChoiceSource source);

    const PresetWalk walk_;
    WordChoiceOptions options_;
    const bool needs_spots_;
    Spots spots_;
    PresetNode edit_node_;
    std::vector<std::uint8_t> met_;  // by preset: whether a choice that it names was made
    ChoiceBuffer buffer_;
    ChoiceRecorder recorder_;
    std::vector<Spot> spots_of_made_;
    std::uint64_t left_out_ = 0;
};

// The successor that a value names: by its text, blanks left aside, or by its number from 1.
std::optional<std::size_t> successor_named(const Rule& rule, const Value& value);
// What a macro draws: first its length, then its letters.
std::u32string drawn_letters(const Macro& macro, const std::function<std::uint64_t(std::uint64_t draw)>& bits);
// Of candidates with weights, those that race by the bits of their indices; none where no weight is above zero.
std::size_t raced(std::span<const double> weights, std::uint64_t bits);

}  // namespace filigree::rewriting
