// XML as the SVG files of this layer need it, on top of pugixml: places in the source, names without their
// prefixes, escaping.
//
// Guarantee: nothing outside the given bytes is ever read and no entity but the five of XML is expanded, so a
// document type declaration is harmless.
#pragma once

#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "base/result.h"

namespace filigree {

// A parsed file. Offsets are exact for UTF-8 (what every SVG in practice is) and a near place otherwise.
struct Xml {
    pugi::xml_document document;
    std::string_view source;
    std::uint32_t file = 0;

    pugi::xml_node root() const { return document.document_element(); }
    SourceSpan span_of(pugi::xml_node element) const;                             // its name
    SourceSpan span_of(pugi::xml_node element, pugi::xml_attribute value) const;  // the attribute's value
};

// `keep_space` keeps text nodes of nothing but white space.
Result<std::unique_ptr<Xml>> parse_xml(std::string_view source, std::uint32_t file, bool keep_space = false);

std::string_view local_name(std::string_view name);  // "svg:path" -> "path"
// The namespace that the element's prefix, or its lack of one, stands for at its place; empty where none is said.
std::string_view namespace_of(pugi::xml_node element);
// The text and character data directly inside an element.
std::string text_of(pugi::xml_node element);

// Whether a text comes back unchanged when it is written into XML: valid UTF-8 of characters that XML knows,
// without carriage returns.
bool survives_xml(std::string_view text);
// For text and attributes in double quotes. What XML cannot hold becomes U+FFFD.
void append_escaped(std::string& out, std::string_view text);
// A CDATA section, or several where the text is very long or holds the end mark. The text must survive XML.
void append_cdata(std::string& out, std::string_view text);

}  // namespace filigree
