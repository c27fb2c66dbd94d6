// What the parts of a word become, eight symbols at a time.
//
// Words repeat their parts: those of a substitution hold at most as many different parts of eight symbols as some
// multiple of eight, however long they are. So what eight symbols become is made once, and looked up by these symbols
// and as many behind them as have a say. A part goes symbol by symbol where it counts something, becomes too much, or
// is new when the table is full: what is met first stays.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "engines/rewriting/rewrite_symbols.h"

namespace filigree::rewriting {

class ChunkTable {
public:
    static constexpr std::size_t length = 8;  // symbols of a chunk
    static constexpr std::size_t seen = 16;   // symbols that are read for one
    static constexpr std::size_t width = 64;  // the most that one becomes

    using Code = std::uint16_t;
    static constexpr Code by_symbol = 0;

    explicit ChunkTable(const Rewriting& in);

    // Of the chunk at a place, behind which the word has `seen` symbols.
    Code code_at(const Rewriting& in, std::size_t place) {
        const Key key = key_at(in, place);
        std::size_t at = ((key.symbols ^ (key.behind * 0x9E3779B97F4A7C15U >> 7)) * 0xD6E8FEB86659FD93U) >> (64 - bits);
        for (std::size_t tried = 0; tried < most_tries; ++tried, at = (at + 1) % slots_.size()) {
            const Slot& slot = slots_[at];
            if (slot.code == unused) return add(in, place, key, at);
            if (slot.key == key) return slot.code;
        }
        ++strangers_;
        return by_symbol;
    }
    std::size_t strangers() const { return strangers_; }  // looked up in vain, with no room for them
    std::uint8_t size_of(Code code) const { return sizes_[code]; }
    const std::array<Symbol, width>& image_of(Code code) const { return images_[code]; }

private:
    struct Key {
        std::uint64_t symbols = 0, behind = 0;
        bool operator==(const Key&) const = default;
    };
    struct Slot {
        Key key;
        Code code = unused;
    };
    static constexpr unsigned bits = 12;
    static constexpr std::size_t most_tries = 4, most_images = 2048;
    static constexpr Code unused = UINT16_MAX;

    Key key_at(const Rewriting& in, std::size_t place) const {
        Key key;
        std::memcpy(&key.symbols, in.word.symbols.data() + place, 8);
        std::memcpy(&key.behind, in.word.symbols.data() + place + 8, 8);
        key.behind &= behind_;
        return key;
    }
    Code add(const Rewriting& in, std::size_t place, const Key& key, std::size_t slot);

    std::array<bool, max_symbols> is_local_{};  // what hangs on the symbols behind it alone
    std::uint64_t behind_ = 0;                  // the bytes that have a say
    std::vector<Slot> slots_;
    std::vector<std::array<Symbol, width>> images_;  // by code
    std::vector<std::uint8_t> sizes_;
    std::size_t strangers_ = 0;
};

}  // namespace filigree::rewriting
