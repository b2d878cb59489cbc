#include "liquid/flow_cases.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::liquid::cases {

void fill_randomly(grid::BoxField& field, unsigned seed) {
    std::uint32_t index = 0;
    for (float& value : field.values())
        value = 2.0F * core::uniform_noise(index++, seed) - 1.0F;
}

VelocityField random_velocity(const grid::BoxShape& shape, unsigned seed) {
    VelocityField velocity(shape);
    for (const int axis : kAxes)
        fill_randomly(velocity.along(axis), seed + static_cast<unsigned>(axis));
    return velocity;
}

float largest_difference(const grid::BoxField& a, const grid::BoxField& b) {
    float largest = 0.0F;
    for (std::size_t n = 0; n < a.values().size(); ++n)
        largest = std::max(largest, std::abs(a.values()[n] - b.values()[n]));
    return largest;
}

}  // namespace pastoso::liquid::cases
