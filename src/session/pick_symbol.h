// What made a symbol of a drawn word at a point: the symbol, and those from which it descends.
#pragma once

#include "session/pick.h"

namespace filigree {

// Where an embedded word stands; nothing of it for a document on its own.
struct WordPlace {
    Key root;
    std::string prefix;  // of paths
};

// The symbol that is drawn on top there, in the coordinates of the document's own drawing, px; none where there is
// nothing. Lines are met a px beside them, too.
std::optional<Picked> pick_symbol(const OpenedDocument& opened, const CheckedDocument& checked, const WordRun& word,
                                  const WordPlace& place, Vec at);

}  // namespace filigree
