// For tests: right documents as random text, with blanks, comments and line ends wherever they may stand, and
// random damage to a text.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "base/test_cases.h"

namespace filigree {

struct RandomDocument {
    std::string text;
    std::size_t statements = 0;
    std::vector<std::string> parameters;
};

class RandomText : public CaseRandom {
public:
    using CaseRandom::CaseRandom;

    bool chance(std::uint32_t one_in) { return below(one_in) == 0; }
    std::string pick(std::initializer_list<std::string_view> options) {
        return std::string(options.begin()[below(static_cast<std::uint32_t>(options.size()))]);
    }

    RandomDocument document() {
        RandomDocument result;
        end_ = chance(3) ? "\r\n" : "\n";
        if (chance(5)) result.text = "\xEF\xBB\xBF";
        const std::uint32_t count = below(12);
        if (chance(3)) add(result, "filigree" + gap() + "1");
        if (chance(2)) add(result, "seed" + gap() + std::to_string(bits() >> below(64)));
        if (!chance(5)) add(result, "grammar" + gap() + "tangle");
        if (chance(3)) add(result, "unit" + gap() + pick({"mm", "cm", "m", "in", "pt", "px"}));
        for (std::uint32_t i = 0; i < count; ++i) statement(result, 2);
        if (chance(3)) result.text += " # the end";
        return result;
    }

    // One of a shape grammar.
    RandomDocument shape_document() {
        RandomDocument result;
        end_ = chance(3) ? "\r\n" : "\n";
        if (chance(3)) add(result, "seed" + gap() + std::to_string(bits() >> below(64)));
        add(result, "grammar" + gap() + "shape");
        for (std::uint32_t count = below(12); count > 0; --count) shape_statement(result);
        if (chance(3)) result.text += " # the end";
        return result;
    }

    // A path; of a group alone where it has no parameter.
    std::string path(bool may_have_parameter) {
        std::string result = chance(6) ? pick({"**", "*"}) : path_name();
        while (!chance(3)) result += "/" + (chance(4) ? pick({"*", "**", "2", "5,2,2", "007"}) : path_name());
        if (may_have_parameter && chance(2)) {
            result += "." + name();
            if (chance(3)) result += pick({"~1", "~2", "~17"});
        }
        return result;
    }

    // A value of a statement: line ends only inside brackets.
    std::string expression(int depth) {
        if (chance(8))
            return range(depth) + gap() + "?" + blank() + expression(depth - 1) + blank() + ":" + blank() +
                   range(depth);
        if (chance(12)) return range(depth) + gap() + "in" + gap() + range(depth);
        return range(depth);
    }
    std::string range(int depth) {
        if (chance(8)) return pick({"25..60", "1.5..2.5", "-3..3", ".5...75", "5deg..0.5turn"});
        if (chance(8)) return operation(depth, 1) + gap() + ".." + gap() + operation(depth, 1);
        return operation(depth, 1);
    }

private:
    std::string blank() { return chance(2) ? "" : gap(); }
    std::string gap() { return pick({" ", "  ", "\t", " \t "}); }
    // Inside brackets.
    std::string room() { return chance(6) ? blank() + pick({"", " # a note", " #"}) + end_ + blank() : blank(); }

    std::string name() {
        return pick({"gap", "in", "set", "to", "x3", "system", "when", "weight", "x", "step", "start", "p\xC3\xA9tale",
                     "p\x65\xCC\x81tale", "_a1", "\xE8\x91\x89", "margin", "true_", "mm"});
    }
    std::string tag() {
        return pick({"leaf", "in", "out", "0_medium_poly", "2in", "5deg", "1e5", "when", "weight", "match", "_x", "__",
                     "bl\xC3\xA4tt", "seed", "fit", "keep", "operator", "to", "apply"});
    }
    std::string path_name() {
        std::string result = tag();
        if (chance(5)) result += pick({"#2", "#1", "#12"});
        if (chance(5)) result += pick({"[1]", "[3,1]", "[2,3,17]"});
        return result;
    }
    std::string number() {
        return pick({"0", "12", "3.5mm", "1.2m", "30deg", "40%", "1e-3", ".5", "5.", "2in", "1e5", "0.25turn", "4GB",
                     "1E+2px", "007", "3s", "2.5e3cm"});
    }
    std::string text() {
        return pick({"\"\"", "\"leaf.svg\"", "\"# \\\" ; ) } \\\\\"", "\"\\n\\u{1F33F}\"", "\"->\""});
    }

    std::string call(int depth) {
        std::string result = name() + blank() + "(" + room();
        const std::uint32_t count = below(4);
        for (std::uint32_t i = 0; i < count; ++i) {
            if (i > 0) result += "," + room();
            if (chance(3)) result += name() + room() + ":" + room();
            result += expression(depth - 1) + room();
        }
        return result + ")";
    }
    std::string primary(int depth) {
        switch (depth <= 0 ? below(5) : below(9)) {
            case 0:
                return number();
            case 1:
                return name();
            case 2:
                return text();
            case 3:
                return pick({"#a03", "#A03F", "#1a1a1a", "#00000080"});
            case 4:
                return pick({"true", "false", "page.width", "page . height"});
            case 5:
                return "(" + room() + expression(depth - 1) + room() + ")";
            case 6:
                return "(" + room() + expression(depth - 1) + room() + "," + room() + expression(depth - 1) + ")";
            case 7: {
                std::string list = "[" + room();
                const std::uint32_t count = below(4);
                for (std::uint32_t i = 0; i < count; ++i)
                    list += (i > 0 ? "," : "") + room() + expression(depth - 1) + room();
                return list + "]";
            }
            default:
                return call(depth);
        }
    }
    std::string operation(int depth, int tier) {
        if (tier > 5) return (chance(6) ? pick({"-", "!", "- -"}) : "") + primary(depth);
        std::string result = operation(depth, tier + 1);
        while (chance(7)) {
            const std::string sign = tier == 1   ? "||"
                                     : tier == 2 ? "&&"
                                     : tier == 3 ? pick({"==", "!=", "<", "<=", ">", ">="})
                                     : tier == 4 ? pick({"+", "-"})
                                                 : pick({"*", "/", "&"});
            result += gap() + sign + gap() + operation(depth, tier + 1);
        }
        return result;
    }

    std::string outputs() {
        const bool has_brackets = chance(2);
        std::string result = has_brackets ? "[" : "";
        const std::uint32_t count = 1 + below(3);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::string space = has_brackets ? room() : blank();
            if (i > 0) result += "," + space;
            switch (below(5)) {
                case 0:
                    result += "<" + blank() + tag() + blank() + ">";
                    break;
                case 1:
                    result += "<>";
                    break;
                case 2:
                    result += "_";
                    break;
                case 3:
                    result += name() + blank() + ":" + blank() + tag();
                    break;
                default:
                    result += tag();
                    break;
            }
            if (has_brackets) result += room();
        }
        return result + (has_brackets ? "]" : "");
    }
    std::string operator_call() {
        std::string result = pick({"outline", "place", "regular_split", "regularSplit"}) + blank() + "(" + room();
        const std::uint32_t count = below(3);
        for (std::uint32_t i = 0; i < count; ++i) result += (i > 0 ? "," : "") + room() + expression(2) + room();
        return result + ")";
    }
    std::string rule() {
        std::string result = chance(3) ? name() + blank() + "=" + blank() : "";
        result += operator_call() + blank() + ":" + blank() + tag();
        if (chance(3)) result += gap() + "when" + gap() + expression(1);
        if (chance(3)) result += gap() + "weight" + gap() + expression(1);
        if (!chance(5)) result += gap() + pick({"->", "\xE2\x86\x92"}) + blank() + outputs();
        return result;
    }
    std::string style() {
        std::string result = "style" + gap() + (chance(4) ? "*" : tag());
        while (chance(3)) result += blank() + "," + blank() + tag();
        if (chance(3)) result += gap() + "when" + gap() + expression(1);
        result += gap() + "{";
        while (!chance(3)) {
            result += room() + pick({"fill", "stroke-width", "pen", "in"}) + blank() + ":" + blank() + expression(1) +
                      blank();
            result += chance(2) ? ";" : " # a note" + end_;
        }
        return result + room() + "}";
    }
    std::string preset() {
        std::string result = pick({"set", "default"}) + gap() + path(true) + blank() + "=" + blank() + expression(2);
        if (chance(3)) result += gap() + "when" + gap() + expression(1);
        return result;
    }
    std::string apply() {
        std::string result = "apply" + gap() + (chance(2) ? name() + blank() + "=" + blank() : "");
        result += operator_call() + gap() + "to" + gap() + path(false);
        while (chance(3)) result += blank() + "," + gap() + path(false);
        if (chance(2)) result += blank() + pick({"->", "\xE2\x86\x92"}) + blank() + outputs();
        return result;
    }
    std::string definition_parameters() {
        std::string result = "(" + room();
        const std::uint32_t count = below(4);
        for (std::uint32_t i = 0; i < count; ++i) {
            if (i > 0) result += "," + room();
            result += name() + room();
            if (chance(2)) result += "=" + room() + expression(1) + room();
        }
        return result + ")";
    }
    std::string block(bool has_rules_alone, int depth) {
        RandomDocument inner;
        inner.text = chance(2) ? end_ : " ";
        if (!has_rules_alone && chance(2)) add(inner, "grammar" + gap() + "tangle");
        if (!has_rules_alone && chance(3)) add(inner, "seed" + gap() + std::to_string(below(100)));
        if (!has_rules_alone && chance(3)) add(inner, "unit" + gap() + pick({"mm", "cm"}));
        for (std::uint32_t count = below(4); count > 0; --count) {
            if (has_rules_alone) {
                add(inner, rule());
            } else {
                statement(inner, depth - 1);
            }
        }
        if (chance(2)) inner.text += blank() + rule() + blank();
        return "{" + inner.text + "}";
    }
    std::string system(int depth) {
        const std::string parameters = chance(2) ? blank() + definition_parameters() : "";
        return "system" + gap() + name() + parameters + blank() + block(false, depth);
    }
    std::string macro() {
        std::string result = "operator" + gap() + name() + blank() + definition_parameters() + blank();
        if (chance(2)) {
            result += pick({"->", "\xE2\x86\x92"}) + blank() + tag() + blank();
            while (chance(3)) result += "," + blank() + tag() + blank();
        }
        return result + block(true, 0);
    }
    void statement(RandomDocument& into, int depth) {
        switch (below(depth > 0 ? 19 : 17)) {
            case 0:
            case 1: {
                const std::string parameter = "p" + std::to_string(into.parameters.size());
                std::string text = "param" + gap() + parameter + blank() + "=" + blank() + range(2);
                if (chance(2)) text += gap() + "in" + gap() + range(1);
                if (chance(3)) text += gap() + "step" + gap() + expression(1);
                if (chance(3)) text += gap() + "\"help\"";
                into.parameters.push_back(parameter);
                return add(into, text);
            }
            case 2:
                return add(into, "let" + gap() + name() + blank() + "=" + blank() + expression(2));
            case 3:
                return add(into, "page" + gap() +
                                     pick({"fit", "a4", "tile 10mm x 20mm", "210mm x 297mm", "a4 margin 10mm",
                                           "fit margin 1cm", "(3 + 4) x gap margin 2"}));
            case 4:
                return add(into, "limit" + gap() + name() + gap() + expression(1));
            case 5:
                return add(into, "start" + gap() + tag() + blank() + "=" + blank() + expression(2));
            case 6:
                return add(into, "start" + gap() + "from" + blank() + text());
            case 7:
                return add(into, style());
            case 8:
                return add(into, "palette" + gap() + name() + blank() + "=" + blank() + "[#a03," + room() + "#000]");
            case 9:
                return add(into, pick({"symmetry p4m", "resolution 0.25", "resolution (1 / 4)"}));
            case 10:
                return add(into, preset());
            case 11:
                return add(into, "keep" + gap() + path(true));
            case 12:
                return add(into, "reroll" + gap() + path(true) +
                                     (chance(2) ? gap() + pick({"x 2", "x3", "x\t1000000000", "x 01"}) : ""));
            case 13:
                return add(into, apply());
            case 17:
                return add(into, system(depth));
            case 18:
                return add(into, macro());
            default:
                return add(into, rule());
        }
    }

    std::string rule_name() { return pick({"slide", "back", "when", "weight", "at", "p\x65\xCC\x81tale", "x3", "_"}); }
    std::string arrow() { return blank() + pick({"->", "\xE2\x86\x92"}) + blank(); }
    // In a random order, each with some chance.
    std::string clauses(std::vector<std::string> all) {
        std::string result;
        while (!all.empty()) {
            const std::uint32_t which = below(static_cast<std::uint32_t>(all.size()));
            if (chance(3)) result += gap() + all[which];
            all.erase(all.begin() + which);
        }
        return result;
    }
    std::string shape(int depth) {
        if (depth <= 0)
            return pick({"petal", "empty", "circle(5)", "path(\"M 0 0 H 1\")", "point((0, 0), \"a\")", "many(2)"});
        switch (below(5)) {
            case 0:
                return "(" + room() + shape(depth - 1) + gap() + pick({"+", "-", "&"}) + room() + shape(depth - 1) +
                       ")";
            case 1:
                return pick({"translate(1, 2)", "rotate(90)", "scale(2, (3, 3))", "mirror(45)"}) + blank() + "*" +
                       blank() + shape(depth - 1);
            case 2:
                return shape(depth - 1) + gap() + pick({"+", "-", "&"}) + gap() + shape(depth - 1);
            case 3:
                return "(" + expression(depth) + ")";
            default:
                return shape(0);
        }
    }
    std::string shape_rule() {
        const std::string end = chance(4) ? pick({" # goes on", ""}) + end_ + blank() : "";
        std::string result = rule_name() + blank() + "=" + blank() + shape(2) + arrow() + end + shape(2);
        return result +
               clauses({"match" + gap() + pick({"isometry", "affine", "visual(0.5)"}), "weight" + gap() + expression(1),
                        "priority" + gap() + expression(1), "unless" + gap() + shape(1),
                        "unless" + gap() + "box(0, 0, 3, 3)", "when" + gap() + expression(1)});
    }
    void shape_statement(RandomDocument& into) {
        switch (below(11)) {
            case 0:
                return add(into, "start" + gap() + tag() + blank() + "=" + blank() + shape(3));
            case 10:
                return add(into, "back" + gap() + "to" + gap() + pick({"first", "start"}));
            case 1:
                return add(into, "let" + gap() + name() + blank() + "=" + blank() + shape(3));
            case 2:
                return add(into, rule_name() + blank() + "=" + blank() +
                                     pick({"inverse(slide)", "mirror( slide, 45 )", "mirror(slide,\n angle: gap)"}));
            case 3:
                return add(into, "rules" + gap() + "from" + blank() + text());
            case 4:
            case 5:
                return add(into, "apply" + gap() + (chance(3) ? "first" + blank() + "=" + blank() : "") + rule_name() +
                                     clauses({"angle" + gap() + expression(1), "mirrored"}) + gap() + "at" + gap() +
                                     expression(1) +
                                     clauses({"scale" + gap() + expression(1), "orbit"}));
            case 6:
                return add(into, pick({"steps", "tolerance", "match", "choose"}) + gap() + expression(1));
            case 7:
                return add(into, "show" + gap() + pick({"points", "matches(slide)"}) + blank() +
                                     (chance(2) ? "," + blank() + "film(columns: 4)" : ""));
            case 8:
                return add(into,
                           pick({"match = petal -> lens", "start=petal->empty", "rules = empty \xE2\x86\x92 petal"}));
            default:
                return add(into, shape_rule());
        }
    }
    void add(RandomDocument& into, const std::string& statement) {
        ++into.statements;
        const bool at_line_start = into.text.empty() || into.text.back() == '\n' || into.text == "\xEF\xBB\xBF";
        while (at_line_start && chance(5))
            into.text += pick({"# a comment", "## Head", "", "  # seed 5; (", "####", "#"}) + end_;
        into.text += blank() + statement;
        if (chance(5)) {
            into.text += blank() + ";" + (chance(2) ? blank() : end_);
        } else {
            into.text += (chance(4) ? pick({" # behind", "\t#"}) : blank()) + end_;
        }
    }

    std::string end_ = "\n";
};

// Bytes removed, doubled, swapped for others that mean something, or cut off.
inline std::string damaged(std::string text, RandomText& random) {
    const std::uint32_t changes = 1 + random.below(4);
    for (std::uint32_t i = 0; i < changes && !text.empty(); ++i) {
        const std::uint32_t at = random.below(static_cast<std::uint32_t>(text.size()));
        switch (random.below(5)) {
            case 0:
                text.erase(at, 1 + random.below(6));
                break;
            case 1:
                text.insert(at, text.substr(random.below(static_cast<std::uint32_t>(text.size())), random.below(20)));
                break;
            case 2:
                text.resize(at);
                break;
            case 3:
                text.insert(at, random.pick({"(",  ")",        "[",    "]",      "{",          "}",    "\"", "#",  ";",
                                             "\n", "->",       "=",    ",",      ":",          "<",    ">",  "..", "\\",
                                             "%",  "\xC2\xA0", "?",    "\r",     "9",          "when", "in", "_",  "/",
                                             "**", "~",        "set ", "apply ", "system a {", " to ", "#2"}));
                break;
            default:
                text[at] = static_cast<char>(random.below(256));
                break;
        }
    }
    return text;
}

}  // namespace filigree
