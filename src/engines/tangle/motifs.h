// What an operator places or marks: the values of a `form` parameter as motifs, and which way each copy lies.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engines/tangle/operator.h"
#include "plane/edge_tree.h"
#include "plane/motif.h"

namespace filigree::tangle {

// The drawn motifs of a step, read once.
class DrawnMotifs {
public:
    // Of the form parameter `form`, for copies up to the `size` parameter's value. An error where a form cannot be
    // read or encloses nothing.
    static Result<DrawnMotifs> of(const OperatorInput& input, std::string_view form, std::string_view size);

    // Of a shape; null where its value is a word.
    const Motif* at(std::size_t shape) const { return motifs_.size() == 1 ? motifs_[0].get() : motifs_[shape].get(); }

private:
    std::vector<std::shared_ptr<const Motif>> motifs_;  // one where all shapes have the same
};

// Words of a `rotation` parameter beyond those of every direction.
//   random  each copy its own way; along  with the nearest border, which lies to the left
// towards((x, y)) is from the copy's place here.
Vec copy_direction(const Value& value, const Shape& shape, PolygonView polygon, const EdgeTree& border, Vec at,
                   std::uint64_t bits);
ParameterDescription rotation_parameter(std::string_view help, std::string_view default_text);

}  // namespace filigree::tangle
