#include "trace/tracer.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "trace/camera_rays.hpp"
#include "trace/denoise.hpp"
#include "trace/path.hpp"
#include "trace/photons.hpp"
#include "trace/stoppable.hpp"
#include "trace/tile_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pastoso::trace {
namespace {

constexpr int kLongestSide = 16384;

/// From so many samples on, a tile is looked at after every so many more: once it is clean enough it
/// gets no others.
constexpr int kFewestSamples = 16, kSamplesBetweenLooks = 8;
/// The error of a clean tile. The denoiser takes out most of it.
constexpr double kCleanError = 0.06;

/// A block that the outline of something passes, a glass's lip for example: the direction of the first
/// surface differs from pixel to pixel by so much, squared. The denoiser finds little like it around, so
/// that it gets samples besides after each look until its error is as small as that.
constexpr float kOutline = 0.1F;
constexpr double kOutlineError = 0.03;
constexpr int kOutlineSamples = 64, kMostOutlineRounds = 12;
static_assert(kOutlineSamples % 2 == 0);

/// What is summed for a pixel, over its samples of even or of odd number: linear colour and features.
constexpr int kSums = 3 + kFeatures;
/// The first of a direction's three.
constexpr int kDirectionSum = 6;

using BlockSamples = std::array<int, kBlocks>;

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
          outline_samples(tile_samples.size()),
          tile_wanted(tile_samples.size(), 0),
          is_clean(tile_samples.size(), 0),
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
    int samples_at(int x, int y) const {
        const int tile = x / kTile + y / kTile * tiles_across;
        return tile_samples[tile] + outline_samples[tile][block_of(x, y)];
    }

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
        while (taken < wanted && is_clean[tile] == 0) {
            const int next = std::min(wanted, (taken / kSamplesBetweenLooks + 1) * kSamplesBetweenLooks);
            for_tile(tile, [&](int x, int y) { add_samples(x, y, next - taken, rays); });
            taken = next;
            if (taken >= kFewestSamples && taken % kSamplesBetweenLooks == 0) look_at(tile, rays);
        }
        tile_wanted[tile] = std::max(tile_wanted[tile], wanted);
        tile_rays[tile] += rays;
    }

    void add_samples(int x, int y, int count, std::uint64_t& rays) {
        const int first = samples_at(x, y);
        for (int sample = first; sample < first + count; ++sample)
            add_sample(x, y, sample, rays);
    }

    /// Finds out whether a tile is clean, and adds to its outlines: once, or all they need where nobody
    /// looks again.
    void look_at(std::size_t tile, std::uint64_t& rays) {
        TileErrors errors = errors_of(tile);
        is_clean[tile] = errors.tile.error() < kCleanError ? 1 : 0;
        const int rounds = is_clean[tile] != 0 ? kMostOutlineRounds : 1;
        for (int round = 0; round < rounds && add_to_outlines(tile, errors, rays); ++round)
            errors = errors_of(tile);
    }

    /// Whether there was an outline that needed it.
    bool add_to_outlines(std::size_t tile, const TileErrors& errors, std::uint64_t& rays) {
        const BlockSamples more = missing_samples(tile, errors);
        for_tile(tile, [&](int x, int y) { add_samples(x, y, more[block_of(x, y)], rays); });
        for (int block = 0; block < kBlocks; ++block)
            outline_samples[tile][block] += more[block];
        return std::any_of(more.begin(), more.end(), [](int samples) { return samples > 0; });
    }

    BlockSamples missing_samples(std::size_t tile, const TileErrors& errors) const {
        BlockSamples missing{};
        for_tile(tile, [&](int x, int y) {
            const int block = block_of(x, y);
            const bool is_noisy = errors.blocks[block].error() > kOutlineError;
            if (is_noisy && (turns(tile, x, y, x + 1, y) || turns(tile, x, y, x, y + 1)))
                missing[block] = kOutlineSamples;
        });
        return missing;
    }

    /// Whether the direction of the first surface differs between two pixels of a tile.
    bool turns(std::size_t tile, int x, int y, int x2, int y2) const {
        if (x2 >= settings.width || y2 >= settings.height) return false;
        if (static_cast<std::size_t>(x2 / kTile + y2 / kTile * tiles_across) != tile) return false;
        const std::size_t at = pixel_index(x, y) * kSums, at2 = pixel_index(x2, y2) * kSums;
        const float share = 1.0F / static_cast<float>(samples_at(x, y));
        const float share2 = 1.0F / static_cast<float>(samples_at(x2, y2));
        float squares = 0.0F;
        for (int k = kDirectionSum; k < kDirectionSum + 3; ++k) {
            const float difference = share * (sums[0][at + k] + sums[1][at + k]) -
                                     share2 * (sums[0][at2 + k] + sums[1][at2 + k]);
            squares += difference * difference;
        }
        return squares > kOutline;
    }

    TileErrors errors_of(std::size_t tile) const {
        TileErrors errors;
        for_tile(tile, [&](int x, int y) {
            const std::size_t at = pixel_index(x, y) * kSums;
            const double share = 1.0 / (3.0 * samples_at(x, y));
            const auto brightness = [&](int half) {
                const float* rgb = sums[half].data() + at;
                return static_cast<double>(rgb[0] + rgb[1] + rgb[2]) * share;
            };
            const double even = brightness(0), odd = brightness(1);
            errors.tile.add(even, odd);
            errors.blocks[block_of(x, y)].add(even, odd);
        });
        return errors;
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
    std::vector<int> tile_samples;              ///< of each pixel of a tile
    std::vector<BlockSamples> outline_samples;  ///< of each pixel of a tile's blocks, besides
    std::vector<int> tile_wanted;               ///< as tile_samples, had none been clean before
    std::vector<char> is_clean;
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
