// What is known at a place, seen from another document: the names of the place's own document are exchanged for those
// of the document that says a preset.
#pragma once

#include <list>

#include "language/evaluate.h"

namespace filigree {

// A chain of scopes in which one, the names of a document, is replaced by those of another document.
class ReplacedScope {
public:
    ReplacedScope(const Scope* scope, const Scope* from, const Scope* to) {
        if (from == to || !contains(scope, from)) {
            first_ = scope;
            return;
        }
        Scope* inner = nullptr;
        for (; scope != from; scope = scope->outer) {
            Scope& copy = copies_.emplace_back(Scope{nullptr, scope->names});
            (inner != nullptr ? inner->outer : first_) = &copy;
            inner = &copy;
        }
        (inner != nullptr ? inner->outer : first_) = to;
    }
    const Scope* get() const { return first_; }

    static const Scope* outermost(const Scope* scope) {
        while (scope != nullptr && scope->outer != nullptr) scope = scope->outer;
        return scope;
    }

private:
    std::list<Scope> copies_;  // they point at each other, so they must stay where they are
    const Scope* first_ = nullptr;

    static bool contains(const Scope* scope, const Scope* wanted) {
        while (scope != nullptr && scope != wanted) scope = scope->outer;
        return scope == wanted;
    }
};

}  // namespace filigree
