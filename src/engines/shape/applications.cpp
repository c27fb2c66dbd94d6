#include "engines/shape/applications.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "curves/affine.h"
#include "curves/algebra.h"
#include "curves/faces.h"
#include "curves/fingerprint.h"
#include "curves/match_order.h"
#include "curves/maximal.h"
#include "curves/similarity.h"
#include "curves/visual.h"
#include "engines/shape/paths.h"
#include "language/evaluate.h"
#include "language/quantity.h"

namespace filigree::shape {
namespace {

using curves::Element;
using curves::ElementKind;
using curves::Shape;

// The design without what the application covers, where the region is.
bool is_void(const Region& region, const Shape& covered, SeenDesign& design, double tolerance) {
    Shape near = design.within(bounds_of(region));
    std::erase_if(near.elements, [&](const Element& e) { return !reaches_into(e, region, tolerance); });
    if (near.elements.empty()) return true;
    const Shape rest = erased(near, covered, tolerance);
    return std::none_of(rest.elements.begin(), rest.elements.end(),
                        [&](const Element& e) { return reaches_into(e, region, tolerance); });
}

// A region of a rule's plane as an application places it in the design.
Region placed(Region region, const Rule& rule, const Application& at) {
    if (at.corners.empty()) return transformed(region, at.fit.by);
    for (Vec& corner : region.corners) corner = curves::stretched(corner, rule.corners, at.corners);
    return region;
}

bool is_allowed(const Rule& rule, const Application& at, SeenDesign& design, double tolerance) {
    for (const Shape& forbidden : rule.forbidden) {
        const Shape there = placed(forbidden, rule, at, tolerance);
        if (is_part_of(there, design.near(there), tolerance)) return false;
    }
    if (rule.voids.empty()) return true;
    const Shape covered = at.covered.empty() ? placed(rule.left, rule, at, tolerance) : merged(at.covered, tolerance);
    return std::all_of(rule.voids.begin(), rule.voids.end(), [&](const Region& region) {
        return is_void(placed(region, rule, at), covered, design, tolerance);
    });
}

Value number(double value) { return {Quantity{value, 0, false}, {}}; }

// What a rule's condition may ask of a match.
Scope scope_of(const Application& at, std::size_t steps, std::size_t elements, const Settings& settings) {
    Scope scope;
    scope.outer = &settings.globals;
    scope.names["x"] = {Quantity{at.place.x, 1, false}, {}};
    scope.names["y"] = {Quantity{at.place.y, 1, false}, {}};
    scope.names["scale"] = number(at.fit.scale);
    scope.names["angle"] = {Quantity{at.fit.angle_degrees, 0, true}, {}};
    scope.names["mirrored"] = {at.fit.is_reflected, {}};
    scope.names["area"] = {Quantity{at.corners.empty() ? 0 : std::fabs(curves::area_of(at.corners)), 2, false}, {}};
    const auto side = [&](std::size_t i) {
        return at.corners.size() < 3 ? 0 : length(at.corners[i + 1] - at.corners[i]);
    };
    scope.names["first_side"] = {Quantity{side(0), 1, false}, {}};
    scope.names["second_side"] = {Quantity{side(1), 1, false}, {}};
    scope.names["steps"] = number(static_cast<double>(steps));
    scope.names["elements"] = number(static_cast<double>(elements));
    return scope;
}

Result<bool> holds(const Rule& rule, const Application& at, SeenDesign& design, const Surroundings& around) {
    if (rule.condition == nullptr) return true;
    const Scope scope = scope_of(at, design.steps(), design.shape().elements.size(), around.settings);
    Evaluation evaluation;
    evaluation.document = &around.document;
    evaluation.scope = &scope;
    const Result<Value> value = evaluate(*rule.condition, evaluation);
    if (!value) return value.diagnostics();
    return as_flag(*value);
}

// The same match by another map onto the same elements.
curves::Match with_map(curves::Match match, const Transform& by) {
    match.by = by;
    match.is_reflected = determinant(by) < 0;
    match.angle_degrees = curves::angle_of(by);
    return match;
}

// Every face with as many corners, in all ways in which the corners can be named after each other.
void add_faces(const Rule& rule, SeenDesign& design, double tolerance, Applications& found) {
    const std::vector<Vec>& own = rule.corners;
    for (const curves::Face& face : convex_faces(design.shape(), tolerance)) {
        if (face.corners.size() != own.size()) continue;
        const auto count = static_cast<std::uint32_t>(own.size());
        const std::uint32_t variants = rule.options.with_reflections ? 2 * count : count;
        for (std::uint32_t variant = 0; variant < variants; ++variant) {
            Application at;
            at.match = found.matches;
            at.variant = variant;
            for (std::uint32_t i = 0; i < count; ++i) {
                at.corners.push_back(face.corners[(variant < count ? variant + i : variant + 2 * count - i) % count]);
            }
            at.fit.is_reflected = variant >= count;
            for (const Vec corner : face.corners) at.place = at.place + corner * (1.0 / count);
            const Vec side = at.corners[1] - at.corners[0], own_side = own[1] - own[0];
            at.fit.scale = std::sqrt(std::fabs(curves::area_of(face.corners) / curves::area_of(own)));
            at.fit.angle_degrees = curves::angle_of(curves::to_transform({curves::over(side, own_side), {}, false}));
            found.all.push_back(std::move(at));
        }
        ++found.matches;
    }
}

// All applications of one match.
void add_variants(const Rule& rule, const curves::Match& match, bool is_of_family, Applications& found) {
    std::uint32_t variant = 0;
    for (const Transform& symmetry : rule.variants) {
        Application at;
        at.match = found.matches;
        at.variant = variant++;
        at.fit = with_map(match, compose(match.by, symmetry));
        at.place = match.centroid;
        at.is_of_family = is_of_family;
        found.all.push_back(std::move(at));
    }
    ++found.matches;
}

// Of anything that counts and numbers its matches.
template <class Matches>
void add_matches(const Rule& rule, const Matches& matches, Applications& found) {
    found.all.reserve(found.all.size() + matches.size() * rule.variants.size());
    for (std::size_t i = 0; i < matches.size(); ++i) add_variants(rule, matches[i], false, found);
}

void add_families(const Rule& rule, const std::vector<curves::Family>& families, Applications& found) {
    found.families = families;
    for (const curves::Family& family : families) {
        for (const curves::Match& member : family.members) add_variants(rule, member, true, found);
    }
}

}  // namespace

Shape placed(const Shape& shape, const Rule& rule, const Application& at, double tolerance) {
    if (at.corners.empty()) return transformed(shape, at.fit.by);
    const auto moved = [&](Vec p) { return curves::stretched(p, rule.corners, at.corners); };
    std::vector<Element> elements;
    for (Element e : shape.elements) {
        if (e.kind == ElementKind::arc) {
            // As its axes are moved: an ellipse again, which it comes near.
            const Vec centre = moved(e.at[0]), u = e.at[1], v = e.at[2];
            const Vec u_moved = moved(e.at[0] + u) - centre, v_moved = moved(e.at[0] + v) - centre;
            const Vec x = (u_moved * v.y - v_moved * u.y) * (1 / cross(u, v));
            const Vec y = (v_moved * u.x - u_moved * v.x) * (1 / cross(u, v));
            const Vec origin = centre - x * e.at[0].x - y * e.at[0].y;
            e = transformed(e, {x.x, x.y, y.x, y.y, origin.x, origin.y});
        } else {
            for (std::size_t i = 0; i < curves::vector_count(e.kind); ++i) e.at[i] = moved(e.at[i]);
        }
        elements.push_back(e);
    }
    return maximal(std::move(elements), tolerance);
}

Result<Applications> applications_of(const Grammar& grammar, std::uint32_t number, SeenDesign& design,
                                     const Surroundings& around, const Job& job) {
    const Rule& rule = grammar.rules[number];
    Applications found;
    if (rule.by_corners) {
        add_faces(rule, design, grammar.tolerance, found);
    } else {
        curves::MatchOptions options = rule.options;
        options.job = job;
        if (options.group == curves::MatchGroup::affine) {
            const curves::Matches matches = find_affine_matches(rule.left, design.index(), options).matches;
            add_matches(rule, matches.found, found);
            add_families(rule, matches.families, found);
            found.near_misses = matches.near_misses.size();
            found.is_complete = matches.is_complete;
        } else {
            const curves::KeptMatches& matches = design.matches_of(number, job);
            add_matches(rule, matches.found(), found);
            add_families(rule, matches.families(), found);
            found.near_misses = matches.near_misses().size();
            found.is_complete = matches.is_complete();
        }
        if (is_cancelled(job)) return cancelled_diagnostic();
        if (options.visual_tolerance > 0) {
            for (const curves::Match& match : find_look_alikes(rule.left, design.index(), options).found) {
                const std::size_t first = found.all.size();
                add_variants(rule, match, false, found);
                const auto covered = covered_pieces(rule.left, design.index(), match, options.visual_tolerance);
                for (std::size_t i = first; i < found.all.size(); ++i) found.all[i].covered = covered;
            }
        }
    }
    for (Application& at : found.all) at.rule = number;
    if (rule.forbidden.empty() && rule.voids.empty() && rule.condition == nullptr) return found;
    std::vector<Application> kept;
    std::vector<std::uint32_t> numbers(found.matches, UINT32_MAX);
    std::uint32_t matches = 0;
    for (Application& at : found.all) {
        if (is_cancelled(job)) return cancelled_diagnostic();
        if (!is_allowed(rule, at, design, grammar.tolerance)) continue;
        const Result<bool> wanted = holds(rule, at, design, around);
        if (!wanted) return wanted.diagnostics();
        if (!*wanted) continue;
        std::uint32_t& renumbered = numbers[at.match];
        if (renumbered == UINT32_MAX) renumbered = matches++;
        at.match = renumbered;
        kept.push_back(std::move(at));
    }
    found.all = std::move(kept);
    found.matches = matches;
    return found;
}

double breadth_of(const Rule& rule, const Application& at) {
    return diagonal_of(bounds_of(rule.left.elements)) * at.fit.scale;
}

Scope example_scope(const Settings& settings) { return scope_of({}, 0, 1, settings); }

Result<Application> application_at(const Grammar& grammar, const Applications& found, const ApplyAt& wanted,
                                   const Surroundings& around) {
    const Rule& rule = grammar.rules[wanted.rule];
    const auto unit_text = [&](Vec place) { return place_text(place, around.document); };
    if (found.all.empty()) {
        return error("shape.no-match", "'" + rule.name + "' applies nowhere in this design", wanted.span,
                     {"`filigree match DOC --rule " + rule.name + " --explain` says what is missing"});
    }
    const auto distance = [&](const Application& at) { return length(at.place - wanted.place); };
    const Application* nearest = &found.all[0];
    for (const Application& at : found.all) {
        if (distance(at) < distance(*nearest)) nearest = &at;
    }
    const double breadth = breadth_of(rule, *nearest);
    // Places are written to a thousandth of a px, and a point has no breadth.
    if (distance(*nearest) > std::max(0.5 * breadth, 0.002)) {
        return error("shape.no-match-there", "'" + rule.name + "' does not apply at " + unit_text(wanted.place),
                     wanted.span, {"the nearest place where it does is " + unit_text(nearest->place)});
    }
    // Places that a person would call one, then what else was said of it; what was not said is as the rule stands.
    const double near = std::max(0.01 * breadth, 0.002), same = distance(*nearest) + near;
    if (nearest->is_of_family && distance(*nearest) > near) {
        return error(
            "shape.infinite-matches",
            "'" + rule.name + "' applies in infinitely many ways here, but is told none at " + unit_text(wanted.place),
            wanted.span, {"the nearest of those that can be told is at " + unit_text(nearest->place)});
    }
    const auto turned = [&](const Application& at) {
        const double off = std::fabs(std::remainder(at.fit.angle_degrees - wanted.angle.value_or(0), 360.0));
        return wanted.angle || off > 1e-6 ? off : 0;
    };
    const auto rank = [&](const Application& at) {
        const bool wrong_hand = at.fit.is_reflected != wanted.is_mirrored;
        const double scaled = wanted.scale ? std::fabs(at.fit.scale / *wanted.scale - 1) : 0;
        return std::tuple(wrong_hand, std::round(scaled * 1e6), std::round(turned(at) * 1e6), distance(at));
    };
    const Application* best = nullptr;
    for (const Application& at : found.all) {
        if (distance(at) > same) continue;
        if (best == nullptr || rank(at) < rank(*best)) best = &at;
    }
    if (wanted.angle && turned(*best) > 1) {
        return error("shape.no-match-there",
                     "at " + unit_text(best->place) + " '" + rule.name + "' applies at no angle of " +
                         to_text(*wanted.angle) + " degrees",
                     wanted.span, {"the nearest angle is " + to_text(std::round(best->fit.angle_degrees * 1e6) / 1e6)});
    }
    if (wanted.scale && std::fabs(best->fit.scale / *wanted.scale - 1) > 0.01) {
        return error(
            "shape.no-match-there",
            "at " + unit_text(best->place) + " '" + rule.name + "' applies at no scale of " + to_text(*wanted.scale),
            wanted.span, {"the nearest scale is " + to_text(std::round(best->fit.scale * 1e6) / 1e6)});
    }
    if (wanted.is_mirrored && !best->fit.is_reflected) {
        return error("shape.no-match-there", "at " + unit_text(best->place) + " '" + rule.name + "' is not mirrored",
                     wanted.span);
    }
    return *best;
}

std::vector<Application> orbit_of(const Application& application, const Applications& among, const Grammar& grammar,
                                  const Shape& design) {
    const Rule& rule = grammar.rules[application.rule];
    const double tolerance = grammar.tolerance, slack = std::max(8 * tolerance, rule.options.visual_tolerance);
    const Shape left = placed(rule.left, rule, application, tolerance);
    const Shape right = placed(rule.right, rule, application, tolerance);
    std::vector<Application> orbit = {application};
    std::vector<Shape> taken = {left};
    for (const Transform& by : maps_onto_itself(design, tolerance)) {
        const Shape image = transformed(left, by), put = transformed(right, by);
        const auto is_image = [&](const Shape& other) { return are_equal(other, image, slack); };
        if (std::any_of(taken.begin(), taken.end(), is_image)) continue;
        const Vec place = apply(by, application.place);
        for (const Application& other : among.all) {
            if (length(other.place - place) > 4 * slack) continue;
            if (!is_image(placed(rule.left, rule, other, tolerance))) continue;
            if (!are_equal(placed(rule.right, rule, other, tolerance), put, slack)) continue;
            orbit.push_back(other);
            taken.push_back(image);
            break;
        }
    }
    return orbit;
}

}  // namespace filigree::shape
