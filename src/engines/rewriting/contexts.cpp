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

bool Contexts::has_left(std::size_t place, std::u32string_view pattern, std::u32string_view ignored) const {
    std::size_t wanted = pattern.size();
    while (wanted > 0) {
        if (place == 0) return false;
        --place;
        const char32_t here = letter(place);
        if (here == U']') {
            if (partners_[place] == none) return false;
            place = partners_[place];
            continue;
        }
        if (here == U'[' || is_passed(here, ignored)) continue;
        if (here != pattern[--wanted]) return false;
    }
    return true;
}

bool Contexts::has_right(std::size_t place, std::u32string_view pattern, std::u32string_view ignored) const {
    return begins_with(place + 1, word_.size(), pattern, ignored, 0);
}

bool Contexts::begins_with(std::size_t from, std::size_t end, std::u32string_view pattern, std::u32string_view ignored,
                           int depth) const {
    if (depth > deepest) return false;
    for (std::size_t wanted = 0; wanted < pattern.size();) {
        const bool wants_branch = pattern[wanted] == U'[';
        for (;; ++from) {
            if (from >= end) return false;
            const char32_t here = letter(from);
            if (here == U']') return false;
            if (is_passed(here, ignored)) continue;
            if (here != U'[' || wants_branch) break;
            if (partners_[from] == none) return false;
            from = partners_[from];
        }
        if (!wants_branch) {
            if (letter(from) != pattern[wanted]) return false;
            ++wanted;
            ++from;
            continue;
        }
        if (letter(from) != U'[' || partners_[from] == none) return false;
        const std::size_t behind = behind_branch(pattern, wanted);
        const std::u32string_view branch = pattern.substr(wanted + 1, behind - wanted - 2);
        if (!begins_with(from + 1, partners_[from], branch, ignored, depth + 1)) return false;
        wanted = behind;
        from = partners_[from] + 1;
    }
    return true;
}

}  // namespace filigree::rewriting
