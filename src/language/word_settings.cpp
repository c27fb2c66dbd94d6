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
    WordSetting{"after", "after hold", "what a letter does behind its last row: identity, hold or cycle"},
    WordSetting{"memory", "memory last", "which draw of a macro is recalled: first or last"},
    WordSetting{"random", "random position", "what draws are addressed by: lineage or position"},
    WordSetting{"ages", "ages lineage", "how ages are counted: position or lineage"},
    WordSetting{"ignore", "ignore \"+-\"", "symbols that contexts look past"},
    WordSetting{"mode", "mode grow", "of a subsystem: instant or grow"},
    WordSetting{"array", "array M [10] [10]", "words by their place; a cell is written M[3][9] -> \"ab\""},
    WordSetting{"register", "register ix 3", "a number that rules may change"},
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
