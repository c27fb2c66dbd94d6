// For tests alone: the grammar of a document, from its text below `grammar rewriting`.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "engines/rewriting/derive.h"
#include "engines/rewriting/read_grammar.h"
#include "language/parse.h"

namespace filigree::rewriting {

struct Read {
    Document document;
    Settings settings;
    Grammar grammar;
    Diagnostics problems;  // of the grammar alone
};
inline Read read(const std::string& text, const Inputs& inputs = {}) {
    Read out;
    Parsed parsed = parse_document("a.fil", "grammar rewriting\n" + text, {});
    EXPECT_EQ(to_text(parsed.diagnostics, parsed.document.sources), "");
    out.document = std::move(parsed.document);
    Result<Settings> settings = read_settings(out.document);
    EXPECT_TRUE(settings) << to_text(settings.diagnostics(), out.document.sources);
    if (settings) out.settings = std::move(*settings);
    Result<Grammar> grammar = read_grammar(out.settings, out.document, inputs);
    out.problems = grammar.diagnostics();
    if (grammar) out.grammar = std::move(*grammar);
    return out;
}
inline Grammar grammar_of(const std::string& text) {
    Read said = read(text);
    EXPECT_EQ(to_text(said.problems, said.document.sources), "");
    return std::move(said.grammar);
}

// They point into what was read.
inline DeriveOptions options_of(const Read& said) {
    DeriveOptions options;
    options.seed = said.settings.seed;
    options.document = &said.document;
    options.globals = &said.settings.globals;
    return options;
}

}  // namespace filigree::rewriting
