// The document inside an exported PDF: a file attachment beside those that it read, so that any viewer can save it.
//
// What is needed to open it again stands with the attachments under names of our own (/FiligreeCarried and so on): the
// files' exact names and hashes, as in an SVG (svg_carried.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "formats/pdf_file.h"
#include "formats/svg_write.h"

namespace filigree {

// Puts the attachments; the result are the entries of the catalog that name them.
std::string put_carried(PdfFile& pdf, const CarriedDocument& carried);

// The document that a PDF carries; none where it carries none. Reads files as they were written: a program that
// writes a PDF anew may keep the attachments for people and yet lose this. `file` is for diagnostics.
Result<std::optional<CarriedDocument>> carried_document_of_pdf(std::string_view pdf, std::uint32_t file = 0);

}  // namespace filigree
