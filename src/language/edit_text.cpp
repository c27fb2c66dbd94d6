#include "language/edit_text.h"

#include "language/lexer.h"

namespace filigree {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

std::string spliced(std::string_view text, std::size_t begin, std::size_t end, std::string_view with) {
    std::string result;
    result.reserve(text.size() - (end - begin) + with.size());
    result += text.substr(0, begin);
    result += with;
    result += text.substr(end);
    return result;
}

std::string_view text_of(const Expression& expression, std::string_view text) {
    return text.substr(expression.span.begin, expression.span.end - expression.span.begin);
}

std::string with_last_line(std::string_view text, std::string_view line) {
    const std::size_t last = text.rfind('\n');
    const bool has_returns = last != std::string_view::npos && last > 0 && text[last - 1] == '\r';
    const std::string line_end = has_returns ? "\r\n" : "\n";
    const bool is_open = text.size() > text_start(text) && text.back() != '\n';
    return std::string(text) + (is_open ? line_end : "") + std::string(line) + line_end;
}

std::string without_statement(std::string_view text, std::uint32_t begin, std::uint32_t end) {
    std::size_t first = begin, last = end;
    const auto skip_blanks_before = [&] {
        while (first > text_start(text) && is_blank(text[first - 1])) --first;
    };
    const auto skip_blanks_behind = [&] {
        while (last < text.size() && is_blank(text[last])) ++last;
    };
    const auto at_line_begin = [&] { return first == text_start(text) || text[first - 1] == '\n'; };
    const auto at_line_end = [&] { return last == text.size() || text[last] == '\n'; };

    skip_blanks_before();
    skip_blanks_behind();
    const bool has_more_before = !at_line_begin();  // a ';' stands there
    const bool has_semicolon_behind = last < text.size() && text[last] == ';';
    if (has_more_before) {
        --first;
        last = end;
    } else if (has_semicolon_behind) {
        ++last;
        skip_blanks_behind();
    }
    const std::size_t cut_begin = has_more_before ? first : begin, cut_end = last;

    skip_blanks_before();
    skip_blanks_behind();
    if (!at_line_begin() || !at_line_end()) return spliced(text, cut_begin, cut_end, "");
    return spliced(text, first, last < text.size() ? last + 1 : last, "");
}

}  // namespace filigree
