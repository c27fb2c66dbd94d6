// For tests alone: a small reader of PDFs that shares nothing with the writer.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace filigree {

struct TestPdf {
    std::map<std::size_t, std::string> objects;  // the text between "obj" and "endobj", by number
    std::string trailer;

    // What stands behind a key, up to the next key or the end of the dictionary.
    static std::string value(const std::string& dictionary, const std::string& key) {
        std::size_t at = dictionary.find(key + " ");
        if (at == std::string::npos) return "";
        at += key.size() + 1;
        const std::size_t end = dictionary.find_first_of("/>]", dictionary[at] == '[' ? dictionary.find(']', at) : at);
        const std::string text = dictionary.substr(at, end - at + (dictionary[end] == ']' ? 1 : 0));
        return text.substr(0, text.find_last_not_of(" \n") + 1);
    }
    std::string object(const std::string& reference) const {  // "7 0 R"
        const auto found = objects.find(std::strtoul(reference.c_str(), nullptr, 10));
        EXPECT_NE(found, objects.end()) << reference;
        return found == objects.end() ? "" : found->second;
    }
    std::string catalog() const { return object(value(trailer, "/Root")); }
    std::string page() const {
        const std::string kids = value(object(value(catalog(), "/Pages")), "/Kids");
        return object(kids.substr(1));
    }
    static std::string stream(const std::string& object_text) {
        const std::size_t begin = object_text.find("stream\n") + 7;
        const std::size_t length = std::strtoul(value(object_text, "/Length").c_str(), nullptr, 10);
        EXPECT_EQ(object_text.substr(begin + length, 10), "\nendstream");
        std::string unpacked;
        z_stream z{};
        inflateInit(&z);
        z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(object_text.data() + begin));
        z.avail_in = static_cast<uInt>(length);
        int status = Z_OK;
        while (status == Z_OK) {
            char room[65536];
            z.next_out = reinterpret_cast<Bytef*>(room);
            z.avail_out = sizeof room;
            status = inflate(&z, Z_NO_FLUSH);
            unpacked.append(room, sizeof room - z.avail_out);
        }
        EXPECT_EQ(status, Z_STREAM_END);
        EXPECT_EQ(z.avail_in, 0U);
        inflateEnd(&z);
        return unpacked;
    }
    std::string content() const {
        std::string all;
        std::istringstream references(value(page(), "/Contents").substr(1));
        for (std::string number, generation, r; references >> number >> generation >> r;) all += stream(object(number));
        return all;
    }
};

inline TestPdf read_test_pdf(const std::string& bytes) {
    TestPdf pdf;
    EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
    EXPECT_EQ(bytes.substr(bytes.size() - 6), "%%EOF\n");
    const std::size_t start = bytes.rfind("startxref\n");
    const std::size_t table = std::strtoul(bytes.c_str() + start + 10, nullptr, 10);
    EXPECT_EQ(bytes.substr(table, 7), "xref\n0 ");
    char* after = nullptr;
    const std::size_t count = std::strtoul(bytes.c_str() + table + 7, &after, 10);
    std::size_t at = static_cast<std::size_t>(after - bytes.c_str()) + 1;
    EXPECT_EQ(bytes.substr(at, 20), "0000000000 65535 f \n");
    for (std::size_t i = 1; i < count; ++i) {
        const std::string entry = bytes.substr(at + 20 * i, 20);
        EXPECT_EQ(entry.substr(10), " 00000 n \n");
        const std::size_t offset = std::strtoul(entry.c_str(), nullptr, 10);
        const std::string head = std::to_string(i) + " 0 obj\n";
        EXPECT_EQ(bytes.substr(offset, head.size()), head);
        std::size_t end = bytes.find("\nendobj\n", offset);
        // A stream may hold the word by chance.
        if (const std::size_t stream = bytes.find("stream\n", offset); stream < end) {
            const std::string dictionary = bytes.substr(offset, stream - offset);
            const std::size_t length = std::strtoul(TestPdf::value(dictionary, "/Length").c_str(), nullptr, 10);
            end = bytes.find("\nendobj\n", stream + 7 + length);
        }
        pdf.objects[i] = bytes.substr(offset + head.size(), end - offset - head.size());
    }
    pdf.trailer = bytes.substr(at + 20 * count, start - at - 20 * count);
    EXPECT_EQ(TestPdf::value(pdf.trailer, "/Size"), std::to_string(count));
    return pdf;
}

// The operators of a content stream with their operands, checked for what each takes.
struct PdfOperator {
    std::string name;
    std::vector<std::string> operands;

    double number(std::size_t i) const { return std::strtod(operands.at(i).c_str(), nullptr); }
};
inline std::vector<PdfOperator> pdf_operators(const std::string& content) {
    static const std::map<std::string, std::size_t> takes = {
        {"q", 0}, {"Q", 0}, {"cm", 6}, {"gs", 1}, {"rg", 3}, {"RG", 3}, {"w", 1},  {"j", 1},  {"J", 1}, {"M", 1},
        {"m", 2}, {"l", 2}, {"c", 6},  {"h", 0},  {"re", 4}, {"f", 0},  {"f*", 0}, {"B*", 0}, {"S", 0}};
    std::vector<PdfOperator> operators;
    PdfOperator next;
    std::istringstream words(content);
    int depth = 0;
    bool has_path = false;
    for (std::string word; words >> word;) {
        const auto found = takes.find(word);
        if (found == takes.end()) {
            next.operands.push_back(word);
            continue;
        }
        next.name = word;
        EXPECT_EQ(next.operands.size(), found->second) << word;
        depth += word == "q" ? 1 : word == "Q" ? -1 : 0;
        EXPECT_GE(depth, 0);
        const bool is_painting = word == "f" || word == "f*" || word == "B*" || word == "S";
        const bool is_path = word == "m" || word == "l" || word == "c" || word == "h" || word == "re";
        const bool needs_path = is_painting || word == "l" || word == "c" || word == "h";
        EXPECT_TRUE(has_path || !needs_path) << word;
        EXPECT_TRUE(!has_path || is_painting || is_path) << word << " within a path";
        has_path = is_path;
        operators.push_back(std::move(next));
        next = {};
    }
    EXPECT_TRUE(next.operands.empty());
    EXPECT_EQ(depth, 0);
    EXPECT_FALSE(has_path);
    return operators;
}

}  // namespace filigree
