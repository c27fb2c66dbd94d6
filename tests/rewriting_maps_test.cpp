// Words that look at pictures and tables, as a person meets them: files beside the document, carried with the drawing.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "formats/png_encode.h"
#include "tests/program.h"

namespace filigree {
namespace {

// A black, a grey and a white pixel.
std::string row_png() {
    const std::vector<std::uint32_t> pixels = {0xFF000000, 0xFF808080, 0xFFFFFFFF};
    const Result<std::string> bytes =
        encode_png({3, 1, reinterpret_cast<const unsigned char*>(pixels.data()), 12, false}, 1);
    return bytes ? *bytes : "";
}

constexpr const char* wall =
    "grammar rewriting\nletter i nothing\nstep 10\niterations 1\naxiom \"iaiaia\"\n"
    "image wall \"photo.png\" over 0, 0, 30, 10\n"
    "i -> image wall L { 0..85 \"T+b\"; 86..170 \"b\"; 171..255 \"T---b\" }\n";

TEST(RewritingMaps, TheTurtlesSettingsSayWhereSymbolsStand) {
    const TestFolder folder;
    folder.write("photo.png", row_png());
    const std::string document = folder.write("a.fil", wall);
    EXPECT_EQ(run_program("derive " + document).out, "T+babaT---ba\n");
    EXPECT_EQ(run_program("derive " + document + " --steps 0").out, "iaiaia\n");
    std::string slow = wall;
    slow.replace(slow.find("step 10"), 7, "step 5");
    EXPECT_EQ(run_program("derive " + folder.write("b.fil", slow)).out, "T+baT+baba\n");
    folder.write("heights.csv", "0, 1\n2, 3\n");
    EXPECT_EQ(run_program("derive " + folder.write("c.fil",
                                                   "grammar rewriting\niterations 1\naxiom \"[b]f[b]Yf[b]\"\n"
                                                   "data heights \"heights.csv\" over 0, 0, 2, 2\n"
                                                   "b -> data heights { 0..9 \"{$value u}\" }\n"))
                  .out,
              "[uu]f[uuu]Yf[u]\n");
}

TEST(RewritingMaps, DrawingsCarryThem) {
    const TestFolder folder;
    folder.write("sub/photo.png", row_png());
    const std::string document = folder.write("sub/a.fil", wall);
    for (const char* name : {"a.svg", "a.pdf"}) {
        const Ran ran = run_program("render " + document + " -o " + folder / name);
        ASSERT_EQ(ran.status, 0) << ran.out;
        EXPECT_EQ(run_program("derive " + folder / name).out, "T+babaT---ba\n") << name;
    }
}

TEST(RewritingMaps, FilesThatCannotBeReadAreSaidOnceAndWhereTheyAreNamed) {
    const TestFolder folder;
    folder.write("photo.png", row_png());
    const auto said = [&](const std::string& file, const std::string& options = "") {
        std::string text = wall;
        text.replace(text.find("photo.png"), 9, file);
        return run_program("check " + folder.write("sub/a.fil", text) + options);
    };
    const Ran missing = said("other.png");
    EXPECT_EQ(missing.status, 1);
    EXPECT_NE(missing.out.find("a.fil:6:12: error: the file 'other.png' cannot be read"), std::string::npos)
        << missing.out;
    EXPECT_EQ(missing.out.find("error:", missing.out.find("error:") + 1), std::string::npos) << missing.out;
    const Ran outside = said("../photo.png");
    EXPECT_NE(outside.out.find("input.outside"), std::string::npos) << outside.out;
    EXPECT_EQ(said("../photo.png", " --allow " + folder / "").status, 0);
    const Ran no_picture = said("a.fil");
    EXPECT_NE(no_picture.out.find("a.fil:6:12: error: in 'a.fil': the picture is neither a PNG nor a JPEG"),
              std::string::npos)
        << no_picture.out;
}

TEST(RewritingMaps, ExplainTellsOfPlacesBesideAMap) {
    const TestFolder folder;
    folder.write("photo.png", row_png());
    std::string text = wall;
    text.replace(text.find("30, 10"), 6, "20, 10 outside none");
    const Ran ran = run_program("derive " + folder.write("a.fil", text) + " --steps 0 --explain 4");
    EXPECT_NE(ran.out.find("a map that it looks at has nothing where the symbol stands"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace filigree
