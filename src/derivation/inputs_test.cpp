#include "derivation/inputs.h"

#include <gtest/gtest.h>

#include "language/parse.h"

namespace filigree {
namespace {

// "name@what its span covers", with blanks between.
std::string files_of(const std::string& text) {
    const Parsed parsed = parse_document("a.fil", text, {});
    EXPECT_EQ(to_text(parsed.diagnostics, parsed.document.sources), "");
    std::string out;
    for (const Name& file : named_files(parsed.document)) {
        const std::string bytes = text.substr(file.span.begin, file.span.end - file.span.begin);
        out += (out.empty() ? "" : " ") + file.text + "@" + bytes;
    }
    return out;
}

TEST(NamedFiles, OfShapeGrammars) {
    EXPECT_EQ(
        files_of("grammar shape\nlet knot = file(\"knot.svg\", id: \"lobe\") + circle(3)\nlet name = \"b.svg\"\n"
                 "rules from \"rules.svg\"\nslide = translate(2, 2) * file(name) -> empty - file(name: \"c.svg\")\n"
                 "steps 3\nshow points\napply slide at (3, 3)\ngrow = empty -> knot unless inside(file(\"d.svg\"))\n"
                 "start from \"e.svg\"\nstart design = knot & file(\"f.svg\")\nrules from \"rules.svg\"\n"),
        "knot.svg@\"knot.svg\" rules.svg@\"rules.svg\" b.svg@\"b.svg\" c.svg@\"c.svg\" d.svg@\"d.svg\" "
        "e.svg@\"e.svg\" f.svg@\"f.svg\"");
}

TEST(NamedFiles, OfOtherGrammars) {
    EXPECT_EQ(files_of("grammar tangle\nplace(file(one_of(\"a.svg\", \"b.svg\")), 3) : x -> y\nstart x = circle(5)\n"),
              "a.svg@\"a.svg\" b.svg@\"b.svg\"");
    EXPECT_EQ(files_of("grammar rewriting\naxiom \"a\"\narray M from \"m.csv\"\nimage w \"w.png\" over 0, 0, 1, 1\n"),
              "m.csv@\"m.csv\" w.png@\"w.png\"");
}

}  // namespace
}  // namespace filigree
