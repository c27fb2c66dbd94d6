#include "derivation/start_shapes.h"

#include "base/elementary.h"
#include "language/form_value.h"

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

enum class Use { start, form };

std::vector<OperatorDescription> make_descriptions(Use use) {
    std::vector<OperatorDescription> all;
    const auto add = [&](std::string_view name, std::string_view help, std::vector<ParameterDescription> parameters,
                         std::string_view example) {
        if (use == Use::start) parameters.push_back(overlap_parameter());
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
    add("text", "letters of a font, each a shape of its own",
        {{.name = "text", .type = ParameterType::text, .help = "what it says; \\n begins a new line"},
         {.name = "font",
          .type = ParameterType::text,
          .help = "a font file (TrueType or OpenType), beside the document or below it"},
         {.name = "size",
          .type = ParameterType::length,
          .help = "height of a line of the font",
          .default_text = "80px",
          .low = 1,
          .high = 1e6},
         {.name = "spacing",
          .type = ParameterType::length,
          .help = "added between letters",
          .default_text = "0px",
          .low = -1e6,
          .high = 1e6},
         {.name = "line_height",
          .type = ParameterType::real,
          .help = "from line to line, in sizes",
          .default_text = "1.2",
          .low = 0.1,
          .high = 100},
         {.name = "align",
          .type = ParameterType::word,
          .help = "how lines stand below each other",
          .default_text = "centre",
          .words = {"left", "centre", "right"}},
         at_parameter()},
        "start word = text(\"LACE\", font: \"bold.ttf\", size: 200)");
    add("image", "where a picture is dark, as smooth outlines",
        {{.name = "name", .type = ParameterType::text, .help = "a PNG or JPEG file, beside the document or below it"},
         {.name = "width",
          .type = ParameterType::length,
          .help = "of the whole picture; 0: a px for each of its pixels",
          .default_text = "0px",
          .low = 0,
          .high = 1e6},
         {.name = "threshold",
          .type = ParameterType::real,
          .help = "darkness from which on a pixel counts, from 0 (white) to 1 (black)",
          .default_text = "0.5",
          .low = 0.01,
          .high = 0.99},
         {.name = "light",
          .type = ParameterType::flag,
          .help = "take the light parts instead of the dark ones",
          .default_text = "false"},
         {.name = "specks",
          .type = ParameterType::real,
          .help = "leave out spots and holes of fewer pixels than this",
          .default_text = "16",
          .low = 0,
          .high = 1e9},
         at_parameter()},
        "start shade = image(\"portrait.png\", width: 600)");
    if (use == Use::form) return all;
    add("cell", "the domain of the document's symmetry: its copies cover the plane, or the disc of a rosette, once",
        {{.name = "width",
          .type = ParameterType::length,
          .help = "of the tile that repeats, or across the disc; 0 takes the page's tile",
          .default_text = "0px",
          .low = 0,
          .high = 1e6},
         {.name = "height",
          .type = ParameterType::length,
          .help = "of the tile; 0 is what the group needs, or the width",
          .default_text = "0px",
          .low = 0,
          .high = 1e6}},
        "start ground = cell(120)");
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

SymbolicCall call_of(const Arguments& arguments) {
    SymbolicCall call{std::string(arguments.description->name), {}};
    for (std::size_t i = 0; i < arguments.values.size(); ++i) {
        call.arguments.push_back(
            {std::string(arguments.description->parameters[i].name), arguments.values[i].common, {}});
    }
    return call;
}

std::vector<Polyline> built_in_outline(const SymbolicCall& shape, double tolerance) {
    const auto number = [&](std::string_view name) { return number_of(shape, name); };
    const auto count = [&](std::string_view name) { return static_cast<std::size_t>(number(name)); };
    Polyline outline;
    if (shape.name == "rectangle") {
        const double x = number("width") / 2, y = number("height") / 2;
        outline = {.points = {{-x, -y}, {x, -y}, {x, y}, {-x, y}}, .closed = true};
    } else if (shape.name == "circle") {
        outline = ellipse_outline(number("radius"), number("radius"), tolerance);
    } else if (shape.name == "ellipse") {
        outline = ellipse_outline(number("rx"), number("ry"), tolerance);
    } else if (shape.name == "polygon") {
        outline = ring_of_corners(count("sides"), number("radius"), number("radius"));
    } else {
        outline = ring_of_corners(2 * count("points"), number("outer"), number("inner"));
    }
    const Vec at = std::get<Vec>(argument_of(shape, "at").data);
    for (Vec& point : outline.points) point = point + at;
    return {std::move(outline)};
}

const std::vector<OperatorDescription>& start_shape_descriptions() {
    static const std::vector<OperatorDescription> descriptions = make_descriptions(Use::start);
    return descriptions;
}

const std::vector<OperatorDescription>& shape_forms() {
    static const std::vector<OperatorDescription> descriptions = make_descriptions(Use::form);
    return descriptions;
}

const std::vector<OperatorDescription>& curve_forms() {
    static const std::vector<OperatorDescription> descriptions = [] {
        std::vector<OperatorDescription> curves;
        for (const OperatorDescription& form : shape_forms()) {
            if (form.name == "path" || form.name == "file") curves.push_back(form);
        }
        return curves;
    }();
    return descriptions;
}

}  // namespace filigree
