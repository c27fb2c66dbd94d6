#include "engines/shape/shape_values.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "curves/algebra.h"
#include "curves/maximal.h"
#include "curves/path_elements.h"
#include "engines/shape/grammar.h"
#include "language/form_value.h"
#include "language/quantity.h"
#include "language/shape_forms.h"

namespace filigree::shape {
namespace {

using curves::Element;
using curves::Shape;

constexpr Colour black{0, 0, 0, 255};

struct Ink {
    std::uint32_t layer = 0;
    double weight = 1;
};

Ink ink_of(const SymbolicCall& call) {
    const auto& colour = std::get<Colour>(argument_of(call, "colour").data);
    return {layer_of_colour(colour == black ? std::nullopt : std::optional(colour)), number_of(call, "weight")};
}

void take(std::vector<Element>& elements, Element e, const Ink& ink) {
    e.layer = ink.layer;
    e.weight = ink.weight;
    elements.push_back(e);
}

Vec point_of(const SymbolicCall& call, std::string_view name) { return std::get<Vec>(argument_of(call, name).data); }

// The corners of a regular polygon, the first at the top.
std::vector<Vec> ring_of(int count, double radius, Vec centre) {
    std::vector<Vec> corners;
    for (int i = 0; i < count; ++i) {
        const auto [cosine, sine] = elementary::cos_sin_degrees(360.0 * i / count - 90);
        corners.push_back(centre + Vec{radius * cosine, radius * sine});
    }
    return corners;
}

void add_lines(std::vector<Element>& elements, const std::vector<Vec>& corners, bool is_closed, const Ink& ink) {
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        take(elements, curves::line_element(corners[i], corners[i + 1]), ink);
    }
    if (is_closed) take(elements, curves::line_element(corners.back(), corners.front()), ink);
}

Diagnostic not_a_shape(const Value& value, std::string_view wanted) {
    return error("shape.wrong-kind", "expected " + std::string(wanted) + ", found " + std::string(kind_of(value)),
                 value.span);
}

// The call with a value for every parameter of its form.
Result<SymbolicCall> bound(const SymbolicCall& call, const std::vector<OperatorDescription>& forms, const Value& value,
                           const ValueReading& reading) {
    ParameterDescription parameter{.name = "shape", .type = ParameterType::form};
    parameter.forms = &forms;
    Result<Value> converted = to_form(parameter, Value{call, value.span}, reading.document, value.span);
    if (!converted) return converted.diagnostics();
    return std::get<SymbolicCall>(std::move(converted->data));
}

Result<std::vector<Element>> elements_of_path(const SymbolicCall& call, const Value& value, const ValueReading& reading,
                                              const Ink& ink) {
    Result<Path> path = parse_path_data(text_of(call, "data"));
    if (!path) {
        Diagnostic problem = path.diagnostics().front();
        problem.span = value.span;
        return problem;
    }
    const double unit = px_per(bare_unit(&reading.document, value.span));
    return curves::elements_of(transformed(*path, scaling(unit, unit)), ink.layer, ink.weight);
}

Result<std::vector<Element>> elements_of_file(const SymbolicCall& call, const Value& value,
                                              const ValueReading& reading) {
    const auto picture = reading.files.drawing(text_of(call, "name"));
    if (!picture) {
        Diagnostic problem = picture.diagnostics().front();
        if (problem.span.file == SourceSpan::no_file) problem.span = value.span;
        return problem;
    }
    const Result<DrawnSide> drawn = drawn_below(**picture, text_of(call, "id"));
    if (drawn) return elements_of(*drawn, reading);
    Diagnostic problem = drawn.diagnostics().front();
    problem.span = value.span;
    return problem;
}

Result<std::vector<Element>> elements_of_form(const SymbolicCall& call, const Value& value,
                                              const ValueReading& reading) {
    if (call.name == "file") return elements_of_file(call, value, reading);
    const Ink ink = ink_of(call);
    if (!(ink.weight > 0)) return error("shape.no-weight", "a weight must be above 0", value.span);
    if (call.name == "path") return elements_of_path(call, value, reading, ink);
    std::vector<Element> elements;
    if (call.name == "line") {
        take(elements, curves::line_element(point_of(call, "from"), point_of(call, "to")), ink);
    } else if (call.name == "polyline") {
        std::vector<Vec> corners;
        for (const Value& item : std::get<ValueList>(argument_of(call, "points").data).items) {
            corners.push_back(std::get<Vec>(item.data));
        }
        add_lines(elements, corners, false, ink);
    } else if (call.name == "circle") {
        take(elements, curves::circle_element(point_of(call, "centre"), number_of(call, "radius")), ink);
    } else if (call.name == "ellipse") {
        take(elements,
             curves::arc_element(point_of(call, "centre"), {number_of(call, "rx"), 0}, {0, number_of(call, "ry")},
                                 -elementary::pi, elementary::pi),
             ink);
    } else if (call.name == "arc") {
        const double radius = number_of(call, "radius"), degree = elementary::pi / 180;
        const double from = number_of(call, "from");
        double to = number_of(call, "to");
        if (to < from) to += 360 * std::ceil((from - to) / 360);
        take(elements,
             curves::arc_element(point_of(call, "centre"), {radius, 0}, {0, radius}, from * degree, to * degree), ink);
    } else if (call.name == "rectangle") {
        const double x = 0.5 * number_of(call, "width"), y = 0.5 * number_of(call, "height");
        const Vec centre = point_of(call, "centre");
        add_lines(elements, {centre + Vec{-x, -y}, centre + Vec{x, -y}, centre + Vec{x, y}, centre + Vec{-x, y}}, true,
                  ink);
    } else if (call.name == "polygon") {
        add_lines(
            elements,
            ring_of(static_cast<int>(number_of(call, "sides")), number_of(call, "radius"), point_of(call, "centre")),
            true, ink);
    } else if (call.name == "point") {
        const std::string& label = text_of(call, "label");
        if (reading.labels != nullptr) reading.labels->insert_or_assign(layer_of_label(label), label);
        take(elements, curves::point_element(point_of(call, "at")), {layer_of_label(label), ink.weight});
    }
    return elements;
}

Result<Transform> transform_of_form(const SymbolicCall& call) {
    if (call.name == "translate") return translation({number_of(call, "dx"), number_of(call, "dy")});
    const Vec about = point_of(call, "about");
    const auto there_and_back = [&](const Transform& by) {
        return compose(translation(about), compose(by, translation(-about)));
    };
    if (call.name == "rotate") return there_and_back(rotation_degrees(number_of(call, "angle")));
    if (call.name == "scale") return there_and_back(scaling(number_of(call, "factor"), number_of(call, "factor")));
    const auto [cosine, sine] = elementary::cos_sin_degrees(2 * number_of(call, "angle"));
    return there_and_back({cosine, sine, sine, -cosine, 0, 0});
}

std::optional<Diagnostic> off_plane(std::span<const Element> elements, SourceSpan span) {
    if (std::all_of(elements.begin(), elements.end(), curves::is_on_plane)) return std::nullopt;
    return error("shape.off-plane", "this reaches beyond the plane, which ends 2^30 px from the origin", span);
}

Result<Shape> moved(const Shape& shape, const Transform& by, double tolerance, SourceSpan span) {
    std::vector<Element> elements;
    for (const Element& e : shape.elements) elements.push_back(transformed(e, by));
    if (auto beyond = off_plane(elements, span)) return *std::move(beyond);
    return maximal(std::move(elements), tolerance);
}

}  // namespace

std::vector<Element> elements_of(const DrawnSide& side, const ValueReading& reading) {
    std::vector<Element> elements;
    for (const DrawnPath& drawn : side.paths) {
        const auto colour = drawn.colour == black ? std::nullopt : drawn.colour;
        const std::vector<Element> own = curves::elements_of(drawn.path, layer_of_colour(colour), drawn.weight);
        elements.insert(elements.end(), own.begin(), own.end());
    }
    for (const DrawnLabel& label : side.labels) {
        if (reading.labels != nullptr) reading.labels->insert_or_assign(layer_of_label(label.text), label.text);
        take(elements, curves::point_element(label.place), {layer_of_label(label.text), 1});
    }
    return elements;
}

std::optional<Region> region_inside(const Path& border) {
    const double error = 1e-5 * diagonal_of(curves::bounds_of(curves::elements_of(border)));
    if (!(error > 0)) return std::nullopt;
    std::vector<Polyline> lines = flatten(border, error);
    if (lines.size() != 1 || !lines[0].closed || lines[0].points.size() < 3) return std::nullopt;
    return Region{std::move(lines[0].points), error};
}

Result<Shape> shape_of(const Value& value, const ValueReading& reading) {
    if (const auto* word = std::get_if<Symbol>(&value.data); word != nullptr && word->name == "empty") return Shape();
    const auto* call = std::get_if<SymbolicCall>(&value.data);
    if (call == nullptr || shape_kind(value) != ShapeKind::shape) return not_a_shape(value, "a shape");
    if (!is_operation(*call)) {
        const Result<SymbolicCall> form = bound(*call, drawn_shapes(), value, reading);
        if (!form) return form.diagnostics();
        Result<std::vector<Element>> elements = elements_of_form(*form, value, reading);
        if (!elements) return elements.diagnostics();
        if (auto beyond = off_plane(*elements, value.span)) return *std::move(beyond);
        Shape shape = maximal(std::move(*elements), reading.tolerance, reading.doubts);
        if (shape.elements.empty() && reading.warnings != nullptr) {
            reading.warnings->push_back(
                warning("shape.nothing-there", "nothing of this shape is longer than the tolerance", value.span));
        }
        return shape;
    }
    if (call->name == "*") {
        Result<Shape> shape = shape_of(call->arguments.back().value, reading);
        for (std::size_t i = call->arguments.size() - 1; shape && i-- > 0;) {
            const Result<Transform> by = transform_of(call->arguments[i].value, reading);
            if (!by) return by.diagnostics();
            shape = moved(*shape, *by, reading.tolerance, value.span);
        }
        return shape;
    }
    Shape all;
    std::vector<Element> summed;  // of a sum, made maximal once
    for (std::size_t i = 0; i < call->arguments.size(); ++i) {
        Result<Shape> operand = shape_of(call->arguments[i].value, reading);
        if (!operand) return operand.diagnostics();
        if (call->name == "+") {
            summed.insert(summed.end(), operand->elements.begin(), operand->elements.end());
        } else if (i == 0) {
            all = std::move(*operand);
        } else {
            all = call->name == "-" ? difference(all, *operand, reading.tolerance, reading.doubts)
                                    : product(all, *operand, reading.tolerance, reading.doubts);
        }
    }
    return call->name == "+" ? maximal(std::move(summed), reading.tolerance, reading.doubts) : all;
}

Result<Transform> transform_of(const Value& value, const ValueReading& reading) {
    const auto* call = std::get_if<SymbolicCall>(&value.data);
    if (call == nullptr || shape_kind(value) != ShapeKind::transform) {
        return not_a_shape(value, "a transform such as rotate(90)");
    }
    if (!is_operation(*call)) {
        const Result<SymbolicCall> form = bound(*call, shape_transforms(), value, reading);
        if (!form) return form.diagnostics();
        return transform_of_form(*form);
    }
    Transform all;
    for (const NamedValue& argument : call->arguments) {
        const Result<Transform> one = transform_of(argument.value, reading);
        if (!one) return one.diagnostics();
        all = compose(all, *one);
    }
    return all;
}

bool is_region(const Value& value) {
    const auto* call = std::get_if<SymbolicCall>(&value.data);
    if (call != nullptr && call->name == "*" && !call->arguments.empty())
        return is_region(call->arguments.back().value);
    return shape_kind(value) == ShapeKind::region;
}

Result<Region> region_of(const Value& value, const ValueReading& reading) {
    const auto* call = std::get_if<SymbolicCall>(&value.data);
    if (call == nullptr || shape_kind(value) != ShapeKind::region)
        return not_a_shape(value, "a region such as box(...)");
    if (call->name == "*") {
        Result<Region> region = region_of(call->arguments.back().value, reading);
        for (std::size_t i = call->arguments.size() - 1; region && i-- > 0;) {
            const Result<Transform> by = transform_of(call->arguments[i].value, reading);
            if (!by) return by.diagnostics();
            region = transformed(*region, *by);
        }
        return region;
    }
    const Result<SymbolicCall> form = bound(*call, shape_regions(), value, reading);
    if (!form) return form.diagnostics();
    if (form->name == "box") {
        const double x0 = number_of(*form, "x0"), y0 = number_of(*form, "y0");
        const double x1 = number_of(*form, "x1"), y1 = number_of(*form, "y1");
        if (x0 == x1 || y0 == y1) return error("shape.empty-region", "this box has no inside", value.span);
        return Region{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
    }
    if (form->name == "disc") {
        const double radius = number_of(*form, "radius");
        return Region{ring_of(256, radius, point_of(*form, "centre")), 1e-4 * radius};
    }
    const Result<Shape> border = shape_of(argument_of(*form, "shape"), reading);
    if (!border) return border.diagnostics();
    const std::vector<curves::JoinedPath> paths = curves::paths_of(border->elements, 2 * reading.tolerance);
    std::optional<Region> region;
    if (paths.size() == 1) region = region_inside(paths[0].path);
    if (!region) {
        return error("shape.open-region", "the curves of this shape do not close to one ring", value.span,
                     {"inside(...) takes a shape with one closed outline"});
    }
    return *std::move(region);
}

}  // namespace filigree::shape
