#include "engines/shape/doubts.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/number_text.h"
#include "engines/shape/paths.h"

namespace filigree::shape {
namespace {

std::string_view name_of(curves::Doubt doubt) {
    switch (doubt) {
        case curves::Doubt::descriptor:
            return "curves that lie together but are not one, off by";
        case curves::Doubt::gap:
            return "a gap in a curve of";
        case curves::Doubt::rest:
            return "a short rest of a curve of";
        case curves::Doubt::overlap:
            return "curves that overlap by";
        case curves::Doubt::flatness:
            return "a nearly straight curve, bent by";
        case curves::Doubt::place:
            return "equal labels apart by";
    }
    return "";
}

}  // namespace

std::optional<Diagnostic> warning_of(const curves::Ambiguities& doubts, const Document& document, SourceSpan span) {
    if (doubts.found.empty()) return std::nullopt;
    const auto nearest = std::min_element(doubts.found.begin(), doubts.found.end(),
                                          [](const auto& a, const auto& b) { return a.tolerances < b.tolerances; });
    const std::size_t count = doubts.found.size();
    std::string text = count == 1 ? "a near decision: " : std::to_string(count) + " near decisions, the nearest: ";
    text += std::string(name_of(nearest->what)) + " " + to_text(std::round(nearest->tolerances * 10) / 10) +
            " tolerances at " + place_text(nearest->where, document);
    return warning("shape.near-decision", text, span, {"another 'tolerance' may decide otherwise"});
}

}  // namespace filigree::shape
