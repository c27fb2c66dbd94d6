#include "session/stats.h"

#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "base/number_text.h"
#include "engines/tangle/verify.h"
#include "session/embed.h"
#include "session/list_steps.h"

namespace filigree {
namespace {

using Json = nlohmann::ordered_json;

// Documents may name files in bytes that are no UTF-8; they are shown with replacement characters.
std::string dumped(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json diagnostic_json(const Diagnostic& diagnostic, const Sources& sources) {
    Json json;
    json["severity"] = diagnostic.severity == Severity::error ? "error" : "warning";
    json["code"] = diagnostic.code;
    json["message"] = diagnostic.message;
    if (diagnostic.span.file < sources.size()) {
        const SourceFile& source = sources[diagnostic.span.file];
        const LineColumn place = line_column(source.text, diagnostic.span.begin);
        json["file"] = source.name;
        json["line"] = place.line;
        json["column"] = place.column;
    }
    json["hints"] = diagnostic.hints;
    return json;
}

}  // namespace

std::uint64_t peak_memory_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

namespace {

Json seconds_of(const RunTimes& times) {
    return {{"parse", times.parse},
            {"derive", times.derive},
            {"draw", times.draw},
            {"write", times.write},
            {"total", times.total}};
}

std::size_t rule_count(const rewriting::Grammar& grammar) {
    return std::accumulate(grammar.systems.begin(), grammar.systems.end(), std::size_t{0},
                           [](std::size_t sum, const rewriting::System& system) { return sum + system.rules.size(); });
}

Json verified(const Run& run) { return run.verified ? Json(run.broken.empty()) : Json(nullptr); }

void add_unmatched(Json& json, const Run& run) {
    json["unmatched"] = Json::array();
    for (const UnmatchedPreset& preset : run.unmatched) json["unmatched"].push_back(preset.path);
}

std::string word_stats_json(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run) {
    const rewriting::Derivation& derivation = run.word->derivation;
    Json json;
    json["document"] = opened.name;
    json["engine"] = checked.settings->engine;
    json["seed"] = checked.settings->seed;
    json["steps"] = derivation.iteration;
    json["elements"] = run.drawing.shapes.size();
    json["rules"] = rule_count(*checked.words);
    json["seconds"] = seconds_of(run.times);
    json["peak_memory_bytes"] = peak_memory_bytes();
    json["verified"] = verified(run);
    add_unmatched(json, run);
    std::uint64_t vertices = 0;
    for (const auto& geometry : run.drawing.geometry) vertices += geometry->points.size();
    json["word"] = {{"length", derivation.word.size()}, {"vertices", vertices}};
    return dumped(json);
}

std::string design_stats_json(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run) {
    const shape::Derivation& derivation = run.design->derivation;
    Json json;
    json["document"] = opened.name;
    json["engine"] = checked.settings->engine;
    json["seed"] = checked.settings->seed;
    json["steps"] = derivation.steps.size();
    json["elements"] = derivation.design.elements.size();
    json["rules"] = checked.design->rules.size();
    json["seconds"] = seconds_of(run.times);
    json["peak_memory_bytes"] = peak_memory_bytes();
    json["verified"] = verified(run);
    json["unmatched"] = Json::array();
    for (const UnmatchedPreset& preset : run.unmatched) json["unmatched"].push_back(preset.path);
    json["choices"] = derivation.choices.size();
    json["shape"] = {{"tolerance", checked.design->tolerance},
                     {"ambiguous", derivation.ambiguities.found.size()},
                     {"finished", derivation.is_finished}};
    return dumped(json);
}

}  // namespace

std::string stats_json(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run) {
    if (run.word) return word_stats_json(opened, checked, run);
    if (run.design) return design_stats_json(opened, checked, run);
    std::uint64_t elements = 0, marks = 0, groups = 0;
    std::uint32_t depth = 0;
    for (const tangle::Group& group : run.tangle.groups) {
        depth = std::max(depth, group.depth);
        if (group.consumer != tangle::none) continue;
        ++groups;
        elements += group.shapes.size();
        marks += static_cast<std::uint64_t>(std::count_if(group.shapes.begin(), group.shapes.end(),
                                                          [](const tangle::Shape& shape) { return shape.is_mark; }));
    }
    for (const tangle::Step& step : run.tangle.steps) {
        for (const auto& embedded : step.embedded) elements += embedded ? embedded->elements : 0;
    }
    std::uint64_t documents = 0, choices = run.tangle.choices.size() + run.picture.choices.size();
    for_each_embedded(run.tangle, [&](const EmbeddedTangle& inner) {
        ++documents;
        choices += inner.tangle.choices.size() + inner.picture.choices.size();
    });
    const tangle::Areas areas = tangle::areas(run.tangle);
    Json json;
    json["document"] = opened.name;
    json["engine"] = checked.settings->engine;
    json["seed"] = checked.settings->seed;
    json["steps"] = run.tangle.steps.size();
    json["elements"] = elements;
    json["groups"] = groups;
    json["depth"] = depth;
    json["rules"] = checked.rules.size();
    json["seconds"] = seconds_of(run.times);
    json["peak_memory_bytes"] = peak_memory_bytes();
    json["area"] = {{"start", areas.start}, {"leaves", areas.leaves}};
    json["verified"] = verified(run);
    add_unmatched(json, run);
    json["choices"] = choices;
    std::uint64_t vertices = 0;
    for (const auto& geometry : run.tangle.geometry) vertices += geometry->points.size();
    json["tangle"] = {{"marks", marks}, {"vertices", vertices}, {"embedded", documents}};
    return dumped(json);
}

std::string check_text(const CheckedDocument& checked, const Document& document) {
    if (checked.design) {
        std::string text = "rules " + std::to_string(checked.design->rules.size()) + ", tolerance " +
                           to_text(checked.design->tolerance) + " px\n";
        for (const shape::Rule& rule : checked.design->rules) {
            text += "  line " + std::to_string(line_of(document, rule.span)) + "  " + rule.name + "  " +
                    std::to_string(rule.left.elements.size()) + " -> " + std::to_string(rule.right.elements.size()) +
                    " elements\n";
        }
        return text;
    }
    if (checked.words) return "rules " + std::to_string(rule_count(*checked.words)) + "\n";
    std::string text = "rules " + std::to_string(checked.rules.size()) + ", edges " +
                       std::to_string(checked.graph.edges) + ", longest path " +
                       std::to_string(checked.graph.longest_path) + "\n";
    for (std::size_t r = 0; r < checked.rules.size(); ++r) {
        const GroupRule& rule = *checked.rules[r];
        text += "  " + std::to_string(r + 1) + "  line " + std::to_string(line_of(document, rule.operator_name.span)) +
                "  " + rule.operator_name.text + " : " + rule.tag.text;
        const auto& next = checked.graph.successors[r];
        for (std::size_t i = 0; i < next.size(); ++i) text += (i == 0 ? "  -> " : ", ") + std::to_string(next[i] + 1);
        text += "\n";
    }
    return text;
}

std::string check_json(const OpenedDocument& opened, const CheckedDocument& checked) {
    const Document& document = opened.document;
    Json json;
    json["ok"] = !has_errors(checked.diagnostics);
    json["nodes"] = checked.rules.size();
    json["edges"] = checked.graph.edges;
    json["longest_path"] = checked.graph.longest_path;
    json["rules"] = Json::array();
    for (std::size_t r = 0; r < checked.rules.size(); ++r) {
        const GroupRule& rule = *checked.rules[r];
        Json one;
        one["line"] = line_of(document, rule.operator_name.span);
        one["operator"] = rule.operator_name.text;
        one["tag"] = rule.tag.text;
        one["next"] = Json::array();
        for (const std::uint32_t next : checked.graph.successors[r]) one["next"].push_back(next + 1);
        json["rules"].push_back(std::move(one));
    }
    json["diagnostics"] = Json::array();
    for (const Diagnostic& diagnostic : checked.diagnostics) {
        json["diagnostics"].push_back(diagnostic_json(diagnostic, opened.sources));
    }
    return dumped(json);
}

}  // namespace filigree
