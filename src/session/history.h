// The edits of an open document as a tree: undoing and then editing starts a branch, and no text is ever lost.
//
// Plain data; the session that owns a History is the only one to change it. A text is kept as what changed against
// its parent, and whole now and then: often enough that rebuilding one costs little more than copying it, seldom
// enough that an edit costs no more than 64 KiB or a 64th of the text on average. The current text is at hand.
//
//   History history = begin("outline(25) : leaf -> in, out\n");
//   edit(history, "spacing 30", "outline(30) : leaf -> in, out\n");
//   undo(history);
//   history.text;  // as opened
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace filigree {

constexpr std::uint32_t no_edit = UINT32_MAX;

struct Edit {
    std::uint32_t parent = no_edit;      // none for the first
    std::uint32_t last_child = no_edit;  // the child on the way to what was visited last; none if never visited
    std::string label;                   // what was done, for people
    // The text is the parent's, but for what lies between its first `prefix` and its last `suffix` bytes: `text`
    // stands there. Both are as long as they can be, the prefix first. Where `is_whole`, `text` is all of it.
    std::string text;
    std::size_t prefix = 0, suffix = 0;
    std::uint32_t since_whole = 0;  // edits from the last one that is whole
    bool is_whole = true;
};

struct History {
    std::vector<Edit> edits = std::vector<Edit>(1);  // [0]: as opened; parents stand before their children
    std::uint32_t current = 0;
    std::string text;  // of the current edit
};

History begin(std::string text);

// Each says whether it changed anything, and leaves the history as it was where not.
//
// A new child of the current edit, which becomes current. The text that is there already is no edit; one that a
// child has leads to that child, which keeps its label.
bool edit(History& history, std::string label, std::string text);
bool undo(History& history);  // to the parent
bool redo(History& history);  // to the child visited last
bool go_to(History& history, std::uint32_t index);

// These are empty for an index out of range.
std::string text_of(const History& history, std::uint32_t index);
std::vector<std::uint32_t> path_to(const History& history, std::uint32_t index);   // from [0] to it, both included
std::vector<std::uint32_t> children(const History& history, std::uint32_t index);  // in the order of their making

}  // namespace filigree
