#include "engines/rewriting/rewrite_chunks.h"

#include "engines/rewriting/rewrite_outputs.h"

namespace filigree::rewriting {

using Kind = StepPlan::Kind;

ChunkTable::ChunkTable(const Rewriting& in) : slots_(std::size_t{1} << bits), images_(1), sizes_(1, 0) {
    const StepPlan& plan = in.plan;
    const bool counts_ordinals = std::any_of(plan.entries.begin(), plan.entries.end(),
                                             [](const StepPlan::Entry& entry) { return entry.kind == Kind::multiply; });
    std::size_t reach = 1;
    for (std::size_t s = 0; s < plan.entries.size(); ++s) {
        const StepPlan::Entry& entry = plan.entries[s];
        const Role role = in.alphabet[static_cast<Symbol>(s)].role;
        switch (entry.kind) {
            case Kind::keep:
            case Kind::invert:
                is_local_[s] = role != Role::follower && (role != Role::ordinal || !counts_ordinals);
                break;
            case Kind::put:
                is_local_[s] =
                    entry.image != StepPlan::decided && in.followers_in(plan.images[entry.image].symbols) == 0;
                break;
            case Kind::count: {
                // It goes where the run ends up to `gain` symbols behind it, at an inverter with no '=' behind that.
                const std::size_t its_reach = std::size_t{entry.gain} + 1;
                is_local_[s] = its_reach <= seen - length;
                if (is_local_[s]) reach = std::max(reach, its_reach);
                break;
            }
            default:
                break;
        }
    }
    std::array<std::uint8_t, sizeof behind_> mask{};
    std::fill_n(mask.begin(), reach, std::uint8_t{255});
    std::memcpy(&behind_, mask.data(), sizeof behind_);
}

ChunkTable::Code ChunkTable::add(const Rewriting& in, std::size_t place, const Key& key, std::size_t slot) {
    if (images_.size() == most_images) {
        ++strangers_;
        return by_symbol;
    }
    slots_[slot] = {key, by_symbol};
    const Symbol* const symbols = in.word.symbols.data() + place;
    if (!std::all_of(symbols, symbols + length, [&](Symbol symbol) { return is_local_[symbol]; })) return by_symbol;
    Progress progress;
    Counting counting(in);
    rewrite_symbols(in, place, place + length, progress, counting);
    if (counting.symbols > width) return by_symbol;
    Word image;
    Writing writing(in, image);
    progress = {};
    rewrite_symbols(in, place, place + length, progress, writing);
    writing.flush();
    slots_[slot].code = static_cast<Code>(images_.size());
    sizes_.push_back(static_cast<std::uint8_t>(image.size()));
    images_.emplace_back();
    std::copy(image.symbols.begin(), image.symbols.end(), images_.back().begin());
    return slots_[slot].code;
}

}  // namespace filigree::rewriting
