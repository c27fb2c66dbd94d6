// Any bytes as an SVG and as path data: reading ends with a picture or with diagnostics whose places lie in the
// text, and what was read can be flattened and cleaned into polygons without a flaw.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/svg_read.h"
#include "plane/clean.h"
#include "plane/path.h"
#include "plane/verify.h"

namespace {

using namespace filigree;

void require(bool holds) {
    if (!holds) std::abort();
}

void require_none(const std::optional<std::string>& flaw) {
    if (!flaw) return;
    std::cerr << *flaw << "\n";
    std::abort();
}

void check_diagnostics(const Diagnostics& diagnostics, std::size_t size) {
    for (const Diagnostic& diagnostic : diagnostics) {
        require(!diagnostic.code.empty() && !diagnostic.message.empty());
        if (diagnostic.span.file == SourceSpan::no_file) continue;
        require(diagnostic.span.begin <= diagnostic.span.end && diagnostic.span.end <= size);
    }
}

void check_path(const Path& path, FillRule rule) {
    if (path.points.size() > 100) return;  // small ones find the same faults sooner
    const std::vector<Polyline> lines = flatten(path, 0.25);
    std::size_t points = 0;
    for (const Polyline& line : lines) {
        points += line.points.size();
        for (const Vec p : line.points) require(std::isfinite(p.x) && std::isfinite(p.y));
    }
    if (points > 2000) return;
    for (const Polyline& line : lines) {
        for (const Vec p : line.points) {
            if (!is_on_plane(p)) return;
        }
    }
    const Polygons cleaned = clean(lines, rule);
    require(std::isfinite(area(cleaned)) && area(cleaned) >= 0);
    for (std::size_t i = 0; i < cleaned.size(); ++i) require_none(find_flaw(cleaned[i]));
    require_none(find_overlap(cleaned));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);

    const Result<SvgPicture> picture = read_svg(text, 0, SvgPurpose::drawing);
    check_diagnostics(picture.diagnostics(), size);
    require(static_cast<bool>(picture) || has_errors(picture.diagnostics()));
    if (picture) {
        require(picture->size.x > 0 && picture->size.y > 0);
        for (const SvgLabel& label : picture->labels) require(!label.text.empty() && is_on_plane(label.place));
        std::size_t checked = 0;
        for (const SvgShape& shape : picture->shapes) {
            if (++checked > 20) break;
            check_path(shape.path, shape.fill_rule);
        }
    }

    const Result<std::optional<CarriedDocument>> carried = carried_document(text);
    check_diagnostics(carried.diagnostics(), size);

    const Result<Path> path = parse_path_data(text);
    check_diagnostics(path.diagnostics(), size);
    if (path) {
        const Result<Path> again = parse_path_data(to_path_data(*path));
        require(again && *again == *path);
        bool is_near = true;
        for (const Vec p : path->points) is_near = is_near && std::fabs(p.x) <= 0x1p28 && std::fabs(p.y) <= 0x1p28;
        if (is_near) check_path(*path, FillRule::nonzero);
    }
    return 0;
}
