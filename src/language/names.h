// What names and calls mean at a place of an expression, and what to say where they mean nothing.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "language/evaluate.h"
#include "language/walk.h"

namespace filigree {

// Names that the steps of group grammars know in rules, that shapes know inside each(...), and that styles know.
// width, height, x, y and z are lengths, area is an area, the others are bare numbers.
std::span<const std::string_view> step_names();
std::span<const std::string_view> shape_names();
std::span<const std::string_view> style_names();
// What styles know of a symbol of a word; group is how deep it lies in branches, from 1.
std::span<const std::string_view> word_style_names();

// The value of a name; null where it has none. Inside each(...) the shape's names come first.
const Value* find_value(const Evaluation& at, std::string_view name, bool by_shape);

// Whether the word stands for itself here.
bool is_word(const Evaluation& at, std::string_view name, Place place);

enum class CallMeaning { special, function, list, symbolic, none };
CallMeaning meaning_of(const CallExpression& call, const Evaluation& at, Place place);

// Whether the list of arguments has a wrong form: too many, too few, named where that is not allowed.
std::optional<Diagnostic> wrong_arguments(const CallExpression& call, CallMeaning meaning, SourceSpan span);

Diagnostic unknown_name(std::string_view name, SourceSpan span, const Evaluation& at, Place place);
Diagnostic unknown_call(const CallExpression& call, SourceSpan span, const Evaluation& at, Place place);

Diagnostic each_outside(SourceSpan span);

bool any_call_allowed(const Evaluation& at);
bool bare_words_in_calls(const Evaluation& at);

// Where the whole expression stands.
Place top_place(const Evaluation& at);

// A few words quoted for a message: 'line', 'wave' or 'zigzag'.
std::string quoted_alternatives(std::span<const std::string_view> words);

}  // namespace filigree
