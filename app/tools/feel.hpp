// What a painter says of a thing, stiff or runny, warm or cold: each moves several of its numbers
// together.
#pragma once

#include <span>

namespace pastoso::tools {

/// How a number goes from one end to the other: by equal steps, by equal factors, or with equal steps
/// of its cube root, as the yield stress goes with the share of particles (film/thinning.hpp).
enum class FeelScale { Linear, Logarithmic, CubeRoot };

template <class Owner>
struct FeelNumber {
    double Owner::*member;
    double from, to;  ///< at the places 0 and 1
    FeelScale scale;
};

/// Where a value lies between two ends, 0 to 1: there it is reached, or nearest to it.
double feel_place(double value, double from, double to, FeelScale scale);

/// A value that goes along from place to place, towards that end, 0 or 1, which it moves to: it has come
/// to its own there, and what lies beside the way between both ends comes to it by and by.
double feel_moved(double value, double from, double to, FeelScale scale, double place, double next);

/// Where the thing stands: where the first of the numbers does.
template <class Owner>
double feel_place(const Owner& owner, std::span<const FeelNumber<Owner>> numbers) {
    const FeelNumber<Owner>& first = numbers.front();
    return feel_place(owner.*first.member, first.from, first.to, first.scale);
}

/// The value of one of the numbers when the thing goes from place to place.
template <class Owner>
double feel_moved(const Owner& owner, const FeelNumber<Owner>& number, double place, double next) {
    return feel_moved(owner.*number.member, number.from, number.to, number.scale, place, next);
}

}  // namespace pastoso::tools
