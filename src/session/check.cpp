#include "session/check.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "engines/rewriting/read_grammar.h"
#include "engines/shape/read_grammar.h"
#include "language/style.h"
#include "session/engines.h"
#include "session/list_choices.h"
#include "session/path_graph.h"

namespace filigree {
namespace {

Diagnostic unknown_engine(const Settings& settings) {
    std::vector<std::string_view> names;
    for (const EngineInfo& engine : engines()) names.push_back(engine.name);
    std::vector<std::string> hints = did_you_mean(settings.engine, names);
    if (hints.empty()) hints.push_back("known are tangle, rewriting and shape");
    return error("document.unknown-grammar", "there is no kind of grammar '" + settings.engine + "'",
                 settings.engine_span, hints);
}

// Of styles for what nothing is called.
Diagnostics style_warnings(const Settings& settings, const std::vector<std::string_view>& known) {
    Diagnostics warnings;
    for (const StyleStatement* style : settings.styles) {
        for (const Name& tag : style->tags) {
            if (tag.text == "*" || std::find(known.begin(), known.end(), tag.text) != known.end()) continue;
            warnings.push_back(warning("style.unknown-tag", "nothing is called '" + tag.text + "'", tag.span,
                                       did_you_mean(tag.text, known)));
        }
    }
    return warnings;
}

// A system's required parameters get example values.
DocumentSite example_site(const EmbeddableDocument& info) {
    DocumentSite site;
    for (const std::string& name : info.required) site.given.emplace_back(name, Value{Quantity{1, 0, false}, {}});
    return site;
}

// What is said of a document as a whole has a place only where it is embedded.
Diagnostics with_place(Diagnostics diagnostics, SourceSpan place) {
    if (place.file == SourceSpan::no_file) return diagnostics;
    for (Diagnostic& diagnostic : diagnostics) {
        const SourceSpan& span = diagnostic.span;
        if (span.file == SourceSpan::no_file || span == SourceSpan{0, 0, 0}) diagnostic.span = place;
    }
    return diagnostics;
}

// What words have no use for.
Diagnostics not_for_words(const Document& document) {
    Diagnostics problems;
    const auto refuse = [&](std::string_view what, std::string_view why, const Statement& statement) {
        problems.push_back(error("document.not-for-words",
                                 "a rewriting grammar has no '" + std::string(what) + "': " + std::string(why),
                                 statement.span));
    };
    for (const Statement& statement : document.statements) {
        if (std::holds_alternative<StartStatement>(statement.node))
            refuse("start", "it begins with its axiom", statement);
        if (std::holds_alternative<OperatorStatement>(statement.node))
            refuse("operator", "its rules rewrite symbols", statement);
        if (std::holds_alternative<SymmetryStatement>(statement.node))
            refuse("symmetry", "embed it in a document that has one", statement);
        if (std::holds_alternative<ApplyStatement>(statement.node))
            refuse("apply", "what is done by hand is an edit, as in 'once insert(...)'", statement);
        const auto* style = std::get_if<StyleStatement>(&statement.node);
        if (style == nullptr) continue;
        for (const StyleProperty& property : style->properties) {
            if (property.name.text != "wobble" && property.name.text != "wobble_length") continue;
            problems.push_back(warning("style.no-wobble", "what words draw does not waver", property.name.span,
                                       {"'line: drawn' draws lines as a pen in a hand does"}));
        }
    }
    return problems;
}

// Checks a document and those that it embeds, each on its own and once.
class Checker {
public:
    Diagnostics diagnostics;  // of all of them, with places in the outermost one's sources

    CheckedDocument check(const OpenedDocument& opened, const DocumentSite& site) {
        CheckedDocument checked;
        for (const Statement& statement : opened.document.statements) {
            if (const auto* rule = std::get_if<GroupRule>(&statement.node)) checked.rules.push_back(rule);
        }
        checked.graph = tangle::rule_graph(checked.rules);
        const auto take = [&](Diagnostics problems) {
            append(diagnostics, at_first_source(with_place(std::move(problems), opened.place), opened));
        };
        // Nothing of it could be read: all that follows from that would only be said beside the reason.
        if (opened.has_failed && opened.document.statements.empty()) return checked;

        Result<Settings> settings = read_settings(opened.document, site);
        take(settings.diagnostics());
        // A rewriting document reads its systems itself.
        if (settings && settings->engine == "rewriting") {
            for (const EmbeddedDocument& inner : opened.embedded) {
                checked.embedded.push_back(inner.info.is_file ? check_other_word(inner) : nullptr);
            }
            checked.settings = std::move(*settings);
            checked.shapes = std::make_shared<const ShapeSource>(opened.inputs, checked.settings->resolution);
            take(read_words(opened, checked));
            take(read_styles(*checked.settings, opened.document).diagnostics());
            take(check_presets(opened, checked));
            take(not_for_words(opened.document));
            return checked;
        }
        if (settings && settings->engine == "shape") {
            checked.settings = std::move(*settings);
            checked.shapes = std::make_shared<const ShapeSource>(opened.inputs, checked.settings->resolution);
            if (!opened.has_failed) take(read_design(opened, checked));
            take(read_styles(*checked.settings, opened.document).diagnostics());
            if (checked.design) {
                std::vector<std::string_view> names = {checked.design->start_tag};
                for (const shape::Rule& rule : checked.design->rules) names.push_back(rule.name);
                take(style_warnings(*checked.settings, names));
                take(check_presets(opened, checked));
            }
            return checked;
        }
        for (const EmbeddedDocument& inner : opened.embedded) checked.embedded.push_back(check_embedded(inner));
        if (!settings) return checked;
        checked.settings = std::move(*settings);
        if (checked.settings->engine != "tangle") {
            if (!checked.settings->engine.empty()) take({unknown_engine(*checked.settings)});
            return checked;
        }
        checked.shapes = std::make_shared<const ShapeSource>(opened.inputs, checked.settings->resolution);
        // A missing file is said already; the start would only say it again.
        if (!opened.has_failed) {
            Result<PlaneStart> start = make_plane_start(*checked.settings, opened.document, *checked.shapes, site);
            take(start.diagnostics());
            if (start) checked.start = std::move(*start);
        }
        const std::vector<std::string> tags =
            start_tags(opened, *checked.settings, checked.start ? &*checked.start : nullptr);
        Result<tangle::Grammar> grammar =
            tangle::read_grammar(*checked.settings, opened.document, tags, embeddable(opened));
        take(grammar.diagnostics());
        take(read_styles(*checked.settings, opened.document).diagnostics());
        if (grammar) {
            checked.grammar = std::move(*grammar);
            take(style_warnings(*checked.settings, {checked.grammar->tags.begin(), checked.grammar->tags.end()}));
            take(check_presets(opened, checked));
        }
        std::vector<std::string> produced = tags;  // not by rules: by starts, and by steps that are applied by hand
        for (const ApplyStatement* apply : checked.settings->applies) {
            for (const OutputTag& output : apply->outputs) produced.push_back(output.tag);
        }
        take(tangle::graph_warnings(checked.graph, checked.rules, opened.document, produced));
        return checked;
    }

private:
    std::shared_ptr<const CheckedDocument> check_embedded(const EmbeddedDocument& inner) {
        if (!inner.opened) return nullptr;
        const auto known = known_.find(inner.opened.get());
        if (known != known_.end()) return known->second;
        auto checked = std::make_shared<const CheckedDocument>(check(*inner.opened, example_site(inner.info)));
        known_.emplace(inner.opened.get(), checked);
        return checked;
    }
    // What an edit of words names.
    std::shared_ptr<const CheckedDocument> check_other_word(const EmbeddedDocument& inner) {
        auto checked = check_embedded(inner);
        if (checked && checked->settings && checked->settings->engine != "rewriting") {
            append(diagnostics,
                   at_first_source({error("rewriting.no-word",
                                          "'" + inner.info.name + "' is no rewriting grammar, so it has no word",
                                          checked->settings->engine_span)},
                                   *inner.opened));
        }
        return checked;
    }

    std::map<const OpenedDocument*, std::shared_ptr<const CheckedDocument>> known_;  // looked up only
};

}  // namespace

namespace {

// Some faults are met on two ways: where a value is used and where its preset is checked.
Diagnostics each_once(Diagnostics all) {
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::string>> said;
    std::erase_if(all, [&](const Diagnostic& one) {
        return one.span.file != SourceSpan::no_file &&
               !said.emplace(one.span.file, one.span.begin, one.span.end, one.code).second;
    });
    return all;
}

}  // namespace

CheckedDocument check_document(const OpenedDocument& opened, const Replay* replay) {
    Diagnostics all = opened.diagnostics;
    std::shared_ptr<const Replay> own;
    if (!opened.choices.empty()) {
        Result<Replay> read = read_choices(opened.choices);
        append(all, read.diagnostics());
        if (read) own = std::make_shared<const Replay>(std::move(*read));
    }
    DocumentSite site;
    site.replay = replay != nullptr ? replay : own.get();
    Checker checker;
    CheckedDocument checked = checker.check(opened, site);
    checked.replay = std::move(own);
    append(all, std::move(checker.diagnostics));
    checked.diagnostics = each_once(std::move(all));
    return checked;
}

Diagnostics read_words(const OpenedDocument& opened, CheckedDocument& checked) {
    Diagnostics problems;
    Result<rewriting::Grammar> words = rewriting::read_grammar(*checked.settings, opened.document, opened.inputs);
    append(problems, words.diagnostics());
    if (words) checked.words = std::move(*words);
    Result<rewriting::DrawRules> draw_rules = rewriting::read_draw_rules(*checked.settings, opened.document);
    append(problems, draw_rules.diagnostics());
    if (draw_rules) checked.draw_rules = std::move(*draw_rules);
    return problems;
}

Diagnostics read_design(const OpenedDocument& opened, CheckedDocument& checked) {
    Result<shape::Grammar> design = shape::read_grammar(*checked.settings, opened.document, *checked.shapes);
    if (design) checked.design = std::move(*design);
    return design.diagnostics();
}

std::vector<std::string> start_tags(const OpenedDocument& opened, const Settings& settings, const PlaneStart* start) {
    std::vector<std::string> tags;
    bool has_layers = false;
    for (const Statement& statement : opened.document.statements) {
        const auto* said = std::get_if<StartStatement>(&statement.node);
        if (said == nullptr) continue;
        has_layers = has_layers || said->from;
        if (!said->from) tags.push_back(said->tag.text);
    }
    if (!has_layers) return tags;
    std::optional<PlaneStart> own;
    if (start == nullptr) {
        const ShapeSource shapes(opened.inputs, settings.resolution);
        Result<PlaneStart> made = make_plane_start(settings, opened.document, shapes);
        if (!made) return tags;
        own = std::move(*made);
        start = &*own;
    }
    for (const StartGroup& group : start->groups) {
        if (std::find(tags.begin(), tags.end(), group.tag) == tags.end()) tags.push_back(group.tag);
    }
    return tags;
}

EmbeddableDocuments embeddable(const OpenedDocument& opened) {
    EmbeddableDocuments documents;
    for (const EmbeddedDocument& inner : opened.embedded) documents.push_back(inner.info);
    return documents;
}

}  // namespace filigree
