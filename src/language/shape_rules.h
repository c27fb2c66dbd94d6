// The rules of a shape grammar by name: which are written, drawn, or follow from another one, and which rule each
// `apply` means. What their expressions come to is for the engine; here they are checked, so that all that is wrong
// with names and kinds is told at once.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "language/document.h"
#include "language/evaluate.h"

namespace filigree {

// A rule that a file of `rules from` holds, with the place of the file's name.
struct DrawnRule {
    std::string name;
    SourceSpan file;
};

struct NamedShapeRule {
    enum class Kind { written, drawn, inverse, mirror };
    Kind kind = Kind::written;
    std::string name = {};
    const ShapeRule* statement = nullptr;  // null of a drawn one
    std::size_t base = 0;                  // of inverse and mirror: the rule that it follows from
    ExpressionPtr angle = {};              // of mirror; null if absent
};
struct MatchToApply {
    const MatchStatement* statement = nullptr;
    std::size_t rule = 0;
};
struct ShapeRules {
    std::vector<NamedShapeRule> rules;              // in the order of the text; drawn ones in `drawn`'s behind them
    std::vector<std::size_t> in_order;              // the same, each behind the one that it follows from
    std::vector<MatchToApply> applies;              // in the order of the text
    std::vector<const SettingStatement*> settings;  // each once (shape_settings.h)
};

// `document` must outlive the result. Reports: names of two rules, rules that follow from themselves, from no rule or
// by no way that exists, unknown rules of `apply`, settings said twice; and of the expressions in rules, starts,
// applies, `steps` and `tolerance` what is wrong whatever the values, and sides that are no shapes. `varying`: example
// values of what conditions (and, where an engine evaluates them anew, weights and priorities) know besides the
// globals.
Result<ShapeRules> read_shape_rules(const Document& document, const Scope& globals,
                                    std::span<const DrawnRule> drawn = {}, const Scope* varying = nullptr);

}  // namespace filigree
