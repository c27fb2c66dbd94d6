// Whole documents that parse and are wrong all the same: what checking says of them.
#include <gtest/gtest.h>

#include "language/wrong_documents.h"
#include "session/check.h"

namespace filigree {
namespace {

void expect_diagnostics(const std::string& file, int at_least) {
    int checked = 0;
    for (const WrongDocument& wrong : read_wrong_documents(FILIGREE_SOURCE_DIR "/tests/data/" + file)) {
        const OpenedDocument opened = open_text("case.fil", wrong.text, {});
        const CheckedDocument result = check_document(opened);
        EXPECT_EQ(difference(wrong, by_place(result.diagnostics), opened.document.sources), "");
        EXPECT_FALSE(wrong.expected.empty()) << wrong.name;
        ++checked;
    }
    EXPECT_GE(checked, at_least);
}

TEST(WrongGrammars, CheckingTanglesSaysWhatIsExpected) { expect_diagnostics("wrong_tangles.txt", 45); }
TEST(WrongGrammars, CheckingShapesSaysWhatIsExpected) { expect_diagnostics("wrong_shapes.txt", 60); }

}  // namespace
}  // namespace filigree
