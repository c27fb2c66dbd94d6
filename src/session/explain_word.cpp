#include "session/explain_word.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "engines/rewriting/explain.h"
#include "engines/rewriting/symbols.h"
#include "session/list_word.h"

namespace filigree {
namespace {

using Json = nlohmann::ordered_json;
using rewriting::Fate;
using rewriting::Rule;
using rewriting::RuleTrial;
using rewriting::SymbolMoment;
using rewriting::Verdict;

std::string letter_text(char32_t letter) { return rewriting::to_utf8(std::u32string(1, letter)); }
std::string quoted(const std::u32string& letters) { return "'" + shown(letters) + "'"; }

// Each as one word and as the end of a sentence about the symbol.
struct FateText {
    std::string_view name, text;
};
FateText text_of(Fate fate) {
    switch (fate) {
        case Fate::rewritten:
            return {"rewritten", "rewritten"};
        case Fate::kept:
            return {"kept", "kept, since no rule applies"};
        case Fate::asleep:
            return {"asleep", "kept, since it sleeps"};
        case Fate::resting:
            return {"resting", "kept by "};  // a mask or a sleep
        case Fate::at_rest:
            return {"at-rest", "kept, since the iterations of its system are over"};
        case Fate::counted:
            return {"counted", "counted with its run"};
        case Fate::inverted:
            return {"inverter", "what makes the run before it shrink"};
        case Fate::repeated:
            return {"repeated", "replaced by the whole word"};
        case Fate::drawn:
            return {"drawn", "replaced by letters at random"};
        case Fate::recalled:
            return {"recalled", "replaced by letters drawn before"};
        case Fate::grown:
            return {"grown", "replaced by the word of its system"};
    }
    return {};
}

std::string_view name_of(const RuleTrial& trial) {
    if (!trial.verdict) return "not-tried";
    switch (*trial.verdict) {
        case Verdict::applies:
            return "applies";
        case Verdict::other_iteration:
            return "other-iteration";
        case Verdict::other_row:
            return "other-row";
        case Verdict::no_left:
            return "no-left-context";
        case Verdict::no_right:
            return "no-right-context";
        case Verdict::off_map:
            return "off-map";
        case Verdict::does_not_hold:
            return "condition-is-false";
    }
    return "";
}

std::string said_text(const OpenedDocument& opened, SourceSpan span) {
    const SaidRule said = said_at(opened, span);
    return said.file + ":" + std::to_string(said.line) + ": " + said.text;
}

std::string instead(const RuleTrial& trial, const std::u32string& wanted, std::string_view where) {
    return quoted(wanted) + " does not stand " + std::string(where) + " it, but " +
           (trial.found.empty() ? "nothing" : quoted(trial.found));
}

std::string iterations_text(const Rule& rule) {
    if (rule.first == rule.last) return "iteration " + std::to_string(rule.first);
    return "iterations " + std::to_string(rule.first) + ".." + std::to_string(rule.last);
}

std::string values_text(const RuleTrial& trial) {
    std::string text;
    for (const auto& [name, value] : trial.values) text += (text.empty() ? "" : ", ") + name + " = " + to_text(value);
    return text;
}

std::string reason(const RuleTrial& trial, const SymbolMoment& moment) {
    if (!trial.verdict) return "not tried, since a rule before it applies";
    switch (*trial.verdict) {
        case Verdict::applies: {
            if (!trial.drawn) return "applies";
            std::string weights;
            for (const double weight : trial.weights) weights += (weights.empty() ? "" : ", ") + to_text(weight);
            const std::string drawn = *trial.drawn == trial.weights.size()
                                          ? "none of its successors can be drawn"
                                          : "successor " + std::to_string(*trial.drawn + 1) + " of " +
                                                std::to_string(trial.weights.size()) + " is drawn";
            return "applies; " + drawn + ", by the weights " + weights;
        }
        case Verdict::other_iteration:
            return "serves " + iterations_text(*trial.rule) + ", and this is " + std::to_string(moment.clock);
        case Verdict::other_row: {
            if (!moment.row || moment.row->row >= moment.trials.size()) return "the rows of this letter are over";
            return "row " + std::to_string(moment.row->row + 1) + " of this letter serves this iteration";
        }
        case Verdict::no_left:
            return instead(trial, trial.rule->left, "before");
        case Verdict::no_right:
            return instead(trial, trial.rule->right, "behind");
        case Verdict::off_map:
            return "a map that it looks at has nothing where the symbol stands";
        case Verdict::does_not_hold:
            return "its condition does not hold" + (trial.values.empty() ? "" : ": " + values_text(trial));
    }
    return "";
}

std::string fate_text(const OpenedDocument& opened, const SymbolMoment& moment) {
    return std::string(text_of(moment.fate).text) +
           (moment.rest != nullptr ? said_text(opened, moment.rest->span) : std::string());
}

std::string told(const OpenedDocument& opened, const rewriting::Explanation& explanation) {
    std::string text;
    const SymbolMoment* before = nullptr;
    for (const SymbolMoment& moment : explanation.moments) {
        text += "iteration " + std::to_string(moment.iteration) + ": " + shown({&moment.letter, 1}) + " at " +
                std::to_string(moment.index);
        if (moment.system != 0) text += " of the system " + shown({&moment.system, 1});
        if (moment.turns > 0)
            text += ", asleep for " + std::to_string(moment.turns) + (moment.turns == 1 ? " turn" : " turns");
        if (moment.iteration == 0) {
            text += ", of the axiom";
        } else if (before->rule != nullptr) {
            text += ", put by " + said_text(opened, before->rule->span);
        } else {
            text += ", from the one before, " + fate_text(opened, *before);
        }
        text += "\n";
        before = &moment;
    }
    const SymbolMoment& last = explanation.moments.back();
    text += "iteration " + std::to_string(last.iteration + 1) + ": ";
    text += last.fate == Fate::rewritten || !explanation.next ? "" : fate_text(opened, last) + "; ";
    text += explanation.next ? "it becomes \"" + shown(*explanation.next) + "\"\n" : "it cannot be made\n";
    for (const RuleTrial& trial : last.trials) {
        text += "  " + said_text(opened, trial.rule->span) + "\n    " + reason(trial, last) + "\n";
    }
    return text;
}

Json said_json(const OpenedDocument& opened, SourceSpan span) {
    const SaidRule said = said_at(opened, span);
    return {{"file", said.file}, {"line", said.line}, {"text", said.text}};
}

Json moment_json(const OpenedDocument& opened, const SymbolMoment& moment) {
    Json json;
    json["iteration"] = moment.iteration;
    json["index"] = moment.index;
    json["symbol"] = letter_text(moment.letter);
    json["system"] = moment.system == 0 ? Json(nullptr) : Json(letter_text(moment.system));
    json["turns"] = moment.turns;
    json["then"] = text_of(moment.fate).name;
    json["rule"] = nullptr;
    if (moment.rule != nullptr) json["rule"] = said_json(opened, moment.rule->span);
    if (moment.rest != nullptr) json["held_by"] = said_json(opened, moment.rest->span);
    return json;
}

Json trial_json(const OpenedDocument& opened, const RuleTrial& trial, const SymbolMoment& moment) {
    Json json;
    json["rule"] = said_json(opened, trial.rule->span);
    json["verdict"] = name_of(trial);
    json["reason"] = reason(trial, moment);
    for (const auto& [name, value] : trial.values) json["values"][name] = value;
    if (trial.verdict == Verdict::no_left || trial.verdict == Verdict::no_right) {
        json["found"] = rewriting::to_utf8(trial.found);
    }
    if (trial.drawn) {
        json["weights"] = trial.weights;
        json["drawn"] = *trial.drawn == trial.weights.size() ? Json(nullptr) : Json(*trial.drawn);
    }
    return json;
}

std::string as_data(const OpenedDocument& opened, const CheckedDocument& checked,
                    const rewriting::Explanation& explanation) {
    const SymbolMoment& last = explanation.moments.back();
    Json json;
    json["document"] = opened.name;
    json["engine"] = checked.settings->engine;
    json["seed"] = checked.settings->seed;
    json["position"] = last.index;
    json["moments"] = Json::array();
    for (const SymbolMoment& moment : explanation.moments) json["moments"].push_back(moment_json(opened, moment));
    json["next"]["iteration"] = last.iteration + 1;
    json["next"]["becomes"] = explanation.next ? Json(rewriting::to_utf8(*explanation.next)) : Json(nullptr);
    json["next"]["rules"] = Json::array();
    for (const RuleTrial& trial : last.trials) json["next"]["rules"].push_back(trial_json(opened, trial, last));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

// The edit that comes first, where the word after so many iterations is not what the rules alone make.
const rewriting::WordEdit* edit_up_to(const std::vector<rewriting::WordEdit>& edits, std::uint64_t steps) {
    // Behind the last iteration is behind whichever is asked for.
    const auto first_word = [](const rewriting::WordEdit& edit) { return edit.is_once ? 0 : edit.first; };
    const auto first = std::min_element(edits.begin(), edits.end(), [&](const auto& one, const auto& other) {
        return first_word(one) < first_word(other);
    });
    return first == edits.end() || first_word(*first) > steps ? nullptr : &*first;
}

}  // namespace

SaidRule said_at(const OpenedDocument& opened, SourceSpan span) {
    const SourceFile& source = opened.document.sources[span.file];
    const std::string all = source.text.substr(span.begin, span.end - span.begin);
    return {source.name, line_column(source.text, span.begin).line, all.substr(0, all.find('\n'))};
}

Result<std::string> explain_word(const OpenedDocument& opened, const CheckedDocument& checked,
                                 std::optional<std::uint64_t> steps, std::uint64_t position, bool as_json,
                                 const Job& job) {
    const rewriting::Grammar& grammar = *checked.words;
    const std::uint64_t count = steps.value_or(grammar.systems[0].iterations);
    if (const rewriting::WordEdit* edit = edit_up_to(grammar.edits, count)) {
        return error(
            "rewriting.edited-word", "this edits the word, so rules alone do not say how its symbols came", edit->span,
            {edit->is_once ? "without the edit, the word before it can be explained"
                           : "the words up to --steps " + std::to_string(edit->first - 1) + " can be explained"});
    }
    const Result<rewriting::Explanation> explanation =
        rewriting::explain(grammar, word_options(opened, checked), count, position, job);
    if (!explanation) return explanation.diagnostics();
    return as_json ? as_data(opened, checked, *explanation) : told(opened, *explanation);
}

}  // namespace filigree
