#include "derivation/page_canvas.h"

#include <string>

namespace filigree {

Canvas page_canvas(const Settings& settings, const Document& document, const Box& box, std::string_view what,
                   Diagnostics& warnings) {
    const Vec low = to_px(box.min), high = to_px(box.max);
    const Vec extent = high - low;
    Canvas canvas;
    const Unit unit = unit_of(document);
    canvas.in_mm = settings.page.in_mm || unit == Unit::mm || unit == Unit::cm || unit == Unit::m;
    if (settings.page.kind == PageStatement::Kind::fit) {
        fit_canvas(canvas, box, settings.page.margin);
        return canvas;
    }
    canvas.size = {settings.page.width, settings.page.height};
    canvas.origin = 0.5 * (low + high) - 0.5 * canvas.size;
    const double margin = settings.page.margin.value_or(0);
    if (settings.page.kind == PageStatement::Kind::tile) return canvas;  // what crosses its edges comes in again
    if (extent.x > canvas.size.x - 2 * margin + 1e-6 || extent.y > canvas.size.y - 2 * margin + 1e-6) {
        warnings.push_back(warning("page.too-small",
                                   "the " + std::string(what) + " are larger than the page within its margins", {},
                                   {"a larger page, smaller " + std::string(what) + ", or `page fit`"}));
    }
    return canvas;
}

}  // namespace filigree
