// Random tangle documents for property tests: starts with holes or built-in shapes, and a grammar over a few tags
// whose rules only lead onwards, so that every derivation ends. With choices wherever the language knows them, and now
// and then a param, lets, styles, an operator of its own and a system that is embedded.
//
// Every statement stands in a line of its own. Tags of the document itself are t0, t1, ..., and no other word is like
// that.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "base/elementary.h"
#include "base/number_text.h"
#include "base/test_cases.h"

namespace filigree {

// FILIGREE_SCALE: how much coarser random documents are, so that long runs derive many small ones.
inline double document_scale() {
    const char* wanted = std::getenv("FILIGREE_SCALE");
    const double scale = wanted == nullptr ? 1 : std::strtod(wanted, nullptr);
    return scale >= 1 && scale <= 10 ? scale : 1;
}

class RandomDocument {
public:
    // `scale`: of all sizes of what is made; documents of a larger one have fewer shapes.
    explicit RandomDocument(std::uint64_t seed, double scale = 1) : random_(seed), scale_(scale) {}

    std::string text() {
        std::string all = "grammar tangle\nseed " + std::to_string(whole(1000)) + "\n";
        if (whole(4) == 0) all += "unit mm\n";
        if (whole(4) == 0) all += "resolution 0." + std::to_string(1 + whole(5)) + "px\n";
        all += "limit elements 30000\n";
        levels_ = 2 + static_cast<int>(whole(4));
        all += definitions();
        all += start();
        if (whole(3) == 0) all += system();
        if (whole(3) == 0) all += own_operator();
        for (int level = 0; level < levels_; ++level) {
            const int rules = 1 + static_cast<int>(whole(3));
            for (int r = 0; r < rules; ++r) all += rule(level);
        }
        if (whole(3) == 0) all += style();
        return all;
    }

    // One more rule for the tag of a level.
    std::string rule(int level) {
        const std::string label = whole(4) == 0 ? "label" + std::to_string(++labels_) + " = " : "";
        return joined({label, call(level), " : ", tag(level), suffix(), outputs_, "\n"});
    }

private:
    std::uint64_t whole(std::uint32_t count) { return random_.below(count); }
    double real(double low, double high) { return random_.between(low, high); }
    std::string number(double low, double high) {
        std::string text;
        append_fixed(text, real(low, high), static_cast<int>(whole(4)));
        return text;
    }
    // Parts in their order, which `+` would not draw them in with every compiler.
    static std::string joined(std::initializer_list<std::string> parts) {
        std::string all;
        for (const std::string& part : parts) all += part;
        return all;
    }
    static std::string tag(int level) { return "t" + std::to_string(level); }

    // --- what stands before the rules ---

    std::string definitions() {
        std::string all;
        if (whole(3) == 0) {
            all += "param gap = " + number(12, 25) + "px in 5px..60px\n";
            lengths_.push_back("gap");
        }
        if (whole(3) == 0) {
            all += joined({"let wide = ", number(6, 9), "px..", number(10, 20), "px\n"});
            lengths_.push_back("wide");
        }
        if (whole(4) == 0) {
            all += "let some = " + std::string(lengths_.empty() ? "9px" : lengths_.back()) + " * one_of(1, 1.5: 2)\n";
            lengths_.push_back("some");
        }
        if (whole(6) == 0) {
            all += "page 240px x 200px\n";
            lengths_.push_back("page.width / 16");
        }
        return all;
    }

    // A wobbly ring as path data; its corners are distinct and in order around a centre.
    std::string ring(double x, double y, double radius, int corners, double wobble) {
        std::string data;
        for (int i = 0; i < corners; ++i) {
            const double reach = radius * (1 + real(-wobble, wobble));
            const elementary::CosSin turn = elementary::cos_sin_degrees(360.0 * i / corners + real(-1, 1));
            data += i == 0 ? "M " : "L ";
            append_fixed(data, x + reach * turn.cos, 2);
            data += " ";
            append_fixed(data, y + reach * turn.sin, 2);
            data += " ";
        }
        return data + "Z ";
    }

    std::string start() {
        const std::string first = "start t0 = ";
        switch (whole(10)) {
            case 0:
                return joined({first, "rectangle(", number(60, 200), "px, ", number(60, 200), "px)\n"});
            case 1:
                return first + "circle(" + number(40, 100) + "px)\n";
            case 2:
                return joined({first, "star(", std::to_string(3 + whole(9)), ", ", number(60, 110), "px, ",
                               number(20, 50), "px)\n"});
            case 3:  // overlapping starts: the later covers the earlier
                return joined({first, "circle(60px)\nstart t", std::to_string(whole(2)),
                               " = rectangle(100px, 50px, at: (", number(-40, 40), "px, ", number(-40, 40), "px))\n"});
            case 4:  // self-crossing outlines and the even-odd rule
                return joined({first, "path(\"", ring(0, 0, 80, 5 + static_cast<int>(whole(20)), 0.9),
                               ring(20, 10, 60, 7, 0.8), "\")\n"});
            case 5:
                return joined(
                    {first, "ellipse(", number(40, 60), "px..", number(61, 110), "px, ", number(40, 90), "px)\n"});
            case 6:
                return joined({first, "rectangle(60px, 90px)\nstart t1 = circle(", number(20, 40),
                               "px..45px, at: (80px, 0px))\nstart t0 = rectangle(40px, 90px, at: (-70px, 0px))\n"});
            default: {
                const double reach = real(60, 110);
                std::string data = ring(0, 0, reach, 6 + static_cast<int>(whole(60)), 0.25);
                const int holes = static_cast<int>(whole(4));
                for (int h = 0; h < holes; ++h) {
                    const elementary::CosSin turn = elementary::cos_sin_degrees(120.0 * h);
                    const double radius = real(5, 12);
                    data += ring(24 * turn.cos, 24 * turn.sin, radius, 3 + static_cast<int>(whole(12)), 0.3);
                }
                return first + "path(\"" + data + "\")\n";
            }
        }
    }

    // A document that grows in others: either in the host's shape or, now and then, on a page that is laid over it.
    std::string system() {
        has_system_ = true;
        static constexpr const char* starts[] = {
            "start ground = host()",
            "start ground = host(fit: keep)",
            "page 60px x 60px; start ground = host(fit: cover)",
            "page 90px x 60px; start ground = host(fit: contain)",
            "start ground = rectangle(40px, 40px)",
        };
        std::string all = halves("system weave(thread = ", 6, "..", 20, ") { grammar tangle; ");
        all += starts[whole(5)];
        all += "; let knot = 0.5..0.9";
        if (whole(2) == 0) all += "; ungroup() : ground -> ground_2; outline(thread / 5) : ground -> core, edge";
        all += "; regular_split(line, thread, angle: 0..90, dual: yes) : ground -> strands";
        all += "; cords = outline(thread * knot / 4) : strands weight 1..2 -> core, edge";
        all += "; invert(one_of(even, odd)) : strands -> dark, light";
        if (whole(2) == 0) all += "; outline(" + size(2, 4) + ") : core -> inmost, edge";
        if (whole(3) == 0) all += "; style core, dark { fill: one_of(#a03020, #20a030); pen: 0.3px..0.9px }";
        if (whole(4) == 0) all += "; set ground/regular_split.angle = 30..60; reroll **/cords";
        if (whole(4) == 0)
            all += "; keep let/knot; set ground/regular_split/strands/cords.is_random = false when depth < 3";
        all += " }\n";
        has_pair_ = whole(3) == 0;
        if (has_pair_) {
            all += joined({"system pair { grammar tangle; start ground = host(); regular_split(line, ", size(20, 40),
                           ", angle: 0..180) : ground -> half; embed(weave, thread: each(8px..20px)) : half -> rest; "
                           "embed(weave) : half -> rest }\n"});
        }
        return all;
    }

    std::string own_operator() {
        has_operator_ = true;
        std::string all = halves("operator lace(width = ", 2, "..", 8, ", times = 2) -> dots, band { ");
        all += "outline(width) : whole -> inside, band";
        all += "; regular_split(line, width * times, angle: 0..180) : inside -> dots";
        if (whole(2) == 0)
            all += "; second = outline(each(width / 2..width)) : inside -> dots, ring; invert() : ring -> band";
        // What the document knows is known in its operators too.
        if (!lengths_.empty() && whole(2) == 0) all += "; outline(" + lengths_.back() + " / 4) : ring -> dots, band";
        return all + " }\n";
    }

    std::string style() {
        static constexpr const char* styles[] = {
            "style * when area > 200px * 1px { fill: one_of(#a03020, black, white: 2); pen: 0.3px..1.2px }",
            "style t1, t2 { stroke: one_of(black, #204080) }",
            "style t1 when depth > 1 { fill: #d0c0a0; pen: 0.5px }",
            "style t2 when (0..1) < 0.4 { fill: none; stroke: #204080 }",
            "style t1, t3 { wobble: 1.5px; wobble_length: 30px }",
        };
        std::string all;
        for (const char* one : styles) {
            if (whole(2) == 0) all += std::string(one) + "\n";
        }
        return all;
    }

    // --- rules ---

    std::string suffix() {
        std::string text;
        switch (whole(8)) {
            case 0:
                text += " when count < " + std::to_string(1 + whole(40));
                break;
            case 1:
                text += " when (0..1) < " + number(0.5, 1);
                break;
            default:
                break;
        }
        if (whole(5) == 0) {
            text += " weight ";
            text += whole(3) == 0 ? joined({number(0.5, 1), "..", number(2, 4)}) : number(0.5, 4);
        }
        return text;
    }

    // A length of a fixed size.
    std::string size(double low, double high) {
        std::string text;  // whole numbers now and then, but never 0
        append_fixed(text, std::max(0.25, real(low * scale_, high * scale_)),
                     whole(4) == 0 && low * scale_ > 1 ? 0 : 3);
        return text + "px";
    }
    // Two lengths, the second in the upper half of a range, with words around them.
    std::string halves(std::string_view first, double low, std::string_view between, double high,
                       std::string_view last) {
        const double middle = (low + high) / 2;
        std::string text(first);
        append_fixed(text, std::max(0.25, real(low, middle) * scale_), 3);
        text += "px" + std::string(between);
        append_fixed(text, std::max(0.26, real(middle, high) * scale_ + 0.01), 3);
        return text + "px" + std::string(last);
    }

    // A length in all the ways in which one can be said. Names stand for lengths of 5px to 60px.
    std::string length(double low, double high) {
        const double middle = (low + high) / 2;
        switch (whole(14)) {
            case 0:
            case 1:
                return halves("", low, "..", high, "");
            case 2:
                return halves("one_of(", low, ", ", high, ": 2)");
            case 3:
                return joined({"normal(", size(middle, middle), ", ", size(low / 4, low / 2), ") in ",
                               halves("", low, "..", high, "")});
            case 4:
                return halves("each(", low, "..", high, ")");
            case 5:
                return joined({"count > ", std::to_string(whole(9)), " ? ", size(low, middle), " : ",
                               halves("", low, "..", high, "")});
            case 6:
                return joined({"max(", size(low, low), ", ", halves("(", low, "..", high, ")"), " * (0.5..1.5))"});
            case 7:
            case 8: {
                if (lengths_.empty()) return size(low, high);
                const std::string& name = lengths_[random_.index(lengths_.size())];
                std::string factor;
                append_fixed(factor, middle * scale_ / 15, 3);
                return joined({"max(", size(low, low), ", ", name, " * ", factor, ")"});
            }
            default:
                return size(low, high);
        }
    }

    std::string angle() {
        static constexpr const char* angles[] = {"",
                                                 ", angle: keep",
                                                 ", angle: across",
                                                 ", angle: axis",
                                                 ", angle: 0",
                                                 ", angle: 45",
                                                 ", angle: turn(30)",
                                                 ", angle: towards((0, 0))",
                                                 ", angle: one_of(0, 90, 45: 3)",
                                                 ", angle: turn(-20..20)",
                                                 ", angle: each(mod(index, 2) == 0 ? 0 : 90)"};
        return angles[whole(11)];
    }

    // What an operator's call and its outputs are; these are left in outputs_.
    std::string call(int level) {
        const auto next = [&] {
            const int skipped =
                whole(4) != 0 ? 0 : static_cast<int>(whole(static_cast<std::uint32_t>(levels_ - level + 1)));
            return tag(level + 1 + skipped);
        };
        const double finer = level == 0 ? 1 : level == 1 ? 0.5 : 0.3;
        const auto sized = [&](double low, double high) { return length(low * finer, high * finer); };
        outputs_ = " -> " + next();
        switch (has_system_ && level < 2 && whole(5) == 0 ? 11 : whole(22)) {
            case 0:
            case 1: {
                static constexpr const char* curves[] = {"line", "wave", "zigzag", "one_of(line, wave: 2)"};
                std::string call = "regular_split(";
                const std::uint64_t curve = whole(4);
                call += curves[curve];
                call += joined({", ", sized(8, 40), whole(2) == 0 ? ", dual: true" : "", angle()});
                if (curve != 0) call += joined({", amplitude: ", sized(1, 12), ", wavelength: ", sized(10, 60)});
                if (whole(3) == 0) call += ", fit: true";
                if (whole(5) == 0) call += ", anchor: " + std::string(whole(2) == 0 ? "group" : "page");
                return call + ")";
            }
            case 2:
                return joined({"regular_split(line, [", size(6 * finer, 20 * finer), ", ", size(3 * finer, 15 * finer),
                               "], ", whole(2) == 0 ? "1" : "0", angle(), ")"});
            case 3:
                outputs_ += ", " + next();
                return joined({"outline(", sized(1, 14), whole(3) == 0 ? ", join: round" : "", ")"});
            case 4:
                outputs_ += ", " + next();
                return halves("outline(each(", finer, "..", 9 * finer, "))");
            case 5:
                outputs_ += ", " + (whole(6) == 0 ? "_" : next());
                return joined({"place(",
                               whole(2) == 0   ? "blob, "
                               : whole(2) == 0 ? "one_of(disc, blob), "
                                               : "",
                               sized(6, 20), ", ", sized(8, 40), whole(3) == 0 ? ", variation: 0..0.5" : "", ")"});
            case 6:
                return "ungroup()";
            case 7: {
                static constexpr const char* ways[] = {"",           ", by: id",       ", by: colour",
                                                       ", by: area", ", by: distance", ", by: random"};
                return joined({"regroup(", whole(3) == 0 ? "2..4" : std::to_string(1 + whole(4)), ways[whole(6)], ")"});
            }
            case 8:
                if (whole(2) == 0) return "invert()";
                outputs_ += ", " + next();
                return "invert(one_of(even, odd, all))";
            case 9:
                outputs_ += ", <>";
                return "stipple(" + sized(5, 12) + ")";
            case 10:
                return "fill(" + std::string(whole(2) == 0 ? "one_of(#a03020, #208040: 2)" : "#c0b090") + ")";
            case 11:
            case 12:
                // A document in each of very many shapes would not be quick.
                if (!has_system_ || level > 1) break;
                if (has_pair_ && whole(3) == 0) return "embed(pair)";
                return joined({"embed(weave", whole(2) == 0 ? ", thread: " + sized(8, 20) : "", ")"});
            case 13:
                if (!has_operator_) break;
                outputs_ = " -> dots: " + next();
                if (whole(3) != 0) outputs_ += ", band: " + next();
                return joined({"lace(", whole(2) == 0 ? "width: " + sized(2, 6) : "", ")"});
            case 14: {
                static constexpr const char* curves[] = {"circ", "spiral", "rays",
                                                         "path(\"M 0 0 C 10 -20 30 20 40 0\")",
                                                         "path(\"M 0 0 C 40 0 30 30 10 20 C -10 10 0 -20 30 -10\")"};
                return joined({"regular_split(", curves[whole(5)], ", ", sized(8, 30),
                               whole(3) == 0 ? ", dual: true" : "", whole(3) == 0 ? ", centre: (10px, -5px)" : "",
                               angle(), ")"});
            }
            case 15: {
                static constexpr const char* kinds[] = {"smooth", "strip", "circular"};
                return joined({"streamline_split(", kinds[whole(3)], ", ", sized(8, 30),
                               whole(4) == 0 ? ", dual: true" : "", whole(4) == 0 ? ", mode: field" : "", ")"});
            }
            case 16:
                return joined({"radial(", std::to_string(1 + whole(12)), whole(2) == 0 ? ", rings: 2" : "",
                               whole(2) == 0 ? ", twist: " + number(-90, 90) : "",
                               whole(2) == 0 ? ", hub: " + sized(2, 12) : "", ")"});
            case 17: {
                static constexpr const char* sites[] = {"", ", sites: random", ", sites: lattice", ", relax: 1..4"};
                return joined({"voronoi(", sized(10, 30), sites[whole(4)], ")"});
            }
            case 18:
                outputs_ += ", " + (whole(3) == 0 ? "_" : next());
                return joined({"transform(", whole(2) == 0 ? "turn: each(0..90), " : "",
                               whole(3) == 0 ? "move: (3px, -2px), " : "", "scale: 0.", std::to_string(4 + whole(6)),
                               ")"});
            case 19: {
                static constexpr const char* motifs[] = {"star(5, 10, 4)", "path(\"M 0 0 C 8 -9 8 9 0 0 Z\")",
                                                         "rectangle(30, 10)", "one_of(polygon(3, 5), square)"};
                static constexpr const char* borders[] = {"", ", border: touch", ", border: clip", ", relax: no"};
                static constexpr const char* turns[] = {"", ", rotation: random", ", rotation: along",
                                                        ", rotation: 30"};
                outputs_ += ", " + next();
                return joined({"place(", motifs[whole(4)], ", ", sized(6, 20), ", ", sized(10, 40), borders[whole(4)],
                               turns[whole(4)], ")"});
            }
            case 20: {
                static constexpr const char* marks[] = {"dot", "dash", "curve", "circle", "star(4, 3, 1)"};
                static constexpr const char* densities[] = {"", ", density: 0.4", ", density: gradient(1, 0.1)",
                                                            ", density: radial(0.1, 1), grow: yes"};
                outputs_ += ", <>";
                return joined({"stipple(", sized(5, 14), ", mark: ", marks[whole(5)], densities[whole(4)], ")"});
            }
            default:
                break;
        }
        return joined({"regular_split(", sized(5, 25), angle(), ")"});
    }

    CaseRandom random_;
    double scale_ = 1;
    int levels_ = 2;
    int labels_ = 0;
    bool has_system_ = false, has_pair_ = false, has_operator_ = false;
    std::vector<std::string> lengths_;  // names that mean one
    std::string outputs_;
};

}  // namespace filigree
