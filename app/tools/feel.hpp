// What a painter says of a thing, stiff or runny, warm or cold: each moves several of its numbers
// together.
#pragma once

#include <algorithm>
#include <span>
#include <utility>

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

/// The thing at another place, 0 to 1, or the end that is nearest: with(thing, number, value) gives it
/// each of its numbers. It stays as it is where it stands there already.
template <class Owner, class With>
Owner feel_moved(Owner owner, std::span<const FeelNumber<Owner>> numbers, double place,
                 const With& with) {
    const double before = feel_place(owner, numbers), next = std::clamp(place, 0.0, 1.0);
    if (next == before) return owner;
    for (const FeelNumber<Owner>& number : numbers) {
        const double value =
            feel_moved(owner.*number.member, number.from, number.to, number.scale, before, next);
        owner = with(std::move(owner), number, value);
    }
    return owner;
}

/// The same where a number is simply assigned.
template <class Owner>
Owner feel_moved(Owner owner, std::span<const FeelNumber<Owner>> numbers, double place) {
    return feel_moved(std::move(owner), numbers, place,
                      [](Owner moved, const FeelNumber<Owner>& number, double value) {
                          moved.*number.member = value;
                          return moved;
                      });
}

}  // namespace pastoso::tools
