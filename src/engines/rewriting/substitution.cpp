#include "engines/rewriting/substitution.h"

#include <algorithm>
#include <optional>
#include <string>

namespace filigree::rewriting {
namespace {

using Symbols = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 256> themselves = [] {
    std::array<std::uint8_t, 256> result{};
    for (std::size_t i = 0; i < 256; ++i) result[i] = static_cast<std::uint8_t>(i);
    return result;
}();

// First `first`, then `second`, for these symbols.
Substitution in_turn(const Substitution& first, const Substitution& second, Symbols symbols) {
    Substitution result;
    for (const std::uint8_t symbol : symbols) {
        const Symbols middle = image_of(first, symbol);
        std::size_t size = 0;
        for (const std::uint8_t s : middle) size += image_of(second, s).size();
        std::vector<std::uint8_t>& image = result.images[symbol];
        image.clear();
        image.reserve(size);
        for (const std::uint8_t s : middle) {
            const Symbols part = image_of(second, s);
            image.insert(image.end(), part.begin(), part.end());
        }
    }
    return result;
}

std::vector<BigInt> lengths_of(const std::vector<std::vector<Occurrence>>& in_images, std::uint64_t steps) {
    std::vector<BigInt> now(in_images.size(), 1), next(in_images.size());
    for (std::uint64_t step = 0; step < steps; ++step) {
        for (std::size_t i = 0; i < in_images.size(); ++i) {
            next[i].limbs.clear();
            for (const Occurrence& o : in_images[i]) add_product(next[i], now[o.symbol], o.count);
        }
        now.swap(next);
        if (now == next) break;
    }
    return now;
}

// --- lengths in 64 bits: exact below the largest, which stands for all that is more ----------------------------------

std::uint64_t plus_product(std::uint64_t sum, std::uint64_t a, std::uint64_t b) {
    std::uint64_t product = 0, result = 0;
    if (__builtin_mul_overflow(a, b, &product) || __builtin_add_overflow(sum, product, &result)) return UINT64_MAX;
    return result;
}

// The lengths of what some symbols and a word become, step by step.
class Growth {
public:
    Growth(const Substitution& substitution, Symbols word, Symbols symbols)
        : occurrences_(occurrences(substitution, symbols)), now_(symbols.size(), 1), next_(symbols.size()) {
        std::array<std::uint64_t, 256> counts{};
        for (const std::uint8_t s : word) ++counts[s];
        for (const std::uint8_t s : symbols) counts_.push_back(counts[s]);
    }

    // False where no length changes any more.
    bool advance() {
        for (std::size_t i = 0; i < now_.size(); ++i) {
            next_[i] = 0;
            for (const Occurrence& o : occurrences_[i]) next_[i] = plus_product(next_[i], now_[o.symbol], o.count);
        }
        now_.swap(next_);
        return now_ != next_;
    }
    std::uint64_t of_word() const {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < now_.size(); ++i) sum = plus_product(sum, now_[i], counts_[i]);
        return sum;
    }
    std::uint64_t of_all_symbols() const {
        std::uint64_t sum = 0;
        for (const std::uint64_t length : now_) sum = plus_product(sum, length, 1);
        return sum;
    }

private:
    std::vector<std::vector<Occurrence>> occurrences_;
    std::vector<std::uint64_t> now_, next_, counts_;
};

// --- several steps at once -------------------------------------------------------------------------------------------

// Images that fill no more than half of the nearest cache are copied as fast as they can be written.
constexpr std::uint64_t bytes_near = 16 << 10;
// Where words grow by less than this in a pass there would be many; larger images, though slower, save them.
constexpr std::uint64_t passes_near = 8;

}  // namespace

std::vector<std::vector<std::uint8_t>> images_of_themselves() {
    std::vector<std::vector<std::uint8_t>> result;
    for (const std::uint8_t symbol : themselves) result.push_back({symbol});
    return result;
}

Symbols image_of(const Substitution& substitution, std::uint8_t symbol) {
    if (symbol < substitution.images.size()) return substitution.images[symbol];
    return Symbols(themselves).subspan(symbol, 1);
}

std::vector<std::uint8_t> symbols_from(const Substitution& substitution, Symbols word) {
    std::array<bool, 256> seen{};
    std::vector<std::uint8_t> open;
    const auto see = [&](Symbols symbols) {
        for (const std::uint8_t s : symbols) {
            if (!seen[s]) open.push_back(s);
            seen[s] = true;
        }
    };
    see(word);
    while (!open.empty()) {
        const std::uint8_t symbol = open.back();
        open.pop_back();
        see(image_of(substitution, symbol));
    }
    std::vector<std::uint8_t> result;
    for (const std::uint8_t symbol : themselves) {
        if (seen[symbol]) result.push_back(symbol);
    }
    return result;
}

std::vector<std::vector<Occurrence>> occurrences(const Substitution& substitution, Symbols symbols) {
    std::vector<std::vector<Occurrence>> result(symbols.size());
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        std::array<std::uint32_t, 256> counts{};
        for (const std::uint8_t s : image_of(substitution, symbols[i])) ++counts[s];
        for (std::size_t j = 0; j < symbols.size(); ++j) {
            const std::uint32_t count = counts[symbols[j]];
            if (count != 0) result[i].push_back({static_cast<std::uint32_t>(j), count});
        }
    }
    return result;
}

std::array<BigInt, 256> lengths_of_symbols(const Substitution& substitution, std::uint64_t steps) {
    std::vector<BigInt> lengths = lengths_of(occurrences(substitution, themselves), steps);
    std::array<BigInt, 256> result;
    std::move(lengths.begin(), lengths.end(), result.begin());
    return result;
}

std::array<BigInt, 256> counts_of_symbols(const Substitution& substitution, Symbols word, std::uint64_t steps) {
    const std::vector<std::uint8_t> symbols = symbols_from(substitution, word);
    const std::vector<std::vector<Occurrence>> in_images = occurrences(substitution, symbols);
    std::array<std::uint64_t, 256> counts{};
    for (const std::uint8_t s : word) ++counts[s];
    std::vector<BigInt> now, next(symbols.size());
    for (const std::uint8_t symbol : symbols) now.emplace_back(counts[symbol]);
    for (std::uint64_t step = 0; step < steps; ++step) {
        for (BigInt& count : next) count.limbs.clear();
        for (std::size_t i = 0; i < symbols.size(); ++i) {
            for (const Occurrence& o : in_images[i]) add_product(next[o.symbol], now[i], o.count);
        }
        now.swap(next);
        if (now == next) break;
    }
    std::array<BigInt, 256> result;
    for (std::size_t i = 0; i < symbols.size(); ++i) result[symbols[i]] = std::move(now[i]);
    return result;
}

BigInt length_of_word(const Substitution& substitution, Symbols word, std::uint64_t steps) {
    const std::vector<std::uint8_t> symbols = symbols_from(substitution, word);
    const std::vector<BigInt> lengths = lengths_of(occurrences(substitution, symbols), steps);
    std::array<std::uint64_t, 256> counts{};
    for (const std::uint8_t s : word) ++counts[s];
    BigInt sum;
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        for (std::uint64_t left = counts[symbols[i]]; left != 0;) {
            const auto part = static_cast<std::uint32_t>(std::min<std::uint64_t>(left, UINT32_MAX));
            add_product(sum, lengths[i], part);
            left -= part;
        }
    }
    return sum;
}

std::uint64_t steps_within(const Substitution& substitution, Symbols symbols, std::uint64_t steps, std::uint64_t most) {
    Growth growth(substitution, {}, symbols);
    for (std::uint64_t step = 1; step <= steps; ++step) {
        if (!growth.advance()) return steps;
        if (growth.of_all_symbols() > most) return std::max<std::uint64_t>(step - 1, 1);
    }
    return steps;
}

Substitution iterated(const Substitution& substitution, Symbols symbols, std::uint64_t steps) {
    Substitution result, square = substitution;
    for (std::uint64_t rest = steps; rest != 0; rest >>= 1) {
        if ((rest & 1) != 0) result = in_turn(result, square, symbols);
        if (rest > 1) square = in_turn(square, square, symbols);
    }
    return result;
}

Result<ByteWord> power(const Substitution& substitution, Symbols word, std::uint64_t steps, std::uint64_t most_symbols,
                       Executor& executor, ByteWord reuse) {
    const std::vector<std::uint8_t> symbols = symbols_from(substitution, word);
    Growth growth(substitution, word, symbols);
    std::uint64_t growing = 0;  // steps until no length changes any more
    while (growing < steps && growth.advance()) {
        ++growing;
        if (growth.of_word() <= most_symbols) continue;
        return fault(Fault::limit, "limit.elements",
                     "step " + std::to_string(growing) + " makes a word of " +
                         to_text(length_of_word(substitution, word, growing)) +
                         " symbols, which is more than the limit of " + std::to_string(most_symbols));
    }

    std::optional<ByteWord> made;
    Diagnostics reasons;
    std::uint64_t left = steps;
    const auto take = [&](const Substitution& at_once, std::uint64_t count) {
        left -= count;
        Result<ByteWord> next = apply(at_once, made ? made->symbols() : word, most_symbols, executor,
                                      left == 0 ? std::move(reuse) : ByteWord());
        if (next) made = *std::move(next);
        reasons = std::move(next).diagnostics();
        return !has_errors(reasons);
    };
    if (growing != 0) {
        std::uint64_t count = steps_within(substitution, symbols, growing, bytes_near);
        if (growing / count > passes_near) {
            count = steps_within(substitution, symbols, growing, std::max(bytes_near, growth.of_word() / 4));
        }
        const std::uint64_t first = growing % count;
        if (first != 0 && !take(iterated(substitution, symbols, first), first)) return reasons;
        const Substitution images = iterated(substitution, symbols, count);
        for (std::uint64_t pass = growing / count; pass > 0; --pass) {
            if (!take(images, count)) return reasons;
        }
    }
    // What is left changes no length, so that images stay small for any number of steps.
    if (left != 0 || !made) {
        const std::vector<std::uint8_t> remaining = symbols_from(substitution, made ? made->symbols() : word);
        if (!take(iterated(substitution, remaining, left), left)) return reasons;
    }
    return *std::move(made);
}

}  // namespace filigree::rewriting
