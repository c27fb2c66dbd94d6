// The frame of a PDF: numbered objects, the table of where they are, text strings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filigree {

class PdfFile {
public:
    PdfFile();

    // Numbers are taken first, so that objects can name those that come later; each must be put once.
    std::size_t take_number();
    void put(std::size_t number, std::string_view body);
    // A stream packed by `deflated`; `entries` are those of its dictionary beside filter and length.
    void put_stream(std::size_t number, std::string_view entries, std::string_view packed);
    std::string finish(std::size_t root, std::size_t info) &&;

private:
    void begin(std::size_t number);

    std::string bytes_;
    std::vector<std::size_t> offsets_;  // of object i + 1
};

std::string pdf_reference(std::size_t number);       // "7 0 R"
std::string pdf_text(std::string_view utf8);         // a text string: plain where it is ASCII, else UTF-16
std::string pdf_hex(std::string_view bytes);         // a byte string in hexadecimal
std::string pdf_number(double value, int decimals);  // 0 for what is not finite

}  // namespace filigree
