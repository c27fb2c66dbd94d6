// Runs a fuzzer's function over every file of the folders named, in the order of their names: the corpus as a
// test that any compiler can build.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int count, char** arguments) {
    std::vector<std::filesystem::path> files;
    for (int i = 1; i < count; ++i) {
        std::error_code problem;
        for (std::filesystem::recursive_directory_iterator entry(arguments[i], problem), end; !problem && entry != end;
             entry.increment(problem)) {
            if (entry->is_regular_file()) files.push_back(entry->path());
        }
        if (problem) {
            std::cerr << arguments[i] << ": " << problem.message() << "\n";
            return 3;
        }
    }
    if (files.empty()) {
        std::cerr << "usage: replay FOLDER... (with at least one file)\n";
        return 2;
    }
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& path : files) {
        std::ifstream file(path, std::ios::binary);
        const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
        if (!file.is_open()) {
            std::cerr << path.string() << ": cannot be read\n";
            return 3;
        }
        // Named beforehand, so that a crash tells its input.
        std::cout << path.filename().string() << std::endl;
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    }
    std::cout << files.size() << " inputs replayed\n";
    return 0;
}
