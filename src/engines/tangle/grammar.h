// A group grammar as plain data: R = O({p}) : t -> [<t0>, ..., <tk>] (gTangle, section 3).
//
// Beside the rules as they are written it holds those that the document's own operators (macros) expand to: each use
// of a macro has rules of its own over local tags, so a macro is a step that renames its shapes into the first local
// tag, and a port is a local tag that stands for one outside. The rules of `apply` statements match no tag.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/result.h"
#include "derivation/embedding.h"
#include "engines/tangle/operator.h"
#include "language/bind.h"
#include "language/settings.h"

namespace filigree::tangle {

// The value of a parameter of a macro or an embedded document that is not given: a word that nothing else is.
constexpr std::string_view not_given = "not_given";

struct Output {
    std::uint32_t tag = 0;     // index into Grammar::tags
    bool hidden = false;       // `_`
    std::uint32_t leaves = 0;  // how many macros the shapes come out of by this output
};
enum class RuleKind : std::uint8_t { operation, macro, embed };
struct Rule {
    std::string segment;  // as it stands in paths: its label, or "outline", "outline#2", ...
    Key key;              // of the segment
    RuleKind kind = RuleKind::operation;
    const Operator* op = nullptr;
    BoundCall call;
    std::uint32_t tag = none;     // what it matches; none: it is applied by hand
    ExpressionPtr condition;      // `when`; null if absent
    ExpressionPtr weight;         // null if absent: 1
    std::vector<Output> outputs;  // one a port of the operator; of a macro: its first local tag
    std::string name;             // of the `apply` statement, that paths may begin with; else empty
    SourceSpan span;
    std::string reads;  // all that evaluating it could read, but for the step: its text, and the names' values
};
struct Grammar {
    std::vector<std::string> tags;  // in order of appearance; "" is the unnamed terminal; local ones may repeat a name
    std::vector<Rule> rules;        // in order of the document; those of macros behind them, then applied ones
    std::vector<std::vector<std::uint32_t>> rules_of_tag;  // for each tag, indices of rules
    std::vector<std::uint32_t> applied;                    // rules of the `apply` statements, in their order
    std::vector<std::shared_ptr<const Operator>> defined;  // by the document: macros and embeddings
    std::vector<std::string> document_rules;               // segments of the document's own rules, in order

    // Index of a tag, or none. Of tags with one name the first, which is no local one.
    std::uint32_t find_tag(std::string_view name) const;
};

// The grammar of a document, and everything that is wrong with its rules. The tags of the starts get their
// index too, whether a rule matches them or not. `embeddable`: what `embed` may name.
Result<Grammar> read_grammar(const Settings& settings, const Document& document,
                             std::span<const std::string> start_tags, const EmbeddableDocuments& embeddable = {});

}  // namespace filigree::tangle
