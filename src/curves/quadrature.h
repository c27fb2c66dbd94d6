// Integrals over a parameter: Gauss's rule of five points.
#pragma once

#include <array>
#include <cstddef>

#include "curves/element.h"

namespace filigree::curves {

// Calls visit(t, weight) for places in an interval cut into equal parts; the integral is about the sum of the weights
// times the values there.
template <class Visit>
void for_each_gauss_place(Interval on, int parts, Visit visit) {
    constexpr std::array<double, 5> places = {0, -0.5384693101056831, 0.5384693101056831, -0.9061798459386640,
                                              0.9061798459386640};
    constexpr std::array<double, 5> weights = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                                               0.2369268850561891, 0.2369268850561891};
    const double half = 0.5 * (on.to - on.from) / parts;
    for (int part = 0; part < parts; ++part) {
        const double middle = on.from + half * (2 * part + 1);
        for (std::size_t i = 0; i < places.size(); ++i) visit(middle + half * places[i], half * weights[i]);
    }
}

}  // namespace filigree::curves
