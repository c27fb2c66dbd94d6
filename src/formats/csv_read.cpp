#include "formats/csv_read.h"

#include <algorithm>

#include "base/unicode.h"

namespace filigree {
namespace {

std::uint32_t line_at(std::string_view text, std::size_t offset) {
    return 1 + static_cast<std::uint32_t>(
                   std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

Diagnostic wrong(std::string code, std::uint32_t line, const std::string& what) {
    return error(std::move(code), "line " + std::to_string(line) + " " + what);
}

// The cells of a row, and where they ended.
class Reader {
public:
    explicit Reader(std::string_view text) : text_(text) {}

    Result<std::vector<CsvRow>> read() {
        std::vector<CsvRow> rows;
        while (at_ < text_.size()) {
            CsvRow row{line_, {}};
            do {
                Result<std::string> cell = read_cell();
                if (!cell) return cell.diagnostics();
                row.cells.push_back(std::move(*cell));
            } while (accept(","));
            if (accept("\r\n") || accept("\n")) ++line_;
            if (!rows.empty() && row.cells.size() != rows.front().cells.size()) {
                return wrong("csv.ragged", row.line,
                             "has " + count_text(row) + ", where the first has " + count_text(rows.front()));
            }
            rows.push_back(std::move(row));
        }
        if (rows.empty()) return error("csv.empty", "the table has no cells");
        return rows;
    }

private:
    static std::string count_text(const CsvRow& row) {
        return std::to_string(row.cells.size()) + (row.cells.size() == 1 ? " cell" : " cells");
    }
    bool accept(std::string_view wanted) {
        if (!text_.substr(at_).starts_with(wanted)) return false;
        at_ += wanted.size();
        return true;
    }
    // What ends a cell; a lone CR belongs to it.
    bool is_behind_cell() const {
        const std::string_view rest = text_.substr(at_);
        return rest.empty() || rest[0] == ',' || rest[0] == '\n' || rest.starts_with("\r\n");
    }
    Result<std::string> read_cell() {
        std::string cell;
        if (!accept("\"")) {
            while (!is_behind_cell()) cell += text_[at_++];
            return cell;
        }
        const std::uint32_t begin = line_;
        for (; at_ < text_.size(); ++at_) {
            if (accept("\"\"")) {
                cell += '"';
                --at_;
                continue;
            }
            if (accept("\"")) {
                if (is_behind_cell()) return cell;
                return wrong("csv.text-behind-quote", line_, "goes on behind a closing quote");
            }
            line_ += text_[at_] == '\n' ? 1 : 0;
            cell += text_[at_];
        }
        return wrong("csv.unclosed-quote", begin, "opens a quote that nothing closes");
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::uint32_t line_ = 1;
};

}  // namespace

Result<std::vector<CsvRow>> read_csv(std::string_view text) {
    const std::size_t invalid = unicode::find_invalid(text);
    if (invalid != std::string_view::npos) return wrong("csv.not-utf8", line_at(text, invalid), "is no valid UTF-8");
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    return Reader(text).read();
}

}  // namespace filigree
