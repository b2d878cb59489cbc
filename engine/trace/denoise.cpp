#include "trace/denoise.hpp"

#include "core/check.hpp"
#include "trace/denoise_kernel.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::trace {
namespace {

/// Noise is estimated over boxes of so many pixels beside the pixel's own.
constexpr int kNoiseReach = 5;
/// What of the noise is left in the colours that guide the second pass.
constexpr float kNoiseLeft = 0.1F;
constexpr float kFirstColourScale = 0.6F, kSecondColourScale = 0.6F;
constexpr float kFeatureScale = 0.8F;
constexpr float kGuideFloor = 2e-6F;

/// A plane of floats with a margin on all sides.
class Plane {
  public:
    Plane(int width, int height)
        : width_(width),
          height_(height),
          stride_(width + 2 * kMargin),
          values_(static_cast<std::size_t>(stride_) * (height + 2 * kMargin)) {}

    std::ptrdiff_t stride() const { return stride_; }
    float* start() { return values_.data() + kMargin * stride_ + kMargin; }
    const float* start() const { return values_.data() + kMargin * stride_ + kMargin; }
    float& at(int x, int y) { return start()[y * stride_ + x]; }
    float at(int x, int y) const { return start()[y * stride_ + x]; }

    /// Copies the pixels at the edges into the margin.
    void fill_margin() {
        for (int y = -kMargin; y < height_ + kMargin; ++y) {
            const int from = std::clamp(y, 0, height_ - 1);
            for (int x = -kMargin; x < width_ + kMargin; ++x)
                at(x, y) = at(std::clamp(x, 0, width_ - 1), from);
        }
    }

  private:
    int width_, height_;
    std::ptrdiff_t stride_;
    std::vector<float> values_;
};

/// A quantity's channels and the variance of their means.
struct Layer {
    std::vector<Plane> means, noise;
};

/// The least of the means over four boxes that have the pixel in a corner: beside an edge the noise of
/// the pixel's own side counts.
void smooth_noise(Plane& noise, int width, int height) {
    // sums.at(x, y): over all pixels above and to the left, those of its row and column among them.
    std::vector<double> sums(static_cast<std::size_t>(width + 1) * (height + 1), 0.0);
    const auto sum_at = [&](int x, int y) -> double& {
        return sums[static_cast<std::size_t>(y) * (width + 1) + x];
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            sum_at(x + 1, y + 1) = noise.at(x, y) + sum_at(x, y + 1) + sum_at(x + 1, y) - sum_at(x, y);
    const auto mean = [&](int left, int top, int right, int bottom) {
        left = std::max(left, 0), top = std::max(top, 0);
        right = std::min(right + 1, width), bottom = std::min(bottom + 1, height);
        const double sum =
            sum_at(right, bottom) - sum_at(left, bottom) - sum_at(right, top) + sum_at(left, top);
        return static_cast<float>(std::max(0.0, sum) / ((right - left) * (bottom - top)));
    };
    constexpr int r = kNoiseReach;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            noise.at(x, y) = std::min({mean(x - r, y - r, x, y), mean(x, y - r, x + r, y),
                                       mean(x - r, y, x, y + r), mean(x, y, x + r, y + r)});
    noise.fill_margin();
}

/// channel(half, pixel, k): what the even (0) or odd (1) half says. One noise for all channels where
/// `shared`.
template <class Channel>
Layer layer_of(int width, int height, int channels, bool shared, const Channel& channel) {
    Layer layer;
    for (int k = 0; k < channels; ++k)
        layer.means.emplace_back(width, height);
    for (int k = 0; k < (shared ? 1 : channels); ++k)
        layer.noise.emplace_back(width, height);
    const float share = shared ? 1.0F / static_cast<float>(channels) : 1.0F;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
            for (int k = 0; k < channels; ++k) {
                const float even = channel(0, pixel, k), odd = channel(1, pixel, k);
                const float half = 0.5F * (even - odd);
                layer.means[k].at(x, y) = 0.5F * (even + odd);
                layer.noise[shared ? 0 : k].at(x, y) += share * half * half;
            }
        }
    for (Plane& plane : layer.means)
        plane.fill_margin();
    for (Plane& plane : layer.noise)
        smooth_noise(plane, width, height);
    return layer;
}

class Denoiser {
  public:
    Denoiser(const NoisyPicture& noisy, core::ThreadPool& pool)
        : pool_(pool),
          width_(noisy.even.width),
          height_(noisy.even.height),
          feature_count_(noisy.even_features.empty() ? 0 : kFeatures),
          // Square roots: the noise of light then depends little on its brightness.
          colours_(layer_of(width_, height_, kColours, true,
                            [&](int half, std::size_t pixel, int k) {
                                const Picture& picture = half == 0 ? noisy.even : noisy.odd;
                                return std::sqrt(std::max(picture.rgb[3 * pixel + k], 0.0F));
                            })),
          features_(
              layer_of(width_, height_, feature_count_, false, [&](int half, std::size_t pixel, int k) {
                  const auto& values = half == 0 ? noisy.even_features : noisy.odd_features;
                  return values[kFeatures * pixel + k];
              })) {}

    Picture picture() {
        std::vector<Plane> first = averaged(first_job(), kColours + feature_count_);
        for (Plane& plane : first)
            plane.fill_margin();
        scale_noise(kNoiseLeft);
        AverageJob job = first_job();
        job.colour_scale = kSecondColourScale;
        for (int k = 0; k < kColours; ++k)
            job.guide[k] = first[k].start();
        for (int k = 0; k < feature_count_; ++k)
            job.features[k] = first[kColours + k].start();
        const std::vector<Plane> second = averaged(job, kColours);
        Picture result(width_, height_);
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x)
                for (int k = 0; k < kColours; ++k) {
                    const float root = second[k].at(x, y);
                    result.rgb[3 * (static_cast<std::size_t>(y) * width_ + x) + k] = root * root;
                }
        return result;
    }

  private:
    AverageJob first_job() const {
        AverageJob job{};
        job.width = width_;
        job.height = height_;
        job.stride = colours_.means[0].stride();
        job.guide_noise = colours_.noise[0].start();
        job.feature_count = feature_count_;
        job.colour_scale = kFirstColourScale;
        job.feature_scale = kFeatureScale;
        job.guide_floor = kGuideFloor;
        for (int k = 0; k < kColours; ++k)
            job.guide[k] = job.in[k] = colours_.means[k].start();
        for (int k = 0; k < feature_count_; ++k) {
            job.features[k] = job.in[kColours + k] = features_.means[k].start();
            job.feature_noise[k] = features_.noise[k].start();
        }
        return job;
    }

    void scale_noise(float share) {
        for (Layer* layer : {&colours_, &features_})
            for (Plane& plane : layer->noise)
                for (int y = -kMargin; y < height_ + kMargin; ++y)
                    for (int x = -kMargin; x < width_ + kMargin; ++x)
                        plane.at(x, y) *= share;
    }

    std::vector<Plane> averaged(AverageJob job, int channels) {
        std::vector<Plane> out(static_cast<std::size_t>(channels), Plane(width_, height_));
        job.averaged = channels;
        for (int k = 0; k < channels; ++k)
            job.out[k] = out[k].start();
        const auto& kernels = core::kernels<DenoiseKernels>();
        std::vector<std::vector<float>> scratch(pool_.thread_count());
        pool_.run((height_ + kBandRows - 1) / kBandRows, [&](std::size_t band, int worker) {
            scratch[worker].resize(average_scratch(width_));
            AverageJob part = job;
            part.first_row = static_cast<int>(band) * kBandRows;
            part.last_row = std::min(part.first_row + kBandRows, height_);
            kernels.average_rows(part, scratch[worker].data());
        });
        return out;
    }

    core::ThreadPool& pool_;
    int width_, height_, feature_count_;
    Layer colours_, features_;
};

}  // namespace

Picture denoise(const NoisyPicture& noisy, core::ThreadPool& pool) {
    PASTOSO_CHECK_OP(noisy.even.width, ==, noisy.odd.width);
    PASTOSO_CHECK_OP(noisy.even.height, ==, noisy.odd.height);
    PASTOSO_CHECK_OP(noisy.even.rgb.size(), ==, noisy.odd.rgb.size());
    PASTOSO_CHECK_OP(noisy.even_features.size(), ==, noisy.odd_features.size());
    if (noisy.even.rgb.empty()) return noisy.even;
    return Denoiser(noisy, pool).picture();
}

}  // namespace pastoso::trace
