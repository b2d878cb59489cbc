#include "liquid/classic/real_rows.hpp"

#include "core/check.hpp"
#include "liquid/classic/complex_lanes.hpp"

#include <cmath>
#include <numbers>

namespace pastoso::liquid {
namespace {

/// X(k) and X(n/2 - k) of Z(k) and Z(n/2 - k), two of each, the latter in the opposite order.
PASTOSO_LANE_FUNCTION void unfold_pair(Four& z, Four& mirrored, const Turn& turn) {
    const Four other = conjugate(mirrored);
    const Four even = Four(0.5F) * (z + other), odd = times(Four(0.5F) * (z - other), turn);
    z = even + odd;
    mirrored = conjugate(even - odd);
}
PASTOSO_LANE_FUNCTION void fold_pair(Four& x, Four& mirrored, const Turn& turn) {
    const Four other = conjugate(mirrored);
    const Four even = x + other, odd = times_conjugate(x - other, turn);
    x = even + odd;
    mirrored = conjugate(even - odd);
}

}  // namespace

RealRows::RealRows(int n) : half_(n / 2) {
    PASTOSO_CHECK(n >= 2 && n % 2 == 0);
    // One more than there are pairs: the last two lanes may hold a pair and nothing.
    for (int k = 1; k <= half_ / 2 + 1; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n;
        const auto re = static_cast<float>(-std::sin(angle)), im = static_cast<float>(-std::cos(angle));
        real_.insert(real_.end(), {re, re});
        imaginary_.insert(imaginary_.end(), {-im, im});
    }
}

/// Calls pair(a, b, turn) for all Z(k), 0 < k <= n/4, with their mirror images: two at a time as long as
/// no number is met twice, then one by one.
template <class Pair>
PASTOSO_LANE_FUNCTION void for_pairs(float* row, int half, const AlignedFloats& real,
                                     const AlignedFloats& imaginary, const Pair& pair) {
    const auto turn = [&](int k) {
        return Turn(lanes::load<Four>(real.data() + 2 * (k - 1)),
                    lanes::load<Four>(imaginary.data() + 2 * (k - 1)));
    };
    int k = 1;
    for (; k + 1 < half - k - 1; k += kNumbersAtOnce) {
        float *at = row + 2 * k, *mirror_at = row + 2 * (half - k - 1);
        Four here = lanes::load<Four>(at), mirrored = numbers_swapped(lanes::load<Four>(mirror_at));
        pair(here, mirrored, turn(k));
        lanes::store(at, here);
        lanes::store(mirror_at, numbers_swapped(mirrored));
    }
    for (; k <= half - k; ++k) {
        float *at = row + 2 * k, *mirror_at = row + 2 * (half - k);
        Four here{at[0], at[1], 0.0F, 0.0F}, mirrored{mirror_at[0], mirror_at[1], 0.0F, 0.0F};
        pair(here, mirrored, turn(k));
        at[0] = here[0];
        at[1] = here[1];
        mirror_at[0] = mirrored[0];
        mirror_at[1] = mirrored[1];
    }
}

void RealRows::unfold(float* row) const {
    for_pairs(row, half_, real_, imaginary_,
              [](Four& z, Four& mirrored, const Turn& turn) { unfold_pair(z, mirrored, turn); });
    const float re = row[0], im = row[1];
    row[0] = re + im;
    row[2 * half_] = re - im;
    row[1] = row[2 * half_ + 1] = 0.0F;
}

void RealRows::fold(float* row) const {
    for_pairs(row, half_, real_, imaginary_,
              [](Four& x, Four& mirrored, const Turn& turn) { fold_pair(x, mirrored, turn); });
    const float first = row[0], last = row[2 * half_];
    row[0] = first + last;
    row[1] = first - last;
}

}  // namespace pastoso::liquid
