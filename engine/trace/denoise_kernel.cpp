// Non-local means over a band of rows. For every shift within reach: the distance of each pixel to the
// shifted one in units of their noise, its mean over patches, the weight, and the weighted values.
#include "trace/denoise_kernel.hpp"

namespace pastoso::trace::PASTOSO_ISA {
namespace {

constexpr int kPatch = 2 * kPatchReach + 1;
constexpr float kPatchShare = 1.0F / (kPatch * kPatch);
/// Feature differences whose variance is below this do not count.
constexpr float kFeatureFloor = 1e-3F;

struct Scratch {
    float* distances;  ///< rows of the band and of the patches around it
    float* column_sums;
    float* weights;
    float* sums;  ///< planes of band rows
    std::ptrdiff_t row;
};

/// Squared differences less what noise alone would give, over the noise; pixels left - kPatchReach to
/// right + kPatchReach of row y against those shifted by `shift`.
void measure_row(const AverageJob& job, int y, std::ptrdiff_t shift, int left, int right,
                 float* __restrict out) {
    const std::ptrdiff_t start = y * job.stride;
    const float *r = job.guide[0] + start, *g = job.guide[1] + start, *b = job.guide[2] + start;
    const float *r2 = r + shift, *g2 = g + shift, *b2 = b + shift;
    const float *noise = job.guide_noise + start, *noise2 = noise + shift;
    const float scale = job.colour_scale, least = job.guide_floor;
    for (int x = left - kPatchReach; x < right + kPatchReach; ++x) {
        const float dr = r[x] - r2[x], dg = g[x] - g2[x], db = b[x] - b2[x];
        const float smaller = noise[x] < noise2[x] ? noise[x] : noise2[x];
        const float squares = (dr * dr + dg * dg + db * db) * (1.0F / 3.0F);
        out[x] = scale * (squares - noise[x] - smaller) / (noise[x] + noise2[x] + least);
    }
}

void sum_patch_rows(const Scratch& scratch, int band_row, int left, int right) {
    const float* d = scratch.distances + band_row * scratch.row;
    const std::ptrdiff_t row = scratch.row;
    static_assert(kPatch == 5);
    for (int x = left - kPatchReach; x < right + kPatchReach; ++x)
        scratch.column_sums[x] = d[x] + d[x + row] + d[x + 2 * row] + d[x + 3 * row] + d[x + 4 * row];
}

/// The largest of the patch's and the features' distances, as a weight that falls from 1 to 0 at 4.
void weigh_row(const AverageJob& job, int y, std::ptrdiff_t shift, int left, int right,
               const Scratch& scratch) {
    const float* c = scratch.column_sums;
    float* __restrict weights = scratch.weights;
    for (int x = left; x < right; ++x)
        weights[x] = (c[x - 2] + c[x - 1] + c[x] + c[x + 1] + c[x + 2]) * kPatchShare;
    for (int k = 0; k < job.feature_count; ++k) {
        const float *f = job.features[k] + y * job.stride, *f2 = f + shift;
        const float *noise = job.feature_noise[k] + y * job.stride, *noise2 = noise + shift;
        const float scale = job.feature_scale;
        for (int x = left; x < right; ++x) {
            const float d = f[x] - f2[x];
            const float smaller = noise[x] < noise2[x] ? noise[x] : noise2[x];
            const float distance =
                scale * (d * d - noise[x] - smaller) / (noise[x] + noise2[x] + kFeatureFloor);
            weights[x] = weights[x] > distance ? weights[x] : distance;
        }
    }
    for (int x = left; x < right; ++x) {
        const float distance = weights[x] > 0.0F ? weights[x] : 0.0F;
        const float near = 1.0F - 0.25F * distance;
        const float kept = near > 0.0F ? near : 0.0F;
        weights[x] = kept * kept * kept * kept;
    }
}

void add_row(const AverageJob& job, int y, std::ptrdiff_t shift, int left, int right,
             const Scratch& scratch, int band_row) {
    const float* weights = scratch.weights;
    const std::ptrdiff_t plane = scratch.row * kBandRows;
    float* sums = scratch.sums + band_row * scratch.row;
    for (int k = 0; k < job.averaged; ++k) {
        const float* in = job.in[k] + y * job.stride + shift;
        float* __restrict sum = sums + k * plane;
        for (int x = left; x < right; ++x)
            sum[x] += weights[x] * in[x];
    }
    float* __restrict sum = sums + kAveraged * plane;
    for (int x = left; x < right; ++x)
        sum[x] += weights[x];
}

void add_shift(const AverageJob& job, int dx, int dy, const Scratch& scratch) {
    // Rows and columns whose shifted ones lie in the picture.
    const int top = job.first_row + dy < 0 ? -dy : job.first_row;
    const int bottom = job.last_row + dy > job.height ? job.height - dy : job.last_row;
    const int left = dx < 0 ? -dx : 0, right = dx > 0 ? job.width - dx : job.width;
    if (top >= bottom || left >= right) return;
    const std::ptrdiff_t shift = dy * job.stride + dx;
    for (int y = top - kPatchReach; y < bottom + kPatchReach; ++y)
        measure_row(job, y, shift, left, right,
                    scratch.distances + (y - top + kPatchReach) * scratch.row);
    for (int y = top; y < bottom; ++y) {
        sum_patch_rows(scratch, y - top, left, right);
        weigh_row(job, y, shift, left, right, scratch);
        add_row(job, y, shift, left, right, scratch, y - job.first_row);
    }
}

}  // namespace

void average_rows(const AverageJob& job, float* memory) {
    Scratch scratch;
    scratch.row = job.width + 2 * kMargin;
    scratch.distances = memory + kMargin;
    scratch.column_sums = scratch.distances + (kBandRows + 2 * kPatchReach) * scratch.row;
    scratch.weights = scratch.column_sums + scratch.row;
    scratch.sums = scratch.weights + scratch.row;
    const std::ptrdiff_t plane = scratch.row * kBandRows;
    float* all = scratch.sums - kMargin;
    for (std::ptrdiff_t i = 0; i < plane * (kAveraged + 1); ++i)
        all[i] = 0.0F;
    for (int dy = -kReach; dy <= kReach; ++dy)
        for (int dx = -kReach; dx <= kReach; ++dx)
            add_shift(job, dx, dy, scratch);
    for (int k = 0; k < job.averaged; ++k)
        for (int y = job.first_row; y < job.last_row; ++y) {
            const std::ptrdiff_t at = (y - job.first_row) * scratch.row;
            const float* sum = scratch.sums + k * plane + at;
            const float* weight = scratch.sums + kAveraged * plane + at;
            float* out = job.out[k] + y * job.stride;
            for (int x = 0; x < job.width; ++x)
                out[x] = sum[x] / weight[x];
        }
}

}  // namespace pastoso::trace::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::trace, DenoiseKernels, average_rows)
