// Laws of the choices of words, over random grammars as documents: what was listed gives the same word again, and what
// is set, kept or drawn again at a path changes what descends from there and nothing else.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/random_edit.h"

namespace filigree {
namespace {

using State = std::shared_ptr<DocumentState>;

State grown_now(const std::string& text, const Replay* replay = nullptr) {
    SerialExecutor serial;
    RunOptions options;
    options.draws = false;
    options.lists_choices = true;
    options.replay = replay;
    return grown(text, options, serial);
}

struct Looks {
    bool by_place = false;  // draws go by place
    bool has_edits = false;
};

// Letters that are drawn for, each by itself: none looks at another, so that what stands beside a branch stays.
std::string random_words(CaseRandom& random, const Looks& looks) {
    const auto word = [&](const std::string& letters, std::uint32_t most) {
        std::string made;
        for (std::uint32_t left = 1 + random.below(most); left > 0; --left) {
            made += letters[random.index(letters.size())];
            if (made.back() != 'R' && random.below(6) == 0) made += "=";  // R= recalls what others drew
        }
        return made;
    };
    std::string text = "grammar rewriting\nseed " + std::to_string(random.below(1000)) + "\niterations " +
                       std::to_string(2 + random.below(3)) + "\nlimit elements 4000\n";
    if (looks.by_place) text += "random position\n";
    text += "axiom \"" + word("abcRAB+", 6) + "\"\n";
    for (const std::string letter : {"a", "b", "c", "+"}) {
        text += letter + " -> ";
        const std::uint32_t count = 1 + random.below(4);
        for (std::uint32_t s = 0; s < count; ++s) {
            text += (s == 0 ? "\"" : ", \"") + word("abc+R[]A", 3) + "\"";
            if (random.coin()) text += " * " + std::to_string(1 + random.below(4));
        }
        if (random.below(4) == 0) text += ", goto b@1";
        text += "\n";
    }
    text += "R = random 0..3 \"abbc\"" + std::string(random.coin() ? " unique" : "") + "\n";
    text += "system A { axiom \"aR\"; iterations 2; a -> \"ab\", \"ba\", \"b\"; R = random 1..2 \"ab\" }\n";
    text += "system B { mode grow; axiom \"ab\"; iterations 2; a -> \"ab\", \"ba\"; b -> \"b\", \"bb\" }\n";
    if (looks.has_edits) {
        text += "each iteration mutate(replace: 20%, twice: 10%)\nonce insert(\"c\", at: \"a\", where: (0..1) < 0.5)\n";
    }
    return text;
}

std::string word_of(const DocumentState& state) {
    const rewriting::Derivation& derivation = state.run.word->derivation;
    return rewriting::to_text(derivation.word, derivation.alphabet);
}

bool is_at_or_below(const std::string& path, const std::string& above) {
    return path == above || path.rfind(above + "/", 0) == 0;
}

// What a place decides about: what a subsystem grows inside becomes letters of the symbol that puts it.
std::string branch_of(const std::string& place) { return place.substr(0, place.find("/system")); }

// Letters and keys of the symbols that do not descend from a place.
std::vector<std::pair<std::uint64_t, char32_t>> symbols_beside(const DocumentState& state, const std::string& place) {
    const rewriting::Derivation& derivation = state.run.word->derivation;
    std::vector<std::pair<std::uint64_t, char32_t>> beside;
    std::size_t index = 0;
    for (const rewriting::Symbol symbol : derivation.word.symbols) {
        if (symbol == rewriting::Alphabet::freeze) continue;
        const std::string path = derivation.choices->path_of(derivation.word.spots[index]);
        if (!is_at_or_below(path, place)) {
            beside.emplace_back(derivation.word.keys[index], derivation.alphabet[symbol].letter);
        }
        ++index;
    }
    return beside;
}

std::string value_text(const NamedChoice& choice) { return to_text(value_of(*choice.choices, choice.row)); }

std::map<std::string, NamedChoice> by_path(const DocumentState& state) {
    std::map<std::string, NamedChoice> all;
    for (NamedChoice& choice : named_choices(state)) {
        std::string path = choice.path;
        all.emplace(std::move(path), std::move(choice));
    }
    return all;
}

State with_edit(const DocumentState& state, DocumentEdit::Kind kind, const std::string& path,
                const std::string& value = "") {
    DocumentEdit edit;
    edit.kind = kind;
    edit.path = path;
    edit.value = value;
    const Result<std::string> text = edited_text(state.opened.document, edit);
    EXPECT_TRUE(text) << to_text(edit) << "\n" << state.opened.document.text();
    return text ? grown_now(*text) : nullptr;
}

template <class Check>
void for_random_words(const Looks& looks, std::uint64_t count, Check check) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + count; ++seed) {
        CaseRandom random(seed);
        const State state = grown_now(random_words(random, looks));
        if (!state) continue;  // a limit
        const std::vector<NamedChoice> choices = named_choices(*state);
        if (!choices.empty()) check(*state, choices, random);
    }
}

// Something of which there is another value: the choice, and that value as a document writes it.
struct Alternative {
    NamedChoice choice;
    std::string value;
};
std::optional<Alternative> other_value(const std::vector<NamedChoice>& choices, CaseRandom& random) {
    const NamedChoice& choice = choices[random.index(choices.size())];
    if (choice.name() == "letters") return Alternative{choice, "\"cacaca\""};
    if (choice.domain().kind != ChoiceDomain::Kind::alternatives) return std::nullopt;
    const std::vector<Value>& all = choice.domain().alternatives;
    const std::size_t other = (static_cast<std::size_t>(choice.value()) + 1) % all.size();
    return Alternative{choice, to_text(all[other])};
}

TEST(WordChoicesProperty, WhatWasListedGivesTheSameWordUnderAnotherSeed) {
    std::uint64_t seen = 0, others = 0;
    const std::uint64_t count = case_count(1000) / 4;
    for (const Looks looks : {Looks{false, false}, Looks{true, false}, Looks{false, true}, Looks{true, true}}) {
        for_random_words(looks, count, [&](const DocumentState& state, const auto&, CaseRandom& random) {
            std::string listing;
            list_choices(state.opened, state.checked, state.run, [&](std::string_view piece) { listing += piece; });
            const Result<Replay> replay = read_choices(listing);
            ASSERT_TRUE(replay);
            const std::string text = with_seed(state.opened.document, 5000 + random.below(1000));
            const State again = grown_now(text, &*replay);
            ASSERT_TRUE(again) << text;
            EXPECT_EQ(word_of(*again), word_of(state)) << text;
            const State drawn = grown_now(text);
            ++seen;
            others += drawn && word_of(*drawn) != word_of(state) ? 1 : 0;
        });
    }
    EXPECT_GT(seen, 2 * count);
    EXPECT_GT(others * 2, seen);
}

TEST(WordChoicesProperty, ASetChangesWhatDescendsAndNothingElse) {
    std::uint64_t changed = 0;
    const std::uint64_t count = case_count(1000) / 2;
    for_random_words({}, count, [&](const DocumentState& state, const auto& choices, CaseRandom& random) {
        const std::optional<Alternative> other = other_value(choices, random);
        if (!other) return;
        const std::string place = branch_of(other->choice.place), &path = other->choice.path;
        const State after = with_edit(state, DocumentEdit::Kind::set, path, other->value);
        if (!after) return;  // a limit
        const std::string& text = after->opened.document.text();
        EXPECT_EQ(symbols_beside(*after, place), symbols_beside(state, place)) << text;
        const auto now = by_path(*after);
        ASSERT_EQ(now.count(path), 1U) << text;
        EXPECT_EQ(value_text(now.at(path)), other->value) << text;
        for (const NamedChoice& choice : choices) {
            if (is_at_or_below(choice.place, place)) continue;
            const auto found = now.find(choice.path);
            ASSERT_TRUE(found != now.end()) << choice.path << "\n" << text;
            EXPECT_EQ(value_text(found->second), value_text(choice)) << choice.path << "\n" << text;
        }
        EXPECT_TRUE(after->run.unmatched.empty()) << text;
        changed += word_of(*after) != word_of(state) ? 1 : 0;
    });
    EXPECT_GT(changed * 4, count);
}

TEST(WordChoicesProperty, ARerollDrawsAgainWhatLiesBelowAndNothingElse) {
    std::uint64_t redrawn = 0, others = 0;
    for_random_words(
        {}, case_count(1000) / 2, [&](const DocumentState& state, const auto& choices, CaseRandom& random) {
            const std::string& place = choices[random.index(choices.size())].place;
            const State after = with_edit(state, DocumentEdit::Kind::reroll, place);
            if (!after) return;  // a limit
            const std::string branch = branch_of(place);
            EXPECT_EQ(symbols_beside(*after, branch), symbols_beside(state, branch)) << after->opened.document.text();
            const auto now = by_path(*after);
            for (const NamedChoice& choice : choices) {
                const auto found = now.find(choice.path);
                if (!is_at_or_below(choice.place, branch)) {
                    ASSERT_TRUE(found != now.end()) << choice.path;
                    EXPECT_EQ(value_text(found->second), value_text(choice)) << choice.path;
                } else if (is_at_or_below(choice.place, place) && found != now.end()) {
                    ++redrawn;
                    others += value_text(found->second) != value_text(choice) ? 1 : 0;
                }
            }
        });
    EXPECT_GT(redrawn, case_count(1000) / 4);
    EXPECT_GT(others * 4, redrawn);
}

TEST(WordChoicesProperty, WhatIsKeptStaysWhenWhatLiesAboveItIsRerolled) {
    std::uint64_t kept = 0, others = 0;
    for_random_words(
        {}, case_count(1000) / 2, [&](const DocumentState& state, const auto& choices, CaseRandom& random) {
            const std::string& place = choices[random.index(choices.size())].place;
            const std::size_t slash = place.rfind('/');
            if (slash == std::string::npos) return;
            const State held = with_edit(state, DocumentEdit::Kind::keep, place);
            ASSERT_TRUE(held);
            EXPECT_EQ(word_of(*held), word_of(state)) << held->opened.document.text();
            const State after = with_edit(*held, DocumentEdit::Kind::reroll, place.substr(0, slash));
            if (!after) return;  // a limit
            const auto now = by_path(*after);
            for (const NamedChoice& choice : choices) {
                const auto found = now.find(choice.path);
                // Another b may now be the second: paths count, keys do not.
                if (found == now.end() || found->second.key() != choice.key()) continue;
                if (is_at_or_below(choice.place, place)) {
                    ++kept;
                    EXPECT_EQ(value_text(found->second), value_text(choice)) << after->opened.document.text();
                } else if (is_at_or_below(choice.place, place.substr(0, slash))) {
                    others += value_text(found->second) != value_text(choice) ? 1 : 0;
                }
            }
        });
    EXPECT_GT(kept, case_count(1000) / 20);
    EXPECT_GT(others, case_count(1000) / 20);
}

// Wherever it stands, and however its draws are addressed.
TEST(WordChoicesProperty, AGlobReachesEverySymbolOfItsLetter) {
    std::uint64_t seen = 0;
    for (const bool by_place : {false, true}) {
        for_random_words(
            {by_place, false}, case_count(1000) / 4,
            [&](const DocumentState& state, const auto& choices, CaseRandom& random) {
                const std::optional<Alternative> other = other_value(choices, random);
                if (!other || other->choice.name() != "rule") return;
                const std::string& place = other->choice.place;
                std::string letter = place.substr(place.rfind('/') + 1);
                letter = letter.substr(0, letter.find('['));
                const State after = with_edit(state, DocumentEdit::Kind::set, "**/" + letter + ".rule", other->value);
                if (!after) return;  // a limit
                for (const NamedChoice& choice : named_choices(*after)) {
                    const std::string& at = choice.place;
                    if (at.substr(at.rfind('/') + 1).rfind(letter + "[", 0) != 0 || choice.name() != "rule") continue;
                    if (choice.source() != ChoiceSource::set) continue;  // another rule, without such a successor
                    ++seen;
                    EXPECT_EQ(value_text(choice), other->value) << after->opened.document.text();
                }
                EXPECT_TRUE(after->run.unmatched.empty()) << after->opened.document.text();
            });
    }
    EXPECT_GT(seen, case_count(1000) / 4);
}

TEST(WordChoicesProperty, NothingIsDrawnWhereNothingIsRandom) {
    std::uint64_t seen = 0;
    for (const Looks looks : {Looks{false, true}, Looks{true, false}}) {
        for_random_words(looks, case_count(1000) / 8, [&](const DocumentState& state, const auto&, CaseRandom&) {
            const std::string calm = state.opened.document.text() + "set **.is_random = false\n";
            const State one = grown_now(calm);
            if (!one) return;  // a limit
            const State other = grown_now(with_seed(one->opened.document, 77777));
            ASSERT_TRUE(other) << calm;
            EXPECT_EQ(word_of(*one), word_of(*other)) << calm;
            ++seen;
        });
    }
    EXPECT_GT(seen, case_count(1000) / 16);
}

}  // namespace
}  // namespace filigree
