#include "formats/font_check.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace filigree {
namespace {

constexpr std::size_t head_bytes = 12, record_bytes = 16;

std::uint32_t number(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

Diagnostics cut_off() { return {error("font.cut-off", "the font file breaks off before all of its tables are there")}; }

Diagnostics no_font(std::string_view font) {
    const std::string_view tag = font.substr(0, 4);
    if (tag == "wOFF" || tag == "wOF2") {
        return {error("font.unknown-format", "the font is packed for the web (WOFF)", {},
                      {"unpack it to a .ttf or .otf file"})};
    }
    return {error("font.unknown-format", "the font is neither TrueType nor OpenType", {}, {"use a .ttf or .otf file"})};
}

}  // namespace

Diagnostics check_font(std::string_view font) {
    std::size_t start = 0;
    if (font.substr(0, 4) == "ttcf") {
        if (font.size() < 16) return cut_off();
        start = number(font, 12, 4);
        if (start > font.size() || font.size() - start < head_bytes) return cut_off();
    }
    const std::string_view tag = font.substr(start, 4);
    static constexpr std::array<std::string_view, 3> known = {std::string_view("\0\1\0\0", 4), "OTTO", "true"};
    if (std::find(known.begin(), known.end(), tag) == known.end()) return no_font(font);
    if (font.size() - start < head_bytes) return cut_off();
    const std::size_t count = number(font, start + 4, 2);
    if (font.size() - start < head_bytes + record_bytes * count) return cut_off();
    std::vector<std::string_view> tables;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t record = start + head_bytes + record_bytes * i;
        const std::size_t offset = number(font, record + 8, 4), length = number(font, record + 12, 4);
        if (offset > font.size() || length > font.size() - offset) return cut_off();
        tables.push_back(font.substr(record, 4));
    }
    const auto has = [&](std::string_view name) {
        return std::find(tables.begin(), tables.end(), name) != tables.end();
    };
    for (const std::string_view needed : {"head", "maxp", "cmap", "hhea", "hmtx"}) {
        if (!has(needed)) {
            return {error("font.broken", "the font has no table '" + std::string(needed) + "'")};
        }
    }
    if (!(has("glyf") && has("loca")) && !has("CFF ") && !has("CFF2")) {
        return {error("font.no-outlines", "the font has no outlines, only pictures of its letters or nothing")};
    }
    return {};
}

}  // namespace filigree
