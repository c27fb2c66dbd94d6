#include "engines/shape/drawn_groups.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <utility>

namespace filigree::shape {
namespace {

class RuleFinder {
public:
    RuleFinder(const std::vector<SvgGroup>& groups, Diagnostics& diagnostics)
        : groups_(groups), inside_(groups.size()), has_named_sides_(groups.size(), false), diagnostics_(diagnostics) {
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            if (const auto parent = groups_[g].parent) inside_[*parent].push_back(g);
        }
        for (std::size_t g = groups_.size(); g-- > 0;) {
            const DrawnRole role = role_of(groups_[g]);
            const bool is_side = role == DrawnRole::left || role == DrawnRole::right;
            if (is_side || (role == DrawnRole::plain && has_named_sides_[g])) {
                if (const auto parent = groups_[g].parent) has_named_sides_[*parent] = true;
            }
        }
    }

    std::vector<RuleGroups> find() && {
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            if (!groups_[g].parent) look_at(g);
        }
        return std::move(rules_);
    }

private:
    std::vector<std::size_t> inside_of(std::size_t g, DrawnRole role) const {
        std::vector<std::size_t> found;
        std::copy_if(inside_[g].begin(), inside_[g].end(), std::back_inserter(found),
                     [&](std::size_t i) { return role_of(groups_[i]) == role; });
        return found;
    }

    void look_at(std::size_t g) {
        const DrawnRole role = role_of(groups_[g]);
        if (role != DrawnRole::plain && role != DrawnRole::left && role != DrawnRole::right) return;
        const auto left = inside_of(g, DrawnRole::left), right = inside_of(g, DrawnRole::right);
        if (!left.empty() || !right.empty()) return take_named(g, left, right);
        if (groups_[g].is_layer || has_named_sides_[g]) {
            for (const std::size_t i : inside_[g]) look_at(i);
            return;
        }
        const auto plain = inside_of(g, DrawnRole::plain);
        if (plain.size() == 2) {
            rules_.push_back({g, plain[0], plain[1]});
        } else if (plain.size() == 1 && inside_[plain[0]].size() > 1) {
            look_at(plain[0]);  // a group around one rule alone
        } else if (!plain.empty()) {
            diagnostics_.push_back(warning("shape.no-sides",
                                           described(g) + " holds " + std::to_string(plain.size()) +
                                               (plain.size() == 1 ? " group" : " groups") +
                                               ", none called 'left' or 'right', and is taken for no rule",
                                           groups_[g].span));
        }
    }

    void take_named(std::size_t g, const std::vector<std::size_t>& left, const std::vector<std::size_t>& right) {
        for (const auto& [sides, side] : {std::pair(&left, "left"), std::pair(&right, "right")}) {
            if (sides->empty()) {
                diagnostics_.push_back(error("shape.one-side", described(g) + " has no group '" + side + "'",
                                             groups_[g].span, {"a rule that erases has an empty one"}));
            } else if (sides->size() > 1) {
                diagnostics_.push_back(error("shape.side-twice", described(g) + " has two groups '" + side + "'",
                                             groups_[(*sides)[1]].span));
            }
        }
        if (left.size() == 1 && right.size() == 1) rules_.push_back({g, left[0], right[0]});
    }

    std::string described(std::size_t g) const {
        const std::string name = name_of(groups_[g]);
        return name.empty() ? "a group without a name" : "the group '" + name + "'";
    }

    const std::vector<SvgGroup>& groups_;
    std::vector<std::vector<std::size_t>> inside_;  // the groups directly in each
    std::vector<bool> has_named_sides_;             // at any depth, but not in notes and the like
    std::vector<RuleGroups> rules_;
    Diagnostics& diagnostics_;
};

}  // namespace

DrawnRole role_said(std::string_view name) {
    std::string word;
    for (const char c : name) word += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    word.erase(0, word.find_first_not_of(" \t\n\r"));
    if (word.starts_with("unless")) return DrawnRole::condition;
    if (word.starts_with("void")) return DrawnRole::region;
    word.erase(word.find_last_not_of(" \t\n\r-_0123456789") + 1);
    const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
        return std::find(names.begin(), names.end(), word) != names.end();
    };
    if (is_one_of({"left", "a", "alpha", "\u03b1", "lhs"})) return DrawnRole::left;
    if (is_one_of({"right", "b", "beta", "\u03b2", "rhs"})) return DrawnRole::right;
    if (word == "origin") return DrawnRole::origin;
    if (is_one_of({"notes", "note"})) return DrawnRole::notes;
    return DrawnRole::plain;
}

DrawnRole role_within(DrawnRole around, DrawnRole own) {
    if (around == DrawnRole::notes || around == DrawnRole::origin) return around;
    if (own == DrawnRole::notes || own == DrawnRole::origin) return own;
    if (around == DrawnRole::condition || around == DrawnRole::region) return around;
    return own == DrawnRole::condition || own == DrawnRole::region ? own : DrawnRole::plain;
}

std::string name_of(const SvgGroup& group) {
    std::string name = group.label.empty() ? group.id : group.label;
    name.erase(0, name.find_first_not_of(" \t\n\r"));
    name.erase(name.find_last_not_of(" \t\n\r") + 1);
    return name;
}

std::vector<RuleGroups> find_rules(const std::vector<SvgGroup>& groups, Diagnostics& diagnostics) {
    return RuleFinder(groups, diagnostics).find();
}

}  // namespace filigree::shape
