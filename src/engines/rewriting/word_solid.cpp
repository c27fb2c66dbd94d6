#include "engines/rewriting/word_solid.h"

#include <algorithm>

#include "language/form_value.h"
#include "space/solids.h"

namespace filigree::rewriting {
namespace {

class Builder {
public:
    Builder(const Derivation& derivation, const TurtleDrawing& turtled, const DrawRules& rules,
            const std::vector<Polygons>& forms, WordStyles& styles)
        : derivation_(derivation), turtled_(turtled), rules_(rules), forms_(forms), styles_(styles) {}

    Result<WordSolid> run() {
        for (const TurtleSegment& segment : turtled_.segments) add(segment);
        for (const TurtlePolygon& polygon : turtled_.polygons) add(polygon);
        for (const TurtleShape& shape : turtled_.shapes) add(shape);
        if (!styles_.errors.empty()) return styles_.errors;
        return std::move(made_);
    }

private:
    MeshOrigin origin_of(std::uint64_t place, const Material& material) {
        const Key key = styles_.key_of(place);
        made_.symbols.emplace(key.value, place);
        Material named = material;
        named.name = to_utf8(std::u32string(1, derivation_.alphabet[derivation_.word.symbols[place]].letter));
        return {key, number_of_material(named)};
    }
    static Material solid_material(const Style& style) {
        Material material;
        material.fill = style.fill.value_or(material.fill);
        material.edge = has_stroke(style) ? style.stroke : std::nullopt;
        material.pen = style.pen;
        return material;
    }
    std::uint32_t number_of_material(const Material& material) {
        std::vector<Material>& all = made_.materials;
        if (last_ < all.size() && all[last_] == material) return last_;
        const auto found = std::find(all.begin(), all.end(), material);
        last_ = static_cast<std::uint32_t>(found - all.begin());
        if (found == all.end()) all.push_back(material);
        return last_;
    }

    void add(const TurtleSegment& segment) {
        const DrawnSymbol symbol{segment.symbol, segment.width, segment.colour, segment.from};
        const Style line = styles_.look_of(Drawn::line, symbol).style;
        if (!has_stroke(line)) return;
        if (rules_.tubes > 0) {
            Material material = solid_material(styles_.look_of(Drawn::tube, symbol).style);
            material.pen = Material{}.pen;  // the line's own is how thick it is
            add_prism(made_.mesh, segment.from, segment.to, segment.frame, line.pen / 2, rules_.tubes,
                      origin_of(segment.symbol, material));
            return;
        }
        Material material;
        material.fill = *line.stroke;
        material.edge.reset();
        const Vec3 ends[] = {segment.from, segment.to};
        add_line(made_.mesh, ends, line.pen, origin_of(segment.symbol, material));
    }

    void add(const TurtlePolygon& polygon) {
        const Vec3* const corners = turtled_.corners.data() + polygon.first;
        const Style style =
            styles_.look_of(Drawn::solid, {polygon.symbol, polygon.width, polygon.colour, *corners}).style;
        if (!style.fill && !has_stroke(style)) return;
        add_sheet(made_.mesh, {corners, corners + polygon.count}, origin_of(polygon.symbol, solid_material(style)));
    }

    void add(const TurtleShape& shape) {
        const Style style =
            styles_.look_of(Drawn::solid, {shape.symbol, shape.width, shape.colour, shape.position}).style;
        if (!style.fill && !has_stroke(style)) return;
        const std::size_t number = form_number(turtled_, shape.name);
        const SymbolicCall& form = rules_.forms[number].form;
        const MeshOrigin origin = origin_of(shape.symbol, solid_material(style));
        if (form.name == "box") {
            const auto size = [&](const char* name) { return shape.scale * number_of(form, name); };
            const Vec3 end = shape.position + size("length") * shape.frame.heading;
            const double height = size("height") > 0 ? size("height") : size("breadth");
            add_box(made_.mesh, shape.position, end, shape.frame, size("breadth"), height, origin);
            return;
        }
        // The form's y goes to the right of who looks along the heading.
        const Vec3 along = shape.scale * shape.frame.heading, across = -shape.scale * shape.frame.left;
        for (std::size_t i = 0; i < forms_[number].size(); ++i) {
            std::vector<Vec3> ring;
            for (const Point p : forms_[number][i].outer()) {
                const Vec at = to_px(p);
                ring.push_back(shape.position + at.x * along + at.y * across);
            }
            add_sheet(made_.mesh, ring, origin);
        }
    }

    const Derivation& derivation_;
    const TurtleDrawing& turtled_;
    const DrawRules& rules_;
    const std::vector<Polygons>& forms_;
    WordStyles& styles_;
    WordSolid made_;
    std::uint32_t last_ = 0;
};

}  // namespace

Result<WordSolid> word_solid(const Derivation& derivation, const TurtleDrawing& turtled, const DrawRules& rules,
                             const std::vector<Polygons>& forms, WordStyles& styles) {
    return Builder(derivation, turtled, rules, forms, styles).run();
}

}  // namespace filigree::rewriting
