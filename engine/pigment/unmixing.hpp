// Which of the paints that may be in it a mixture was mixed of: the inverse of mix().
#pragma once

#include "pigment/bands.hpp"

#include <span>
#include <vector>

namespace pastoso::pigment {

struct Unmixed {
    std::vector<double>
        shares;          ///< of each paint in the volume, >= 0; what is left of 1 is clear medium
    double error = 0.0;  ///< root of the mean square of the channels' relative errors
};

/// The shares a_i >= 0 for which sum(a_i paints_i) is nearest to the mixture, the least sum of squared
/// relative errors over the channels (non-negative least squares; Lawson and Hanson, Solving Least
/// Squares Problems, 1974, chapter 23). Then paints are left out, the most needless first, as long as
/// the error stays below a thousandth. One or two paints are looked for first: more than they could mix
/// to nearly the same.
Unmixed unmixed(const Coefficients& mixture, std::span<const Coefficients> paints);

}  // namespace pastoso::pigment
