#include "engines/rewriting/implicit_word.h"

#include <algorithm>
#include <string>
#include <utility>

namespace filigree::rewriting {
namespace {

using Symbols = std::span<const std::uint8_t>;

constexpr std::uint64_t bytes_of_blocks = 16 << 10;  // of all symbols together
constexpr std::size_t start_every = 64;              // symbols of the first word

bool stands_for_itself(Symbols image, std::uint8_t symbol) { return image.size() == 1 && image[0] == symbol; }

std::uint64_t bytes_of(const BigInt& number) { return sizeof(BigInt) + number.limbs.size() * sizeof(number.limbs[0]); }

}  // namespace

// What is to come, as symbols with steps left, the nearest last; and in front of all that, symbols that are ready.
class ImplicitWord::Walk {
public:
    // `position` must lie in the word.
    Walk(const ImplicitWord& in, const BigInt& position) : in_(in) {
        const auto after = std::upper_bound(in.starts_.begin(), in.starts_.end(), position);
        const auto start = static_cast<std::size_t>(after - in.starts_.begin()) - 1;
        BigInt rest = position;
        subtract(rest, in.starts_[start]);
        Frame frame{Symbols(in.word_).subspan(start * start_every), in.steps_};
        // Numbers are big until one of 64 bits lies in a row of such: from there on down all are.
        while (!in.is_narrow(frame.height) || !to_u64(rest)) {
            std::size_t i = 0;
            for (BigInt length; (length = in.length_of(frame.height, frame.symbols[i])) <= rest; ++i) {
                subtract(rest, length);
            }
            if (!enter(frame, i)) return;
        }
        for (std::uint64_t left = *to_u64(rest);;) {
            std::size_t i = 0;
            for (std::uint64_t length = 0; (length = in.narrow(frame.height, frame.symbols[i])) <= left; ++i) {
                left -= length;
            }
            if (enter(frame, i)) continue;
            ready_ = ready_.subspan(left);
            return;
        }
    }

    // The symbols that come next, at least one; none at the end.
    Symbols next() {
        while (ready_.empty() && !open_.empty()) {
            Frame frame = open_.back();
            open_.pop_back();
            std::size_t i = 0;
            while (i < frame.symbols.size() && in_.is_empty(frame.height, frame.symbols[i])) ++i;
            if (i < frame.symbols.size() && enter(frame, i)) open_.push_back(frame);
        }
        return std::exchange(ready_, {});
    }

private:
    // Leaves what follows symbol i open and steps down to its image; false where its last symbols are ready.
    bool enter(Frame& frame, std::size_t i) {
        const std::uint8_t symbol = frame.symbols[i];
        if (i + 1 < frame.symbols.size()) open_.push_back({frame.symbols.subspan(i + 1), frame.height});
        ready_ = image_of(in_.substitution_, symbol);
        // Without this a word of many that only wait would cost all their steps.
        if (stands_for_itself(ready_, symbol)) return false;
        if (frame.height == in_.block_steps_) {
            ready_ = image_of(in_.blocks_, symbol);
            return false;
        }
        frame = {std::exchange(ready_, {}), frame.height - 1};
        return true;
    }

    const ImplicitWord& in_;
    std::vector<Frame> open_;
    Symbols ready_;
};

std::size_t ImplicitWord::row(std::uint64_t height) const {
    const std::size_t rows = (narrow_.size() + wide_.size()) / letters_;
    return static_cast<std::size_t>(std::min<std::uint64_t>(height - block_steps_, rows - 1));
}

bool ImplicitWord::is_empty(std::uint64_t height, std::uint8_t symbol) const {
    return is_narrow(height) ? narrow(height, symbol) == 0 : wide(height, symbol).limbs.empty();
}

BigInt ImplicitWord::length_of(std::uint64_t height, std::uint8_t symbol) const {
    return is_narrow(height) ? BigInt(narrow(height, symbol)) : wide(height, symbol);
}

std::optional<std::uint8_t> ImplicitWord::at(const BigInt& position) const {
    if (position >= length_) return std::nullopt;
    return Walk(*this, position).next().front();
}

std::vector<std::uint8_t> ImplicitWord::slice(const BigInt& first, std::size_t count) const {
    std::vector<std::uint8_t> result;
    if (first >= length_ || count == 0) return result;
    Walk walk(*this, first);
    for (Symbols next = walk.next(); !next.empty() && count > 0; next = walk.next()) {
        const std::size_t size = std::min(next.size(), count);
        result.insert(result.end(), next.begin(), next.begin() + static_cast<std::ptrdiff_t>(size));
        count -= size;
    }
    return result;
}

Result<ImplicitWord> implicit_word(const Substitution& substitution, Symbols word, std::uint64_t steps,
                                   std::uint64_t most_bytes) {
    ImplicitWord result;
    result.substitution_ = substitution;
    result.word_.assign(word.begin(), word.end());
    result.steps_ = steps;
    const std::vector<std::uint8_t> symbols = symbols_from(substitution, word);
    if (symbols.empty()) return result;
    result.letters_ = symbols.size();
    for (std::size_t i = 0; i < symbols.size(); ++i) result.place_[symbols[i]] = static_cast<std::uint8_t>(i);
    result.block_steps_ = steps_within(substitution, symbols, steps, bytes_of_blocks);
    result.blocks_ = iterated(substitution, symbols, result.block_steps_);

    const std::vector<std::vector<Occurrence>> in_images = occurrences(substitution, symbols);
    std::vector<BigInt> now, next(symbols.size());
    for (const std::uint8_t symbol : symbols) now.emplace_back(image_of(result.blocks_, symbol).size());
    std::uint64_t bytes = 0;
    for (std::uint64_t height = result.block_steps_;; ++height) {
        const bool fits = result.wide_.empty() &&
                          std::all_of(now.begin(), now.end(), [](const BigInt& length) { return to_u64(length); });
        for (const BigInt& length : now) {
            if (fits) {
                result.narrow_.push_back(*to_u64(length));
            } else {
                result.wide_.push_back(length);
            }
            bytes += fits ? sizeof(std::uint64_t) : bytes_of(length);
        }
        if (bytes > most_bytes) {
            return fault(Fault::limit, "limit.memory",
                         "the lengths of what the symbols become in " + std::to_string(steps) +
                             " steps take more memory than the limit of " + std::to_string(most_bytes) + " bytes");
        }
        if (height == steps) break;
        for (std::size_t i = 0; i < symbols.size(); ++i) {
            next[i].limbs.clear();
            for (const Occurrence& o : in_images[i]) add_product(next[i], now[o.symbol], o.count);
        }
        now.swap(next);
        if (now == next) break;
    }
    // Here `now` holds the lengths after all steps.
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (i % start_every == 0) result.starts_.push_back(result.length_);
        add(result.length_, now[result.place_[word[i]]]);
    }
    return result;
}

}  // namespace filigree::rewriting
