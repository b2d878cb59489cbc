#include "film/ageing.hpp"

#include "film/dissolving.hpp"

#include <utility>

namespace pastoso::film {
namespace {

/// The least drying time carried on at once, and the least number of ticks between two times.
constexpr double kDryingInterval_s = 10.0;
constexpr int kDryingIntervalTicks = 6;

/// A tick short of a second counts as a second: the sum of sixty sixtieths is not quite 1.
constexpr double kDissolvingInterval_s = 0.99;

}  // namespace

void AgeingClock::tick(double tick_s, const DryingAir& air, const pigment::Bands& bare_ground,
                       FilmState& state, core::ThreadPool& pool) {
    drying_s_ += air.speed * tick_s;
    ++drying_ticks_;
    if (drying_s_ >= kDryingInterval_s && drying_ticks_ >= kDryingIntervalTicks) {
        dry(state, air, std::exchange(drying_s_, 0.0), bare_ground, pool);
        drying_ticks_ = 0;
    }
    dissolving_s_ += tick_s;
    if (dissolving_s_ >= kDissolvingInterval_s) dissolve(state, std::exchange(dissolving_s_, 0.0), pool);
}

}  // namespace pastoso::film
