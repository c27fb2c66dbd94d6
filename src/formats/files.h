// Files: read whole, written whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"

namespace filigree {

// The bytes of a file; Fault::file where it cannot be read, is a folder, or is larger than `max_bytes`.
Result<std::string> read_file(const std::filesystem::path& path, std::uint64_t max_bytes = 512U << 20);

struct OutputFile {
    std::filesystem::path path;
    std::string bytes;
};
// All temporaries first, beside their targets, then all renames: an error or an interrupt leaves every target
// as it was, and no temporaries. Symbolic links are followed; permissions of an existing target are kept.
// "/dev/stdout" and other files that are not regular are written to directly, last.
Diagnostics write_files(const std::vector<OutputFile>& files);

}  // namespace filigree
