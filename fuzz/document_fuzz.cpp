// Any bytes as a document that is checked, derived and drawn, in small: no crash, no hang, no broken promise.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

#include "base/executor.h"
#include "formats/svg_write.h"
#include "session/list_choices.h"
#include "session/run.h"

namespace {

using namespace filigree;

void require(bool holds, std::string_view promise) {
    if (holds) return;
    std::cerr << "broken promise: " << promise << "\n";
    std::abort();
}

constexpr const char* knot = "grammar tangle\nparam gap = 5 in 3..9\nstart a = host()\noutline(gap) : a -> b, <>\n";

// Large lengths and fine patterns take long by themselves, and so do shapes of many elements: what they do is for other
// tests.
bool is_small(const CheckedDocument& checked) {
    if (checked.design) {
        const auto is_short = [](const curves::Shape& shape) { return shape.elements.size() <= 40; };
        const auto& rules = checked.design->rules;
        return is_short(checked.design->start) && rules.size() <= 10 &&
               std::all_of(rules.begin(), rules.end(),
                           [&](const shape::Rule& rule) { return is_short(rule.left) && is_short(rule.right); });
    }
    if (!checked.start || area(checked.start->polygons) > 1e6) return false;
    return checked.settings->resolution >= 0.01;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 4000) return 0;
    std::string text(reinterpret_cast<const char*>(data), size);
    OpenedDocument opened = open_text("fuzz.fil", text, {{"knot.fil", knot}});
    CheckedDocument checked = check_document(opened);
    require(!to_text(checked.diagnostics, opened.sources).empty() || checked.diagnostics.empty(),
            "diagnostics are printed");
    if (has_errors(checked.diagnostics) || !is_small(checked)) return 0;
    checked.settings->limits.elements = 2000;
    checked.settings->limits.depth = 20;
    if (checked.design) {
        checked.settings->limits.elements = 200;
        for (shape::Rule& rule : checked.design->rules) rule.options.limit = 200;
    }
    SerialExecutor serial;
    RunOptions options;
    options.steps = checked.design ? 6 : 40;
    options.verify = true;
    const Result<Run> run = run_document(opened, checked, options, serial, {});
    if (!run) {
        require(has_errors(run.diagnostics()), "a run that fails says why");
        for (const Diagnostic& reason : run.diagnostics()) {
            require(reason.fault != Fault::internal, "nothing of our own breaks");
        }
        return 0;
    }
    require(run->broken.empty(), run->broken.empty() ? "" : run->broken.front());
    options.previous = &run->tangle;
    const Result<Run> again = run_document(opened, checked, options, serial, {});
    require(again && to_svg(again->drawing, {}) == to_svg(run->drawing, {}), "deriving again gives the same");
    std::string listed;
    list_choices(opened, checked, *run, [&](std::string_view piece) { listed += piece; });
    const Result<Replay> replay = read_choices(listed);
    require(static_cast<bool>(replay), "what is listed is read");
    return 0;
}
