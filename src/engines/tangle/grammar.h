// A group grammar as plain data: R = O({p}) : t -> [<t0>, ..., <tk>] (gTangle, section 3).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/result.h"
#include "engines/tangle/operator.h"
#include "language/bind.h"
#include "language/settings.h"

namespace filigree::tangle {

struct Output {
    std::uint32_t tag = 0;  // index into Grammar::tags
    bool hidden = false;    // `_`
};
struct Rule {
    std::string segment;  // as it stands in paths: its label, or "outline", "outline#2", ...
    Key key;              // of the segment
    const Operator* op = nullptr;
    BoundCall call;
    std::uint32_t tag = 0;        // what it matches
    ExpressionPtr condition;      // `when`; null if absent
    ExpressionPtr weight;         // null if absent: 1
    std::vector<Output> outputs;  // one a port of the operator
    SourceSpan span;
};
struct Grammar {
    std::vector<std::string> tags;                         // in order of appearance; "" is the unnamed terminal
    std::vector<Rule> rules;                               // in order of the document
    std::vector<std::vector<std::uint32_t>> rules_of_tag;  // for each tag, indices of rules

    // Index of a tag, or none.
    std::uint32_t find_tag(std::string_view name) const;
};

// The grammar of a document, and everything that is wrong with its rules. The tags of the starts get their
// index too, whether a rule matches them or not.
Result<Grammar> read_grammar(const Settings& settings, const Document& document,
                             std::span<const std::string> start_tags);

}  // namespace filigree::tangle
