#include "liquid_files/box_values.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::liquid_files {
namespace {

using grid::BoxShape;
using grid::kBoxGhosts;

/// From one sample to the last, along one axis.
struct Reach {
    int first, end;
    int count() const { return end - first; }
};

Reach reach(int cells, BoxSamples samples) {
    if (samples == BoxSamples::Cells) return {0, cells};
    return {-kBoxGhosts, cells + kBoxGhosts + 1};
}

/// Calls body(index of a row's first sample, samples of the row).
template <class Body>
void for_rows(const BoxShape& shape, BoxSamples samples, const Body& body) {
    const Reach x = reach(shape.nx, samples), y = reach(shape.ny, samples), z = reach(shape.nz, samples);
    for (int k = z.first; k < z.end; ++k)
        for (int j = y.first; j < y.end; ++j)
            body(shape.index(x.first, j, k), x.count());
}

}  // namespace

std::size_t sample_count(const BoxShape& shape, BoxSamples samples) {
    std::size_t count = 1;
    for (const int cells : {shape.nx, shape.ny, shape.nz})
        count *= static_cast<std::size_t>(reach(cells, samples).count());
    return count;
}

void add_field(files::PartFileWriter& file, const grid::BoxField& field, BoxSamples samples) {
    std::vector<float> values;
    values.reserve(sample_count(field.shape(), samples));
    for_rows(field.shape(), samples, [&](std::ptrdiff_t first, int count) {
        const float* row = field.values().data() + first;
        values.insert(values.end(), row, row + count);
    });
    file.add(values);
}

grid::BoxField next_field(files::PartFileReader& file, const BoxShape& shape, BoxSamples samples) {
    const std::vector<float> values = file.next<float>(sample_count(shape, samples));
    if (!std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); }))
        file.refuse("holds a value of a cell that is not finite.");
    grid::BoxField field(shape);
    const float* row = values.data();
    for_rows(shape, samples, [&](std::ptrdiff_t first, int count) {
        std::copy_n(row, count, field.values().data() + first);
        row += count;
    });
    return field;
}

}  // namespace pastoso::liquid_files
