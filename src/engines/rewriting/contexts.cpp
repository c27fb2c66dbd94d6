#include "engines/rewriting/contexts.h"

namespace filigree::rewriting {
namespace {

constexpr int deepest = 100;  // branches of a pattern inside each other

// Behind the ']' that closes the '[' at `open`; the end where none does.
std::size_t behind_branch(std::u32string_view pattern, std::size_t open) {
    int depth = 0;
    for (std::size_t at = open; at < pattern.size(); ++at) {
        depth += pattern[at] == U'[' ? 1 : pattern[at] == U']' ? -1 : 0;
        if (depth == 0) return at + 1;
    }
    return pattern.size();
}

}  // namespace

Contexts::Contexts(const Word& word, const Alphabet& alphabet)
    : word_(word), alphabet_(alphabet), partners_(word.size(), none) {
    std::vector<std::uint32_t> open;
    for (std::uint32_t place = 0; place < word.size(); ++place) {
        const char32_t here = letter(place);
        if (here == U'[') open.push_back(place);
        if (here != U']' || open.empty()) continue;
        partners_[place] = open.back();
        partners_[open.back()] = place;
        open.pop_back();
    }
}

std::optional<std::size_t> Contexts::before(std::size_t place, std::u32string_view ignored) const {
    while (place > 0) {
        const char32_t here = letter(--place);
        if (here == U']') {
            if (partners_[place] == none) return std::nullopt;
            place = partners_[place];
        } else if (here != U'[' && !is_passed(here, ignored)) {
            return place;
        }
    }
    return std::nullopt;
}

std::optional<std::size_t> Contexts::from(std::size_t place, std::u32string_view ignored) const {
    for (; place < word_.size(); ++place) {
        const char32_t here = letter(place);
        if (here == U'[' && partners_[place] != none) {
            place = partners_[place];
        } else if (here == U'[' || here == U']') {
            return std::nullopt;
        } else if (!is_passed(here, ignored)) {
            return place;
        }
    }
    return std::nullopt;
}

bool Contexts::has_left(std::size_t place, std::u32string_view pattern, std::u32string_view ignored) const {
    std::optional<std::size_t> at = place;
    for (std::size_t wanted = pattern.size(); wanted > 0; --wanted) {
        at = before(*at, ignored);
        if (!at || letter(*at) != pattern[wanted - 1]) return false;
    }
    return true;
}

bool Contexts::has_right(std::size_t place, std::u32string_view pattern, std::u32string_view ignored) const {
    return begins_with(place + 1, pattern, ignored, 0);
}

bool Contexts::begins_with(std::size_t place, std::u32string_view pattern, std::u32string_view ignored,
                           int depth) const {
    if (depth > deepest) return false;
    for (std::size_t wanted = 0; wanted < pattern.size();) {
        if (pattern[wanted] != U'[') {
            const std::optional<std::size_t> next = from(place, ignored);
            if (!next || letter(*next) != pattern[wanted]) return false;
            ++wanted;
            place = *next + 1;
            continue;
        }
        while (place < word_.size() && letter(place) != U'[' && is_passed(letter(place), ignored)) ++place;
        if (place == word_.size() || letter(place) != U'[' || partners_[place] == none) return false;
        const std::size_t behind = behind_branch(pattern, wanted);
        const std::u32string_view branch = pattern.substr(wanted + 1, behind - wanted - 2);
        if (!begins_with(place + 1, branch, ignored, depth + 1)) return false;
        wanted = behind;
        place = partners_[place] + 1;
    }
    return true;
}

std::u32string Contexts::letters_left(std::size_t place, std::size_t most, std::u32string_view ignored) const {
    std::u32string letters;
    for (std::optional<std::size_t> at = before(place, ignored); at && letters.size() < most;
         at = before(*at, ignored)) {
        letters.insert(letters.begin(), letter(*at));
    }
    return letters;
}

std::u32string Contexts::letters_right(std::size_t place, std::size_t most, std::u32string_view ignored) const {
    std::u32string letters;
    for (std::optional<std::size_t> at = from(place + 1, ignored); at && letters.size() < most;
         at = from(*at + 1, ignored)) {
        letters += letter(*at);
    }
    return letters;
}

std::u32string Contexts::letters_behind(std::size_t place, std::size_t most) const {
    std::u32string letters;
    for (++place; place < word_.size() && letters.size() < most; ++place) {
        if (letter(place) != U'=') letters += letter(place);
    }
    return letters;
}

}  // namespace filigree::rewriting
