#include "language/names.h"

#include <algorithm>

#include "base/number_text.h"
#include "language/functions.h"

namespace filigree {

namespace {

constexpr std::string_view step_name_list[] = {"area", "width", "height", "count", "depth", "group"};
constexpr std::string_view shape_name_list[] = {"index", "x", "y", "i", "j"};
constexpr std::string_view style_name_list[] = {"area",  "width", "height", "x",     "y",
                                                "index", "i",     "j",      "depth", "group"};
constexpr std::string_view word_style_name_list[] = {"index",    "x",       "y",           "z",      "depth", "age",
                                                     "distance", "density", "homogeneity", "colour", "width", "group",
                                                     "count",    "t"};
constexpr std::string_view special_forms[] = {"one_of", "normal", "each"};

bool contains(std::span<const std::string_view> names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void add_names(std::vector<std::string_view>& to, const Scope* scope) {
    for (; scope != nullptr; scope = scope->outer) {
        for (const auto& [name, value] : scope->names) to.push_back(name);
    }
}

std::string counted(std::size_t count, std::string_view noun) {
    return to_text(std::uint64_t{count}) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

struct Arity {
    std::size_t least = 1, most = 1;
    bool weights = false;  // one_of: "candidate: weight"
    std::string_view signature;
};

Arity arity_of(const CallExpression& call, CallMeaning meaning) {
    if (meaning == CallMeaning::function) {
        const Function* function = find_function(call.name);
        return {function->least_arguments, function->most_arguments, false, function->signature};
    }
    if (meaning == CallMeaning::list) return {1, 1, false, {}};
    if (call.name == "normal") return {2, 2, false, "normal(mean, deviation)"};
    if (call.name == "each") return {1, 1, false, "each(value)"};
    return {1, Function::any_number, true, "one_of(a, b, ...)"};
}

}  // namespace

std::span<const std::string_view> step_names() { return step_name_list; }
std::span<const std::string_view> shape_names() { return shape_name_list; }
std::span<const std::string_view> style_names() { return style_name_list; }
std::span<const std::string_view> word_style_names() { return word_style_name_list; }

const Value* Scope::find(std::string_view name) const {
    for (const Scope* scope = this; scope != nullptr; scope = scope->outer) {
        const auto found = scope->names.find(name);
        if (found != scope->names.end()) return &found->second;
    }
    return nullptr;
}

const Value* find_value(const Evaluation& at, std::string_view name, bool by_shape) {
    if (by_shape && at.shape_scope != nullptr) {
        if (const Value* value = at.shape_scope->find(name)) return value;
    }
    return at.scope != nullptr ? at.scope->find(name) : nullptr;
}

bool is_word(const Evaluation& at, std::string_view name, Place place) {
    return place.result && contains(at.words, name);
}

bool any_call_allowed(const Evaluation& at) { return contains(at.calls, "*"); }
bool bare_words_in_calls(const Evaluation& at) { return at.words_in_calls || any_call_allowed(at); }

Place top_place(const Evaluation& at) { return {true, contains(at.words, "*"), at.whole, at.by_shape, at.shapes}; }

CallMeaning meaning_of(const CallExpression& call, const Evaluation& at, Place place) {
    if (is_special_form(call.name)) return CallMeaning::special;
    if (find_function(call.name) != nullptr) return CallMeaning::function;
    if (place.result && contains(at.calls, call.name)) return CallMeaning::symbolic;
    const Value* value = find_value(at, call.name, place.by_shape);
    if (value != nullptr && std::holds_alternative<ValueList>(value->data)) return CallMeaning::list;
    if (value == nullptr && place.result && any_call_allowed(at)) return CallMeaning::symbolic;
    return CallMeaning::none;
}

std::optional<Diagnostic> wrong_arguments(const CallExpression& call, CallMeaning meaning, SourceSpan span) {
    if (meaning == CallMeaning::none) return std::nullopt;
    if (meaning == CallMeaning::symbolic) {
        for (const CallArgument& argument : call.arguments) {
            if (argument.key && !std::holds_alternative<NameReference>(argument.key->node)) {
                return error("language.wrong-arguments", "the name of an argument is a bare word", argument.key->span);
            }
        }
        return std::nullopt;
    }
    const Arity arity = arity_of(call, meaning);
    std::vector<std::string> hints;
    if (!arity.signature.empty()) hints.push_back("it is written " + std::string(arity.signature));
    if (!arity.weights) {
        for (const CallArgument& argument : call.arguments) {
            if (!argument.key) continue;
            return error("language.wrong-arguments", "the arguments of '" + call.name + "' have no names",
                         argument.key->span, hints);
        }
    }
    const std::size_t given = call.arguments.size();
    if (given >= arity.least && given <= arity.most) return std::nullopt;
    std::string message = "'" + call.name + "' takes ";
    if (arity.least != arity.most) message += given < arity.least ? "at least " : "at most ";
    message += counted(given < arity.least ? arity.least : arity.most, "argument");
    message += given == 0 ? ", but none is given"
                          : ", but " + to_text(std::uint64_t{given}) + (given == 1 ? " is" : " are") + " given";
    return error("language.wrong-arguments", std::move(message), span, std::move(hints));
}

Diagnostic unknown_name(std::string_view name, SourceSpan span, const Evaluation& at, Place place) {
    const std::string quoted = "'" + std::string(name) + "'";
    if (find_function(name) != nullptr || is_special_form(name)) {
        return error("language.unknown-name", quoted + " is a function and needs its arguments", span,
                     {"write " + std::string(name) + "(...)"});
    }
    if (!place.by_shape && contains(shape_names(), name)) {
        return error("language.unknown-name",
                     quoted + " differs from shape to shape and is known only inside each(...)", span);
    }
    if (contains(at.words, name)) {
        return error("language.unknown-name", "the word " + quoted + " cannot be part of a calculation", span);
    }
    if (contains(step_names(), name) || contains(shape_names(), name)) {
        return error("language.unknown-name", quoted + " is not known here, only in rules and styles", span);
    }
    if (name == "page.width" || name == "page.height") {
        return error("language.unknown-name", quoted + " is known only where the page has a size", span,
                     {"write a page statement, as in 'page 210mm x 297mm' or 'page a4'"});
    }
    std::vector<std::string_view> candidates;
    if (place.result) candidates.insert(candidates.end(), at.words.begin(), at.words.end());
    if (place.by_shape) add_names(candidates, at.shape_scope);
    add_names(candidates, at.scope);
    std::vector<std::string> hints = did_you_mean(name, candidates);
    if (hints.empty() && place.result && !at.words.empty() && !at.shapes) {
        hints.push_back("the words that may stand here are " + quoted_alternatives(at.words));
    }
    return error("language.unknown-name", "there is no name " + quoted, span, std::move(hints));
}

Diagnostic unknown_call(const CallExpression& call, SourceSpan span, const Evaluation& at, Place place) {
    const std::string quoted = "'" + call.name + "'";
    if (const Value* value = find_value(at, call.name, place.by_shape)) {
        return error("language.unknown-function",
                     quoted + " is " + std::string(kind_of(*value)) + " and takes no arguments", span);
    }
    if (contains(at.calls, call.name) || any_call_allowed(at)) {
        return error("language.unknown-function", quoted + " cannot be part of a calculation", span);
    }
    std::vector<std::string_view> candidates;
    if (place.result) candidates.insert(candidates.end(), at.calls.begin(), at.calls.end());
    for (const Function& function : functions()) candidates.push_back(function.name);
    for (const std::string_view form : special_forms) candidates.push_back(form);
    add_names(candidates, at.scope);
    return error("language.unknown-function", "there is no function " + quoted, span,
                 did_you_mean(call.name, candidates));
}

Diagnostic each_outside(SourceSpan span) {
    return error("language.each-outside", "each(...) is known only in the arguments of a rule's operator", span);
}

std::string quoted_alternatives(std::span<const std::string_view> words) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) out += i + 1 == words.size() ? " or " : ", ";
        out += "'" + std::string(words[i]) + "'";
    }
    return out;
}

}  // namespace filigree
