#include "film/cell/ageing.hpp"

#include "film/cell/dissolving.hpp"

#include <utility>

namespace pastoso::film {
namespace {

/// The least drying time carried on at once, and the least number of ticks between two times.
constexpr double kDryingInterval_s = 10.0;
constexpr int kDryingIntervalTicks = 6;

/// A tick short of a second counts as a second: the sum of sixty sixtieths is not quite 1.
constexpr double kDissolvingInterval_s = 0.99;

}  // namespace

void AgeingClock::tick(double tick_s, const DryingAir& air, FilmState& state, core::ThreadPool& pool,
                       const grid::Mask* cover) {
    pending_.drying_s += air.speed * tick_s;
    ++pending_.drying_ticks;
    if (pending_.drying_s >= kDryingInterval_s && pending_.drying_ticks >= kDryingIntervalTicks) {
        dry(state, air, std::exchange(pending_.drying_s, 0.0), pool, cover);
        pending_.drying_ticks = 0;
    }
    pending_.dissolving_s += tick_s;
    if (pending_.dissolving_s >= kDissolvingInterval_s)
        dissolve(state, std::exchange(pending_.dissolving_s, 0.0), pool, cover);
}

}  // namespace pastoso::film
