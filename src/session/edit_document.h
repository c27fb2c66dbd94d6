// One edit of a document as data: what the commands set, keep, reroll and apply do to its text, and a studio's buttons.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "session/open.h"

namespace filigree {

struct DocumentEdit {
    enum class Kind { set, set_default, unset, keep, unkeep, reroll, apply };
    Kind kind = Kind::set;
    std::string path;                  // all but `apply`
    std::string value;                 // set: the value; apply: the call, "[NAME =] outline(5)"
    std::vector<std::string> targets;  // apply: paths
    std::string outputs;               // apply: "in, ring"
    std::uint32_t times = 1;           // reroll: how many times further
};
std::string to_text(const DocumentEdit& edit);  // "keep big_poly/outline"

// The document with one edit more, whole and checked; errors where the new document is wrong.
Result<OpenedDocument> edited(const OpenedDocument& opened, const DocumentEdit& edit);

// The new text alone: comments, order and all else of the old one stay. Errors as in language/edit_presets.h.
Result<std::string> edited_text(const Document& document, const DocumentEdit& edit);

}  // namespace filigree
