// What a reading of an SVG leaves out, gathered: one warning a kind, however often it occurs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/diagnostic.h"

namespace filigree {

class SvgNotes {
public:
    // `what` is told once, with the place where it was first met and how often it was.
    void note(std::string code, std::string what, SourceSpan span, std::string hint = {});
    Diagnostics warnings() const;  // in the order of first places met

private:
    struct Note {
        Diagnostic first;
        std::size_t count = 0;
    };
    std::vector<Note> notes_;
};

}  // namespace filigree
