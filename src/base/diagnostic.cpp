#include "base/diagnostic.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <tuple>
#include <utility>

#include "base/number_text.h"
#include "base/unicode.h"

namespace filigree {

namespace {

// Columns of a source line that are shown, and how many of them before the span where the line is cut.
constexpr std::size_t shown_columns = 100;
constexpr std::size_t columns_before_span = 30;
constexpr std::string_view cut_mark = "...";

bool is_shown(char32_t code_point) {
    if (code_point < 0x20 || (code_point >= 0x7F && code_point < 0xA0)) return false;
    // Line separators and marks of direction would move the text that follows them.
    return !(code_point == 0x2028 || code_point == 0x2029 || (code_point >= 0x200E && code_point <= 0x200F) ||
             (code_point >= 0x202A && code_point <= 0x202E) || (code_point >= 0x2066 && code_point <= 0x2069));
}

// What may stand on a terminal: tabs as one blank, anything that would not show as itself as '?'.
void append_printable(std::string& out, std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const unicode::Decoded decoded = unicode::decode(text, i);
        if (decoded.code_point == '\t') {
            out += ' ';
        } else if (decoded.valid && is_shown(decoded.code_point)) {
            out += text.substr(i, decoded.length);
        } else {
            out += '?';
        }
        i += decoded.length;
    }
}

// Walks forwards through one text, so that the places of many sorted diagnostics cost one pass together.
class PlaceFinder {
public:
    explicit PlaceFinder(std::string_view text) : text_(text) {}

    LineColumn find(std::size_t offset) {
        offset = std::min(offset, text_.size());
        if (offset < at_) *this = PlaceFinder(text_);
        while (at_ < offset) {
            const void* found = std::memchr(text_.data() + at_, '\n', offset - at_);
            if (found == nullptr) break;
            at_ = static_cast<std::size_t>(static_cast<const char*>(found) - text_.data()) + 1;
            ++place_.line;
            place_.column = 1;
        }
        while (at_ < offset) {
            const std::size_t next = at_ + unicode::decode(text_, at_).length;
            if (next > offset) break;
            at_ = next;
            ++place_.column;
        }
        return place_;
    }

private:
    std::string_view text_;
    std::size_t at_ = 0;
    LineColumn place_;
};

bool has_place(const Diagnostic& diagnostic, const Sources& sources) { return diagnostic.span.file < sources.size(); }

// The start of the character that the byte at `at` belongs to.
std::size_t character_start(std::string_view line, std::size_t at) {
    for (std::size_t back = 1; back <= 3 && back <= at; ++back) {
        const unicode::Decoded decoded = unicode::decode(line, at - back);
        if (decoded.valid && decoded.length > back) return at - back;
    }
    return at;
}

// How many characters start in [begin, end); `begin` is the start of one.
std::size_t count_columns(std::string_view line, std::size_t begin, std::size_t end) {
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; i += unicode::decode(line, i).length) ++count;
    return count;
}

// Where the character starts that comes `columns` after the one at `begin`, or the line's end.
std::size_t skip_columns(std::string_view line, std::size_t begin, std::size_t columns) {
    std::size_t i = begin;
    for (; i < line.size() && columns > 0; --columns) i += unicode::decode(line, i).length;
    return i;
}

void append_excerpt(std::string& out, std::string_view text, SourceSpan span) {
    const std::size_t begin = std::min<std::size_t>(span.begin, text.size());
    const std::size_t break_before = begin == 0 ? std::string_view::npos : text.rfind('\n', begin - 1);
    const std::size_t line_begin = break_before == std::string_view::npos ? 0 : break_before + 1;
    std::string_view line = text.substr(line_begin, text.find('\n', begin) - line_begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty()) return;

    std::size_t from = std::min(begin - line_begin, line.size());
    if (from < line.size()) from = character_start(line, from);
    const std::size_t to = span.end < line_begin ? from : std::clamp(span.end - line_begin, from, line.size());

    std::size_t shown_from = 0;
    std::size_t shown_to = skip_columns(line, 0, shown_columns);
    if (shown_to < line.size()) {
        // The line is too long: a window with the span's start in it.
        if (const std::size_t columns = count_columns(line, 0, from); columns > shown_columns * 2 / 3) {
            shown_from = from;
            for (std::size_t i = 0; i < columns_before_span; ++i) shown_from = character_start(line, shown_from - 1);
            shown_to = skip_columns(line, shown_from, shown_columns);
        }
    }

    out += "    ";
    if (shown_from > 0) out += cut_mark;
    append_printable(out, line.substr(shown_from, shown_to - shown_from));
    if (shown_to < line.size()) out += cut_mark;
    out += "\n    ";
    if (shown_from > 0) out.append(cut_mark.size(), ' ');
    out.append(count_columns(line, shown_from, from), ' ');
    out += '^';
    const std::size_t columns = count_columns(line, from, std::min(to, shown_to));
    if (columns > 1) out.append(columns - 1, '~');
    out += '\n';
}

void append_text(std::string& out, const Diagnostic& diagnostic, const Sources& sources, LineColumn place) {
    if (has_place(diagnostic, sources)) {
        append_printable(out, sources[diagnostic.span.file].name);
        out += ':' + to_text(std::uint64_t{place.line}) + ':' + to_text(std::uint64_t{place.column});
    } else {
        out += "filigree";
    }
    out += diagnostic.severity == Severity::error ? ": error: " : ": warning: ";
    append_printable(out, diagnostic.message);
    if (!diagnostic.code.empty()) out += " [" + diagnostic.code + "]";
    out += '\n';
    if (has_place(diagnostic, sources)) append_excerpt(out, sources[diagnostic.span.file].text, diagnostic.span);
    for (const std::string& hint : diagnostic.hints) {
        out += "  hint: ";
        append_printable(out, hint);
        out += '\n';
    }
}

}  // namespace

SourceSpan span_over(SourceSpan first, SourceSpan last) {
    if (first.file == SourceSpan::no_file) return last;
    if (last.file != first.file) return first;
    return {first.file, std::min(first.begin, last.begin), std::max(first.end, last.end)};
}

Diagnostic error(std::string code, std::string message, SourceSpan span, std::vector<std::string> hints) {
    return {Severity::error, std::move(code), std::move(message), span, std::move(hints), Fault::document};
}

Diagnostic warning(std::string code, std::string message, SourceSpan span, std::vector<std::string> hints) {
    return {Severity::warning, std::move(code), std::move(message), span, std::move(hints), Fault::document};
}

Diagnostic fault(Fault kind, std::string code, std::string message, SourceSpan span) {
    return {Severity::error, std::move(code), std::move(message), span, {}, kind};
}

bool has_errors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
}

void append(Diagnostics& to, Diagnostics from) {
    if (to.empty()) {
        to = std::move(from);
        return;
    }
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

LineColumn line_column(std::string_view text, std::uint32_t offset) { return PlaceFinder(text).find(offset); }

std::string to_text(const Diagnostic& diagnostic, const Sources& sources) {
    LineColumn place;
    if (has_place(diagnostic, sources)) {
        place = line_column(sources[diagnostic.span.file].text, diagnostic.span.begin);
    }
    std::string out;
    append_text(out, diagnostic, sources, place);
    return out;
}

std::string to_text(const Diagnostics& diagnostics, const Sources& sources) {
    std::vector<const Diagnostic*> sorted;
    sorted.reserve(diagnostics.size());
    for (const Diagnostic& diagnostic : diagnostics) sorted.push_back(&diagnostic);
    // Their addresses are in the order that they came in.
    std::sort(sorted.begin(), sorted.end(), [](const Diagnostic* a, const Diagnostic* b) {
        return std::tie(a->span.file, a->span.begin, a) < std::tie(b->span.file, b->span.begin, b);
    });

    const auto is_less = [](const Diagnostic* a, const Diagnostic* b) {
        const auto fields = [](const Diagnostic* d) {
            return std::tie(d->span.file, d->span.begin, d->span.end, d->severity, d->code, d->message, d->hints);
        };
        return fields(a) < fields(b);
    };
    std::set<const Diagnostic*, decltype(is_less)> written(is_less);

    std::string out;
    std::uint32_t file = SourceSpan::no_file;
    PlaceFinder finder("");
    for (const Diagnostic* diagnostic : sorted) {
        if (!written.insert(diagnostic).second) continue;
        LineColumn place;
        if (has_place(*diagnostic, sources)) {
            if (diagnostic->span.file != file) {
                file = diagnostic->span.file;
                finder = PlaceFinder(sources[file].text);
            }
            place = finder.find(diagnostic->span.begin);
        }
        append_text(out, *diagnostic, sources, place);
    }
    return out;
}

}  // namespace filigree
