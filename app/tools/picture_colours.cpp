#include "tools/picture_colours.hpp"

#include "core/random.hpp"
#include "pigment/lab.hpp"
#include "tools/colour_models.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pastoso::tools {
namespace {

/// Rounds after which the colours have come to rest, or change by less than is seen.
constexpr int kMostRounds = 64;

struct Sample {
    Channels lab{};
    double weight = 0.0;
};

/// Each colour once: pictures repeat theirs.
std::vector<Sample> samples_of(const pigment::Picture& picture) {
    std::map<pigment::Srgb8, double> weights;
    for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4)
        if (picture.rgba[i + 3] > 0)
            weights[{picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]}] += picture.rgba[i + 3];
    std::vector<Sample> samples;
    samples.reserve(weights.size());
    for (const auto& [colour, weight] : weights)
        samples.push_back({oklab(colour), weight});
    return samples;
}

double squared_distance(const Channels& a, const Channels& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

/// The first sample at which the weights reach this share of their sum.
std::size_t drawn(const std::vector<double>& weights, double share) {
    double sum = 0.0;
    for (const double weight : weights)
        sum += weight;
    double left = share * sum;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        left -= weights[i];
        if (left < 0.0) return i;
    }
    return weights.size() - 1;
}

/// Each next one the likelier the farther it is from those before.
std::vector<Channels> first_centres(const std::vector<Sample>& samples, std::size_t count) {
    constexpr std::uint32_t kSeed = 20;
    std::vector<double> weights, nearest(samples.size(), std::numeric_limits<double>::max());
    for (const Sample& sample : samples)
        weights.push_back(sample.weight);
    std::vector<Channels> centres;
    while (centres.size() < count) {
        const auto index = static_cast<std::uint32_t>(centres.size());
        centres.push_back(samples[drawn(weights, core::uniform_noise(index, kSeed))].lab);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            nearest[i] = std::min(nearest[i], squared_distance(samples[i].lab, centres.back()));
            weights[i] = samples[i].weight * nearest[i];
        }
    }
    return centres;
}

std::size_t nearest_of(const std::vector<Channels>& centres, const Channels& lab) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < centres.size(); ++k)
        if (squared_distance(centres[k], lab) < squared_distance(centres[best], lab)) best = k;
    return best;
}

/// Moves each centre to the mean of what is nearest to it. False when they are there.
bool moved_to_means(const std::vector<Sample>& samples, std::vector<Channels>& centres) {
    std::vector<Sample> sums(centres.size());
    for (const Sample& sample : samples) {
        Sample& sum = sums[nearest_of(centres, sample.lab)];
        for (std::size_t i = 0; i < sum.lab.size(); ++i)
            sum.lab[i] += sample.weight * sample.lab[i];
        sum.weight += sample.weight;
    }
    bool moved = false;
    for (std::size_t k = 0; k < centres.size(); ++k) {
        if (sums[k].weight == 0.0) continue;
        const Channels before = centres[k];
        for (std::size_t i = 0; i < before.size(); ++i)
            centres[k][i] = sums[k].lab[i] / sums[k].weight;
        moved = moved || centres[k] != before;
    }
    return moved;
}

/// Pixels first to last - 1 along an axis.
struct Span {
    int first = 0, last = 0;
};

Span span_about(double place_px, double half_px, int size) {
    const int there = static_cast<int>(std::floor(place_px));
    const int first = static_cast<int>(std::ceil(place_px - half_px - 0.5));
    const int last = static_cast<int>(std::floor(place_px + half_px - 0.5)) + 1;
    if (first >= last) return {there, there + 1};
    return {std::max(first, 0), std::min(last, size)};
}

bool lies_on(const pigment::Picture& picture, double x_px, double y_px) {
    return x_px >= 0.0 && y_px >= 0.0 && x_px < picture.width && y_px < picture.height;
}

}  // namespace

std::vector<pigment::Srgb8> picture_colours(const pigment::Picture& picture, int count) {
    const std::vector<Sample> samples = samples_of(picture);
    if (samples.empty()) return {};
    auto centres = first_centres(samples, std::min(static_cast<std::size_t>(count), samples.size()));
    for (int round = 0; round < kMostRounds && moved_to_means(samples, centres); ++round) {
    }
    std::sort(centres.begin(), centres.end());
    std::vector<pigment::Srgb8> colours;
    for (const Channels& lab : centres)
        colours.push_back(colour_of_oklab(lab));
    colours.erase(std::unique(colours.begin(), colours.end()), colours.end());
    return colours;
}

std::optional<pigment::Srgb8> mean_colour(const pigment::Picture& picture, double x_px, double y_px,
                                          double half_px) {
    if (!lies_on(picture, x_px, y_px)) return std::nullopt;
    const Span columns = span_about(x_px, half_px, picture.width);
    const Span rows = span_about(y_px, half_px, picture.height);
    pigment::LinearRgb sum{};
    float weight = 0.0F;
    for (int y = rows.first; y < rows.last; ++y) {
        for (int x = columns.first; x < columns.last; ++x) {
            const std::uint8_t* pixel = &picture.rgba[4 * (std::size_t(y) * picture.width + x)];
            const pigment::LinearRgb light = pigment::decoded({pixel[0], pixel[1], pixel[2]});
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] += pixel[3] * light[i];
            weight += pixel[3];
        }
    }
    if (weight == 0.0F) return std::nullopt;
    for (float& channel : sum)
        channel /= weight;
    return pigment::encoded(sum);
}

pigment::Srgb8 grey_of(const pigment::Srgb8& colour) {
    const pigment::LinearRgb light = pigment::decoded(colour);
    const float luminance = static_cast<float>(pigment::relative_luminance(light));
    return pigment::encoded({luminance, luminance, luminance});
}

}  // namespace pastoso::tools
