// What symbols are rewritten into: a count, a word, a word with columns, or who puts what.
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "base/random.h"
#include "engines/rewriting/rewrite_symbols.h"

namespace filigree::rewriting {

// Counts what is put, up to `too_many`.
class Counting {
public:
    static constexpr bool is_quick = true;
    explicit Counting(const Rewriting& in) : in_(in) {}

    void at(std::size_t) {}
    // From a place on, up to the first that is slow; returns that. Behind the end there is another symbol.
    std::size_t put_quick_ones(std::size_t place, std::size_t end) {
        const Symbol* const from = in_.word.symbols.data();
        std::uint64_t count = 0;
        for (; place < end; ++place) {
            const std::uint8_t size = in_.quick.sizes[QuickTable::index_at(from + place)];
            if (size == QuickTable::slow) break;
            count += size;
        }
        symbols += count;
        return place;
    }
    void put(const std::vector<Symbol>& image, std::uint64_t times, std::size_t, std::uint32_t) {
        const bool is_too_much = !image.empty() && times > too_many / image.size();
        add(is_too_much ? too_many : image.size() * times);
        if (!is_too_much) followers += in_.followers_in(image) * times;
    }
    void put_freeze() { add(1); }
    void copy_all(std::size_t) {
        add(in_.word.size());
        followers += in_.word.origins.size();
    }
    void keep(std::size_t, std::uint32_t origin) {
        add(1);
        followers += origin != 0 ? 1 : 0;
    }
    void keep_run(std::size_t begin, std::size_t end, std::size_t) { add(end - begin); }
    void repeat(Symbol, std::uint64_t count) { add(count); }
    void add(std::uint64_t count) { symbols = std::min(too_many, symbols + count); }

    std::uint64_t symbols = 0;
    std::uint64_t followers = 0;  // among them, where they are not too many

private:
    const Rewriting& in_;
};

// Writes what a word without columns has, by way of a block that stays in the nearest cache: so stores may write beyond
// what they put, and the memory of the word is filled once.
class Writing {
public:
    static constexpr bool is_quick = true;
    static constexpr std::size_t widest = 64;  // of quick stores

    Writing(const Rewriting& in, Word& out) : in_(in), out_(out) {}

    void at(std::size_t) {}
    std::size_t put_quick_ones(std::size_t place, std::size_t end) {
        constexpr std::size_t together = 64;
        const Symbol* const from = in_.word.symbols.data();
        const QuickTable& quick = in_.quick;
        while (place < end && quick.sizes[QuickTable::index_at(from + place)] != QuickTable::slow) {
            Symbol* to = room(together * QuickTable::width);
            for (const std::size_t until = std::min(end, place + together); place < until; ++place) {
                const std::size_t at = QuickTable::index_at(from + place);
                const std::uint8_t size = quick.sizes[at];
                if (size == QuickTable::slow) break;
                std::memcpy(to, quick.images[at].data(), QuickTable::width);
                to += size;
            }
            fill(to);
        }
        return place;
    }
    void put(const std::vector<Symbol>& image, std::uint64_t times, std::size_t, std::uint32_t origin) {
        out_.origins.insert(out_.origins.end(), in_.followers_in(image) * times, origin);
        if (image.size() <= block_size / 2 && times > 1) return put_often(image, times);
        for (; times > 0; --times) append(image);
    }
    void put_freeze() { repeat(Alphabet::freeze, 1); }
    void copy_all(std::size_t) {
        append(in_.word.symbols);
        out_.origins.insert(out_.origins.end(), in_.word.origins.begin(), in_.word.origins.end());
    }
    void keep(std::size_t place, std::uint32_t origin) {
        repeat(in_.word.symbols[place], 1);
        if (origin != 0) out_.origins.push_back(origin);
    }
    void keep_run(std::size_t begin, std::size_t end, std::size_t) {
        while (begin < end) {
            const std::size_t next = in_.has_gaits ? std::min(end, end_of_stretch(in_.word.symbols, begin)) : end;
            repeat(in_.word.symbols[begin], next - begin);
            begin = next;
        }
    }
    void repeat(Symbol symbol, std::uint64_t count) {
        if (count > block_size) {
            flush();
            out_.symbols.insert(out_.symbols.end(), count, symbol);
        } else {
            std::fill_n(room(count), count, symbol);
            used_ += count;
        }
    }

    // Behind what was written, with at least so much room (at most a block).
    Symbol* room(std::size_t count) {
        if (count > block_size + widest - used_) flush();
        return block_.get() + used_;
    }
    // Up to where the room that was asked for was filled.
    void fill(const Symbol* end) { used_ = static_cast<std::size_t>(end - block_.get()); }
    // Before the word is read.
    void flush() {
        out_.symbols.insert(out_.symbols.end(), block_.get(), block_.get() + used_);
        used_ = 0;
    }

    static constexpr std::size_t block_size = 1 << 14;

private:
    void append(const std::vector<Symbol>& symbols) {
        if (symbols.size() > block_size) {
            flush();
            out_.symbols.insert(out_.symbols.end(), symbols.begin(), symbols.end());
        } else {
            std::copy(symbols.begin(), symbols.end(), room(symbols.size()));
            used_ += symbols.size();
        }
    }
    // Doubles what was put until it is enough or nearly fills a block; that goes into the word as often as needed.
    void put_often(const std::vector<Symbol>& image, std::uint64_t times) {
        const std::uint64_t count = image.size() * times;
        if (count == 0) return;
        const std::size_t most = std::min<std::uint64_t>(count, block_size / image.size() * image.size());
        if (count > most) flush();
        Symbol* const begin = room(most);
        std::copy(image.begin(), image.end(), begin);
        for (std::size_t made = image.size(), more = 0; made < most; made += more) {
            more = std::min(made, most - made);
            std::memcpy(begin + made, begin, more);
        }
        used_ += most;
        for (std::uint64_t left = count - most, more = 0; left > 0; left -= more) {
            more = std::min<std::uint64_t>(left, most);
            out_.symbols.insert(out_.symbols.end(), begin, begin + more);
        }
    }

    const Rewriting& in_;
    Word& out_;
    std::unique_ptr<Symbol[]> block_ = std::make_unique_for_overwrite<Symbol[]>(block_size + widest);
    std::size_t used_ = 0;
};

// Writes all columns that the old word has.
class WritingColumns {
public:
    static constexpr bool is_quick = false;

    WritingColumns(const Rewriting& in, bool ages_by_lineage, Word& out)
        : from_(in.word), alphabet_(in.alphabet), ages_by_lineage_(ages_by_lineage), out_(out) {
        stays.assign(from_.ages.size(), 0);
    }

    // Which symbol of the old word comes next, counted without '='.
    void at(std::size_t index) {
        index_ = index;
        children_ = 0;
    }
    void put(const std::vector<Symbol>& image, std::uint64_t times, std::size_t place, std::uint32_t origin) {
        bool was_met = false;
        for (; times > 0; --times) {
            for (const Symbol symbol : image) {
                if (symbol == Alphabet::freeze) {
                    put_freeze();
                    continue;
                }
                const bool is_own = alphabet_[symbol].letter == letter_at(place);
                const bool inherits = is_own && !was_met;
                was_met = was_met || is_own;
                if (alphabet_[symbol].role == Role::follower) out_.origins.push_back(origin);
                add(symbol, child_key(), inherits ? age_at() + 1 : 1);
            }
        }
        if (was_met) set_stays();
    }
    void put_freeze() { out_.symbols.push_back(Alphabet::freeze); }
    void copy_all(std::size_t place) {
        bool was_met = false;
        for (const Symbol symbol : from_.symbols) {
            if (symbol == Alphabet::freeze) {
                put_freeze();
                continue;
            }
            const bool inherits = !was_met && alphabet_[symbol].letter == letter_at(place);
            was_met = was_met || inherits;
            add(symbol, child_key(), inherits ? age_at() + 1 : 1);
        }
        out_.origins.insert(out_.origins.end(), from_.origins.begin(), from_.origins.end());
        set_stays();
    }
    void keep(std::size_t place, std::uint32_t origin) {
        add(from_.symbols[place], key_at(), age_at() + 1);
        if (origin != 0) out_.origins.push_back(origin);
        set_stays();
    }
    // `index`: of its first member.
    void keep_run(std::size_t begin, std::size_t end, std::size_t index) {
        for (std::size_t place = begin; place < end; ++place, ++index) {
            at(index);
            keep(place, 0);
        }
    }
    // More of a run, behind its last member.
    void repeat(Symbol symbol, std::uint64_t count) {
        for (; count > 0; --count) add(symbol, child_key(), 1);
    }

    std::vector<std::uint8_t> stays;  // for each symbol of the old word: whether it could still stand where it stood

private:
    char32_t letter_at(std::size_t place) const { return alphabet_[from_.symbols[place]].letter; }
    std::uint64_t key_at() const { return from_.keys.empty() ? 0 : from_.keys[index_]; }
    std::uint32_t age_at() const { return from_.ages.empty() ? 0 : from_.ages[index_]; }
    std::uint64_t child_key() { return from_.keys.empty() ? 0 : fold(key_at(), children_++); }
    void set_stays() {
        if (!stays.empty()) stays[index_] = 1;
    }
    void add(Symbol symbol, std::uint64_t key, std::uint32_t age) {
        out_.symbols.push_back(symbol);
        if (!from_.keys.empty()) out_.keys.push_back(key);
        if (!from_.ages.empty()) out_.ages.push_back(ages_by_lineage_ ? age : 1);
    }

    const Word& from_;
    const Alphabet& alphabet_;
    const bool ages_by_lineage_;
    Word& out_;
    std::size_t index_ = 0;
    std::uint64_t children_ = 0;
};

// Writes who puts each symbol, '=' left out.
class Tracing {
public:
    static constexpr bool is_quick = false;
    explicit Tracing(const Rewriting& in) : in_(in) {}

    void at(std::size_t index) { index_ = static_cast<std::uint32_t>(index); }
    void put(const std::vector<Symbol>& image, std::uint64_t times, std::size_t, std::uint32_t) {
        add(awake(image) * times);
    }
    void put_freeze() {}
    void copy_all(std::size_t) { add(awake(in_.word.symbols)); }
    void keep(std::size_t, std::uint32_t) { add(1); }
    void keep_run(std::size_t begin, std::size_t end, std::size_t index) {
        for (std::size_t place = begin; place < end; ++place, ++index) {
            at(index);
            add(1);
        }
    }
    void repeat(Symbol, std::uint64_t count) { add(count); }

    std::vector<std::uint32_t> parents;

private:
    static std::uint64_t awake(const std::vector<Symbol>& symbols) {
        return symbols.size() -
               static_cast<std::uint64_t>(std::count(symbols.begin(), symbols.end(), Alphabet::freeze));
    }
    void add(std::uint64_t count) { parents.insert(parents.end(), count, index_); }

    const Rewriting& in_;
    std::uint32_t index_ = 0;
};

}  // namespace filigree::rewriting
