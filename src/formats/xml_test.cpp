#include "formats/xml.h"

#include <gtest/gtest.h>

namespace filigree {
namespace {

TEST(Xml, WhatSurvives) {
    for (const char* text : {"", "a<b>&\"'", "\t\n", "\xC3\xA4\xF0\x9F\x8C\xBF", "\x7F"})
        EXPECT_TRUE(survives_xml(text)) << text;
    for (const std::string& text : {std::string("\r"), std::string(1, '\0'), std::string("\x1b"), std::string("\xff"),
                                    std::string("\xC3"), std::string("\xED\xA0\x80"), std::string("\xEF\xBF\xBF")}) {
        EXPECT_FALSE(survives_xml(text));
    }
}

TEST(Xml, EscapedTextComesBack) {
    std::string text = "<a href=\"&amp;\">'\t\n\r";
    std::string xml = "<r a=\"";
    append_escaped(xml, text);
    xml += "\">";
    append_escaped(xml, text);
    xml += "</r>";
    const auto parsed = parse_xml(xml, 0);
    ASSERT_TRUE(parsed);
    EXPECT_EQ((*parsed)->root().attribute("a").value(), text);
    EXPECT_EQ(text_of((*parsed)->root()), text);
    std::string replaced;
    append_escaped(replaced, std::string_view("a\0\xff\x02", 4));
    EXPECT_EQ(replaced, "a\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");
}

TEST(Xml, PlacesInTheSource) {
    const std::string source = "\xEF\xBB\xBF<a>&lt;<b x='&amp;' y = \"value\"/></a>";
    const auto parsed = parse_xml(source, 3);
    ASSERT_TRUE(parsed);
    const pugi::xml_node b = (*parsed)->root().child("b");
    const SourceSpan name = (*parsed)->span_of(b), value = (*parsed)->span_of(b, b.attribute("y"));
    EXPECT_EQ(name.file, 3U);
    EXPECT_EQ(source.substr(name.begin, name.end - name.begin), "b");
    EXPECT_EQ(source.substr(value.begin, value.end - value.begin), "value");
    EXPECT_EQ((*parsed)->span_of(b, b.attribute("z")), name);
}

TEST(Xml, Namespaces) {
    const auto parsed = parse_xml("<a xmlns='one'><p:b xmlns:p='two'><p:c/><d xmlns='three'/></p:b></a>", 0);
    ASSERT_TRUE(parsed);
    const pugi::xml_node a = (*parsed)->root(), b = a.first_child();
    EXPECT_EQ(namespace_of(a), "one");
    EXPECT_EQ(namespace_of(b), "two");
    EXPECT_EQ(namespace_of(b.first_child()), "two");
    EXPECT_EQ(namespace_of(b.last_child()), "three");
    EXPECT_EQ(local_name("p:b"), "b");
    EXPECT_EQ(local_name("b"), "b");
}

}  // namespace
}  // namespace filigree
