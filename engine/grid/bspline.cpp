#include "grid/bspline.hpp"

namespace pastoso::grid {

BsplineWeights bspline_weights(float t) {
    const float u = 1.0F - t;
    const float t2 = t * t;
    BsplineWeights weights{};
    weights.value = {u * u * u / 6.0F, (3.0F * t2 * t - 6.0F * t2 + 4.0F) / 6.0F,
                     (-3.0F * t2 * t + 3.0F * t2 + 3.0F * t + 1.0F) / 6.0F, t2 * t / 6.0F};
    weights.slope = {-0.5F * u * u, 0.5F * (3.0F * t2 - 4.0F * t), 0.5F * (-3.0F * t2 + 2.0F * t + 1.0F),
                     0.5F * t2};
    weights.bend = {u, 3.0F * t - 2.0F, 1.0F - 3.0F * t, t};
    return weights;
}

}  // namespace pastoso::grid
