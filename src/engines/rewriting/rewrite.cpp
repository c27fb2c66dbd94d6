#include "engines/rewriting/rewrite.h"

#include "engines/rewriting/large_pages.h"
#include "engines/rewriting/rewrite_outputs.h"

namespace filigree::rewriting {

using Kind = StepPlan::Kind;

QuickTable::QuickTable(const StepPlan& plan, const Alphabet& alphabet) {
    sizes.fill(slow);
    const auto set = [this](Symbol symbol, bool has_freeze, const std::vector<Symbol>& image) {
        if (image.size() > width) return;
        const std::size_t at = index_of(symbol, has_freeze);
        std::copy(image.begin(), image.end(), images[at].begin());
        sizes[at] = static_cast<std::uint8_t>(image.size());
    };
    for (std::size_t s = 0; s < plan.entries.size(); ++s) {
        const StepPlan::Entry& entry = plan.entries[s];
        const auto symbol = static_cast<Symbol>(s);
        const Role role = alphabet[symbol].role;
        const bool is_kept = entry.kind == Kind::keep || entry.kind == Kind::invert;
        const bool is_counted = role == Role::ordinal || role == Role::follower;
        if (is_counted || (role == Role::macro && !is_kept)) continue;
        set(symbol, true, {symbol});
        if (entry.may_rest) continue;
        if (role == Role::freeze) {
            set(symbol, false, {});
        } else if (is_kept) {
            set(symbol, false, {symbol});
        } else if (entry.kind == Kind::put && entry.image != StepPlan::decided) {
            const Image& image = plan.images[entry.image];
            const bool is_quick = std::none_of(image.symbols.begin(), image.symbols.end(),
                                               [&](Symbol put) { return alphabet[put].role == Role::follower; });
            if (is_quick && !image.is_kept) set(symbol, false, image.symbols);
        }
    }
}

namespace {

// Whether a symbol is as old as the place that it holds ("whenever a symbol maintains in the same position").
void set_ages_by_position(const Word& from, const Alphabet& alphabet, const std::vector<std::uint8_t>& stays,
                          Word& to) {
    std::size_t old_place = 0, place = 0;
    for (std::size_t index = 0; index < to.ages.size() && index < from.ages.size(); ++index, ++old_place, ++place) {
        while (from.symbols[old_place] == Alphabet::freeze) ++old_place;
        while (to.symbols[place] == Alphabet::freeze) ++place;
        const bool is_alike = alphabet[from.symbols[old_place]].letter == alphabet[to.symbols[place]].letter;
        if (stays[index] != 0 && is_alike) to.ages[index] = from.ages[index] + 1;
    }
}

void write_columns(const Rewriting& in, AgeMode mode, Word& made) {
    WritingColumns writing(in, mode == AgeMode::lineage, made);
    Progress progress;
    rewrite_symbols(in, 0, in.word.size(), progress, writing);
    if (!in.word.ages.empty() && mode == AgeMode::position) {
        set_ages_by_position(in.word, in.alphabet, writing.stays, made);
    }
}

bool has_columns(const Word& word) { return !word.keys.empty() || !word.ages.empty(); }

// Up to where the word turns out to have no order.
void count_chunks(const Rewriting& in, Measured& measured, Progress& progress, Counting& counting) {
    constexpr std::size_t most_strangers = 4096;
    constexpr std::size_t length = ChunkTable::length;
    ChunkTable& table = *measured.table;
    const std::size_t count = (in.word.size() - ChunkTable::seen) / length + 1;
    measured.chunks.reserve(count);
    std::uint64_t quick = 0;
    std::size_t begin = 0;  // of those that go by symbol, up to here
    for (std::size_t c = 0; c < count && table.strangers() <= most_strangers + c / 2; ++c) {
        const ChunkTable::Code code = table.code_at(in, c * length);
        measured.chunks.push_back(code);
        quick += table.size_of(code);
        if (code == ChunkTable::by_symbol) continue;
        if (begin < c) rewrite_symbols(in, begin * length, c * length, progress, counting);
        begin = c + 1;
    }
    rewrite_symbols(in, begin * length, measured.chunks.size() * length, progress, counting);
    counting.add(quick);
}

void write_chunks(const Rewriting& in, const Measured& measured, Progress& progress, Writing& writing) {
    const std::vector<ChunkTable::Code>& chunks = measured.chunks;
    const ChunkTable& table = *measured.table;
    constexpr std::size_t together = 64;
    static_assert(ChunkTable::width <= Writing::widest && together * ChunkTable::width <= Writing::block_size);
    for (std::size_t c = 0; c < chunks.size();) {
        const std::size_t begin = c;
        while (c < chunks.size() && chunks[c] == ChunkTable::by_symbol) ++c;
        rewrite_symbols(in, begin * ChunkTable::length, c * ChunkTable::length, progress, writing);
        Symbol* to = writing.room(together * ChunkTable::width);
        const std::size_t end = std::min(chunks.size(), c + together);
        for (; c < end && chunks[c] != ChunkTable::by_symbol; ++c) {
            std::memcpy(to, table.image_of(chunks[c]).data(), ChunkTable::width);
            to += table.size_of(chunks[c]);
        }
        writing.fill(to);
    }
}

}  // namespace

Measured measure(const Rewriting& in, std::size_t chunks_from) {
    Measured measured;
    Progress progress;
    Counting counting(in);
    if (!has_columns(in.word) && in.plan.resting.empty() && in.word.size() >= std::max(chunks_from, ChunkTable::seen)) {
        measured.table.emplace(in);
        count_chunks(in, measured, progress, counting);
    }
    rewrite_symbols(in, measured.chunks.size() * ChunkTable::length, in.word.size(), progress, counting);
    measured.symbols = counting.symbols;
    measured.followers = counting.followers;
    return measured;
}

Word rewrite(const Rewriting& in, const Measured& measured, AgeMode mode) {
    Word made;
    made.symbols.reserve(measured.symbols);
    ask_for_large_pages(made.symbols.data(), made.symbols.capacity());
    made.origins.reserve(measured.followers);
    if (!in.word.keys.empty()) made.keys.reserve(measured.symbols);
    if (!in.word.ages.empty()) made.ages.reserve(measured.symbols);
    if (has_columns(in.word)) {
        write_columns(in, mode, made);
        return made;
    }
    Writing writing(in, made);
    Progress progress;
    if (measured.table) write_chunks(in, measured, progress, writing);
    rewrite_symbols(in, measured.chunks.size() * ChunkTable::length, in.word.size(), progress, writing);
    writing.flush();
    return made;
}

std::vector<std::uint32_t> parents_of(const Rewriting& in) {
    Tracing tracing(in);
    Progress progress;
    rewrite_symbols(in, 0, in.word.size(), progress, tracing);
    return std::move(tracing.parents);
}

}  // namespace filigree::rewriting
