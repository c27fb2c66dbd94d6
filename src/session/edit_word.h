// One edit of a derived word, as a person asks for it: what `filigree edit` does.
#pragma once

#include <optional>
#include <string>

#include "engines/rewriting/edit_step.h"
#include "session/run.h"

namespace filigree {

struct EditedWord {
    std::optional<rewriting::Derivation> derivation;  // none where an error stands in `diagnostics`
    rewriting::EditReport report;
    Diagnostics diagnostics;
    Sources sources;  // those of the document, and the call
};

// `call`: as behind `once` in a document, such as insert("T+", at: "a"); it edits as that statement would, behind all
// that the document itself says. `other`: the word of another document that the call names.
EditedWord edit_word(const OpenedDocument& opened, const CheckedDocument& checked, const std::string& call,
                     std::optional<std::uint64_t> steps, const rewriting::OtherDocument& other, Executor& executor,
                     const Job& job);

// The word with what was done.
std::string edited_word_json(const OpenedDocument& opened, const CheckedDocument& checked, const std::string& call,
                             const EditedWord& edited);

// The document with the word for its axiom: without iterations and edits of words, all else as it was. It derives the
// same word; an error where a text cannot say it.
Result<std::string> document_of_word(const OpenedDocument& opened, const rewriting::Derivation& derivation);

// A text as a document writes it.
std::string quoted_text(std::string_view text);

}  // namespace filigree
