// The commands about choices and presets: statuses, outputs, and that edits change nothing but what they say.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program.h"

namespace filigree {
namespace {

namespace fs = std::filesystem;

constexpr const char* document =
    "# a leaf in strips\ngrammar tangle\nseed 3\nparam gap = 3..6  # drawn\nstart leaf = circle(60)\n\n"
    "rim = outline(5..15) : leaf -> in, ring\nregular_split(line, 8..14) : in -> strip\n# the end\n";

// Without a choice.
constexpr const char* plain = "grammar tangle\nstart leaf = circle(60)\noutline(5) : leaf -> in, ring\n";

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

std::string in_quotes(const std::string& argument) { return " '" + argument + "'"; }

// --- choices and render --choices ----------------------------------------------------------------------------------

TEST(PresetCommands, ChoicesListsWhatWasDrawn) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    const Ran printed = run_program("choices " + file);
    EXPECT_EQ(printed.status, 0);
    const auto rows = nlohmann::json::parse(printed.out);
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[0]["path"], "let/gap");
    EXPECT_EQ(rows[0]["domain"], "3..6");
    EXPECT_EQ(rows[1]["path"], "leaf/rim");
    EXPECT_EQ(rows[1]["name"], "distance");
    EXPECT_EQ(rows[1]["source"], "drawn");
    EXPECT_EQ(rows[2]["path"], "leaf/rim/in/regular_split");
    EXPECT_EQ(run_program("choices " + file + " -o " + folder / "c.json").status, 0);
    EXPECT_EQ(folder.read("c.json"), printed.out);
    EXPECT_EQ(run_program("choices " + folder.write("plain.fil", plain)).out, "[]\n");
}

TEST(PresetCommands, ChoicesStatuses) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    EXPECT_EQ(run_program("choices").status, 2);
    EXPECT_EQ(run_program("choices " + folder / "none.fil").status, 3);
    EXPECT_EQ(run_program("choices " + file + " -o " + folder / "no/such/c.json").status, 3);
    EXPECT_EQ(run_program("choices " + folder.write("wrong.fil", "grammar tangle\nstart a = cirle(60)\n")).status, 1);
    EXPECT_EQ(run_program("choices " + file + " -o " + file).status, 2);
    EXPECT_EQ(folder.read("a.fil"), document);
}

TEST(PresetCommands, RecordedChoicesMakeTheSamePicture) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    ASSERT_EQ(run_program("choices " + file + " -o " + folder / "c.json").status, 0);
    ASSERT_EQ(run_program("render " + file + " -o " + folder / "a.png").status, 0);
    ASSERT_EQ(run_program("render " + file + " --seed 9 -o " + folder / "other.png").status, 0);
    const Ran replayed =
        run_program("render " + file + " --seed 9 --choices " + folder / "c.json" + " -o " + folder / "again.png");
    EXPECT_EQ(replayed.status, 0) << replayed.out;
    EXPECT_NE(folder.read("a.png"), folder.read("other.png"));
    EXPECT_EQ(folder.read("a.png"), folder.read("again.png"));
}

TEST(PresetCommands, ChoicesOfAnotherDocumentAreHarmless) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    folder.write("other.fil", "grammar tangle\nstart b = circle(70)\noutline(2..3) : b -> x, y\n");
    ASSERT_EQ(run_program("choices " + folder / "other.fil" + " -o " + folder / "c.json").status, 0);
    folder.write("empty.json", "[]");
    ASSERT_EQ(run_program("render " + file + " -o " + folder / "a.png").status, 0);
    for (const char* rows : {"c.json", "empty.json"}) {
        const Ran ran =
            run_program("render " + file + " --choices " + folder / rows + " -o " + folder / "b.png --strict");
        EXPECT_EQ(ran.status, 0) << ran.out;
        EXPECT_EQ(ran.out, "");
        EXPECT_EQ(folder.read("a.png"), folder.read("b.png")) << rows;
    }
}

TEST(PresetCommands, WrongChoices) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    const auto render = [&](const std::string& rows) {
        folder.write("c.json", rows);
        return run_program("render " + file + " --choices " + folder / "c.json" + " -o " + folder / "a.svg");
    };
    const std::string good = run_program("choices " + file).out;
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string rows = good;
        const std::size_t at = rows.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return at == std::string::npos ? rows : rows.replace(at, from.size(), to);
    };
    for (const std::string& no_list : {std::string("not json"), std::string(), std::string("{\"path\": \"leaf\"}"),
                                       good.substr(0, good.size() / 2), std::string(100000, '[')}) {
        const Ran ran = render(no_list);
        EXPECT_EQ(ran.status, 1) << ran.out;
        EXPECT_TRUE(has(ran.out, "choices.not-json")) << ran.out;
    }
    for (const std::string& bad_row :
         {std::string("[1, 2]"), std::string("[{}]"), changed("\"key\": \"", "\"key\": \"z"),
          changed("\"name\": \"gap\"", "\"name\": 5"), changed("\"value\"", "\"worth\"")}) {
        const Ran ran = render(bad_row);
        EXPECT_EQ(ran.status, 1) << ran.out;
        EXPECT_TRUE(has(ran.out, "choices.bad-row")) << ran.out;
    }
    const std::string value = nlohmann::json::parse(good)[0]["value"].dump();
    for (const char* outside : {"-500", "\"wide\"", "6.001", "[3, 4]"}) {
        const Ran ran = render(changed("\"value\": " + value, std::string("\"value\": ") + outside));
        EXPECT_EQ(ran.status, 1) << outside << ran.out;
        EXPECT_TRUE(has(ran.out, "choices.")) << ran.out;
    }
    EXPECT_FALSE(folder.has("a.svg"));
    const Ran missing = run_program("render " + file + " --choices " + folder / "none.json -o " + folder / "a.svg");
    EXPECT_EQ(missing.status, 3) << missing.out;
    EXPECT_EQ(run_program("render " + file + " --choices " + folder / "." + " -o " + folder / "a.svg").status, 3);
    // What is read is not overwritten.
    folder.write("c.svg", good);
    EXPECT_EQ(run_program("render " + file + " --choices " + folder / "c.svg -o " + folder / "c.svg").status, 2);
    EXPECT_EQ(folder.read("c.svg"), good);
}

// --- presets that meet nothing -------------------------------------------------------------------------------------

TEST(PresetCommands, StrictRefusesPresetsThatMeetNothing) {
    const TestFolder folder;
    const std::string text =
        "grammar tangle\nstart leaf = circle(60)\nrim = outline(5..15) : leaf -> in, ring\n"
        "edge = outline(2) : leaf -> in, ring\nset leaf.rule = \"edge\"\n"
        "set leaf/rim.distance = 9\nkeep leaf/edge\n";
    const std::string file = folder.write("a.fil", text);
    const std::string out = " -o " + folder / "a.svg";
    const Ran lenient = run_program("render " + file + out + " --stats " + folder / "a.json");
    EXPECT_EQ(lenient.status, 0);
    EXPECT_TRUE(has(lenient.out, "a.fil:6:5: warning: ")) << lenient.out;
    EXPECT_TRUE(has(lenient.out, "preset.unmatched")) << lenient.out;
    const auto stats = nlohmann::json::parse(folder.read("a.json"));
    ASSERT_EQ(stats["unmatched"].size(), 1U);
    EXPECT_EQ(stats["unmatched"][0], "leaf/rim.distance");
    fs::remove(folder / "a.svg");
    const Ran strict = run_program("render " + file + out + " --strict");
    EXPECT_EQ(strict.status, 1);
    EXPECT_TRUE(has(strict.out, "a.fil:6:5: error: ")) << strict.out;
    EXPECT_FALSE(folder.has("a.svg"));
    const std::string other = folder.write("b.fil", text + "set leaf.rule = \"rim\"\nset leaf/edge.distance = 3\n");
    EXPECT_EQ(run_program("render " + other + out + " --strict").status, 1);
}

// What has an effect is no preset that meets nothing, on one shape of a group or on names.
TEST(PresetCommands, StrictAllowsPresetsOfShapesAndNames) {
    const TestFolder folder;
    const std::string text =
        "grammar tangle\nlet gap = 3..9\nstart leaf = circle(60)\n"
        "outline(each(5..15)) : leaf -> in, ring\n";
    const std::string plain_choices = run_program("choices " + folder.write("a.fil", text)).out;
    for (const char* preset :
         {"set leaf/1/outline.distance = 9", "set leaf/1/outline.is_random = false", "reroll leaf/1/outline.distance",
          "reroll leaf/1", "reroll let/gap", "reroll let", "set gap = 4"}) {
        const std::string file = folder.write("b.fil", text + preset + "\n");
        EXPECT_NE(run_program("choices " + file).out, plain_choices) << preset;
        const Ran strict = run_program("render " + file + " --strict -o " + folder / "b.svg");
        EXPECT_EQ(strict.status, 0) << strict.out;
    }
}

// --- pick ----------------------------------------------------------------------------------------------------------

TEST(PresetCommands, Pick) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    const Ran text = run_program("pick " + file + " --at 0,0");
    EXPECT_EQ(text.status, 0);
    EXPECT_TRUE(text.out.starts_with("leaf/rim/in/regular_split/strip/")) << text.out;
    EXPECT_TRUE(has(text.out, "line 8")) << text.out;
    const auto json = nlohmann::json::parse(run_program("pick " + file + " --at 0,0 --json").out);
    EXPECT_EQ(json["tag"], "strip");
    ASSERT_EQ(json["steps"].size(), 2U);
    EXPECT_EQ(json["steps"][1]["path"], "leaf/rim");
    EXPECT_EQ(json["steps"][1]["line"], 7);
    // What it says can be kept.
    EXPECT_EQ(run_program("keep " + file + " " + json["path"].get<std::string>()).status, 0);
    // The document's unit counts.
    const std::string in_mm = folder.write("mm.fil", "grammar tangle\nunit mm\nstart leaf = circle(60)\n");
    EXPECT_TRUE(run_program("pick " + in_mm + " --at 59,0").out.starts_with("leaf  ("));
    EXPECT_EQ(run_program("pick " + in_mm + " --at 61,0").out, "nothing is drawn there\n");
}

TEST(PresetCommands, PickOutside) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    const Ran text = run_program("pick " + file + " --at 500,500");
    EXPECT_EQ(text.status, 0);
    EXPECT_EQ(text.out, "nothing is drawn there\n");
    EXPECT_EQ(run_program("pick " + file + " --at -500,-5e2 --json").out, "null\n");
    for (const char* point :
         {"", ",", "1", "1,", "1,2,3", "a,b", "1;2", "1e400,0", "1e300,0", "nan,0", "inf,0", "0x1,0"}) {
        const Ran ran = run_program("pick " + file + " --at" + in_quotes(point));
        EXPECT_EQ(ran.status, 2) << point;
        EXPECT_TRUE(has(ran.out, "pick.bad-point")) << ran.out;
    }
    EXPECT_EQ(run_program("pick " + file).status, 2);
    EXPECT_EQ(run_program("pick " + folder / "none.fil --at 0,0").status, 3);
    EXPECT_EQ(run_program("pick " + folder.write("wrong.fil", "grammar tangle\n") + " --at 0,0").status, 1);
}

// --- edits ---------------------------------------------------------------------------------------------------------

struct Edit {
    std::string command;    // behind the document
    std::string statement;  // what it adds at the end
};

const Edit edits[] = {
    {"set leaf/rim.distance=9", "set leaf/rim.distance = 9"},
    {"set 'leaf.rule=one_of(\"rim\")'", "set leaf.rule = one_of(\"rim\")"},
    {"set --default '**.distance=7'", "default **.distance = 7"},
    {"keep leaf/rim/in", "keep leaf/rim/in"},
    {"reroll leaf/rim", "reroll leaf/rim"},
    {"reroll leaf/rim --times 4", "reroll leaf/rim x 4"},
    {"apply 'invert()' --to leaf/rim/ring", "apply invert() to leaf/rim/ring"},
    {"apply 'edge = outline(2)' --to leaf/rim/ring --as 'a, b'", "apply edge = outline(2) to leaf/rim/ring -> a, b"},
};

// "set x=1" behind the document's name.
Ran run_edit(const std::string& command, const std::string& file, const std::string& more = "") {
    const std::size_t blank = command.find(' ');
    return run_program(command.substr(0, blank) + " " + file + command.substr(blank) + more);
}

TEST(PresetCommands, EditsAddALineAndNothingElse) {
    for (const Edit& edit : edits) {
        const TestFolder folder;
        const std::string file = folder.write("a.fil", document);
        const std::string expected = std::string(document) + edit.statement + "\n";
        const Ran printed = run_edit(edit.command, file);
        EXPECT_EQ(printed.status, 0) << edit.command;
        EXPECT_EQ(printed.out, expected);
        EXPECT_EQ(folder.read("a.fil"), document) << "the document itself stays as it is";

        const Ran written = run_edit(edit.command, file, " -o " + folder / "b.fil");
        EXPECT_EQ(written.status, 0);
        EXPECT_EQ(written.out, "");
        EXPECT_EQ(folder.read("b.fil"), expected);
        EXPECT_EQ(run_program("render " + folder / "b.fil" + " --verify -o " + folder / "b.svg").status, 0);

        const Ran json = run_edit(edit.command, file, " --json -o " + folder / "c.fil");
        EXPECT_EQ(json.status, 0);
        const auto parsed = nlohmann::json::parse(json.out);
        EXPECT_EQ(parsed["document"], "a.fil");
        ASSERT_EQ(parsed["edits"].size(), 1U);
        EXPECT_EQ(parsed["edits"][0], edit.statement);
        EXPECT_EQ(parsed["text"], expected);
        EXPECT_EQ(folder.read("c.fil"), expected);

        EXPECT_EQ(run_edit(edit.command, file, " -o " + file).status, 0);
        EXPECT_EQ(folder.read("a.fil"), expected) << "in place where that is asked for";
    }
}

TEST(PresetCommands, EditsKeepLineEnds) {
    for (const Edit& edit : edits) {
        const TestFolder folder;
        std::string windows = document;
        for (std::size_t i = 0; (i = windows.find('\n', i)) != std::string::npos; i += 2) windows.insert(i, "\r");
        const std::string crlf = folder.write("crlf.fil", windows);
        ASSERT_EQ(run_edit(edit.command, crlf, " -o " + crlf).status, 0);
        EXPECT_EQ(folder.read("crlf.fil"), windows + edit.statement + "\r\n");

        const std::string without = std::string(document).substr(0, std::string(document).size() - 1);
        const std::string open = folder.write("open.fil", without);
        ASSERT_EQ(run_edit(edit.command, open, " -o " + open).status, 0);
        EXPECT_EQ(folder.read("open.fil"), without + "\n" + edit.statement + "\n");

        const std::string marked = folder.write("bom.fil", std::string("\xEF\xBB\xBF") + document);
        ASSERT_EQ(run_edit(edit.command, marked, " -o " + marked).status, 0);
        EXPECT_EQ(folder.read("bom.fil"), std::string("\xEF\xBB\xBF") + document + edit.statement + "\n");
    }
}

TEST(PresetCommands, EditsOfWhatIsThereChangeItInPlace) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    const auto edit = [&](const std::string& command) {
        EXPECT_EQ(run_edit(command, file, " -o " + file).status, 0) << command;
        return folder.read("a.fil");
    };
    std::string gap = document;
    gap.replace(gap.find("3..6"), 4, "4.5");
    EXPECT_EQ(edit("set gap=4.5"), gap) << "the comment behind the value stays";
    EXPECT_EQ(edit("set leaf/rim.distance=9"), gap + "set leaf/rim.distance = 9\n");
    EXPECT_EQ(edit("set leaf/rim.distance=8..9"), gap + "set leaf/rim.distance = 8..9\n");
    EXPECT_EQ(edit("keep leaf/rim"), gap + "set leaf/rim.distance = 8..9\nkeep leaf/rim\n");
    EXPECT_EQ(edit("keep leaf/rim"), gap + "set leaf/rim.distance = 8..9\nkeep leaf/rim\n");
    EXPECT_EQ(edit("keep --remove leaf/rim"), gap + "set leaf/rim.distance = 8..9\n");
    EXPECT_EQ(edit("reroll leaf"), gap + "set leaf/rim.distance = 8..9\nreroll leaf\n");
    EXPECT_EQ(edit("reroll leaf --times 3"), gap + "set leaf/rim.distance = 8..9\nreroll leaf x 4\n");
    const Ran several = run_edit("set gap=5 leaf/rim.distance=7 leaf.rule=rim --json", file);
    EXPECT_EQ(nlohmann::json::parse(several.out)["edits"].size(), 3U);
}

TEST(PresetCommands, WrongEditsLeaveOutputsAlone) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    folder.write("old.fil", "old");
    const struct {
        const char* command;
        const char* said;  // a part of it
    } wrong[] = {
        {"set leaf/rim.distance=-9", "language.out-of-range"},
        {"set leaf/rim.distance=wide", "language.unknown-name"},
        {"set leaf/rom.distance=9", "the nearest that is possible is leaf/rim.distance"},
        {"set gap=5 leaf/rom.distance=9", "the edit is: set leaf/rom.distance = 9"},
        {"set gapp=5", "did you mean 'gap'?"},
        {"set leaf=5", "preset.unknown-name"},
        {"set leaf.rule=edge", "preset.unknown-rule"},
        {"set 'leaf/rim.distance=5; seed 9'", "language.unexpected-token"},
        {"set 'gap=5 in 2..9'", "language."},
        {"set 'leaf rim.distance=5'", "language."},
        {"keep leaf/rom", "the nearest that is possible is leaf/rim"},
        {"keep leaf/rim.", "language.missing-name"},
        {"keep leaf/rim --remove", "edit.no-such-keep"},
        {"reroll leaf/rom", "preset.impossible-path"},
        {"apply 'invrt()' --to leaf/rim/in", "did you mean 'invert'?"},
        {"apply 'invert()' --to leaf/rim", "apply.not-a-group"},
        {"apply 'invert(' --to leaf/rim/in", "language.unclosed-bracket"},
        {"apply 'invert() to leaf' --to leaf/rim/in", "language.unexpected-token"},
        {"apply 'invert()' --to 'leaf/rim/in, leaf'", "language.unexpected-token"},
        {"apply 'invert()' --to leaf/rim/in --as 'a b'", "language.unexpected-token"},
    };
    for (const auto& edit : wrong) {
        const Ran ran = run_edit(edit.command, file, " -o " + folder / "old.fil");
        EXPECT_EQ(ran.status, 1) << edit.command << "\n" << ran.out;
        EXPECT_TRUE(has(ran.out, edit.said)) << edit.command << "\n" << ran.out;
        EXPECT_EQ(run_edit(edit.command, file, " --json -o " + file).status, 1);
        EXPECT_EQ(run_edit(edit.command, file).status, 1);
    }
    EXPECT_EQ(folder.read("old.fil"), "old");
    EXPECT_EQ(folder.read("a.fil"), document);
}

TEST(PresetCommands, EditStatuses) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    for (const char* usage : {"set", "set gap", "set =5", "set gap=", "keep", "reroll", "reroll leaf --times 0",
                              "reroll leaf --times 1000001", "apply 'invert()'", "apply --to leaf"}) {
        EXPECT_EQ(run_edit(std::string(usage) + " ", file).status, 2) << usage;
    }
    EXPECT_EQ(run_edit("keep leaf", folder / "none.fil").status, 3);
    EXPECT_EQ(run_edit("keep leaf", file, " -o " + folder / "no/such/a.fil").status, 3);
    EXPECT_EQ(run_edit("keep leaf", file, " -o " + folder / ".").status, 3);
    EXPECT_EQ(run_edit("keep leaf", folder.write("wrong.fil", "grammar tangle\nstart leaf = cirle(9)\n")).status, 1);
    const Ran many = run_edit("reroll leaf --times 1000000",
                              folder.write("many.fil", std::string(document) + "reroll leaf x 1000000000\n"));
    EXPECT_EQ(many.status, 1) << many.out;
    EXPECT_TRUE(has(many.out, "edit.too-many-rerolls")) << many.out;
}

TEST(PresetCommands, EditsNeverOverwriteWhatTheDocumentReads) {
    const TestFolder folder;
    const std::string inner = "grammar tangle\nstart ground = host()\nregular_split(line, 8) : ground -> bar\n";
    folder.write("in.fil", inner);
    const std::string file =
        folder.write("a.fil", "grammar tangle\nstart leaf = circle(60)\nembed(\"in.fil\") : leaf -> below\n");
    const Ran ran = run_edit("keep leaf", file, " -o " + folder / "in.fil");
    EXPECT_EQ(ran.status, 2) << ran.out;
    EXPECT_EQ(folder.read("in.fil"), inner);
}

// --- variations ----------------------------------------------------------------------------------------------------

TEST(PresetCommands, VariationsDrawASheet) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    for (const char* options :
         {"", " --count 1", " --count 12", " --distance 0", " --distance 1", " --count 2 --first 1000000"}) {
        const Ran ran = run_program("variations " + file + options + " -o " + folder / "sheet.svg");
        EXPECT_EQ(ran.status, 0) << options << ran.out;
        EXPECT_TRUE(has(folder.read("sheet.svg"), "<svg")) << options;
        fs::remove(folder / "sheet.svg");
    }
    EXPECT_EQ(run_program("variations " + file + " --count 2 -o " + folder / "sheet.png").status, 0);
    EXPECT_EQ(folder.read("sheet.png").substr(1, 3), "PNG");
    ASSERT_EQ(run_program("variations " + file + " --count 3 -o " + folder / "three.svg").status, 0);
    ASSERT_EQ(run_program("variations " + file + " --count 3 --threads 3 -o " + folder / "again.svg").status, 0);
    EXPECT_EQ(folder.read("three.svg"), folder.read("again.svg"));
    EXPECT_EQ(folder.read("a.fil"), document);
}

TEST(PresetCommands, ATakenVariationIsADocument) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    const std::string before = run_program("choices " + file).out;
    for (const char* options :
         {"--take 1", "--take 7", "--take 7 --distance 0", "--take 7 --distance 1", "--take 1000000"}) {
        const Ran ran = run_program("variations " + file + " " + options + " -o " + folder / "taken.fil");
        EXPECT_EQ(ran.status, 0) << options << ran.out;
        EXPECT_TRUE(folder.read("taken.fil").starts_with(document)) << "only re-rolls behind it";
        EXPECT_NE(run_program("choices " + folder / "taken.fil").out, before) << options;
        const Ran rendered = run_program("render " + folder / "taken.fil --strict --verify -o " + folder / "taken.svg");
        EXPECT_EQ(rendered.status, 0) << options << rendered.out;
    }
}

TEST(PresetCommands, VariationsStatuses) {
    const TestFolder folder;
    const std::string file = folder.write("a.fil", document);
    const std::string sheet = " -o " + folder / "sheet.svg";
    for (const char* usage : {" --count 0", " --count 1001", " --distance -0.1", " --distance 1.1", " --take 0",
                              " --count x", " --first 0"}) {
        EXPECT_EQ(run_program("variations " + file + usage + sheet).status, 2) << usage;
    }
    EXPECT_EQ(run_program("variations " + file).status, 2);
    EXPECT_EQ(run_program("variations " + file + " -o " + folder / "sheet.xyz").status, 2);
    EXPECT_EQ(run_program("variations " + file + " --take 1 -o " + file).status, 2);
    EXPECT_EQ(run_program("variations " + folder / "none.fil" + sheet).status, 3);
    EXPECT_EQ(run_program("variations " + file + " -o " + folder / "no/such/sheet.svg").status, 3);
    const std::string pinned =
        std::string(document) + "set **.distance = 9\nset **.offset = 9\nset **.angle = 9\nset gap = 4\n";
    for (const std::string& fixed : {std::string(plain), pinned, std::string(document) + "keep **\n",
                                     std::string(document) + "set **.is_random = false\n"}) {
        for (const char* take : {"", " --take 2"}) {
            const Ran ran = run_program("variations " + folder.write("fixed.fil", fixed) + take + sheet);
            EXPECT_EQ(ran.status, 1) << fixed << ran.out;
            EXPECT_TRUE(has(ran.out, "variations.nothing-free")) << ran.out;
        }
    }
    EXPECT_FALSE(folder.has("sheet.svg"));
    EXPECT_EQ(folder.read("a.fil"), document);
}

}  // namespace
}  // namespace filigree
