#include "derivation/plane_start.h"

#include <algorithm>
#include <map>

#include "base/unicode.h"
#include "derivation/start_shapes.h"
#include "language/bind.h"
#include "language/form_value.h"
#include "plane/clean.h"
#include "plane/path.h"

namespace filigree {
namespace {

// px^2: what outlines that nearly share a border leave of a covered shape beside its true rest.
constexpr double least_fragment = 1e-3;

// One shape as a start gives it, before overlaps are resolved.
struct Piece {
    Polygons area;  // one polygon or several
    std::string tag;
    Key key;
    std::size_t statement = 0;  // number of its start, from 0
};

Diagnostic at_span(Diagnostic diagnostic, SourceSpan span) {
    if (diagnostic.span.file == SourceSpan::no_file) diagnostic.span = span;
    return diagnostic;
}

std::optional<Diagnostic> open_subpath(const std::vector<Polyline>& outlines, const std::string& what) {
    for (const Polyline& outline : outlines) {
        if (outline.closed || outline.points.size() < 2 || outline.points.front() == outline.points.back()) continue;
        return error("start.open-path", what + " has an open path, which encloses no area", {},
                     {"close it (a path's data then ends in Z)"});
    }
    return std::nullopt;
}

// Outlines off the plane would be dropped without a word when they are cleaned.
std::optional<Diagnostic> off_plane(const std::vector<Polyline>& outlines) {
    for (const Polyline& outline : outlines) {
        for (const Vec& point : outline.points) {
            if (is_on_plane(point)) continue;
            return error("start.off-plane", "the start reaches farther than 2^30 px from the origin");
        }
    }
    return std::nullopt;
}

// Shapes that are drawn by their stroke alone grow where they are closed.
std::optional<Diagnostic> open_stroke(bool filled, const std::vector<Polyline>& lines, const std::string& name,
                                      const std::string& file) {
    if (filled) return std::nullopt;
    return open_subpath(lines, name.empty() ? "'" + file + "'" : "the element '" + name + "' of '" + file + "'");
}

// A layer's name as a tag: what no tag may hold becomes '_'.
std::string as_tag(const std::string& name) {
    std::string tag;
    bool all_digits = true;
    for (std::size_t i = 0; i < name.size();) {
        const unicode::Decoded next = unicode::decode(name, i);
        const bool letter = next.valid && (unicode::is_letter(next.code_point) || next.code_point == U'_');
        const bool digit = next.valid && unicode::is_digit(next.code_point);
        if (letter || digit) {
            tag.append(name, i, next.length);
        } else {
            tag += '_';
        }
        all_digits = all_digits && digit;
        i += next.length;
    }
    return all_digits ? "_" + tag : tag;
}

class StartBuilder {
public:
    StartBuilder(const Settings& settings, const Document& document, const ShapeSource& shapes,
                 const DocumentSite& site, const PolygonView* host)
        : settings_(settings), document_(document), shapes_(shapes), site_(site), host_(host) {}

    Result<PlaneStart> build() {
        walk_ = begin_walk(site_, document_, settings_.globals, settings_.seed);
        read_symmetry();
        for (const Statement& statement : document_.statements) {
            if (const auto* start = std::get_if<StartStatement>(&statement.node)) add_start(*start);
        }
        if (number_ == 0) {
            diagnostics_.push_back(error("start.missing", "the document has no start to grow from", {},
                                         {"add one, such as: start big_poly = rectangle(400, 300)"}));
        }
        if (has_errors(diagnostics_)) return diagnostics_;
        PlaneStart start = collect();
        if (start.polygons.empty()) {
            return error("start.empty", "the starts enclose no area that a grammar could grow in");
        }
        return Result<PlaneStart>(std::move(start), diagnostics_);
    }

private:
    void refuse(const Diagnostics& reasons, SourceSpan span) {
        for (const Diagnostic& reason : reasons) diagnostics_.push_back(at_span(reason, span));
    }

    void add_start(const StartStatement& start) {
        const std::size_t number = number_++;
        const Key key = rooted(site_, child(Key{hash_text("start")}, number + 1));
        if (start.from) {
            add_picture_layers(*start.from, key, number);
            return;
        }
        const auto* call = std::get_if<CallExpression>(&start.value->node);
        if (call == nullptr) {
            diagnostics_.push_back(error("start.not-a-shape", "a start is a shape such as rectangle(400, 300)",
                                         start.value->span, shape_hints("")));
            return;
        }
        const OperatorDescription* description = find_operator(start_shape_descriptions(), call->name);
        if (description == nullptr) {
            diagnostics_.push_back(error("start.unknown-shape", "there is no start shape '" + call->name + "'",
                                         call->name_span, shape_hints(call->name)));
            return;
        }
        const Result<BoundCall> bound =
            bind(*description, call->arguments, start.value->span, document_, settings_.globals);
        if (!bound) return refuse(bound.diagnostics(), start.value->span);
        const PresetNode node = node_below(walk_, walk_.root, {segment_of(start.tag.text)});
        const Result<StepChoices> choices = choices_at(walk_, node, settings_.globals, &choices_);
        if (!choices) return refuse(choices.diagnostics(), start.value->span);
        for (const std::uint32_t preset : node.accepted) {
            const std::string& parameter = walk_.presets.all[preset].path->parameter;
            const auto& known = description->parameters;
            if (std::any_of(known.begin(), known.end(), [&](const auto& p) { return p.name == parameter; })) {
                met_.push_back(preset);
            }
        }
        const Result<Arguments> arguments = evaluate_arguments(*bound, document_, settings_.globals, *choices, key, {});
        if (!arguments) return refuse(arguments.diagnostics(), start.value->span);
        add_shape(*arguments, start, key, number);
    }

    // The first start of a tag stands in paths as the tag itself, later ones as tag#2, tag#3.
    std::string segment_of(const std::string& tag) {
        const std::uint32_t count = ++starts_of_tag_[tag];
        return count == 1 ? tag : tag + "#" + std::to_string(count);
    }

    std::vector<std::string> shape_hints(const std::string& wanted) const {
        std::vector<std::string_view> names;
        std::string all = "known are ";
        for (const OperatorDescription& shape : start_shape_descriptions()) {
            if (!names.empty()) all += ", ";
            all += shape.name;
            names.push_back(shape.name);
        }
        std::vector<std::string> hints = did_you_mean(wanted, names);
        if (hints.empty()) hints.push_back(all);
        return hints;
    }

    void add_shape(const Arguments& arguments, const StartStatement& start, Key key, std::size_t number) {
        const SourceSpan whole = start.value->span;
        const std::string overlap(arguments.word("overlap"));
        std::vector<Piece> pieces;
        if (arguments.description->name == "host") {
            if (!set_fit(std::string(arguments.word("fit")), whole)) return;
            pieces.push_back({host_area(), start.tag.text, child(key, 0), number});
            accept(std::move(pieces), overlap, whole);
            return;
        }
        if (arguments.description->name == "cell") {
            if (auto cell = symmetry_cell(arguments, whole)) {
                pieces.push_back({std::move(*cell), start.tag.text, child(key, 0), number});
                accept_own(std::move(pieces), overlap, whole);
            }
            return;
        }
        const SymbolicCall shape = call_of(arguments);
        const Result<ShapeSource::Parts> parts = shapes_.parts(shape);
        refuse(parts.diagnostics(), whole);  // warnings too
        if (!parts) return;
        for (const ShapePart& part : **parts) {
            const auto open = shape.name == "path" ? open_subpath(part.lines, "the start")
                              : shape.name == "file"
                                  ? open_stroke(part.filled, part.lines, part.name, text_of(shape, "name"))
                                  : std::nullopt;
            if (open) return refuse({*open}, whole);
            if (!add_to(pieces, part.lines, part.rule, start.tag.text, key, number, whole)) return;
        }
        accept_own(std::move(pieces), overlap, whole);
    }

    // --- symmetry ---

    void read_symmetry() {
        const bool has_tile = settings_.page.kind == PageStatement::Kind::tile;
        if (settings_.symmetry) {
            Result<SymmetryGroup> group = find_symmetry(settings_.symmetry->text, settings_.symmetry->span);
            if (!group) return refuse(group.diagnostics(), settings_.symmetry->span);
            group_ = std::move(*group);
        } else if (has_tile) {
            group_ = *find_symmetry("p1");
        }
        if (group_ && has_tile) set_tile({settings_.page.width, settings_.page.height}, span_of_page());
    }
    SourceSpan span_of_page() const {
        for (const Statement& statement : document_.statements) {
            if (std::holds_alternative<PageStatement>(statement.node)) return statement.span;
        }
        return {};
    }
    void set_tile(Vec px, SourceSpan span) {
        Result<Point> tile = fit_tile(*group_, px, span);
        refuse(tile.diagnostics(), span);  // warnings too
        if (tile) tile_ = *tile;
    }

    // The domain of the symmetry; none, and an error, where that is not known. Already on the grid: its corners must
    // stay where they are, so that the copies meet.
    std::optional<Polygons> symmetry_cell(const Arguments& arguments, SourceSpan span) {
        const auto fail = [&](Diagnostic reason) {
            diagnostics_.push_back(at_span(std::move(reason), span));
            return std::nullopt;
        };
        if (!group_) {
            if (settings_.symmetry) return std::nullopt;  // its name is wrong, which is said
            return fail(error("start.no-symmetry", "cell() is the domain of a symmetry, and the document has none", {},
                              {"add one, such as: symmetry p4m"}));
        }
        const double width = arguments.number("width"), height = arguments.number("height");
        const bool given = width > 0;
        if (is_rosette(*group_)) {
            const double side = given ? width : tile_ ? std::min(to_px(*tile_).x, to_px(*tile_).y) : 400;
            return domain_of(Symmetry(*group_, tile_.value_or(Point{})), side / 2, settings_.resolution);
        }
        if (given && tile_) {
            return fail(error("start.two-cell-sizes", "the size of the tile is said already", {},
                              {"here, write cell() without a size"}));
        }
        if (!given && !tile_) {
            return fail(error("start.no-cell-size", "how large the cell is must be said once", {},
                              {"such as: cell(120), or page tile 120 x 120"}));
        }
        if (given) {
            constexpr double root_of_three = 1.7320508075688772;
            const double fitting = group_->lattice == Lattice::hexagonal ? width * root_of_three : width;
            set_tile({width, height > 0 ? height : fitting}, span);
            if (!tile_) return std::nullopt;
        }
        return domain_of(Symmetry(*group_, *tile_), 0, settings_.resolution);
    }

    // The way in which all host(...) of the document take the host's shape; false, and an error, where two differ.
    bool set_fit(const std::string& fit, SourceSpan span) {
        if (!fit_.empty() && fit_ != fit) {
            diagnostics_.push_back(error("start.two-fits", "another start takes the host's shape with fit: " + fit_,
                                         span, {"all starts by host(...) of a document have one fit"}));
            return false;
        }
        if (fit != "keep" && settings_.page.kind == PageStatement::Kind::fit) {
            diagnostics_.push_back(error("start.no-page", "fit: " + fit + " needs a page that is laid over the shape",
                                         span, {"add one, such as: page 100 x 100"}));
            return false;
        }
        fit_ = fit;
        if (host_ != nullptr) to_host_ = page_onto(settings_.page, bounds(*host_), fit);
        return true;
    }

    // The host's shape in this document's coordinates.
    Polygons host_area() const {
        if (host_ == nullptr) {
            const bool has_page = settings_.page.kind != PageStatement::Kind::fit;
            const Vec half = has_page ? Vec{settings_.page.width / 2, settings_.page.height / 2} : Vec{200, 150};
            const Polyline page{{{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}}, true};
            return clean(std::vector<Polyline>{page}, FillRule::nonzero);
        }
        Polygons area;
        area.add(*host_);
        if (fit_ == "keep") return area;
        const Transform from_host = inverse(to_host_);
        std::vector<Polyline> outlines;
        for (std::size_t r = 0; r < host_->ring_count(); ++r) {
            Polyline outline{{}, true};
            for (const Point& point : host_->ring(r)) outline.points.push_back(apply(from_host, to_px(point)));
            outlines.push_back(std::move(outline));
        }
        return clean(outlines, FillRule::even_odd);
    }

    void add_picture_layers(const Name& file, Key key, std::size_t number) {
        const Result<std::shared_ptr<const SvgPicture>> picture = shapes_.picture(file.text);
        if (!picture) return refuse(picture.diagnostics(), file.span);
        const std::vector<SvgShape>& shapes = (*picture)->shapes;
        const bool is_filled =
            std::any_of(shapes.begin(), shapes.end(), [](const SvgShape& shape) { return shape.filled; });
        std::vector<Piece> pieces;
        for (const SvgShape& shape : shapes) {
            if (is_filled && !shape.filled) continue;
            const std::vector<Polyline> lines = flatten(shape.path, settings_.resolution);
            if (const auto open = open_stroke(shape.filled, lines, shape.id, file.text)) {
                return refuse({*open}, file.span);
            }
            const std::string& layer = !shape.groups.empty() ? shape.groups.front() : shape.id;
            if (layer.empty()) {
                diagnostics_.push_back(error(
                    "start.unnamed-shape", "'" + file.text + "' has a shape without an id or a layer", file.span,
                    {"give it an id, or grow from the whole file by: start big_poly = file(\"" + file.text + "\")"}));
                return;
            }
            if (!add_to(pieces, lines, shape.fill_rule, as_tag(layer), key, number, file.span)) return;
        }
        accept_own(std::move(pieces), "top", file.span);
    }

    // The area of outlines as one more piece of a start; false, and an error, where it lies off the plane.
    bool add_to(std::vector<Piece>& pieces, const std::vector<Polyline>& outlines, FillRule rule, std::string tag,
                Key key, std::size_t number, SourceSpan span) {
        if (const auto off = off_plane(outlines)) {
            refuse({*off}, span);
            return false;
        }
        pieces.push_back({clean(outlines, rule), std::move(tag), child(key, pieces.size()), number});
        return true;
    }

    // Later pieces cover, swallow or refuse the earlier ones that they overlap.
    void accept_own(std::vector<Piece> fresh, const std::string& overlap, SourceSpan span) {
        has_own_shapes_ = true;
        accept(std::move(fresh), overlap, span);
    }
    void accept(std::vector<Piece> fresh, const std::string& overlap, SourceSpan span) {
        double largest = 0;
        for (Piece& piece : fresh) {
            first_pieces_.emplace(piece.tag, piece.key);
            if (piece.area.empty()) continue;
            const Box box = bounds(piece.area);
            largest = std::max({largest, to_px(box.max).x - to_px(box.min).x, to_px(box.max).y - to_px(box.min).y});
            for (Piece& earlier : pieces_) {
                if (earlier.area.empty() || !overlaps(bounds(earlier.area), box)) continue;
                Polygons rest = subtract(earlier.area, piece.area);
                if (!(area(earlier.area) - area(rest) > 0)) continue;  // they touch at most
                if (overlap == "error" && earlier.statement != piece.statement) {
                    diagnostics_.push_back(
                        error("start.overlap", "the start '" + piece.tag + "' overlaps the start '" + earlier.tag + "'",
                              span, {"overlap: top lets it cover what is below"}));
                    return;
                }
                if (overlap == "union" && earlier.tag == piece.tag) {
                    piece.area = unite(earlier.area, piece.area);
                    earlier.area = {};
                } else {
                    earlier.area = std::move(rest);
                }
            }
            pieces_.push_back(std::move(piece));
        }
        if (largest < 1) {
            diagnostics_.push_back(error("start.too-small", "the start is less than 1 px across", span,
                                         {"is its unit the one that was meant? 1 mm is 3.78 px"}));
        }
    }

    PlaneStart collect() {
        PlaneStart start;
        start.choices = std::move(choices_);
        start.met = std::move(met_);
        start.in_host = host_ != nullptr && !fit_.empty();
        start.leaves_host = start.in_host && has_own_shapes_;
        start.to_host = to_host_;
        for (const Piece& piece : pieces_) add_to_start(start, piece);
        if (group_) {
            if (!tile_ && !is_rosette(*group_)) tile_ = tile_around(*group_, bounds(start.polygons));
            start.symmetry.emplace(*group_, tile_.value_or(Point{}));
        }
        return start;
    }

    void add_to_start(PlaneStart& start, const Piece& piece) const {
        if (piece.area.empty()) return;
        auto group = std::find_if(start.groups.begin(), start.groups.end(),
                                  [&](const StartGroup& known) { return known.tag == piece.tag; });
        if (group == start.groups.end()) {
            const Key first = first_pieces_.find(piece.tag)->second;
            start.groups.push_back({piece.tag, child(Key{hash_text("start group")}, first.value), {}});
            group = start.groups.end() - 1;
        }
        for (std::size_t i = 0; i < piece.area.size(); ++i) {
            if (area(piece.area[i]) < least_fragment && piece.area.size() > 1) continue;
            group->shapes.push_back({static_cast<std::uint32_t>(start.polygons.size()), child(piece.key, i)});
            start.polygons.add(piece.area[i]);
        }
    }

    const Settings& settings_;
    const Document& document_;
    const ShapeSource& shapes_;
    const DocumentSite& site_;
    const PolygonView* host_;
    PresetWalk walk_;
    ChoiceBuffer choices_;
    std::vector<std::uint32_t> met_;
    std::map<std::string, std::uint32_t> starts_of_tag_;
    std::map<std::string, Key> first_pieces_;  // of each tag
    bool has_own_shapes_ = false;              // a start is not host(...)
    std::optional<SymmetryGroup> group_;
    std::optional<Point> tile_;
    std::string fit_;  // of the starts by host(...); empty where there is none
    Transform to_host_;
    std::vector<Piece> pieces_;
    Diagnostics diagnostics_;
    std::size_t number_ = 0;
};

}  // namespace

Result<PlaneStart> make_plane_start(const Settings& settings, const Document& document, const ShapeSource& shapes,
                                    const DocumentSite& site, const PolygonView* host) {
    return StartBuilder(settings, document, shapes, site, host).build();
}

Transform page_onto(const Page& page, const Box& box, std::string_view fit) {
    if (fit == "keep") return {};
    const Vec low = to_px(box.min), high = to_px(box.max);
    const double across = (high.x - low.x) / page.width, down = (high.y - low.y) / page.height;
    double x = across, y = down;
    if (fit == "cover") x = y = std::max(across, down);
    if (fit == "contain") x = y = std::min(across, down);
    Transform onto = scaling(x, y);
    const Vec centre = 0.5 * (low + high);
    onto.e = centre.x;
    onto.f = centre.y;
    return onto;
}

}  // namespace filigree
