// The document inside an exported SVG: how it is written into the metadata (reading: svg_read.h).
//
//   <filigree:carried xmlns:filigree="urn:x-filigree:carried" version="1" inputs="1">
//     <filigree:document name="leaf.fil" hash="16 hex digits"><![CDATA[...]]></filigree:document>
//     <filigree:input name="leaf.svg" hash="16 hex digits" encoding="base64">...</filigree:input>
//   </filigree:carried>
//
// Text that XML keeps unchanged stays readable; all else is base64, names too (`name-base64`). The hashes
// are hash_text of the bytes, folded with that of the name, so that a file that an editor has changed is noticed.
#pragma once

#include <string>

#include "formats/svg_write.h"

namespace filigree {

// A whole <metadata> element and a newline.
void append_carried(std::string& out, const CarriedDocument& carried);

}  // namespace filigree
