#include "formats/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <optional>
#include <utility>

#include "base/number_text.h"
#include "base/random.h"

namespace filigree {
namespace {

namespace fs = std::filesystem;

Diagnostic file_fault(std::string code, const fs::path& path, std::string_view what, int reason) {
    return fault(Fault::file, std::move(code),
                 "'" + path.string() + "' " + std::string(what) + ": " + std::strerror(reason));
}
Diagnostic cannot_read(const fs::path& path, int reason) {
    return file_fault("files.cannot-read", path, "cannot be read", reason);
}
Diagnostic cannot_write(const fs::path& path, int reason) {
    return file_fault("files.cannot-write", path, "cannot be written", reason);
}

// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool is_open() const { return number_ >= 0; }
    int number() const { return number_; }
    // Some file systems tell of a full disk only when a file is closed.
    int close() {
        const int failed = ::close(std::exchange(number_, -1));
        return failed != 0 && errno != EINTR ? errno : 0;
    }

private:
    int number_;
};

int open_file(const fs::path& path, int flags, mode_t mode = 0) {
    for (;;) {
        const int number = ::open(path.c_str(), flags | O_CLOEXEC, mode);
        if (number >= 0 || errno != EINTR) return number;
    }
}

// 0, or the reason why not all of it was written.
int write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), std::min<std::size_t>(bytes.size(), 1U << 30));
        if (written < 0) {
            if (errno == EINTR) continue;
            return errno;
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

// "/dev/stdout" and its like by number: what the process has open there is written to as it stands, so that
// redirections, also appending ones, do what the shell was told.
std::optional<int> standard_descriptor(const fs::path& path) {
    const std::string text = path.string();
    if (text == "/dev/stdout") return STDOUT_FILENO;
    if (text == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view prefix : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!text.starts_with(prefix)) continue;
        const std::optional<double> number = parse_number(std::string_view(text).substr(prefix.size()));
        if (number && *number >= 0 && *number <= INT_MAX) return static_cast<int>(*number);
    }
    return std::nullopt;
}

// Where a name leads in the end; its last link may lead to what does not exist yet.
fs::path without_links(fs::path path) {
    for (int hops = 0; hops < 40; ++hops) {
        std::error_code failed;
        const fs::path target = fs::read_symlink(path, failed);
        if (failed) break;
        path = target.is_absolute() ? target : path.parent_path() / target;
    }
    return path;
}

// A name beside the target that says whose it is; shortened where the file system would not take it.
fs::path temporary_name(const fs::path& target, int attempt) {
    std::string name = target.filename().string();
    if (name.size() > 200) {
        std::size_t cut = 180;
        while (cut > 0 && (static_cast<unsigned char>(name[cut]) & 0xC0) == 0x80) --cut;
        name = name.substr(0, cut) + to_hex(hash_text(name));
    }
    std::string text = "." + name + "." + std::to_string(::getpid());
    if (attempt > 0) text += "." + std::to_string(attempt + 1);
    return target.parent_path() / (text + ".tmp");
}

struct Target {
    const OutputFile* file = nullptr;
    bool is_direct = false;             // written where it stands
    std::optional<int> descriptor;      // of a direct one: already open
    fs::path path;                      // without links
    std::optional<mode_t> permissions;  // of the file that is there
    fs::path temporary;                 // empty while there is none
    bool is_exchanged = false;          // the temporary's name now holds what was there before
};

Result<Target> target_of(const OutputFile& file) {
    Target target;
    target.file = &file;
    target.descriptor = standard_descriptor(file.path);
    if (target.descriptor) {
        target.is_direct = true;
        return target;
    }
    if (file.path.empty()) return fault(Fault::file, "files.cannot-write", "a file without a name cannot be written");
    struct stat status {};
    if (::stat(file.path.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) return cannot_write(file.path, EISDIR);
        // Replacing would get round a file's write protection.
        if (::access(file.path.c_str(), W_OK) != 0) return cannot_write(file.path, errno);
        target.is_direct = !S_ISREG(status.st_mode);
        target.permissions = status.st_mode & 07777;
    } else if (errno != ENOENT) {
        return cannot_write(file.path, errno);
    }
    target.path = without_links(file.path);
    if (!target.path.has_filename()) return cannot_write(file.path, EISDIR);
    return target;
}

std::optional<Diagnostic> write_temporary(Target& target) {
    int number = -1;
    fs::path name;
    for (int attempt = 0; attempt < 100; ++attempt) {
        name = temporary_name(target.path, attempt);
        number = open_file(name, O_WRONLY | O_CREAT | O_EXCL, 0666);
        if (number >= 0 || errno != EEXIST) break;
    }
    if (number < 0) return cannot_write(target.file->path, errno);
    Descriptor descriptor(number);
    target.temporary = name;
    int reason = write_all(descriptor.number(), target.file->bytes);
    if (reason == 0 && target.permissions && ::fchmod(descriptor.number(), *target.permissions) != 0) reason = errno;
    if (const int failed = descriptor.close(); reason == 0) reason = failed;
    if (reason != 0) return cannot_write(target.file->path, reason);
    return std::nullopt;
}

// Puts the temporary in the target's place. Where asked and where the file system can exchange two names, what
// was there is kept under the temporary's name, so that it can be put back.
std::optional<Diagnostic> put_in_place(Target& target, bool keep_old) {
    if (keep_old && target.permissions &&
        ::renameat2(AT_FDCWD, target.temporary.c_str(), AT_FDCWD, target.path.c_str(), RENAME_EXCHANGE) == 0) {
        target.is_exchanged = true;
        return std::nullopt;
    }
    if (::rename(target.temporary.c_str(), target.path.c_str()) != 0) return cannot_write(target.file->path, errno);
    target.temporary.clear();
    return std::nullopt;
}

void put_back(Target& target) {
    if (target.is_exchanged) {
        ::renameat2(AT_FDCWD, target.temporary.c_str(), AT_FDCWD, target.path.c_str(), RENAME_EXCHANGE);
        target.is_exchanged = false;
    } else if (!target.permissions && target.temporary.empty()) {
        ::unlink(target.path.c_str());
    }
}

void remove_temporaries(const std::vector<Target*>& targets) {
    for (Target* target : targets) {
        if (!target->temporary.empty()) ::unlink(target->temporary.c_str());
        target->temporary.clear();
    }
}

Diagnostics replace_files(const std::vector<Target*>& targets) {
    for (Target* target : targets) {
        if (const std::optional<Diagnostic> failed = write_temporary(*target)) {
            remove_temporaries(targets);
            return {*failed};
        }
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (const std::optional<Diagnostic> failed = put_in_place(*targets[i], i + 1 < targets.size())) {
            for (std::size_t k = 0; k < i; ++k) put_back(*targets[k]);
            remove_temporaries(targets);
            return {*failed};
        }
    }
    remove_temporaries(targets);
    return {};
}

std::optional<Diagnostic> write_direct(const Target& target) {
    if (target.descriptor) {
        const int reason = write_all(*target.descriptor, target.file->bytes);
        if (reason != 0) return cannot_write(target.file->path, reason);
        return std::nullopt;
    }
    Descriptor descriptor(open_file(target.file->path, O_WRONLY | O_NOCTTY));
    if (!descriptor.is_open()) return cannot_write(target.file->path, errno);
    int reason = write_all(descriptor.number(), target.file->bytes);
    if (const int failed = descriptor.close(); reason == 0) reason = failed;
    if (reason != 0) return cannot_write(target.file->path, reason);
    return std::nullopt;
}

// Whether two names lead to one place: the same file in the same folder.
bool is_same_place(const Target& a, const Target& b) {
    std::error_code failed;
    const fs::path folder_a = a.path.parent_path().empty() ? "." : a.path.parent_path();
    const fs::path folder_b = b.path.parent_path().empty() ? "." : b.path.parent_path();
    return a.path.filename() == b.path.filename() && fs::equivalent(folder_a, folder_b, failed) && !failed;
}

}  // namespace

Result<std::string> read_file(const fs::path& path, std::uint64_t max_bytes) {
    Descriptor descriptor(open_file(path, O_RDONLY | O_NOCTTY));
    if (!descriptor.is_open()) return cannot_read(path, errno);
    struct stat status {};
    if (::fstat(descriptor.number(), &status) != 0) return cannot_read(path, errno);
    if (S_ISDIR(status.st_mode)) return cannot_read(path, EISDIR);
    const auto too_large = [&] {
        return fault(Fault::file, "files.too-large",
                     "'" + path.string() + "' is larger than " + to_text(max_bytes) + " bytes, the most that is read");
    };
    if (S_ISREG(status.st_mode) && static_cast<std::uint64_t>(status.st_size) > max_bytes) return too_large();
    // One byte more than the size that is told: the end is where nothing more comes, as pipes know no size.
    std::string bytes(static_cast<std::size_t>(S_ISREG(status.st_mode) ? status.st_size : 0) + 1, '\0');
    std::size_t size = 0;
    for (;;) {
        if (size == bytes.size()) bytes.resize(bytes.size() * 2 + 4096);
        const ssize_t got = ::read(descriptor.number(), bytes.data() + size, bytes.size() - size);
        if (got < 0) {
            if (errno == EINTR) continue;
            return cannot_read(path, errno);
        }
        if (got == 0) break;
        size += static_cast<std::size_t>(got);
        if (size > max_bytes) return too_large();
    }
    bytes.resize(size);
    return bytes;
}

Diagnostics write_files(const std::vector<OutputFile>& files) {
    Diagnostics wrong;
    std::vector<Target> targets;
    for (const OutputFile& file : files) {
        Result<Target> target = target_of(file);
        if (target) {
            targets.push_back(*std::move(target));
        } else {
            append(wrong, std::move(target).diagnostics());
        }
    }
    if (!wrong.empty()) return wrong;

    std::vector<Target*> replaced, direct;
    for (Target& target : targets) {
        if (target.is_direct) {
            direct.push_back(&target);
            continue;
        }
        for (const Target* other : replaced) {
            if (!is_same_place(*other, target)) continue;
            return {fault(Fault::usage, "files.same-target",
                          "'" + target.file->path.string() + "' would be written twice")};
        }
        replaced.push_back(&target);
    }
    if (Diagnostics failed = replace_files(replaced); !failed.empty()) return failed;
    for (const Target* target : direct) {
        if (std::optional<Diagnostic> failed = write_direct(*target)) wrong.push_back(*std::move(failed));
    }
    return wrong;
}

}  // namespace filigree
