#include "engines/rewriting/turtle_letters.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/number_text.h"
#include "base/unicode.h"
#include "engines/rewriting/word_tokens.h"

namespace filigree::rewriting {
namespace {

// An inverter governs growth, though its letter is lower-case.
Act usual_act(const SymbolEntry& entry) {
    if (entry.role == Role::freeze || entry.role == Role::inverter) return Act::nothing;
    switch (entry.letter) {
        case U'F':
            return Act::line;
        case U'f':
            return Act::move;
        case U'X':
            return Act::head_x;
        case U'Y':
            return Act::head_y;
        case U'Z':
            return Act::head_z;
        case U'T':
            return Act::select_up;
        case U'P':
            return Act::select_left;
        case U'D':
            return Act::select_heading;
        case U'+':
            return Act::plus;
        case U'-':
            return Act::minus;
        case U'<':
            return Act::less;
        case U'>':
            return Act::greater;
        case U'?':
            return Act::formula;
        case U'[':
            return Act::push;
        case U']':
            return Act::pop;
        case U'~':
            return Act::shrink;
        default:
            break;
    }
    const bool is_lower = unicode::is_letter(entry.letter) && unicode::to_lower(entry.letter) == entry.letter;
    return is_lower ? Act::line : Act::nothing;
}

// A shrink that begins here. Looks no further than where the next could begin, so that a word is read once.
std::optional<TurtleShrink> shrink_at(const Word& word, const Alphabet& alphabet, const TurtleLetters& letters,
                                      std::size_t begin) {
    const auto letter = [&](std::size_t at) { return alphabet[word.symbols[at]].letter; };
    if (begin + 1 >= word.size() || letter(begin + 1) != U'(') return std::nullopt;
    std::u32string text = U"~(";
    for (std::size_t at = begin + 2; at < word.size() && letters.acts[word.symbols[at]] != Act::shrink; ++at) {
        text += letter(at);
        if (letter(at) != U')') continue;
        const std::optional<double> factor = shrink_factor(text);
        return factor ? std::optional<TurtleShrink>({begin, at + 1, *factor}) : std::nullopt;
    }
    return std::nullopt;
}

void set_acts(TurtleLetters& letters, const Alphabet& alphabet, const std::vector<LetterUse>& uses) {
    for (std::size_t s = 1; s < alphabet.size(); ++s) {
        const SymbolEntry& entry = alphabet[static_cast<Symbol>(s)];
        letters.acts[s] = usual_act(entry);
        const auto use = std::find_if(uses.rbegin(), uses.rend(),
                                      [&](const LetterUse& said) { return said.letter == entry.letter; });
        if (use == uses.rend() || entry.role == Role::inverter) continue;
        letters.acts[s] = use->act;
        if (use->act != Act::shape) continue;
        std::vector<std::string>& names = letters.shape_names;
        const auto name = std::find(names.begin(), names.end(), use->shape);
        letters.names[s] = static_cast<std::uint32_t>(name - names.begin());
        if (name == names.end()) names.push_back(use->shape);
    }
}

// Of a gait, what it leaves open being as the document says.
TurtleSettings settings_within(const Gait& gait, const TurtleSettings& settings) {
    TurtleSettings of;
    of.angle = gait.angle.value_or(settings.angle);
    of.angle2 = gait.angle2 ? gait.angle2 : settings.angle2;
    of.step = gait.step.value_or(settings.step);
    return of;
}

void set_measures(TurtleLetters& letters, const Alphabet& alphabet, const TurtleSettings& settings) {
    std::vector<TurtleSettings> by_gait;
    std::vector<double> angles;
    for (const Gait& gait : alphabet.gaits()) {
        const TurtleSettings& of = by_gait.emplace_back(settings_within(gait, settings));
        angles.push_back(of.angle);
        angles.push_back(of.angle2.value_or(of.angle));
    }
    letters.scale = turn_scale(angles);
    for (std::size_t s = 1; s < alphabet.size(); ++s) {
        const std::size_t gait = alphabet[static_cast<Symbol>(s)].gait;
        const Act act = letters.acts[s];
        const bool is_second = act == Act::less || act == Act::greater;
        const bool is_forth = act == Act::plus || act == Act::less;
        const Int128 amount = letters.scale.amounts[2 * gait + (is_second ? 1 : 0)];
        const bool is_opposite = is_forth == (settings.plus == PlusTurn::clockwise);
        letters.turns[s] = is_opposite ? letters.scale.opposite(amount) : amount;
        letters.lengths[s] = by_gait[gait].step;
        if (is_step(act) && by_gait[gait].step != settings.step) letters.have_one_length = false;
    }
}

}  // namespace

TurtleLetters turtle_letters(const Alphabet& alphabet, const TurtleSettings& settings) {
    TurtleLetters letters;
    set_acts(letters, alphabet, settings.letters);
    set_measures(letters, alphabet, settings);
    return letters;
}

TurtleCounts count_acts(const Word& word, const Alphabet& alphabet, const TurtleLetters& letters) {
    TurtleCounts counts;
    std::uint64_t depth = 0, open = 0;
    for (std::size_t at = 0; at < word.size(); ++at) {
        const Act act = letters.acts[word.symbols[at]];
        if (is_step(act)) {
            counts.segments += act == Act::line ? 1 : 0;
            counts.shapes += act == Act::shape ? 1 : 0;
            counts.corners += open != 0 ? 1 : 0;
            continue;
        }
        switch (act) {
            case Act::push:
                counts.deepest = std::max(counts.deepest, ++depth);
                break;
            case Act::pop:
                depth != 0 ? --depth : ++counts.stray_closings;
                break;
            case Act::begin_polygon:
                ++open;
                ++counts.polygons;
                ++counts.corners;
                break;
            case Act::end_polygon:
                open != 0 ? --open : ++counts.stray_polygon_ends;
                break;
            case Act::shrink:
                if (const std::optional<TurtleShrink> shrink = shrink_at(word, alphabet, letters, at)) {
                    counts.shrinks.push_back(*shrink);
                    at = shrink->end - 1;
                }
                break;
            default:
                break;
        }
    }
    counts.unclosed = depth;
    counts.unclosed_polygons = open;
    return counts;
}

std::optional<Diagnostic> check_settings(const TurtleSettings& settings, const Alphabet& alphabet) {
    const auto wrong = [](const char* name, double value, const char* wanted) {
        return error("rewriting.turtle-setting",
                     std::string("the turtle's ") + name + " must be " + wanted + ", not " + filigree::to_text(value));
    };
    for (const Gait& gait : alphabet.gaits()) {
        const TurtleSettings of = settings_within(gait, settings);
        if (!std::isfinite(of.angle)) return wrong("angle", of.angle, "a number");
        if (of.angle2 && !std::isfinite(*of.angle2)) return wrong("angle2", *of.angle2, "a number");
        if (!std::isfinite(of.step)) return wrong("step", of.step, "a number");
    }
    if (!std::isfinite(settings.width) || settings.width < 0) return wrong("width", settings.width, "0 or more");
    if (!std::isfinite(settings.width_ratio) || !(settings.width_ratio > 0)) {
        return wrong("width ratio", settings.width_ratio, "above 0");
    }
    const auto is_wrong = [](double angle) { return !std::isfinite(angle); };
    const auto angle = std::find_if(settings.angles.begin(), settings.angles.end(), is_wrong);
    if (angle != settings.angles.end()) return wrong("list of angles", *angle, "of numbers");
    return std::nullopt;
}

Diagnostic too_much_to_draw(std::uint64_t count, const char* what, std::uint64_t most) {
    return fault(Fault::limit, "limit.elements",
                 "this word has " + filigree::to_text(count) + " " + what + ", which is more than the limit of " +
                     filigree::to_text(most));
}

Diagnostic out_of_range(std::uint64_t symbol) {
    return error("rewriting.turtle-out-of-range",
                 "what the turtle draws becomes too large for numbers at symbol " + filigree::to_text(symbol + 1));
}

double width_of(const TurtleSettings& settings, std::int64_t level) {
    if (level == 0) return settings.width;
    return settings.width * elementary::power(settings.width_ratio, static_cast<double>(level));
}

}  // namespace filigree::rewriting
