#include "tank/liquid_volume.hpp"

#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <array>

namespace pastoso::tank {
namespace {

/// Values at the corners of a box, x first.
using Corners = std::array<double, 8>;

/// The share of a tetrahedron where a linear function of these values at its corners is negative.
double share_of_tetrahedron(std::array<double, 4> values) {
    std::sort(values.begin(), values.end());
    const auto [a, b, c, d] = values;
    if (a >= 0.0) return 0.0;
    if (d < 0.0) return 1.0;
    if (b >= 0.0) return a * a * a / ((a - b) * (a - c) * (a - d));
    if (c < 0.0) return 1.0 - d * d * d / ((d - a) * (d - b) * (d - c));
    // The wedge around the edge from a to b: its corners divide the four other edges.
    const double ac = a / (a - c), ad = a / (a - d), bc = b / (b - c), bd = b / (b - d);
    return ac * ad + bc * bd * (1.0 - ad) + bc * ad * (1.0 - ac);
}

/// Of a box, as six tetrahedra around its diagonal.
double share_of_box(const Corners& v) {
    constexpr int kSteps[6][2] = {{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}};
    double sum = 0.0;
    for (const auto& [first, second] : kSteps)
        sum += share_of_tetrahedron(
            {v[0], v[static_cast<std::size_t>(first)], v[static_cast<std::size_t>(second)], v[7]});
    return sum / 6.0;
}

/// What of the volume between two neighbouring middles lies in the box: all but outside the first and
/// last.
struct Span {
    double begin = 0.0, end = 1.0;
    double length() const { return end - begin; }
};
Span inside(int lower, int cells) {
    return {lower < 0 ? 0.5 : 0.0, lower == cells - 1 ? 0.5 : 1.0};
}

/// Cuts corners' values down to a part along one axis.
void cut(Corners& corners, std::size_t step, const Span& span) {
    for (std::size_t corner = 0; corner < 8; ++corner) {
        if ((corner & step) != 0) continue;
        const double low = corners[corner], rise = corners[corner + step] - low;
        corners[corner] = low + span.begin * rise;
        corners[corner + step] = low + span.end * rise;
    }
}

}  // namespace

double liquid_volume_m3(const grid::BoxField& phi, core::ThreadPool& pool) {
    const grid::BoxShape& shape = phi.shape();
    const std::ptrdiff_t y = shape.stride_y(), z = shape.stride_z();
    const double cells = liquid::sum_over_slices(pool, shape.nz + 1, [&](int slice) {
        const int k = slice - 1;
        const Span in_z = inside(k, shape.nz);
        double sum = 0.0;
        for (int j = -1; j < shape.ny; ++j) {
            const Span in_y = inside(j, shape.ny);
            const float* row = phi.row(j, k);
            for (int i = -1; i < shape.nx; ++i) {
                const float* at = row + i;
                const float values[8] = {at[0], at[1],     at[y],     at[1 + y],
                                         at[z], at[1 + z], at[y + z], at[1 + y + z]};
                int negative = 0;
                for (const float value : values)
                    negative += value < 0.0F ? 1 : 0;
                if (negative == 0) continue;
                const Span in_x = inside(i, shape.nx);
                const double volume = in_x.length() * in_y.length() * in_z.length();
                if (negative == 8) {
                    sum += volume;
                    continue;
                }
                Corners corners;
                std::copy(std::begin(values), std::end(values), corners.begin());
                cut(corners, 1, in_x);
                cut(corners, 2, in_y);
                cut(corners, 4, in_z);
                sum += volume * share_of_box(corners);
            }
        }
        return sum;
    });
    return cells * shape.cell_volume_m3();
}

}  // namespace pastoso::tank
