#include "language/edit_presets.h"

#include <algorithm>
#include <optional>

#include "base/number_text.h"
#include "language/choice_path.h"
#include "language/edit.h"
#include "language/edit_text.h"
#include "language/parse.h"
#include "language/token_text.h"

namespace filigree {

namespace {

// The name that a path behind `set` or `default` gives a value to, as `gap` and `let/gap` do.
std::optional<std::string_view> defined_name(const ChoicePath& path) {
    const auto is_plain = [](const PathSegment& segment) {
        return segment.kind == PathSegment::Kind::name && segment.ordinals.empty();
    };
    if (!path.parameter.empty() || !std::all_of(path.segments.begin(), path.segments.end(), is_plain)) {
        return std::nullopt;
    }
    if (path.segments.size() == 1) return path.segments[0].name;
    if (path.segments.size() == 2 && path.segments[0].name == "let") return path.segments[1].name;
    return std::nullopt;
}

bool same_preset_path(const ChoicePath& a, const ChoicePath& b) {
    const std::optional<std::string_view> name = defined_name(a);
    return same_path(a, b) || (name && name == defined_name(b) && a.draw == b.draw);
}

bool is_own_parameter(const Document& document, std::string_view name) {
    return std::any_of(document.statements.begin(), document.statements.end(), [&](const Statement& statement) {
        const ParamStatement* param = std::get_if<ParamStatement>(&statement.node);
        return param != nullptr && statement.span.file == 0 && param->name.text == name;
    });
}

// The last statement of this kind in the document itself that the condition holds for.
template <class Node, class Condition>
const Statement* find_last(const Document& document, Condition holds) {
    const auto found =
        std::find_if(document.statements.rbegin(), document.statements.rend(), [&](const Statement& statement) {
            const Node* node = std::get_if<Node>(&statement.node);
            return node != nullptr && statement.span.file == 0 && holds(*node);
        });
    return found == document.statements.rend() ? nullptr : &*found;
}

const Statement* find_preset(const Document& document, const ChoicePath& path, bool is_default) {
    return find_last<PresetStatement>(document, [&](const PresetStatement& preset) {
        return preset.is_default == is_default && !preset.condition && same_preset_path(preset.path, path);
    });
}

Result<std::string> with_value(const Document& document, std::string_view path_text, std::string_view value_text,
                               bool is_default) {
    const Result<ChoicePath> path = parse_path(path_text);
    if (!path) return path.diagnostics();
    const Result<ExpressionPtr> value = parse_expression(value_text);
    if (!value) return value.diagnostics();
    // Only spans in a file can be joined, so that they cover the whole.
    const std::string_view written = text_of(**parse_expression(value_text, 0), value_text);
    if (const Statement* const old = find_preset(document, *path, is_default)) {
        const SourceSpan span = std::get<PresetStatement>(old->node).value->span;
        return spliced(document.text(), span.begin, span.end, written);
    }
    const std::optional<std::string_view> name = defined_name(*path);
    if (!is_default && name && path->draw == 0 && is_own_parameter(document, *name)) {
        return with_parameter(document, *name, value_text);
    }
    const std::string word = is_default ? "default " : "set ";
    return with_last_line(document.text(), word + to_text(*path) + " = " + std::string(written));
}

// With the nearest path of a statement of this kind.
template <class Node>
Diagnostic no_such(std::string code, std::string_view word, const Document& document, const ChoicePath& path) {
    std::vector<std::string> there;
    for (const Statement& statement : document.statements) {
        const Node* node = std::get_if<Node>(&statement.node);
        if (node != nullptr && statement.span.file == 0) there.push_back(to_text(node->path));
    }
    const std::string text = to_text(path);
    return error(std::move(code), "the document has no '" + std::string(word) + "' of " + in_quotes(text), {},
                 did_you_mean(text, {there.begin(), there.end()}));
}

std::string to_text(const OutputTag& output) {
    const std::string tag = output.dropped ? "_" : output.tag.empty() ? "<>" : output.tag;
    return output.port.empty() ? tag : output.port + ": " + tag;
}

}  // namespace

Result<std::string> with_preset(const Document& document, std::string_view path, std::string_view value) {
    return with_value(document, path, value, false);
}

Result<std::string> with_default(const Document& document, std::string_view path, std::string_view value) {
    return with_value(document, path, value, true);
}

Result<std::string> without_preset(const Document& document, std::string_view path_text) {
    const Result<ChoicePath> path = parse_path(path_text);
    if (!path) return path.diagnostics();
    const Statement* const found = find_preset(document, *path, false);
    if (found != nullptr) return without_statement(document.text(), found->span.begin, found->span.end);
    return no_such<PresetStatement>("edit.no-such-preset", "set", document, *path);
}

Result<std::string> with_keep(const Document& document, std::string_view path_text) {
    const Result<ChoicePath> path = parse_path(path_text);
    if (!path) return path.diagnostics();
    const auto is_it = [&](const KeepStatement& keep) { return same_path(keep.path, *path); };
    if (find_last<KeepStatement>(document, is_it) != nullptr) return document.text();
    return with_last_line(document.text(), "keep " + to_text(*path));
}

Result<std::string> without_keep(const Document& document, std::string_view path_text) {
    const Result<ChoicePath> path = parse_path(path_text);
    if (!path) return path.diagnostics();
    std::string text = document.text();
    bool is_there = false;
    // From the end, so that the places before stay where they are.
    for (auto statement = document.statements.rbegin(); statement != document.statements.rend(); ++statement) {
        const KeepStatement* keep = std::get_if<KeepStatement>(&statement->node);
        if (keep == nullptr || statement->span.file != 0 || !same_path(keep->path, *path)) continue;
        text = without_statement(text, statement->span.begin, statement->span.end);
        is_there = true;
    }
    if (is_there) return text;
    return no_such<KeepStatement>("edit.no-such-keep", "keep", document, *path);
}

Result<std::string> with_reroll(const Document& document, std::string_view path_text, std::uint32_t more) {
    const Result<ChoicePath> path = parse_path(path_text);
    if (!path) return path.diagnostics();
    const std::string& text = document.text();
    const Statement* old = find_last<RerollStatement>(
        document, [&](const RerollStatement& reroll) { return same_path(reroll.path, *path); });
    // What is said before a `keep` is kept by it.
    const Statement* const keep = find_last<KeepStatement>(document, [](const KeepStatement&) { return true; });
    if (old != nullptr && keep != nullptr && old->span.begin < keep->span.begin) old = nullptr;
    const RerollStatement* const reroll = old == nullptr ? nullptr : &std::get<RerollStatement>(old->node);
    const std::uint64_t times = (reroll == nullptr ? 0 : std::uint64_t{reroll->times}) + more;
    if (times > max_rerolls) {
        return error("edit.too-many-rerolls",
                     in_quotes(to_text(*path)) + " would be drawn again more than 1000000000 times");
    }
    if (more == 0) return text;
    const std::string count = to_text(times);
    if (reroll == nullptr) {
        return with_last_line(text, "reroll " + to_text(*path) + (times == 1 ? "" : " x " + count));
    }
    if (reroll->times_span.file == SourceSpan::no_file) {
        return spliced(text, old->span.end, old->span.end, " x " + count);
    }
    return spliced(text, reroll->times_span.begin, reroll->times_span.end, count);
}

Result<std::string> with_apply(const Document& document, std::string_view call_text,
                               const std::vector<std::string>& targets, std::string_view outputs_text) {
    const Result<OperatorCall> call = parse_call(call_text);
    if (!call) return call.diagnostics();
    std::string line = "apply " + std::string(call_text.substr(call->span.begin, call->span.end - call->span.begin));
    if (targets.empty()) return error("language.missing-path", "a step by hand needs the path of a group");
    for (const std::string& target : targets) {
        const Result<ChoicePath> path = parse_path(target);
        if (!path) return path.diagnostics();
        if (!path->parameter.empty() || path->draw != 0) {
            return error("language.bad-target", "a step is applied to groups, not to a parameter", path->span,
                         {"write the path without what stands behind its group"});
        }
        line += (&target == &targets.front() ? " to " : ", ") + to_text(*path);
    }
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = outputs_text.find_first_not_of(blanks);
    if (first != std::string_view::npos) {
        const Result<std::vector<OutputTag>> outputs = parse_outputs(outputs_text);
        if (!outputs) return outputs.diagnostics();
        for (const OutputTag& output : *outputs) {
            line += (&output == &outputs->front() ? " -> " : ", ") + to_text(output);
        }
    }
    return with_last_line(document.text(), line);
}

}  // namespace filigree
