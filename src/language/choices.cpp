#include "language/choices.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/number_text.h"

namespace filigree {

std::string_view name_of(ChoiceSource source) {
    switch (source) {
        case ChoiceSource::drawn:
            return "drawn";
        case ChoiceSource::set:
            return "set";
        case ChoiceSource::fallback:
            return "default";
        case ChoiceSource::middle:
            return "middle";
        case ChoiceSource::replayed:
            return "replayed";
    }
    return "";
}

Value value_of(const Choices& choices, std::size_t row) {
    const ChoiceDomain& domain = choices.domain_table[choices.domains[row]];
    const double value = choices.values[row];
    const bool is_number = domain.kind == ChoiceDomain::Kind::range || domain.kind == ChoiceDomain::Kind::normal;
    if (!is_number) return domain.alternatives[static_cast<std::size_t>(value)];
    Quantity quantity = domain.dimension;
    quantity.value = value;
    return {quantity, {}};
}

// --- text -------------------------------------------------------------------------------------------------------

namespace {

std::string number_text(double value, const Quantity& dimension) {
    std::string out = to_text(value);
    if (dimension.is_angle) out += "deg";
    if (dimension.length_power == 1) out += "px";
    return out;
}

std::string ends_text(const ChoiceDomain& domain) {
    return number_text(domain.low, domain.dimension) + ".." + number_text(domain.high, domain.dimension);
}

}  // namespace

std::string text_with_unit(const Value& value) {
    if (const Quantity* quantity = std::get_if<Quantity>(&value.data)) return number_text(quantity->value, *quantity);
    const ValueList* list = std::get_if<ValueList>(&value.data);
    if (list == nullptr) return to_text(value);
    std::string out = "[";
    for (const Value& item : list->items) out += (out.size() == 1 ? "" : ", ") + text_with_unit(item);
    return out + "]";
}

std::string domain_text(const ChoiceDomain& domain) {
    switch (domain.kind) {
        case ChoiceDomain::Kind::range:
            return ends_text(domain);
        case ChoiceDomain::Kind::normal: {
            const std::string out = "normal(" + number_text(domain.mean, domain.dimension) + ", " +
                                    number_text(domain.deviation, domain.dimension) + ")";
            return std::isfinite(domain.low) ? out + " in " + ends_text(domain) : out;
        }
        case ChoiceDomain::Kind::alternatives: {
            std::string out;
            for (std::size_t i = 0; i < domain.alternatives.size(); ++i) {
                out += (i == 0 ? "" : ", ") + text_with_unit(domain.alternatives[i]);
                if (domain.weights[i] != 1) out += ": " + to_text(domain.weights[i]);
            }
            return "one_of(" + out + ")";
        }
        case ChoiceDomain::Kind::fixed:
            return text_with_unit(domain.alternatives.front());
        case ChoiceDomain::Kind::worded:
            return plain_text(domain.alternatives.front());
    }
    return {};
}

// --- recording --------------------------------------------------------------------------------------------------

namespace {

// As their own comparison says; quick for words, which most alternatives are.
bool is_same(const Value& a, const Value& b) {
    const Symbol *word = std::get_if<Symbol>(&a.data), *other = std::get_if<Symbol>(&b.data);
    return word != nullptr && other != nullptr ? word->name == other->name : a == b;
}

// As their own comparison says, but by the bits of the numbers: where only 0 and -0 differ, a place is written twice.
bool is_same(const ChoiceDomain& a, const ChoiceDomain& b) {
    const auto changed = [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) ^ std::bit_cast<std::uint64_t>(y);
    };
    const std::uint64_t changes =
        changed(a.low, b.low) | changed(a.high, b.high) | changed(a.mean, b.mean) | changed(a.deviation, b.deviation);
    return changes == 0 && a.kind == b.kind && a.whole == b.whole && a.dimension == b.dimension &&
           a.weights == b.weights &&
           std::equal(a.alternatives.begin(), a.alternatives.end(), b.alternatives.begin(), b.alternatives.end(),
                      [](const Value& one, const Value& two) { return is_same(one, two); });
}

// The index of a place that is known, else of a new one.
std::uint32_t place_index(ChoiceBuffer& buffer, const void* text, std::string_view name, const ChoiceDomain& domain) {
    constexpr std::size_t remembered = 16;
    const std::size_t count = buffer.places.size();
    const auto is_at = [&](std::size_t i) {
        const ChoiceBuffer::Place& known = buffer.places[i];
        return known.text == text && known.name == name && is_same(known.domain, domain);
    };
    // Work goes through the same texts over and over: what followed a place last time mostly follows it again.
    std::size_t next = buffer.rows.empty() ? 0 : buffer.rows.back().place + std::size_t{1};
    if (next >= count) next = 0;
    if (next < count && is_at(next)) return static_cast<std::uint32_t>(next);
    for (std::size_t i = count; i > 0 && i + remembered > count; --i) {
        if (is_at(i - 1)) return static_cast<std::uint32_t>(i - 1);
    }
    if (count == 0) buffer.places.reserve(4);  // to move places costs more than to make room for a few
    buffer.places.push_back({text, std::string(name), domain});
    return static_cast<std::uint32_t>(count);
}

}  // namespace

void record(ChoiceBuffer& buffer, const void* text, std::string_view name, const ChoiceDomain& domain, Key key,
            double value, ChoiceSource source) {
    const std::uint32_t place = place_index(buffer, text, name, domain);
    buffer.rows.push_back({key, value, place, source});
}

namespace {

std::uint64_t folded(std::uint64_t hash, double value) {
    return fold(hash, std::bit_cast<std::uint64_t>(value + 0.0));  // 0 and -0 are equal
}

// Equal domains have equal hashes.
std::uint64_t hash_of(const ChoiceDomain& domain) {
    std::uint64_t hash = fold(static_cast<std::uint64_t>(domain.kind), domain.whole ? 1 : 0);
    hash = fold(hash, static_cast<std::uint64_t>(domain.dimension.length_power + 128));
    for (const double value : {domain.low, domain.high, domain.mean, domain.deviation}) hash = folded(hash, value);
    for (const Value& alternative : domain.alternatives) hash = fold(hash, hash_text(to_text(alternative)));
    for (const double weight : domain.weights) hash = folded(hash, weight);
    return hash;
}

}  // namespace

std::uint32_t ChoiceRecorder::name_index(std::string_view name) {
    const auto known = names_.find(name);
    if (known != names_.end()) return known->second;
    const auto index = static_cast<std::uint32_t>(choices.name_table.size());
    choices.name_table.emplace_back(name);
    names_.emplace(name, index);
    return index;
}

std::uint32_t ChoiceRecorder::domain_index(const ChoiceDomain& domain) {
    const std::uint64_t hash = hash_of(domain);
    const auto [begin, end] = domains_.equal_range(hash);
    for (auto known = begin; known != end; ++known) {  // one of them at most is equal
        if (choices.domain_table[known->second] == domain) return known->second;
    }
    const auto index = static_cast<std::uint32_t>(choices.domain_table.size());
    choices.domain_table.push_back(domain);
    domains_.emplace(hash, index);
    return index;
}

std::uint32_t ChoiceRecorder::domain_index(const void* text, const ChoiceDomain& domain) {
    const auto guess = last_domain_of_text_.find(text);
    if (guess != last_domain_of_text_.end() && choices.domain_table[guess->second] == domain) return guess->second;
    return last_domain_of_text_[text] = domain_index(domain);
}

void ChoiceRecorder::append(const ChoiceBuffer& buffer) {
    interned_.assign(buffer.places.size(), {});
    for (const ChoiceBuffer::Row& row : buffer.rows) {
        Interned& place = interned_[row.place];
        if (place.known) continue;
        const ChoiceBuffer::Place& from = buffer.places[row.place];
        place = {name_index(from.name), domain_index(from.text, from.domain), true};
    }
    const std::size_t first = choices.size(), size = first + buffer.rows.size();
    const auto grown = [first, size](auto& column) {
        column.resize(size);
        return column.data() + first;
    };
    Key* key = grown(choices.keys);
    std::uint32_t* name = grown(choices.names);
    double* value = grown(choices.values);
    std::uint32_t* domain = grown(choices.domains);
    ChoiceSource* source = grown(choices.sources);
    for (const ChoiceBuffer::Row& row : buffer.rows) {
        const Interned& place = interned_[row.place];
        *key++ = row.key;
        *name++ = place.name;
        *value++ = row.value;
        *domain++ = place.domain;
        *source++ = row.source;
    }
}

void ChoiceRecorder::append(const Choices& from, std::size_t first, std::size_t end) {
    const auto guess_at = [](Guesses& guesses, std::uint32_t i) -> std::uint32_t& {
        if (i >= guesses.size()) guesses.resize(i + std::size_t{1}, 0);
        return guesses[i];
    };
    for (std::size_t row = first; row < end; ++row) {
        const std::string& name = from.name_table[from.names[row]];
        std::uint32_t& name_guess = guess_at(name_guesses_, from.names[row]);
        if (name_guess >= choices.name_table.size() || choices.name_table[name_guess] != name) {
            name_guess = name_index(name);
        }
        const ChoiceDomain& domain = from.domain_table[from.domains[row]];
        std::uint32_t& domain_guess = guess_at(domain_guesses_, from.domains[row]);
        if (domain_guess >= choices.domain_table.size() || choices.domain_table[domain_guess] != domain) {
            domain_guess = domain_index(domain);
        }
        choices.keys.push_back(from.keys[row]);
        choices.names.push_back(name_guess);
        choices.values.push_back(from.values[row]);
        choices.domains.push_back(domain_guess);
        choices.sources.push_back(from.sources[row]);
    }
}

void Replay::add(Key key, std::string_view name, Value value) {
    values_.insert_or_assign(fold(key.value, hash_text(name)), std::move(value));
}

const Value* Replay::find(Key key, std::string_view name) const {
    const auto found = values_.find(fold(key.value, hash_text(name)));
    return found != values_.end() ? &found->second : nullptr;
}

}  // namespace filigree
