#include "session/list_design.h"

#include <nlohmann/json.hpp>

#include "curves/path_elements.h"
#include "engines/shape/paths.h"
#include "session/derive_design.h"
#include "session/list_matches.h"
#include "session/list_steps.h"

namespace filigree {
namespace {

using Json = nlohmann::ordered_json;

Json application_json(const OpenedDocument& opened, const CheckedDocument& checked, const shape::Application& at) {
    Json json;
    json["apply"] = apply_text(opened, checked, {}, at, false);
    json["at"] = {at.place.x, at.place.y};
    json["angle"] = at.fit.angle_degrees;
    json["scale"] = at.fit.scale;
    json["reflected"] = at.fit.is_reflected;
    json["ambiguous"] = at.fit.is_ambiguous;
    return json;
}

std::string count_text(std::size_t count, std::string_view noun) {
    return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace

std::string path_data_of(const curves::Shape& design, double tolerance) {
    std::string data;
    for (const curves::JoinedPath& joined : curves::paths_of(design.elements, 2 * tolerance)) {
        data += (data.empty() ? "" : " ") + to_path_data(joined.path);
    }
    return data;
}

std::string design_text(const OpenedDocument& opened, const CheckedDocument& checked,
                        const shape::Derivation& derivation) {
    const shape::Grammar& grammar = *checked.design;
    std::string text;
    for (std::uint32_t s = 1; s <= derivation.steps.size(); ++s) {
        const shape::Step& step = derivation.steps[s - 1];
        text += std::to_string(s) + "  " + shape::path_of_state(derivation, grammar, s) + "  " +
                apply_text(opened, checked, {}, step.applied[0], false).substr(6);
        if (step.applied.size() > 1) text += " and " + count_text(step.applied.size() - 1, "other place");
        text += "  " + std::to_string(step.change.removed.size()) + " -> " +
                count_text(step.change.added.size(), "element");
        if (step.before + 1 != s) text += "  from state " + std::to_string(step.before);
        text += "\n";
    }
    text += count_text(derivation.design.elements.size(), "element");
    if (derivation.is_finished) text += ", no rule applies any more";
    return text + "\n";
}

std::string design_json(const OpenedDocument& opened, const CheckedDocument& checked,
                        const shape::Derivation& derivation) {
    const shape::Grammar& grammar = *checked.design;
    Json json;
    json["document"] = opened.name;
    json["start"] = grammar.start_tag;
    json["state"] = derivation.state;
    json["finished"] = derivation.is_finished;
    json["steps"] = Json::array();
    for (std::uint32_t s = 1; s <= derivation.steps.size(); ++s) {
        const shape::Step& step = derivation.steps[s - 1];
        Json one;
        one["state"] = s;
        one["before"] = step.before;
        one["path"] = shape::path_of_state(derivation, grammar, s);
        one["rule"] = grammar.rules[step.rule].name;
        one["line"] = line_of(opened.document, step.number > 0 ? grammar.rules[step.rule].span : step.by);
        for (const shape::Application& at : step.applied) {
            one["applied"].push_back(application_json(opened, checked, at));
        }
        one["removed"] = step.change.removed.size();
        one["added"] = step.change.added.size();
        json["steps"].push_back(std::move(one));
    }
    json["elements"] = derivation.design.elements.size();
    json["ambiguous"] = derivation.ambiguities.found.size();
    json["path"] = path_data_of(derivation.design, grammar.tolerance);
    return json.dump(1) + "\n";
}

Result<shape::FoundDesigns> find_designs(const OpenedDocument& opened, const CheckedDocument& checked,
                                         const shape::EnumerateOptions& options, const Job& job) {
    Result<shape::Derivation> derivation = derive_design(opened, checked, {{}, {}, true}, job);
    if (!derivation) return derivation.diagnostics();
    return shape::enumerate(*checked.design, derivation->design, surroundings_of(opened, checked), options, job);
}

std::string designs_text(const CheckedDocument& checked, const shape::FoundDesigns& found) {
    std::string text;
    std::vector<std::size_t> of_depth;
    for (std::size_t d = 0; d < found.all.size(); ++d) {
        const shape::FoundDesign& design = found.all[d];
        if (of_depth.size() <= design.depth) of_depth.resize(design.depth + 1);
        ++of_depth[design.depth];
        text += std::to_string(d) + "  depth " + std::to_string(design.depth) + "  ";
        if (d > 0) {
            text += checked.design->rules[design.by.rule].name + " of " + std::to_string(design.before) + "  ";
        }
        text += count_text(design.design.elements.size(), "element");
        if (design.ways > 1) text += "  met " + std::to_string(design.ways) + " times";
        text += "\n";
    }
    text += count_text(found.all.size(), "design") + ": ";
    for (std::size_t depth = 0; depth < of_depth.size(); ++depth) {
        text += (depth == 0 ? "" : ", ") + std::to_string(of_depth[depth]) + " at depth " + std::to_string(depth);
    }
    return text + (found.is_complete ? "\n" : "; there are more\n");
}

std::string designs_json(const OpenedDocument& opened, const CheckedDocument& checked,
                         const shape::FoundDesigns& found) {
    Json json;
    json["document"] = opened.name;
    json["complete"] = found.is_complete;
    json["designs"] = Json::array();
    for (std::size_t d = 0; d < found.all.size(); ++d) {
        const shape::FoundDesign& design = found.all[d];
        Json one;
        one["number"] = d;
        one["depth"] = design.depth;
        if (d > 0) {
            one["before"] = design.before;
            one["rule"] = checked.design->rules[design.by.rule].name;
            one["applied"] = application_json(opened, checked, design.by);
        }
        one["ways"] = design.ways;
        one["elements"] = design.design.elements.size();
        one["path"] = path_data_of(design.design, checked.design->tolerance);
        json["designs"].push_back(std::move(one));
    }
    return json.dump(1) + "\n";
}

}  // namespace filigree
