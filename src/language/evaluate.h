// Evaluating expressions: values, units, functions and choices (docs/language.md, "Values").
//
// A choice (a range, one_of, normal) draws from addressed randomness: its site is the key of the step or
// shape and the name of the argument; the k-th choice of one expression is drawn under `name~k` (k from 1,
// the first under the bare name). k counts the places in the text, so it does not depend on which branch of a
// condition is taken. Evaluating the same expression at the same site gives the same value. With a ChoiceMaking
// (choices.h) choices are also recorded, replayed, preset or put in the middle of their domains.
//
// Guarantee: every value is finite; every error has the span of what is wrong; nothing throws, whatever the
// tree (nesting deeper than max_evaluation_depth is an error).
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.h"
#include "base/result.h"
#include "language/document.h"
#include "language/quantity.h"
#include "language/value.h"

namespace filigree {

// What names mean. Looked up from the innermost scope outwards; `page.width` is the name "page.width".
struct Scope {
    const Scope* outer = nullptr;
    std::map<std::string, Value, std::less<>> names = {};

    const Value* find(std::string_view name) const;
};

struct ChoiceMaking;
struct OperatorDescription;

struct ChoiceAddress {
    Key key = {};
    std::string name = {};
};
// Where choices are drawn.
struct ChoiceSite {
    std::uint64_t seed = 0;
    Key key = {};
    std::string name = {};
    const ChoiceAddress* recorded_at = nullptr;  // where they are recorded and looked up, if that is elsewhere
};

struct Evaluation {
    const Document* document = nullptr;  // for the units of bare lengths; px where null
    const Scope* scope = nullptr;
    ChoiceSite site = {};
    // Set where the expression stands inside or may contain each(...): `each` evaluates with this scope (looked
    // up before `scope`) and draws at this key.
    const Scope* shape_scope = nullptr;
    std::optional<Key> shape_key = {};
    bool by_shape = false;  // the whole expression stands inside each(...), as in styles
    // Words that mean themselves here, before any parameter of that name (enumerations). They stand where the
    // result may come from, not inside arithmetic and conditions; likewise the calls. "*": any that names nothing.
    std::vector<std::string_view> words = {};
    // Names of calls that are no functions and are kept as SymbolicCall; "*": any, with bare words as arguments.
    std::vector<std::string_view> calls = {};
    bool words_in_calls = false;  // whether such calls take bare words as arguments in any case
    // Describes such calls, so that ranges are whole where their parameters are; null: nothing is known of them.
    const std::vector<OperatorDescription>* forms = nullptr;
    // Shapes, transforms and operations over them may stand here; the calls and words are those of shape_forms.h.
    bool shapes = false;
    bool whole = false;                     // ranges are drawn as whole numbers, both ends included
    const ChoiceMaking* choices = nullptr;  // null: drawn at random and not recorded
};

constexpr int max_evaluation_depth = 500;         // of expressions, and of shapes that an expression takes over
constexpr std::size_t max_shape_parts = 100'000;  // that one expression takes over from names

Result<Value> evaluate(const Expression& expression, const Evaluation& at);

// Whether the expression contains each(...), so that it must be evaluated for every shape.
bool varies_by_shape(const Expression& expression);
// Whether it contains a choice.
bool has_choice(const Expression& expression);

// Names of the functions of the language with one line of help each, for `describe` and the reference.
struct FunctionDescription {
    std::string_view signature;  // "max(a, b, ...)"
    std::string_view help;
};
std::vector<FunctionDescription> function_descriptions();

// Conversions that binding and settings share; the error names what was found and what was expected.
Result<double> as_length(const Value& value, const Document& document);  // px
Result<double> as_angle(const Value& value);                             // degrees
Result<double> as_number(const Value& value);                            // a bare number
Result<bool> as_flag(const Value& value);                                // true, false, 0, 1

}  // namespace filigree
