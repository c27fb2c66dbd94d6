// One step of a substitution. Short images are written whole, with what follows them in their table, and the next one
// over that: a store of constant size and an addition a symbol. Parts of the word are written apart, each exactly.
#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <string>

#include "engines/rewriting/substitution.h"

namespace filigree::rewriting {
namespace {

using Symbols = std::span<const std::uint8_t>;

// The images of all symbols, each in `width` bytes.
template <std::size_t width>
struct Table {
    alignas(64) std::array<std::uint8_t, 256 * width> images{};
    std::array<std::uint32_t, 256> sizes{};
};

template <std::size_t width>
std::unique_ptr<const Table<width>> make_table(const std::array<Symbols, 256>& images) {
    auto table = std::make_unique<Table<width>>();
    for (std::size_t s = 0; s < 256; ++s) {
        if (images[s].size() <= width) std::copy(images[s].begin(), images[s].end(), &table->images[s * width]);
        table->sizes[s] = static_cast<std::uint32_t>(images[s].size());
    }
    return table;
}

// All images fit into the width.
template <std::size_t width>
void write_short(const Table<width>& table, Symbols from, std::uint8_t* to, const std::uint8_t* end) {
    const auto put = [&](std::size_t symbol) {
        std::memcpy(to, &table.images[symbol * width], width);
        to += table.sizes[symbol];
    };
    std::size_t i = 0;
    constexpr std::size_t together = 8;
    while (i + together <= from.size() && static_cast<std::size_t>(end - to) >= together * width) {
        const std::uint8_t* const s = from.data() + i;
        put(s[0]), put(s[1]), put(s[2]), put(s[3]), put(s[4]), put(s[5]), put(s[6]), put(s[7]);
        i += together;
    }
    for (; i < from.size(); ++i) {
        const std::size_t symbol = from[i];
        for (std::size_t b = 0; b < table.sizes[symbol]; ++b) to[b] = table.images[symbol * width + b];
        to += table.sizes[symbol];
    }
}

// `size` >= 64. The call of memcpy for a size that is not known costs more than most images; beyond some KB it is
// slower.
void copy_block(std::uint8_t* to, const std::uint8_t* from, std::size_t size) {
    const std::uint8_t* const last = from + size - 64;
    std::uint8_t* const to_last = to + size - 64;
    for (; from < last; from += 64, to += 64) std::memcpy(to, from, 64);
    std::memcpy(to_last, last, 64);
}

constexpr std::size_t block_width = 64;

void write_blocks(const Table<block_width>& table, const std::array<Symbols, 256>& images, Symbols from,
                  std::uint8_t* to, const std::uint8_t* end) {
    for (const std::uint8_t symbol : from) {
        const std::size_t size = table.sizes[symbol];
        if (size >= block_width) {
            copy_block(to, images[symbol].data(), size);
        } else if (static_cast<std::size_t>(end - to) >= block_width) {
            std::memcpy(to, &table.images[symbol * block_width], block_width);
        } else {
            std::copy_n(&table.images[symbol * block_width], size, to);
        }
        to += size;
    }
}

std::uint64_t size_of(const std::array<std::uint32_t, 256>& sizes, Symbols from) {
    std::uint64_t a = 0, b = 0, c = 0, d = 0;
    std::size_t i = 0;
    for (; i + 4 <= from.size(); i += 4) {
        a += sizes[from[i]], b += sizes[from[i + 1]], c += sizes[from[i + 2]], d += sizes[from[i + 3]];
    }
    for (; i < from.size(); ++i) a += sizes[from[i]];
    return a + b + c + d;
}

// --- two symbols at a time, where words are long and of few symbols --------------------------------------------------

constexpr std::size_t pairs_pay_from = 1 << 16;  // symbols of a word
constexpr std::size_t most_paired = 24;          // symbols of which all pairs of images lie in the nearest cache

// What the symbols of a part become: the bytes, the pairs of more than 16, and those of more than 32 or of symbols that
// are not paired. A part is short enough for each to stay in its field.
struct Tally {
    std::uint64_t fields = 0;

    std::uint64_t bytes() const { return fields & UINT32_MAX; }
    std::size_t width() const { return fields >> 48 != 0 ? 0 : fields >> 32 != 0 ? 32 : 16; }
};
constexpr Tally tally_of_pair(std::uint64_t size) {
    return {size | (size > 16 ? std::uint64_t{1} << 32 : 0) | (size > 32 ? std::uint64_t{1} << 48 : 0)};
}
constexpr Tally tally_of_unpaired{std::uint64_t{1} << 48};

struct Pairs {
    std::vector<std::uint16_t> codes;  // of first + 256 second; 0 for those that are not paired
    std::vector<Tally> tallies;        // of a code
    std::vector<std::uint32_t> sizes;
    std::vector<std::uint8_t> images16, images32;  // those that fit
};

std::size_t index_of_pair(const std::uint8_t* at) { return at[0] | std::size_t{at[1]} << 8; }

// The symbols that stand in samples of the word: one that is missed makes its part slower, not wrong.
std::vector<std::uint8_t> sampled_symbols(Symbols word) {
    constexpr std::size_t samples = 64, length = 128;
    std::array<bool, 256> seen{};
    for (std::size_t sample = 0; sample < samples; ++sample) {
        const std::size_t begin = (word.size() - length) / (samples - 1) * sample;
        for (const std::uint8_t s : word.subspan(begin, length)) seen[s] = true;
    }
    std::vector<std::uint8_t> result;
    for (std::size_t s = 0; s < 256; ++s) {
        if (seen[s]) result.push_back(static_cast<std::uint8_t>(s));
    }
    return result;
}

Pairs make_pairs(const std::array<Symbols, 256>& images, const std::vector<std::uint8_t>& symbols) {
    Pairs result;
    const std::size_t count = 1 + symbols.size() * symbols.size();
    result.codes.resize(1 << 16);
    result.tallies.assign(1, tally_of_unpaired);
    result.sizes.assign(1, 0);
    result.images16.resize(16 * count);
    result.images32.resize(32 * count);
    for (const std::uint8_t first : symbols) {
        for (const std::uint8_t second : symbols) {
            const std::size_t code = result.sizes.size(), size = images[first].size() + images[second].size();
            result.codes[first | std::size_t{second} << 8] = static_cast<std::uint16_t>(code);
            result.tallies.push_back(tally_of_pair(size));
            result.sizes.push_back(static_cast<std::uint32_t>(size));
            const auto write = [&](std::uint8_t* to) {
                std::copy(images[second].begin(), images[second].end(),
                          std::copy(images[first].begin(), images[first].end(), to));
            };
            if (size <= 16) write(&result.images16[16 * code]);
            if (size <= 32) write(&result.images32[32 * code]);
        }
    }
    return result;
}

Tally tally_of(const Pairs& pairs, Symbols from) {
    std::uint64_t a = 0, b = 0;
    std::size_t i = 0;
    for (; i + 4 <= from.size(); i += 4) {
        a += pairs.tallies[pairs.codes[index_of_pair(&from[i])]].fields;
        b += pairs.tallies[pairs.codes[index_of_pair(&from[i + 2])]].fields;
    }
    return {a + b};
}

// Returns how many symbols were written: all but some at the end.
template <std::size_t width>
std::size_t write_pairs(const Pairs& pairs, Symbols from, std::uint8_t*& to, const std::uint8_t* end) {
    // What is written may lie anywhere, for all that the compiler knows; so it would read these anew for each pair.
    const std::uint8_t* const images = width == 16 ? pairs.images16.data() : pairs.images32.data();
    const std::uint16_t* const codes = pairs.codes.data();
    const std::uint32_t* const sizes = pairs.sizes.data();
    std::uint8_t* at = to;
    const auto put = [&](const std::uint8_t* symbols) {
        const std::size_t code = codes[index_of_pair(symbols)];
        std::memcpy(at, images + code * width, width);
        at += sizes[code];
    };
    std::size_t i = 0;
    for (; i + 8 <= from.size() && static_cast<std::size_t>(end - at) >= 4 * width; i += 8) {
        const std::uint8_t* const s = from.data() + i;
        put(s), put(s + 2), put(s + 4), put(s + 6);
    }
    to = at;
    return i;
}

// --- a step ----------------------------------------------------------------------------------------------------------

// Short words are written in one part: threads would cost more than they save.
constexpr std::size_t part_size = 1 << 15;
constexpr std::uint64_t part_bytes = 1 << 20;

struct Part {
    std::uint64_t bytes = 0;
    std::size_t pair_width = 0;  // 0: not in pairs
};

// measure(symbols) makes a Part, write(symbols, pair width, begin, end) its bytes.
template <class Measure, class Write>
Result<ByteWord> in_two_passes(std::size_t longest, Symbols word, std::uint64_t most_symbols, Executor& executor,
                               ByteWord made, const Measure& measure, const Write& write) {
    const std::size_t size_of_part =
        std::clamp<std::size_t>(part_bytes / std::max<std::size_t>(longest, 1), 64, part_size);
    std::vector<Part> parts((word.size() + size_of_part - 1) / size_of_part);
    const auto symbols_of = [&](std::size_t p) {
        const std::size_t begin = p * size_of_part;
        return word.subspan(begin, std::min(size_of_part, word.size() - begin));
    };
    executor.run(parts.size(), [&](std::size_t p) { parts[p] = measure(symbols_of(p)); });
    std::vector<std::uint64_t> begins{0};
    for (const Part& part : parts) begins.push_back(begins.back() + part.bytes);

    const std::uint64_t size = begins.back();
    if (size > most_symbols) {
        return fault(Fault::limit, "limit.elements",
                     "a step makes a word of " + std::to_string(size) + " symbols, which is more than the limit of " +
                         std::to_string(most_symbols));
    }
    if (!made.make(size)) {
        return fault(Fault::limit, "limit.memory",
                     "there is no memory for a word of " + std::to_string(size) + " symbols");
    }
    std::uint8_t* const to = made.data();
    executor.run(parts.size(),
                 [&](std::size_t p) { write(symbols_of(p), parts[p].pair_width, to + begins[p], to + begins[p + 1]); });
    return made;
}

}  // namespace

Result<ByteWord> apply(const Substitution& substitution, Symbols word, std::uint64_t most_symbols, Executor& executor,
                       ByteWord reuse) {
    std::array<Symbols, 256> images;
    std::size_t longest = 0;
    for (std::size_t s = 0; s < 256; ++s) {
        images[s] = image_of(substitution, static_cast<std::uint8_t>(s));
        longest = std::max(longest, images[s].size());
    }
    const auto with_short_images = [&]<std::size_t width>(std::unique_ptr<const Table<width>> table) {
        std::optional<Pairs> pairs;
        if (word.size() >= pairs_pay_from) {
            const std::vector<std::uint8_t> symbols = sampled_symbols(word);
            if (symbols.size() <= most_paired) pairs = make_pairs(images, symbols);
        }
        const auto measure = [&](Symbols from) -> Part {
            const Tally tally = pairs ? tally_of(*pairs, from) : tally_of_unpaired;
            if (tally.width() == 0) return {size_of(table->sizes, from), 0};
            return {tally.bytes() + size_of(table->sizes, from.last(from.size() % 4)), tally.width()};
        };
        const auto write = [&](Symbols from, std::size_t pair_width, std::uint8_t* to, const std::uint8_t* end) {
            std::size_t written = 0;
            if (pair_width == 16) written = write_pairs<16>(*pairs, from, to, end);
            if (pair_width == 32) written = write_pairs<32>(*pairs, from, to, end);
            write_short(*table, from.subspan(written), to, end);
        };
        return in_two_passes(longest, word, most_symbols, executor, std::move(reuse), measure, write);
    };
    if (longest <= 16) return with_short_images(make_table<16>(images));
    if (longest <= 32) return with_short_images(make_table<32>(images));
    const auto table = make_table<block_width>(images);
    const auto measure = [&](Symbols from) { return Part{size_of(table->sizes, from), 0}; };
    const auto write = [&](Symbols from, std::size_t, std::uint8_t* to, const std::uint8_t* end) {
        write_blocks(*table, images, from, to, end);
    };
    return in_two_passes(longest, word, most_symbols, executor, std::move(reuse), measure, write);
}

}  // namespace filigree::rewriting
