#include "language/word_settings.h"

#include <array>

namespace filigree {
namespace {

constexpr std::array settings = {
    WordSetting{"dialect", "dialect gdesign", "which letters are special"},
    WordSetting{"axiom", "axiom \"D+a+a+a\"", "the word that the derivation begins with"},
    WordSetting{"iterations", "iterations 5", "how many times the word is rewritten"},
    WordSetting{"free", "free s n", "special letters that are ordinary ones here"},
    WordSetting{"gain", "gain q 1 g 2", "by how many symbols a run of a counter grows in an iteration"},
    WordSetting{
        "loop", "loop \"ab\"@2 side",
        "for how many iterations the rules of these letters serve, as rows, or some of their rules: a rule's own "
        "`loop` goes first"},
    WordSetting{"after", "after hold", "what a letter does behind its last row: identity, hold or cycle"},
    WordSetting{"memory", "memory last", "which draw of a macro is recalled: first or last"},
    WordSetting{"random", "random position", "what draws are addressed by: lineage or position"},
    WordSetting{"ages", "ages lineage", "how ages are counted: position or lineage"},
    WordSetting{"ignore", "ignore \"+-\"", "symbols that contexts look past"},
    WordSetting{"mode", "mode grow", "of a subsystem: instant or grow"},
    WordSetting{"mask", "mask a@2, \"b+\" when depth > 2",
                "symbols that stay as they are, in these iterations, where the condition holds"},
    WordSetting{"sleep", "sleep a, q until age > 3",
                "symbols that stay as they are, as if '=' stood behind them, until the condition holds"},
    WordSetting{"array", "array M [10] [10]",
                "words by their place; a cell is written M[3][9] -> \"ab\". 'array M from \"rules.csv\"' reads them; "
                "'wrap' or 'clamp' behind it leads indexes outside back inside"},
    WordSetting{"register", "register ix 3", "a number that rules may change"},
    WordSetting{
        "image", "image wall \"photo.png\" over 0, 0, 400, 300",
        "a picture over a rectangle of the wall (x, y upwards, width, height), for rules to look at; 'outside wrap' "
        "or 'none': what it has beside it, instead of its border",
        false, true},
    WordSetting{"data", "data heights \"heights.csv\" over 0, 0, 400, 300",
                "likewise a table of numbers, its first row on top", false, true},
    WordSetting{"angle", "angle 30", "degrees by which + and - turn; in a subsystem, where it has put them", true,
                false, true},
    WordSetting{"angle2", "angle2 45", "degrees by which < and > turn; as angle unless said; in a subsystem likewise",
                true, false, true},
    WordSetting{"plus", "plus counterclockwise", "which way + turns: clockwise or counterclockwise", true},
    WordSetting{"step", "step 10",
                "how far a letter goes; unless said, it is 1, and the drawing is scaled to the page; in a subsystem, "
                "how far the letters go that it has put",
                true, false, true},
    WordSetting{"width", "width 0.5mm", "of the lines", true},
    WordSetting{"widening", "widening 1.25", "how much wider a letter of the use `wider` makes lines", true},
    WordSetting{"letter", "letter b box(20, 10, 6)", "what a letter does when it is drawn, or a shape that it places",
                true},
    WordSetting{"formula", "formula k * 15", "degrees of the k-th ?, of k, t, depth, age, x, y and z; or a list", true},
    WordSetting{"colours", "colours [#1a1a1a, #a03020]", "a palette for next_colour and previous_colour", true},
    WordSetting{"tubes", "tubes 8", "lines in space are solid, with so many sides", true},
    WordSetting{"view", "view 30, 25", "from where words in space are seen: azimuth and elevation, degrees", true},
};

}  // namespace

std::span<const WordSetting> word_settings() { return settings; }

const WordSetting* find_word_setting(std::string_view name) {
    for (const WordSetting& setting : settings) {
        if (setting.name == name) return &setting;
    }
    return nullptr;
}

}  // namespace filigree
