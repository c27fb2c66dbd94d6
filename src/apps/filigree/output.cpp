#include "apps/filigree/output.h"

#include <algorithm>

#include "formats/pdf_write.h"
#include "formats/png_write.h"

namespace filigree {
namespace fs = std::filesystem;
namespace {

Diagnostic usage_error(std::string code, std::string message, std::vector<std::string> hints = {}) {
    Diagnostic wrong = fault(Fault::usage, std::move(code), std::move(message));
    wrong.hints = std::move(hints);
    return wrong;
}

std::string ending_of(const fs::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

// Whether two paths name one file, existing or not.
bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code failed;
    if (fs::equivalent(a, b, failed) && !failed) return true;
    return fs::weakly_canonical(a, failed) == fs::weakly_canonical(b, failed) && !failed;
}

}  // namespace

bool is_known_format(const fs::path& output) {
    const std::string ending = ending_of(output);
    return ending == ".svg" || ending == ".pdf" || ending == ".png";
}

bool is_mesh_format(const fs::path& output) { return ending_of(output) == ".obj"; }
fs::path materials_beside(const fs::path& output) { return fs::path(output).replace_extension(".mtl"); }

Diagnostics unknown_formats(const std::vector<fs::path>& outputs, bool takes_meshes) {
    Diagnostics problems;
    for (const fs::path& output : outputs) {
        if (is_known_format(output) || (takes_meshes && is_mesh_format(output))) continue;
        problems.push_back(usage_error(
            "render.unknown-format", "'" + output.string() + "' has an ending that is no known format",
            {takes_meshes ? "known are .svg, .pdf, .png and, of words, .obj" : "known are .svg, .pdf and .png"}));
    }
    return problems;
}

Diagnostics not_a_document(const fs::path& output) {
    if (!is_known_format(output)) return {};
    return {usage_error("edit.not-a-drawing",
                        "an edited document is text, so it is not written to '" + output.string() + "'",
                        {"write a .fil file, and render that"})};
}

Diagnostics same_outputs(const std::vector<fs::path>& targets) {
    Diagnostics problems;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (!same_file(targets[i], targets[k])) continue;
            problems.push_back(
                usage_error("render.same-output", "'" + targets[i].string() + "' is given twice as an output"));
        }
    }
    return problems;
}

Diagnostics overwrites(const std::vector<fs::path>& targets, const std::vector<fs::path>& read) {
    Diagnostics problems;
    for (const fs::path& target : targets) {
        const bool is_read =
            std::any_of(read.begin(), read.end(), [&](const fs::path& file) { return same_file(target, file); });
        if (!is_read) continue;
        problems.push_back(usage_error("render.overwrites-input",
                                       "'" + target.string() + "' is read by the document, so it is not overwritten",
                                       {"choose another name for the output"}));
    }
    return problems;
}

Result<std::string> encoded(const Drawing& drawing, const fs::path& output, const EncodeOptions& options) {
    if (ending_of(output) == ".png") return to_png(drawing, {options.dpi / 96, options.job});
    if (ending_of(output) == ".pdf") {
        PdfOptions pdf;
        pdf.carried = options.carried;
        pdf.title = options.title;
        return to_pdf(drawing, pdf);
    }
    SvgOptions svg;
    svg.lean = options.lean;
    svg.carried = options.carried;
    svg.title = options.title;
    return to_svg(drawing, svg);
}

}  // namespace filigree
