// Texts of letters as documents write them, with patterns that repeat: {3b+c}bbb is b+cb+cb+cbbb ("{,}" of Roncoroni
// and Crousse). Repeats nest; a missing number is 1, and with 0 or less nothing is put. Braces around a number alone
// are for the '=' behind them: a{3}= is a===.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "base/result.h"
#include "engines/rewriting/grammar.h"
#include "language/evaluate.h"

namespace filigree::rewriting {

// `at` is where the text stands in its document; `free_braces`: { and } are letters like all others. A number may be
// given in digits, as {$NAME p} with a blank behind the name, or as {(EXPRESSION) p}.
Result<Pattern> read_pattern(std::string_view text, SourceSpan at, bool free_braces = false);

// Whether no part of it must be evaluated.
bool is_constant(const Pattern& pattern);
// How many letters such a one has; none where some part must be evaluated, infinity where they are too many to count.
std::optional<double> letter_count(const Pattern& pattern);

// The letters with all repeats put; at most `most` of them, which is an error of Fault::limit without a place.
using CountOf = std::function<Result<double>(const ExpressionPtr& count)>;
Result<std::u32string> expanded(const Pattern& pattern, std::uint64_t most, const CountOf& count_of);

// The same with numbers that may use the names.
Result<std::u32string> put_text(const Pattern& text, const Document* document, const Scope& names, std::uint64_t most);

}  // namespace filigree::rewriting
