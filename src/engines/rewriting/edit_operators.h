// The edits of words by name, as documents and commands call them: what they take, described as data, and what makes
// the library (word_edits.h) do it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "engines/rewriting/edit_arguments.h"
#include "engines/rewriting/word_edits.h"
#include "language/description.h"

namespace filigree::rewriting {

struct EditInput {
    std::u32string_view word;
    std::span<const std::uint32_t> ages;     // as attributes_of takes them
    std::u32string_view other;               // of an edit of two words
    std::span<const ChunkPair> pairs;        // as they are written, repeats put
    std::span<const ChunkPair> productions;  // of the grammar
    EditArguments& arguments;
    TokenBits bits;  // chance, by token and what for
    std::uint64_t most_symbols = most_edited_symbols;
};

struct EditOutput {
    std::u32string word;
    EditTrace trace;
    std::u32string other = {};  // of two words: the second behind the edit, where it is changed as well
    std::uint64_t replaced = 0;
    std::uint32_t passes = 0;
    std::vector<std::string> changes = {};  // in words
};

struct EditOperator {
    // A parameter that is evaluated for every token or branch, and the names that it knows.
    struct TokenParameter {
        std::string_view name;
        std::span<const std::string_view> facts;
    };

    OperatorDescription description;
    Result<EditOutput> (*run)(EditInput& input) = nullptr;
    enum class Pairs : std::uint8_t { none, chunks, reactions };
    Pairs pairs = Pairs::none;
    std::vector<TokenParameter> by_token = {};

    bool takes_other() const;  // whether it has the parameters `with` and `with_word`
};

std::span<const EditOperator> edit_operators();
const EditOperator* find_edit(std::string_view name);

}  // namespace filigree::rewriting
