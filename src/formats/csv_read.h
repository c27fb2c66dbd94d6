// Tables as text: rows of cells between commas (RFC 4180).
//
// UTF-8, with or without a byte order mark; lines end in LF or CRLF. A cell in quotes may hold commas, line ends and
// doubled quotes. All rows have as many cells as the first, and blanks belong to their cell.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace filigree {

struct CsvRow {
    std::uint32_t line = 1;  // where it begins
    std::vector<std::string> cells;
};

// At least one row of at least one cell. Errors name the line; their place is for the caller to say.
Result<std::vector<CsvRow>> read_csv(std::string_view text);

}  // namespace filigree
