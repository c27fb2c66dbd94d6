// The commands of the program. Each takes its options as data and returns the exit status.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engines/tangle/draw.h"
#include "session/open.h"

namespace filigree {

struct RenderCommand {
    std::filesystem::path document;
    std::vector<std::filesystem::path> outputs;
    OpenOptions open;
    std::optional<std::uint64_t> steps;
    std::size_t threads = 0;      // 0: as many as the machine has
    std::filesystem::path stats;  // empty: none
    tangle::ColourBy colour_by = tangle::ColourBy::style;
    double dpi = 192;  // of PNG
    bool verify = false;
    bool lean = false;
    bool watch = false;
};
int run_render(const RenderCommand& command);

struct CheckCommand {
    std::filesystem::path document;
    OpenOptions open;
    bool json = false;
};
int run_check(const CheckCommand& command);

struct DeriveCommand {
    std::filesystem::path document;
    OpenOptions open;
    std::optional<std::uint64_t> steps;
    std::size_t threads = 0;
    bool json = false;
};
int run_derive(const DeriveCommand& command);

struct DescribeCommand {
    std::string name;  // empty with `markdown` or `json`
    bool markdown = false;
    bool json = false;
};
int run_describe(const DescribeCommand& command);
int run_list();

}  // namespace filigree
