// What the kernels of whole rows are told: plain numbers and pointers.
#pragma once

#include <cstddef>

namespace pastoso::liquid {

/// The faces of a row of cells: x[m] is the face before cell m, y[m] and z[m] those before it, y and z
/// strides apart.
struct FaceRows {
    const float *x, *y, *z;
    std::ptrdiff_t stride_y, stride_z;
};

/// new = here q + before (the value one stage earlier) + gain (Laplacian of q).
struct Stage {
    float here, before, gain;
};

/// Values of a row, those one y or z stride away among them.
struct DiffusedRow {
    const float* values;
    float* next;  ///< holds the values one stage earlier
    int count;
};

}  // namespace pastoso::liquid
