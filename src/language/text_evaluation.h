// For tests: documents and expressions from text, evaluated.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "language/evaluate.h"
#include "language/parse.h"

namespace filigree {

// A document that must parse without a complaint; included files are "name" -> text.
inline Document document_of(std::string_view text, const std::map<std::string, std::string>& included = {}) {
    Parsed parsed = parse_document("test.fil", text, [&included](std::string_view name) -> Result<std::string> {
        const auto found = included.find(std::string(name));
        if (found == included.end()) return error("test.no-file", "there is no such file");
        return found->second;
    });
    EXPECT_EQ(to_text(parsed.diagnostics, parsed.document.sources), "");
    return std::move(parsed.document);
}

inline ExpressionPtr expression_of(std::string_view text, std::uint32_t file = 0) {
    Result<ExpressionPtr> parsed = parse_expression(text, file);
    EXPECT_TRUE(parsed) << text << ": " << (parsed ? "" : parsed.diagnostics().front().message);
    return parsed ? *parsed : std::make_shared<Expression>(Expression{{0, 0, 0}, BoolLiteral{}});
}

inline Value number_value(double value) { return {Quantity{value, 0, false}, {}}; }
inline Value length_value(double px) { return {Quantity{px, 1, false}, {}}; }
inline Value area_value(double px2) { return {Quantity{px2, 2, false}, {}}; }

// The value as text, or "CODE: message" of the first diagnostic.
inline std::string shown(const Result<Value>& value) {
    if (value) return to_text(*value);
    const Diagnostic& first = value.diagnostics().front();
    return first.code + ": " + first.message;
}
inline std::string evaluated(std::string_view text, const Evaluation& at) {
    return shown(evaluate(*expression_of(text), at));
}

// "CODE@text under the span" of each diagnostic, one a line.
inline std::string codes_of(const Diagnostics& diagnostics, const Document& document) {
    std::string out;
    for (const Diagnostic& diagnostic : diagnostics) {
        out += diagnostic.code + "@";
        if (diagnostic.span.file < document.sources.size()) {
            const std::string& text = document.sources[diagnostic.span.file].text;
            out += text.substr(diagnostic.span.begin, diagnostic.span.end - diagnostic.span.begin);
        } else {
            out += "nowhere";
        }
        out += "\n";
    }
    return out;
}

}  // namespace filigree
