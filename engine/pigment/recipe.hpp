// Which of the paints at hand mix to a colour, and in which parts.
#pragma once

#include "pigment/lab.hpp"
#include "pigment/palette.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace pastoso::pigment {

inline constexpr int kMostIngredients = 3;

struct RecipePart {
    std::string ci_name;
    int parts = 1;  ///< by volume, 1 to 100
    friend bool operator==(const RecipePart&, const RecipePart&) = default;
};

struct Recipe {
    std::vector<RecipePart> ingredients;  ///< 1 to kMostIngredients, the largest part first
    double difference = 0.0;              ///< CIEDE2000 between its masstone and the colour wanted
};

/// "8 PW6 + 1 PB29", or "PB29" alone.
std::string recipe_text(const Recipe& recipe);

/// Finds recipes from one set of paints. Building it mixes some 19000 recipes of one or two paints with
/// the lightest of the set (6 ms for the box); a search then takes less than one.
class RecipeFinder {
  public:
    /// At least one pigment. A set without a white is tinted with its lightest paint.
    explicit RecipeFinder(std::span<const Pigment> pigments);

    /// The mixture of at most kMostIngredients paints in round parts whose opaque masstone is nearest to
    /// `wanted` (linear sRGB of the paint itself, see paint_colour()) in CIEDE2000. Where a simpler
    /// recipe is as near to the eye it is preferred. The same colour gives the same recipe.
    Recipe closest(const LinearRgb& wanted) const;

  private:
    /// Indices of paints, -1 for none, and steps on the ladder of round parts.
    struct Mixture {
        std::array<int, kMostIngredients> paint = {-1, -1, -1};
        std::array<int, kMostIngredients> step = {0, 0, 0};
    };
    struct Candidate {
        Mixture mixture;
        Lab colour;
    };
    struct Rated {
        Mixture mixture;
        double difference = 0.0;
        double score = 0.0;  ///< the difference and a little for every complication
    };

    void add_candidates(int first, int second);
    void add_candidate(const Mixture& mixture);
    Lab colour_of(const Mixture& mixture) const;
    Rated rated(const Mixture& mixture, const Lab& wanted) const;
    std::vector<std::size_t> shortlist(const Lab& wanted) const;
    Rated refined(Rated best, const Lab& wanted) const;
    Rated exchanged(const Rated& best, const Lab& wanted) const;
    static bool better_score(const Rated& a, const Rated& b);
    Recipe recipe_of(const Rated& best) const;

    std::vector<std::string> names_;
    std::vector<Coefficients> paints_;
    int white_ = 0;  ///< the lightest paint
    std::vector<Candidate> candidates_;
};

}  // namespace pastoso::pigment
