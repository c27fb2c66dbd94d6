// UTF-8: decoding, what may stand in a name, and normal form C for comparing names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace filigree::unicode {

struct Decoded {
    char32_t code_point = 0;   // U+FFFD where the bytes are no valid UTF-8
    std::uint32_t length = 1;  // bytes taken; 1 for an invalid byte
    bool valid = true;
};
// The code point at `offset`, which must lie inside `text`.
Decoded decode(std::string_view text, std::size_t offset);
void append_utf8(std::string& out, char32_t code_point);  // U+FFFD for what is no Unicode scalar value

bool is_letter(char32_t code_point);     // letters and marks of any script, but no digits and no '_'
bool is_digit(char32_t code_point);      // 0-9 alone
char32_t to_lower(char32_t code_point);  // one code point to one, without regard to the locale
// Byte offset of the first byte that is no valid UTF-8, or npos.
std::size_t find_invalid(std::string_view text);
// Normal form C; the text itself where it has it already or is no valid UTF-8.
std::string normalise(std::string_view text);

}  // namespace filigree::unicode
