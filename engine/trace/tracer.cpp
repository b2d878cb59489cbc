#include "trace/tracer.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "trace/camera_rays.hpp"
#include "trace/denoise.hpp"
#include "trace/path.hpp"
#include "trace/photons.hpp"
#include "trace/stoppable.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pastoso::trace {
namespace {

constexpr int kTile = 16;
constexpr int kLongestSide = 16384;

/// From so many samples on, a tile is looked at after every so many more: once it is clean enough it
/// gets no others.
constexpr int kFewestSamples = 16, kSamplesBetweenLooks = 8;
/// The error of a clean tile's pixels, root mean square, against their mean and what the eye takes for
/// black. The denoiser takes out most of it.
constexpr double kCleanError = 0.06, kBlack = 0.05;

/// What is summed for a pixel, over its samples of even or of odd number: linear colour and features.
constexpr int kSums = 3 + kFeatures;

void check_settings(const TraceSettings& settings) {
    for (const int side : {settings.width, settings.height})
        if (side < 1 || side > kLongestSide)
            throw core::InputError(
                "trace settings: a side of the picture is %1, but must be from 1 to 16384 pixels.",
                side);
    if (!(settings.brightest > 0.0F && settings.brightest < 1e30F))
        throw core::InputError("trace settings: brightest is %1, but must be above 0 and finite.",
                               std::to_string(settings.brightest));
    if (settings.most_events < 1)
        throw core::InputError("trace settings: most_events is %1, but must be at least 1.",
                               settings.most_events);
}

const Scene& checked(const Scene& scene, const TraceSettings& settings) {
    check_scene(scene);
    check_settings(settings);
    return scene;
}

}  // namespace

struct PathTracer::State {
    State(const Scene& scene, const TraceSettings& trace_settings, core::ThreadPool& threads)
        : settings(trace_settings),
          pool(threads),
          world(checked(scene, trace_settings)),
          camera(scene.camera, settings.width, settings.height),
          tiles_across((settings.width + kTile - 1) / kTile),
          tile_samples(static_cast<std::size_t>(tiles_across) *
                           static_cast<std::size_t>((settings.height + kTile - 1) / kTile),
                       0),
          tile_wanted(tile_samples.size(), 0),
          tile_rays(tile_samples.size(), 0) {
        const std::size_t pixels =
            static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
        for (auto& half : sums)
            half.assign(pixels * kSums, 0.0F);
    }

    std::size_t pixel_index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(settings.width) +
               static_cast<std::size_t>(x);
    }
    int samples_at(int x, int y) const { return tile_samples[x / kTile + y / kTile * tiles_across]; }

    template <class Body>
    void for_each_pixel(const Body& body) const {
        for (int y = 0; y < settings.height; ++y)
            for (int x = 0; x < settings.width; ++x)
                body(x, y);
    }

    void add_sample(int x, int y, int sample, std::uint64_t& rays) {
        const std::size_t pixel = pixel_index(x, y);
        Sampler sampler(settings.seed, static_cast<std::uint32_t>(pixel),
                        static_cast<std::uint32_t>(sample));
        const Ray ray = camera.through(x, y, sampler);
        PathResult path = follow_path({world, settings, maps}, ray, sampler, rays);
        const float brightness = largest(path.radiance);
        if (brightness > settings.brightest) path.radiance *= settings.brightest / brightness;
        float* sum = sums[sample & 1].data() + pixel * kSums;
        for (int channel = 0; channel < 3; ++channel)
            sum[channel] += path.radiance[channel];
        for (int feature = 0; feature < kFeatures; ++feature)
            sum[3 + feature] += path.features[feature];
    }

    /// False when stopped.
    bool shoot(const std::function<bool()>& stop) {
        if (has_maps || !settings.seeks_lamp) return true;
        std::optional<PhotonMaps> shot = shoot_photons(world, settings, pool, stop);
        if (!shot) return false;
        maps = std::move(*shot);
        has_maps = true;
        return true;
    }

    template <class Body>
    void for_tile(std::size_t tile, const Body& body) const {
        const int left = static_cast<int>(tile) % tiles_across * kTile;
        const int top = static_cast<int>(tile) / tiles_across * kTile;
        for (int y = top; y < std::min(top + kTile, settings.height); ++y)
            for (int x = left; x < std::min(left + kTile, settings.width); ++x)
                body(x, y);
    }

    /// Brings a tile to `wanted` samples, or to where it is clean; each pixel's are added in the order
    /// of their numbers.
    void bring_tile(std::size_t tile, int wanted) {
        std::uint64_t rays = 0;
        int& taken = tile_samples[tile];
        while (taken < wanted && !is_clean(tile)) {
            const int next = std::min(wanted, (taken / kSamplesBetweenLooks + 1) * kSamplesBetweenLooks);
            for_tile(tile, [&](int x, int y) {
                for (int sample = taken; sample < next; ++sample)
                    add_sample(x, y, sample, rays);
            });
            taken = next;
        }
        tile_wanted[tile] = std::max(tile_wanted[tile], wanted);
        tile_rays[tile] += rays;
    }

    /// The halves of a pixel's samples differ by twice the error of its mean, on the average.
    bool is_clean(std::size_t tile) const {
        const int taken = tile_samples[tile];
        if (taken < kFewestSamples || taken % kSamplesBetweenLooks != 0) return false;
        double squares = 0.0, sum = 0.0;
        int pixels = 0;
        for_tile(tile, [&](int x, int y) {
            const std::size_t at = pixel_index(x, y) * kSums;
            const auto brightness = [&](int half) {
                const float* rgb = sums[half].data() + at;
                return static_cast<double>(rgb[0] + rgb[1] + rgb[2]) / 3.0;
            };
            const double difference = brightness(0) - brightness(1);
            squares += difference * difference;
            sum += brightness(0) + brightness(1);
            ++pixels;
        });
        const double error = std::sqrt(squares / pixels) / taken, mean = sum / (taken * pixels);
        return error < kCleanError * (mean + kBlack);
    }

    /// The mean over the even or the odd samples; with one sample alone, both are that one.
    void mean_half(int half, Picture& picture, std::vector<float>& features) const {
        picture = Picture(settings.width, settings.height);
        features.resize(picture.rgb.size() / 3 * kFeatures);
        for_each_pixel([&](int x, int y) {
            const int samples = samples_at(x, y);
            const int used = samples == 1 ? 0 : half;
            const int count = (samples + 1 - used) / 2;
            const std::size_t pixel = pixel_index(x, y);
            const float* sum = sums[used].data() + pixel * kSums;
            const float share = count > 0 ? 1.0F / static_cast<float>(count) : 0.0F;
            for (int channel = 0; channel < 3; ++channel)
                picture.rgb[3 * pixel + channel] = sum[channel] * share;
            for (int feature = 0; feature < kFeatures; ++feature)
                features[kFeatures * pixel + feature] = sum[3 + feature] * share;
        });
    }

    TraceSettings settings;
    core::ThreadPool& pool;
    World world;
    PhotonMaps maps;
    bool has_maps = false;
    CameraRays camera;
    int tiles_across;
    std::vector<int> tile_samples;  ///< of each pixel of a tile
    std::vector<int> tile_wanted;   ///< the same, had none been clean before
    std::vector<std::uint64_t> tile_rays;
    std::vector<float> sums[2];
};

PathTracer::PathTracer(const Scene& scene, const TraceSettings& settings, core::ThreadPool& pool)
    : state_(std::make_unique<State>(scene, settings, pool)) {}
PathTracer::~PathTracer() = default;
PathTracer::PathTracer(PathTracer&&) noexcept = default;
PathTracer& PathTracer::operator=(PathTracer&&) noexcept = default;

bool PathTracer::add_samples(int count, const std::function<bool()>& stop) {
    PASTOSO_CHECK_OP(count, >=, 0);
    if (!state_->shoot(stop)) return false;
    const int wanted = samples() + count;
    return run_until_stopped(state_->pool, state_->tile_samples.size(), stop,
                             [&](std::size_t tile) { state_->bring_tile(tile, wanted); });
}

int PathTracer::samples() const {
    return *std::min_element(state_->tile_wanted.begin(), state_->tile_wanted.end());
}

std::uint64_t PathTracer::rays() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t rays : state_->tile_rays)
        sum += rays;
    return sum;
}

Picture PathTracer::radiance() const {
    Picture picture(state_->settings.width, state_->settings.height);
    state_->for_each_pixel([&](int x, int y) {
        const int samples = state_->samples_at(x, y);
        const float share = samples > 0 ? 1.0F / static_cast<float>(samples) : 0.0F;
        const std::size_t pixel = state_->pixel_index(x, y);
        for (int channel = 0; channel < 3; ++channel)
            picture.rgb[3 * pixel + channel] =
                (state_->sums[0][pixel * kSums + channel] + state_->sums[1][pixel * kSums + channel]) *
                share;
    });
    return picture;
}

Picture PathTracer::denoised() const {
    NoisyPicture noisy;
    state_->mean_half(0, noisy.even, noisy.even_features);
    state_->mean_half(1, noisy.odd, noisy.odd_features);
    return denoise(noisy, state_->pool);
}

}  // namespace pastoso::trace
