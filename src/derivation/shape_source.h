// What the forms of a document mean: the outlines of star(5, 20, 8), path("..."), file("leaf.svg", id: "vein"),
// and the pictures that image("photo.png") names.
//
// Starts, placed shapes, curves of splits and marks all come from here. Every answer is worked out once and kept, so
// that a file is read once however many steps use it; asking is safe from several threads.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/result.h"
#include "derivation/inputs.h"
#include "formats/svg_read.h"
#include "language/value.h"
#include "plane/clean.h"
#include "plane/grey_image.h"

namespace filigree {

// One shape of a form, such as a letter of a text: px, curves followed to the document's resolution.
struct ShapePart {
    std::vector<Polyline> lines;
    FillRule rule = FillRule::nonzero;
    bool filled = true;  // false: drawn by its stroke alone
    std::string name;    // an SVG element's id; else empty

    bool operator==(const ShapePart&) const = default;
};

struct ShapeOutlines {
    std::vector<Polyline> lines;
    FillRule rule = FillRule::nonzero;
};

class ShapeSource {
public:
    // `inputs` must outlive it; `resolution` in px.
    ShapeSource(const Inputs& inputs, double resolution);

    // The parts of a form of start_shape_descriptions() (start_shapes.h) but host, converted by to_form. Of an SVG file
    // those that are filled; where none is, all. Warnings say what an SVG file holds that is not read.
    using Parts = std::shared_ptr<const std::vector<ShapePart>>;
    Result<Parts> parts(const SymbolicCall& shape) const;

    // The same as outlines of one area, fine enough to be enlarged: to a thousandth of its extent.
    Result<std::shared_ptr<const ShapeOutlines>> outlines(const SymbolicCall& shape) const;

    Result<std::shared_ptr<const SvgPicture>> picture(const std::string& file) const;
    // The same read as a drawing of strokes and labels (SvgPurpose).
    Result<std::shared_ptr<const SvgPicture>> drawing(const std::string& file) const;
    Result<std::shared_ptr<const GreyImage>> image(const std::string& file) const;

    // Differs where any file that could be asked for does.
    std::uint64_t fingerprint() const { return fingerprint_; }

private:
    template <class T>
    using Memo = std::map<std::string, Result<std::shared_ptr<const T>>>;

    Result<Parts> parts_at(const SymbolicCall& shape, double resolution) const;
    Result<std::shared_ptr<const SvgPicture>> read(const std::string& file, SvgPurpose purpose) const;
    template <class T, class Make>
    Result<std::shared_ptr<const T>> once(Memo<T>& memo, const std::string& key, Make make) const;

    const Inputs& inputs_;
    const double resolution_;
    std::uint64_t fingerprint_ = 0;
    mutable std::mutex mutex_;
    mutable Memo<std::vector<ShapePart>> parts_;
    mutable Memo<ShapeOutlines> outlines_;
    mutable Memo<SvgPicture> pictures_, drawings_;
    mutable Memo<GreyImage> images_;
};

}  // namespace filigree
