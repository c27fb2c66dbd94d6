#include "session/path_graph.h"

#include <algorithm>
#include <map>

#include "derivation/start_shapes.h"
#include "engines/rewriting/edit_operators.h"
#include "language/argument_check.h"
#include "language/check.h"
#include "language/style.h"
#include "language/walk.h"
#include "session/check_word_preset.h"

namespace filigree {
namespace {

using tangle::none;

class PathBuilder {
public:
    DocumentPaths build(const OpenedDocument& opened, const CheckedDocument& checked) {
        paths_.graph.roots = add_document(opened, checked);
        return std::move(paths_);
    }

private:
    PathNode& node(std::uint32_t index) { return paths_.graph.nodes[index]; }

    std::uint32_t add_node(PathNode node, PathPlace place) {
        paths_.graph.nodes.push_back(std::move(node));
        paths_.places.push_back(place);
        return static_cast<std::uint32_t>(paths_.graph.nodes.size() - 1);
    }

    // The nodes of one document; its roots. Each document is added once.
    std::vector<std::uint32_t> add_document(const OpenedDocument& opened, const CheckedDocument& checked) {
        const auto known = roots_.find(&checked);
        if (known != roots_.end()) return known->second;
        std::vector<std::uint32_t> roots;
        const PathPlace here{&opened, &checked, none, none, nullptr, false, {}};
        const std::uint32_t definitions = add_definitions(opened, here);
        if (checked.grammar) {
            const std::vector<std::uint32_t> tags = add_tags(*checked.grammar, here);
            const std::vector<std::uint32_t> rules = add_rules(opened, checked, here, tags);
            for (const std::uint32_t start : add_starts(opened, *checked.grammar, here, tags)) roots.push_back(start);
            add_applied(opened, *checked.grammar, rules, roots);
        }
        if (checked.words) {
            for (const WordPathPlace& word : add_word_nodes(*checked.words, paths_.graph, roots)) {
                paths_.places.push_back(here);
                paths_.places.back().word = word;
            }
        }
        if (checked.design) add_steps(*checked.design, here, roots);
        roots.push_back(definitions);
        return roots_[&checked] = roots;
    }

    // The steps of a shape grammar: step[3] by the machine, apply[2] by hand, and the rule below it.
    void add_steps(const shape::Grammar& grammar, PathPlace here, std::vector<std::uint32_t>& roots) {
        std::vector<std::uint32_t> rules;
        for (const shape::Rule& rule : grammar.rules) {
            rules.push_back(add_node({false, false, rule.name, {}, {"right", "is_random"}}, here));
        }
        roots.push_back(add_node({true, true, "step", rules, {"rule", "match", "is_random"}}, here));
        roots.push_back(add_node({true, true, "apply", rules, {"is_random"}}, here));
    }

    std::uint32_t add_definitions(const OpenedDocument& opened, PathPlace here) {
        std::vector<std::uint32_t> names;
        const auto add = [&](const Name& name) {
            names.push_back(add_node({false, false, name.text, {}, {"is_random"}}, here));
        };
        for (const Statement& statement : opened.document.statements) {
            if (const auto* param = std::get_if<ParamStatement>(&statement.node)) add(param->name);
            if (const auto* let = std::get_if<LetStatement>(&statement.node)) add(let->name);
            if (const auto* palette = std::get_if<PaletteStatement>(&statement.node)) add(palette->name);
        }
        return add_node({false, false, "let", std::move(names), {}}, here);
    }

    // A node a tag, and behind them one for all hidden groups. Styles stand below every group.
    std::vector<std::uint32_t> add_tags(const tangle::Grammar& grammar, PathPlace here) {
        std::vector<std::uint32_t> styles;
        const std::size_t style_count = here.checked->settings->styles.size();
        for (std::size_t s = 0; s < style_count; ++s) {
            PathNode style{false, false, style_segment(s + 1), {}, {"when", "is_random"}};
            for (const StyleProperty& property : here.checked->settings->styles[s]->properties) {
                style.parameters.push_back(property.name.text);
            }
            PathPlace place = here;
            place.is_style = true;
            styles.push_back(add_node(std::move(style), place));
        }
        std::vector<std::uint32_t> tags;
        for (std::uint32_t tag = 0; tag < grammar.tags.size(); ++tag) {
            PathPlace place = here;
            place.tag = tag;
            std::vector<std::string> parameters = {"is_random"};
            if (!grammar.rules_of_tag[tag].empty()) parameters.push_back("rule");
            tags.push_back(add_node({true, false, grammar.tags[tag], styles, std::move(parameters)}, place));
        }
        tags.push_back(add_node({true, false, "_", {}, {}}, here));
        return tags;
    }

    std::vector<std::uint32_t> add_rules(const OpenedDocument& opened, const CheckedDocument& checked, PathPlace here,
                                         const std::vector<std::uint32_t>& tags) {
        const tangle::Grammar& grammar = *checked.grammar;
        std::vector<std::uint32_t> rules;
        for (std::uint32_t r = 0; r < grammar.rules.size(); ++r) {
            const tangle::Rule& rule = grammar.rules[r];
            PathNode step{false, false, rule.segment, {}, {"is_random"}};
            for (const ParameterDescription& parameter : rule.op->description.parameters) {
                step.parameters.emplace_back(parameter.name);
            }
            if (rule.op->scatters) step.parameters.emplace_back("scatter");
            if (rule.condition) step.parameters.emplace_back("when");
            if (rule.weight) step.parameters.emplace_back("weight");
            for (const tangle::Output& output : rule.outputs) {
                if (!output.hidden && grammar.tags[output.tag].empty()) continue;  // no path can name it
                const std::uint32_t next = output.hidden ? tags.back() : tags[output.tag];
                step.next.push_back(next);
                if (rule.op->description.regroups) node(next).has_ordinals = true;
            }
            if (rule.kind == tangle::RuleKind::embed) {
                for (const std::uint32_t root : embedded_roots(opened, checked, rule)) step.next.push_back(root);
            }
            PathPlace place = here;
            place.rule = r;
            const std::uint32_t index = add_node(std::move(step), place);
            rules.push_back(index);
            if (rule.tag != none) node(tags[rule.tag]).next.push_back(index);
        }
        return rules;
    }

    std::vector<std::uint32_t> embedded_roots(const OpenedDocument& opened, const CheckedDocument& checked,
                                              const tangle::Rule& rule) {
        std::vector<std::uint32_t> roots;
        if (rule.call.expressions.empty() || !rule.call.expressions[0]) return roots;
        for (const Alternative& alternative : alternatives_of(*rule.call.expressions[0])) {
            const auto* text = std::get_if<TextLiteral>(&alternative.expression->node);
            const auto* name = std::get_if<NameReference>(&alternative.expression->node);
            for (std::size_t i = 0; i < opened.embedded.size(); ++i) {
                const EmbeddedDocument& inner = opened.embedded[i];
                const bool is_this = inner.info.is_file ? text != nullptr && text->text == inner.info.name
                                                        : name != nullptr && name->name == inner.info.name;
                if (!is_this || i >= checked.embedded.size() || !checked.embedded[i] || !inner.opened) continue;
                for (const std::uint32_t root : add_document(*inner.opened, *checked.embedded[i])) {
                    roots.push_back(root);
                }
            }
        }
        return roots;
    }

    // The starts have nodes of their own, since only they have the parameters of their shapes.
    std::vector<std::uint32_t> add_starts(const OpenedDocument& opened, const tangle::Grammar& grammar, PathPlace here,
                                          const std::vector<std::uint32_t>& tags) {
        std::vector<std::uint32_t> roots;
        std::map<std::string, int> count;
        const auto add = [&](const std::string& tag, const OperatorDescription* shape, bool is_group) {
            const int number = ++count[tag];
            const std::uint32_t index = grammar.find_tag(tag);
            if (index == none) return;
            PathPlace place = here;
            place.tag = index;
            place.start = shape;
            PathNode start{
                is_group && number == 1, false, number == 1 ? tag : tag + "#" + std::to_string(number), {}, {}};
            if (number == 1) start = {true, false, tag, node(tags[index]).next, node(tags[index]).parameters};
            if (shape != nullptr) {
                for (const ParameterDescription& parameter : shape->parameters) {
                    start.parameters.emplace_back(parameter.name);
                }
            }
            roots.push_back(add_node(std::move(start), place));
        };
        for (const Statement& statement : opened.document.statements) {
            const auto* start = std::get_if<StartStatement>(&statement.node);
            if (start == nullptr || start->from) continue;
            const auto* call = std::get_if<CallExpression>(&start->value->node);
            add(start->tag.text, call ? find_operator(start_shape_descriptions(), call->name) : nullptr, true);
        }
        if (here.checked->start) {  // those of `start from`
            for (const StartGroup& group : here.checked->start->groups) {
                if (count.find(group.tag) == count.end()) add(group.tag, nullptr, true);
            }
        }
        return roots;
    }

    // Steps that are applied by hand stand below the groups that their paths name, and may begin paths by their name.
    void add_applied(const OpenedDocument& opened, const tangle::Grammar& grammar,
                     const std::vector<std::uint32_t>& rules, std::vector<std::uint32_t>& roots) {
        std::size_t number = 0;
        for (const Statement& statement : opened.document.statements) {
            const auto* apply = std::get_if<ApplyStatement>(&statement.node);
            if (apply == nullptr || number >= grammar.applied.size()) continue;
            const std::uint32_t rule = rules[grammar.applied[number++]];
            std::vector<std::uint32_t> before = roots;
            std::swap(before, paths_.graph.roots);
            for (const ChoicePath& target : apply->targets) {
                const PathCheck found = check_path(paths_.graph, target);
                for (const std::vector<std::uint32_t>* ends : {&found.ends, &found.shapes_of}) {
                    for (const std::uint32_t end : *ends) {
                        if (node(end).is_group) node(end).next.push_back(rule);
                    }
                }
            }
            std::swap(before, paths_.graph.roots);
            if (apply->name) roots.push_back(rule);
        }
    }

    DocumentPaths paths_;
    std::map<const CheckedDocument*, std::vector<std::uint32_t>> roots_;  // looked up only
};

class PresetChecker {
public:
    PresetChecker(const OpenedDocument& opened, const CheckedDocument& checked)
        : opened_(opened), checked_(checked), paths_(document_paths(opened, checked)) {}

    Diagnostics run() {
        for (const Statement& statement : opened_.document.statements) {
            if (const auto* preset = std::get_if<PresetStatement>(&statement.node)) check(*preset);
            if (const auto* keep = std::get_if<KeepStatement>(&statement.node)) possible(keep->path);
            if (const auto* reroll = std::get_if<RerollStatement>(&statement.node)) possible(reroll->path);
            const auto* apply = std::get_if<ApplyStatement>(&statement.node);
            if (apply != nullptr && !checked_.words) check(*apply);  // words have none
        }
        return std::move(diagnostics_);
    }

private:
    // A single name is short for let/NAME.
    static ChoicePath full_path(const ChoicePath& path) {
        ChoicePath full = path;
        const bool is_name =
            path.segments.size() == 1 && path.parameter.empty() && path.segments[0].kind == PathSegment::Kind::name;
        if (is_name) full.segments.insert(full.segments.begin(), PathSegment{PathSegment::Kind::name, "let", {}});
        return full;
    }

    std::optional<PathCheck> possible(const ChoicePath& path) {
        PathCheck found = check_path(paths_.graph, path);
        if (found.possible) return found;
        std::vector<std::string> hints;
        if (!found.nearest.empty()) hints.push_back("the nearest that is possible is " + found.nearest);
        diagnostics_.push_back(error("preset.impossible-path", found.why, path.span, std::move(hints)));
        return std::nullopt;
    }

    // Whether let/NAME is a name of the document; an error where not.
    bool is_defined(const ChoicePath& path) {
        if (check_path(paths_.graph, path).possible) return true;
        std::vector<std::string_view> names;
        for (const PathNode& node : paths_.graph.nodes) {
            if (node.segment != "let") continue;
            for (const std::uint32_t name : node.next) names.push_back(paths_.graph.nodes[name].segment);
        }
        const std::string& name = path.segments.back().name;
        std::vector<std::string> hints = did_you_mean(name, names);
        hints.push_back("a choice of a step is named by its path: big_poly/outline.distance");
        diagnostics_.push_back(
            error("preset.unknown-name", "the document defines no '" + name + "'", path.span, hints));
        return false;
    }

    void check(const PresetStatement& preset) {
        const ChoicePath path = full_path(preset.path);
        if (path.segments.size() != preset.path.segments.size() && !is_defined(path)) return;
        const auto found = possible(path);
        if (!found) return;
        const std::size_t before = diagnostics_.size();
        if (preset.path.parameter.empty() && !check_names_a_value(preset, *found)) return;
        if (preset.path.parameter == "rule") check_rule_names(preset, found->ends);
        check_word_choice(preset, found->ends);
        for (const std::uint32_t end : found->ends) check_value(preset, end);
        keep_each_once(before);
    }

    // A value at several places says the same at each.
    void keep_each_once(std::size_t first) {
        std::size_t kept = first;
        for (std::size_t i = first; i < diagnostics_.size(); ++i) {
            const auto begin = diagnostics_.begin() + static_cast<std::ptrdiff_t>(first);
            const auto end = diagnostics_.begin() + static_cast<std::ptrdiff_t>(kept);
            if (std::find(begin, end, diagnostics_[i]) != end) continue;
            if (kept != i) diagnostics_[kept] = std::move(diagnostics_[i]);
            ++kept;
        }
        diagnostics_.resize(kept);
    }

    bool check_names_a_value(const PresetStatement& preset, const PathCheck& found) {
        std::vector<std::uint32_t> ends = found.ends;
        ends.insert(ends.end(), found.shapes_of.begin(), found.shapes_of.end());
        for (const std::uint32_t end : ends) {
            const PathPlace& place = paths_.places[end];
            if (place.rule == none && place.tag == none && !place.is_style && !place.word) continue;
            diagnostics_.push_back(error("preset.no-parameter", "this path names no parameter", preset.path.span,
                                         {"a parameter stands behind a dot, as in " + example(end)}));
            return false;
        }
        return true;
    }

    std::string example(std::uint32_t node) const {
        const PathNode& at = paths_.graph.nodes[node];
        const std::string parameter = at.parameters.empty() ? "rule" : at.parameters.back();
        return at.segment + "." + parameter;
    }

    void check_value(const PresetStatement& preset, std::uint32_t end) {
        const PathPlace& place = paths_.places[end];
        const std::string& parameter = preset.path.parameter;
        if (parameter == "rule" && place.tag != none) return;  // all of its places together
        if (place.word && place.word->edit == nullptr && parameter != "is_random") return;  // likewise
        const bool has_shapes = place.rule != none || place.is_style;
        if (varies_by_shape(*preset.value) && (!has_shapes || parameter == "is_random" || parameter == "scatter" ||
                                               ((parameter == "when" || parameter == "weight") && !place.is_style))) {
            diagnostics_.push_back(error("language.each-outside", "each(...) can only stand where there are shapes",
                                         preset.value->span, {"this is decided once for all of them"}));
            return;
        }
        static const ParameterDescription flag{
            .name = "is_random", .type = ParameterType::flag, .default_text = "true"};
        static const ParameterDescription when{.name = "when", .type = ParameterType::flag, .default_text = "true"};
        static const ParameterDescription weight{
            .name = "weight", .type = ParameterType::real, .default_text = "1", .low = 0};
        static const ParameterDescription scatter{
            .name = "scatter", .type = ParameterType::whole, .default_text = "0", .low = 0, .high = 4294967295.0};
        if (place.is_style && parameter != "is_random") {
            append(diagnostics_,
                   check_style_preset(parameter, *preset.value, opened_.document, checked_.settings->globals));
            return;
        }
        if (parameter.empty()) {
            check_definition(preset);
            return;
        }
        const ParameterDescription* described = nullptr;
        std::span<const ParameterDescription> all;
        for (const ParameterDescription* special : {&flag, &when, &weight, &scatter}) {
            if (special->name == parameter) described = special;
        }
        const OperatorDescription* description = place.start;
        if (place.rule != none) description = &place.checked->grammar->rules[place.rule].op->description;
        if (place.word && place.word->edit != nullptr) description = &place.word->edit->op->description;
        if (description != nullptr) {
            all = description->parameters;
            for (const ParameterDescription& known : description->parameters) {
                if (known.name == parameter) described = &known;
            }
        }
        if (place.rule != none && parameter == "document") {
            check_document_names(preset, place);
            return;
        }
        if (described == nullptr) return;
        if (preset.path.draw != 0) {
            check_draw(preset, place);
            return;
        }
        const Scope& globals = checked_.settings->globals;
        append(diagnostics_, check_preset_value(*described, *preset.value, opened_.document, globals, all));
        if (preset.condition) {
            append(diagnostics_, check_preset_condition(*described, *preset.condition, opened_.document, globals, all));
        }
    }

    // A `let` or `param` is evaluated before any step, so it may use names of the document alone. Its domain is
    // looked at when it is.
    void check_definition(const PresetStatement& preset) {
        Evaluation at;
        at.document = &opened_.document;
        at.scope = &checked_.settings->globals;
        if (preset.condition) append(diagnostics_, check_expression(*preset.condition, at));
        at.words = {"*"};  // those of its domain
        append(diagnostics_, check_expression(*preset.value, at));
    }

    // The k-th choice of an argument that has fewer does nothing.
    void check_draw(const PresetStatement& preset, const PathPlace& place) {
        if (place.rule == none) return;
        const BoundCall& call = place.checked->grammar->rules[place.rule].call;
        for (std::size_t i = 0; i < call.expressions.size(); ++i) {
            if (call.description->parameters[i].name != preset.path.parameter || !call.expressions[i]) continue;
            const std::uint32_t count = count_choices(*call.expressions[i]);
            if (preset.path.draw <= count) return;
            diagnostics_.push_back(warning("preset.no-such-draw",
                                           "'" + preset.path.parameter + "' has " + std::to_string(count) +
                                               (count == 1 ? " choice" : " choices") + " here",
                                           preset.path.span));
        }
    }

    static std::string name_in(const Expression& expression) {
        const auto* text = std::get_if<TextLiteral>(&expression.node);
        const auto* word = std::get_if<NameReference>(&expression.node);
        return text != nullptr ? text->text : word != nullptr ? word->name : "";
    }
    static std::string listed(const std::vector<std::string_view>& names) {
        std::string list;
        for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
        return list;
    }

    // Only the documents that the rule itself may embed, since their parameters are the rule's.
    void check_document_names(const PresetStatement& preset, const PathPlace& place) {
        const BoundCall& call = place.checked->grammar->rules[place.rule].call;
        std::vector<std::string> names;
        for (const Alternative& alternative : alternatives_of(*call.expressions[0])) {
            names.push_back(name_in(*alternative.expression));
        }
        const std::vector<std::string_view> known(names.begin(), names.end());
        for (const Alternative& alternative : alternatives_of(*preset.value)) {
            const std::string name = name_in(*alternative.expression);
            if (!name.empty() && std::find(known.begin(), known.end(), name) != known.end()) continue;
            diagnostics_.push_back(error("preset.unknown-document", "this rule embeds no '" + name + "'",
                                         alternative.expression->span, {"it embeds " + listed(known)}));
        }
    }

    // The rules that a `.rule` names must be rules of the tag; of one of the tags, where the path leaves it open.
    void check_rule_names(const PresetStatement& preset, const std::vector<std::uint32_t>& ends) {
        std::vector<std::string_view> known;
        std::string tag;
        for (const std::uint32_t end : ends) {
            const PathPlace& place = paths_.places[end];
            if (place.tag == none) continue;
            const tangle::Grammar& grammar = *place.checked->grammar;
            tag = grammar.tags[place.tag];
            for (const std::uint32_t rule : grammar.rules_of_tag[place.tag]) {
                const std::string_view name = grammar.rules[rule].segment;
                if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
            }
        }
        if (known.empty()) return;
        for (const Alternative& alternative : alternatives_of(*preset.value)) {
            const std::string name = name_in(*alternative.expression);
            if (alternative.by_shape) {
                diagnostics_.push_back(error("language.each-outside", "each(...) can only stand where there are shapes",
                                             preset.value->span, {"a rule is drawn once for all of them"}));
                continue;
            }
            if (name.empty()) {
                diagnostics_.push_back(
                    error("preset.not-a-rule", "the value of a rule is its label or operator in quotes",
                          alternative.expression->span, {"as in \"" + std::string(known[0]) + "\""}));
                continue;
            }
            if (name == "none" || std::find(known.begin(), known.end(), name) != known.end()) continue;
            std::vector<std::string> hints = did_you_mean(name, known);
            if (hints.empty()) hints.push_back("its rules are " + listed(known));
            diagnostics_.push_back(error("preset.unknown-rule", "the tag '" + tag + "' has no rule '" + name + "'",
                                         alternative.expression->span, std::move(hints)));
        }
    }

    // What symbols choose.
    void check_word_choice(const PresetStatement& preset, const std::vector<std::uint32_t>& ends) {
        std::vector<WordPathPlace> letters;
        for (const std::uint32_t end : ends) {
            const PathPlace& place = paths_.places[end];
            if (!place.word || place.word->letter == 0 || preset.path.parameter == "is_random") continue;
            letters.push_back(*place.word);
        }
        if (letters.empty()) return;
        const Scope& globals = checked_.settings->globals;
        append(diagnostics_, check_word_preset(preset, letters, opened_.document, globals));
    }

    void check(const ApplyStatement& apply) {
        for (const ChoicePath& target : apply.targets) {
            const PathSegment& first = target.segments.front();
            if (apply.name && first.kind == PathSegment::Kind::name && first.name == apply.name->text) {
                diagnostics_.push_back(error("preset.impossible-path",
                                             "a step cannot be applied to what it makes itself", target.span,
                                             {"begin the path at a start"}));
                continue;
            }
            const auto found = possible(target);
            if (!found) continue;
            // At any depth it would be applied to its own results for ever.
            bool is_group = false;
            if (target.segments.back().kind == PathSegment::Kind::any_depth) {
                diagnostics_.push_back(error("apply.not-a-group", "a step is applied to a group or to single shapes",
                                             target.span, {"end the path in a tag"}));
                continue;
            }
            for (const std::vector<std::uint32_t>* ends : {&found->ends, &found->shapes_of}) {
                for (const std::uint32_t end : *ends) {
                    const PathPlace& place = paths_.places[end];
                    if (place.opened != &opened_) {
                        diagnostics_.push_back(error("apply.across-border",
                                                     "a step cannot be added inside an embedded document", target.span,
                                                     {"add it in '" + place.opened->name + "' itself"}));
                        return;
                    }
                    is_group = is_group || place.tag != none;
                }
            }
            if (is_group) continue;
            diagnostics_.push_back(error("apply.not-a-group", "a step is applied to a group or to single shapes",
                                         target.span, {"this path ends in a rule; add a tag behind it"}));
        }
    }

    const OpenedDocument& opened_;
    const CheckedDocument& checked_;
    DocumentPaths paths_;
    Diagnostics diagnostics_;
};

}  // namespace

DocumentPaths document_paths(const OpenedDocument& opened, const CheckedDocument& checked) {
    return PathBuilder().build(opened, checked);
}

Diagnostics check_presets(const OpenedDocument& opened, const CheckedDocument& checked) {
    const bool has_any = std::any_of(opened.document.statements.begin(), opened.document.statements.end(),
                                     [](const Statement& statement) {
                                         return std::holds_alternative<PresetStatement>(statement.node) ||
                                                std::holds_alternative<KeepStatement>(statement.node) ||
                                                std::holds_alternative<RerollStatement>(statement.node) ||
                                                std::holds_alternative<ApplyStatement>(statement.node);
                                     });
    if (!has_any) return {};
    return PresetChecker(opened, checked).run();
}

}  // namespace filigree
