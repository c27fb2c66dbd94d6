#include "language/shape_forms.h"

#include <array>

namespace filigree {
namespace {

constexpr double largest_px = 0x1p30;
constexpr std::string_view source = "Jowers & Earl, section 3.2";

using Parameters = std::vector<ParameterDescription>;

ParameterDescription length_parameter(std::string_view name, std::string_view help) {
    return {.name = name, .type = ParameterType::length, .help = help, .low = -largest_px, .high = largest_px};
}
ParameterDescription size_parameter(std::string_view name, std::string_view help) {
    return {.name = name, .type = ParameterType::length, .help = help, .low = 1e-9, .high = largest_px};
}
ParameterDescription angle_parameter(std::string_view name, std::string_view help) {
    return {.name = name, .type = ParameterType::angle, .help = help, .low = -1e6, .high = 1e6};
}
ParameterDescription point_parameter(std::string_view name, std::string_view help, std::string_view default_text = "") {
    return {.name = name, .type = ParameterType::point, .help = help, .default_text = default_text};
}
ParameterDescription text_parameter(std::string_view name, std::string_view help, std::string_view default_text = "") {
    return {.name = name, .type = ParameterType::text, .help = help, .default_text = default_text};
}
ParameterDescription centre_parameter() { return point_parameter("centre", "where its centre lies", "(0, 0)"); }

OperatorDescription described(std::string_view name, std::string_view help, Parameters parameters,
                              std::string_view example) {
    return {.name = name, .help = help, .source = source, .parameters = std::move(parameters), .example = example};
}
// With the attributes that curves and points have.
OperatorDescription drawn(std::string_view name, std::string_view help, Parameters parameters,
                          std::string_view example) {
    parameters.push_back({.name = "weight",
                          .type = ParameterType::real,
                          .help = "an attribute that rules ask for",
                          .default_text = "1",
                          .low = 0,
                          .high = 1e9});
    parameters.push_back({.name = "colour",
                          .type = ParameterType::colour,
                          .help = "another one, in which it is drawn",
                          .default_text = "black"});
    return described(name, help, std::move(parameters), example);
}

std::vector<OperatorDescription> make_shapes() {
    return {
        drawn("path", "the curves of SVG path data, open or closed",
              {text_parameter("data", "as in the attribute d; numbers are lengths in the document's unit")},
              "let petal = path(\"M -1 -1 Q 1 -3 3 3 M -1 -1 Q -3 1 3 3\")"),
        drawn("line", "a straight line", {point_parameter("from", "one end"), point_parameter("to", "the other end")},
              "let base = line((0, 0), (40, 0))"),
        drawn("polyline", "straight lines from point to point",
              {{.name = "points", .type = ParameterType::point, .help = "two or more", .repeats = true}},
              "let roof = polyline((0, 0), (20, -15), (40, 0))"),
        drawn("circle", "a circle", {size_parameter("radius", "from the centre to the border"), centre_parameter()},
              "let ring = circle(20, centre: (5, 5))"),
        drawn("arc", "an arc of a circle, clockwise on the page from one direction to the other",
              {size_parameter("radius", "from the centre to the arc"),
               angle_parameter("from", "where it begins; 0 is to the right, 90 downwards"),
               angle_parameter("to", "where it ends"), centre_parameter()},
              "let crest = arc(20, 180, 360)"),
        drawn("ellipse", "an ellipse",
              {size_parameter("rx", "half its width"), size_parameter("ry", "half its height"), centre_parameter()},
              "let eye = ellipse(20, 12)"),
        drawn("rectangle", "the four sides of a rectangle",
              {size_parameter("width", "from left to right"), size_parameter("height", "from top to bottom"),
               centre_parameter()},
              "let frame = rectangle(40, 30)"),
        drawn("polygon", "the sides of a regular polygon, a corner at the top",
              {{.name = "sides", .type = ParameterType::whole, .help = "how many", .low = 3, .high = 1000},
               size_parameter("radius", "from the centre to the corners"),
               centre_parameter()},
              "let hexagon = polygon(6, 20)"),
        drawn("point", "a point with a label, which only the same label matches",
              {point_parameter("at", "where it lies"), text_parameter("label", "what it is called", "\"\"")},
              "let tip = point((0, 0), \"tip\")"),
        described("file", "the strokes of an SVG file, or those of one element",
                  {text_parameter("name", "the file, beside the document or below it"),
                   text_parameter("id", "take only the element or group with this id", "\"\"")},
                  "let knot = file(\"knot.svg\", id: \"lobe\")"),
    };
}

ParameterDescription about_parameter(std::string_view help) { return point_parameter("about", help, "(0, 0)"); }

std::vector<OperatorDescription> make_transforms() {
    return {
        described("translate", "moves a shape",
                  {length_parameter("dx", "to the right"), length_parameter("dy", "downwards")},
                  "slide = petal -> translate(2, 2) * petal"),
        described("rotate", "turns a shape",
                  {angle_parameter("angle", "clockwise on the page"), about_parameter("what stays in its place")},
                  "turn = petal -> rotate(90) * petal"),
        described("scale", "makes a shape larger or smaller",
                  {{.name = "factor", .type = ParameterType::real, .help = "of lengths", .low = 1e-9, .high = 1e9},
                   about_parameter("what stays in its place")},
                  "grow = petal -> petal + scale(2, (3, 3)) * petal"),
        described("mirror", "reflects a shape in a line",
                  {angle_parameter("angle", "the direction of the line"), about_parameter("a point of the line")},
                  "close = petal -> petal + mirror(45) * petal"),
    };
}

std::vector<OperatorDescription> make_regions() {
    return {
        described("box", "an upright rectangle",
                  {length_parameter("x0", "of one corner"), length_parameter("y0", "of one corner"),
                   length_parameter("x1", "of the other corner"), length_parameter("y1", "of the other corner")},
                  "slide = petal -> lens unless box(0, 0, 3, 3)"),
        described("disc", "the inside of a circle",
                  {point_parameter("centre", "where its centre lies"),
                   size_parameter("radius", "from the centre to the border")},
                  "slide = petal -> lens unless disc((3, 3), 1)"),
        described("inside", "the inside of a closed shape",
                  {{.name = "shape", .type = ParameterType::any, .help = "any shape whose curves close"}},
                  "slide = petal -> lens unless inside(petal)"),
    };
}

std::vector<OperatorDescription> make_derivations() {
    const ParameterDescription rule{.name = "rule", .type = ParameterType::word, .help = "the name of another rule"};
    ParameterDescription angle = angle_parameter("angle", "the direction of the line");
    angle.default_text = "0";
    return {
        described("inverse", "the rule with its sides exchanged", {rule}, "back = inverse(slide)"),
        described("mirror", "the rule with its sides reflected in a line through the origin", {rule, angle},
                  "flip = mirror(slide, 45)"),
    };
}

}  // namespace

const std::vector<OperatorDescription>& drawn_shapes() {
    static const std::vector<OperatorDescription> descriptions = make_shapes();
    return descriptions;
}
const std::vector<OperatorDescription>& shape_transforms() {
    static const std::vector<OperatorDescription> descriptions = make_transforms();
    return descriptions;
}
const std::vector<OperatorDescription>& shape_regions() {
    static const std::vector<OperatorDescription> descriptions = make_regions();
    return descriptions;
}
const std::vector<OperatorDescription>& rule_derivations() {
    static const std::vector<OperatorDescription> descriptions = make_derivations();
    return descriptions;
}

const OperatorDescription* find_shape_form(std::string_view name) {
    for (const auto* forms : {&drawn_shapes(), &shape_transforms(), &shape_regions()}) {
        if (const OperatorDescription* form = find_operator(*forms, name)) return form;
    }
    return nullptr;
}

std::optional<ShapeKind> shape_kind(const Value& value) {
    if (const auto* word = std::get_if<Symbol>(&value.data)) {
        return word->name == "empty" ? std::optional(ShapeKind::shape) : std::nullopt;
    }
    const auto* call = std::get_if<SymbolicCall>(&value.data);
    if (call == nullptr) return std::nullopt;
    if (call->name == "*") return shape_kind(call->arguments.back().value);
    if (is_operation(*call)) return ShapeKind::shape;
    if (find_operator(drawn_shapes(), call->name) != nullptr) return ShapeKind::shape;
    if (find_operator(shape_transforms(), call->name) != nullptr) return ShapeKind::transform;
    if (find_operator(shape_regions(), call->name) != nullptr) return ShapeKind::region;
    return std::nullopt;
}

std::string_view kind_among_shapes(const Value& value) {
    const std::optional<ShapeKind> kind = shape_kind(value);
    if (!kind) return kind_of(value);
    return *kind == ShapeKind::shape ? "a shape" : *kind == ShapeKind::transform ? "a transform" : "a region";
}

Evaluation with_shapes(Evaluation at) {
    at.shapes = true;
    at.words.push_back("empty");
    for (const auto* forms : {&drawn_shapes(), &shape_transforms(), &shape_regions()}) {
        for (const OperatorDescription& form : *forms) at.calls.push_back(form.name);
    }
    return at;
}

}  // namespace filigree
