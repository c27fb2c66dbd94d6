#include "session/list_matches.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "curves/explain.h"
#include "language/edit_text.h"
#include "language/quantity.h"

namespace filigree {
namespace {

using Json = nlohmann::ordered_json;
using shape::Application;
using shape::Applications;

// What people read and write back: in the unit of the document, to a thousandth of a px, and of the breadth of what
// lies there.
std::string place_text(Vec place, double breadth, const OpenedDocument& opened) {
    const Unit unit = unit_of(opened.document);
    double per_px = 1000;
    while (per_px * breadth < 1e3 && per_px < 1e12 && breadth > 0) per_px *= 10;
    const auto in_unit = [&](double px) {
        const double rounded = std::round(px * per_px) / per_px;
        const double value = std::round(from_px(rounded, unit) * (10 * per_px)) / (10 * per_px);
        return value == 0 ? 0 : value;
    };
    return "(" + to_text(in_unit(place.x)) + ", " + to_text(in_unit(place.y)) + ")";
}
std::string place_text(const Application& at, const shape::Rule& rule, const OpenedDocument& opened) {
    return place_text(at.place, breadth_of(rule, at), opened);
}
double shortened(double value) {
    const double rounded = std::round(value * 1e6) / 1e6;
    return rounded == 0 ? 0 : rounded;
}
double shortened_angle(double degrees) { return std::fmod(shortened(degrees), 360); }

const shape::Rule& rule_of(const CheckedDocument& checked, std::uint32_t rule) { return checked.design->rules[rule]; }

std::size_t count_of(const FoundMatches& found) {
    std::size_t count = 0;
    for (const Applications& one : found.of_rules) count += one.all.size();
    return count;
}

Json json_of(const curves::Element& e) {
    Json json;
    json["kind"] = curves::name_of(e.kind);
    for (std::size_t i = 0; i < curves::vector_count(e.kind); ++i) json["points"].push_back({e.at[i].x, e.at[i].y});
    if (e.kind == curves::ElementKind::arc) {
        json["from"] = e.from;
        json["to"] = e.to;
    }
    if (e.weight != 1) json["weight"] = e.weight;
    return json;
}

}  // namespace

Result<FoundMatches> find_matches(const OpenedDocument& opened, const CheckedDocument& checked,
                                  const MatchQuestion& question, const Job& job) {
    const shape::Grammar& grammar = *checked.design;
    FoundMatches found;
    for (std::uint32_t r = 0; r < grammar.rules.size(); ++r) {
        if (question.rule.empty() || grammar.rules[r].name == question.rule) found.rules.push_back(r);
    }
    if (grammar.rules.empty()) return fault(Fault::usage, "match.no-rules", "the document has no rules");
    if (found.rules.empty()) {
        std::vector<std::string_view> names;
        for (const shape::Rule& rule : grammar.rules) names.push_back(rule.name);
        Diagnostic unknown = fault(Fault::usage, "match.unknown-rule", "there is no rule '" + question.rule + "'");
        unknown.hints = did_you_mean(question.rule, names);
        if (unknown.hints.empty() && !names.empty()) unknown.hints = {"one of them is '" + std::string(names[0]) + "'"};
        return unknown;
    }
    Result<shape::Derivation> derivation =
        derive_design(opened, checked, {question.steps, {}, question.by_hand_alone}, job);
    if (!derivation) return derivation.diagnostics();
    found.derivation = std::move(*derivation);
    shape::SeenDesign seen = seen_design(grammar, found.derivation);
    for (const std::uint32_t rule : found.rules) {
        Result<Applications> here = applications_of(grammar, rule, seen, surroundings_of(opened, checked), job);
        if (!here) return here.diagnostics();
        found.of_rules.push_back(std::move(*here));
    }
    return {std::move(found), derivation.diagnostics()};
}

std::string apply_text(const OpenedDocument& opened, const CheckedDocument& checked, const Applications& among,
                       const Application& at, bool is_orbit) {
    std::string text =
        "apply " + rule_of(checked, at.rule).name + " at " + place_text(at, rule_of(checked, at.rule), opened);
    // What sets it apart from others at the same place, and from those that may be meant by it.
    const double same = std::max(0.5, 0.02 * breadth_of(rule_of(checked, at.rule), at));
    bool other_angle = false, other_scale = false;
    for (const Application& other : among.all) {
        if (length(other.place - at.place) > same || other.fit.is_reflected != at.fit.is_reflected) continue;
        other_angle =
            other_angle || std::fabs(std::remainder(other.fit.angle_degrees - at.fit.angle_degrees, 360)) > 1e-3;
        other_scale = other_scale || std::fabs(other.fit.scale / at.fit.scale - 1) > 1e-3;
    }
    if (other_angle || at.fit.is_reflected) text += " angle " + to_text(shortened_angle(at.fit.angle_degrees));
    if (other_scale) text += " scale " + to_text(shortened(at.fit.scale));
    if (at.fit.is_reflected) text += " mirrored";
    if (is_orbit) text += " orbit";
    return text;
}

std::string matches_text(const OpenedDocument& opened, const CheckedDocument& checked, const FoundMatches& found) {
    std::string text;
    std::size_t number = 0;
    for (std::size_t i = 0; i < found.rules.size(); ++i) {
        const shape::Rule& rule = rule_of(checked, found.rules[i]);
        const Applications& here = found.of_rules[i];
        text += rule.name + ": " + std::to_string(here.matches) + (here.matches == 1 ? " match" : " matches");
        if (here.all.size() != here.matches) text += ", " + std::to_string(here.all.size()) + " applications";
        if (!here.families.empty()) {
            text += ", in infinitely many ways; ends, middles and the like are shown";
        }
        if (here.near_misses > 0) {
            text += ", " + std::to_string(here.near_misses) + (here.near_misses == 1 ? " near miss" : " near misses") +
                    " (within ten tolerances)";
        }
        if (!here.is_complete) text += ", and more, which were not looked for";
        text += "\n";
        for (const Application& at : here.all) {
            text += "  " + std::to_string(++number) + "  at " + place_text(at, rule, opened);
            if (const double angle = shortened_angle(at.fit.angle_degrees); angle != 0)
                text += "  angle " + to_text(angle);
            if (const double scale = shortened(at.fit.scale); scale != 1) text += "  scale " + to_text(scale);
            if (at.fit.is_reflected) text += "  mirrored";
            if (at.variant > 0) text += "  variant " + std::to_string(at.variant + 1);
            if (at.is_of_family) text += "  one of infinitely many";
            if (at.fit.is_visual) text += "  looks alike only";
            if (at.fit.is_ambiguous) text += "  ambiguous";
            text += "\n";
        }
    }
    return text;
}

std::string matches_json(const OpenedDocument& opened, const CheckedDocument& checked, const FoundMatches& found) {
    Json json;
    json["document"] = opened.name;
    json["state"] = found.derivation.state;
    json["tolerance"] = checked.design->tolerance;
    json["elements"] = found.derivation.design.elements.size();
    json["rules"] = Json::array();
    std::size_t number = 0;
    for (std::size_t i = 0; i < found.rules.size(); ++i) {
        const shape::Rule& rule = rule_of(checked, found.rules[i]);
        const Applications& here = found.of_rules[i];
        Json one;
        one["name"] = rule.name;
        one["matches"] = here.matches;
        one["families"] = here.families.size();
        one["near_misses"] = here.near_misses;
        one["complete"] = here.is_complete;
        one["applications"] = Json::array();
        for (const Application& at : here.all) {
            const Transform& t = at.fit.by;
            Json application;
            application["number"] = ++number;
            application["match"] = at.match + 1;
            application["variant"] = at.variant + 1;
            application["at"] = {at.place.x, at.place.y};
            application["angle"] = at.fit.angle_degrees;
            application["scale"] = at.fit.scale;
            application["reflected"] = at.fit.is_reflected;
            if (at.corners.empty()) {
                application["transform"] = {t.a, t.b, t.c, t.d, t.e, t.f};
            } else {
                for (const Vec corner : at.corners) application["corners"].push_back({corner.x, corner.y});
            }
            application["misfit"] = at.fit.misfit;
            application["ambiguous"] = at.fit.is_ambiguous;
            application["visual"] = at.fit.is_visual;
            application["family"] = at.is_of_family;
            application["elements"] = at.fit.carriers;
            application["apply"] = apply_text(opened, checked, here, at, false);
            one["applications"].push_back(std::move(application));
        }
        json["rules"].push_back(std::move(one));
    }
    json["design"] = Json::array();
    for (const curves::Element& e : found.derivation.design.elements) json["design"].push_back(json_of(e));
    return json.dump(1) + "\n";
}

Result<std::string> explain_match(const OpenedDocument& opened, const CheckedDocument& checked,
                                  const MatchQuestion& question, const FoundMatches& found, bool as_json) {
    if (question.rule.empty()) return fault(Fault::usage, "match.no-rule", "--explain wants one rule: --rule NAME");
    const shape::Rule& rule = rule_of(checked, found.rules[0]);
    if (rule.by_corners) {
        return fault(Fault::usage, "match.not-explained",
                     "'" + rule.name + "' matches by corners: it wants a void convex polygon with as many corners");
    }
    const curves::MatchIndex index(found.derivation.design, checked.design->tolerance);
    const curves::Explanation why = curves::explain(rule.left, index, rule.options, question.at);
    const std::vector<std::string> sentences = text_of(why, px_per(unit_of(opened.document)));
    const std::string fitting = std::to_string(why.fitting) + " of " + std::to_string(why.findings.size());
    if (as_json) {
        Json json;
        json["rule"] = rule.name;
        json["at"] = {why.centroid.x, why.centroid.y};
        json["angle"] = why.angle_degrees;
        json["scale"] = why.scale;
        json["transform"] = {why.by.a, why.by.b, why.by.c, why.by.d, why.by.e, why.by.f};
        json["match"] = why.is_match();
        json["fitting"] = why.fitting;
        json["elements"] = why.findings.size();
        json["missing"] = sentences;
        return json.dump(1) + "\n";
    }
    const double breadth = diagonal_of(bounds_of(rule.left.elements)) * why.scale;
    std::string text = rule.name + " comes nearest at " + place_text(why.centroid, breadth, opened) + ", angle " +
                       to_text(shortened_angle(why.angle_degrees)) + (determinant(why.by) < 0 ? " mirrored" : "") +
                       ", scale " + to_text(shortened(why.scale)) + ": " + fitting + " elements fit\n";
    for (const std::string& sentence : sentences) text += "  " + sentence + "\n";
    if (!why.is_match()) return text;
    // What stands around it decides then.
    const auto is_there = [&](const Application& at) { return length(at.place - why.centroid) < 1e-3; };
    const auto& all = found.of_rules[0].all;
    const bool applies = std::any_of(all.begin(), all.end(), is_there);
    if (applies) return text + "  it applies there\n";
    const bool has_conditions = !rule.forbidden.empty() || !rule.voids.empty() || rule.condition != nullptr;
    return text + (has_conditions ? "  its conditions (unless, when) do not hold there\n"
                                  : "  too little of it is fixed for a match\n");
}

Result<std::string> with_step(const OpenedDocument& opened, const CheckedDocument& checked, const FoundMatches& found,
                              std::uint64_t number, bool is_orbit) {
    const std::size_t count = count_of(found);
    if (number < 1 || number > count) {
        return fault(Fault::usage, "step.no-match",
                     count == 0 ? "the rule applies nowhere in this design"
                                : "there is no match " + std::to_string(number) + ": they are numbered from 1 to " +
                                      std::to_string(count));
    }
    std::uint64_t before = 0;
    for (const Applications& here : found.of_rules) {
        if (number > before + here.all.size()) {
            before += here.all.size();
            continue;
        }
        const Application& at = here.all[number - before - 1];
        return with_last_line(opened.document.text(), apply_text(opened, checked, here, at, is_orbit));
    }
    return error("step.no-match", "there is no such match");
}

}  // namespace filigree
