// Presets, paths, operators of a document's own and systems that are wrong or nearly so: what checking says of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "language/wrong_documents.h"
#include "session/check.h"

namespace filigree {
namespace {

std::vector<WrongDocument> cases() { return read_wrong_documents(FILIGREE_SOURCE_DIR "/tests/data/wrong_presets.txt"); }

TEST(WrongPresets, CheckingSaysWhatIsExpected) {
    std::set<std::string> names;
    for (const WrongDocument& wrong : cases()) {
        const OpenedDocument opened = open_text("case.fil", wrong.text, {});
        const CheckedDocument checked = check_document(opened);
        EXPECT_EQ(difference(wrong, by_place(checked.diagnostics), opened.sources), "");
        EXPECT_FALSE(wrong.expected.empty()) << wrong.name;
        EXPECT_TRUE(names.insert(wrong.name).second) << wrong.name;
    }
    EXPECT_GE(names.size(), 80U);
}

// Nothing that is wrong with a document may look like a fault of the program, or of the disk.
TEST(WrongPresets, AreFaultsOfTheDocument) {
    for (const WrongDocument& wrong : cases()) {
        const OpenedDocument opened = open_text("case.fil", wrong.text, {});
        for (const Diagnostic& diagnostic : check_document(opened).diagnostics) {
            EXPECT_EQ(diagnostic.fault, Fault::document) << wrong.name << ": " << diagnostic.message;
        }
    }
}

// A hint that names a path is there to be written: the preset with that path in its place is no impossible one.
TEST(WrongPresets, TheNearestPathIsPossible) {
    constexpr std::string_view lead = "the nearest that is possible is ";
    int tried = 0;
    for (const WrongDocument& wrong : cases()) {
        const OpenedDocument opened = open_text("case.fil", wrong.text, {});
        for (const Diagnostic& diagnostic : check_document(opened).diagnostics) {
            for (const std::string& hint : diagnostic.hints) {
                if (diagnostic.code != "preset.impossible-path" || !hint.starts_with(lead)) continue;
                const SourceSpan span = diagnostic.span;
                std::string text = wrong.text;
                text.replace(span.begin, span.end - span.begin, hint.substr(lead.size()));
                const OpenedDocument repaired = open_text("case.fil", text, {});
                ++tried;
                for (const Diagnostic& left : check_document(repaired).diagnostics) {
                    const bool is_of_path = left.code == "preset.impossible-path" ||
                                            left.code == "preset.unknown-name" || left.code == "language.bad-path";
                    EXPECT_FALSE(is_of_path && left.span.begin == span.begin) << wrong.name << "\n" << text;
                }
            }
        }
    }
    EXPECT_GE(tried, 50);
}

}  // namespace
}  // namespace filigree
