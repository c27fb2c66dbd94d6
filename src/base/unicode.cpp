#include "base/unicode.h"

#include <utf8proc.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace filigree::unicode {

namespace {

constexpr Decoded invalid_byte{0xFFFD, 1, false};

bool is_ascii(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

bool is_scalar_value(char32_t code_point) {
    return code_point < 0xD800 || (code_point > 0xDFFF && code_point <= 0x10FFFF);
}

}  // namespace

Decoded decode(std::string_view text, std::size_t offset) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[offset + i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return {lead, 1, true};

    std::uint32_t length = 0;
    char32_t code_point = 0;
    char32_t least = 0;  // anything smaller has a shorter form, so this one is not valid
    if ((lead & 0xE0) == 0xC0) {
        length = 2, code_point = lead & 0x1FU, least = 0x80;
    } else if ((lead & 0xF0) == 0xE0) {
        length = 3, code_point = lead & 0x0FU, least = 0x800;
    } else if ((lead & 0xF8) == 0xF0) {
        length = 4, code_point = lead & 0x07U, least = 0x10000;
    } else {
        return invalid_byte;
    }
    if (text.size() - offset < length) return invalid_byte;
    for (std::uint32_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return invalid_byte;
        code_point = (code_point << 6) | (byte(i) & 0x3FU);
    }
    if (code_point < least || !is_scalar_value(code_point)) return invalid_byte;
    return {code_point, length, true};
}

void append_utf8(std::string& out, char32_t code_point) {
    if (!is_scalar_value(code_point)) code_point = 0xFFFD;
    const auto add = [&](char32_t bits) { out += static_cast<char>(static_cast<unsigned char>(bits)); };
    const auto add_tail = [&](int shift) { add(0x80 | ((code_point >> shift) & 0x3F)); };
    if (code_point < 0x80) {
        add(code_point);
    } else if (code_point < 0x800) {
        add(0xC0 | (code_point >> 6));
        add_tail(0);
    } else if (code_point < 0x10000) {
        add(0xE0 | (code_point >> 12));
        add_tail(6);
        add_tail(0);
    } else {
        add(0xF0 | (code_point >> 18));
        add_tail(12);
        add_tail(6);
        add_tail(0);
    }
}

bool is_letter(char32_t code_point) {
    if (code_point < 0x80) {
        return (code_point >= 'a' && code_point <= 'z') || (code_point >= 'A' && code_point <= 'Z');
    }
    if (!is_scalar_value(code_point)) return false;
    switch (utf8proc_category(static_cast<utf8proc_int32_t>(code_point))) {
        case UTF8PROC_CATEGORY_LU:
        case UTF8PROC_CATEGORY_LL:
        case UTF8PROC_CATEGORY_LT:
        case UTF8PROC_CATEGORY_LM:
        case UTF8PROC_CATEGORY_LO:
        case UTF8PROC_CATEGORY_MN:
        case UTF8PROC_CATEGORY_MC:
        case UTF8PROC_CATEGORY_ME:
            return true;
        default:
            return false;
    }
}

bool is_digit(char32_t code_point) { return code_point >= '0' && code_point <= '9'; }

char32_t to_lower(char32_t code_point) {
    if (code_point < 0x80) return code_point >= 'A' && code_point <= 'Z' ? code_point + ('a' - 'A') : code_point;
    if (!is_scalar_value(code_point)) return code_point;
    return static_cast<char32_t>(utf8proc_tolower(static_cast<utf8proc_int32_t>(code_point)));
}

std::size_t find_invalid(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const Decoded decoded = decode(text, i);
        if (!decoded.valid) return i;
        i += decoded.length;
    }
    return std::string_view::npos;
}

std::string normalise(std::string_view text) {
    if (is_ascii(text) || find_invalid(text) != std::string_view::npos) return std::string(text);
    utf8proc_uint8_t* mapped = nullptr;
    const auto options = static_cast<utf8proc_option_t>(UTF8PROC_STABLE | UTF8PROC_COMPOSE);
    const utf8proc_ssize_t length = utf8proc_map(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                                                 static_cast<utf8proc_ssize_t>(text.size()), &mapped, options);
    const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> owner(mapped, &std::free);
    if (length < 0 || mapped == nullptr) return std::string(text);
    return std::string(reinterpret_cast<const char*>(mapped), static_cast<std::size_t>(length));
}

}  // namespace filigree::unicode
