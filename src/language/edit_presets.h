// Edits of what a document says of the places of its derivation: set, default, keep, reroll and apply.
//
// As in edit.h everything else of the text stays as it is, statements of included files and inside `system` blocks
// too, and for a document that parses without errors the new text parses without errors. What is added stands in a
// line of its own at the end. Paths are compared by what they say (same_path); behind `set` and `default`, `gap`
// and `let/gap` are one. Errors in what is given have the codes of parsing and spans without a file, which
// count in the path, value, call, target or tags that was given.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "language/document.h"

namespace filigree {

// `set PATH = VALUE`: in place of the value of the last `set` of this path without `when`; else in place of the value
// of the `param` that the path names (with_parameter); else at the end.
Result<std::string> with_preset(const Document& document, std::string_view path, std::string_view value);
// The same for `default`, but for parameters.
Result<std::string> with_default(const Document& document, std::string_view path, std::string_view value);
// Without the last `set` of this path that has no `when`; where there is none, the error edit.no-such-preset.
Result<std::string> without_preset(const Document& document, std::string_view path);

// `keep PATH`, unless it is there.
Result<std::string> with_keep(const Document& document, std::string_view path);
// Without every `keep` of this path; where there is none, the error edit.no-such-keep.
Result<std::string> without_keep(const Document& document, std::string_view path);

// `reroll PATH x N`: the last one's N is raised by `more`, unless a `keep` stands behind it; else one is added. Beyond
// max_rerolls (parse.h) the error edit.too-many-rerolls.
Result<std::string> with_reroll(const Document& document, std::string_view path, std::uint32_t more = 1);

// `apply CALL to TARGET, TARGET -> OUTPUTS`. `call`: "[NAME =] outline(5)"; `outputs`: "in, ring", or empty.
Result<std::string> with_apply(const Document& document, std::string_view call, const std::vector<std::string>& targets,
                               std::string_view outputs);

}  // namespace filigree
