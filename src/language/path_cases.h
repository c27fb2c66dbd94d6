// For tests alone: paths from text without the parser, and paths at random.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/test_cases.h"
#include "language/document.h"

namespace filigree {

// "1,3" as numbers.
inline std::vector<std::uint32_t> numbers_of(std::string_view text) {
    std::vector<std::uint32_t> numbers = {0};
    for (const char c : text) {
        if (c == ',') {
            numbers.push_back(0);
        } else {
            numbers.back() = 10 * numbers.back() + static_cast<std::uint32_t>(c - '0');
        }
    }
    return numbers;
}

// A well-formed path; a dot only before the parameter.
inline ChoicePath path_of(std::string_view text) {
    ChoicePath path;
    if (const std::size_t dot = text.find('.'); dot != text.npos) {
        const std::string_view behind = text.substr(dot + 1);
        const std::size_t tilde = behind.find('~');
        path.parameter = behind.substr(0, tilde);
        if (tilde != behind.npos) path.draw = numbers_of(behind.substr(tilde + 1)).front();
        text = text.substr(0, dot);
    }
    for (std::size_t begin = 0, end = 0; end != text.npos; begin = end + 1) {
        end = text.find('/', begin);
        const std::string_view part = text.substr(begin, end == text.npos ? end : end - begin);
        PathSegment segment;
        if (part == "*" || part == "**") {
            segment.kind = part == "*" ? PathSegment::Kind::any : PathSegment::Kind::any_depth;
        } else if (part.find_first_not_of("0123456789,") == part.npos) {
            segment.kind = PathSegment::Kind::shapes;
            segment.ordinals = numbers_of(part);
        } else {
            const std::size_t bracket = part.find('[');
            segment.name = part.substr(0, bracket);
            if (bracket != part.npos)
                segment.ordinals = numbers_of(part.substr(bracket + 1, part.size() - bracket - 2));
        }
        path.segments.push_back(segment);
    }
    return path;
}

// Numbers from 1 to 3, ascending, each once; never none.
inline std::vector<std::uint32_t> random_numbers(CaseRandom& random) {
    const std::uint32_t chosen = random.whole(1U, 7U);
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t number = 1; number <= 3; ++number) {
        if ((chosen >> (number - 1) & 1U) != 0) numbers.push_back(number);
    }
    return numbers;
}

inline ChoicePath random_path(CaseRandom& random, const std::vector<std::string>& names, std::uint32_t longest) {
    ChoicePath path;
    const std::uint32_t length = random.whole(1U, longest);
    while (path.segments.size() < length) {
        PathSegment segment;
        const std::uint32_t kind = random.below(8);
        const bool may_be_deep = path.segments.empty() || path.segments.back().kind != PathSegment::Kind::any_depth;
        if (kind == 0) {
            segment.kind = PathSegment::Kind::any;
        } else if (kind <= 2 && may_be_deep) {
            segment.kind = PathSegment::Kind::any_depth;
        } else if (kind == 3) {
            segment.kind = PathSegment::Kind::shapes;
            segment.ordinals = random_numbers(random);
        } else {
            segment.name = names[random.index(names.size())];
            if (random.below(4) == 0) segment.ordinals = random_numbers(random);
        }
        path.segments.push_back(segment);
    }
    return path;
}

}  // namespace filigree
