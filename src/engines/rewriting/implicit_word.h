// A word of astronomical length that is not written down: what stands at a place, and what follows it.
//
// Kept are the lengths of what each symbol becomes after any number of steps. A place is found by going down from the
// first word to the last, one image a step; the lowest steps are blocks that are written out. So a word of 10^55
// symbols takes some KB.
// Guarantee: the symbols are those that `power` would write, were there room.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "engines/rewriting/bigint.h"
#include "engines/rewriting/substitution.h"

namespace filigree::rewriting {

class ImplicitWord {
public:
    const BigInt& length() const { return length_; }

    // None behind the end. O(steps x longest image).
    std::optional<std::uint8_t> at(const BigInt& position) const;

    // The symbols from `first` on: `count` of them, or as many as there are. The first costs as much as `at`, the
    // others mostly what copying them costs.
    std::vector<std::uint8_t> slice(const BigInt& first, std::size_t count) const;

private:
    friend Result<ImplicitWord> implicit_word(const Substitution& substitution, std::span<const std::uint8_t> word,
                                              std::uint64_t steps, std::uint64_t most_bytes);
    class Walk;

    // Symbols that have not all their steps behind them; `height` is the number of those that are left.
    struct Frame {
        std::span<const std::uint8_t> symbols;
        std::uint64_t height = 0;
    };

    std::size_t row(std::uint64_t height) const;
    bool is_narrow(std::uint64_t height) const { return row(height) * letters_ < narrow_.size(); }
    std::uint64_t narrow(std::uint64_t height, std::uint8_t symbol) const {
        return narrow_[row(height) * letters_ + place_[symbol]];
    }
    const BigInt& wide(std::uint64_t height, std::uint8_t symbol) const {
        return wide_[row(height) * letters_ - narrow_.size() + place_[symbol]];
    }
    BigInt length_of(std::uint64_t height, std::uint8_t symbol) const;
    bool is_empty(std::uint64_t height, std::uint8_t symbol) const;

    Substitution substitution_, blocks_;
    std::vector<std::uint8_t> word_;
    std::uint64_t steps_ = 0;
    std::uint64_t block_steps_ = 0;  // how many steps the blocks do
    std::size_t letters_ = 0;        // symbols that can arise
    std::array<std::uint8_t, 256> place_{};
    // Lengths, a row of all letters a height from `block_steps_` upwards: in 64 bits as long as all of a row fit, then
    // as big numbers. Heights above the last row have the lengths of the last.
    std::vector<std::uint64_t> narrow_;
    std::vector<BigInt> wide_;
    std::vector<BigInt> starts_;  // where what comes of every so many symbols of the word begins
    BigInt length_;
};

// `limit.memory` where the tables would take more than `most_bytes`.
Result<ImplicitWord> implicit_word(const Substitution& substitution, std::span<const std::uint8_t> word,
                                   std::uint64_t steps, std::uint64_t most_bytes);

}  // namespace filigree::rewriting
