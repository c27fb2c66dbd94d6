#include "formats/svg_carried.h"

#include <optional>
#include <string_view>
#include <utility>

#include "base/number_text.h"
#include "base/random.h"
#include "formats/base64.h"
#include "formats/svg_read.h"
#include "formats/xml.h"

namespace filigree {
namespace {

constexpr std::string_view carried_namespace = "urn:x-filigree:carried";
constexpr std::string_view version = "1";

std::string hash_of(const CarriedFile& file) { return to_hex(fold(hash_text(file.name), hash_text(file.bytes))); }

void append_file(std::string& out, std::string_view element, const CarriedFile& file) {
    out += "<filigree:";
    out += element;
    if (survives_xml(file.name)) {
        out += " name=\"";
        append_escaped(out, file.name);
    } else {
        out += " name-base64=\"";
        out += to_base64(file.name);
    }
    out += "\" hash=\"" + hash_of(file) + "\"";
    if (survives_xml(file.bytes)) {
        out += '>';
        append_cdata(out, file.bytes);
    } else {
        out += " encoding=\"base64\">";
        append_cdata(out, to_base64(file.bytes, 100));
    }
    out += "</filigree:";
    out += element;
    out += ">\n";
}

pugi::xml_node find_carried(pugi::xml_node root) {
    for (const pugi::xml_node metadata : root.children()) {
        if (local_name(metadata.name()) != "metadata") continue;
        for (const pugi::xml_node child : metadata.children()) {
            if (child.type() != pugi::node_element || local_name(child.name()) != "carried") continue;
            if (namespace_of(child) == carried_namespace) return child;
        }
    }
    return {};
}

Diagnostic damaged(const Xml& xml, pugi::xml_node element, std::string what) {
    return error("svg.carried-damaged", "the document that this SVG carries is damaged: " + std::move(what),
                 xml.span_of(element));
}

Result<CarriedFile> read_carried_file(const Xml& xml, pugi::xml_node element) {
    CarriedFile file;
    if (const pugi::xml_attribute encoded = element.attribute("name-base64")) {
        std::optional<std::string> name = from_base64(encoded.value());
        if (!name) return damaged(xml, element, "a name is no base64");
        file.name = *std::move(name);
    } else {
        file.name = element.attribute("name").value();
    }
    file.bytes = text_of(element);
    if (const std::string_view encoding = element.attribute("encoding").value(); encoding == "base64") {
        std::optional<std::string> bytes = from_base64(file.bytes);
        if (!bytes) return damaged(xml, element, "'" + file.name + "' is no base64");
        file.bytes = *std::move(bytes);
    } else if (!encoding.empty()) {
        return damaged(xml, element, "the encoding of '" + file.name + "' is not known");
    }
    if (hash_of(file) != element.attribute("hash").value()) {
        return damaged(xml, element, "'" + file.name + "' is not what was written (its hash differs)");
    }
    return file;
}

}  // namespace

void append_carried(std::string& out, const CarriedDocument& carried) {
    out += "<metadata>\n<filigree:carried xmlns:filigree=\"";
    out += carried_namespace;
    out += "\" version=\"";
    out += version;
    out += "\" inputs=\"" + std::to_string(carried.inputs.size()) + "\">\n";
    append_file(out, "document", carried.document);
    for (const CarriedFile& input : carried.inputs) append_file(out, "input", input);
    out += "</filigree:carried>\n</metadata>\n";
}

Result<std::optional<CarriedDocument>> carried_document(std::string_view svg, std::uint32_t file) {
    using Found = std::optional<CarriedDocument>;
    if (svg.find(carried_namespace) == std::string_view::npos) return Found();
    const Result<std::unique_ptr<Xml>> parsed = parse_xml(svg, file, true);
    if (!parsed) return parsed.diagnostics();
    const Xml& xml = **parsed;
    const pugi::xml_node carried = find_carried(xml.root());
    if (!carried) return Found();
    if (const std::string_view said = carried.attribute("version").value(); said != version) {
        return error("svg.carried-version",
                     "the document that this SVG carries is of version '" + std::string(said) +
                         "'; this program reads version 1",
                     xml.span_of(carried));
    }

    CarriedDocument found;
    bool has_document = false;
    for (const pugi::xml_node child : carried.children()) {
        if (child.type() != pugi::node_element) continue;
        const std::string_view name = local_name(child.name());
        if (name != "document" && name != "input") continue;
        Result<CarriedFile> read = read_carried_file(xml, child);
        if (!read) return std::move(read).diagnostics();
        if (name == "input") {
            found.inputs.push_back(*std::move(read));
        } else if (std::exchange(has_document, true)) {
            return damaged(xml, child, "there are two documents");
        } else {
            found.document = *std::move(read);
        }
    }
    if (!has_document) return damaged(xml, carried, "it is missing");
    if (std::to_string(found.inputs.size()) != carried.attribute("inputs").value()) {
        return damaged(xml, carried, "an input file is missing");
    }
    return Found(std::move(found));
}

}  // namespace filigree
