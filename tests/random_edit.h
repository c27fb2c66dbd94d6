// Random edits of a document's text, as a person or a studio would make them: what presets say of a place of its
// derivation (set, default, keep, reroll, apply), and changes of its statements. An edit may well be wrong: then the
// new document has errors.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/executor.h"
#include "base/test_cases.h"
#include "engines/tangle/paths.h"
#include "language/edit.h"
#include "language/edit_text.h"
#include "session/edit_document.h"
#include "session/list_choices.h"
#include "session/workspace.h"

namespace filigree {

// A document with its derivation; null where it is wrong or reaches a limit.
inline std::shared_ptr<DocumentState> grown(std::string text, const RunOptions& options, Executor& executor) {
    auto state = std::make_shared<DocumentState>();
    state->opened = open_text("random.fil", std::move(text), {});
    state->checked = check_document(state->opened, options.replay);
    if (has_errors(state->checked.diagnostics)) return nullptr;
    Result<Run> run = run_document(state->opened, state->checked, options, executor, {});
    if (!run) return nullptr;
    state->run = std::move(*run);
    return state;
}

// One choice of a run as an edit may name it.
struct NamedChoice {
    std::string place;  // of the group, the step, the shape or the name
    std::string path;   // "a/outline.distance~2", "let/gap~2"
    const Choices* choices = nullptr;
    std::size_t row = 0;

    const ChoiceDomain& domain() const { return choices->domain_table[choices->domains[row]]; }
    double value() const { return choices->values[row]; }
    Key key() const { return choices->keys[row]; }
    const std::string& name() const { return choices->name_table[choices->names[row]]; }
    ChoiceSource source() const { return choices->sources[row]; }
    std::string identity() const { return to_hex(key().value) + " " + name(); }
};
inline std::vector<NamedChoice> named_choices(const DocumentState& state) {
    std::vector<NamedChoice> all;
    for_each_choice(state.opened, state.checked, state.run, [&](const ListedChoice& choice) {
        NamedChoice one{choice.path, choice.path, choice.choices, choice.row};
        const bool is_definition = choice.path.find("let/") != std::string::npos;
        if (is_definition) {
            one.path += choice.name.substr(std::min(choice.name.find('~'), choice.name.size()));
        } else {
            one.path += "." + std::string(choice.name);
        }
        all.push_back(std::move(one));
    });
    return all;
}

// Whole words of a text replaced.
inline std::string with_word(std::string_view text, std::string_view word, std::string_view by) {
    const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && is_letter(text[end])) ++end;
        if (end == i) {
            out += text[i++];
            continue;
        }
        const std::string_view here = text.substr(i, end - i);
        out += here == word ? by : here;
        i = end;
    }
    return out;
}

class RandomEdits {
public:
    struct Made {
        std::string what;
        std::string text;
    };

    explicit RandomEdits(std::uint64_t seed) : random_(seed) {}

    Made next(const DocumentState& state) {
        Made made = any(state);
        const bool is_added = made.text.size() > text().size() && made.text.compare(0, text().size(), text()) == 0;
        if (is_added && random_.below(4) == 0) made.text = with_last_line_before_presets(made.text);
        return made;
    }

    // A value in the domain of a choice, as a document writes it.
    std::string value_for(const NamedChoice& choice) {
        const ChoiceDomain& domain = choice.domain();
        switch (domain.kind) {
            case ChoiceDomain::Kind::range:
                return number_in(domain, random_.between(domain.low, domain.high));
            case ChoiceDomain::Kind::normal: {
                const double low = std::max(domain.low, domain.mean - 2 * domain.deviation);
                const double high = std::min(domain.high, domain.mean + 2 * domain.deviation);
                return number_in(domain, random_.between(low, high));
            }
            case ChoiceDomain::Kind::alternatives:
            case ChoiceDomain::Kind::fixed:
            case ChoiceDomain::Kind::worded:
                break;
        }
        const Value& value = domain.alternatives[random_.index(domain.alternatives.size())];
        return choice.name() == "rule" ? in_quotes(to_text(value)) : text_with_unit(value);
    }

    // A narrower range for a choice from one.
    std::string range_for(const NamedChoice& choice) {
        const ChoiceDomain& domain = choice.domain();
        double low = random_.between(domain.low, domain.high), high = random_.between(domain.low, domain.high);
        if (low > high) std::swap(low, high);
        return number_in(domain, low) + ".." + number_in(domain, high);
    }

    // A path of a group, a step or a parameter, with globs now and then.
    std::string any_path() {
        if (random_.below(20) == 0) return "**";
        if (text().find("hand = ") != std::string::npos && random_.below(8) == 0) return "hand";
        const bool by_choice = !choices_.empty() && random_.below(3) != 0;
        if (by_choice) {
            const NamedChoice& choice = any_choice();
            const std::string path = choice.path.substr(0, choice.path.find('~'));
            if (choice.name().find('?') == std::string::npos) return with_globs(path);
        }
        return with_globs(place());
    }
    // The path of any group or step.
    std::string place() {
        const auto& tangle = state_->run.tangle;
        const auto& grammar = *state_->checked.grammar;
        if (!tangle.steps.empty() && random_.coin()) {
            return path_of_step(tangle, grammar, static_cast<std::uint32_t>(random_.index(tangle.steps.size())));
        }
        return path_of_group(tangle, grammar, static_cast<std::uint32_t>(random_.index(tangle.groups.size())));
    }

private:
    using Kind = DocumentEdit::Kind;

    const Document& document() const { return state_->opened.document; }
    const std::string& text() const { return document().text(); }

    Made any(const DocumentState& state) {
        state_ = &state;
        choices_ = named_choices(state);
        switch (random_.below(21)) {
            case 0:
            case 1:
            case 2:
                return set_value();
            case 3:
                return set_range();
            case 4:
                return set_named();
            case 5:
            case 6:
                return by(Kind::keep, any_path());
            case 7:
            case 8:
            case 9:
                return reroll();
            case 10:
                return is_random();
            case 11:
            case 12:
                return apply();
            case 13:
                return parameter();
            case 14:
                return {"seed", with_seed(document(), random_.below(1000))};
            case 15:
                return append_rule();
            case 16:
                return remove_statement();
            case 17:
                return change_number();
            case 18:
                return swap_statements();
            case 19:
                return remove_preset();
            default:
                return rename_tag();
        }
    }

    Made by(const DocumentEdit& edit) {
        const Result<std::string> made = edited_text(document(), edit);
        return made ? Made{to_text(edit), *made} : nothing("cannot be: " + to_text(edit));
    }
    Made by(Kind kind, std::string path, std::string value = "") {
        DocumentEdit edit;
        edit.kind = kind;
        edit.path = std::move(path);
        edit.value = std::move(value);
        return by(edit);
    }
    Made nothing(std::string why) { return {std::move(why), with_last_line(text(), "# nothing")}; }

    static std::string in_quotes(const std::string& text) {
        return text.size() > 1 && text.front() == '"' ? text : "\"" + text + "\"";
    }
    static std::string number_in(const ChoiceDomain& domain, double value) {
        Quantity quantity = domain.dimension;
        quantity.value = domain.whole ? std::round(value) : value;
        return text_with_unit(Value{quantity, {}});
    }

    const NamedChoice& any_choice() { return choices_[random_.index(choices_.size())]; }

    std::string with_globs(const std::string& path) {
        if (path.rfind("let/", 0) == 0) return path;
        const std::size_t dot = path.rfind('.');
        const std::string place = path.substr(0, dot), parameter = dot == std::string::npos ? "" : path.substr(dot);
        const std::size_t first = place.find('/'), last = place.rfind('/');
        switch (random_.below(8)) {
            case 0:
                return last == std::string::npos ? path : "**/" + place.substr(last + 1) + parameter;
            case 1:
                return place.substr(0, first) + "/**" + parameter;
            case 2:
                return parameter.empty() ? path : "**" + parameter;
            case 3:
                return last == first ? path : place.substr(0, first) + "/**" + place.substr(last) + parameter;
            case 4: {  // any of several groups
                const std::size_t bracket = path.rfind('['), end = path.rfind(']');
                return bracket == std::string::npos ? path : path.substr(0, bracket) + path.substr(end + 1);
            }
            default:
                return path;
        }
    }

    Made set_value() {
        if (choices_.empty()) return nothing("no choice");
        const NamedChoice& choice = any_choice();
        DocumentEdit edit;
        edit.kind = random_.below(4) == 0 ? Kind::set_default : Kind::set;
        edit.value = value_for(choice);
        const std::size_t draw = choice.path.find('~');
        edit.path = draw == std::string::npos ? with_globs(choice.path) : choice.path;
        Made made = by(edit);
        if (random_.below(6) == 0) made.text = with_condition(made.text);
        return made;
    }
    // As a person writes it who keeps a document tidy: the presets that are there come behind it.
    static std::string with_last_line_before_presets(const std::string& of) {
        const std::size_t end = of.find_last_not_of('\n');
        const std::size_t line = of.rfind('\n', end) + 1;
        const std::string last = of.substr(line);
        std::size_t at = line;
        for (const char* word : {"\nset ", "\ndefault ", "\nkeep ", "\nreroll ", "\napply "}) {
            const std::size_t found = of.find(word);
            if (found != std::string::npos) at = std::min(at, found + 1);
        }
        return of.substr(0, at) + last + of.substr(at, line - at);
    }
    // The last line, a preset, with a condition.
    std::string with_condition(std::string of) {
        const std::size_t end = of.find_last_not_of('\n');
        const std::size_t line = of.rfind('\n', end);
        if (of.compare(line + 1, 4, "set ") != 0 && of.compare(line + 1, 8, "default ") != 0) return of;
        static constexpr const char* conditions[] = {" when count > 2", " when (0..1) < 0.5", " when depth < 3"};
        return of.insert(end + 1, conditions[random_.below(3)]);
    }

    Made reroll() {
        DocumentEdit edit;
        edit.kind = Kind::reroll;
        edit.path = any_path();
        edit.times = 1 + random_.below(3);
        return by(edit);
    }

    Made set_range() {
        for (int tried = 0; tried < 20 && !choices_.empty(); ++tried) {
            const NamedChoice& choice = any_choice();
            if (choice.domain().kind != ChoiceDomain::Kind::range) continue;
            return by(Kind::set, choice.path, range_for(choice));
        }
        return nothing("no range");
    }

    // A value for a step that an `apply` has named, wherever it now stands.
    Made set_named() {
        const bool outlines = text().find("hand = outline") != std::string::npos;
        const bool splits = text().find("hand = regular_split") != std::string::npos;
        if (!outlines && !splits) return set_rule();
        return by(Kind::set, outlines ? "hand.distance" : "hand.offset", "2px..9px");
    }

    Made set_rule() {
        const auto& tangle = state_->run.tangle;
        const auto& grammar = *state_->checked.grammar;
        const auto group = static_cast<std::uint32_t>(random_.index(tangle.groups.size()));
        const std::vector<std::uint32_t>& rules = grammar.rules_of_tag[tangle.groups[group].tag];
        if (rules.empty()) return nothing("no rule");
        const auto any = [&] { return in_quotes(grammar.rules[rules[random_.index(rules.size())]].segment); };
        const std::string one = any(), two = any();
        const std::string value = random_.below(4) != 0 ? one
                                  : one == two          ? "none"
                                                        : "one_of(" + one + ", " + two + ": 2)";
        return by(Kind::set, with_globs(path_of_group(tangle, grammar, group) + ".rule"), value);
    }

    Made is_random() {
        const std::string path = random_.coin() ? "**" : random_.coin() ? place() : "t0/**";
        return by(Kind::set, path + ".is_random", random_.below(5) == 0 ? "true" : "false");
    }

    Made apply() {
        static constexpr const char* calls[] = {
            "outline(2px..5px)", "regular_split(12px, angle: 30)", "fill(#2060a0)",       "ungroup()",
            "regroup(2)",        "place(6px, 8px..12px)",          "hand = outline(3px)", "invert()",
            "stipple()",         "hand = regular_split(9px)"};
        DocumentEdit edit;
        edit.kind = Kind::apply;
        edit.value = calls[random_.below(10)];
        if (text().find("operator lace") != std::string::npos && random_.below(4) == 0) edit.value = "lace(width: 3px)";
        if (text().find("system weave") != std::string::npos && random_.below(4) == 0) edit.value = "embed(weave)";
        const auto target = [&] {
            const auto& tangle = state_->run.tangle;
            const auto group = static_cast<std::uint32_t>(random_.index(tangle.groups.size()));
            std::string path = path_of_group(tangle, *state_->checked.grammar, group);
            const tangle::Group& of = tangle.groups[group];
            if (of.picked == 0 && random_.below(4) == 0) {
                path += "/" + std::to_string(of.number_of(random_.index(of.shapes.size())));
            }
            return path;
        };
        edit.targets.push_back(target());
        if (random_.below(4) == 0) edit.targets.push_back(target());
        edit.outputs = random_.below(3) == 0 ? "t3, fresh" : "fresh";
        return by(edit);
    }

    Made parameter() {
        if (text().find("param gap") == std::string::npos) return change_number();
        const std::string value = std::to_string(5 + random_.below(50)) + "px";
        const Result<std::string> made = with_parameter(document(), "gap", value);
        return made ? Made{"gap = " + value, *made} : nothing("no such parameter");
    }

    Made append_rule() {
        static constexpr const char* rules[] = {
            "outline(2px) : t1 -> t3, t4",
            "extra = outline(1px..3px) : t2 weight 0.5 -> t3, t4",
            "ungroup() : t1 -> t2",
            "never = invert() : t1 when count > 100000 -> t2",
            "regular_split(15px, angle: 0..90) : t2 weight 2 -> t4",
            "fill(#606060) : t3 when group < 3 -> t5",
        };
        const std::string rule = rules[random_.below(6)];
        return {"rule " + rule, with_last_line(text(), rule)};
    }

    // Any but those that a document needs.
    std::vector<const Statement*> removable() const {
        std::vector<const Statement*> found;
        for (const Statement& statement : document().statements) {
            const bool is_needed = std::holds_alternative<GrammarStatement>(statement.node) ||
                                   std::holds_alternative<StartStatement>(statement.node) ||
                                   std::holds_alternative<LimitStatement>(statement.node);
            if (!is_needed) found.push_back(&statement);
        }
        return found;
    }
    std::string text_of(const Statement& statement) const {
        return text().substr(statement.span.begin, statement.span.end - statement.span.begin);
    }

    Made remove_statement() {
        const std::vector<const Statement*> all = removable();
        const Statement& one = *all[random_.index(all.size())];
        return {"without " + text_of(one), without_statement(text(), one.span.begin, one.span.end)};
    }

    Made remove_preset() {
        std::vector<const Statement*> found;
        for (const Statement* one : removable()) {
            const bool is_preset = std::holds_alternative<PresetStatement>(one->node) ||
                                   std::holds_alternative<KeepStatement>(one->node) ||
                                   std::holds_alternative<RerollStatement>(one->node) ||
                                   std::holds_alternative<ApplyStatement>(one->node);
            if (is_preset) found.push_back(one);
        }
        if (found.empty()) return nothing("no preset");
        const Statement& one = *found[random_.index(found.size())];
        return {"without " + text_of(one), without_statement(text(), one.span.begin, one.span.end)};
    }

    Made swap_statements() {
        const std::vector<const Statement*> all = removable();
        const Statement* first = all[random_.index(all.size())];
        const Statement* second = all[random_.index(all.size())];
        if (first == second) return nothing("one statement");
        if (first->span.begin > second->span.begin) std::swap(first, second);
        const std::string later = spliced(text(), second->span.begin, second->span.end, text_of(*first));
        return {"swapped " + text_of(*first) + " and " + text_of(*second),
                spliced(later, first->span.begin, first->span.end, text_of(*second))};
    }

    bool is_low_end(std::size_t at) const {
        const std::size_t end = text().find_first_not_of("0123456789.px", at);
        return text().substr(at, end - at).find("..") != std::string::npos;
    }

    // A number behind a bracket or a comma, a little larger or smaller: an argument of any statement.
    Made change_number() {
        std::vector<std::size_t> places;
        for (std::size_t i = 1; i < text().size(); ++i) {
            const bool is_digit = std::isdigit(static_cast<unsigned char>(text()[i])) != 0;
            const std::size_t before = text().find_last_not_of(' ', i - 1);
            const bool begins = before != std::string::npos && std::string_view("(,:").find(text()[before]) < 3;
            // The low end of a range is left alone: above the high one it would be an error, as it mostly was.
            if (is_digit && begins && !is_low_end(i)) places.push_back(i);
        }
        if (places.empty()) return nothing("no number");
        const std::size_t at = places[random_.index(places.size())];
        const std::size_t end = text().find_first_not_of("0123456789", at);
        const int number = std::atoi(text().substr(at, end - at).c_str());
        const std::string changed = std::to_string(number + 1 + static_cast<int>(random_.below(3)));
        return {"number at " + std::to_string(at) + ": " + changed, spliced(text(), at, end, changed)};
    }

    Made rename_tag() {
        const std::string tag = "t" + std::to_string(random_.below(6));
        const std::string other = "t" + std::to_string(10 + random_.below(90)) + "_renamed";
        return {tag + " renamed " + other, with_word(text(), tag, other)};
    }

    CaseRandom random_;
    const DocumentState* state_ = nullptr;
    std::vector<NamedChoice> choices_;
};

}  // namespace filigree
