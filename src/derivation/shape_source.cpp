#include "derivation/shape_source.h"

#include <algorithm>
#include <limits>

#include "base/random.h"
#include "derivation/start_shapes.h"
#include "formats/font.h"
#include "formats/image_read.h"
#include "language/form_value.h"
#include "plane/silhouette.h"

namespace filigree {

namespace {

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

Diagnostic missing(const std::string& file) {
    return error("input.missing", "the file '" + file + "' cannot be read", {},
                 {"files are looked up beside the document"});
}

// Problems and warnings without a place in the file, told where it is used.
Diagnostics named(Diagnostics reasons, const std::string& file) {
    for (Diagnostic& reason : reasons) {
        reason.message = "in '" + file + "': " + reason.message;
        reason.span = {};
    }
    return reasons;
}

// Problems of a text file, told where it is used.
Diagnostics told_of(Diagnostics reasons, const Input& input) {
    for (Diagnostic& reason : reasons) {
        const auto size = static_cast<std::uint32_t>(input.bytes.size());
        const LineColumn place = line_column(input.bytes, std::min(reason.span.begin, size));
        reason.message = "in '" + input.name + "', line " + std::to_string(place.line) + ": " + reason.message;
        reason.span = {};
    }
    return reasons;
}

// The scale that gives polylines a width; 0 keeps theirs.
double scale_to_width(const std::vector<const SvgShape*>& shapes, double width) {
    if (width <= 0) return 1;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const SvgShape* shape : shapes) {
        for (const Polyline& line : flatten(shape->path, 0.1)) {
            for (const Vec& point : line.points) {
                low = std::min(low, point.x);
                high = std::max(high, point.x);
            }
        }
    }
    return high > low ? width / (high - low) : 1;
}

using PartList = std::vector<ShapePart>;
using Shared = Result<std::shared_ptr<const PartList>>;

Shared shared(PartList parts, Diagnostics warnings = {}) {
    return {std::make_shared<const PartList>(std::move(parts)), std::move(warnings)};
}

Shared path_parts(const SymbolicCall& shape, double resolution) {
    const Result<Path> path = parse_path_data(text_of(shape, "data"));
    if (!path) {
        Diagnostic reason = path.diagnostics().front();
        reason.message += " (byte " + std::to_string(reason.span.begin + 1) + " of the path data)";
        reason.span = {};
        return reason;
    }
    const double scale = number_of(shape, "scale");
    return shared({{flatten(transformed(*path, scaling(scale, scale)), resolution), FillRule::even_odd, true, {}}});
}

Shared file_parts(const SymbolicCall& shape, const SvgPicture& picture, double resolution) {
    const std::string& file = text_of(shape, "name");
    const std::string& id = text_of(shape, "id");
    std::vector<const SvgShape*> named, filled;
    for (const SvgShape& one : picture.shapes) {
        if (!id.empty() && !has_id(one, id)) continue;
        named.push_back(&one);
        if (one.filled) filled.push_back(&one);
    }
    if (named.empty() && !id.empty()) return no_such_id(file, id, picture);
    const std::vector<const SvgShape*>& chosen = filled.empty() ? named : filled;
    const double scale = scale_to_width(chosen, number_of(shape, "width"));
    PartList parts;
    for (const SvgShape* one : chosen) {
        const Path path = scale == 1 ? one->path : transformed(one->path, scaling(scale, scale));
        parts.push_back({flatten(path, resolution), one->fill_rule, one->filled, one->id});
    }
    return shared(std::move(parts));
}

struct Extent {
    double low_x = std::numeric_limits<double>::infinity(), low_y = low_x, high_x = -low_x, high_y = -low_x;
};
Extent box_of(const PartList& parts) {
    Extent box;
    for (const ShapePart& part : parts) {
        for (const Polyline& line : part.lines) {
            for (const Vec& point : line.points) {
                box.low_x = std::min(box.low_x, point.x);
                box.low_y = std::min(box.low_y, point.y);
                box.high_x = std::max(box.high_x, point.x);
                box.high_y = std::max(box.high_y, point.y);
            }
        }
    }
    return box;
}
double extent_of(const PartList& parts) {
    const Extent box = box_of(parts);
    return std::max(0.0, std::max(box.high_x - box.low_x, box.high_y - box.low_y));
}

// Moves parts so that the middle of their box comes to lie at a point.
void centre_at(PartList& parts, Vec at) {
    const Extent box = box_of(parts);
    if (!(box.high_x >= box.low_x)) return;
    const Vec shift = at - Vec{(box.low_x + box.high_x) / 2, (box.low_y + box.high_y) / 2};
    for (ShapePart& part : parts) {
        for (Polyline& line : part.lines) {
            for (Vec& point : line.points) point = point + shift;
        }
    }
}

Shared text_parts(const SymbolicCall& shape, const Inputs& inputs, double resolution) {
    const std::string& font = text_of(shape, "font");
    const Input* input = find_input(inputs, font);
    if (input == nullptr) return missing(font);
    TextOptions options;
    options.line_height = number_of(shape, "line_height");
    options.letter_spacing = number_of(shape, "spacing");
    const std::string_view align = word_of(shape, "align");
    options.align = align == "left" ? TextAlign::left : align == "right" ? TextAlign::right : TextAlign::centre;
    const auto glyphs = text_outlines(input->bytes, text_of(shape, "text"), number_of(shape, "size"), options);
    if (!glyphs) return named(glyphs.diagnostics(), font);
    PartList parts;
    for (const Glyph& glyph : *glyphs) {
        parts.push_back({flatten(glyph.path, resolution), FillRule::nonzero, true, glyph.text});
    }
    centre_at(parts, std::get<Vec>(argument_of(shape, "at").data));
    return shared(std::move(parts), named(glyphs.diagnostics(), font));
}

PartList image_parts(const SymbolicCall& shape, const GreyImage& image) {
    SilhouetteOptions options;
    options.threshold = number_of(shape, "threshold");
    options.least_area = number_of(shape, "specks");
    const bool light = std::get<bool>(argument_of(shape, "light").data);
    GreyImage negative;
    if (light) {
        negative = image;
        for (float& darkness : negative.darkness) darkness = 1 - darkness;
        options.threshold = 1 - options.threshold;
    }
    const double width = number_of(shape, "width");
    const double scale = width > 0 && image.width > 0 ? width / image.width : 1;
    PartList parts{{silhouette(light ? negative : image, options), FillRule::nonzero, true, {}}};
    for (Polyline& line : parts.front().lines) {
        for (Vec& point : line.points) point = scale * point;
    }
    centre_at(parts, std::get<Vec>(argument_of(shape, "at").data));
    return parts;
}

}  // namespace

ShapeSource::ShapeSource(const Inputs& inputs, double resolution) : inputs_(inputs), resolution_(resolution) {
    for (const Input& input : inputs) {
        fingerprint_ = fold(fold(fingerprint_, hash_text(input.name)), hash_text(input.bytes));
    }
}

template <class T, class Make>
Result<std::shared_ptr<const T>> ShapeSource::once(Memo<T>& memo, const std::string& key, Make make) const {
    {
        const std::lock_guard lock(mutex_);
        const auto known = memo.find(key);
        if (known != memo.end()) return known->second;
    }
    Result<std::shared_ptr<const T>> made = make();  // twice where two threads ask at once: the same, so harmless
    const std::lock_guard lock(mutex_);
    return memo.emplace(key, std::move(made)).first->second;
}

Result<ShapeSource::Parts> ShapeSource::parts(const SymbolicCall& shape) const {
    return once(parts_, to_text(Value{shape, {}}), [&] { return parts_at(shape, resolution_); });
}

Result<ShapeSource::Parts> ShapeSource::parts_at(const SymbolicCall& shape, double resolution) const {
    if (shape.name == "path") return path_parts(shape, resolution);
    if (shape.name == "text") return text_parts(shape, inputs_, resolution);
    if (shape.name == "image") {
        const auto found = image(text_of(shape, "name"));
        if (!found) return found.diagnostics();
        return shared(image_parts(shape, **found), found.diagnostics());
    }
    if (shape.name == "file") {
        const auto found = picture(text_of(shape, "name"));
        if (!found) return found.diagnostics();
        Shared parts = file_parts(shape, **found, resolution);
        if (!parts) return parts;
        return {*parts, found.diagnostics()};
    }
    return shared({{built_in_outline(shape, resolution), FillRule::nonzero, true, {}}});
}

Result<std::shared_ptr<const ShapeOutlines>> ShapeSource::outlines(const SymbolicCall& shape) const {
    using Outlines = Result<std::shared_ptr<const ShapeOutlines>>;
    return once(outlines_, to_text(Value{shape, {}}), [&]() -> Outlines {
        Result<Parts> found = parts(shape);
        if (!found) return found.diagnostics();
        const double fine = std::max(extent_of(**found) / 1000, 1e-4);
        if (fine < resolution_) found = parts_at(shape, fine);
        if (!found) return found.diagnostics();
        ShapeOutlines all;
        const bool one_rule = std::all_of((*found)->begin(), (*found)->end(),
                                          [&](const ShapePart& part) { return part.rule == (*found)->front().rule; });
        if (!(*found)->empty() && one_rule && ((*found)->size() == 1 || (*found)->front().rule == FillRule::nonzero)) {
            all.rule = (*found)->front().rule;
            for (const ShapePart& part : **found) {
                all.lines.insert(all.lines.end(), part.lines.begin(), part.lines.end());
            }
        } else {
            for (const ShapePart& part : **found) {
                const Polygons area = clean(part.lines, part.rule);
                for (std::size_t p = 0; p < area.size(); ++p) {
                    for (std::size_t r = 0; r < area[p].ring_count(); ++r) {
                        Polyline line{{}, true};
                        for (const Point& point : area[p].ring(r)) line.points.push_back(to_px(point));
                        all.lines.push_back(std::move(line));
                    }
                }
            }
        }
        return {std::make_shared<const ShapeOutlines>(std::move(all)), found.diagnostics()};
    });
}

Result<std::shared_ptr<const SvgPicture>> ShapeSource::picture(const std::string& file) const {
    return read(file, SvgPurpose::areas);
}
Result<std::shared_ptr<const SvgPicture>> ShapeSource::drawing(const std::string& file) const {
    return read(file, SvgPurpose::drawing);
}

Result<std::shared_ptr<const SvgPicture>> ShapeSource::read(const std::string& file, SvgPurpose purpose) const {
    auto& memo = purpose == SvgPurpose::areas ? pictures_ : drawings_;
    return once(memo, file, [&]() -> Result<std::shared_ptr<const SvgPicture>> {
        const Input* input = find_input(inputs_, file);
        if (input == nullptr) return missing(file);
        Result<SvgPicture> picture = read_svg(input->bytes, SourceSpan::no_file, purpose);
        if (!picture) return told_of(std::move(picture).diagnostics(), *input);
        Diagnostics notes = named(picture.diagnostics(), file);
        return {std::make_shared<const SvgPicture>(std::move(*picture)), std::move(notes)};
    });
}

Result<std::shared_ptr<const GreyImage>> ShapeSource::image(const std::string& file) const {
    return once(images_, file, [&]() -> Result<std::shared_ptr<const GreyImage>> {
        const Input* input = find_input(inputs_, file);
        if (input == nullptr) return missing(file);
        Result<GreyImage> image = read_image(input->bytes);
        if (!image) return named(image.diagnostics(), file);
        return {std::make_shared<const GreyImage>(std::move(*image)), named(image.diagnostics(), file)};
    });
}

}  // namespace filigree
