#include "formats/pdf_carried.h"

#include <charconv>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "base/random.h"
#include "formats/deflate.h"

namespace filigree {
namespace {

constexpr std::string_view catalog_entry = "/FiligreeCarried << /Version ";
constexpr std::size_t most_bytes = 512U << 20;  // of a file when it is unpacked
constexpr int version = 1;

std::string hash_of(const CarriedFile& file) { return to_hex(fold(hash_text(file.name), hash_text(file.bytes))); }

std::string_view last_part(std::string_view path) {
    return path.substr(path.find_last_of('/') == std::string_view::npos ? 0 : path.find_last_of('/') + 1);
}

// Puts a file and what says how it is called; the result is the number of the latter.
std::size_t put_attachment(PdfFile& pdf, const CarriedFile& file) {
    const std::size_t specification = pdf.take_number(), stream = pdf.take_number();
    const std::string shown = pdf_text(last_part(file.name));
    pdf.put(specification, "<< /Type /Filespec /F " + shown + " /UF " + shown + " /EF << /F " + pdf_reference(stream) +
                               " /UF " + pdf_reference(stream) + " >> /AFRelationship /Source >>");
    pdf.put_stream(stream,
                   "/Type /EmbeddedFile /FiligreeName " + pdf_hex(file.name) + " /FiligreeHash " +
                       pdf_hex(hash_of(file)) + " /Params << /Size " + std::to_string(file.bytes.size()) + " >> ",
                   deflated(file.bytes));
    return specification;
}

// Walks over a text piece by piece; once something is not as expected, nothing is any more.
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    bool is_good() const { return is_good_; }
    void skip(std::string_view expected) {
        if (!is_good_ || text_.substr(0, expected.size()) != expected) return fail();
        text_.remove_prefix(expected.size());
    }
    void skip_past(std::string_view mark) {
        const std::size_t at = is_good_ ? text_.find(mark) : std::string_view::npos;
        if (at == std::string_view::npos) return fail();
        text_.remove_prefix(at + mark.size());
    }
    std::size_t number() {
        std::size_t value = 0;
        const auto [end, status] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
        if (status != std::errc()) fail();
        if (is_good_) text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
        return is_good_ ? value : 0;
    }
    std::string hex() {
        skip("<");
        std::string bytes;
        while (is_good_ && text_.size() >= 2 && text_[0] != '>') {
            unsigned byte = 0;
            const auto [end, status] = std::from_chars(text_.data(), text_.data() + 2, byte, 16);
            if (status != std::errc() || end != text_.data() + 2) fail();
            bytes += static_cast<char>(byte);
            text_.remove_prefix(2);
        }
        skip(">");
        return bytes;
    }
    std::string_view take(std::size_t count) {
        if (!is_good_ || text_.size() < count) fail();
        if (!is_good_) return {};
        const std::string_view taken = text_.substr(0, count);
        text_.remove_prefix(count);
        return taken;
    }
    bool starts(std::string_view with) const { return is_good_ && text_.substr(0, with.size()) == with; }

private:
    void fail() { is_good_ = false; }

    std::string_view text_;
    bool is_good_ = true;
};

// The text from an object of a number onwards, by the table at the end.
Scanner object_at(std::string_view pdf, std::size_t number) {
    Scanner bad("");
    bad.skip("x");
    const std::size_t end = pdf.rfind("startxref\n");
    if (end == std::string_view::npos) return bad;
    Scanner tail(pdf.substr(end));
    tail.skip("startxref\n");
    const std::size_t table = tail.number();
    if (!tail.is_good() || table > pdf.size()) return bad;
    Scanner head(pdf.substr(table));
    head.skip("xref\n0 ");
    const std::size_t count = head.number();
    if (!head.is_good() || number >= count) return bad;
    head.skip("\n");
    for (std::size_t i = 0; i < number && head.is_good(); ++i) head.take(20);
    std::string_view digits = head.take(10);
    while (digits.size() > 1 && digits[0] == '0') digits.remove_prefix(1);
    Scanner entry(digits);
    const std::size_t offset = entry.number();
    if (!entry.is_good() || offset > pdf.size()) return bad;
    Scanner object(pdf.substr(offset));
    object.skip(std::to_string(number) + " 0 obj\n");
    return object;
}

std::optional<CarriedFile> read_attachment(std::string_view pdf, std::size_t number) {
    Scanner specification = object_at(pdf, number);
    specification.skip_past("/EF << /F ");
    const std::size_t stream = specification.number();
    if (!specification.is_good()) return {};
    Scanner object = object_at(pdf, stream);
    CarriedFile file;
    object.skip("<< /Type /EmbeddedFile /FiligreeName ");
    file.name = object.hex();
    object.skip(" /FiligreeHash ");
    const std::string hash = object.hex();
    object.skip(" /Params << /Size ");
    const std::size_t size = object.number();
    object.skip(" >> /Filter /FlateDecode /Length ");
    const std::size_t length = object.number();
    object.skip(" >>\nstream\n");
    const std::string_view packed = object.take(length);
    if (!object.is_good() || size > most_bytes) return {};
    std::optional<std::string> bytes = inflated(packed, size);
    if (!bytes) return {};
    file.bytes = *std::move(bytes);
    if (hash_of(file) != hash) return {};
    return file;
}

}  // namespace

std::string put_carried(PdfFile& pdf, const CarriedDocument& carried) {
    std::vector<std::size_t> numbers = {put_attachment(pdf, carried.document)};
    for (const CarriedFile& input : carried.inputs) numbers.push_back(put_attachment(pdf, input));
    std::string files, names;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        // Readers search the names, so they must be in order.
        std::string key = std::to_string(i);
        key.insert(0, key.size() < 8 ? 8 - key.size() : 0, '0');
        files += (i == 0 ? "" : " ") + pdf_reference(numbers[i]);
        names += (i == 0 ? "(" : " (") + key + ") " + pdf_reference(numbers[i]);
    }
    return "/Names << /EmbeddedFiles << /Names [" + names + "] >> >> /AF [" + files + "] " +
           std::string(catalog_entry) + std::to_string(version) + " /Files [" + files + "] >> ";
}

Result<std::optional<CarriedDocument>> carried_document_of_pdf(std::string_view pdf, std::uint32_t file) {
    using Found = std::optional<CarriedDocument>;
    const SourceSpan whole{file, 0, 0};
    const std::size_t entry = pdf.rfind(catalog_entry);  // the catalog comes after the attachments
    if (entry == std::string_view::npos) return Found();
    Scanner catalog(pdf.substr(entry));
    catalog.skip(catalog_entry);
    const std::size_t said = catalog.number();
    if (catalog.is_good() && said != version) {
        return error("pdf.carried-version",
                     "the document that this PDF carries is of version " + std::to_string(said) +
                         "; this program reads version 1",
                     whole);
    }
    catalog.skip(" /Files [");
    CarriedDocument found;
    bool is_first = true;
    while (catalog.is_good() && !catalog.starts("]")) {
        if (!is_first) catalog.skip(" ");
        const std::size_t number = catalog.number();
        catalog.skip(" 0 R");
        if (!catalog.is_good()) break;
        std::optional<CarriedFile> read = read_attachment(pdf, number);
        if (!read) {
            return error("pdf.carried-damaged",
                         "the document that this PDF carries is damaged: an attachment is not what was written", whole);
        }
        if (std::exchange(is_first, false)) {
            found.document = *std::move(read);
        } else {
            found.inputs.push_back(*std::move(read));
        }
    }
    if (!catalog.is_good() || is_first) {
        return error("pdf.carried-damaged", "the document that this PDF carries is damaged: it is missing", whole);
    }
    return Found(std::move(found));
}

}  // namespace filigree
