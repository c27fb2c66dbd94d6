// A document of a test's own, checked and derived as the program does it.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "session/check.h"
#include "session/run.h"

namespace filigree {

struct GrownDocument {
    OpenedDocument opened;
    CheckedDocument checked;
    tangle::Tangle tangle;
};

// `Grown`: a GrownDocument, with whatever a test asks of it. `rules`: all behind `grammar tangle`. What is wrong with
// it fails the test.
template <class Grown>
std::unique_ptr<Grown> grown_document(const std::string& rules) {
    auto grown = std::make_unique<Grown>();
    grown->opened = open_text("a.fil", "grammar tangle\n" + rules, {});
    grown->checked = check_document(grown->opened);
    EXPECT_FALSE(has_errors(grown->checked.diagnostics))
        << to_text(grown->checked.diagnostics, grown->opened.document.sources);
    if (has_errors(grown->checked.diagnostics)) return grown;
    SerialExecutor executor;
    Result<tangle::Tangle> derived = derive_document(grown->opened, grown->checked, {}, executor, {});
    EXPECT_TRUE(derived) << to_text(derived.diagnostics(), grown->opened.document.sources);
    if (derived) grown->tangle = std::move(*derived);
    return grown;
}

}  // namespace filigree
