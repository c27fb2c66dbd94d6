// Edits of a derived word: post-production, and editing between iterations (Roncoroni and Crousse, "Editing").
//
// An edit sees the word's text. What it leaves of the word stays what it was, with age, lineage and origin, in the
// system that rewrites it. What it puts belongs to the document's own system, is one iteration old, and descends from
// the symbol that it comes to stand behind. Nothing else of the derivation changes.
//
// Guarantee: the result hangs on the derivation, the edit and the seed alone; an error leaves all as it was.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engines/rewriting/derive.h"
#include "engines/rewriting/edit_operators.h"

namespace filigree::rewriting {

// The word of another document, by the name that the edit gives: the session knows documents.
using OtherDocument = std::function<Result<std::u32string>(const std::string& name)>;

struct EditReport {
    std::uint64_t before = 0, after = 0;  // symbols, '=' among them
    std::uint64_t kept = 0;               // of those before; all others of those after are new
    std::uint64_t replaced = 0;           // chunks
    std::uint32_t passes = 0;             // over the word, in search of them
    std::vector<std::string> changes;     // what was cleaned, in words
    std::u32string other;                 // of two words: the one that does not go on, where it is changed as well
};

Result<EditReport> apply_edit(Derivation& derivation, const WordEdit& edit, const Grammar& grammar,
                              const DeriveOptions& options, const OtherDocument& other, const Job& job);

// All edits that the grammar says behind the iteration that the derivation has come to, or, once it has come to its
// end, at the end: in the order of the document. Warnings, or the error that ended it.
enum class EditTime { iteration, end };
Diagnostics apply_edits(Derivation& derivation, const Grammar& grammar, EditTime time, const DeriveOptions& options,
                        const OtherDocument& other, const Job& job);

// Whether an edit asks for ages, so that the derivation must count them.
bool asks_for_ages(const WordEdit& edit);

// --- what reading an edit needs as well

// What expressions about a whole word know: registers, and t, the iteration.
Scope names_of_word(const std::vector<Register>& registers, std::uint32_t iteration, const Scope* globals);
std::optional<std::uint32_t> system_of_letter(const Grammar& grammar, std::string_view letter);

}  // namespace filigree::rewriting
