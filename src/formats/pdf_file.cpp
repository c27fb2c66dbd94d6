#include "formats/pdf_file.h"

#include <algorithm>
#include <utility>

#include "base/number_text.h"
#include "base/unicode.h"

namespace filigree {
namespace {

constexpr std::string_view hex_digits = "0123456789ABCDEF";

void append_hex(std::string& out, unsigned value, int digits) {
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) out += hex_digits[value >> shift & 15];
}

}  // namespace

// The comment tells transfer programs that the file is binary.
PdfFile::PdfFile() : bytes_("%PDF-1.7\n%\xE2\xE3\xCF\xD3\n") {}

std::size_t PdfFile::take_number() {
    offsets_.push_back(0);
    return offsets_.size();
}

void PdfFile::begin(std::size_t number) {
    offsets_[number - 1] = bytes_.size();
    bytes_ += std::to_string(number) + " 0 obj\n";
}

void PdfFile::put(std::size_t number, std::string_view body) {
    begin(number);
    bytes_ += body;
    bytes_ += "\nendobj\n";
}

void PdfFile::put_stream(std::size_t number, std::string_view entries, std::string_view packed) {
    begin(number);
    bytes_ += "<< ";
    bytes_ += entries;
    bytes_ += "/Filter /FlateDecode /Length " + std::to_string(packed.size()) + " >>\nstream\n";
    bytes_ += packed;
    bytes_ += "\nendstream\nendobj\n";
}

std::string PdfFile::finish(std::size_t root, std::size_t info) && {
    const std::size_t table = bytes_.size();
    const std::string count = std::to_string(offsets_.size() + 1);
    bytes_ += "xref\n0 " + count + "\n0000000000 65535 f \n";
    for (const std::size_t offset : offsets_) {
        const std::string digits = std::to_string(offset);
        bytes_.append(10 - std::min<std::size_t>(digits.size(), 10), '0');
        bytes_ += digits + " 00000 n \n";
    }
    bytes_ += "trailer\n<< /Size " + count + " /Root " + pdf_reference(root) + " /Info " + pdf_reference(info) +
              " >>\nstartxref\n" + std::to_string(table) + "\n%%EOF\n";
    return std::move(bytes_);
}

std::string pdf_reference(std::size_t number) { return std::to_string(number) + " 0 R"; }

std::string pdf_text(std::string_view utf8) {
    const bool is_plain = std::all_of(utf8.begin(), utf8.end(), [](char c) { return c >= ' ' && c <= '~'; });
    if (is_plain) {
        std::string text = "(";
        for (const char c : utf8) {
            if (c == '(' || c == ')' || c == '\\') text += '\\';
            text += c;
        }
        return text + ")";
    }
    std::string text = "<FEFF";
    for (std::size_t at = 0; at < utf8.size();) {
        const unicode::Decoded decoded = unicode::decode(utf8, at);
        const auto code = static_cast<unsigned>(decoded.code_point);
        if (code < 0x10000) {
            append_hex(text, code, 4);
        } else {
            append_hex(text, 0xD800 + ((code - 0x10000) >> 10), 4);
            append_hex(text, 0xDC00 + ((code - 0x10000) & 0x3FF), 4);
        }
        at += decoded.length;
    }
    return text + ">";
}

std::string pdf_hex(std::string_view bytes) {
    std::string text = "<";
    for (const char c : bytes) append_hex(text, static_cast<unsigned char>(c), 2);
    return text + ">";
}

std::string pdf_number(double value, int decimals) {
    std::string text;
    append_fixed(text, value, decimals);
    return text;
}

}  // namespace filigree
