#include "engines/shape/applications.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/number_text.h"
#include "curves/affine.h"
#include "curves/algebra.h"
#include "curves/faces.h"
#include "curves/maximal.h"
#include "curves/symmetry.h"
#include "curves/visual.h"
#include "language/evaluate.h"
#include "language/quantity.h"

namespace filigree::shape {
namespace {

using curves::Element;
using curves::ElementKind;
using curves::Shape;

// The design without what the application covers, where the region is.
bool is_void(const Region& region, const Shape& covered, const Shape& design, double tolerance) {
    const curves::Bounds box = bounds_of(region);
    Shape near;
    for (const Element& e : design.elements) {
        const curves::Bounds own = bounds_of(e);
        if (own.max.x < box.min.x || own.min.x > box.max.x || own.max.y < box.min.y || own.min.y > box.max.y) continue;
        if (reaches_into(e, region, tolerance)) near.elements.push_back(e);
    }
    if (near.elements.empty()) return true;
    const Shape rest = erased(near, covered, tolerance);
    return std::none_of(rest.elements.begin(), rest.elements.end(),
                        [&](const Element& e) { return reaches_into(e, region, tolerance); });
}

bool is_allowed(const Rule& rule, const Application& at, const SeenDesign& design, double tolerance) {
    for (const Shape& forbidden : rule.forbidden) {
        if (is_part_of(placed(forbidden, rule, at, tolerance), design.shape(), tolerance)) return false;
    }
    if (rule.voids.empty()) return true;
    const Shape covered = placed(rule.left, rule, at, tolerance);
    return std::all_of(rule.voids.begin(), rule.voids.end(), [&](const Region& region) {
        return is_void(transformed(region, at.fit.by), covered, design.shape(), tolerance);
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

Result<bool> holds(const Rule& rule, const Application& at, const SeenDesign& design, const Surroundings& around) {
    if (rule.condition == nullptr) return true;
    const Scope scope = scope_of(at, design.steps(), design.shape().elements.size(), around.settings);
    Evaluation evaluation;
    evaluation.document = &around.document;
    evaluation.scope = &scope;
    const Result<Value> value = evaluate(*rule.condition, evaluation);
    if (!value) return value.diagnostics();
    return as_flag(*value);
}

double degrees_of(Vec way) {
    const double degrees = elementary::atan2(way.y, way.x) * (180 / elementary::pi);
    return degrees < 0 ? degrees + 360 : degrees;
}

// The same match by another map onto the same elements.
curves::Match with_map(curves::Match match, const Transform& by) {
    match.by = by;
    match.is_reflected = determinant(by) < 0;
    match.angle_degrees = degrees_of({by.a, by.b});
    return match;
}

// The corners of a left side that is one polygon, in the order of a face; empty where it is none.
std::vector<Vec> corners_of(const Shape& left, double tolerance) {
    const std::vector<curves::Face> faces = convex_faces(left, tolerance);
    return faces.size() == 1 ? faces[0].corners : std::vector<Vec>();
}

// Every face with as many corners, in all ways in which the corners can be named after each other.
void add_faces(const Rule& rule, const SeenDesign& design, double tolerance, Applications& found) {
    const std::vector<Vec> own = corners_of(rule.left, tolerance);
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
            at.fit.angle_degrees = degrees_of(side) - degrees_of(own_side);
            if (at.fit.angle_degrees < 0) at.fit.angle_degrees += 360;
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
    const std::vector<Vec> own = corners_of(rule.left, tolerance);
    const auto moved = [&](Vec p) { return curves::stretched(p, own, at.corners); };
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
        } else {
            const curves::KeptMatches& matches = design.matches_of(number, job);
            add_matches(rule, matches.found(), found);
            add_families(rule, matches.families(), found);
            found.near_misses = matches.near_misses().size();
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

Scope example_scope(const Settings& settings) { return scope_of({}, 0, 1, settings); }

Result<Application> application_at(const Grammar& grammar, const Applications& found, const ApplyAt& wanted,
                                   const Surroundings& around) {
    const Rule& rule = grammar.rules[wanted.rule];
    const Unit unit = around.document.units.empty() ? Unit::px : around.document.units[0];
    const auto unit_text = [&](Vec p) {
        const auto shortened = [&](double px) { return to_text(std::round(from_px(px, unit) * 1000) / 1000); };
        return "(" + shortened(p.x) + ", " + shortened(p.y) + ")";
    };
    if (found.all.empty()) {
        return error("shape.no-match", "'" + rule.name + "' applies nowhere in this design", wanted.span,
                     {"`filigree match DOC --rule " + rule.name + " --explain` says what is missing"});
    }
    const auto distance = [&](const Application& at) { return length(at.place - wanted.place); };
    const Application* nearest = &found.all[0];
    for (const Application& at : found.all) {
        if (distance(at) < distance(*nearest)) nearest = &at;
    }
    const double breadth = diagonal_of(bounds_of(rule.left.elements)) * nearest->fit.scale;
    if (distance(*nearest) > 0.5 * breadth) {
        return error("shape.no-match-there", "'" + rule.name + "' does not apply at " + unit_text(wanted.place),
                     wanted.span, {"the nearest place where it does is " + unit_text(nearest->place)});
    }
    // Places that a person would call one, then what else was said of it; what was not said is as the rule stands.
    const double near = 0.01 * breadth, same = distance(*nearest) + near;
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
    if (wanted.is_mirrored && !best->fit.is_reflected) {
        return error("shape.no-match-there", "at " + unit_text(best->place) + " '" + rule.name + "' is not mirrored",
                     wanted.span);
    }
    return *best;
}

std::vector<Application> orbit_of(const Application& application, const Rule& rule, const SeenDesign& design,
                                  double tolerance) {
    std::vector<Application> orbit = {application};
    std::vector<Shape> covered = {placed(rule.left, rule, application, tolerance)};
    curves::MatchOptions options;
    options.group = curves::MatchGroup::isometry;
    options.tolerance = tolerance;
    for (const curves::Symmetry& symmetry : symmetries(design.shape(), options)) {
        Application moved = application;
        moved.fit = with_map(application.fit, compose(symmetry.by, application.fit.by));
        for (Vec& corner : moved.corners) corner = apply(symmetry.by, corner);
        moved.place = apply(symmetry.by, application.place);
        Shape own = placed(rule.left, rule, moved, tolerance);
        const bool is_known = std::any_of(covered.begin(), covered.end(),
                                          [&](const Shape& other) { return are_equal(own, other, tolerance); });
        if (is_known) continue;
        covered.push_back(std::move(own));
        orbit.push_back(std::move(moved));
    }
    return orbit;
}

}  // namespace filigree::shape
