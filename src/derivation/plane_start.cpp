#include "derivation/plane_start.h"

#include <algorithm>
#include <limits>
#include <map>

#include "base/unicode.h"
#include "derivation/start_shapes.h"
#include "formats/svg_read.h"
#include "language/bind.h"
#include "plane/clean.h"
#include "plane/path.h"

namespace filigree {
namespace {

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

bool has_id(const SvgShape& shape, std::string_view id) {
    return shape.id == id || std::find(shape.groups.begin(), shape.groups.end(), id) != shape.groups.end();
}

Diagnostic no_such_id(const std::string& file, const std::string& id, const SvgPicture& picture) {
    std::vector<std::string_view> known;
    for (const SvgShape& shape : picture.shapes) {
        if (!shape.id.empty()) known.push_back(shape.id);
        for (const std::string& group : shape.groups) {
            if (!group.empty()) known.push_back(group);
        }
    }
    return error("start.unknown-id", "'" + file + "' has no drawn element with the id '" + id + "'", {},
                 did_you_mean(id, known));
}

// The shapes of a picture to grow from: the filled ones; where nothing is filled, the outlines, which must be closed.
Result<std::vector<const SvgShape*>> chosen_shapes(const SvgPicture& picture, const std::string& file,
                                                   const std::string& id) {
    std::vector<const SvgShape*> named, filled;
    for (const SvgShape& shape : picture.shapes) {
        if (!id.empty() && !has_id(shape, id)) continue;
        named.push_back(&shape);
        if (shape.filled) filled.push_back(&shape);
    }
    if (named.empty() && !id.empty()) return no_such_id(file, id, picture);
    if (!filled.empty()) return filled;
    for (const SvgShape* shape : named) {
        const std::string what =
            shape->id.empty() ? "'" + file + "'" : "the element '" + shape->id + "' of '" + file + "'";
        if (auto open = open_subpath(flatten(shape->path, 1), what)) return *open;
    }
    return named;
}

Result<SvgPicture> picture_of(const Inputs& inputs, const std::string& name, SourceSpan span) {
    const Input* input = find_input(inputs, name);
    if (input == nullptr) {
        return error("input.missing", "the file '" + name + "' cannot be read", span,
                     {"files are looked up beside the document"});
    }
    Result<SvgPicture> picture = read_svg(input->bytes, SourceSpan::no_file);
    if (picture) return picture;
    Diagnostics reasons;
    for (Diagnostic reason : picture.diagnostics()) {
        const auto size = static_cast<std::uint32_t>(input->bytes.size());
        const LineColumn place = line_column(input->bytes, std::min(reason.span.begin, size));
        reason.message = "in '" + name + "', line " + std::to_string(place.line) + ": " + reason.message;
        reason.span = span;
        reasons.push_back(std::move(reason));
    }
    return reasons;
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
    StartBuilder(const Settings& settings, const Document& document, const Inputs& inputs, const DocumentSite& site,
                 const PolygonView* host)
        : settings_(settings), document_(document), inputs_(inputs), site_(site), host_(host) {}

    Result<PlaneStart> build() {
        walk_ = begin_walk(site_, document_, settings_.globals, settings_.seed);
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
        const auto add_piece = [&](const std::vector<Polyline>& outlines, FillRule rule) {
            return add_to(pieces, outlines, rule, start.tag.text, key, number, whole);
        };
        const std::string_view name = arguments.description->name;
        if (name == "file") {
            const std::string file = std::get<std::string>(arguments.value("name").data);
            const std::string id = std::get<std::string>(arguments.value("id").data);
            const Result<SvgPicture> picture = picture_of(inputs_, file, whole);
            if (!picture) return refuse(picture.diagnostics(), whole);
            for (const Diagnostic& note : picture.diagnostics()) {
                diagnostics_.push_back(warning(note.code, "in '" + file + "': " + note.message, whole, note.hints));
            }
            const auto shapes = chosen_shapes(*picture, file, id);
            if (!shapes) return refuse(shapes.diagnostics(), whole);
            const Transform to_size = scaled_to_width(*shapes, arguments.number("width"));
            for (const SvgShape* shape : *shapes) {
                if (!add_piece(flatten(transformed(shape->path, to_size), settings_.resolution), shape->fill_rule))
                    return;
            }
        } else if (name == "path") {
            const Result<Path> path = parse_path_data(std::get<std::string>(arguments.value("data").data));
            if (!path) {
                Diagnostic reason = path.diagnostics().front();
                reason.message += " (byte " + std::to_string(reason.span.begin + 1) + " of the path data)";
                reason.span = whole;
                diagnostics_.push_back(std::move(reason));
                return;
            }
            const double scale = arguments.number("scale");
            const std::vector<Polyline> outlines =
                flatten(transformed(*path, scaling(scale, scale)), settings_.resolution);
            if (auto open = open_subpath(outlines, "the start")) return refuse({*open}, whole);
            if (!add_piece(outlines, FillRule::even_odd)) return;
        } else if (name == "host") {
            if (!set_fit(std::string(arguments.word("fit")), whole)) return;
            pieces.push_back({host_area(), start.tag.text, child(key, 0), number});
            accept(std::move(pieces), overlap, whole);
            return;
        } else {
            std::vector<Polyline> outlines = built_in_outline(arguments, settings_.resolution);
            const Vec at = std::get<Vec>(arguments.value("at").data);
            for (Polyline& outline : outlines) {
                for (Vec& point : outline.points) point = point + at;
            }
            if (!add_piece(outlines, FillRule::nonzero)) return;
        }
        accept_own(std::move(pieces), overlap, whole);
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

    static Transform scaled_to_width(const std::vector<const SvgShape*>& shapes, double width) {
        if (width <= 0) return {};
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const SvgShape* shape : shapes) {
            for (const Polyline& line : flatten(shape->path, 0.1)) {
                for (const Vec& point : line.points) {
                    low = std::min(low, point.x);
                    high = std::max(high, point.x);
                }
            }
        }
        if (!(high > low)) return {};
        return scaling(width / (high - low), width / (high - low));
    }

    void add_picture_layers(const Name& file, Key key, std::size_t number) {
        const Result<SvgPicture> picture = picture_of(inputs_, file.text, file.span);
        if (!picture) return refuse(picture.diagnostics(), file.span);
        const auto shapes = chosen_shapes(*picture, file.text, "");
        if (!shapes) return refuse(shapes.diagnostics(), file.span);
        std::vector<Piece> pieces;
        for (const SvgShape* shape : *shapes) {
            const std::string& layer = !shape->groups.empty() ? shape->groups.front() : shape->id;
            if (layer.empty()) {
                diagnostics_.push_back(error(
                    "start.unnamed-shape", "'" + file.text + "' has a shape without an id or a layer", file.span,
                    {"give it an id, or grow from the whole file by: start big_poly = file(\"" + file.text + "\")"}));
                return;
            }
            if (!add_to(pieces, flatten(shape->path, settings_.resolution), shape->fill_rule, as_tag(layer), key,
                        number, file.span))
                return;
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
                if (area(intersect(earlier.area, piece.area)) <= 0) continue;
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
                    earlier.area = subtract(earlier.area, piece.area);
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
        for (const Piece& piece : pieces_) {
            if (piece.area.empty()) continue;
            auto group = std::find_if(start.groups.begin(), start.groups.end(),
                                      [&](const StartGroup& known) { return known.tag == piece.tag; });
            if (group == start.groups.end()) {
                const Key first = first_pieces_.find(piece.tag)->second;
                start.groups.push_back({piece.tag, child(Key{hash_text("start group")}, first.value), {}});
                group = start.groups.end() - 1;
            }
            for (std::size_t i = 0; i < piece.area.size(); ++i) {
                group->shapes.push_back({static_cast<std::uint32_t>(start.polygons.size()), child(piece.key, i)});
                start.polygons.add(piece.area[i]);
            }
        }
        return start;
    }

    const Settings& settings_;
    const Document& document_;
    const Inputs& inputs_;
    const DocumentSite& site_;
    const PolygonView* host_;
    PresetWalk walk_;
    ChoiceBuffer choices_;
    std::vector<std::uint32_t> met_;
    std::map<std::string, std::uint32_t> starts_of_tag_;
    std::map<std::string, Key> first_pieces_;  // of each tag
    bool has_own_shapes_ = false;              // a start is not host(...)
    std::string fit_;                          // of the starts by host(...); empty where there is none
    Transform to_host_;
    std::vector<Piece> pieces_;
    Diagnostics diagnostics_;
    std::size_t number_ = 0;
};

}  // namespace

Result<PlaneStart> make_plane_start(const Settings& settings, const Document& document, const Inputs& inputs,
                                    const DocumentSite& site, const PolygonView* host) {
    return StartBuilder(settings, document, inputs, site, host).build();
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

std::vector<Name> start_files(const Document& document) {
    std::vector<Name> files;
    const auto add = [&](const std::string& name, SourceSpan span) {
        const bool known = std::any_of(files.begin(), files.end(), [&](const Name& file) { return file.text == name; });
        if (!known) files.push_back({name, span});
    };
    for (const Statement& statement : document.statements) {
        const auto* start = std::get_if<StartStatement>(&statement.node);
        if (start == nullptr) continue;
        if (start->from) add(start->from->text, start->from->span);
        const auto* call = start->value ? std::get_if<CallExpression>(&start->value->node) : nullptr;
        if (call == nullptr || call->name != "file") continue;
        for (const CallArgument& argument : call->arguments) {
            const auto* key = argument.key ? std::get_if<NameReference>(&argument.key->node) : nullptr;
            if (argument.key && (key == nullptr || key->name != "name")) continue;
            if (const auto* text = std::get_if<TextLiteral>(&argument.value->node))
                add(text->text, argument.value->span);
            break;
        }
    }
    return files;
}

}  // namespace filigree
