#include "pigment/recipe.hpp"

#include "core/check.hpp"
#include "pigment/appearance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pastoso::pigment {
namespace {

/// Parts that painters measure out by eye; steps of at most a third.
constexpr std::array<int, 19> kRoundParts = {1,  2,  3,  4,  5,  6,  8,  10, 12, 15,
                                             20, 25, 30, 40, 50, 60, 75, 90, 100};
constexpr int kSteps = static_cast<int>(kRoundParts.size());

/// The coarse grid: steps of the two paints, and of the white beside them.
constexpr std::array<std::array<int, 2>, 9> kPairSteps = {
    {{16, 0}, {9, 0}, {5, 0}, {2, 0}, {0, 0}, {0, 2}, {0, 5}, {0, 9}, {0, 16}}};
constexpr std::array<int, 9> kWhiteSteps = {0, 2, 5, 7, 9, 11, 13, 15, 18};

/// How much nearer a recipe must be to be worth another paint, or parts twice as large.
constexpr double kCostOfPaint = 0.15;
constexpr double kCostOfDoubledParts = 0.05;

constexpr std::size_t kShortlist = 160;
constexpr std::size_t kRefined = 8;

/// How far the parts are raised to make room for a small amount of another paint.
constexpr std::array<int, 3> kRaises = {1, 4, 12};
constexpr std::size_t kExchanges = 6;

/// The step of the ladder at so many parts, or the next above.
int step_at(int parts) {
    const auto above = std::lower_bound(kRoundParts.begin(), kRoundParts.end() - 1, parts);
    return static_cast<int>(above - kRoundParts.begin());
}

double squared(double x) {
    return x * x;
}

/// The difference in the neighbourhood of one colour, cheap enough for every candidate.
class NearbyDifference {
  public:
    explicit NearbyDifference(const Lab& wanted)
        : wanted_(wanted), weights_(difference_weights(wanted)) {
        const double chroma = std::max(wanted.chroma(), 1e-9);
        radial_a_ = wanted.a / chroma;
        radial_b_ = wanted.b / chroma;
    }

    double squared_from(const Lab& colour) const {
        const double da = colour.a - wanted_.a, db = colour.b - wanted_.b;
        return squared(weights_.lightness * (colour.lightness - wanted_.lightness)) +
               squared(weights_.chroma * (radial_a_ * da + radial_b_ * db)) +
               squared(weights_.hue * (radial_a_ * db - radial_b_ * da));
    }

  private:
    Lab wanted_;
    DifferenceWeights weights_;
    double radial_a_ = 1.0, radial_b_ = 0.0;
};

}  // namespace

bool RecipeFinder::better_score(const Rated& a, const Rated& b) {
    return a.score < b.score;
}

std::string recipe_text(const Recipe& recipe) {
    if (recipe.ingredients.size() == 1) return recipe.ingredients.front().ci_name;
    std::string text;
    for (const RecipePart& part : recipe.ingredients)
        text += (text.empty() ? "" : " + ") + std::to_string(part.parts) + " " + part.ci_name;
    return text;
}

RecipeFinder::RecipeFinder(std::span<const Pigment> pigments) {
    PASTOSO_CHECK(!pigments.empty());
    double lightest = -1.0;
    for (const Pigment& pigment : pigments) {
        const double lightness = lab(masstone(pigment.coefficients)).lightness;
        if (lightness > lightest) white_ = static_cast<int>(paints_.size());
        lightest = std::max(lightest, lightness);
        names_.push_back(pigment.ci_name);
        paints_.push_back(pigment.coefficients);
    }
    const int count = static_cast<int>(paints_.size());
    for (int first = 0; first < count; ++first) {
        add_candidate({{first, -1, -1}, {0, 0, 0}});
        for (int second = first + 1; second < count; ++second)
            add_candidates(first, second);
    }
}

void RecipeFinder::add_candidates(int first, int second) {
    for (const auto& steps : kPairSteps)
        add_candidate({{first, second, -1}, {steps[0], steps[1], 0}});
    if (first == white_ || second == white_) return;
    for (const auto& steps : kPairSteps) {
        for (const int white_step : kWhiteSteps)
            add_candidate({{first, second, white_}, {steps[0], steps[1], white_step}});
    }
}

void RecipeFinder::add_candidate(const Mixture& mixture) {
    candidates_.push_back({mixture, colour_of(mixture)});
}

Lab RecipeFinder::colour_of(const Mixture& mixture) const {
    std::array<Portion, kMostIngredients> portions{};
    for (int i = 0; i < kMostIngredients; ++i) {
        portions[i].parts = 0.0;
        if (mixture.paint[i] < 0) continue;
        portions[i] = {paints_[mixture.paint[i]], static_cast<double>(kRoundParts[mixture.step[i]])};
    }
    return lab(masstone(mix(portions)));
}

RecipeFinder::Rated RecipeFinder::rated(const Mixture& mixture, const Lab& wanted) const {
    Rated result{mixture, ciede2000(colour_of(mixture), wanted), 0.0};
    result.score = result.difference;
    for (int i = 0; i < kMostIngredients; ++i) {
        if (mixture.paint[i] < 0) continue;
        result.score += kCostOfPaint + kCostOfDoubledParts * std::log2(kRoundParts[mixture.step[i]]);
    }
    return result;
}

/// The candidates nearest to the colour, nearest first. Looking at all of them takes less time than the
/// refinement of one: a tree would not be noticed.
std::vector<std::size_t> RecipeFinder::shortlist(const Lab& wanted) const {
    const NearbyDifference difference(wanted);
    std::vector<std::pair<double, std::size_t>> order;
    order.reserve(candidates_.size());
    for (std::size_t i = 0; i < candidates_.size(); ++i)
        order.emplace_back(difference.squared_from(candidates_[i].colour), i);
    const std::size_t count = std::min(kShortlist, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
    std::vector<std::size_t> nearest;
    for (std::size_t i = 0; i < count; ++i)
        nearest.push_back(order[i].second);
    return nearest;
}

/// Moves along the ladders of parts, one or two of them at a time, and leaves a paint out, as long as
/// that makes the recipe better.
RecipeFinder::Rated RecipeFinder::refined(Rated best, const Lab& wanted) const {
    for (bool better = true; better;) {
        better = false;
        const Mixture from = best.mixture;
        const auto consider = [&](const Mixture& mixture) {
            const Rated tried = rated(mixture, wanted);
            if (tried.score >= best.score) return;
            best = tried;
            better = true;
        };
        for (int moves = 1; moves < 27; ++moves) {
            Mixture mixture = from;
            bool possible = true;
            for (int i = 0, rest = moves; i < kMostIngredients; ++i, rest /= 3) {
                const int step = rest % 3 == 2 ? -1 : rest % 3;
                mixture.step[i] += step;
                possible = possible && mixture.step[i] >= 0 && mixture.step[i] < kSteps &&
                           (step == 0 || mixture.paint[i] >= 0);
            }
            if (possible) consider(mixture);
        }
        const auto used =
            std::count_if(from.paint.begin(), from.paint.end(), [](int p) { return p >= 0; });
        for (int i = 0; used > 1 && i < kMostIngredients; ++i) {
            Mixture mixture = from;
            mixture.paint[i] = -1;
            mixture.step[i] = 0;
            if (from.paint[i] >= 0) consider(mixture);
        }
    }
    return best;
}

/// Puts every other paint into every place of the recipe, a little or much of it, and refines the most
/// promising of these recipes.
RecipeFinder::Rated RecipeFinder::exchanged(const Rated& best, const Lab& wanted) const {
    std::vector<Rated> tried;
    for (int paint = 0; paint < static_cast<int>(paints_.size()); ++paint) {
        const auto& used = best.mixture.paint;
        if (std::find(used.begin(), used.end(), paint) != used.end()) continue;
        for (int place = 0; place < kMostIngredients; ++place) {
            for (const int raise : kRaises) {
                Mixture mixture = best.mixture;
                for (int& step : mixture.step)
                    step = step_at(raise * kRoundParts[step]);
                mixture.paint[place] = paint;
                mixture.step[place] = 0;
                tried.push_back(rated(mixture, wanted));
            }
        }
    }
    const std::size_t count = std::min(kExchanges, tried.size());
    std::partial_sort(tried.begin(), tried.begin() + static_cast<std::ptrdiff_t>(count), tried.end(),
                      better_score);
    Rated winner = best;
    for (std::size_t i = 0; i < count; ++i)
        winner = std::min(winner, refined(tried[i], wanted), better_score);
    return winner;
}

Recipe RecipeFinder::recipe_of(const Rated& best) const {
    Recipe recipe;
    recipe.difference = best.difference;
    int divisor = 0;
    for (int i = 0; i < kMostIngredients; ++i) {
        if (best.mixture.paint[i] < 0) continue;
        const int parts = kRoundParts[best.mixture.step[i]];
        recipe.ingredients.push_back({names_[best.mixture.paint[i]], parts});
        divisor = std::gcd(divisor, parts);
    }
    for (RecipePart& part : recipe.ingredients)
        part.parts /= divisor;
    std::stable_sort(recipe.ingredients.begin(), recipe.ingredients.end(),
                     [](const RecipePart& a, const RecipePart& b) { return a.parts > b.parts; });
    return recipe;
}

Recipe RecipeFinder::closest(const LinearRgb& wanted) const {
    const Lab target = lab(wanted);
    std::vector<Rated> starts;
    for (const std::size_t i : shortlist(target)) {
        const Rated start = rated(candidates_[i].mixture, target);
        // One start for every choice of paints: the refinement finds the parts.
        const auto same = std::find_if(starts.begin(), starts.end(), [&](const Rated& other) {
            return other.mixture.paint == start.mixture.paint;
        });
        if (same == starts.end())
            starts.push_back(start);
        else if (start.score < same->score)
            *same = start;
    }
    std::stable_sort(starts.begin(), starts.end(), better_score);
    starts.resize(std::min(starts.size(), kRefined));
    for (Rated& start : starts)
        start = refined(start, target);
    const Rated best = *std::min_element(starts.begin(), starts.end(), better_score);
    return recipe_of(exchanged(best, target));
}

}  // namespace pastoso::pigment
