#include "derivation/inputs.h"

#include <algorithm>

#include "language/walk.h"
#include "language/word_settings.h"

namespace filigree {

namespace {

class FileFinder {
public:
    explicit FileFinder(const Document& document) : document_(document) {}

    std::vector<Name> files;

    void look_into(const std::vector<Statement>& statements) {
        for (const Statement& statement : statements) std::visit(*this, statement.node);
    }

    void operator()(const ParamStatement& param) { look_into(param.value); }
    void operator()(const LetStatement& let) { look_into(let.value); }
    void operator()(const StartStatement& start) {
        if (start.from) add(start.from->text, start.from->span);
        look_into(start.value);
    }
    void operator()(const GroupRule& rule) { look_into(rule.arguments); }
    void operator()(const PresetStatement& preset) { look_into(preset.value); }
    void operator()(const ApplyStatement& apply) { look_into(apply.arguments); }
    void operator()(const ShapeRule& rule) {
        look_into(rule.left);
        look_into(rule.right);
        for (const ExpressionPtr& forbidden : rule.unless) look_into(forbidden);
    }
    void operator()(const RulesFromStatement& rules) { add(rules.file.text, rules.file.span); }
    void operator()(const OperatorStatement& macro) { look_into(macro.statements); }
    // array M from "rules.csv", image wall "photo.png" over ..., letter b file("leaf.svg")
    void operator()(const SettingStatement& setting) {
        if (setting.name.text == "letter") {
            for (const ExpressionPtr& value : setting.values) look_into(value);
        }
        const WordSetting* of_words = find_word_setting(setting.name.text);  // null of shapes
        const bool is_map = of_words != nullptr && of_words->is_map;
        const std::size_t place = is_map ? 1 : 2;
        if ((!is_map && setting.name.text != "array") || setting.values.size() <= place) return;
        const auto* word = std::get_if<NameReference>(&setting.values[place - 1]->node);
        const auto* file = std::get_if<TextLiteral>(&setting.values[place]->node);
        if (word != nullptr && (is_map || word->name == "from") && file != nullptr) {
            add(file->text, setting.values[place]->span);
        }
    }
    template <class Other>
    void operator()(const Other&) {}  // a system is a document of its own

private:
    const Document& document_;

    void add(const std::string& name, SourceSpan span) {
        const bool known = std::any_of(files.begin(), files.end(), [&](const Name& file) { return file.text == name; });
        if (!known) files.push_back({name, span});
    }

    void look_into(const std::vector<CallArgument>& arguments) {
        for (const CallArgument& argument : arguments) look_into(argument.value);
    }
    void look_into(const ExpressionPtr& root) {
        visit_nodes(root, [&](const Expression& node) {
            if (const auto* call = std::get_if<CallExpression>(&node.node)) add_file_of(*call);
            return &node;
        });
    }

    // Every node, parents first; below each come the parts of what the visitor gives back for it, if anything.
    template <class Visitor>
    static void visit_nodes(const ExpressionPtr& root, Visitor visitor) {
        std::vector<const Expression*> open;
        if (root) open.push_back(root.get());
        while (!open.empty()) {
            const Expression* node = open.back();
            open.pop_back();
            node = visitor(*node);
            if (node == nullptr) continue;
            const std::vector<PlacedExpression> parts = parts_of(*node, {}, true);
            for (auto part = parts.rbegin(); part != parts.rend(); ++part) open.push_back(part->expression);
        }
    }

    // What a `let` or `param` says; null where there is none.
    const Expression* definition_of(const std::string& name) const {
        for (const Statement& statement : document_.statements) {
            const auto* let = std::get_if<LetStatement>(&statement.node);
            const auto* param = std::get_if<ParamStatement>(&statement.node);
            if (let != nullptr && let->name.text == name) return let->value.get();
            if (param != nullptr && param->name.text == name) return param->value.get();
        }
        return nullptr;
    }

    // All texts that the expression can come to, such as both of one_of("a.svg", "b.svg").
    void add_texts_in(const ExpressionPtr& root) {
        std::vector<const Expression*> met;  // definitions, each followed once
        visit_nodes(root, [&](const Expression& node) -> const Expression* {
            const Expression* value = &node;
            if (const auto* name = std::get_if<NameReference>(&node.node)) {
                value = definition_of(name->name);
                if (value == nullptr || std::find(met.begin(), met.end(), value) != met.end()) return nullptr;
                met.push_back(value);
            }
            if (const auto* text = std::get_if<TextLiteral>(&value->node)) add(text->text, value->span);
            return value;
        });
    }

    // The argument that names a file, by its name or its place.
    void add_file_of(const CallExpression& call) {
        const bool is_text = call.name == "text";
        if (!is_text && call.name != "file" && call.name != "image") return;
        const std::string_view wanted = is_text ? "font" : "name";
        std::size_t place = is_text ? 1 : 0;
        for (const CallArgument& argument : call.arguments) {
            const auto* key = argument.key ? std::get_if<NameReference>(&argument.key->node) : nullptr;
            if (argument.key ? key == nullptr || key->name != wanted : place-- != 0) continue;
            add_texts_in(argument.value);
            return;
        }
    }
};

}  // namespace

std::vector<Name> named_files(const Document& document) {
    FileFinder finder(document);
    finder.look_into(document.statements);
    return std::move(finder.files);
}

}  // namespace filigree
