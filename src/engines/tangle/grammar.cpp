#include "engines/tangle/grammar.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>

#include "base/number_text.h"
#include "engines/tangle/operators/operators.h"
#include "language/check.h"
#include "language/names.h"
#include "language/parse.h"
#include "language/walk.h"

namespace filigree::tangle {
namespace {

constexpr std::size_t max_macro_depth = 32;  // macros within macros
constexpr std::size_t max_rules = 100'000;

// An operator that the document defines, with the texts that its description points into.
struct DefinedOperator {
    std::deque<std::string> texts;
    Operator op;

    std::string_view keep(std::string text) { return texts.emplace_back(std::move(text)); }
};

// Inside which use of a macro a rule stands.
struct Frame {
    std::size_t id = 0;  // 0: in none
    const Frame* outer = nullptr;
    const OperatorStatement* macro = nullptr;
    std::map<std::string, Output> ports;  // local tags that stand for tags outside
    Scope examples;                       // of the parameters of this and all macros around it
    std::map<std::string, SourceSpan> labels;
    std::map<std::pair<std::uint32_t, std::string>, int> unlabelled;
};

class GrammarReader {
public:
    GrammarReader(const Settings& settings, const Document& document, const EmbeddableDocuments& embeddable)
        : settings_(settings), document_(document), embeddable_(embeddable) {
        tag_index(top_, "");  // the unnamed terminal
    }

    Result<Grammar> read(std::span<const std::string> start_tags) {
        start_tags_ = start_tags;
        for (const std::string& tag : start_tags) tag_index(top_, tag);
        check_macros();
        for (std::size_t i = 0; i < settings_.rules.size(); ++i) {
            add_rule(*settings_.rules[i], settings_.rule_spans[i], top_);
        }
        add_applied();
        try_unused_macros();
        if (has_errors(diagnostics_)) return diagnostics_;
        grammar_.rules_of_tag.resize(grammar_.tags.size());
        for (std::uint32_t r = 0; r < grammar_.rules.size(); ++r) {
            if (grammar_.rules[r].tag != none) grammar_.rules_of_tag[grammar_.rules[r].tag].push_back(r);
        }
        return Result<Grammar>(std::move(grammar_), std::move(diagnostics_));
    }

private:
    void refuse(std::string code, std::string message, SourceSpan span, std::vector<std::string> hints = {}) {
        diagnostics_.push_back(error(std::move(code), std::move(message), span, std::move(hints)));
    }

    std::uint32_t tag_index(const Frame& frame, const std::string& name) {
        const auto next = static_cast<std::uint32_t>(grammar_.tags.size());
        // The unnamed terminal is one for all.
        const auto [known, fresh] = tag_indices_.emplace(std::pair(name.empty() ? 0 : frame.id, name), next);
        if (fresh) grammar_.tags.push_back(name);
        return known->second;
    }

    // What an output tag means: behind a port it is the tag outside.
    Output output_for(const Frame& frame, const OutputTag& output) {
        if (output.dropped) return {0, true, 0};
        const auto port = frame.ports.find(output.tag);
        if (port != frame.ports.end()) return {port->second.tag, port->second.hidden, port->second.leaves + 1};
        return {tag_index(frame, output.tag), false, 0};
    }

    // --- rules ---

    void add_rule(const GroupRule& source, SourceSpan span, Frame& frame) {
        const auto index = read_rule(source, span, frame, false);
        if (frame.id == 0 && index) grammar_.document_rules.push_back(grammar_.rules[*index].segment);
    }

    std::optional<std::size_t> read_rule(const GroupRule& source, SourceSpan span, Frame& frame, bool is_applied) {
        const OperatorStatement* macro = find_macro(source.operator_name.text);
        const Operator* op = macro == nullptr ? find_operator(source.operator_name.text) : nullptr;
        if (macro == nullptr && op == nullptr) {
            unknown_operator(source.operator_name);
            return std::nullopt;
        }
        Rule rule;
        rule.op = op;
        rule.span = span;
        rule.condition = source.condition;
        rule.weight = source.weight;
        const bool is_embed = op != nullptr && op->description.name == "embed";
        if (macro != nullptr) {
            used_macros_.insert(macro);
            rule.kind = RuleKind::macro;
            rule.op = define_macro(*macro);
        } else if (is_embed) {
            rule.kind = RuleKind::embed;
            rule.op = define_embedding(source, *op);
            if (rule.op == nullptr) return std::nullopt;
        }
        if (!is_applied) {
            if (frame.ports.count(source.tag.text) > 0) {
                refuse("tangle.rule-of-port", "the shapes of the port '" + source.tag.text + "' leave the operator",
                       source.tag.span, {"a rule for them stands outside of it"});
            }
            rule.tag = tag_index(frame, source.tag.text);
        }
        name_rule(rule, source, frame, is_applied);

        const Scope* varying = frame.id == 0 ? nullptr : &frame.examples;
        Result<BoundCall> call = bind(rule.op->description, source.arguments, source.operator_name.span, document_,
                                      settings_.globals, varying);
        append(diagnostics_, call.diagnostics());
        const bool bound = static_cast<bool>(call);
        if (bound) rule.call = std::move(*call);
        if (source.condition) {
            append(diagnostics_, check_condition(*source.condition, document_, settings_.globals, varying));
        }
        if (source.weight) append(diagnostics_, check_weight(*source.weight, document_, settings_.globals, varying));
        read_outputs(rule, source, frame);
        rule.reads = reads_of(rule, source, frame);

        const std::size_t index = grammar_.rules.size();
        grammar_.rules.push_back(std::move(rule));
        if (macro != nullptr && bound) expand_macro(*macro, index, frame);
        return index;
    }

    void unknown_operator(const Name& name) {
        std::vector<std::string_view> names;
        for (const Operator& known : operators()) {
            names.push_back(known.description.name);
            names.insert(names.end(), known.description.aliases.begin(), known.description.aliases.end());
        }
        for (const OperatorStatement* macro : settings_.operators) names.push_back(macro->name.text);
        refuse("tangle.unknown-operator", "there is no operator '" + name.text + "'", name.span,
               did_you_mean(name.text, names));
    }

    void name_rule(Rule& rule, const GroupRule& source, Frame& frame, bool is_applied) {
        if (source.label) {
            rule.segment = source.label->text;
            const auto [known, fresh] = frame.labels.emplace(source.label->text, source.label->span);
            if (!fresh) {
                refuse("tangle.repeated-label", "the label '" + source.label->text + "' already names another rule",
                       source.label->span);
            }
            if (find_operator(source.label->text) != nullptr || find_macro(source.label->text) != nullptr) {
                // paths could not tell the two apart
                refuse("tangle.label-of-operator",
                       "'" + source.label->text + "' is the name of an operator, so it cannot be a label",
                       source.label->span);
            }
        } else {
            const std::string name(rule.op->description.name);
            // Only one step is applied to a group, so there is nothing to number.
            const int number = is_applied ? 1 : ++frame.unlabelled[{rule.tag, name}];
            rule.segment = number == 1 ? name : name + "#" + std::to_string(number);
        }
        rule.key = Key{hash_text(rule.segment)};
    }

    void read_outputs(Rule& rule, const GroupRule& source, const Frame& frame) {
        const auto& ports = rule.op->description.ports;
        rule.outputs.assign(ports.size(), Output{});
        std::vector<bool> taken(ports.size(), false);
        std::size_t next = 0;
        for (const OutputTag& output : source.outputs) {
            std::size_t port = ports.size();
            if (!output.port.empty()) {
                const auto found = std::find_if(ports.begin(), ports.end(),
                                                [&](const PortDescription& p) { return p.name == output.port; });
                port = static_cast<std::size_t>(found - ports.begin());
                if (port == ports.size()) {
                    diagnostics_.push_back(unknown_port(output, *rule.op));
                    continue;
                }
                if (taken[port]) {
                    refuse("tangle.repeated-port", "the output '" + output.port + "' is named twice", output.span);
                    continue;
                }
            } else {
                port = next++;
                if (port >= ports.size()) {
                    diagnostics_.push_back(
                        warning("tangle.surplus-output",
                                "'" + std::string(rule.op->description.name) + "' has " +
                                    (ports.empty()       ? "no outputs"
                                     : ports.size() == 1 ? "one output"
                                                         : std::to_string(ports.size()) + " outputs") +
                                    "; this tag is never produced",
                                output.span));
                    if (!output.dropped && !output.tag.empty()) tag_index(frame, output.tag);
                    continue;
                }
            }
            taken[port] = true;
            rule.outputs[port] = output_for(frame, output);
        }
    }

    static Diagnostic unknown_port(const OutputTag& output, const Operator& op) {
        std::vector<std::string_view> names;
        std::string all;
        for (const PortDescription& port : op.description.ports) {
            names.push_back(port.name);
            all += (all.empty() ? "" : ", ") + std::string(port.name);
        }
        std::vector<std::string> hints = did_you_mean(output.port, names);
        if (hints.empty()) hints.push_back(all.empty() ? "it has none" : "its outputs are " + all);
        return error("tangle.unknown-port",
                     "'" + std::string(op.description.name) + "' has no output '" + output.port + "'", output.span,
                     hints);
    }

    // --- macros ---

    const OperatorStatement* find_macro(std::string_view name) const {
        for (const OperatorStatement* macro : settings_.operators) {
            if (macro->name.text == name) return macro;
        }
        return nullptr;
    }

    // What is wrong with the definitions, whether they are used or not.
    void check_macros() {
        std::set<std::string_view> names;
        for (const OperatorStatement* macro : settings_.operators) {
            const Name& name = macro->name;
            if (find_operator(name.text) != nullptr) {
                refuse("tangle.hidden-operator", "'" + name.text + "' is an operator already", name.span,
                       {"give this one another name"});
            }
            if (!names.insert(name.text).second) {
                refuse("tangle.repeated-operator", "the operator '" + name.text + "' is already defined", name.span);
            }
            std::set<std::string_view> parameters, ports;
            for (const DefinitionParameter& parameter : macro->parameters) {
                if (parameters.insert(parameter.name.text).second) continue;
                refuse("tangle.repeated-parameter", "'" + parameter.name.text + "' is already a parameter",
                       parameter.name.span);
            }
            for (const Name& port : macro->ports) {
                if (ports.insert(port.text).second) continue;
                refuse("tangle.repeated-port", "the output '" + port.text + "' is named twice", port.span);
            }
            if (macro->statements.empty()) {
                refuse("tangle.empty-operator", "the operator '" + name.text + "' has no rules", name.span);
            }
        }
        if (has_errors(diagnostics_)) macros_are_wrong_ = true;
    }

    // An operator of the document, described like the others. Once for each definition.
    const Operator* define_macro(const OperatorStatement& macro) {
        const auto known = macro_operators_.find(&macro);
        if (known != macro_operators_.end()) return known->second;
        auto defined = std::make_shared<DefinedOperator>();
        OperatorDescription& description = defined->op.description;
        description.name = defined->keep(macro.name.text);
        description.shrinks = false;
        for (const DefinitionParameter& parameter : macro.parameters) {
            description.parameters.push_back({.name = defined->keep(parameter.name.text),
                                              .type = ParameterType::any,
                                              .default_text = parameter.value ? not_given : std::string_view()});
        }
        for (const Name& port : macro.ports) description.ports.push_back({.name = defined->keep(port.text)});
        return macro_operators_[&macro] = kept(std::move(defined));
    }
    const Operator* kept(std::shared_ptr<DefinedOperator> defined) {
        const Operator* op = &defined->op;
        grammar_.defined.push_back(std::shared_ptr<const Operator>(std::move(defined), op));
        return op;
    }

    // Puts the macro's rules, over local tags, behind the rule that uses it.
    void expand_macro(const OperatorStatement& macro, std::size_t use, Frame& outer) {
        if (macros_are_wrong_) return;
        if (grammar_.rules.size() > max_rules) {
            if (!has_too_many_rules_) {
                refuse("tangle.too-many-rules",
                       "the operators of this document expand to more than " + std::to_string(max_rules) + " rules",
                       grammar_.rules[use].span);
            }
            has_too_many_rules_ = true;
            return;
        }
        std::size_t depth = 1;
        for (const Frame* at = &outer; at->id != 0; at = at->outer, ++depth) {
            if (at->macro != &macro && depth < max_macro_depth) continue;
            refuse("tangle.operator-cycle", "the operator '" + macro.name.text + "' uses itself",
                   grammar_.rules[use].span, {"a rule that gives a tag back makes a recursion: ... : a -> a"});
            return;
        }
        Frame frame;
        frame.id = ++frames_;
        frame.outer = &outer;
        frame.macro = &macro;
        frame.examples.outer = &settings_.globals;
        frame.examples.names = outer.examples.names;
        for (std::size_t p = 0; p < macro.ports.size(); ++p) {
            frame.ports[macro.ports[p].text] = grammar_.rules[use].outputs[p];
        }
        take_parameters(macro, use, outer, frame);
        const auto* first = std::get_if<GroupRule>(&macro.statements.front().node);
        if (first == nullptr) return;
        grammar_.rules[use].outputs.assign(1, {tag_index(frame, first->tag.text), false, 0});
        for (const Statement& statement : macro.statements) {
            if (const auto* rule = std::get_if<GroupRule>(&statement.node)) add_rule(*rule, statement.span, frame);
        }
    }

    // Example values of the parameters for checking the rules; and their defaults, which unlike those of described
    // operators may use the names of the document.
    void take_parameters(const OperatorStatement& macro, std::size_t use, const Frame& outer, Frame& frame) {
        BoundCall& call = grammar_.rules[use].call;
        const Scope* around = outer.id == 0 ? &settings_.globals : &outer.examples;
        for (std::size_t i = 0; i < macro.parameters.size(); ++i) {
            const DefinitionParameter& parameter = macro.parameters[i];
            Evaluation at = call.expected[i];
            Scope examples = example_scope(step_names(), around);
            if (!call.given[i]) {
                call.expressions[i] = parameter.value;
                call.constants[i].reset();
                for (std::size_t k = 0; k < i; ++k) {
                    const std::string& earlier = macro.parameters[k].name.text;
                    examples.names[earlier] = frame.examples.names[earlier];
                }
            }
            at.document = &document_;
            at.scope = &examples;
            Value example{Quantity{1, 0, false}, parameter.name.span};
            if (call.expressions[i]) {
                const Diagnostics problems = check_expression(*call.expressions[i], at);
                if (!call.given[i]) append(diagnostics_, problems);
                const Result<Value> value = evaluate(*call.expressions[i], at);
                if (problems.empty() && value) example = *value;
            }
            frame.examples.names[parameter.name.text] = example;
        }
    }

    // Definitions that no rule uses are checked all the same.
    void try_unused_macros() {
        for (const OperatorStatement* macro : settings_.operators) {
            if (macros_are_wrong_ || used_macros_.count(macro) > 0) continue;
            diagnostics_.push_back(warning("tangle.unused-operator",
                                           "no rule uses the operator '" + macro->name.text + "'", macro->name.span));
            GroupRule use;
            use.operator_name = macro->name;
            for (const DefinitionParameter& parameter : macro->parameters) {
                if (parameter.value) continue;
                const Result<ExpressionPtr> one = parse_expression("1");
                const auto name =
                    std::make_shared<Expression>(Expression{parameter.name.span, NameReference{parameter.name.text}});
                use.arguments.push_back({name, *one});
            }
            read_rule(use, macro->name.span, top_, true);
        }
    }

    // --- apply ---

    bool is_start_tag(std::string_view name) const {
        return std::find(start_tags_.begin(), start_tags_.end(), name) != start_tags_.end();
    }

    void add_applied() {
        for (const ApplyStatement* apply : settings_.applies) {
            if (apply->name && (apply->name->text == "let" || is_start_tag(apply->name->text))) {
                refuse("apply.name-taken", "paths begin with '" + apply->name->text + "' already", apply->name->span,
                       {"give the step another name"});
            }
            GroupRule source;
            source.label = apply->name;
            source.operator_name = apply->operator_name;
            source.arguments = apply->arguments;
            source.outputs = apply->outputs;
            const auto index = read_rule(source, apply->operator_name.span, top_, true);
            if (!index) continue;
            if (apply->name) grammar_.rules[*index].name = apply->name->text;
            grammar_.applied.push_back(static_cast<std::uint32_t>(*index));
        }
    }

    // --- embed ---

    // The operator with the parameters of every document that this call may embed.
    const Operator* define_embedding(const GroupRule& source, const Operator& described) {
        std::vector<const EmbeddableDocument*> documents;
        const CallArgument* which = nullptr;
        for (const CallArgument& argument : source.arguments) {
            const auto* key = argument.key ? std::get_if<NameReference>(&argument.key->node) : nullptr;
            if (!argument.key || (key != nullptr && key->name == "document")) which = which ? which : &argument;
        }
        auto defined = std::make_shared<DefinedOperator>();
        defined->op = described;
        if (which == nullptr || !which->value) return kept(std::move(defined));  // binding says what is missing
        bool complete = true;
        for (const Alternative& alternative : alternatives_of(*which->value)) {
            const EmbeddableDocument* document = find_embeddable(*alternative.expression);
            complete = complete && document != nullptr;
            if (document != nullptr) documents.push_back(document);
        }
        if (!complete) return nullptr;
        for (const EmbeddableDocument* document : documents) {
            for (const std::string& parameter : document->parameters) {
                auto& all = defined->op.description.parameters;
                const bool known = std::any_of(all.begin(), all.end(),
                                               [&](const ParameterDescription& p) { return p.name == parameter; });
                if (known) continue;
                const auto& required = document->required;
                const bool must = std::find(required.begin(), required.end(), parameter) != required.end();
                all.push_back({.name = defined->keep(parameter),
                               .type = ParameterType::any,
                               .default_text = must ? std::string_view() : not_given});
            }
        }
        return kept(std::move(defined));
    }

    const EmbeddableDocument* find_embeddable(const Expression& expression) {
        const auto* text = std::get_if<TextLiteral>(&expression.node);
        const auto* name = std::get_if<NameReference>(&expression.node);
        if (text == nullptr && name == nullptr) {
            refuse("embed.not-a-document", "a document to embed is the name of a system, or a file in quotes",
                   expression.span, {"as in embed(dots) or embed(\"knot.fil\")"});
            return nullptr;
        }
        const std::string& wanted = text != nullptr ? text->text : name->name;
        std::vector<std::string_view> known;
        for (const EmbeddableDocument& document : embeddable_) {
            if (document.is_file == (text != nullptr) && document.name == wanted) return &document;
            if (!document.is_file) known.push_back(document.name);
        }
        if (text != nullptr) {
            refuse("embed.missing", "the document '" + wanted + "' cannot be read", expression.span,
                   {"files are looked up beside the document"});
        } else {
            std::vector<std::string> hints = did_you_mean(wanted, known);
            if (hints.empty()) hints.push_back("a system is written: system " + wanted + " { grammar tangle; ... }");
            refuse("embed.unknown-system", "there is no system '" + wanted + "'", expression.span, std::move(hints));
        }
        return nullptr;
    }

    // --- what a rule may read ---

    std::string reads_of(const Rule& rule, const GroupRule& source, const Frame& frame) const {
        std::string reads = rule.segment + "\n";
        const auto add_source = [&](SourceSpan span) {
            if (span.file >= document_.sources.size()) return;
            reads += document_.sources[span.file].text.substr(span.begin, span.end - span.begin);
            reads += " " + std::to_string(static_cast<int>(bare_unit(&document_, span))) + "\n";
        };
        const auto add_names = [&](const ExpressionPtr& expression) {
            if (!expression) return;
            add_source(expression->span);
            for (const NameInExpression& name : names_in(*expression)) {
                if (const Value* value = settings_.globals.find(name.text)) {
                    reads += name.text + "=" + to_text(*value) + " " +
                             std::to_string(static_cast<int>(bare_unit(&document_, value->span))) + "\n";
                }
            }
        };
        add_source(rule.span);
        for (const CallArgument& argument : source.arguments) {
            if (argument.key) add_source(argument.key->span);
            add_names(argument.value);
        }
        add_names(source.condition);
        add_names(source.weight);
        for (const OutputTag& output : source.outputs) add_source(output.span);
        for (const Output& output : rule.outputs) {
            reads += std::to_string(output.leaves) + (output.hidden ? "_" : "") + " ";
        }
        for (const Frame* at = &frame; at->id != 0; at = at->outer) {
            for (const DefinitionParameter& parameter : at->macro->parameters) add_names(parameter.value);
        }
        const OperatorStatement* macro = find_macro(source.operator_name.text);
        if (macro != nullptr) {
            for (const DefinitionParameter& parameter : macro->parameters) {
                reads += parameter.name.text + " ";
                add_names(parameter.value);
            }
            for (const Name& port : macro->ports) reads += port.text + " ";
            const auto* first =
                macro->statements.empty() ? nullptr : std::get_if<GroupRule>(&macro->statements.front().node);
            if (first != nullptr) reads += first->tag.text;
        }
        if (rule.kind == RuleKind::embed) {
            for (const EmbeddableDocument& document : embeddable_) reads += document.fingerprint + "\n";
        }
        return reads;
    }

    const Settings& settings_;
    const Document& document_;
    const EmbeddableDocuments& embeddable_;
    std::span<const std::string> start_tags_;
    Grammar grammar_;
    Diagnostics diagnostics_;
    Frame top_;
    std::size_t frames_ = 0;
    bool macros_are_wrong_ = false;
    bool has_too_many_rules_ = false;
    std::map<std::pair<std::size_t, std::string>, std::uint32_t> tag_indices_;
    std::map<const OperatorStatement*, const Operator*> macro_operators_;  // looked up only
    std::set<const OperatorStatement*> used_macros_;                       // likewise
};

}  // namespace

std::uint32_t Grammar::find_tag(std::string_view name) const {
    const auto found = std::find(tags.begin(), tags.end(), name);
    return found == tags.end() ? none : static_cast<std::uint32_t>(found - tags.begin());
}

Result<Grammar> read_grammar(const Settings& settings, const Document& document,
                             std::span<const std::string> start_tags, const EmbeddableDocuments& embeddable) {
    return GrammarReader(settings, document, embeddable).read(start_tags);
}

}  // namespace filigree::tangle
