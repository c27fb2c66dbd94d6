#include "session/check.h"

#include "language/style.h"
#include "session/engines.h"

namespace filigree {
namespace {

std::vector<std::string> start_tags(const CheckedDocument& checked, const Document& document) {
    std::vector<std::string> tags;
    if (checked.start) {
        for (const StartGroup& group : checked.start->groups) tags.push_back(group.tag);
        return tags;
    }
    for (const Statement& statement : document.statements) {
        const auto* start = std::get_if<StartStatement>(&statement.node);
        if (start != nullptr && !start->from) tags.push_back(start->tag.text);
    }
    return tags;
}

Diagnostic unknown_engine(const Settings& settings) {
    std::vector<std::string_view> names;
    for (const EngineInfo& engine : engines()) names.push_back(engine.name);
    std::vector<std::string> hints = did_you_mean(settings.engine, names);
    if (hints.empty()) hints.push_back("known is tangle");
    return error("document.unknown-grammar", "there is no kind of grammar '" + settings.engine + "'",
                 settings.engine_span, hints);
}

Diagnostics style_warnings(const Settings& settings, const tangle::Grammar& grammar) {
    Diagnostics warnings;
    std::vector<std::string_view> known(grammar.tags.begin(), grammar.tags.end());
    for (const StyleStatement* style : settings.styles) {
        for (const Name& tag : style->tags) {
            if (tag.text == "*" || grammar.find_tag(tag.text) != tangle::none) continue;
            warnings.push_back(warning("style.unknown-tag", "no shape has the tag '" + tag.text + "'", tag.span,
                                       did_you_mean(tag.text, known)));
        }
    }
    return warnings;
}

}  // namespace

CheckedDocument check_document(const OpenedDocument& opened) {
    CheckedDocument checked;
    checked.diagnostics = opened.diagnostics;
    for (const Statement& statement : opened.document.statements) {
        if (const auto* rule = std::get_if<GroupRule>(&statement.node)) checked.rules.push_back(rule);
    }
    checked.graph = tangle::rule_graph(checked.rules);

    Result<Settings> settings = read_settings(opened.document);
    append(checked.diagnostics, settings.diagnostics());
    if (!settings) return checked;
    checked.settings = std::move(*settings);
    if (checked.settings->engine != "tangle") {
        if (!checked.settings->engine.empty()) checked.diagnostics.push_back(unknown_engine(*checked.settings));
        return checked;
    }
    if (checked.settings->symmetry) {
        checked.diagnostics.push_back(
            error("document.no-symmetry", "tangles know no symmetry", checked.settings->symmetry->span));
    }
    // A missing file is said already; the start would only say it again.
    if (!has_errors(opened.diagnostics)) {
        Result<PlaneStart> start = make_plane_start(*checked.settings, opened.document, opened.inputs);
        append(checked.diagnostics, start.diagnostics());
        if (start) checked.start = std::move(*start);
    }
    const std::vector<std::string> tags = start_tags(checked, opened.document);
    Result<tangle::Grammar> grammar = tangle::read_grammar(*checked.settings, opened.document, tags);
    append(checked.diagnostics, grammar.diagnostics());
    append(checked.diagnostics, read_styles(*checked.settings, opened.document).diagnostics());
    if (grammar) {
        checked.grammar = std::move(*grammar);
        append(checked.diagnostics, style_warnings(*checked.settings, *checked.grammar));
    }
    append(checked.diagnostics, tangle::graph_warnings(checked.graph, checked.rules, opened.document, tags));
    return checked;
}

}  // namespace filigree
