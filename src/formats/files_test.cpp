#include "formats/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace filigree {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "filigree-files-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path at(const std::string& name) const { return folder_ / name; }
    void put(const std::string& name, const std::string& bytes) const {
        std::ofstream(at(name), std::ios::binary) << bytes;
    }
    std::string get(const std::string& name) const {
        std::ostringstream bytes;
        bytes << std::ifstream(at(name), std::ios::binary).rdbuf();
        return bytes.str();
    }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : fs::directory_iterator(folder_)) all.push_back(entry.path().filename().string());
        std::sort(all.begin(), all.end());
        return all;
    }
    static std::string code_of(const Diagnostics& diagnostics) {
        return diagnostics.empty() ? "" : diagnostics[0].code;
    }

    fs::path folder_;
};
using Names = std::vector<std::string>;

TEST_F(Files, WriteAndReadBack) {
    std::string bytes;
    for (int i = 0; i < 100'000; ++i) bytes += static_cast<char>(i * 7);
    EXPECT_TRUE(write_files({{at("a"), bytes}, {at("b"), ""}}).empty());
    EXPECT_EQ(*read_file(at("a")), bytes);
    EXPECT_EQ(*read_file(at("b")), "");
    EXPECT_EQ(names(), (Names{"a", "b"}));
    EXPECT_TRUE(write_files({{at("a"), "new"}, {at("b"), "too"}, {at("c"), "!"}}).empty());
    EXPECT_EQ(get("a") + get("b") + get("c"), "newtoo!");
    EXPECT_EQ(names(), (Names{"a", "b", "c"}));
    EXPECT_TRUE(write_files({}).empty());
}

TEST_F(Files, WhatCannotBeRead) {
    const Result<std::string> missing = read_file(at("missing"));
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.diagnostics()[0].code, "files.cannot-read");
    EXPECT_EQ(missing.diagnostics()[0].fault, Fault::file);
    EXPECT_NE(missing.diagnostics()[0].message.find("No such file"), std::string::npos);
    const Result<std::string> folder = read_file(folder_);
    ASSERT_FALSE(folder);
    EXPECT_NE(folder.diagnostics()[0].message.find("directory"), std::string::npos);
    put("large", "12345");
    EXPECT_EQ(code_of(read_file(at("large"), 4).diagnostics()), "files.too-large");
    EXPECT_TRUE(read_file(at("large"), 5));
    EXPECT_EQ(code_of(read_file("/dev/zero", 10'000).diagnostics()), "files.too-large");
    EXPECT_EQ(*read_file("/dev/null"), "");
}

TEST_F(Files, AnUnwritableTargetLeavesAllOthers) {
    put("first", "old");
    fs::create_directory(at("folder"));
    for (const fs::path& second : {at("folder"), at("no/such/folder/file"), at("first/file"), fs::path()}) {
        const Diagnostics failed = write_files({{at("first"), "new"}, {second, "x"}, {at("third"), "y"}});
        ASSERT_EQ(failed.size(), 1U) << second;
        EXPECT_EQ(failed[0].code, "files.cannot-write");
        EXPECT_EQ(failed[0].fault, Fault::file);
        EXPECT_EQ(get("first"), "old");
        EXPECT_EQ(names(), (Names{"first", "folder"}));
    }
}

TEST_F(Files, WriteProtectionHolds) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
    put("first", "old");
    put("kept", "old");
    fs::permissions(at("kept"), fs::perms::owner_read);
    EXPECT_EQ(code_of(write_files({{at("first"), "new"}, {at("kept"), "new"}})), "files.cannot-write");
    EXPECT_EQ(get("first") + get("kept"), "oldold");
}

TEST_F(Files, SameTargetTwice) {
    fs::create_directory(at("d"));
    for (const auto& [a, b] :
         std::vector<std::pair<std::string, std::string>>{{"x", "x"}, {"x", "d/../x"}, {"./x", "x"}}) {
        const Diagnostics failed = write_files({{at(a), "1"}, {at(b), "2"}});
        EXPECT_EQ(code_of(failed), "files.same-target");
        EXPECT_EQ(names(), (Names{"d"}));
    }
    EXPECT_TRUE(write_files({{at("x"), "1"}, {at("d/x"), "2"}}).empty());
}

TEST_F(Files, LinksAreFollowedAndPermissionsKept) {
    put("real", "old");
    fs::permissions(at("real"), fs::perms(0640));
    fs::create_symlink("real", at("link"));
    fs::create_symlink(at("link"), at("link2"));
    fs::create_symlink("not-yet", at("dangling"));
    EXPECT_TRUE(write_files({{at("link2"), "new"}, {at("dangling"), "made"}}).empty());
    EXPECT_TRUE(fs::is_symlink(at("link")) && fs::is_symlink(at("link2")) && fs::is_symlink(at("dangling")));
    EXPECT_EQ(get("real"), "new");
    EXPECT_EQ(get("not-yet"), "made");
    struct stat status {};
    ASSERT_EQ(::stat(at("real").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0640U);
    // A circle of links leads nowhere.
    fs::create_symlink("c2", at("c1"));
    fs::create_symlink("c1", at("c2"));
    EXPECT_EQ(code_of(write_files({{at("c1"), "x"}})), "files.cannot-write");
}

TEST_F(Files, NewFilesFollowTheMask) {
    const mode_t before = ::umask(027);
    EXPECT_TRUE(write_files({{at("new"), "x"}}).empty());
    ::umask(before);
    struct stat status {};
    ASSERT_EQ(::stat(at("new").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0640U);
}

TEST_F(Files, LongNamesAndLeftovers) {
    const std::string name(250, 'n');
    EXPECT_TRUE(write_files({{at(name), "x"}}).empty());
    EXPECT_EQ(get(name), "x");
    const std::string leftover = ".a." + std::to_string(::getpid()) + ".tmp";
    put(leftover, "of a run that was killed");
    EXPECT_TRUE(write_files({{at("a"), "x"}}).empty());
    EXPECT_EQ(get("a"), "x");
    EXPECT_EQ(get(leftover), "of a run that was killed");
}

TEST_F(Files, WhatIsNoRegularFileIsWrittenTo) {
    EXPECT_TRUE(write_files({{"/dev/null", "x"}}).empty());
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    if (fs::exists("/dev/full")) {
        const Diagnostics failed = write_files({{"/dev/full", "x"}});
        EXPECT_EQ(code_of(failed), "files.cannot-write");
    }
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    EXPECT_TRUE(write_files({{"/dev/fd/" + std::to_string(ends[1]), "hello"}, {at("file"), "too"}}).empty());
    char got[8] = {};
    EXPECT_EQ(::read(ends[0], got, 8), 5);
    EXPECT_STREQ(got, "hello");
    EXPECT_EQ(get("file"), "too");
    ::close(ends[0]);
    ::close(ends[1]);
}

}  // namespace
}  // namespace filigree
