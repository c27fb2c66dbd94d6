#include "session/history.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace filigree {
namespace {

// A text is kept whole after so many edits or, where it is larger, so many that they bear so many bytes of it each.
// A text of 64 MiB is then put together from some 2000 pieces at most.
constexpr std::size_t least_edits_a_whole = 64;
constexpr std::size_t bytes_an_edit = 65536;

bool is_whole_due(std::size_t since_whole, std::size_t size) {
    return since_whole >= std::max(least_edits_a_whole, size / bytes_an_edit);
}

struct Difference {
    std::size_t prefix = 0, suffix = 0;

    bool operator==(const Difference&) const = default;
};

constexpr std::size_t block = 4096;

// How many bytes two texts share at the front, or at the back; blocks first, as those compare fast.
std::size_t shared_front(std::string_view a, std::string_view b) {
    const std::size_t shorter = std::min(a.size(), b.size());
    std::size_t n = 0;
    while (shorter - n >= block && a.substr(n, block) == b.substr(n, block)) n += block;
    while (n < shorter && a[n] == b[n]) ++n;
    return n;
}
std::size_t shared_back(std::string_view a, std::string_view b) {
    const std::size_t shorter = std::min(a.size(), b.size());
    const auto before = [](std::string_view text, std::size_t n) {
        return text.substr(text.size() - n - block, block);
    };
    std::size_t n = 0;
    while (shorter - n >= block && before(a, n) == before(b, n)) n += block;
    while (n < shorter && a[a.size() - 1 - n] == b[b.size() - 1 - n]) ++n;
    return n;
}

// As much as can be shared at the front, then as much as can be at the back.
Difference difference(std::string_view before, std::string_view after) {
    const std::size_t prefix = shared_front(before, after);
    return {prefix, shared_back(before.substr(prefix), after.substr(prefix))};
}

std::string_view changed_part(std::string_view text, Difference shared) {
    return text.substr(shared.prefix, text.size() - shared.prefix - shared.suffix);
}

// A text as views into what edits hold.
class Pieces {
public:
    explicit Pieces(std::string_view whole) : pieces_{whole}, size_(whole.size()) {}

    void apply(const Edit& edit) {
        const std::size_t first = cut(edit.prefix), end = cut(size_ - edit.suffix);
        const auto at = pieces_.begin();
        pieces_.insert(pieces_.erase(at + static_cast<std::ptrdiff_t>(first), at + static_cast<std::ptrdiff_t>(end)),
                       edit.text);
        size_ = edit.prefix + edit.text.size() + edit.suffix;
    }

    std::string joined() const {
        std::string text;
        text.reserve(size_);
        for (const std::string_view piece : pieces_) text += piece;
        return text;
    }

private:
    // The index of the piece that starts at an offset; one that holds it inside is cut there.
    std::size_t cut(std::size_t offset) {
        std::size_t i = 0;
        for (; i < pieces_.size() && pieces_[i].size() <= offset; ++i) offset -= pieces_[i].size();
        if (offset == 0) return i;
        const std::string_view piece = pieces_[i];
        pieces_[i] = piece.substr(0, offset);
        pieces_.insert(pieces_.begin() + static_cast<std::ptrdiff_t>(i + 1), piece.substr(offset));
        return i + 1;
    }

    std::vector<std::string_view> pieces_;
    std::size_t size_;
};

// The child of the current edit with this text, or none.
std::uint32_t find_child(const History& history, std::string_view text, Difference shared) {
    for (std::uint32_t e = history.current + 1; e < history.edits.size(); ++e) {
        const Edit& child = history.edits[e];
        if (child.parent != history.current || Difference{child.prefix, child.suffix} != shared) continue;
        if (child.text == (child.is_whole ? text : changed_part(text, shared))) return e;
    }
    return no_edit;
}

void visit(History& history, std::uint32_t index) {
    history.current = index;
    std::vector<Edit>& edits = history.edits;
    for (; edits[index].parent != no_edit; index = edits[index].parent) edits[edits[index].parent].last_child = index;
}

}  // namespace

History begin(std::string text) {
    History history;
    history.edits[0].text = text;
    history.text = std::move(text);
    return history;
}

bool edit(History& history, std::string label, std::string text) {
    if (text == history.text) return false;
    const Difference shared = difference(history.text, text);
    std::uint32_t child = find_child(history, text, shared);
    if (child == no_edit) {
        child = static_cast<std::uint32_t>(history.edits.size());
        Edit made;
        made.parent = history.current;
        made.label = std::move(label);
        made.prefix = shared.prefix;
        made.suffix = shared.suffix;
        made.since_whole = history.edits[history.current].since_whole + 1;
        made.is_whole = shared == Difference{} || is_whole_due(made.since_whole, text.size());
        if (made.is_whole) made.since_whole = 0;
        made.text = made.is_whole ? text : changed_part(text, shared);
        history.edits.push_back(std::move(made));
    }
    visit(history, child);
    history.text = std::move(text);
    return true;
}

bool undo(History& history) { return go_to(history, history.edits[history.current].parent); }

bool redo(History& history) { return go_to(history, history.edits[history.current].last_child); }

bool go_to(History& history, std::uint32_t index) {
    if (index >= history.edits.size() || index == history.current) return false;
    history.text = text_of(history, index);
    visit(history, index);
    return true;
}

std::string text_of(const History& history, std::uint32_t index) {
    if (index >= history.edits.size()) return {};
    std::vector<std::uint32_t> changes;
    for (; !history.edits[index].is_whole; index = history.edits[index].parent) changes.push_back(index);
    Pieces pieces(history.edits[index].text);
    for (std::size_t i = changes.size(); i-- > 0;) pieces.apply(history.edits[changes[i]]);
    return pieces.joined();
}

std::vector<std::uint32_t> path_to(const History& history, std::uint32_t index) {
    std::vector<std::uint32_t> path;
    while (index < history.edits.size()) {
        path.push_back(index);
        index = history.edits[index].parent;
    }
    std::reverse(path.begin(), path.end());
    return path;
}

std::vector<std::uint32_t> children(const History& history, std::uint32_t index) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t e = 1; e < history.edits.size(); ++e) {
        if (history.edits[e].parent == index) found.push_back(e);
    }
    return found;
}

}  // namespace filigree
