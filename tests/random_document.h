// Random tangle documents for property tests: an outline with holes or a built-in shape, and a grammar over
// a few tags whose rules only lead onwards, so that every derivation ends.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/elementary.h"
#include "base/number_text.h"
#include "base/test_cases.h"

namespace filigree {

// Where the seeds begin: FILIGREE_FIRST_SEED, so that long runs try others.
inline std::uint64_t first_seed() {
    const char* wanted = std::getenv("FILIGREE_FIRST_SEED");
    return wanted == nullptr ? 1 : std::strtoull(wanted, nullptr, 10);
}

class RandomDocument {
public:
    explicit RandomDocument(std::uint64_t seed) : random_(seed) {}

    std::string text() {
        std::string all = "grammar tangle\nseed " + std::to_string(whole(1000)) + "\n";
        if (whole(4) == 0) all += "unit mm\n";
        all += "limit elements 30000\n";
        all += start();
        const int levels = 2 + static_cast<int>(whole(4));
        for (int level = 0; level < levels; ++level) {
            const int rules = 1 + static_cast<int>(whole(3));
            for (int r = 0; r < rules; ++r) all += rule(level, levels);
        }
        return all;
    }

private:
    std::uint64_t whole(std::uint32_t count) { return random_.below(count); }
    double real(double low, double high) { return random_.between(low, high); }
    std::string number(double low, double high) {
        std::string text;
        append_fixed(text, real(low, high), static_cast<int>(whole(4)));
        return text;
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
        const std::string tag = "start t0 = ";
        switch (whole(8)) {
            case 0:
                return tag + "rectangle(" + number(60, 200) + "px, " + number(60, 200) + "px)\n";
            case 1:
                return tag + "circle(" + number(40, 100) + "px)\n";
            case 2:
                return tag + "star(" + std::to_string(3 + whole(9)) + ", " + number(60, 110) + "px, " + number(20, 50) +
                       "px)\n";
            case 3:  // overlapping starts: the later covers the earlier
                return tag + "circle(60px)\n" + "start t0 = rectangle(100px, 50px, at: (" + number(-40, 40) + "px, " +
                       number(-40, 40) + "px))\n";
            case 4:  // self-crossing outlines and the even-odd rule
                return tag + "path(\"" + ring(0, 0, 80, 5 + static_cast<int>(whole(20)), 0.9) +
                       ring(20, 10, 60, 7, 0.8) + "\")\n";
            default: {
                std::string data = ring(0, 0, real(60, 110), 6 + static_cast<int>(whole(60)), 0.25);
                const int holes = static_cast<int>(whole(4));
                for (int h = 0; h < holes; ++h) {
                    const elementary::CosSin turn = elementary::cos_sin_degrees(120.0 * h);
                    data += ring(24 * turn.cos, 24 * turn.sin, real(5, 12), 3 + static_cast<int>(whole(12)), 0.3);
                }
                return tag + "path(\"" + data + "\")\n";
            }
        }
    }

    std::string rule(int level, int levels) {
        const auto next = [&] {
            const int skipped =
                whole(4) != 0 ? 0 : static_cast<int>(whole(static_cast<std::uint32_t>(levels - level + 1)));
            return "t" + std::to_string(level + 1 + skipped);
        };
        const std::string here = " : t" + std::to_string(level);
        std::string suffix;
        if (whole(5) == 0) suffix += " when count < " + std::to_string(1 + whole(40));
        if (whole(5) == 0) suffix += " weight " + number(0.5, 4);
        const double scale = level == 0 ? 1 : level == 1 ? 0.5 : 0.3;
        const auto size = [&](double low, double high) {
            std::string text;  // whole numbers now and then, but never 0
            append_fixed(text, std::max(0.25, real(low * scale, high * scale)),
                         whole(4) == 0 && low * scale > 1 ? 0 : 3);
            return text + "px";
        };
        static constexpr const char* angles[] = {
            "",           ", angle: keep", ", angle: across",   ", angle: axis",
            ", angle: 0", ", angle: 45",   ", angle: turn(30)", ", angle: towards((0, 0))"};
        const std::string angle = angles[whole(8)];
        switch (whole(11)) {
            case 0:
            case 1: {
                static constexpr const char* curves[] = {"line", "wave", "zigzag", "one_of(line, wave: 2)"};
                std::string call = "regular_split(";
                const std::uint64_t curve = whole(3);
                call += curves[curve];
                call += ", " + size(8, 40) + (whole(2) == 0 ? ", dual: true" : "") + angle;
                if (curve != 0) call += ", amplitude: " + size(1, 12) + ", wavelength: " + size(10, 60);
                if (whole(3) == 0) call += ", fit: true";
                if (whole(5) == 0) call += ", anchor: " + std::string(whole(2) == 0 ? "group" : "page");
                return call + ")" + here + suffix + " -> " + next() + "\n";
            }
            case 2:
                return "regular_split(line, [" + size(6, 20) + ", " + size(3, 15) + "], " +
                       (whole(2) == 0 ? "1" : "0") + angle + ")" + here + suffix + " -> " + next() + "\n";
            case 3:
                return "outline(" + size(1, 14) + (whole(3) == 0 ? ", join: round" : "") + ")" + here + suffix +
                       " -> " + next() + ", " + next() + "\n";
            case 4:
                return "outline(each(" + size(1, 4) + ".." + size(5, 9) + "))" + here + suffix + " -> " + next() +
                       ", " + next() + "\n";
            case 5:
                return "place(" + std::string(whole(2) == 0 ? "blob, " : "") + size(6, 20) + ", " + size(8, 40) + ")" +
                       here + suffix + " -> " + next() + ", " + next() + "\n";
            case 6:
                return "ungroup()" + here + suffix + " -> " + next() + "\n";
            case 7:
                return "regroup(" + std::to_string(1 + whole(4)) + (whole(2) == 0 ? ", by: id" : "") + ")" + here +
                       suffix + " -> " + next() + "\n";
            case 8:
                return "invert()" + here + suffix + " -> " + next() + "\n";
            case 9:
                return "stipple(" + size(5, 12) + ")" + here + suffix + " -> " + next() + ", <>\n";
            default:
                return "regular_split(" + size(5, 25) + angle + ")" + here + suffix + " -> " + next() + "\n";
        }
    }

    CaseRandom random_;
};

}  // namespace filigree
