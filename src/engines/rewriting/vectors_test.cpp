// The words of published and worked examples, symbol by symbol: tests/data/rewriting_vectors.json.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "engines/rewriting/derive.h"
#include "engines/rewriting/pattern.h"
#include "engines/rewriting/turtle.h"
#include "language/parse.h"

namespace filigree::rewriting {
namespace {

using nlohmann::json;

json rows_of_kind(std::string_view kind) {
    std::ifstream file(FILIGREE_SOURCE_DIR "/tests/data/rewriting_vectors.json");
    json rows = json::array();
    for (json& row : json::parse(file)) {
        if (row["kind"] != kind) continue;
        json said = json::object();
        for (auto& [name, value] : row.items()) {
            if (!value.is_null()) said[name] = std::move(value);
        }
        rows.push_back(std::move(said));
    }
    return rows;
}

const json& part_of(const json& row, const char* name) {
    static const json none = json::object();
    return row.contains(name) ? row[name] : none;
}

Pattern pattern_of(const std::string& text, bool free_braces = false) {
    Result<Pattern> pattern = read_pattern(text, {}, free_braces);
    EXPECT_TRUE(pattern) << text;
    return pattern ? *pattern : Pattern{};
}
char32_t letter_of(const std::string& text) { return letters_of(text).at(0); }

// array[3][9] or words.
Successor successor_of(const std::string& text) {
    Successor successor;
    if (text.rfind("array[", 0) != 0) {
        successor.pattern = pattern_of(text);
        return successor;
    }
    successor.kind = Successor::Kind::cell;
    successor.array = "array";
    for (std::size_t open = text.find('['); open != std::string::npos; open = text.find('[', open + 1)) {
        successor.indexes.push_back(*parse_expression(text.substr(open + 1, text.find(']', open) - open - 1)));
    }
    return successor;
}

// "0..85 T+b"
Lookup::Row row_of(const std::string& text) {
    const std::size_t dots = text.find(".."), blank = text.find(' ');
    return {std::stod(text), std::stod(text.substr(dots + 2)), pattern_of(text.substr(blank + 1)), {}};
}

// The greys of a picture, and the rule of i by their brightness.
void add_image(Grammar& grammar, const json& said) {
    Map map;
    map.name = "image";
    ColourImage image;
    for (const json& row : said["rows_top_to_bottom"]) {
        ++image.height;
        image.width = static_cast<std::uint32_t>(row.size());
        for (const std::uint8_t level : row) image.pixels.push_back({level, level, level});
    }
    map.cells = std::move(image);
    map.x = said["over"][0];
    map.y = said["over"][1];
    map.width = said["over"][2];
    map.height = said["over"][3];
    grammar.maps.push_back(std::move(map));
    Rule rule;
    rule.letter = U'i';
    rule.successors.emplace_back();
    rule.successors[0].kind = Successor::Kind::lookup;
    rule.successors[0].lookup.map = "image";
    EXPECT_EQ(said["channel"], "L");
    for (const json& row : said["rules"]) rule.successors[0].lookup.rows.push_back(row_of(row));
    grammar.systems[0].rules.push_back(std::move(rule));
}

void add_rule(System& system, const std::string& letter, const std::string& text, std::uint32_t first = 1,
              std::uint32_t last = every_iteration, const ExpressionPtr& loop = nullptr) {
    Rule rule;
    rule.letter = letter_of(letter);
    rule.first = first;
    rule.last = last;
    rule.loop = loop;
    rule.successors.push_back(successor_of(text));
    system.rules.push_back(std::move(rule));
}

void add_rules(System& system, const json& rules) {
    for (const auto& [letter, said] : rules.items()) {
        if (said.is_string()) add_rule(system, letter, said);
        if (said.is_object()) {
            for (const auto& [iteration, text] : said.items()) {
                const auto only = static_cast<std::uint32_t>(std::stoul(iteration));
                add_rule(system, letter, text, only, only);
            }
        }
        if (said.is_array()) {
            for (const json& row : said) {
                add_rule(system, letter, row[0], 1, every_iteration, *parse_expression(row[1].dump()));
            }
        }
    }
}

Grammar grammar_of(const json& row) {
    Grammar grammar;
    grammar.draws = DrawMode::position;
    if (row.contains("array")) {
        Array array{"array", {10, 10}, std::vector<Pattern>(100), OutOfRange::error};
        for (const auto& [place, text] : row["array"].items()) {
            const auto cell = static_cast<std::size_t>((place[1] - '0') * 10 + (place[4] - '0'));
            array.cells[cell] = pattern_of(text);
        }
        grammar.arrays.push_back(std::move(array));
    }
    for (const auto& [name, value] : part_of(row, "registers").items()) {
        grammar.registers.push_back({name, value});
    }
    for (const auto& [letter, said] : part_of(row, "systems").items()) {
        System inner;
        inner.letter = letter_of(letter);
        inner.axiom = pattern_of(said["axiom"]);
        inner.iterations = said["iterations"];
        add_rules(inner, said["rules"]);
        grammar.systems[0].roles.subsystems += inner.letter;
        grammar.systems.push_back(std::move(inner));
    }
    System& system = grammar.systems[0];
    system.axiom = pattern_of(row["axiom"]);
    add_rules(system, part_of(row, "rules"));
    for (const auto& [iteration, target] : part_of(row, "goto").items()) {
        Rule rule;
        rule.letter = U'r';
        rule.first = rule.last = static_cast<std::uint32_t>(std::stoul(iteration));
        rule.successors.emplace_back();
        rule.successors[0].kind = Successor::Kind::jump;
        rule.successors[0].target = letter_of(target[0]);
        rule.successors[0].target_iteration = target[1];
        system.rules.push_back(std::move(rule));
    }
    for (const auto& [letter, said] : part_of(row, "macros").items()) {
        system.macros.push_back({letter_of(letter), said["min"], said["max"],
                                 letters_of(said["letters"].get<std::string>()), said.value("unique", false)});
        system.roles.macros += letter_of(letter);
    }
    for (const auto& [letter, by] : part_of(row, "gain").items()) {
        system.gains.push_back({letter_of(letter), by});
    }
    if (row.contains("image")) add_image(grammar, row["image"]);
    return grammar;
}

TEST(Vectors, WordsOfGdesign) {
    std::size_t rows = 0;
    for (const json& row : rows_of_kind("gdesign")) {
        if (row.contains("formula")) continue;  // of the turtle
        SCOPED_TRACE(row["name"].get<std::string>());
        ++rows;
        const Grammar grammar = grammar_of(row);
        DeriveOptions options;
        options.seed = row.value("seed", 0);
        options.with_ages = true;
        options.positions = [](const Derivation& at) {
            TurtleSettings turtle;
            turtle.letters = {{U'i', Act::nothing}};
            return symbol_positions(at.word, at.alphabet, turtle);
        };
        Result<Derivation> derivation = begin(grammar, options);
        ASSERT_TRUE(derivation);
        const json ages = row.value("ages", json());
        for (std::size_t n = 0; n < row["steps"].size(); ++n) {
            if (n > 0) {
                const std::optional<Diagnostic> problem = step(*derivation, grammar, options, {});
                ASSERT_FALSE(problem) << problem->message;
            }
            const json& wanted = row["steps"][n];
            const std::string text = to_text(derivation->word, derivation->alphabet);
            if (wanted.is_string()) {
                EXPECT_EQ(text, wanted.get<std::string>()) << "iteration " << n;
            } else {
                EXPECT_EQ(letters_of(text).size(), wanted) << "iteration " << n;
            }
            if (ages.is_array()) {
                EXPECT_EQ(json(derivation->word.ages), ages[n]) << "iteration " << n << " of " << text;
            }
        }
    }
    EXPECT_EQ(rows, 21U);
}

// Words without anything special: all letters are free.
TEST(Vectors, WordsOfOtherSystems) {
    for (const json& row : rows_of_kind("d0l")) {
        SCOPED_TRACE(row["name"].get<std::string>());
        Grammar grammar;
        System& system = grammar.systems[0];
        system.roles = {};
        for (const char32_t letter : U"qgisn\u00F1") system.roles.free(letter);
        system.axiom = pattern_of(row["axiom"], true);
        for (const auto& [letter, text] : row["rules"].items()) {
            Rule rule;
            rule.letter = letter_of(letter);
            rule.successors.emplace_back();
            rule.successors[0].pattern = pattern_of(text, true);
            system.rules.push_back(std::move(rule));
        }
        const DeriveOptions options;
        Result<Derivation> derivation = begin(grammar, options);
        ASSERT_TRUE(derivation);
        for (int n = row["n"]; n > 0; --n) ASSERT_FALSE(step(*derivation, grammar, options, {}));
        const std::string text = to_text(derivation->word, derivation->alphabet);
        EXPECT_EQ(text.size(), row["len"]);
        EXPECT_EQ(text.substr(0, 48), row["head"].get<std::string>().substr(0, 48));
    }
}

}  // namespace
}  // namespace filigree::rewriting
