#include "formats/svg_text.h"

#include <string_view>

#include "formats/svg_elements.h"
#include "formats/svg_values.h"
#include "formats/xml.h"

namespace filigree {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// A blank run before the first letter leaves nothing; one at the end is taken off later.
void append_words(std::string& content, std::string_view text) {
    for (const char c : text) {
        if (!is_blank(c)) {
            content += c;
        } else if (!content.empty() && content.back() != ' ') {
            content += ' ';
        }
    }
}

pugi::xml_node saying(const char* attribute, pugi::xml_node innermost, pugi::xml_node text) {
    for (pugi::xml_node at = innermost; at != text; at = at.parent()) {
        if (!at.attribute(attribute).empty()) return at;
    }
    return text;
}

}  // namespace

SvgText read_text(pugi::xml_node text) {
    SvgText read{{}, text, text};
    const auto enters = [](pugi::xml_node node) {
        const std::string_view name = local_name(node.name());
        return node.type() == pugi::node_element && (is_text(name) || name == "a");
    };
    for (pugi::xml_node at = text.first_child(); at;) {
        if (at.type() == pugi::node_pcdata || at.type() == pugi::node_cdata) {
            const std::string_view words = at.value();
            read.byte_count += words.size();
            const bool was_empty = read.content.empty();
            append_words(read.content, words);
            if (was_empty && !read.content.empty()) {
                read.placed_x = saying("x", at.parent(), text);
                read.placed_y = saying("y", at.parent(), text);
            }
        } else if (enters(at)) {
            ++read.element_count;
            // Inkscape's lines.
            if (std::string_view(at.attribute("sodipodi:role").value()) == "line") append_words(read.content, " ");
            if (at.first_child()) {
                at = at.first_child();
                continue;
            }
        }
        while (at != text && !at.next_sibling()) at = at.parent();
        if (at == text) break;
        at = at.next_sibling();
    }
    if (read.content.ends_with(' ')) read.content.pop_back();
    return read;
}

}  // namespace filigree
