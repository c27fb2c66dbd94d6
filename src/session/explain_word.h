// Why a symbol of a derived word is what it is, and which rules were tried for it: what `derive --explain` prints.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "session/run.h"

namespace filigree {

// A rule or a mask as the document says it, without what follows its first line.
struct SaidRule {
    std::string file;
    std::uint32_t line = 1;
    std::string text;
};
SaidRule said_at(const OpenedDocument& opened, SourceSpan span);

// Of the symbol at a position, from 0 and without '=', of the word after `steps` iterations; without a number, after as
// many as the document says. An error where the document edits that word, or one before it.
Result<std::string> explain_word(const OpenedDocument& opened, const CheckedDocument& checked,
                                 std::optional<std::uint64_t> steps, std::uint64_t position, bool as_json,
                                 const Job& job);

}  // namespace filigree
