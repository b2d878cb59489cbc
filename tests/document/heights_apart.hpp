// How much two supports differ.
#pragma once

#include "film/support/support.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::document {

/// The largest difference of two supports, which are of one shape, away from the edges.
inline double apart_mm(const film::SupportHeights& a, const film::SupportHeights& b) {
    constexpr int kEdge = 4;
    double apart = 0.0;
    for (int y = kEdge; y < a.shape().height - kEdge; ++y)
        for (int x = kEdge; x < a.shape().width - kEdge; ++x)
            apart = std::max<double>(apart, std::abs(a.at(x, y) - b.at(x, y)));
    return apart;
}

}  // namespace pastoso::document
