// For tests alone: a document's presets as they are met at one place of a derivation.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "language/path_cases.h"
#include "language/step_choices.h"
#include "language/text_evaluation.h"

namespace filigree {

struct PresetPlace {
    Document document;
    Scope globals;
    Presets presets;
    std::vector<std::uint32_t> accepted_here;
    std::vector<ShapeChoices> shapes;
    ChoiceBuffer buffer;
    Replay replay;
    StepChoices choices;
    std::uint64_t seed = 1;

    PresetPlace() = default;
    PresetPlace(const PresetPlace&) = delete;
    PresetPlace& operator=(const PresetPlace&) = delete;

    // The globals must be there already. `outer`: those of another document, met at the same place.
    void stand_at(std::string_view path, std::string_view text, const PresetPlace* outer = nullptr) {
        document = document_of(text);
        presets = with_presets_of(outer != nullptr ? outer->presets : Presets{}, document, globals, seed);
        accepted_here = accepted_at(path);
        shapes.clear();
        buffer = {};
        choices = {&presets, accepted_here, seed_at_node(presets, accepted_here, {seed, nullptr})};
        choices.replay = &replay;
        choices.record = &buffer;
        const Result<bool> is_random = is_random_at(presets, accepted_here, globals);
        EXPECT_TRUE(is_random);
        choices.is_random = is_random && *is_random;
    }
    // What is said of the n-th shape, from 1: at this path.
    void add_shape(std::uint32_t number, std::string_view path) {
        shapes.push_back({number - 1, accepted_at(path), {}});
        choices.shapes = shapes;
    }

    std::vector<std::uint32_t> accepted_at(std::string_view path) const {
        PresetState state = begin_presets(presets, 0, nullptr);
        for (const PathSegment& segment : path_of(path).segments) {
            const std::uint32_t number = segment.ordinals.empty() ? 0 : segment.ordinals.front();
            const bool is_shape = segment.kind == PathSegment::Kind::shapes;
            state = advance(presets, state, is_shape ? WalkSegment{{}, 0, number} : WalkSegment{segment.name, number});
        }
        return accepted(presets, state);
    }

    // "distance: 5..9 drawn 7.5", one a line; the key in front where it is not `step`.
    std::string rows(Key step) const {
        ChoiceRecorder recorder;
        recorder.append(buffer);
        const Choices& made = recorder.choices;
        std::string out;
        for (std::size_t row = 0; row < made.size(); ++row) {
            if (made.keys[row] != step) out += "@" + to_text(made.keys[row].value) + " ";
            const ChoiceDomain& domain = made.domain_table[made.domains[row]];
            out += made.name_table[made.names[row]] + ": " + domain_text(domain) + " " +
                   std::string(name_of(made.sources[row]));
            if (domain.kind != ChoiceDomain::Kind::fixed) out += " " + to_text(value_of(made, row));
            out += "\n";
        }
        return out;
    }
};

}  // namespace filigree
