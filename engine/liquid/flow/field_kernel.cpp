// Loops over rows of fields: diffusion, divergence and gradient, sums. Compiled once per instruction
// set; see pastoso_add_kernels.
#include "liquid/flow/kernels.hpp"

namespace pastoso::liquid::PASTOSO_ISA {

// What these write overlaps nothing that they read but at m itself.

void diffuse_cells(const FaceRows& open, const Stage& stage, const DiffusedRow& row) {
    const std::ptrdiff_t y = open.stride_y, z = open.stride_z;
    const float *wx = open.x, *wy = open.y, *wz = open.z, *q = row.values;
    float* __restrict next = row.next;
#pragma GCC ivdep
    for (int m = 0; m < row.count; ++m) {
        const float here = q[m];
        const float gain = ((wx[m] * (q[m - 1] - here) + wx[m + 1] * (q[m + 1] - here)) +
                            (wy[m] * (q[m - y] - here) + wy[m + y] * (q[m + y] - here))) +
                           (wz[m] * (q[m - z] - here) + wz[m + z] * (q[m + z] - here));
        next[m] = (stage.here * here + stage.before * next[m]) + stage.gain * gain;
    }
}

void diffuse_faces(const float* open, std::ptrdiff_t y, std::ptrdiff_t z, bool sticks,
                   const Stage& stage, const DiffusedRow& row) {
    const float* q = row.values;
    float* __restrict next = row.next;
    const float slip = sticks ? 0.0F : 1.0F;
#pragma GCC ivdep
    for (int m = 0; m < row.count; ++m) {
        const float here = q[m], beyond_wall = slip * here;
        const auto beside = [&](std::ptrdiff_t n) {
            const float there = q[n];
            return open[n] > 0.0F ? there : beyond_wall;
        };
        const float sum = ((beside(m - 1) + beside(m + 1)) + (beside(m - y) + beside(m + y))) +
                          (beside(m - z) + beside(m + z));
        const float moved =
            (stage.here * here + stage.before * next[m]) + stage.gain * (sum - 6.0F * here);
        next[m] = open[m] > 0.0F ? moved : here;
    }
}

void compute_inflow(const FaceRows& open, const FaceRows& velocity, int count, float* out) {
    const std::ptrdiff_t y = open.stride_y, z = open.stride_z;
    const float *wx = open.x, *wy = open.y, *wz = open.z;
    const float *u = velocity.x, *v = velocity.y, *w = velocity.z;
    float* __restrict to = out;
#pragma GCC ivdep
    for (int m = 0; m < count; ++m)
        to[m] = ((wx[m] * u[m] - wx[m + 1] * u[m + 1]) + (wy[m] * v[m] - wy[m + y] * v[m + y])) +
                (wz[m] * w[m] - wz[m + z] * w[m + z]);
}

void subtract_gradient(const float* open, const float* pressure, std::ptrdiff_t stride, int count,
                       float* velocity) {
    float* __restrict u = velocity;
#pragma GCC ivdep
    for (int m = 0; m < count; ++m) {
        const float slower = u[m] - (pressure[m] - pressure[m - stride]);
        u[m] = open[m] > 0.0F ? slower : 0.0F;
    }
}

double sum_of_products(const float* a, const float* b, int count) {
    double lanes[kGroup] = {};
    int m = 0;
    for (; m + kGroup <= count; m += kGroup)
        for (int lane = 0; lane < kGroup; ++lane)
            lanes[lane] += static_cast<double>(a[m + lane] * b[m + lane]);
    for (int lane = 0; m < count; ++m, ++lane)
        lanes[lane] += static_cast<double>(a[m] * b[m]);
    return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) +
           ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}

}  // namespace pastoso::liquid::PASTOSO_ISA
