// Tokens in messages: how one is named, what is wrong with one, and what a quoted text stands for.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/diagnostic.h"
#include "base/result.h"
#include "language/lexer.h"

namespace filigree {

// "'big_poly'", "a text", "the end of the line": long ones are cut, unprintable ones shown by number.
std::string describe(const Token& token, std::string_view text);

// Some bytes of a document in quotes, as messages show them.
std::string in_quotes(std::string_view bytes);

// What is wrong with a token of kind `invalid`, with its span in source `file`.
Diagnostic explain(const Token& token, std::string_view text, std::uint32_t file);

// What a token of kind `text` stands for, escapes resolved.
Result<std::string> unescape(const Token& token, std::string_view text, std::uint32_t file);

// What a token of kind `colour` stands for.
Colour colour_of(const Token& token, std::string_view text);

}  // namespace filigree
