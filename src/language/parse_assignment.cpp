// PATH=VALUE of a command line.
#include "language/parse.h"
#include "language/token_text.h"

namespace filigree {

namespace {

std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// The '=' that separates, or npos.
std::size_t separator(std::string_view text) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') {
            for (++i; i < text.size() && text[i] != '"'; ++i) {
                if (text[i] == '\\') ++i;
            }
        } else if (c == '(' || c == '[' || c == '{') {
            ++depth;
        } else if (c == ')' || c == ']' || c == '}') {
            --depth;
        } else if (c == '=' || c == '<' || c == '>' || c == '!') {
            const bool is_comparison = i + 1 < text.size() && text[i + 1] == '=';
            if (is_comparison)
                ++i;
            else if (c == '=' && depth == 0)
                return i;
        }
    }
    return std::string_view::npos;
}

Diagnostic wrong(std::string_view text, std::string_view code, const std::string& problem) {
    Diagnostic diagnostic = fault(Fault::usage, std::string(code), in_quotes(text) + " " + problem);
    diagnostic.hints = {"a value is given as PATH=VALUE, as in 'leaf/outline.distance=25'"};
    return diagnostic;
}

}  // namespace

Result<Assignment> split_assignment(std::string_view text) {
    const std::size_t at = separator(text);
    if (at == std::string_view::npos) return wrong(text, "language.missing-equals", "has no '='");
    const std::string_view path = without_blanks(text.substr(0, at)), value = without_blanks(text.substr(at + 1));
    if (path.empty()) return wrong(text, "language.missing-path", "has no path before its '='");
    if (value.empty()) return wrong(text, "language.missing-value", "has no value behind its '='");
    return Assignment{std::string(path), std::string(value)};
}

}  // namespace filigree
