// A picture as one number a pixel: how dark it is. What half-tones, stippling and silhouettes go by.
#pragma once

#include <cstdint>
#include <vector>

namespace filigree {

struct GreyImage {
    std::uint32_t width = 0, height = 0;
    std::vector<float> darkness;  // 0 white or transparent .. 1 black; width * height of them, rows from the top

    bool operator==(const GreyImage&) const = default;
};

}  // namespace filigree
