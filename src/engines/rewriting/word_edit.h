// One edit of a whole word, as a document says it between iterations: `once insert("T+", at: "a")`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/random.h"
#include "language/bind.h"
#include "language/expression.h"

namespace filigree::rewriting {

constexpr std::uint32_t every_iteration = UINT32_MAX;

// A text in which patterns repeat: b{3 a+}c. Where the number is no constant, as in {$k p} and {(expr) p}, it is
// evaluated when the text is put.
struct Pattern {
    struct Part {
        std::u32string letters;  // where nothing repeats
        ExpressionPtr count;     // null for letters
        std::vector<Part> repeated;
    };
    std::vector<Part> parts;
};

struct EditOperator;

struct WordEdit {
    // "aaa" -> "b". Reactions are read otherwise than texts: "l < a > r  b" -> "c".
    struct Pair {
        std::u32string from;
        Pattern to;
    };
    // An argument that is evaluated for every token or branch, and not once.
    struct TokenExpression {
        std::size_t parameter = 0;  // index into the description's parameters
        ExpressionPtr expression;
    };

    bool is_once = false;                             // behind the last iteration, whichever that is;
    std::uint32_t first = 1, last = every_iteration;  // else behind each of these
    const EditOperator* op = nullptr;
    BoundCall call;  // where a parameter is evaluated by token, some value of its type stands in its place
    std::vector<TokenExpression> by_token;
    std::vector<Pair> pairs;
    bool frees_braces = false;  // in its texts { and } are letters
    Key key;                    // of what it draws
    SourceSpan span;
};

}  // namespace filigree::rewriting
