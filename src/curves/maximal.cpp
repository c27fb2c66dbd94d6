#include "curves/maximal.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "curves/along.h"
#include "curves/end_index.h"
#include "curves/overlap.h"

namespace filigree::curves {
namespace {

void put_in_order(std::vector<Element>& elements) {
    std::sort(elements.begin(), elements.end(), comes_before);
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
}

// Joins elements of equal weight, two at a time: in each round every element joins one other at most, so that those
// that come together are of like length, and a curve of many pieces is done after few rounds.
class Joining {
public:
    Joining(std::vector<Element>& elements, double tolerance)
        : elements_(elements), tolerance_(tolerance), index_(elements), slots_(elements.size()) {
        std::iota(slots_.begin(), slots_.end(), 0U);
        joined_in_.assign(elements.size(), 0);
        tried_by_.assign(elements.size(), 0);
    }

    void run() {
        std::vector<std::uint32_t> active = living();
        // What is new may meet what is old, and in the end nobody may meet anybody.
        for (bool is_all = true;;) {
            const std::vector<std::uint32_t> next = joined_round(active);
            if (next.empty() && is_all) break;
            is_all = next.empty();
            active = is_all ? living() : next;
        }
        const std::vector<std::uint32_t> left = living();
        for (std::uint32_t i = 0; i < left.size(); ++i) elements_[i] = elements_[left[i]];
        elements_.resize(left.size());
    }

private:
    // The slot in which an element is now.
    std::uint32_t slot_of(std::uint32_t i) {
        while (slots_[i] != i) i = slots_[i] = slots_[slots_[i]];
        return i;
    }

    std::vector<std::uint32_t> living() {
        std::vector<std::uint32_t> all;
        for (std::uint32_t i = 0; i < slots_.size(); ++i) {
            if (slots_[i] == i) all.push_back(i);
        }
        return all;
    }

    // The elements that the next round has to look at.
    std::vector<std::uint32_t> joined_round(const std::vector<std::uint32_t>& active) {
        ++round_;
        std::vector<std::uint32_t> next;
        for (const std::uint32_t i : active) {
            if (slots_[i] != i || joined_in_[i] == round_) continue;
            ++try_;
            bool is_waiting = false;
            std::uint32_t partner = i;
            std::optional<Element> whole;
            const Element& e = elements_[i];
            // Ends of arcs are where their angles say, so a little farther than their points.
            index_.any(e, 2 * tolerance_, [&](std::uint32_t end) {
                partner = slot_of(end);
                const Element& other = elements_[partner];
                if (partner == i || other.kind != e.kind || other.layer != e.layer || other.weight != e.weight) {
                    return false;
                }
                if (tried_by_[partner] == try_) return false;
                tried_by_[partner] = try_;
                if (joined_in_[partner] == round_) {
                    is_waiting = true;
                    return false;
                }
                whole = joined(e, other, tolerance_);
                return whole.has_value();
            });
            if (whole) {
                const std::uint32_t kept = std::min(i, partner);
                slots_[std::max(i, partner)] = kept;
                elements_[kept] = *whole;
                joined_in_[kept] = round_;
                next.push_back(kept);
            } else if (is_waiting) {
                next.push_back(i);
            }
        }
        std::sort(next.begin(), next.end());
        // One that waited may have been joined by a later one.
        next.erase(std::unique(next.begin(), next.end()), next.end());
        std::erase_if(next, [&](std::uint32_t i) { return slots_[i] != i; });
        return next;
    }

    std::vector<Element>& elements_;
    double tolerance_;
    EndIndex index_;
    std::vector<std::uint32_t> slots_, joined_in_;
    std::vector<std::uint64_t> tried_by_;
    std::uint32_t round_ = 0;
    std::uint64_t try_ = 0;
};

// Cuts off whatever lies under something heavier; whether anything was cut.
bool cut_lighter(std::vector<Element>& elements, double tolerance) {
    const bool has_one_weight = std::all_of(elements.begin(), elements.end(),
                                            [&](const Element& e) { return e.weight == elements.front().weight; });
    if (has_one_weight) return false;
    std::vector<std::vector<Stretch>> hidden(elements.size());
    bool is_any = false;
    for (const auto& [light, heavy] : pairs_near(elements, elements, 2 * tolerance)) {
        if (!(elements[light].weight < elements[heavy].weight)) continue;
        const auto stretches = covered(elements[light], elements[heavy], tolerance);
        for (const Stretch& stretch : stretches.span()) {
            hidden[light].push_back(stretch);
            is_any = true;
        }
    }
    if (!is_any) return false;
    std::vector<Element> seen;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        for (Element& rest : uncovered(elements[i], std::move(hidden[i]), tolerance)) seen.push_back(rest);
    }
    elements = std::move(seen);
    return true;
}

void note_near_decisions(const std::vector<Element>& elements, double tolerance, Ambiguities& ambiguities) {
    for (const auto& [i, j] : pairs_near(elements, elements, doubtful * tolerance)) {
        if (i < j) note_nearly_joined(elements[i], elements[j], tolerance, ambiguities);
    }
}

// How far a curve lies off the simpler one that it nearly is.
double off_form(const Element& e, const Element& form) {
    double most = 0;
    const Interval on = interval_of(e), other = interval_of(form);
    for (int i = 1; i < 16; ++i) {
        const Vec p = point_at(e, on.from + (on.to - on.from) * i / 16);
        const double guess = other.from + (other.to - other.from) * i / 16;
        most = std::max(most, length(point_at(form, parameter_near(form, p, guess)) - p));
    }
    return most;
}

void merge(std::vector<Element>& elements, double tolerance) {
    do {
        put_in_order(elements);
        Joining(elements, tolerance).run();
    } while (cut_lighter(elements, tolerance));
    put_in_order(elements);
}

}  // namespace

Shape merged(std::vector<Element> elements, double tolerance, Ambiguities* ambiguities) {
    merge(elements, tolerance);
    if (ambiguities != nullptr) note_near_decisions(elements, tolerance, *ambiguities);
    return {std::move(elements)};
}

Shape maximal(std::vector<Element> elements, double tolerance, Ambiguities* ambiguities) {
    std::vector<Element> forms;
    for (const Element& e : elements) {
        if (const auto form = own_form(e, tolerance)) forms.push_back(*form);
    }
    // What is simpler as a whole may go on along others of its new kind.
    for (bool is_settled = false; !is_settled;) {
        merge(forms, tolerance);
        is_settled = true;
        std::vector<Element> simpler;
        for (const Element& e : forms) {
            const auto form = normal_form(e, tolerance);
            if (form != e) is_settled = false;
            if (form) simpler.push_back(*form);
        }
        forms = std::move(simpler);
    }
    if (ambiguities != nullptr) {
        note_near_decisions(forms, tolerance, *ambiguities);
        for (const Element& e : forms) {
            const auto form = normal_form(e, doubtful * tolerance);
            if (!form || form->kind == e.kind) continue;
            const Interval on = interval_of(e);
            const Vec middle = point_at(e, 0.5 * (on.from + on.to));
            note(ambiguities, Doubt::flatness, middle, off_form(e, *form), tolerance);
        }
    }
    return {std::move(forms)};
}

}  // namespace filigree::curves
