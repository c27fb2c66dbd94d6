#include "engines/tangle/grammar.h"

#include <algorithm>
#include <map>

#include "engines/tangle/operators/operators.h"
#include "language/check.h"

namespace filigree::tangle {
namespace {

class GrammarReader {
public:
    GrammarReader(const Settings& settings, const Document& document) : settings_(settings), document_(document) {
        tag_index("");  // the unnamed terminal
    }

    Result<Grammar> read(std::span<const std::string> start_tags) {
        for (const std::string& tag : start_tags) tag_index(tag);
        for (std::size_t i = 0; i < settings_.rules.size(); ++i) add_rule(*settings_.rules[i], settings_.rule_spans[i]);
        if (has_errors(diagnostics_)) return diagnostics_;
        grammar_.rules_of_tag.resize(grammar_.tags.size());
        for (std::uint32_t r = 0; r < grammar_.rules.size(); ++r) {
            grammar_.rules_of_tag[grammar_.rules[r].tag].push_back(r);
        }
        return Result<Grammar>(std::move(grammar_), std::move(diagnostics_));
    }

private:
    std::uint32_t tag_index(const std::string& name) {
        const auto [known, fresh] = tag_indices_.emplace(name, static_cast<std::uint32_t>(grammar_.tags.size()));
        if (fresh) grammar_.tags.push_back(name);
        return known->second;
    }

    void add_rule(const GroupRule& source, SourceSpan span) {
        const Operator* op = find_operator(source.operator_name.text);
        if (op == nullptr) {
            std::vector<std::string_view> names;
            for (const Operator& known : operators()) {
                names.push_back(known.description.name);
                names.insert(names.end(), known.description.aliases.begin(), known.description.aliases.end());
            }
            diagnostics_.push_back(error("tangle.unknown-operator",
                                         "there is no operator '" + source.operator_name.text + "'",
                                         source.operator_name.span, did_you_mean(source.operator_name.text, names)));
            return;
        }
        Rule rule;
        rule.op = op;
        rule.span = span;
        rule.tag = tag_index(source.tag.text);
        rule.condition = source.condition;
        rule.weight = source.weight;
        name_rule(rule, source);
        Result<BoundCall> call =
            bind(op->description, source.arguments, source.operator_name.span, document_, settings_.globals);
        append(diagnostics_, call.diagnostics());
        if (call) rule.call = std::move(*call);
        if (source.condition) append(diagnostics_, check_condition(*source.condition, document_, settings_.globals));
        if (source.weight) append(diagnostics_, check_weight(*source.weight, document_, settings_.globals));
        read_outputs(rule, source);
        grammar_.rules.push_back(std::move(rule));
    }

    void name_rule(Rule& rule, const GroupRule& source) {
        if (source.label) {
            rule.segment = source.label->text;
            const auto [known, fresh] = labels_.emplace(source.label->text, source.label->span);
            if (!fresh) {
                diagnostics_.push_back(error("tangle.repeated-label",
                                             "the label '" + source.label->text + "' already names another rule",
                                             source.label->span));
            }
            if (find_operator(source.label->text) != nullptr) {  // paths could not tell the two apart
                diagnostics_.push_back(
                    error("tangle.label-of-operator",
                          "'" + source.label->text + "' is the name of an operator, so it cannot be a label",
                          source.label->span));
            }
        } else {
            const std::string name(rule.op->description.name);
            const int number = ++unlabelled_[{rule.tag, name}];
            rule.segment = number == 1 ? name : name + "#" + std::to_string(number);
        }
        rule.key = Key{hash_text(rule.segment)};
    }

    void read_outputs(Rule& rule, const GroupRule& source) {
        const auto& ports = rule.op->description.ports;
        rule.outputs.assign(ports.size(), Output{0, false});
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
                    diagnostics_.push_back(
                        error("tangle.repeated-port", "the output '" + output.port + "' is named twice", output.span));
                    continue;
                }
            } else {
                port = next++;
                if (port >= ports.size()) {
                    diagnostics_.push_back(
                        warning("tangle.surplus-output",
                                "'" + std::string(rule.op->description.name) + "' has " +
                                    (ports.size() == 1 ? "one output" : std::to_string(ports.size()) + " outputs") +
                                    "; this tag is never produced",
                                output.span));
                    if (!output.dropped && !output.tag.empty()) tag_index(output.tag);
                    continue;
                }
            }
            taken[port] = true;
            rule.outputs[port] = {output.dropped ? 0 : tag_index(output.tag), output.dropped};
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
        if (hints.empty()) hints.push_back("its outputs are " + all);
        return error("tangle.unknown-port",
                     "'" + std::string(op.description.name) + "' has no output '" + output.port + "'", output.span,
                     hints);
    }

    const Settings& settings_;
    const Document& document_;
    Grammar grammar_;
    Diagnostics diagnostics_;
    std::map<std::string, std::uint32_t> tag_indices_;
    std::map<std::string, SourceSpan> labels_;
    std::map<std::pair<std::uint32_t, std::string>, int> unlabelled_;
};

}  // namespace

std::uint32_t Grammar::find_tag(std::string_view name) const {
    const auto found = std::find(tags.begin(), tags.end(), name);
    return found == tags.end() ? none : static_cast<std::uint32_t>(found - tags.begin());
}

Result<Grammar> read_grammar(const Settings& settings, const Document& document,
                             std::span<const std::string> start_tags) {
    return GrammarReader(settings, document).read(start_tags);
}

}  // namespace filigree::tangle
