#include "tools/picture_colours.hpp"

#include "core/random.hpp"
#include "tools/colour_models.hpp"

#include <algorithm>
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

}  // namespace pastoso::tools
