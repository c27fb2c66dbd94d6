#include "session/open.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/number_text.h"
#include "base/random.h"
#include "derivation/plane_start.h"
#include "engines/rewriting/edit_operators.h"
#include "formats/files.h"
#include "formats/pdf_carried.h"
#include "formats/svg_read.h"
#include "language/check.h"
#include "language/edit.h"
#include "language/edit_presets.h"
#include "language/parse.h"

namespace filigree {
namespace fs = std::filesystem;
namespace {

// The name under which an SVG carries replayed choices; no file of a document can have it.
constexpr const char* carried_choices = "filigree:choices";

// Where a document's files come from: what it carries, or the disk below the folders it may read.
class InputSource {
public:
    InputSource(fs::path folder, std::vector<fs::path> allowed) : folder_(std::move(folder)) {
        roots_.push_back(folder_.empty() ? fs::path(".") : folder_);
        roots_.insert(roots_.end(), allowed.begin(), allowed.end());
    }
    explicit InputSource(Inputs given) : given_(std::move(given)), on_disk_(false) {}

    Result<std::string> load(std::string_view name) {
        const Input* known = find_input(loaded_, name);
        if (known != nullptr) return known->bytes;
        Result<std::string> bytes = on_disk_ ? read(std::string(name)) : find(name);
        if (bytes) loaded_.push_back({std::string(name), *bytes});
        return bytes;
    }

    // The same for all names of one file, whatever links lead to it.
    std::string identity(const std::string& name) const {
        if (!on_disk_) return name;
        const std::optional<fs::path> real = real_path(path_of(name));
        return real ? real->generic_string() : name;
    }

    const Inputs& loaded() const { return loaded_; }
    const std::vector<fs::path>& files() const { return files_; }

private:
    // Without links; the file may not be there.
    static std::optional<fs::path> real_path(const fs::path& path) {
        std::error_code failed;
        const fs::path whole = fs::absolute(path, failed);
        if (failed) return std::nullopt;
        const fs::path real = fs::weakly_canonical(whole, failed);
        return failed ? std::nullopt : std::optional(real);
    }

    fs::path path_of(const std::string& name) const {
        return fs::path(name).is_absolute() ? fs::path(name) : folder_ / name;
    }

    Result<std::string> find(std::string_view name) const {
        const Input* input = find_input(given_, name);
        if (input != nullptr) return input->bytes;
        return error("input.missing", "the file '" + std::string(name) + "' is not carried with the document");
    }

    Result<std::string> read(const std::string& name) {
        if (name.empty()) return error("input.missing", "a file without a name cannot be read");
        const fs::path path = path_of(name);
        const std::optional<fs::path> real = real_path(path);
        const bool inside = real && std::any_of(roots_.begin(), roots_.end(), [&](const fs::path& root) {
                                std::error_code unknown;
                                const fs::path top = fs::canonical(root, unknown);
                                if (unknown) return false;
                                const fs::path relative = real->lexically_relative(top);
                                return !relative.empty() && *relative.begin() != "..";
                            });
        if (!inside) {
            return error("input.outside", "'" + name + "' lies outside the document's folder, so it is not read", {},
                         {"--allow DIR lets documents read below DIR"});
        }
        files_.push_back(path);
        Result<std::string> bytes = read_file(path);
        if (bytes) return bytes;
        Diagnostic reason = error("input.missing", "the file '" + name + "' cannot be read", {},
                                  {"files are looked up beside the document"});
        if (!bytes.diagnostics().empty()) reason.hints.push_back(bytes.diagnostics().front().message);
        return reason;
    }

    Inputs loaded_;                // in the order in which they were asked for
    std::vector<fs::path> files_;  // those on disk
    Inputs given_;
    bool on_disk_ = true;
    fs::path folder_;
    std::vector<fs::path> roots_;
};

Parsed parse_with(const std::string& name, const std::string& text, InputSource& source) {
    return parse_document(name, text, [&](std::string_view included) { return source.load(included); });
}

bool looks_like_svg(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string_view::npos && text[first] == '<';
}

// --- embedded documents ------------------------------------------------------------------------------------------

// The call's argument that may name another document, its first or that of a name: all that it may come to.
void find_named(const std::vector<CallArgument>& arguments, std::string_view parameter,
                std::vector<const Expression*>& found) {
    for (const CallArgument& argument : arguments) {
        const auto* key = argument.key ? std::get_if<NameReference>(&argument.key->node) : nullptr;
        if (argument.key && (key == nullptr || key->name != parameter)) continue;
        for (const Alternative& alternative : alternatives_of(*argument.value)) found.push_back(alternative.expression);
        return;
    }
}

// The other document of an edit of two words. The letter of a system, even in quotes, is none.
void find_other_word(const WordEditStatement& edit, const std::vector<Statement>& statements,
                     std::vector<const Expression*>& found) {
    const rewriting::EditOperator* op = rewriting::find_edit(edit.edit_name.text);
    if (op == nullptr || !op->takes_other()) return;
    const std::size_t known = found.size();
    find_named(edit.arguments, "with", found);
    const auto is_system = [&](const Expression* named) {
        const auto* text = std::get_if<TextLiteral>(&named->node);
        return text != nullptr && std::any_of(statements.begin(), statements.end(), [&](const Statement& statement) {
                   const auto* system = std::get_if<SystemStatement>(&statement.node);
                   return system != nullptr && system->name.text == text->text;
               });
    };
    found.erase(std::remove_if(found.begin() + static_cast<std::ptrdiff_t>(known), found.end(), is_system),
                found.end());
}

// Every expression that names a document, behind `embed` and in edits of words, in the order of the statements.
std::vector<const Expression*> embeddings(const std::vector<Statement>& statements) {
    std::vector<const Expression*> found;
    for (const Statement& statement : statements) {
        if (const auto* rule = std::get_if<GroupRule>(&statement.node)) {
            if (rule->operator_name.text == "embed") find_named(rule->arguments, "document", found);
        } else if (const auto* apply = std::get_if<ApplyStatement>(&statement.node)) {
            if (apply->operator_name.text == "embed") find_named(apply->arguments, "document", found);
        } else if (const auto* macro = std::get_if<OperatorStatement>(&statement.node)) {
            for (const Expression* inner : embeddings(macro->statements)) found.push_back(inner);
        } else if (const auto* edit = std::get_if<WordEditStatement>(&statement.node)) {
            find_other_word(*edit, statements, found);
        }
    }
    return found;
}

// A name as a document in `folder` gives it: below that folder, unless it is absolute.
std::string beside(const std::string& folder, const std::string& name) {
    return fs::path(name).is_absolute() ? name : folder + name;
}

std::string folder_of(const std::string& name) {
    const fs::path folder = fs::path(name).parent_path();
    return folder.empty() ? "" : folder.generic_string() + "/";
}

// The names of a document's parameters.
std::vector<std::string> parameters_of(const Document& document) {
    std::vector<std::string> names;
    for (const Statement& statement : document.statements) {
        if (const auto* param = std::get_if<ParamStatement>(&statement.node)) names.push_back(param->name.text);
    }
    return names;
}

// Differs where one of the parts differs, and is as long for many of them as for one.
class Fingerprint {
public:
    void add(const std::string& part) {
        first_ = fold(first_, hash_text(part));
        second_ = fold(second_, hash_text("filigree " + part));
    }
    std::string text() const { return to_hex(first_) + to_hex(second_); }

private:
    std::uint64_t first_ = 0;
    std::uint64_t second_ = 0;
};

std::string fingerprint(const OpenedDocument& opened, const std::string& text) {
    Fingerprint all;
    all.add(text);
    for (const Input& input : opened.inputs) {
        all.add(input.name);
        all.add(input.bytes);
    }
    for (const EmbeddedDocument& inner : opened.embedded) all.add(inner.info.fingerprint);
    return all.text();
}

// Opens the documents inside a document, and those inside them. Each file is opened once; a document that is inside
// itself is an error, as are more than max_embedding_depth of them.
class EmbeddedOpener {
public:
    // `shown_name`: the outermost document's, for messages; what goes before its own name goes before the others'.
    EmbeddedOpener(InputSource& source, OpenedDocument& outermost, const std::string& shown_name)
        : source_(source), outermost_(outermost), on_the_way_{source.identity(outermost.name)} {
        if (shown_name.ends_with(outermost.name)) {
            shown_prefix_ = shown_name.substr(0, shown_name.size() - outermost.name.size());
        }
    }

    void open_all() { open_inside(outermost_, "", {}); }

private:
    // What was opened of a file, for all who embed it.
    struct OpenedFile {
        EmbeddedDocument document;
        std::uint32_t height = 0;  // of the longest chain of documents below it
    };

    // `folder`: that of the document, below that of the outermost one. `around`: the systems that it may name.
    void open_inside(OpenedDocument& opened, const std::string& folder, std::vector<EmbeddedDocument> around) {
        opened.embedded = std::move(around);
        deepest_ = std::max(deepest_, depth_);
        for (const Statement& statement : opened.document.statements) {
            if (const auto* system = std::get_if<SystemStatement>(&statement.node)) {
                open_system(opened, *system, folder);
            }
        }
        for (const Expression* named : embeddings(opened.document.statements)) {
            if (const auto* file = std::get_if<TextLiteral>(&named->node)) {
                embed_file(opened, file->text, named->span, folder);
            }
        }
    }

    void report(Diagnostic problem, OpenedDocument& inside) {
        inside.has_failed = inside.has_failed || problem.severity == Severity::error;
        append(outermost_.diagnostics, at_first_source({std::move(problem)}, inside));
    }

    // A system is a document over the same texts; its parameters with a default are `param`s of it.
    void open_system(OpenedDocument& outer, const SystemStatement& system, const std::string& folder) {
        for (const EmbeddedDocument& known : outer.embedded) {
            if (known.info.is_file || known.info.name != system.name.text) continue;
            report(error("embed.repeated-system", "the system '" + system.name.text + "' is already defined",
                         system.name.span),
                   outer);
            return;
        }
        auto inner = std::make_shared<OpenedDocument>();
        inner->name = system.name.text;
        inner->place = system.name.span;
        inner->has_failed = outer.has_failed;  // what could not be read may have been a part of it
        inner->document.sources = outer.document.sources;
        inner->document.units = outer.document.units;
        if (system.unit) inner->document.units[system.name.span.file] = *system.unit;
        EmbeddableDocument info{system.name.text, false, {}, {}, {}};
        for (const DefinitionParameter& parameter : system.parameters) {
            info.parameters.push_back(parameter.name.text);
            if (!parameter.value) {
                info.required.push_back(parameter.name.text);
                continue;
            }
            inner->document.statements.push_back(
                {parameter.name.span, ParamStatement{parameter.name, parameter.value, nullptr, nullptr, {}}});
        }
        for (const Statement& statement : system.statements) inner->document.statements.push_back(statement);
        for (const std::string& name : parameters_of(inner->document)) {
            if (std::find(info.parameters.begin(), info.parameters.end(), name) == info.parameters.end()) {
                info.parameters.push_back(name);
            }
        }
        if (is_too_deep(outer, system.name.span, 0)) {
            outer.embedded.push_back({std::move(info), nullptr});
            return;
        }
        inner->inputs = outer.inputs;
        inner->first_source = outer.first_source;
        load_named_files(*inner, folder);
        // It may name the systems that stand before it, so no two can embed each other; but not itself.
        ++depth_;
        open_inside(*inner, folder, outer.embedded);
        --depth_;
        const Expression* itself = nullptr;
        for (const Expression* named : embeddings(inner->document.statements)) {
            const auto* name = std::get_if<NameReference>(&named->node);
            if (name != nullptr && name->name == system.name.text) itself = named;
        }
        if (itself != nullptr) {
            report(error("embed.cycle", "the system '" + system.name.text + "' embeds itself", itself->span), outer);
            inner->embedded.push_back({info, nullptr});
        }
        const std::string& text = outer.document.sources[system.name.span.file].text;
        info.fingerprint =
            fingerprint(*inner, text.substr(system.name.span.begin, last_byte(system) - system.name.span.begin));
        outer.embedded.push_back({std::move(info), std::move(inner)});
    }
    static std::uint32_t last_byte(const SystemStatement& system) {
        return system.statements.empty() ? system.name.span.end : system.statements.back().span.end;
    }

    void embed_file(OpenedDocument& outer, const std::string& name, SourceSpan span, const std::string& folder) {
        for (const EmbeddedDocument& known : outer.embedded) {
            if (known.info.is_file && known.info.name == name) return;
        }
        const std::string full = fs::path(beside(folder, name)).lexically_normal().generic_string();
        EmbeddedDocument embedded{{name, true, {}, {}, {}}, nullptr};
        if (const OpenedFile* file = find_file(outer, name, span, full)) {
            embedded = file->document;
            embedded.info.name = name;  // as this document names it
        }
        outer.embedded.push_back(std::move(embedded));
    }

    // Null where there is none at this place, which is reported.
    const OpenedFile* find_file(OpenedDocument& outer, const std::string& name, SourceSpan span,
                                const std::string& full) {
        const std::string identity = source_.identity(full);
        if (std::find(on_the_way_.begin(), on_the_way_.end(), identity) != on_the_way_.end()) {
            report(error("embed.cycle", "the document '" + name + "' would lie inside itself", span), outer);
            return nullptr;
        }
        const auto known = files_.find(full);
        if (known != files_.end()) {
            if (is_too_deep(outer, span, known->second.height)) return nullptr;
            deepest_ = std::max(deepest_, depth_ + 1 + known->second.height);
            return &known->second;
        }
        if (is_too_deep(outer, span, 0)) return nullptr;
        Result<std::string> text = source_.load(full);
        for (Diagnostic reason : text.diagnostics()) {
            reason.span = span;
            report(std::move(reason), outer);
        }
        if (!text) return nullptr;
        if (looks_like_svg(*text)) {
            report(error("embed.not-a-document", "'" + name + "' is a picture, and only documents can be embedded",
                         span, {"an SVG can be grown from: start big_poly = file(\"" + name + "\")"}),
                   outer);
            return nullptr;
        }
        on_the_way_.push_back(identity);
        const std::uint32_t deepest_elsewhere = std::exchange(deepest_, 0);
        ++depth_;
        EmbeddedDocument document = opened_file(name, full, *text);
        const std::uint32_t height = std::max(deepest_, depth_) - depth_;
        --depth_;
        deepest_ = std::max(deepest_, deepest_elsewhere);
        on_the_way_.pop_back();
        return &files_.emplace(full, OpenedFile{std::move(document), height}).first->second;
    }

    EmbeddedDocument opened_file(const std::string& name, const std::string& full, const std::string& text) {
        auto inner = std::make_shared<OpenedDocument>();
        inner->name = name;
        inner->place = {0, 0, 0};
        inner->first_source = static_cast<std::uint32_t>(outermost_.sources.size());
        const std::string folder = folder_of(full);
        Inputs included;
        // By the name that it has in its own folder, by which what it includes would include it.
        Parsed parsed = parse_document(fs::path(full).filename().generic_string(), text, [&](std::string_view other) {
            Result<std::string> bytes = source_.load(beside(folder, std::string(other)));
            if (bytes) included.push_back({std::string(other), *bytes});
            return bytes;
        });
        inner->document = std::move(parsed.document);
        for (SourceFile& source : inner->document.sources) source.name = shown(beside(folder, source.name));
        inner->inputs = std::move(included);
        append(outermost_.sources, inner->document.sources);
        for (Diagnostic& problem : parsed.diagnostics) report(std::move(problem), *inner);
        EmbeddableDocument info{name, true, {}, {}, {}};
        // Nothing of it could be read: all that follows from that would only be said beside the reason.
        if (inner->has_failed && inner->document.statements.empty()) return {std::move(info), nullptr};
        load_named_files(*inner, folder);
        open_inside(*inner, folder, {});
        info.parameters = parameters_of(inner->document);
        info.fingerprint = fingerprint(*inner, text);
        return {std::move(info), std::move(inner)};
    }

    std::string shown(const std::string& full) const {
        return fs::path(full).is_absolute() ? full : shown_prefix_ + full;
    }

    static void append(Sources& to, const Sources& from) { to.insert(to.end(), from.begin(), from.end()); }
    static void append(Diagnostics& to, Diagnostics from) { filigree::append(to, std::move(from)); }

    // A document with `height` documents below it, one below the present depth.
    bool is_too_deep(OpenedDocument& outer, SourceSpan span, std::uint32_t height) {
        if (depth_ + height < max_embedding_depth) return false;
        report(error("embed.too-deep",
                     "documents lie inside documents more than " + std::to_string(max_embedding_depth) + " deep", span),
               outer);
        return true;
    }

    void load_named_files(OpenedDocument& opened, const std::string& folder) {
        for (const Name& file : named_files(opened.document)) {
            if (find_input(opened.inputs, file.text) != nullptr) continue;
            const Result<std::string> bytes = source_.load(beside(folder, file.text));
            if (bytes) opened.inputs.push_back({file.text, *bytes});
            for (Diagnostic reason : bytes.diagnostics()) {
                reason.span = file.span;
                report(std::move(reason), opened);
            }
        }
    }

    InputSource& source_;
    OpenedDocument& outermost_;
    std::string shown_prefix_;
    std::vector<std::string> on_the_way_;      // identities of the files around the place, outermost first
    std::map<std::string, OpenedFile> files_;  // by their full names; looked up only
    std::uint32_t depth_ = 0;
    std::uint32_t deepest_ = 0;  // that was reached inside the file that is being opened
};

OpenedDocument opened_from(std::string name, const std::string& shown_name, std::string text, InputSource& source,
                           const OpenOptions& options) {
    OpenedDocument opened;
    opened.name = std::move(name);
    Parsed parsed = parse_with(shown_name, text, source);
    const auto edit = [&](Result<std::string> edited) {
        if (!edited) {
            append(parsed.diagnostics, edited.diagnostics());
            return;
        }
        parsed = parse_with(shown_name, *edited, source);
    };
    for (const auto& [path, value] : options.settings) {
        if (has_errors(parsed.diagnostics)) break;
        edit(with_preset(parsed.document, path, value));
    }
    if (options.seed && !has_errors(parsed.diagnostics)) edit(with_seed(parsed.document, *options.seed));
    opened.document = std::move(parsed.document);
    opened.diagnostics = std::move(parsed.diagnostics);
    for (const Name& file : named_files(opened.document)) {
        const Result<std::string> bytes = source.load(file.text);
        for (Diagnostic reason : bytes.diagnostics()) {
            reason.span = file.span;
            opened.diagnostics.push_back(std::move(reason));
        }
    }
    opened.has_failed = has_errors(opened.diagnostics);
    opened.inputs = source.loaded();
    opened.sources = opened.document.sources;
    EmbeddedOpener(source, opened, shown_name).open_all();
    opened.inputs = source.loaded();
    return opened;
}

}  // namespace

Result<OpenedDocument> open_document(const fs::path& file, const OpenOptions& options) {
    Result<std::string> text = read_file(file);
    if (!text) return text.diagnostics();
    const bool is_pdf = text->starts_with("%PDF-");
    if (is_pdf || looks_like_svg(*text)) {
        const Result<std::optional<CarriedDocument>> found =
            is_pdf ? carried_document_of_pdf(*text, SourceSpan::no_file) : carried_document(*text, SourceSpan::no_file);
        if (!found) return found.diagnostics();
        if (!*found && is_pdf) {
            return error("document.not-carried", "'" + file.string() + "' is a PDF that carries no document");
        }
        if (!*found) {
            return error("document.not-carried", "'" + file.string() + "' is an SVG that carries no document", {},
                         {"an SVG can be grown from: start big_poly = file(\"" + file.filename().string() + "\")"});
        }
        const CarriedDocument& inside = **found;
        Inputs inputs;
        std::string choices = options.choices;
        for (const CarriedFile& input : inside.inputs) {
            if (input.name != carried_choices) {
                inputs.push_back({input.name, input.bytes});
            } else if (choices.empty()) {
                choices = input.bytes;
            }
        }
        InputSource source(std::move(inputs));
        OpenedDocument opened = opened_from(inside.document.name, file.string() + ":" + inside.document.name,
                                            inside.document.bytes, source, options);
        opened.files = {file};
        opened.carries_inputs = true;
        opened.choices = std::move(choices);
        return opened;
    }
    InputSource source(file.parent_path(), options.allowed_folders);
    OpenedDocument opened = opened_from(file.filename().string(), file.string(), std::move(*text), source, options);
    opened.allowed_folders = options.allowed_folders;
    opened.choices = options.choices;
    opened.folder = file.parent_path();
    opened.files = {file};
    opened.files.insert(opened.files.end(), source.files().begin(), source.files().end());
    return opened;
}

OpenedDocument open_text(std::string name, std::string text, Inputs inputs) {
    InputSource source(std::move(inputs));
    const std::string shown = name;
    OpenedDocument opened = opened_from(std::move(name), shown, std::move(text), source, {});
    opened.carries_inputs = true;
    return opened;
}

OpenedDocument reopened(const OpenedDocument& opened, std::string text) {
    InputSource source =
        opened.carries_inputs ? InputSource(opened.inputs) : InputSource(opened.folder, opened.allowed_folders);
    const std::string shown = opened.document.sources.at(0).name;
    OpenedDocument again = opened_from(opened.name, shown, std::move(text), source, {});
    again.allowed_folders = opened.allowed_folders;
    again.folder = opened.folder;
    again.carries_inputs = opened.carries_inputs;
    again.choices = opened.choices;
    again.files = {opened.files.begin(), opened.files.begin() + (opened.files.empty() ? 0 : 1)};
    again.files.insert(again.files.end(), source.files().begin(), source.files().end());
    return again;
}

Diagnostics at_first_source(Diagnostics diagnostics, const OpenedDocument& opened) {
    for (Diagnostic& diagnostic : diagnostics) {
        if (diagnostic.span.file != SourceSpan::no_file) diagnostic.span.file += opened.first_source;
    }
    return diagnostics;
}

CarriedDocument carried(const OpenedDocument& opened) {
    CarriedDocument all;
    all.document = {opened.name, opened.document.text()};
    for (const Input& input : opened.inputs) all.inputs.push_back({input.name, input.bytes});
    if (!opened.choices.empty()) all.inputs.push_back({carried_choices, opened.choices});
    return all;
}

}  // namespace filigree
