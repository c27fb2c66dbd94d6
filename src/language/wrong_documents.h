// For tests: wrong documents and what is to be said about them, read from tests/data/wrong_documents.txt.
//
//   === the case's name
//   the document, line by line
//   ---
//   LINE:COLUMN code | a part of one of the hints
//
// The expectations are the whole list of diagnostics, warnings too, in the order of places; the `| hint` may be
// left out. Which layer a case is for shows in its codes. Characters that no one sees stand as their
// pictures: U+2409 tab, U+240D carriage return, U+2400 NUL, U+2423 no-break space, U+2402 byte order mark,
// U+FFFD the byte FF, U+2403 (last) a document without a final line end. Lines of `#` before the first case are a
// comment.
#pragma once

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostic.h"

namespace filigree {

struct ExpectedDiagnostic {
    LineColumn place;
    std::string code;
    std::string hint;  // a part of one; empty: any or none
};

struct WrongDocument {
    std::string name;
    std::string text;
    std::vector<ExpectedDiagnostic> expected;
    std::string malformed;  // the line of the case that cannot be read, if there is one
};

inline std::string with_unseen_characters(std::string text) {
    const auto replace = [&](std::string_view picture, std::string_view character) {
        for (std::size_t i = 0; (i = text.find(picture, i)) != std::string::npos; i += character.size()) {
            text.replace(i, picture.size(), character);
        }
    };
    replace("\xE2\x90\x89", "\t");
    replace("\xE2\x90\x8D", "\r");
    replace("\xE2\x90\x80", std::string_view("\0", 1));
    replace("\xE2\x90\xA3", "\xC2\xA0");
    replace("\xE2\x90\x82", "\xEF\xBB\xBF");
    replace("\xEF\xBF\xBD", "\xFF");
    replace("\xE2\x90\x83\n", "");
    return text;
}

inline bool read_expectation(std::string_view line, ExpectedDiagnostic& into) {
    constexpr std::string_view digits = "0123456789";
    const auto number = [&](std::uint32_t& value) {
        const std::size_t length = std::min(line.find_first_not_of(digits), line.size());
        for (const char c : line.substr(0, length)) value = value * 10 + static_cast<std::uint32_t>(c - '0');
        line.remove_prefix(length);
        return length > 0;
    };
    const auto sign = [&](std::string_view wanted) {
        const bool is_there = line.substr(0, wanted.size()) == wanted;
        if (is_there) line.remove_prefix(wanted.size());
        return is_there;
    };
    into.place = {0, 0};
    if (!number(into.place.line) || !sign(":") || !number(into.place.column) || !sign(" ")) return false;
    const std::size_t bar = line.find(" | ");
    into.code = line.substr(0, bar);
    if (bar != std::string_view::npos) into.hint = line.substr(bar + 3);
    return !into.code.empty() && into.code.find(' ') == std::string::npos;
}

inline std::vector<WrongDocument> read_wrong_documents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<WrongDocument> cases;
    bool is_document = false;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("=== ")) {
            cases.push_back({line.substr(4), "", {}, ""});
            is_document = true;
        } else if (cases.empty() || (!is_document && line.empty())) {
            continue;
        } else if (is_document && line == "---") {
            cases.back().text = with_unseen_characters(std::move(cases.back().text));
            is_document = false;
        } else if (is_document) {
            cases.back().text += line + "\n";
        } else {
            ExpectedDiagnostic expected;
            if (!read_expectation(line, expected)) cases.back().malformed = line;
            cases.back().expected.push_back(std::move(expected));
        }
    }
    return cases;
}

// What is wrong with the diagnostics of a case; empty if they are as expected.
inline std::string difference(const WrongDocument& wrong, const Diagnostics& found, const Sources& sources) {
    if (!wrong.malformed.empty()) return "the case has a malformed line: " + wrong.malformed;
    std::string problem;
    for (std::size_t i = 0; i < std::max(found.size(), wrong.expected.size()); ++i) {
        if (i >= wrong.expected.size()) {
            problem += "not expected:\n";
        } else if (i >= found.size()) {
            problem += "missing: " + wrong.expected[i].code + "\n";
            continue;
        } else {
            const ExpectedDiagnostic& expected = wrong.expected[i];
            const auto has_hint = [&](const std::string& hint) {
                return hint.find(expected.hint) != std::string::npos;
            };
            const bool is_hinted =
                expected.hint.empty() || std::any_of(found[i].hints.begin(), found[i].hints.end(), has_hint);
            const bool has_place = found[i].span.file < sources.size();
            const LineColumn place =
                has_place ? line_column(sources[found[i].span.file].text, found[i].span.begin) : LineColumn{0, 0};
            if (place == expected.place && found[i].code == expected.code && is_hinted) continue;
            problem += "expected " + std::to_string(expected.place.line) + ":" + std::to_string(expected.place.column) +
                       " " + expected.code + (expected.hint.empty() ? "" : " | " + expected.hint) + ", found:\n";
        }
        problem += to_text(found[i], sources);
    }
    return problem.empty() ? problem : "in the case '" + wrong.name + "':\n" + problem;
}

// In the order of places, as they are printed; what has no place goes first.
inline Diagnostics by_place(Diagnostics diagnostics) {
    std::vector<std::pair<std::uint64_t, std::size_t>> order;
    for (std::size_t i = 0; i < diagnostics.size(); ++i) {
        const SourceSpan& span = diagnostics[i].span;
        order.emplace_back(span.file == SourceSpan::no_file ? 0 : span.begin + std::uint64_t{1}, i);
    }
    std::sort(order.begin(), order.end());
    Diagnostics sorted;
    for (const auto& [place, index] : order) sorted.push_back(std::move(diagnostics[index]));
    return sorted;
}

}  // namespace filigree
