#include "session/variations.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "language/edit_presets.h"
#include "language/parse.h"
#include "session/list_choices.h"

namespace filigree {
namespace {

constexpr std::size_t most_single_choices = 100;

// Something that can be drawn again as one.
struct Candidate {
    std::string path;  // as `reroll` takes it
    std::string short_name;
    std::size_t choices = 0;  // that it holds
};

// Whether a `keep` holds the place, or one above it.
bool is_kept(const PresetWalk& walk, const ChoicePath& path) {
    PresetNode node = walk.root;
    for (const PathSegment& segment : path.segments) {
        if (!node.state) return false;
        WalkSegment step;
        step.name = segment.name;
        if (segment.kind == PathSegment::Kind::shapes) {
            step = {{}, 0, segment.ordinals.front()};
        } else if (!segment.ordinals.empty()) {
            step.ordinal = segment.ordinals.front();
        }
        node = node_below(walk, node, step);
        for (const std::uint32_t i : node.accepted) {
            const Preset& preset = walk.presets.all[i];
            const bool is_end = &segment == &path.segments.back();
            const bool covers = preset.path->parameter.empty() || (is_end && preset.path->parameter == path.parameter);
            if (preset.kind == PresetKind::keep && covers) return true;
        }
    }
    return false;
}

// "outline.distance" of "big_poly/outline.distance".
std::string last_part(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    std::string last = slash == std::string::npos ? path : path.substr(slash + 1);
    const std::size_t bracket = last.find('['), close = last.find(']');
    if (bracket != std::string::npos && close != std::string::npos) last.erase(bracket, close + 1 - bracket);
    return last;
}

std::vector<Candidate> single_candidates(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run) {
    const PresetWalk walk = begin_walk({}, opened.document, checked.settings->globals, checked.settings->seed);
    std::vector<Candidate> candidates;
    for_each_choice(opened, checked, run, [&](const ListedChoice& choice) {
        if (choice.choices->sources[choice.row] != ChoiceSource::drawn) return;
        // The k-th choice of an expression is drawn again with the first.
        const std::string name(choice.name.substr(0, choice.name.find('~')));
        const bool is_definition = choice.path.rfind("let/", 0) == 0;
        std::string path = is_definition ? choice.path : choice.path + "." + name;
        if (!candidates.empty() && candidates.back().path == path) return;
        const Result<ChoicePath> parsed = parse_path(path);
        if (!parsed || is_kept(walk, *parsed)) return;
        candidates.push_back({path, last_part(path), 1});
    });
    return candidates;
}

std::vector<Candidate> classes_of(const std::vector<Candidate>& singles) {
    std::vector<Candidate> classes;
    std::map<std::string, std::size_t> known;
    for (const Candidate& one : singles) {
        const bool is_definition = one.path.rfind("let/", 0) == 0;
        const std::string path = is_definition ? one.path : "**/" + one.short_name;
        const auto [place, fresh] = known.emplace(path, classes.size());
        if (fresh) classes.push_back({path, one.short_name, 0});
        ++classes[place->second].choices;
    }
    return classes;
}

std::string label_of(std::uint32_t number, const std::vector<std::string>& names) {
    std::string label = std::to_string(number) + "  ";
    for (std::size_t i = 0; i < names.size() && i < 2; ++i) label += (i == 0 ? "" : ", ") + names[i];
    if (names.size() > 2) label += " +" + std::to_string(names.size() - 2);
    return label;
}

}  // namespace

Result<std::vector<Variation>> variations(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run,
                                          const VariationOptions& options) {
    std::vector<Candidate> candidates = single_candidates(opened, checked, run);
    const auto free = static_cast<double>(candidates.size());
    if (candidates.empty()) {
        return error("variations.nothing-free",
                     "nothing can be drawn again: every choice is set or kept, or there is none", {},
                     {"a range such as 5..9, one_of(...) or several rules for a tag make a choice"});
    }
    if (candidates.size() > most_single_choices) candidates = classes_of(candidates);
    const double wanted = std::max(1.0, std::round(options.distance * free));
    std::vector<Variation> all;
    for (std::uint32_t n = options.first; n < options.first + options.count; ++n) {
        Variation variation;
        variation.number = n;
        variation.text = opened.document.text();
        std::vector<std::string> names;
        double drawn = 0;
        const std::vector<std::uint32_t> order =
            permutation(checked.settings->seed, child(Key{hash_text("variation")}, n), "order",
                        static_cast<std::uint32_t>(candidates.size()));
        for (const std::uint32_t i : order) {
            if (drawn >= wanted) break;
            const Candidate& candidate = candidates[i];
            const Parsed parsed = parse_document(opened.name, variation.text, [&](std::string_view name) {
                const Input* input = find_input(opened.inputs, name);
                return input != nullptr ? Result<std::string>(input->bytes)
                                        : Result<std::string>(error("input.missing", "the file is not at hand"));
            });
            // Every neighbour draws anew: the n-th time.
            Result<std::string> text = with_reroll(parsed.document, candidate.path, n);
            if (!text) return std::move(text).diagnostics();
            variation.text = std::move(*text);
            variation.rerolls.push_back(candidate.path);
            names.push_back(candidate.short_name);
            drawn += static_cast<double>(candidate.choices);
        }
        variation.label = label_of(n, names);
        all.push_back(std::move(variation));
    }
    return all;
}

}  // namespace filigree
