#include "session/open.h"

#include <algorithm>

#include "derivation/plane_start.h"
#include "formats/files.h"
#include "formats/svg_read.h"
#include "language/edit.h"
#include "language/parse.h"

namespace filigree {
namespace fs = std::filesystem;
namespace {

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

    const Inputs& loaded() const { return loaded_; }
    const std::vector<fs::path>& files() const { return files_; }

private:
    Result<std::string> find(std::string_view name) const {
        const Input* input = find_input(given_, name);
        if (input != nullptr) return input->bytes;
        return error("input.missing", "the file '" + std::string(name) + "' is not carried with the document");
    }

    Result<std::string> read(const std::string& name) {
        std::error_code failed;
        const fs::path path = fs::path(name).is_absolute() ? fs::path(name) : folder_ / name;
        const fs::path real = fs::weakly_canonical(path, failed);
        const bool inside = !failed && std::any_of(roots_.begin(), roots_.end(), [&](const fs::path& root) {
            std::error_code unknown;
            const fs::path top = fs::canonical(root, unknown);
            if (unknown) return false;
            const fs::path relative = real.lexically_relative(top);
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
    for (const auto& [parameter, value] : options.settings) {
        if (has_errors(parsed.diagnostics)) break;
        edit(with_parameter(parsed.document, parameter, value));
    }
    if (options.seed && !has_errors(parsed.diagnostics)) edit(with_seed(parsed.document, *options.seed));
    opened.document = std::move(parsed.document);
    opened.diagnostics = std::move(parsed.diagnostics);
    for (const Name& file : start_files(opened.document)) {
        const Result<std::string> bytes = source.load(file.text);
        for (Diagnostic reason : bytes.diagnostics()) {
            reason.span = file.span;
            opened.diagnostics.push_back(std::move(reason));
        }
    }
    opened.inputs = source.loaded();
    return opened;
}

bool looks_like_svg(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string_view::npos && text[first] == '<';
}

}  // namespace

Result<OpenedDocument> open_document(const fs::path& file, const OpenOptions& options) {
    Result<std::string> text = read_file(file);
    if (!text) return text.diagnostics();
    if (looks_like_svg(*text)) {
        const Result<std::optional<CarriedDocument>> found = carried_document(*text, SourceSpan::no_file);
        if (!found) return found.diagnostics();
        if (!*found) {
            return error("document.not-carried", "'" + file.string() + "' is an SVG that carries no document", {},
                         {"an SVG can be grown from: start big_poly = file(\"" + file.filename().string() + "\")"});
        }
        const CarriedDocument& inside = **found;
        Inputs inputs;
        for (const CarriedFile& input : inside.inputs) inputs.push_back({input.name, input.bytes});
        InputSource source(std::move(inputs));
        OpenedDocument opened = opened_from(inside.document.name, file.string() + ":" + inside.document.name,
                                            inside.document.bytes, source, options);
        opened.files = {file};
        return opened;
    }
    InputSource source(file.parent_path(), options.allowed_folders);
    OpenedDocument opened = opened_from(file.filename().string(), file.string(), std::move(*text), source, options);
    opened.files = {file};
    opened.files.insert(opened.files.end(), source.files().begin(), source.files().end());
    return opened;
}

OpenedDocument open_text(std::string name, std::string text, Inputs inputs) {
    InputSource source(std::move(inputs));
    const std::string shown = name;
    return opened_from(std::move(name), shown, std::move(text), source, {});
}

CarriedDocument carried(const OpenedDocument& opened) {
    CarriedDocument all;
    all.document = {opened.name, opened.document.text()};
    for (const Input& input : opened.inputs) all.inputs.push_back({input.name, input.bytes});
    return all;
}

}  // namespace filigree
