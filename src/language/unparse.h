// For tests: a document written again from its parts, one statement a line, every operation in brackets.
//
// Two documents mean the same if they are written alike; what is written parses to the same document.
#pragma once

#include <string>
#include <string_view>

#include "base/number_text.h"
#include "language/choice_path.h"
#include "language/document.h"

namespace filigree {

inline std::string unparse(const ExpressionPtr& expression);

inline std::string unparse_text(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '\n') {
            result += "\\n";
        } else {
            if (c == '"' || c == '\\') result += '\\';
            result += c;
        }
    }
    return result + "\"";
}

inline std::string unparse_unit(Unit unit) {
    constexpr std::string_view spellings[] = {"",    "mm",   "cm", "m",  "in", "pt", "px", "deg",
                                              "rad", "turn", "%",  "KB", "MB", "GB", "s"};
    return std::string(spellings[static_cast<std::size_t>(unit)]);
}

struct ExpressionUnparser {
    static std::string joined(const std::vector<ExpressionPtr>& items) {
        std::string result;
        for (const ExpressionPtr& item : items) result += (result.empty() ? "" : ", ") + unparse(item);
        return result;
    }
    std::string operator()(const NumberLiteral& node) const { return to_text(node.value) + unparse_unit(node.unit); }
    std::string operator()(const TextLiteral& node) const { return unparse_text(node.text); }
    std::string operator()(const ColourLiteral& node) const { return to_text(node.colour); }
    std::string operator()(const BoolLiteral& node) const { return node.value ? "true" : "false"; }
    std::string operator()(const NameReference& node) const { return node.name; }
    std::string operator()(const ListExpression& node) const { return "[" + joined(node.items) + "]"; }
    std::string operator()(const PointExpression& node) const { return "(" + joined(node.coordinates) + ")"; }
    std::string operator()(const UnaryExpression& node) const {
        return (node.op == UnaryOperator::negate ? "(-" : "(!") + unparse(node.operand) + ")";
    }
    std::string operator()(const BinaryExpression& node) const {
        constexpr std::string_view signs[] = {"||", "&&", "==", "!=", "<", "<=", ">", ">=", "+", "-", "*", "/", "&"};
        const std::string sign(signs[static_cast<std::size_t>(node.op)]);
        return "(" + unparse(node.left) + " " + sign + " " + unparse(node.right) + ")";
    }
    std::string operator()(const ConditionalExpression& node) const {
        return "(" + unparse(node.condition) + " ? " + unparse(node.when_true) + " : " + unparse(node.when_false) + ")";
    }
    std::string operator()(const RangeExpression& node) const {
        return "(" + unparse(node.low) + " .. " + unparse(node.high) + ")";
    }
    std::string operator()(const WithinExpression& node) const {
        return "(" + unparse(node.value) + " in " + unparse(node.range) + ")";
    }
    std::string operator()(const CallExpression& node) const {
        std::string result = node.name + "(";
        for (const CallArgument& argument : node.arguments) {
            if (&argument != &node.arguments.front()) result += ", ";
            if (argument.key) result += unparse(argument.key) + ": ";
            result += unparse(argument.value);
        }
        return result + ")";
    }
    std::string operator()(const MemberExpression& node) const {
        // `12 .a` is a member of a number, `12.a` a wrong unit.
        const bool is_number = std::holds_alternative<NumberLiteral>(node.object->node);
        return "(" + unparse(node.object) + (is_number ? " ." : ".") + node.name + ")";
    }
};

inline std::string unparse(const ExpressionPtr& expression) {
    return expression ? std::visit(ExpressionUnparser{}, expression->node) : "";
}

inline std::string unparse(const Statement& statement);

struct StatementUnparser {
    static std::string with(std::string_view word, const ExpressionPtr& expression) {
        return expression ? " " + std::string(word) + " " + unparse(expression) : "";
    }
    std::string operator()(const VersionStatement& node) const { return "filigree " + to_text(node.version); }
    std::string operator()(const GrammarStatement& node) const { return "grammar " + node.engine.text; }
    std::string operator()(const SeedStatement& node) const { return "seed " + to_text(node.seed); }
    std::string operator()(const UnitStatement& node) const { return "unit " + unparse_unit(node.unit); }
    std::string operator()(const ResolutionStatement& node) const { return "resolution " + unparse(node.value); }
    std::string operator()(const IncludeStatement& node) const { return "include " + unparse_text(node.file.text); }
    std::string operator()(const ParamStatement& node) const {
        return "param " + node.name.text + " = " + unparse(node.value) + with("in", node.domain) +
               with("step", node.step) + (node.help ? " " + unparse_text(*node.help) : "");
    }
    std::string operator()(const LetStatement& node) const {
        return "let " + node.name.text + " = " + unparse(node.value);
    }
    std::string operator()(const PageStatement& node) const {
        const std::string size = unparse(node.width) + " x " + unparse(node.height);
        std::string result = "page ";
        switch (node.kind) {
            case PageStatement::Kind::fit:
                result += "fit";
                break;
            case PageStatement::Kind::named:
                result += node.name.text;
                break;
            case PageStatement::Kind::size:
                result += size;
                break;
            case PageStatement::Kind::tile:
                result += "tile " + size;
                break;
        }
        return result + with("margin", node.margin);
    }
    std::string operator()(const LimitStatement& node) const {
        return "limit " + node.name.text + " " + unparse(node.value);
    }
    std::string operator()(const SymmetryStatement& node) const { return "symmetry " + node.group.text; }
    std::string operator()(const PaletteStatement& node) const {
        return "palette " + node.name.text + " = " + unparse(node.colours);
    }
    std::string operator()(const StartStatement& node) const {
        if (node.from) return "start from " + unparse_text(node.from->text);
        return "start " + node.tag.text + " = " + unparse(node.value);
    }
    std::string operator()(const StyleStatement& node) const {
        std::string result = "style ";
        for (const Name& tag : node.tags) result += (&tag == &node.tags.front() ? "" : ", ") + tag.text;
        result += with("when", node.condition) + " {";
        for (const StyleProperty& property : node.properties) {
            result += " " + property.name.text + ": " + unparse(property.value) + ";";
        }
        return result + " }";
    }
    std::string operator()(const GroupRule& node) const {
        std::string result = node.label ? node.label->text + " = " : "";
        result += ExpressionUnparser{}(CallExpression{node.operator_name.text, {}, node.arguments});
        result += " : " + node.tag.text + with("when", node.condition) + with("weight", node.weight);
        return result + outputs(node.outputs);
    }
    std::string operator()(const PresetStatement& node) const {
        return (node.is_default ? "default " : "set ") + to_text(node.path) + " = " + unparse(node.value) +
               with("when", node.condition);
    }
    std::string operator()(const KeepStatement& node) const { return "keep " + to_text(node.path); }
    std::string operator()(const RerollStatement& node) const {
        const bool has_times = node.times_span.file != SourceSpan::no_file;
        return "reroll " + to_text(node.path) + (has_times ? " x " + to_text(std::uint64_t{node.times}) : "");
    }
    std::string operator()(const ApplyStatement& node) const {
        std::string result = "apply " + (node.name ? node.name->text + " = " : "");
        result += ExpressionUnparser{}(CallExpression{node.operator_name.text, {}, node.arguments});
        for (const ChoicePath& target : node.targets) {
            result += (&target == &node.targets.front() ? " to " : ", ") + to_text(target);
        }
        return result + outputs(node.outputs);
    }
    std::string operator()(const SystemStatement& node) const {
        return "system " + node.name.text + (node.parameters.empty() ? "" : parameters(node.parameters)) +
               block(node.statements);
    }
    std::string operator()(const OperatorStatement& node) const {
        std::string result = "operator " + node.name.text + parameters(node.parameters);
        for (const Name& port : node.ports) result += (&port == &node.ports.front() ? " -> " : ", ") + port.text;
        return result + block(node.statements);
    }

    std::string operator()(const WordRule& node) const {
        std::string result = node.left.text.empty() ? "" : unparse_text(node.left.text) + " < ";
        result += unparse_text(node.symbol.text);
        if (!node.right.text.empty()) result += " > " + unparse_text(node.right.text);
        result += iterations(node.first, node.last) + " -> ";
        for (const WordSuccessor& successor : node.successors) {
            if (&successor != &node.successors.front()) result += ", ";
            if (successor.text) result += unparse_text(successor.text->text);
            if (successor.target) {
                result +=
                    "goto " + unparse_text(successor.target->text) + "@" + to_text(std::uint64_t{successor.iteration});
            }
            if (successor.array) result += successor.array->text + indexes(successor.indexes);
            if (successor.lookup) result += lookup(*successor.lookup);
            if (successor.weight) result += " * (" + unparse(successor.weight) + ")";
        }
        result += with("loop", node.loop) + with("when", node.condition);
        if (node.assignments.empty()) return result;
        result += " {";
        for (const WordAssignment& assignment : node.assignments) {
            result += " " + assignment.name.text + " = " + unparse(assignment.value) + ";";
        }
        return result + " }";
    }
    std::string operator()(const MacroStatement& node) const {
        return unparse_text(node.symbol.text) + " = random " + unparse(node.length) + " " +
               unparse_text(node.letters.text) + (node.is_unique ? " unique" : "");
    }
    std::string operator()(const CellStatement& node) const {
        return node.array.text + indexes(node.indexes) + " -> " + unparse_text(node.text.text);
    }
    std::string operator()(const RestStatement& node) const {
        return (node.is_until ? "sleep" : "mask") + numbered(node.symbols) +
               with(node.is_until ? "until" : "when", node.condition);
    }
    std::string operator()(const LoopStatement& node) const {
        return "loop" + numbered(node.symbols) + " " + unparse(node.length);
    }
    std::string operator()(const WordEditStatement& node) const {
        std::string result = "after " + to_text(std::uint64_t{node.first}) + ".." + to_text(std::uint64_t{node.last});
        if (node.last == UINT32_MAX) result = "each iteration";
        result = (node.is_once ? "once" : result) + " " + node.edit_name.text + "(";
        for (const CallArgument& argument : node.arguments) {
            if (&argument != &node.arguments.front()) result += ", ";
            const bool is_pair = argument.key && std::holds_alternative<TextLiteral>(argument.key->node);
            if (argument.key) result += unparse(argument.key) + (is_pair ? " -> " : ": ");
            result += unparse(argument.value);
        }
        return result + ")";
    }
    std::string operator()(const SettingStatement& node) const {
        std::string result = node.name.text;
        for (const ExpressionPtr& value : node.values) {
            result += (&value == &node.values.front() ? " " : ", ") + unparse(value);
        }
        return result;
    }
    std::string operator()(const ShapeRule& node) const {
        std::string result = node.name.text + " = ";
        if (node.derivation) return result + unparse(node.derivation);
        result += unparse(node.left) + " -> " + unparse(node.right) + with("match", node.match) +
                  with("weight", node.weight) + with("priority", node.priority);
        for (const ExpressionPtr& forbidden : node.unless) result += with("unless", forbidden);
        return result + with("when", node.condition);
    }
    std::string operator()(const RulesFromStatement& node) const {
        return "rules from " + unparse_text(node.file.text);
    }
    std::string operator()(const MatchStatement& node) const {
        return "apply " + (node.name ? node.name->text + " = " : "") + node.rule.text + with("at", node.at) +
               with("angle", node.angle) + with("scale", node.scale) + (node.is_mirrored ? " mirrored" : "") +
               (node.is_orbit ? " orbit" : "");
    }
    std::string operator()(const BackStatement& node) const { return "back to " + node.name.text; }

private:
    static std::string numbered(const std::vector<NumberedSymbols>& all) {
        std::string result;
        for (const NumberedSymbols& symbols : all) {
            result += &symbols == &all.front() ? " " : ", ";
            result += unparse_text(symbols.text.text) + iterations(symbols.first, symbols.last);
        }
        return result;
    }
    static std::string iterations(std::uint32_t first, std::uint32_t last) {
        if (last == UINT32_MAX) return "";
        return "@" + to_text(std::uint64_t{first}) + ".." + to_text(std::uint64_t{last});
    }
    static std::string lookup(const WordLookup& node) {
        std::string result = (node.is_image ? "image " : "data ") + node.map.text;
        if (node.is_image) result += " " + node.channel.text;
        result += " {";
        for (const WordLookupRow& row : node.rows) {
            result += " " + unparse(row.range) + " " + unparse_text(row.text.text) + ";";
        }
        return result + " }";
    }
    static std::string indexes(const std::vector<ExpressionPtr>& list) {
        std::string result;
        for (const ExpressionPtr& index : list) result += "[" + unparse(index) + "]";
        return result;
    }
    static std::string outputs(const std::vector<OutputTag>& tags) {
        std::string result;
        for (const OutputTag& output : tags) {
            result += &output == &tags.front() ? " -> " : ", ";
            if (!output.port.empty()) result += output.port + ": ";
            result += output.dropped ? "_" : output.tag.empty() ? "<>" : output.tag;
        }
        return result;
    }
    static std::string parameters(const std::vector<DefinitionParameter>& list) {
        std::string result;
        for (const DefinitionParameter& parameter : list) {
            result += (result.empty() ? "" : ", ") + parameter.name.text;
            if (parameter.value) result += " = " + unparse(parameter.value);
        }
        return "(" + result + ")";
    }
    static std::string block(const std::vector<Statement>& statements) {
        std::string result = " {";
        for (const Statement& statement : statements) result += " " + unparse(statement) + ";";
        return result + " }";
    }
};

inline std::string unparse(const Statement& statement) { return std::visit(StatementUnparser{}, statement.node); }

inline std::string unparse(const Document& document) {
    std::string result;
    for (const Statement& statement : document.statements) result += unparse(statement) + "\n";
    return result;
}

}  // namespace filigree
