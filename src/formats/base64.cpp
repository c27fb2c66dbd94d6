#include "formats/base64.h"

#include <array>
#include <cstdint>

namespace filigree {
namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t foreign = 255;

constexpr std::array<std::uint8_t, 256> make_values() {
    std::array<std::uint8_t, 256> values{};
    for (std::uint8_t& value : values) value = foreign;
    for (std::size_t i = 0; i < alphabet.size(); ++i) {
        values[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
    }
    return values;
}
constexpr std::array<std::uint8_t, 256> values_of = make_values();

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

std::string to_base64(std::string_view bytes, std::size_t line) {
    std::string out;
    const std::size_t length = (bytes.size() + 2) / 3 * 4;
    out.reserve(length + (line == 0 ? 0 : length / line));
    std::size_t column = 0;
    const auto put = [&](char c) {
        if (line != 0 && column == line) {
            out += '\n';
            column = 0;
        }
        out += c;
        ++column;
    };
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) -> std::uint32_t {
            return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0;
        };
        const std::uint32_t bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        put(alphabet[bits >> 18]);
        put(alphabet[bits >> 12 & 63]);
        put(i + 1 < bytes.size() ? alphabet[bits >> 6 & 63] : '=');
        put(i + 2 < bytes.size() ? alphabet[bits & 63] : '=');
    }
    return out;
}

std::optional<std::string> from_base64(std::string_view text) {
    std::string out;
    out.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    int digits = 0;  // of the group of four
    int padding = 0;
    for (const char c : text) {
        if (is_space(c)) continue;
        if (c == '=') {
            ++padding;
            continue;
        }
        const std::uint8_t value = values_of[static_cast<unsigned char>(c)];
        if (value == foreign || padding > 0) return std::nullopt;
        bits = bits << 6 | value;
        if (++digits == 4) {
            out += static_cast<char>(bits >> 16 & 255);
            out += static_cast<char>(bits >> 8 & 255);
            out += static_cast<char>(bits & 255);
            bits = 0;
            digits = 0;
        }
    }
    if (digits == 0) return padding == 0 ? std::optional(out) : std::nullopt;
    if (digits + padding != 4 || digits == 1) return std::nullopt;
    if (digits == 2) {
        if ((bits & 15) != 0) return std::nullopt;
        out += static_cast<char>(bits >> 4 & 255);
    } else {
        if ((bits & 3) != 0) return std::nullopt;
        out += static_cast<char>(bits >> 10 & 255);
        out += static_cast<char>(bits >> 2 & 255);
    }
    return out;
}

}  // namespace filigree
