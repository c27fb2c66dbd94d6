// Writes an edited word piece by piece, with the places that its symbols come from.
#pragma once

#include <string>
#include <string_view>

#include "engines/rewriting/word_edits.h"

namespace filigree::rewriting {

class EditWriter {
public:
    // `trace`: null where nobody asks.
    EditWriter(std::u32string_view word, EditTrace* trace) : word_(word), trace_(trace) {
        if (trace_ != nullptr) trace_->clear();
    }

    void reserve(std::size_t symbols) {
        text_.reserve(symbols);
        if (trace_ != nullptr) trace_->reserve(symbols);
    }
    // Symbols of the word that is edited; each once at most.
    void keep(std::size_t begin, std::size_t end) {
        text_ += word_.substr(begin, end - begin);
        if (trace_ == nullptr) return;
        for (; begin < end; ++begin) trace_->push_back(static_cast<std::uint32_t>(begin));
    }
    void keep(EditToken token) { keep(token.begin, token.end); }
    // All from a place on.
    void keep_from(std::size_t begin) { keep(begin, word_.size()); }
    void add(std::u32string_view text) {
        text_ += text;
        if (trace_ != nullptr) trace_->resize(text_.size(), new_symbol);
    }

    const std::u32string& text() const { return text_; }
    std::u32string take() { return std::move(text_); }

private:
    std::u32string_view word_;
    EditTrace* trace_;
    std::u32string text_;
};

}  // namespace filigree::rewriting
