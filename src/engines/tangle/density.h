// How dense marks lie over a shape: the values of a `density` parameter, as functions of the place.
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "engines/tangle/operator.h"

namespace filigree::tangle {

// gradient(from, to, angle), radial(centre, border), image(name).
const std::vector<OperatorDescription>& density_forms();

struct DarknessSums;  // of a picture: what makes the mean of any rectangle cheap

// The densities of a step; pictures are read once.
class Densities {
public:
    // Of the form parameter `density`, laid over what the word parameter `over` says.
    static Result<Densities> of(const OperatorInput& input, std::string_view density, std::string_view over);

    // For one shape: 0 to 1 at a place; none where it is 1 everywhere. Of pictures it is the mean over about `blur` px.
    std::function<double(Vec)> at(std::size_t shape, PolygonView polygon, double blur) const;

private:
    struct One {
        Value value;
        std::shared_ptr<const DarknessSums> picture;
    };
    std::vector<One> all_;    // one where all shapes have the same
    std::vector<Box> boxes_;  // the same; empty: each shape's own
};

}  // namespace filigree::tangle
