// The arrows between the layers point down only; see docs/architecture.md. Reads the sources as text.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 13> layers = {"base",    "plane",   "curves",   "space",      "mesh",
                                                     "scene",   "formats", "language", "derivation", "engines",
                                                     "session", "study",   "apps"};

std::size_t layer_of(const fs::path& path) {
    return static_cast<std::size_t>(std::find(layers.begin(), layers.end(), path.begin()->string()) - layers.begin());
}

std::string engine_of(const fs::path& path) {
    const auto first = path.begin();
    return *first == "engines" && std::next(first) != path.end() ? std::next(first)->string() : "";
}

std::vector<fs::path> sources_below(const fs::path& root) {  // relative to the root
    std::vector<fs::path> paths;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const std::string ending = entry.path().extension().string();
        if (ending == ".h" || ending == ".cpp") paths.push_back(fs::relative(entry.path(), root));
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

// What an include line names, with its quotes or brackets; empty for any other line.
std::string included(const std::string& line) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') return "";
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) return "";
    const std::size_t begin = line.find_first_of("\"<", word);
    const std::size_t end = begin == std::string::npos ? begin : line.find_first_of("\">", begin + 1);
    return end == std::string::npos ? "" : line.substr(begin, end - begin + 1);
}

// Why a source may not include something, or an empty text.
std::string objection(const fs::path& source, const std::string& name) {
    const bool is_engine = *source.begin() == "engines";
    const bool is_test = source.stem().string().ends_with("_test");
    if (name.front() == '<') {
        return is_engine && !is_test && (name == "<fstream>" || name == "<filesystem>") ? "engines open no files" : "";
    }
    const fs::path target = name.substr(1, name.size() - 2);
    if (layer_of(target) == layers.size()) return "includes are written from src/";
    if (layer_of(target) > layer_of(source)) return "that goes up the layers";
    if (is_engine && *target.begin() == "engines" && engine_of(target) != engine_of(source)) {
        return "engines never include each other";
    }
    if (*source.begin() == "language" && (*target.begin() == "curves" || *target.begin() == "space" ||
                                          *target.begin() == "mesh" || *target.begin() == "formats")) {
        return "of geometry, the language knows only the plane, and what is drawn";
    }
    return "";
}

TEST(Layering, ObjectsToWrongIncludes) {
    EXPECT_EQ(objection("plane/clean.cpp", "\"base/result.h\""), "");
    EXPECT_EQ(objection("engines/tangle/derive.cpp", "\"engines/tangle/operators/place.h\""), "");
    EXPECT_EQ(objection("engines/tangle/derive.cpp", "<vector>"), "");
    EXPECT_NE(objection("base/result.h", "\"plane/point.h\""), "");
    EXPECT_NE(objection("plane/clean.cpp", "\"result.h\""), "");
    EXPECT_NE(objection("engines/tangle/derive.cpp", "\"engines/shape/derive.h\""), "");
    EXPECT_NE(objection("engines/tangle/derive.cpp", "<fstream>"), "");
    EXPECT_NE(objection("language/parse.cpp", "\"formats/svg_read.h\""), "");
    EXPECT_NE(objection("language/style.h", "\"space/vector.h\""), "");
    EXPECT_EQ(objection("language/style.h", "\"scene/drawing.h\""), "");
    EXPECT_EQ(included("  #  include \"base/result.h\"  // why"), "\"base/result.h\"");
    EXPECT_EQ(included("// #include <vector>"), "");
}

TEST(Layering, IncludesPointDown) {
    const fs::path root = fs::path(FILIGREE_SOURCE_DIR) / "src";
    const std::vector<fs::path> sources = sources_below(root);
    EXPECT_GT(sources.size(), 10u);
    for (const fs::path& source : sources) {
        EXPECT_LT(layer_of(source), layers.size()) << source << " lies in no layer";
        std::ifstream in(root / source);
        std::size_t number = 0;
        bool has_pragma = false;
        for (std::string line; std::getline(in, line);) {
            ++number;
            has_pragma = has_pragma || line == "#pragma once";
            if (number == 1 && source.extension() == ".h") {
                EXPECT_TRUE(line.starts_with("//")) << source << " does not open with a comment";
            }
            const std::string name = included(line);
            if (name.empty()) continue;
            EXPECT_EQ(objection(source, name), "") << source.string() << ":" << number << " includes " << name;
        }
        EXPECT_TRUE(source.extension() != ".h" || has_pragma) << source << " has no #pragma once";
    }
}

}  // namespace
