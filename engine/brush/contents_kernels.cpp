// Compiled once per instruction set; see pastoso_add_kernels.
#include "brush/contents_kernels.hpp"

#include "core/lane_memory.hpp"
#include "film/state.hpp"

namespace pastoso::brush::PASTOSO_ISA {
namespace {

namespace lanes = core::lanes;

using Doubles = lanes::Widest<double>;

PASTOSO_LANE_FUNCTION double share_of(double amount_mm3, const Contents& contents) {
    return contents.volume_mm3 > 0.0 ? lanes::min(1.0, amount_mm3 / contents.volume_mm3) : 0.0;
}

/// Moves shares of two amounts across.
template <class V>
PASTOSO_LANE_FUNCTION void exchange(double* a, double* b, double share_of_a, double share_of_b) {
    const V of_a = lanes::load<V>(a), of_b = lanes::load<V>(b);
    const V amount = of_a * share_of_a - of_b * share_of_b;
    lanes::store(a, of_a - amount);
    lanes::store(b, of_b + amount);
}

PASTOSO_LANE_FUNCTION void wick_between(Contents& a, Contents& b, double wick) {
    const double both_ways_mm3 = 0.5 * wick * lanes::min(a.volume_mm3, b.volume_mm3);
    const double one_way_mm3 = 0.25 * wick * (a.volume_mm3 - b.volume_mm3);
    const double share_of_a = share_of(both_ways_mm3 + lanes::max(one_way_mm3, 0.0), a);
    const double share_of_b = share_of(both_ways_mm3 + lanes::max(-one_way_mm3, 0.0), b);
    exchange<double>(&a.volume_mm3, &b.volume_mm3, share_of_a, share_of_b);
    for (int k = 0; k < film::kPaintChannels; k += Doubles::kLanes)
        exchange<Doubles>(a.paint.data() + k, b.paint.data() + k, share_of_a, share_of_b);
}

}  // namespace

void wick(Contents* held, const std::pair<int, int>* pairs, int count, double wick) {
    for (int i = 0; i < count; ++i)
        wick_between(held[pairs[i].first], held[pairs[i].second], wick);
}

void give(const Contents& held, const GivingLimits& limits, film::PaintCoefficients& given) {
    constexpr double kQuantumRatio = film::kThicknessQuantum_mm / film::kPaintQuantum;
    const double per_mm3 = 1.0 / held.volume_mm3;
    for (int k = 0; k < film::kPaintChannels; k += Doubles::kLanes) {
        const auto paint = lanes::load<Doubles>(held.paint.data() + k);
        const Doubles per_mm = lanes::min(paint * per_mm3, Doubles(limits.strongest_per_mm));
        const auto some = limits.kept_share * paint > Doubles(limits.negligible);
        const Doubles quanta = lanes::select(some, per_mm * kQuantumRatio, Doubles(0.0));
        lanes::store(given.data() + k, lanes::convert<float>(quanta));
    }
}

void take(const ChangeSums& gained, double cell_area_mm2, Contents& held) {
    const double quantum_mm3 = film::kThicknessQuantum_mm * cell_area_mm2;
    held.volume_mm3 -= static_cast<double>(gained.thickness) * quantum_mm3;
    for (int k = 0; k < film::kPaintChannels; k += Doubles::kLanes) {
        const auto quanta = lanes::load<lanes::As<std::int64_t, Doubles>>(gained.paint.data() + k);
        const auto paint = lanes::load<Doubles>(held.paint.data() + k);
        lanes::store(held.paint.data() + k,
                     paint - lanes::convert<double>(quanta) * (film::kPaintQuantum * cell_area_mm2));
    }
}

}  // namespace pastoso::brush::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::brush, ContentsKernels, wick, give, take)
