// How far a long work is, and how it is given up.
#pragma once

#include <functional>
#include <utility>

namespace pastoso::core {

/// Told now and then how much of a work is done, 0 to 1, by one of its threads at a time. What it throws
/// ends the work; nothing is told where it is empty.
using Progress = std::function<void(double done)>;

/// What it throws when nobody wants the work any more.
struct GivenUp {};

/// A part of a work as the whole of it, from one share of that to another.
inline Progress part_of(Progress whole, double from, double to) {
    if (!whole) return {};
    return [whole = std::move(whole), from, to](double done) { whole(from + done * (to - from)); };
}

}  // namespace pastoso::core
