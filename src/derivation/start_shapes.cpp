#include "derivation/start_shapes.h"

#include "base/elementary.h"

namespace filigree {
namespace {

constexpr double largest_px = 0x1p30;

ParameterDescription size_parameter(std::string_view name, std::string_view help) {
    return {.name = name, .type = ParameterType::length, .help = help, .low = 1, .high = largest_px};
}
ParameterDescription at_parameter() {
    return {.name = "at", .type = ParameterType::point, .help = "where its centre lies", .default_text = "(0, 0)"};
}
ParameterDescription overlap_parameter() {
    return {.name = "overlap",
            .type = ParameterType::word,
            .help = "what happens to earlier starts below it: covered, united with those of its tag, or refused",
            .default_text = "top",
            .words = {"top", "union", "error"}};
}

std::vector<OperatorDescription> make_descriptions() {
    std::vector<OperatorDescription> all;
    const auto add = [&](std::string_view name, std::string_view help, std::vector<ParameterDescription> parameters,
                         std::string_view example) {
        parameters.push_back(overlap_parameter());
        all.push_back({.name = name,
                       .help = help,
                       .source = "gTangle, section 3",
                       .parameters = std::move(parameters),
                       .ports = {},
                       .example = example});
    };
    add("rectangle", "a rectangle",
        {size_parameter("width", "from left to right"), size_parameter("height", "from top to bottom"), at_parameter()},
        "start big_poly = rectangle(400, 300)");
    add("circle", "a circle", {size_parameter("radius", "from the centre to the border"), at_parameter()},
        "start big_poly = circle(200)");
    add("ellipse", "an ellipse",
        {size_parameter("rx", "half its width"), size_parameter("ry", "half its height"), at_parameter()},
        "start big_poly = ellipse(240, 160)");
    add("polygon", "a regular polygon, a corner at the top",
        {{.name = "sides", .type = ParameterType::whole, .help = "how many sides", .low = 3, .high = 1000},
         size_parameter("radius", "from the centre to the corners"),
         at_parameter()},
        "start big_poly = polygon(6, 200)");
    add("star", "a star, a tip at the top",
        {{.name = "points", .type = ParameterType::whole, .help = "how many tips", .low = 3, .high = 1000},
         size_parameter("outer", "from the centre to the tips"),
         size_parameter("inner", "from the centre to the notches"),
         at_parameter()},
        "start big_poly = star(5, 200, 90)");
    add("path", "SVG path data, filled by the even-odd rule; every subpath closed",
        {{.name = "data", .type = ParameterType::text, .help = "as in the attribute d"},
         {.name = "scale",
          .type = ParameterType::real,
          .help = "factor of its coordinates",
          .default_text = "1",
          .low = 1e-6,
          .high = 1e6}},
        "start big_poly = path(\"M 0 0 H 300 V 200 H 0 Z\")");
    add("file", "the filled shapes of an SVG file, or those of one element",
        {{.name = "name", .type = ParameterType::text, .help = "the file, beside the document or below it"},
         {.name = "id",
          .type = ParameterType::text,
          .help = "take only the element or group with this id",
          .default_text = "\"\""},
         {.name = "width",
          .type = ParameterType::length,
          .help = "scale it to this width; 0 keeps its size",
          .default_text = "0px",
          .low = 0,
          .high = largest_px}},
        "start big_poly = file(\"leaf.svg\", id: \"outline\", width: 120mm)");
    add("host", "the shape of another document that embeds this one; on its own, this document's page",
        {{.name = "fit",
          .type = ParameterType::word,
          .help = "how this document's page is laid over the shape's box: not at all (a length stays what it is), "
                  "covering it, within it, or stretched to it",
          .default_text = "keep",
          .words = {"keep", "cover", "contain", "stretch"}}},
        "start ground = host(fit: cover)");
    return all;
}

Polyline ring_of_corners(std::size_t count, double first_radius, double second_radius) {
    Polyline ring{.points = {}, .closed = true};
    ring.points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 360.0 * static_cast<double>(i) / static_cast<double>(count) - 90.0;
        const elementary::CosSin turn = elementary::cos_sin_degrees(angle);
        const double radius = i % 2 == 0 ? first_radius : second_radius;
        ring.points.push_back({radius * turn.cos, radius * turn.sin});
    }
    return ring;
}

Polyline ellipse_outline(double rx, double ry, double tolerance) {
    Path path;
    path.verbs = {Verb::move, Verb::arc, Verb::arc, Verb::close};
    path.points = {{rx, 0}, {rx, ry}, {0, 2}, {-rx, 0}, {rx, ry}, {0, 2}, {rx, 0}};
    return flatten(path, tolerance).front();
}

}  // namespace

std::vector<Polyline> built_in_outline(const Arguments& arguments, double tolerance) {
    const std::string_view name = arguments.description->name;
    if (name == "rectangle") {
        const double x = arguments.number("width") / 2, y = arguments.number("height") / 2;
        return {{.points = {{-x, -y}, {x, -y}, {x, y}, {-x, y}}, .closed = true}};
    }
    if (name == "circle") return {ellipse_outline(arguments.number("radius"), arguments.number("radius"), tolerance)};
    if (name == "ellipse") return {ellipse_outline(arguments.number("rx"), arguments.number("ry"), tolerance)};
    if (name == "polygon") {
        const double radius = arguments.number("radius");
        return {ring_of_corners(static_cast<std::size_t>(arguments.number("sides")), radius, radius)};
    }
    return {ring_of_corners(2 * static_cast<std::size_t>(arguments.number("points")), arguments.number("outer"),
                            arguments.number("inner"))};
}

const std::vector<OperatorDescription>& start_shape_descriptions() {
    static const std::vector<OperatorDescription> descriptions = make_descriptions();
    return descriptions;
}

}  // namespace filigree
