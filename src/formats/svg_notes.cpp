#include "formats/svg_notes.h"

#include <algorithm>
#include <utility>

namespace filigree {
namespace {
constexpr std::size_t most_kinds = 50;
}

void SvgNotes::note(std::string code, std::string what, SourceSpan span, std::string hint) {
    const auto same = std::find_if(notes_.begin(), notes_.end(), [&](const Note& note) {
        return note.first.code == code && note.first.message == what;
    });
    if (same != notes_.end()) {
        ++same->count;
        return;
    }
    if (notes_.size() == most_kinds) return;
    Diagnostic first = warning(std::move(code), std::move(what), span);
    if (!hint.empty()) first.hints.push_back(std::move(hint));
    notes_.push_back({std::move(first), 1});
}

Diagnostics SvgNotes::warnings() const {
    Diagnostics all;
    for (const Note& note : notes_) {
        all.push_back(note.first);
        if (note.count > 1) all.back().message += " (" + std::to_string(note.count) + " times)";
    }
    return all;
}

}  // namespace filigree
