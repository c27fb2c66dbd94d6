// Documents in files that embed each other: which files are read, and what is said where that goes wrong.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/executor.h"
#include "session/run.h"
#include "tests/program.h"

namespace filigree {
namespace {

namespace fs = std::filesystem;

const std::string bars = "grammar tangle\nstart ground = host()\nregular_split(line, 8) : ground -> bar\n";

std::string embedding(const std::string& file) {
    return "grammar tangle\nstart leaf = circle(100)\nembed(\"" + file + "\") : leaf -> below\n";
}

struct Checked {
    OpenedDocument opened;
    CheckedDocument checked;

    // "a.fil:3:7 input.missing", one a line: by file names, since folders differ from run to run.
    std::string said() const {
        std::string all;
        for (const Diagnostic& one : checked.diagnostics) {
            if (one.span.file < opened.sources.size()) {
                const auto& source = opened.sources[one.span.file];
                const LineColumn place = line_column(source.text, one.span.begin);
                all += fs::path(source.name).filename().string() + ":" + std::to_string(place.line) + ":" +
                       std::to_string(place.column) + " ";
            }
            all += one.code + "\n";
        }
        return all;
    }
    std::string text() const { return to_text(checked.diagnostics, opened.sources); }
};

std::unique_ptr<Checked> check_file(const std::string& file, std::vector<fs::path> allowed = {}) {
    OpenOptions options;
    options.allowed_folders = std::move(allowed);
    Result<OpenedDocument> opened = open_document(file, options);
    EXPECT_TRUE(opened) << file;
    auto checked = std::make_unique<Checked>();
    if (!opened) return checked;
    checked->opened = std::move(*opened);
    checked->checked = check_document(checked->opened);
    return checked;
}

std::string said_of(const std::string& file, std::vector<fs::path> allowed = {}) {
    return check_file(file, std::move(allowed))->said();
}

Result<Run> run(const Checked& of) {
    SerialExecutor executor;
    RunOptions options;
    options.verify = true;
    return run_document(of.opened, of.checked, options, executor, {});
}

TEST(WrongEmbeddings, AFileThatIsNotThere) {
    const TestFolder folder;
    const auto checked = check_file(folder.write("a.fil", embedding("none.fil")));
    EXPECT_EQ(checked->said(), "a.fil:3:7 input.missing\n");
    EXPECT_NE(checked->text().find("the file 'none.fil' cannot be read"), std::string::npos) << checked->text();
    EXPECT_NE(checked->text().find("hint: files are looked up beside the document"), std::string::npos);
    EXPECT_EQ(said_of(folder.write("b.fil", embedding(""))), "b.fil:3:7 input.missing\n");
}

TEST(WrongEmbeddings, AFolderIsNoDocument) {
    const TestFolder folder;
    folder.write("sub/in.fil", bars);
    EXPECT_EQ(said_of(folder.write("a.fil", embedding("sub"))), "a.fil:3:7 input.missing\n");
    EXPECT_EQ(said_of(folder.write("b.fil", embedding("."))), "b.fil:3:7 input.missing\n");
    EXPECT_EQ(said_of(folder.write("c.fil", embedding("sub/in.fil/x"))), "c.fil:3:7 input.missing\n");
}

TEST(WrongEmbeddings, FilesOutsideTheFolder) {
    const TestFolder folder;
    folder.write("out.fil", bars);
    const std::string climbing = folder.write("doc/a.fil", embedding("../out.fil"));
    const std::string hidden = folder.write("doc/b.fil", embedding("sub/../../out.fil"));
    const std::string absolute = folder.write("doc/c.fil", embedding(folder / "out.fil"));
    fs::create_symlink(folder / "out.fil", folder / "doc/link.fil");
    fs::create_directory_symlink(folder / ".", folder / "doc/dir");
    const std::string linked = folder.write("doc/d.fil", embedding("link.fil"));
    const std::string in_linked = folder.write("doc/e.fil", embedding("dir/out.fil"));
    for (const std::string& file : {climbing, hidden, absolute, linked, in_linked}) {
        const std::string name = fs::path(file).filename().string();
        EXPECT_EQ(said_of(file), name + ":3:7 input.outside\n");
        EXPECT_EQ(said_of(file, {folder / "doc"}), name + ":3:7 input.outside\n");
        EXPECT_EQ(said_of(file, {folder / "no-such-folder"}), name + ":3:7 input.outside\n");
        EXPECT_EQ(said_of(file, {folder / "."}), "");
    }
    EXPECT_NE(check_file(climbing)->text().find("hint: --allow DIR"), std::string::npos);
}

// A folder whose name only begins like the document's is another one.
TEST(WrongEmbeddings, AFolderOfALongerName) {
    const TestFolder folder;
    folder.write("doc-secret/out.fil", bars);
    EXPECT_EQ(said_of(folder.write("doc/a.fil", embedding("../doc-secret/out.fil"))), "a.fil:3:7 input.outside\n");
}

TEST(WrongEmbeddings, OtherWaysToNameAFileInTheFolder) {
    const TestFolder folder;
    folder.write("doc/in.fil", bars);
    folder.write("doc/sub/in.fil", bars);
    fs::create_symlink("in.fil", folder / "doc/link.fil");
    const std::string absolute = folder / "doc/in.fil";
    for (const std::string& name :
         {std::string("in.fil"), std::string("./in.fil"), std::string("sub/../in.fil"), std::string("sub//in.fil"),
          std::string("../doc/in.fil"), std::string("link.fil"), absolute}) {
        EXPECT_EQ(said_of(folder.write("doc/a.fil", embedding(name))), "") << name;
    }
}

// Also where the document that names it lies in a sub-folder.
TEST(WrongEmbeddings, AnAbsoluteNameIsAbsoluteEverywhere) {
    const TestFolder folder;
    folder.write("doc/in.fil", bars);
    folder.write("doc/leaf.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><rect width=\"80\" height=\"80\"/></svg>");
    folder.write("doc/sub/a.fil", "grammar tangle\nstart ground = host()\nembed(\"" + (folder / "doc/in.fil") +
                                      "\") : ground -> below\n");
    EXPECT_EQ(said_of(folder.write("doc/a.fil", embedding("sub/a.fil"))), "");
    folder.write("doc/sub/b.fil", "grammar tangle\nstart ground = file(\"" + (folder / "doc/leaf.svg") + "\")\n");
    EXPECT_EQ(said_of(folder.write("doc/b.fil", embedding("sub/b.fil"))), "");
}

TEST(WrongEmbeddings, Cycles) {
    const TestFolder folder;
    EXPECT_EQ(said_of(folder.write("self.fil", embedding("self.fil"))), "self.fil:3:7 embed.cycle\n");
    EXPECT_EQ(said_of(folder.write("self.fil", embedding("./self.fil"))), "self.fil:3:7 embed.cycle\n");
    folder.write("b.fil", embedding("c.fil"));
    folder.write("c.fil", embedding("b.fil"));
    const std::string beside = folder.write("a.fil", embedding("b.fil"));
    EXPECT_EQ(said_of(beside), "c.fil:3:7 embed.cycle\n");
    // One that comes back to where it began has one error too, in one of the two.
    const std::string back = said_of(folder / "b.fil");
    EXPECT_TRUE(back == "b.fil:3:7 embed.cycle\n" || back == "c.fil:3:7 embed.cycle\n") << back;
}

TEST(WrongEmbeddings, OneFileTwiceIsNoCycle) {
    const TestFolder folder;
    folder.write("in.fil", bars);
    folder.write("left.fil", embedding("in.fil"));
    folder.write("right.fil", embedding("in.fil"));
    const std::string document = folder.write(
        "a.fil", embedding("left.fil") + "embed(\"right.fil\") : below -> b\n" + "embed(\"in.fil\") : b -> c\n");
    const auto checked = check_file(document);
    EXPECT_EQ(checked->said(), "");
    EXPECT_TRUE(run(*checked));
}

// A chain of `length` documents, the last of them plain; the name of the first.
std::string chain(const TestFolder& folder, std::uint32_t length) {
    folder.write("d" + std::to_string(length) + ".fil", bars);
    for (std::uint32_t i = 1; i < length; ++i) {
        folder.write("d" + std::to_string(i) + ".fil", "grammar tangle\nstart ground = host()\nembed(\"d" +
                                                           std::to_string(i + 1) + ".fil\") : ground -> below\n");
    }
    return folder.write("a.fil", embedding("d1.fil"));
}

TEST(WrongEmbeddings, AChainAsDeepAsAllowed) {
    const TestFolder folder;
    const auto checked = check_file(chain(folder, max_embedding_depth));
    EXPECT_EQ(checked->said(), "");
    const auto result = run(*checked);
    ASSERT_TRUE(result) << to_text(result.diagnostics(), checked->opened.sources);
    EXPECT_TRUE(result->broken.empty());
    EXPECT_GT(result->drawing.shapes.size(), std::size_t{max_embedding_depth});
}

TEST(WrongEmbeddings, AChainDeeperThanAllowed) {
    for (const std::uint32_t more : {1U, 2U, 30U}) {
        const TestFolder folder;
        const std::string last = "d" + std::to_string(max_embedding_depth) + ".fil";
        EXPECT_EQ(said_of(chain(folder, max_embedding_depth + more)), last + ":3:7 embed.too-deep\n");
    }
}

TEST(WrongEmbeddings, ErrorsAreToldWhereTheyAre) {
    const TestFolder folder;
    folder.write("sub/syntax.fil", "grammar tangle\nstart ground = host()\nregular_split(line 8) : ground -> bar\n");
    const auto syntax = check_file(folder.write("a.fil", embedding("sub/syntax.fil")));
    EXPECT_EQ(syntax->said(), "syntax.fil:3:20 language.unexpected-token\n");
    EXPECT_NE(syntax->text().find("sub/syntax.fil:3:20: error: "), std::string::npos) << syntax->text();
    EXPECT_NE(syntax->text().find("    regular_split(line 8) : ground -> bar\n"), std::string::npos);

    folder.write("operator.fil", "grammar tangle\nstart ground = host()\nregular_spilt(line, 8) : ground -> bar\n");
    EXPECT_EQ(said_of(folder.write("b.fil", embedding("operator.fil"))), "operator.fil:3:1 tangle.unknown-operator\n");

    folder.write("preset.fil", bars + "set ground/regular_split.offset = -4\n");
    EXPECT_EQ(said_of(folder.write("c.fil", embedding("preset.fil"))), "preset.fil:4:35 language.out-of-range\n");

    // In a document inside of one, and in what it includes.
    folder.write("sub/names.fil", "let gap = gpa\n");
    folder.write("sub/including.fil", "include \"names.fil\"\n" + bars);
    folder.write("sub/outer.fil", embedding("including.fil"));
    EXPECT_EQ(said_of(folder.write("d.fil", embedding("sub/outer.fil"))), "names.fil:1:11 language.unknown-name\n");

    // Two errors, each in its own file.
    folder.write("twice.fil", embedding("operator.fil") + "invrt() : below -> b\n");
    const std::string both = said_of(folder.write("e.fil", embedding("twice.fil")));
    EXPECT_NE(both.find("operator.fil:3:1 tangle.unknown-operator\n"), std::string::npos) << both;
    EXPECT_NE(both.find("twice.fil:4:1 tangle.unknown-operator\n"), std::string::npos) << both;
    EXPECT_EQ(std::count(both.begin(), both.end(), '\n'), 2) << both;
}

// What only a derivation finds out is told in the embedded file too.
TEST(WrongEmbeddings, ErrorsOfADerivationAreToldWhereTheyAre) {
    const TestFolder folder;
    folder.write("in.fil",
                 "grammar tangle\nparam gap = 8\nstart ground = host()\nregular_split(line, gap) : ground -> bar\n");
    auto checked = check_file(folder.write(
        "a.fil", "grammar tangle\nstart leaf = circle(100)\nembed(\"in.fil\", gap: 0 - count) : leaf -> below\n"));
    EXPECT_EQ(checked->said(), "");
    const auto result = run(*checked);
    ASSERT_FALSE(result);
    checked->checked.diagnostics = result.diagnostics();
    EXPECT_EQ(checked->said(), "in.fil:4:21 language.out-of-range\n");
}

TEST(WrongEmbeddings, BytesThatAreNoText) {
    const TestFolder folder;
    folder.write("utf.fil", "grammar tangle\nstart gr\xFFund = host()\n");
    const std::string latin = said_of(folder.write("a.fil", embedding("utf.fil")));
    EXPECT_NE(latin.find("utf.fil:2:9 language.not-utf8\n"), std::string::npos) << latin;
    EXPECT_EQ(latin.find("a.fil:"), std::string::npos) << latin;
    folder.write("empty.fil", "");
    EXPECT_EQ(said_of(folder.write("b.fil", embedding("empty.fil"))), "empty.fil:1:1 language.no-grammar\n");
    folder.write("windows.fil",
                 "\xEF\xBB\xBFgrammar tangle\r\nstart ground = host()\r\nregular_split(line, 8) : ground -> b");
    EXPECT_EQ(said_of(folder.write("c.fil", embedding("windows.fil"))), "");
}

TEST(WrongEmbeddings, AStartFileThatIsNotThereIsToldOnce) {
    const TestFolder folder;
    folder.write("sub/in.fil", "grammar tangle\nstart ground = file(\"none.svg\")\n");
    EXPECT_EQ(said_of(folder.write("a.fil", embedding("sub/in.fil"))), "in.fil:2:21 input.missing\n");
    folder.write("sub/far.fil", "grammar tangle\nstart ground = file(\"../../none.svg\")\n");
    EXPECT_EQ(said_of(folder.write("b.fil", embedding("sub/far.fil"))), "far.fil:2:21 input.outside\n");
}

// A document in a sub-folder with a start, names and documents of its own beside it, above it and below it.
std::string with_sub_folder(const TestFolder& folder) {
    folder.write("doc/bars.fil", bars);
    folder.write("doc/sub/below/net.fil",
                 "grammar tangle\nstart ground = host()\nregular_split(line, 9, 30) : ground -> n\n");
    folder.write("doc/sub/names.fil", "let gap = 11..13\n");
    folder.write("doc/sub/leaf.svg",
                 "<svg xmlns=\"http://www.w3.org/2000/svg\"><rect width=\"80\" height=\"80\"/></svg>");
    folder.write("doc/sub/in.fil",
                 "grammar tangle\ninclude \"names.fil\"\nstart pane = file(\"leaf.svg\")\nstart ground = host()\n"
                 "regular_split(line, gap) : pane -> bar\nembed(\"below/net.fil\") : bar -> b\n"
                 "embed(\"../bars.fil\") : ground -> c\n");
    // Files of the same names that are not meant.
    folder.write("doc/names.fil", "let gap = wrong\n");
    folder.write("doc/leaf.svg", "no picture");
    return folder.write("doc/a.fil", embedding("sub/in.fil") + "set leaf/embed/let/gap = 12\n");
}

TEST(Embeddings, AFileInASubFolderReadsBesideItself) {
    const TestFolder folder;
    const auto checked = check_file(with_sub_folder(folder));
    EXPECT_EQ(checked->said(), "");
    const auto result = run(*checked);
    ASSERT_TRUE(result) << to_text(result.diagnostics(), checked->opened.sources);
    EXPECT_TRUE(result->broken.empty());
    EXPECT_TRUE(result->diagnostics.empty()) << to_text(result->diagnostics, checked->opened.sources);
    std::vector<std::string> read;
    for (const fs::path& file : checked->opened.files) {
        read.push_back(fs::relative(file, folder / "doc").generic_string());
    }
    std::sort(read.begin(), read.end());
    EXPECT_EQ(read, (std::vector<std::string>{"a.fil", "bars.fil", "sub/below/net.fil", "sub/in.fil", "sub/leaf.svg",
                                              "sub/names.fil"}));
}

TEST(Embeddings, AnSvgCarriesAllOfThem) {
    const TestFolder folder;
    const std::string document = with_sub_folder(folder);
    const Ran first =
        run_program("render " + document + " -o " + folder / "empty/one.svg" + " -o " + folder / "empty/one.png");
    EXPECT_EQ(first.status, 3) << "there is no such folder yet";
    fs::create_directory(folder / "empty");
    ASSERT_EQ(run_program("render " + document + " -o " + folder / "empty/one.svg" + " -o " + folder / "empty/one.png")
                  .status,
              0);
    fs::remove_all(folder / "doc");
    const Ran again = run_program("render " + folder / "empty/one.svg" + " -o " + folder / "empty/two.svg" + " -o " +
                                  folder / "empty/two.png");
    EXPECT_EQ(again.status, 0) << again.out;
    EXPECT_EQ(folder.read("empty/one.svg"), folder.read("empty/two.svg"));
    EXPECT_EQ(folder.read("empty/one.png"), folder.read("empty/two.png"));

    // An edit of it still knows what it carries.
    const Ran edited = run_program("set " + folder / "empty/one.svg" + " leaf/embed/let/gap=20");
    EXPECT_EQ(edited.status, 0) << edited.out;
    EXPECT_NE(edited.out.find("set leaf/embed/let/gap = 20\n"), std::string::npos) << edited.out;
    const Ran other = run_program("render " + folder / "empty/one.svg" + " --set leaf/embed/let/gap=20 -o " +
                                  folder / "empty/three.svg");
    EXPECT_EQ(other.status, 0) << other.out;
    EXPECT_NE(folder.read("empty/one.svg"), folder.read("empty/three.svg"));
    ASSERT_EQ(run_program("render " + folder / "empty/three.svg" + " -o " + folder / "empty/four.svg").status, 0);
    EXPECT_EQ(folder.read("empty/three.svg"), folder.read("empty/four.svg"));
}

TEST(Embeddings, AnSvgCarriesFilesFromElsewhere) {
    const TestFolder folder;
    folder.write("out.fil", bars);
    fs::create_directory(folder / "empty");
    const std::string document = folder.write("doc/a.fil", embedding("../out.fil"));
    ASSERT_EQ(run_program("render " + document + " --allow " + folder / "." + " -o " + folder / "empty/one.svg").status,
              0);
    fs::remove(folder / "out.fil");
    const Ran again = run_program("render " + folder / "empty/one.svg" + " -o " + folder / "empty/two.svg");
    EXPECT_EQ(again.status, 0) << again.out;
    EXPECT_EQ(folder.read("empty/one.svg"), folder.read("empty/two.svg"));
}

std::size_t count_embedded(const tangle::Tangle& tangle) {
    std::size_t count = 0;
    for (const tangle::Step& step : tangle.steps) {
        count += static_cast<std::size_t>(std::count_if(step.embedded.begin(), step.embedded.end(),
                                                        [](const auto& embedded) { return embedded != nullptr; }));
    }
    return count;
}

TEST(Embeddings, ADocumentAThousandTimes) {
    const TestFolder folder;
    folder.write("in.fil", "grammar tangle\nstart ground = host()\noutline(0.3) : ground -> in, rim\n");
    const auto checked =
        check_file(folder.write("a.fil",
                                "grammar tangle\nstart leaf = rectangle(400, 250)\n"
                                "regular_split(line, 10, 0) : leaf -> row\nregular_split(line, 10, 90) : row -> field\n"
                                "embed(\"in.fil\") : field -> below\n"));
    EXPECT_EQ(checked->said(), "");
    const auto result = run(*checked);
    ASSERT_TRUE(result) << to_text(result.diagnostics(), checked->opened.sources);
    EXPECT_TRUE(result->broken.empty());
    EXPECT_GE(count_embedded(result->tangle), 1000U);
}

TEST(Embeddings, AThousandRulesForOneDocument) {
    const TestFolder folder;
    folder.write("in.fil", bars);
    std::string text = "grammar tangle\nstart leaf = circle(20)\n";
    for (int i = 0; i < 1000; ++i) text += "r" + std::to_string(i) + " = embed(\"in.fil\") : leaf -> below\n";
    const auto checked = check_file(folder.write("a.fil", text + "set leaf.rule = \"r999\"\n"));
    EXPECT_EQ(checked->said(), "");
    EXPECT_EQ(checked->opened.sources.size(), 2U);
    const auto result = run(*checked);
    ASSERT_TRUE(result) << to_text(result.diagnostics(), checked->opened.sources);
    EXPECT_EQ(count_embedded(result->tangle), 1U);
}

// However many ways lead to a file, it is read once: else a few dozen lines in a dozen files would never end.
TEST(Embeddings, FilesThatManyOthersEmbedAreReadOnce) {
    const TestFolder folder;
    constexpr int levels = 8;
    for (int level = 0; level < levels; ++level) {
        for (const char* side : {"a", "b"}) {
            std::string text = "grammar tangle\nstart ground = host()\n";
            for (const char* next : {"a", "b"}) {
                if (level + 1 == levels) break;
                text += std::string("embed(\"") + next + std::to_string(level + 1) + ".fil\") : ground -> below\n";
            }
            folder.write(side + std::to_string(level) + ".fil", text);
        }
    }
    const auto checked = check_file(folder / "a0.fil");
    EXPECT_EQ(checked->said(), "");
    EXPECT_LE(checked->opened.sources.size(), std::size_t{2 * levels});
}

TEST(WrongEmbeddings, AnEmbeddedDocumentReachesItsOwnLimit) {
    const TestFolder folder;
    folder.write("in.fil", bars + "limit elements 3\n");
    const auto checked = check_file(folder.write("a.fil", embedding("in.fil")));
    const auto result = run(*checked);
    ASSERT_FALSE(result);
    const Diagnostic& reason = result.diagnostics().front();
    EXPECT_EQ(reason.code, "limit.elements");
    EXPECT_EQ(reason.fault, Fault::limit);
    ASSERT_EQ(reason.span.file, 1U);
    EXPECT_EQ(line_column(checked->opened.sources[1].text, reason.span.begin).line, 3U);
}

TEST(WrongEmbeddings, WhatIsEmbeddedCountsTowardsTheOuterLimit) {
    const TestFolder folder;
    folder.write("in.fil", bars);
    const std::string document =
        "grammar tangle\nstart leaf = circle(100)\nregular_split(line, 25) : leaf -> bar\nembed(\"in.fil\") : bar -> "
        "b\n";
    const auto free = check_file(folder.write("a.fil", document));
    const auto all = run(*free);
    ASSERT_TRUE(all);
    const auto limited = check_file(folder.write("b.fil", document + "limit elements 60\n"));
    const auto stopped = run(*limited);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.diagnostics().front().code, "limit.elements");
    EXPECT_EQ(stopped.diagnostics().front().fault, Fault::limit);
    EXPECT_EQ(run_program("render " + folder / "b.fil" + " -o " + folder / "b.svg").status, 4);
    EXPECT_FALSE(folder.has("b.svg"));
    const auto enough = check_file(folder.write("c.fil", document + "limit elements 100000\n"));
    EXPECT_TRUE(run(*enough));
}

// Fields of less than a px.
std::string tiny_fields(const std::string& file) {
    return "grammar tangle\nstart leaf = circle(20)\nregular_split(line, 0.7, 0) : leaf -> row\n"
           "regular_split(line, 0.7, 90) : row -> field\nembed(\"" +
           file + "\") : field -> below\n";
}

TEST(Embeddings, ShapesTooSmallStayEmpty) {
    const TestFolder folder;
    folder.write("in.fil", "grammar tangle\nstart ground = host()\noutline(0.3) : ground -> in, rim\n");
    const auto checked = check_file(folder.write("a.fil", tiny_fields("in.fil")));
    EXPECT_EQ(checked->said(), "");
    const auto result = run(*checked);
    ASSERT_TRUE(result) << to_text(result.diagnostics(), checked->opened.sources);
    EXPECT_TRUE(result->broken.empty());
    EXPECT_EQ(count_embedded(result->tangle), 0U);
    EXPECT_GT(result->drawing.shapes.size(), 1000U);
}

// In the units of a page that is laid over them they are as large as the page.
TEST(Embeddings, APageFitsIntoTheSmallestShapes) {
    const TestFolder folder;
    folder.write(
        "in.fil",
        "grammar tangle\npage 100mm x 100mm\nstart ground = host(fit: cover)\noutline(3mm) : ground -> in, rim\n");
    const auto checked = check_file(folder.write("a.fil", tiny_fields("in.fil")));
    EXPECT_EQ(checked->said(), "");
    const auto result = run(*checked);
    ASSERT_TRUE(result) << to_text(result.diagnostics(), checked->opened.sources);
    EXPECT_TRUE(result->broken.empty());
    EXPECT_GT(count_embedded(result->tangle), 1000U);
}

}  // namespace
}  // namespace filigree
