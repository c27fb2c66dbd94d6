// The memory of a word of one byte a symbol: not filled before it is written, kept for the next word, and in large
// pages where it is large.
//
// A step writes every byte of its word, at the speed of memory: filling them first, as std::vector does, would cost
// about as much again, and memory that is used for the first time costs twice that.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <utility>

namespace filigree::rewriting {

class ByteWord {
public:
    ByteWord() = default;
    ByteWord(ByteWord&& other) noexcept { swap(other); }
    ByteWord& operator=(ByteWord&& other) noexcept {
        swap(other);
        return *this;
    }
    void swap(ByteWord& other) noexcept {
        bytes_.swap(other.bytes_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

    std::size_t size() const { return size_; }
    std::uint8_t* data() { return bytes_.get(); }
    const std::uint8_t* data() const { return bytes_.get(); }
    std::span<const std::uint8_t> symbols() const { return {bytes_.get(), size_}; }

    // The symbols are lost and the new ones undefined; memory is asked for only where there is too little. False, and
    // an empty word, where the system has none.
    bool make(std::size_t size);

private:
    struct Free {
        void operator()(std::uint8_t* bytes) const { std::free(bytes); }
    };
    std::unique_ptr<std::uint8_t[], Free> bytes_;
    std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace filigree::rewriting
