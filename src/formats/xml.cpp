#include "formats/xml.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/unicode.h"

namespace filigree {
namespace {

// Some readers refuse sections of more than ten million bytes.
constexpr std::size_t longest_cdata = 4'000'000;

bool is_xml_character(char32_t c) {
    if (c < 0x20) return c == '\t' || c == '\n' || c == '\r';
    return c <= 0xD7FF || (c >= 0xE000 && c <= 0xFFFD) || (c >= 0x10000 && c <= 0x10FFFF);
}

SourceSpan span_at(const Xml& xml, std::ptrdiff_t offset, std::size_t length) {
    const std::size_t size = xml.source.size();
    const std::size_t begin = offset < 0 ? 0 : std::min(static_cast<std::size_t>(offset), size);
    const std::size_t end = std::min(begin + length, size);
    return {xml.file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

}  // namespace

SourceSpan Xml::span_of(pugi::xml_node element) const {
    return span_at(*this, element.offset_debug(), std::string_view(element.name()).size());
}

SourceSpan Xml::span_of(pugi::xml_node element, pugi::xml_attribute value) const {
    const std::ptrdiff_t name = element.offset_debug();
    if (!value || name < 0) return span_of(element);
    // Names and values are views into one buffer that lies as the source does.
    const std::ptrdiff_t ahead = value.value() - element.name();
    if (ahead < 0 || static_cast<std::size_t>(name + ahead) > source.size()) return span_of(element);
    return span_at(*this, name + ahead, std::string_view(value.value()).size());
}

Result<std::unique_ptr<Xml>> parse_xml(std::string_view source, std::uint32_t file, bool keep_space) {
    if (source.size() >= UINT32_MAX) return fault(Fault::limit, "svg.too-large", "the file is larger than 4 GB");
    auto xml = std::make_unique<Xml>();
    xml->source = source;
    xml->file = file;
    const unsigned flags = pugi::parse_default | pugi::parse_pi | (keep_space ? pugi::parse_ws_pcdata : 0U);
    const pugi::xml_parse_result parsed = xml->document.load_buffer(source.data(), source.size(), flags);
    if (!parsed) {
        std::string reason = parsed.description();
        if (!reason.empty() && reason[0] >= 'A' && reason[0] <= 'Z')
            reason[0] = static_cast<char>(reason[0] - 'A' + 'a');
        return error("svg.bad-xml", "this is not well-formed XML: " + reason, span_at(*xml, parsed.offset, 1));
    }
    return xml;
}

std::string_view local_name(std::string_view name) {
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string_view namespace_of(pugi::xml_node element) {
    const std::string_view name = element.name();
    const std::size_t colon = name.find(':');
    const std::string attribute =
        colon == std::string_view::npos ? "xmlns" : "xmlns:" + std::string(name.substr(0, colon));
    for (pugi::xml_node at = element; at.type() == pugi::node_element; at = at.parent()) {
        if (const pugi::xml_attribute said = at.attribute(attribute.c_str())) return said.value();
    }
    return {};
}

std::string text_of(pugi::xml_node element) {
    std::string text;
    for (const pugi::xml_node child : element.children()) {
        if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) text += child.value();
    }
    return text;
}

bool survives_xml(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const unsigned char byte = static_cast<unsigned char>(text[i]);
        if (byte >= 0x20 && byte < 0x80) {
            ++i;
            continue;
        }
        const unicode::Decoded next = unicode::decode(text, i);
        if (!next.valid || next.code_point == '\r' || !is_xml_character(next.code_point)) return false;
        i += next.length;
    }
    return true;
}

void append_escaped(std::string& out, std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const unicode::Decoded next = unicode::decode(text, i);
        switch (next.code_point) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\t':
                out += "&#9;";
                break;
            case '\n':
                out += "&#10;";
                break;
            case '\r':
                out += "&#13;";
                break;
            default:
                if (next.valid && is_xml_character(next.code_point)) {
                    out += text.substr(i, next.length);
                } else {
                    out += "\xEF\xBF\xBD";
                }
        }
        i += next.length;
    }
}

void append_cdata(std::string& out, std::string_view text) {
    do {
        std::size_t length = std::min(text.size(), longest_cdata);
        while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
        if (const std::size_t end_mark = text.substr(0, length).find("]]>"); end_mark != std::string_view::npos) {
            length = end_mark + 2;
        }
        out += "<![CDATA[";
        out += text.substr(0, length);
        out += "]]>";
        text.remove_prefix(length);
    } while (!text.empty());
}

}  // namespace filigree
