#include "language/shape_rules.h"

#include <algorithm>
#include <map>

#include "base/number_text.h"
#include "language/names.h"
#include "language/shape_checks.h"
#include "language/shape_forms.h"

namespace filigree {
namespace {

using Kind = NamedShapeRule::Kind;

std::string quoted(std::string_view name) { return "'" + std::string(name) + "'"; }

class RulesReader {
public:
    RulesReader(const Document& document, std::span<const DrawnRule> drawn) : document_(document), drawn_(drawn) {}

    ShapeRules rules;
    Diagnostics diagnostics;

    void run() {
        for (const Statement& statement : document_.statements) {
            if (const auto* rule = std::get_if<ShapeRule>(&statement.node)) add(*rule);
        }
        for (const DrawnRule& drawn : drawn_) add(drawn);
        for (NamedShapeRule& rule : rules.rules) {
            if (rule.statement != nullptr && rule.statement->derivation) follow(rule);
        }
        find_order();
        for (const Statement& statement : document_.statements) {
            if (const auto* match = std::get_if<MatchStatement>(&statement.node)) add(*match);
            if (const auto* setting = std::get_if<SettingStatement>(&statement.node)) add(*setting);
        }
    }

private:
    const Document& document_;
    std::span<const DrawnRule> drawn_;
    std::map<std::string, std::size_t, std::less<>> by_name_;
    std::map<std::string, SourceSpan, std::less<>> settings_;

    void report(Diagnostic diagnostic) { diagnostics.push_back(std::move(diagnostic)); }

    std::string line_of(SourceSpan span) const {
        const SourceFile& source = document_.sources.at(span.file);
        return "line " + to_text(std::uint64_t{line_column(source.text, span.begin).line}) +
               (span.file == 0 ? "" : " of " + source.name);
    }

    void add(const ShapeRule& rule) { add({.name = rule.name.text, .statement = &rule}, rule.name.span); }
    void add(const DrawnRule& rule) { add({.kind = Kind::drawn, .name = rule.name}, rule.file); }
    void add(NamedShapeRule rule, SourceSpan span) {
        const auto [first, is_new] = by_name_.emplace(rule.name, rules.rules.size());
        if (!is_new) {
            const ShapeRule* other = rules.rules[first->second].statement;
            std::vector<std::string> hints;
            if (other != nullptr) hints = {"the other one is on " + line_of(other->name.span)};
            report(error("language.doubled-name", "there is another rule " + quoted(rule.name), span, hints));
        }
        rules.rules.push_back(std::move(rule));
    }

    std::optional<std::size_t> rule_named(std::string_view name, SourceSpan span) {
        if (const auto found = by_name_.find(name); found != by_name_.end()) return found->second;
        std::vector<std::string_view> known;
        for (const auto& [other, index] : by_name_) known.push_back(other);
        std::vector<std::string> hints = did_you_mean(name, known);
        if (hints.empty() && !known.empty()) hints = {"the rules are " + quoted_alternatives(known)};
        report(error("language.unknown-rule", "there is no rule " + quoted(name), span, std::move(hints)));
        return std::nullopt;
    }

    // inverse(RULE), or mirror(RULE, angle)
    void follow(NamedShapeRule& rule) {
        const Expression& expression = *rule.statement->derivation;
        const auto& call = std::get<CallExpression>(expression.node);
        const OperatorDescription* way = find_operator(rule_derivations(), call.name);
        if (way == nullptr) return fail_unknown_way(rule, call);
        const Expression* base = nullptr;
        std::size_t positional = 0;
        for (const CallArgument& argument : call.arguments) {
            const ParameterDescription* parameter = parameter_of(*way, argument, positional);
            if (!argument.key) ++positional;
            const bool is_rule = parameter != nullptr && parameter->name == "rule";
            if (parameter == nullptr || (is_rule ? base != nullptr : rule.angle != nullptr)) {
                return fail_arguments(*way, argument.key ? argument.key->span : argument.value->span);
            }
            if (is_rule) {
                base = argument.value.get();
            } else {
                rule.angle = argument.value;
            }
        }
        const auto* name = base == nullptr ? nullptr : std::get_if<NameReference>(&base->node);
        if (name == nullptr) return fail_arguments(*way, base == nullptr ? expression.span : base->span);
        const std::optional<std::size_t> found = rule_named(name->name, base->span);
        if (!found) return;
        rule.kind = way->name == "inverse" ? Kind::inverse : Kind::mirror;
        rule.base = *found;
    }
    void fail_unknown_way(const NamedShapeRule& rule, const CallExpression& call) {
        std::vector<std::string_view> known;
        for (const OperatorDescription& way : rule_derivations()) known.push_back(way.name);
        std::vector<std::string> hints = did_you_mean(call.name, known);
        if (hints.empty()) {
            hints = {"a shape with a name is written 'let " + rule.name + " = ...'",
                     "a rule follows from another one by 'inverse(rule)' or 'mirror(rule, angle)'"};
        }
        report(error("language.unknown-derivation", "no rule follows from another one by " + quoted(call.name),
                     call.name_span, std::move(hints)));
    }
    void fail_arguments(const OperatorDescription& way, SourceSpan span) {
        report(error("language.wrong-arguments",
                     quoted(way.name) + " takes the name of a rule" +
                         (way.parameters.size() > 1 ? " and an angle" : " and nothing else"),
                     span, {"as in '" + std::string(way.example) + "'"}));
    }

    // Each rule behind the one that it follows from; those that follow from themselves are errors, each circle one.
    void find_order() {
        enum class State : std::uint8_t { open, on_way, done };
        std::vector<State> states(rules.rules.size(), State::open);
        for (std::size_t first = 0; first < rules.rules.size(); ++first) {
            std::vector<std::size_t> way;
            std::size_t at = first;
            while (states[at] == State::open) {
                states[at] = State::on_way;
                way.push_back(at);
                if (!follows(at)) break;
                at = rules.rules[at].base;
            }
            if (states[at] == State::on_way && follows(at)) fail_circle(way, at);
            for (auto one = way.rbegin(); one != way.rend(); ++one) {
                states[*one] = State::done;
                rules.in_order.push_back(*one);
            }
        }
    }
    bool follows(std::size_t rule) const {
        return rules.rules[rule].kind == Kind::inverse || rules.rules[rule].kind == Kind::mirror;
    }
    void fail_circle(const std::vector<std::size_t>& way, std::size_t first) {
        constexpr std::ptrdiff_t most_shown = 10;
        const auto begin = std::find(way.begin(), way.end(), first);
        const bool is_long = way.end() - begin > most_shown;
        std::string circle;
        for (auto at = begin; at != (is_long ? begin + most_shown : way.end()); ++at) {
            circle += rules.rules[*at].name + " -> ";
        }
        if (is_long) circle += "... -> ";
        const NamedShapeRule& rule = rules.rules[first];
        report(error("language.rule-cycle", "the rule " + quoted(rule.name) + " follows from itself",
                     rule.statement->name.span, {"the circle is " + circle + rule.name}));
    }

    void add(const MatchStatement& match) {
        const auto rule = rule_named(match.rule.text, match.rule.span);
        if (rule) rules.applies.push_back({&match, *rule});
    }
    void add(const SettingStatement& setting) {
        const auto [first, is_new] = settings_.emplace(setting.name.text, setting.name.span);
        if (is_new) return rules.settings.push_back(&setting);
        report(error("language.repeated-statement", quoted(setting.name.text) + " is already given", setting.name.span,
                     {"it is given on " + line_of(first->second)}));
    }
};

}  // namespace

Result<ShapeRules> read_shape_rules(const Document& document, const Scope& globals, std::span<const DrawnRule> drawn,
                                    const Scope* varying) {
    RulesReader reader(document, drawn);
    reader.run();
    append(reader.diagnostics, check_shape_expressions(document, reader.rules, globals, varying));
    if (has_errors(reader.diagnostics)) return std::move(reader.diagnostics);
    return {std::move(reader.rules), std::move(reader.diagnostics)};
}

}  // namespace filigree
