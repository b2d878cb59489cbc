#include "brush/tip.hpp"

#include "brush/laid_film.hpp"
#include "core/r2_sequence.hpp"
#include "core/random.hpp"
#include "core/units.hpp"
#include "film/support/smooth_noise.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {
namespace {

using core::uniform_noise;

/// What the random numbers of a tip are used for, each with its own stream.
enum Stream : std::uint32_t {
    kPlaceU,
    kPlaceV,
    kDeficit,
    kStiffness,
    kBody,
    kHair,
    kFanDeficit,
    kClumpX,
    kClumpY,
    kClump = 32,
    kClumpDeficit = 64,
    kClumpUptake = 96,
    kPores = 128
};

/// A place in the tip's outline, -1 to 1 along width and thickness.
struct Place {
    double u, v;
};

/// Point `index` of the R2 sequence, shaken by about half the distance of neighbours so that no rows
/// show.
Place spread_place(std::uint32_t index, std::uint32_t seed, const Place& shake) {
    return {2.0 * core::fraction(0.5 + index * core::kR2StepX) - 1.0 +
                shake.u * (uniform_noise(index, seed + kPlaceU) - 0.5),
            2.0 * core::fraction(0.5 + index * core::kR2StepY) - 1.0 +
                shake.v * (uniform_noise(index, seed + kPlaceV) - 0.5)};
}

/// Unrolled, a roller is a rectangle.
bool is_oval(const TipPreset& tip) {
    return (tip.shape == TipShape::Round || tip.shape == TipShape::Pad) && tip.girth_mm <= 0.0;
}

double depth_of(const TipPreset& tip) {
    if (tip.girth_mm > 0.0) return tip.girth_mm;
    return tip.shape == TipShape::Round ? tip.width_mm : tip.thickness_mm;
}

double outline_area_mm2(const TipPreset& tip) {
    const double box_mm2 = tip.width_mm * depth_of(tip);
    return is_oval(tip) ? core::kPi / 4.0 * box_mm2 : box_mm2;
}

/// Radius of a footprint against the distance of the elements. Those of hairs pass one after the other
/// over a place; what rolls or stamps has to cover it with those that happen to stand there.
double footprint_share(const TipPreset& tip) {
    constexpr double kSliding = 0.72, kStanding = 1.1;
    return tip.girth_mm > 0.0 || tip.pores_mm > 0.0 ? kStanding : kSliding;
}

double footprint_mm(const TipPreset& tip) {
    return footprint_share(tip) * std::sqrt(outline_area_mm2(tip) / tip.bristles);
}

/// How far elements stand from the middle, of half the width: no footprint of a roller reaches beyond
/// its ends, so that its mark ends straight.
double farthest_u(const TipPreset& tip) {
    return tip.girth_mm > 0.0 ? std::max(0.0, 1.0 - 2.0 * footprint_mm(tip) / tip.width_mm) : HUGE_VAL;
}

std::vector<Place> places(const TipPreset& tip, std::uint32_t seed) {
    const double depth_mm = depth_of(tip);
    const double distance_mm = std::sqrt(tip.width_mm * depth_mm / tip.bristles);
    const Place shake = {2.0 * distance_mm / tip.width_mm, 2.0 * distance_mm / depth_mm};
    const double farthest = farthest_u(tip);
    std::vector<Place> result;
    for (std::uint32_t index = 0; static_cast<int>(result.size()) < tip.bristles; ++index) {
        const Place place = spread_place(index, seed, shake);
        const bool outside = place.u * place.u + place.v * place.v > 1.0;
        if (is_oval(tip) && outside) continue;
        result.push_back({std::clamp(place.u, -farthest, farthest), place.v});
    }
    return result;
}

std::vector<Place> edge_places(int count) {
    std::vector<Place> result;
    result.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        result.push_back({2.0 * (i + 0.5) / count - 1.0, 0.0});
    return result;
}

/// Clumps: noise in four octaves across the width, at five clumps per width the coarsest; mean 0.5.
double clump_noise(double u, std::uint32_t seed) {
    constexpr double kWeights[] = {0.3, 0.3, 0.2, 0.2};
    double sum = 0.0, frequency = 2.5;
    for (std::uint32_t octave = 0; octave < 4; ++octave, frequency *= 2.0) {
        const double shift = 17.0 * octave + uniform_noise(octave, seed);
        sum += kWeights[octave] * film::smooth_noise(u * frequency + shift, seed + 1 + octave);
    }
    return sum;
}

/// The noises of a tip, mean 0.5: its own and those of its latest dip.
class TipNoise {
  public:
    TipNoise(std::uint32_t own, std::uint32_t dip, double gathered)
        : own_(own),
          dip_(dip),
          own_weight_(std::sqrt(1.0 - gathered)),
          dip_weight_(std::sqrt(gathered)) {}

    std::uint32_t own_seed() const { return own_; }

    double uniform(std::uint32_t index, Stream stream) const {
        return blended(uniform_noise(index, own_ + stream), uniform_noise(index, dip_ + stream));
    }
    double plane(double x, double y, Stream stream) const {
        return blended(film::smooth_noise(x, y, own_ + stream), film::smooth_noise(x, y, dip_ + stream));
    }
    double clump(double u, Stream stream) const {
        return blended(clump_noise(u, own_ + stream), clump_noise(u, dip_ + stream));
    }

  private:
    double blended(double own, double dip) const {
        return 0.5 + own_weight_ * (own - 0.5) + dip_weight_ * (dip - 0.5);
    }

    std::uint32_t own_, dip_;
    double own_weight_, dip_weight_;
};

/// What makes a bristle thick or thin, mean 0.5 before the tip is levelled.
double body_noise(double u, std::uint32_t index, const TipNoise& noise) {
    const double raw = 0.65 * noise.clump(u, kClump) + 0.35 * noise.uniform(index, kBody);
    return 0.5 + 1.9 * (raw - 0.5);
}

/// How far the hairs are gathered, 0 to 1: less and less as the brush empties.
double gathered_share(const PaintPreset& paint, const Gathering& gathering) {
    if (gathering.number == 0) return 0.0;
    return paint.gather * std::exp(-gathering.worn_mm / (2.0 * paint.run_mm));
}

/// Where a bristle goes when wet hairs clump: along with its surroundings, and towards the middle of its
/// clump, each clump as firmly as chance has it.
float clumped_mm(float place_mm, double gathered, std::uint32_t seed) {
    constexpr double kClump_mm = 1.2, kFirmest = 0.7, kSway_mm = 3.0, kFarthest_mm = 0.7;
    const double place = place_mm / kClump_mm + uniform_noise(0, seed);
    const double clump = std::floor(place);
    const auto index = static_cast<std::uint32_t>(static_cast<std::int32_t>(clump));
    const double firmness = kFirmest * uniform_noise(index + 1, seed);
    const double sway = 2.0 * film::smooth_noise(place_mm / kSway_mm, seed) - 1.0;
    const double moved_mm = kFarthest_mm * sway + firmness * (clump + 0.5 - place) * kClump_mm;
    return static_cast<float>(place_mm + gathered * moved_mm);
}

/// Draws the hairs together along both sides of the tip.
void draw_together(double gathered, Tip& tip) {
    for (Bristle& bristle : tip.bristles) {
        bristle.root_x_mm = clumped_mm(bristle.root_x_mm, gathered, tip.dip_seed + kClumpX);
        bristle.root_y_mm = clumped_mm(bristle.root_y_mm, gathered, tip.dip_seed + kClumpY);
    }
}

/// That of bristles whose noise is 0.5.
double mean_body(double streak) {
    return 1.0 - streak + streak * 1.25 * 0.5;
}

/// Thin bristles take up less, those of a knife as much as each other.
double dip_of_body(bool rigid, double body) {
    return rigid ? 1.0 : 0.4 + 0.6 * body;
}

/// Sets the mean of what full bristles hold, none more than `most`.
void level_dips(double mean, double most, Tip& tip) {
    double sum = 0.0, room = 0.0;
    for (Bristle& bristle : tip.bristles) {
        bristle.full_dip = std::min(bristle.full_dip, most);
        sum += bristle.full_dip, room += most - bristle.full_dip;
    }
    const double missing = mean * static_cast<double>(tip.bristles.size()) - sum;
    for (Bristle& bristle : tip.bristles)
        bristle.full_dip += missing < 0.0 ? missing * bristle.full_dip / sum
                                          : missing * (most - bristle.full_dip) / room;
}

/// Gives each clump its part of a dip, which is as much as any other dip of a tip of that streak.
void share_dip(double gathered, const Preset& preset, Tip& tip) {
    constexpr double kMostApart = 0.3, kContrast = 1.9;
    for (Bristle& bristle : tip.bristles) {
        const double u = bristle.root_x_mm / tip.half_width_mm;
        const double noise = kContrast * (clump_noise(u, tip.dip_seed + kClumpUptake) - 0.5);
        bristle.full_dip = dip_of_body(tip.rigid, bristle.body) *
                           (1.0 + gathered * std::clamp(noise, -kMostApart, kMostApart));
    }
    if (gathered > 0.0)
        level_dips(dip_of_body(tip.rigid, mean_body(preset.paint.streak)), preset.exchange.overflow,
                   tip);
}

/// Makes the mean of the noise 0.5, whatever the seed, and turns it into body.
void level_bodies(double streak, Tip& tip) {
    double mean = 0.0;
    for (const Bristle& bristle : tip.bristles)
        mean += bristle.body;
    mean /= static_cast<double>(tip.bristles.size());
    for (Bristle& bristle : tip.bristles) {
        const double body = 1.0 - streak + streak * 1.25 * (bristle.body - mean + 0.5);
        bristle.body = static_cast<float>(std::clamp(body, 0.03, 1.25));
        if (tip.rigid) bristle.body = 0.75F + 0.3F * bristle.body;
    }
}

void measure_distances(Tip& tip) {
    for (Bristle& bristle : tip.bristles)
        bristle.per_distance = 1.0F / (std::hypot(bristle.root_x_mm, bristle.root_y_mm) + 1e-6F);
}

/// Measures all deficits from the longest bristle.
void level_deficits(Tip& tip) {
    float least = tip.bristles.front().deficit_mm;
    for (const Bristle& bristle : tip.bristles)
        least = std::min(least, bristle.deficit_mm);
    for (Bristle& bristle : tip.bristles)
        bristle.deficit_mm -= least;
}

/// Moves places along the width together into tufts with gaps between them.
double gathered(double u) {
    constexpr double kTufts = 15.0, kTuftWidth = 0.35;
    const double place = 0.5 * (u + 1.0) * kTufts;
    const double middle = std::floor(place) + 0.5;
    return 2.0 * (middle + kTuftWidth * (place - middle)) / kTufts - 1.0;
}

/// Roots on the arc of a fan that is spread over about a hundred degrees, in tufts.
void place_on_fan(const Place& place, const TipPreset& tip, Bristle& bristle) {
    const double angle = 0.9 * gathered(place.u);
    const double half_width = 0.5 * tip.width_mm;
    bristle.root_x_mm = static_cast<float>(1.15 * half_width * std::sin(angle));
    bristle.root_y_mm = static_cast<float>(0.6 * half_width * (1.0 - std::cos(angle)) +
                                           0.5 * tip.thickness_mm * place.v);
}

/// A sable's point: round, with a tip. From 0 in the middle to 1 outside.
double point_profile(double radius) {
    return 0.45 * radius + 0.55 * radius * radius;
}

/// How deep a sponge is at a place, of its pores' depth: walls between holes of two sizes.
double pore_at(const TipPreset& tip, const Place& place, const TipNoise& noise) {
    constexpr double kLarge_mm = 5.0, kSmall_mm = 2.0, kContrast = 3.0;
    const double x_mm = 0.5 * tip.width_mm * place.u, y_mm = 0.5 * depth_of(tip) * place.v;
    const double holes = 0.55 * noise.plane(x_mm / kLarge_mm, y_mm / kLarge_mm, kPores) +
                         0.45 * noise.plane(x_mm / kSmall_mm, y_mm / kSmall_mm, kPores);
    return std::clamp(0.5 + kContrast * (holes - 0.5), 0.0, 1.0);
}

/// Worn bristles: single hairs and whole clumps are shorter than the longest, few of them much, which
/// gives the strokes their ragged ends. Sable wears less, a pad is domed.
double deficit_of(const TipPreset& tip, const Place& place, std::uint32_t index, const TipNoise& noise) {
    const double shake = std::clamp(noise.uniform(index, kDeficit), 0.0, 1.0);
    const double clump = std::clamp(0.5 + 1.8 * (noise.clump(place.u, kClumpDeficit) - 0.5), 0.0, 1.0);
    const double pores = tip.pores_mm > 0.0 ? tip.pores_mm * pore_at(tip, place, noise) : 0.0;
    if (tip.shape == TipShape::Pad)
        return pores +
               tip.point_mm * (place.u * place.u + (tip.girth_mm > 0.0 ? 0.0 : place.v * place.v));
    const bool round = tip.shape == TipShape::Round;
    const double wear = round ? 0.006 : 0.06;
    double deficit = wear * tip.length_mm * (shake * shake + clump * clump);
    if (round) deficit += tip.point_mm * point_profile(std::hypot(place.u, place.v));
    if (tip.shape == TipShape::Filbert) deficit += tip.point_mm * place.u * place.u;
    if (tip.shape == TipShape::Fan)
        deficit += 0.05 * tip.length_mm * std::clamp(noise.uniform(index, kFanDeficit), 0.0, 1.0);
    return deficit + pores;
}

/// The bristle at a place; body holds its noise and the deficits are to be levelled.
Bristle make_bristle(const Preset& preset, const Place& place, std::uint32_t index,
                     const TipNoise& noise) {
    const TipPreset& tip = preset.tip;
    Bristle bristle;
    bristle.root_x_mm = static_cast<float>(0.5 * tip.width_mm * place.u);
    bristle.root_y_mm = static_cast<float>(0.5 * depth_of(tip) * place.v);
    bristle.body = static_cast<float>(body_noise(place.u, index, noise));
    if (tip.shape == TipShape::Fan) place_on_fan(place, tip, bristle);
    if (is_row(tip.shape)) return bristle;
    bristle.deficit_mm = static_cast<float>(deficit_of(tip, place, index, noise));
    bristle.stiffness = 0.8F + 0.4F * uniform_noise(index, noise.own_seed() + kStiffness);
    return bristle;
}

/// The four nearest of every bristle, each pair once, in order.
std::vector<std::pair<int, int>> nearest_pairs(const std::vector<Bristle>& bristles) {
    constexpr std::size_t kNearest = 4;
    const int count = static_cast<int>(bristles.size());
    std::vector<std::pair<int, int>> pairs;
    std::vector<std::pair<float, int>> distances;
    for (int i = 0; i < count; ++i) {
        distances.clear();
        for (int j = 0; j < count; ++j) {
            const float dx = bristles[j].root_x_mm - bristles[i].root_x_mm;
            const float dy = bristles[j].root_y_mm - bristles[i].root_y_mm;
            if (j != i) distances.emplace_back(dx * dx + dy * dy, j);
        }
        const std::size_t nearest = std::min(kNearest, distances.size());
        std::partial_sort(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(nearest),
                          distances.end());
        for (std::size_t n = 0; n < nearest; ++n)
            pairs.push_back(std::minmax(i, int{distances[n].second}));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

void add_hairs(Tip& tip, const TipNoise& noise) {
    const auto count = tip.bristles.size() * static_cast<std::size_t>(tip.hair_count());
    for (std::size_t i = 0; i < count; ++i) {
        const double height = noise.uniform(static_cast<std::uint32_t>(i), kHair) - 0.5;
        tip.hairs.push_back(static_cast<float>(std::clamp(height, -0.5, 0.5)));
    }
}

/// A bottle, or a mouth that blows: one element that touches nothing.
Tip nozzle(const Preset& preset, std::uint32_t seed) {
    Tip tip;
    tip.seed = seed;
    tip.bristles.resize(1);
    tip.half_width_mm = 0.5 * preset.tip.width_mm;
    tip.capacity_mm3 = preset.kind == ToolKind::Droplets ? preset.droplets.capacity_mm3 : 0.0;
    tip.hairs_per_bristle = preset.tip.hairs_per_bristle;
    tip.hairs.resize(static_cast<std::size_t>(tip.hair_count()));
    return tip;
}

}  // namespace

Tip make_tip(const Preset& preset, std::uint32_t seed, const Gathering& gathering) {
    const std::uint32_t mixed_seed = core::scramble(core::scramble(preset.tip.seed) + seed);
    if (preset.kind != ToolKind::Contact) return nozzle(preset, mixed_seed);
    const bool row = is_row(preset.tip.shape);
    const int count = preset.tip.bristles;
    Tip tip;
    tip.seed = mixed_seed;
    tip.hairs_per_bristle = preset.tip.hairs_per_bristle;
    tip.rigid = row;
    tip.half_width_mm = 0.5 * preset.tip.width_mm;
    tip.area_mm2 = outline_area_mm2(preset.tip) / count;
    tip.capacity_mm3 = full_film_mm(preset) * preset.paint.run_mm * preset.tip.width_mm / count;
    tip.radius_mm = row ? 0.5 * preset.tip.thickness_mm : footprint_mm(preset.tip);
    const double lane_share = preset.tip.shape == TipShape::Comb ? 0.5 * preset.tip.tooth : 1.0;
    tip.lane_mm = row ? lane_share * preset.tip.width_mm / count : 0.0;
    const double gathered = gathered_share(preset.paint, gathering);
    tip.dip_seed = gathered > 0.0 ? core::scramble(mixed_seed + gathering.number) : mixed_seed;
    const TipNoise noise(mixed_seed, tip.dip_seed, gathered);
    std::uint32_t index = 0;
    for (const Place& place : row ? edge_places(count) : places(preset.tip, mixed_seed)) {
        tip.bristles.push_back(make_bristle(preset, place, index++, noise));
    }
    if (!row) draw_together(gathered, tip);
    level_bodies(preset.paint.streak, tip);
    share_dip(gathered, preset, tip);
    level_deficits(tip);
    measure_distances(tip);
    add_hairs(tip, noise);
    tip.neighbours = nearest_pairs(tip.bristles);
    return tip;
}

}  // namespace pastoso::brush
