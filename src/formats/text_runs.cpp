#include "formats/text_runs.h"

#include <fribidi.h>

#include <algorithm>

#include "base/unicode.h"

namespace filigree {
namespace {

struct Letter {
    std::size_t begin = 0;  // byte offset
    hb_script_t script = HB_SCRIPT_COMMON;
    FriBidiLevel level = 0;
};

bool has_script(hb_script_t script) {
    return script != HB_SCRIPT_COMMON && script != HB_SCRIPT_INHERITED && script != HB_SCRIPT_UNKNOWN;
}

// Levels by the bidirectional algorithm; all 0 where it gives none.
void set_levels(std::vector<Letter>& letters, const std::vector<FriBidiChar>& characters) {
    const auto count = static_cast<FriBidiStrIndex>(characters.size());
    std::vector<FriBidiCharType> types(characters.size());
    std::vector<FriBidiBracketType> brackets(characters.size());
    std::vector<FriBidiLevel> levels(characters.size());
    fribidi_get_bidi_types(characters.data(), count, types.data());
    fribidi_get_bracket_types(characters.data(), count, types.data(), brackets.data());
    FriBidiParType direction = FRIBIDI_PAR_ON;
    if (fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), count, &direction, levels.data()) == 0) {
        return;
    }
    // White space at the end of a line goes with the line (rule L1).
    const FriBidiLevel outer = FRIBIDI_IS_RTL(direction) ? 1 : 0;
    for (std::size_t i = characters.size(); i-- > 0 && FRIBIDI_IS_EXPLICIT_OR_BN_OR_WS(types[i]);) levels[i] = outer;
    for (std::size_t i = 0; i < letters.size(); ++i) letters[i].level = levels[i];
}

void settle_scripts(std::vector<Letter>& letters) {
    const auto first =
        std::find_if(letters.begin(), letters.end(), [](const Letter& l) { return has_script(l.script); });
    hb_script_t around = first == letters.end() ? HB_SCRIPT_COMMON : first->script;
    for (Letter& letter : letters) {
        if (has_script(letter.script)) around = letter.script;
        letter.script = around;
    }
}

}  // namespace

std::vector<TextRun> text_runs(std::string_view line) {
    std::vector<Letter> letters;
    std::vector<FriBidiChar> characters;
    for (std::size_t at = 0; at < line.size();) {
        const unicode::Decoded decoded = unicode::decode(line, at);
        letters.push_back({at, hb_unicode_script(hb_unicode_funcs_get_default(), decoded.code_point), 0});
        characters.push_back(decoded.code_point);
        at += decoded.length;
    }
    if (letters.empty()) return {};
    set_levels(letters, characters);
    settle_scripts(letters);

    std::vector<TextRun> runs;
    std::vector<FriBidiLevel> levels;
    for (const Letter& letter : letters) {
        if (runs.empty() || levels.back() != letter.level || runs.back().script != letter.script) {
            runs.push_back({letter.begin, letter.begin, letter.script, letter.level % 2 != 0});
            levels.push_back(letter.level);
        }
    }
    for (std::size_t i = 0; i < runs.size(); ++i) runs[i].end = i + 1 < runs.size() ? runs[i + 1].begin : line.size();

    // From the highest level down to the lowest odd one, what is at least as high is turned around (rule L2).
    for (FriBidiLevel level = *std::max_element(levels.begin(), levels.end()); level > 0; --level) {
        for (std::size_t i = 0; i < runs.size();) {
            std::size_t end = i;
            while (end < runs.size() && levels[end] >= level) ++end;
            std::reverse(runs.begin() + static_cast<std::ptrdiff_t>(i),
                         runs.begin() + static_cast<std::ptrdiff_t>(end));
            std::reverse(levels.begin() + static_cast<std::ptrdiff_t>(i),
                         levels.begin() + static_cast<std::ptrdiff_t>(end));
            i = end + 1;
        }
    }
    return runs;
}

}  // namespace filigree
