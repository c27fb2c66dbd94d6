#include "session/history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/test_cases.h"

namespace filigree {
namespace {

using Indices = std::vector<std::uint32_t>;

std::size_t stored_bytes(const History& history) {
    std::size_t bytes = 0;
    for (const Edit& edit : history.edits) bytes += edit.text.size();
    return bytes;
}

// The same with every text in full, and every visit remembered.
struct Model {
    struct Node {
        std::uint32_t parent;
        std::string label, text;
        std::uint64_t visited;
    };
    std::vector<Node> nodes;
    std::uint32_t current = 0;
    std::uint64_t clock = 0;

    bool is_below(std::uint32_t node, std::uint32_t ancestor) const {
        while (node != ancestor && node != 0) node = nodes[node].parent;
        return node == ancestor;
    }
    void visit(std::uint32_t node) {
        current = node;
        nodes[node].visited = ++clock;
    }
    bool edit(const std::string& label, const std::string& text) {
        if (text == nodes[current].text) return false;
        for (std::uint32_t n = 1; n < nodes.size(); ++n) {
            if (nodes[n].parent == current && nodes[n].text == text) {
                visit(n);
                return true;
            }
        }
        nodes.push_back({current, label, text, 0});
        visit(static_cast<std::uint32_t>(nodes.size() - 1));
        return true;
    }
    bool undo() {
        if (current == 0) return false;
        visit(nodes[current].parent);
        return true;
    }
    bool redo() {
        std::uint32_t last = current;
        for (std::uint32_t n = current + 1; n < nodes.size(); ++n) {
            const bool is_later = last == current || nodes[n].visited > nodes[last].visited;
            if (is_below(n, current) && is_later) last = n;
        }
        if (last == current) return false;
        while (nodes[last].parent != current) last = nodes[last].parent;
        visit(last);
        return true;
    }
    bool go_to(std::uint32_t node) {
        if (node >= nodes.size() || node == current) return false;
        visit(node);
        return true;
    }
    Indices path_to(std::uint32_t node) const {
        Indices path{node};
        while (path.back() != 0) path.push_back(nodes[path.back()].parent);
        return {path.rbegin(), path.rend()};
    }
    Indices children(std::uint32_t node) const {
        Indices found;
        for (std::uint32_t n = 1; n < nodes.size(); ++n) {
            if (nodes[n].parent == node) found.push_back(n);
        }
        return found;
    }
};

// Few letters, so that what is put in often equals what stands beside it.
std::string random_letters(CaseRandom& random, std::uint32_t most) {
    std::string text;
    for (std::uint32_t n = random.below(most + 1); n > 0; --n) text += random.coin() ? 'a' : 'b';
    return text;
}

std::string changed(const std::string& text, CaseRandom& random) {
    if (random.below(20) == 0) return random_letters(random, 30);
    const std::size_t at = random.index(text.size() + 1);
    const std::size_t taken = std::min<std::size_t>(random.below(4), text.size() - at);
    return text.substr(0, at) + random_letters(random, 3) + text.substr(at + taken);
}

void expect_same(const History& history, const Model& model) {
    ASSERT_EQ(history.current, model.current);
    ASSERT_EQ(history.text, model.nodes[model.current].text);
    ASSERT_EQ(history.edits.size(), model.nodes.size());
}

TEST(History, AgreesWithAModelThatKeepsEveryText) {
    std::size_t due_wholes = 0;
    for (std::uint64_t n = 0; n < case_count(300); ++n) {
        CaseRandom random(n);
        const std::string opened = random_letters(random, 40);
        History history = begin(opened);
        Model model;
        model.nodes.push_back({0, "", opened, 0});
        // Some go mostly forwards, so that texts are far from those kept whole.
        const std::uint32_t wandering = n % 3 == 0 ? 4 : n % 3 == 1 ? 40 : 1000;
        for (int step = 0; step < 200; ++step) {
            const std::uint32_t kind = random.below(wandering);
            const auto any = static_cast<std::uint32_t>(random.index(model.nodes.size() + 1));
            if (kind == 0) {
                EXPECT_EQ(undo(history), model.undo());
            } else if (kind == 1) {
                EXPECT_EQ(redo(history), model.redo());
            } else if (kind == 2) {
                EXPECT_EQ(go_to(history, any), model.go_to(any));
            } else {
                const std::string& now = model.nodes[model.current].text;
                const std::string text =
                    random.below(10) == 0 ? model.nodes[any % model.nodes.size()].text : changed(now, random);
                const std::string label = std::to_string(step);
                EXPECT_EQ(edit(history, label, text), model.edit(label, text));
            }
            expect_same(history, model);
            if (HasFatalFailure()) return;
        }
        for (std::uint32_t e = 0; e < model.nodes.size(); ++e) {
            const Edit& made = history.edits[e];
            due_wholes += made.is_whole && made.prefix + made.suffix > 0 ? 1 : 0;
            EXPECT_EQ(text_of(history, e), model.nodes[e].text);
            EXPECT_EQ(made.label, model.nodes[e].label);
            EXPECT_EQ(path_to(history, e), model.path_to(e));
            EXPECT_EQ(children(history, e), model.children(e));
        }
    }
    EXPECT_GT(due_wholes, 0U);  // else chains are too short to say anything about them
}

TEST(History, LongTextsShareWhatTheyCan) {
    for (std::uint64_t n = 0; n < case_count(200); ++n) {
        CaseRandom random(n);
        std::string front(random.below(10'000), 'f'), back(random.below(10'000), 'g');
        const std::string before = random_letters(random, 3), after = random_letters(random, 3);
        History history = begin(front + "[" + before + "]" + back);
        const std::string text = front + "(" + after + ")" + back;
        ASSERT_TRUE(edit(history, "", text));
        EXPECT_EQ(history.edits[1].prefix, front.size());
        EXPECT_EQ(history.edits[1].suffix, back.size());
        EXPECT_EQ(text_of(history, 1), text);
    }
}

TEST(History, NothingToDoIsSaid) {
    History history = begin("one");
    EXPECT_FALSE(undo(history));
    EXPECT_FALSE(redo(history));
    EXPECT_FALSE(go_to(history, 0));
    EXPECT_FALSE(go_to(history, 1));
    EXPECT_FALSE(go_to(history, no_edit));
    EXPECT_FALSE(edit(history, "same", "one"));
    EXPECT_EQ(history.edits.size(), 1U);
    EXPECT_EQ(text_of(history, 1), "");
    EXPECT_EQ(path_to(history, 1), Indices{});
    EXPECT_EQ(path_to(history, no_edit), Indices{});
    EXPECT_EQ(children(history, no_edit), Indices{});
    EXPECT_EQ(text_of(History{}, 0), "");
}

TEST(History, UndoingAndEditingStartsABranch) {
    History history = begin("a");
    EXPECT_TRUE(edit(history, "b", "ab"));
    EXPECT_TRUE(edit(history, "c", "abc"));
    EXPECT_TRUE(undo(history));
    EXPECT_TRUE(edit(history, "d", "abd"));
    EXPECT_EQ(children(history, 1), (Indices{2, 3}));
    EXPECT_EQ(path_to(history, 3), (Indices{0, 1, 3}));
    EXPECT_EQ(text_of(history, 2), "abc");
    // Redo leads to the child visited last, from any height.
    EXPECT_TRUE(go_to(history, 0));
    EXPECT_TRUE(redo(history));
    EXPECT_TRUE(redo(history));
    EXPECT_EQ(history.text, "abd");
    EXPECT_TRUE(go_to(history, 2));
    EXPECT_TRUE(go_to(history, 0));
    EXPECT_TRUE(redo(history));
    EXPECT_TRUE(redo(history));
    EXPECT_EQ(history.text, "abc");
}

TEST(History, AnEditThatWasMadeBeforeLeadsThere) {
    History history = begin("a");
    edit(history, "first", "ab");
    undo(history);
    edit(history, "other", "ac");
    undo(history);
    EXPECT_TRUE(edit(history, "again", "ab"));
    EXPECT_EQ(history.current, 1U);
    EXPECT_EQ(history.edits[1].label, "first");
    EXPECT_EQ(history.edits.size(), 3U);
    // Only children count: back to the text of the parent is a new edit.
    EXPECT_TRUE(edit(history, "back", "a"));
    EXPECT_EQ(history.current, 3U);
}

TEST(History, AWholeChildIsFoundAgainToo) {
    History history = begin("x");
    std::string text = "x";
    for (int i = 0; i < 200; ++i) {
        text += 'y';
        edit(history, "", text);
        undo(history);
        EXPECT_TRUE(edit(history, "", text));
    }
    EXPECT_EQ(history.edits.size(), 201U);
}

TEST(History, KeepsLittleMoreThanTheChanges) {
    CaseRandom random(1);
    std::string text;
    while (text.size() < (1U << 20)) text += static_cast<char>('a' + random.below(26));
    History history = begin(text);
    constexpr std::size_t count = 200;
    for (std::size_t i = 0; i < count; ++i) {
        text[random.index(text.size())] = '#';
        text.insert(random.index(64), "changed");
        edit(history, "", text);
    }
    EXPECT_EQ(text_of(history, history.current), text);
    // One in 64 is whole; the changes themselves reach from the front to any place.
    std::size_t wholes = 0, run = 0;
    for (const Edit& edit : history.edits) {
        wholes += edit.is_whole ? 1 : 0;
        run = edit.is_whole ? 0 : run + 1;
        EXPECT_EQ(edit.since_whole, run);
        EXPECT_LT(run, 64U);
    }
    EXPECT_LE(wholes, 1 + count / 64);
    History typing = begin(text);
    for (std::size_t i = 0; i < count; ++i) edit(typing, "", text.insert(text.size() / 2, "!"));
    EXPECT_LE(stored_bytes(typing), (1 + count / 64) * text.size() + count);
}

TEST(History, LargeTextsAreKeptWholeMoreSeldom) {
    std::string text(std::size_t{5} << 20, 'a');
    History history = begin(text);
    std::uint32_t longest = 0;
    for (int i = 0; i < 100; ++i) {
        text[static_cast<std::size_t>(i) * 1000] = 'b';
        edit(history, "", text);
        longest = std::max(longest, history.edits.back().since_whole);
    }
    EXPECT_EQ(longest, 79U);
    EXPECT_EQ(text_of(history, 79), history.text.substr(0, 79 * 1000) + std::string(text.size() - 79 * 1000, 'a'));
    EXPECT_LT(stored_bytes(history), 2 * text.size() + 1000);
}

}  // namespace
}  // namespace filigree
