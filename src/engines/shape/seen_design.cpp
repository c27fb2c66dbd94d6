#include "engines/shape/seen_design.h"

#include <algorithm>

namespace filigree::shape {

SeenDesign::SeenDesign(const Grammar& grammar, const curves::Shape& design, std::uint32_t steps)
    : grammar_(&grammar), design_(&design) {
    start_anew(steps);
}

void SeenDesign::follow(const curves::Change& change) {
    ++steps_;
    if (!index_) return;
    const curves::MatchIndex::Change slots = index_->update(change.removed, change.added);
    for (OfRule& rule : of_rules_) {
        if (!rule.kept) continue;
        rule.since.removed.insert(rule.since.removed.end(), slots.removed.begin(), slots.removed.end());
        rule.since.added.insert(rule.since.added.end(), slots.added.begin(), slots.added.end());
    }
}

void SeenDesign::start_anew(std::uint32_t steps) {
    index_.reset();
    steps_ = steps;
    of_rules_.clear();
    of_rules_.resize(grammar_->rules.size());
}

const curves::MatchIndex& SeenDesign::index() {
    if (!index_) index_.emplace(*design_, grammar_->tolerance);
    return *index_;
}

curves::Shape SeenDesign::on(std::vector<std::uint32_t> slots) {
    std::sort(slots.begin(), slots.end());
    slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
    curves::Shape shape;
    for (const std::uint32_t slot : slots) shape.elements.push_back(index().element(slot));
    std::sort(shape.elements.begin(), shape.elements.end(), curves::comes_before);
    return shape;
}

curves::Shape SeenDesign::near(const curves::Shape& shape) {
    std::vector<std::uint32_t> slots;
    for (const curves::Element& e : shape.elements) {
        const std::vector<std::uint32_t> own = index().grid().found_along(e, 10 * grammar_->tolerance);
        slots.insert(slots.end(), own.begin(), own.end());
    }
    return on(std::move(slots));
}

curves::Shape SeenDesign::within(const curves::Bounds& box) {
    std::vector<std::uint32_t> slots;
    const Vec size = box.max - box.min;
    index().grid().visit_near((box.min + box.max) * 0.5, 0.5 * std::max(size.x, size.y),
                              [&](std::uint32_t slot) { slots.push_back(slot); });
    return on(std::move(slots));
}

const curves::KeptMatches& SeenDesign::matches_of(std::uint32_t number, const Job& job) {
    OfRule& rule = of_rules_[number];
    if (!rule.kept) {
        curves::MatchOptions options = grammar_->rules[number].options;
        options.job = job;
        rule.kept.emplace(grammar_->rules[number].left, index(), options);
    } else if (!rule.since.removed.empty() || !rule.since.added.empty()) {
        rule.kept->update(index(), rule.since);
        rule.since = {};
    }
    return *rule.kept;
}

}  // namespace filigree::shape
