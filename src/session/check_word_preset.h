// What is wrong with a preset of what symbols of words choose, before anything is derived.
#pragma once

#include <span>

#include "base/diagnostic.h"
#include "language/document.h"
#include "language/evaluate.h"
#include "session/word_paths.h"

namespace filigree {

// `letters`: those at which its path may end, at least one. A value must be possible at one of them.
Diagnostics check_word_preset(const PresetStatement& preset, std::span<const WordPathPlace> letters,
                              const Document& document, const Scope& globals);

}  // namespace filigree
