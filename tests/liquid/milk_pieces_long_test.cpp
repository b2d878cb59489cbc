// Milk hangs together: what looks like crumbs and beads is counted. And its density is sparse.
#include "liquid/tea/milk_density.hpp"
#include "liquid/tea/milk_tea.hpp"

#include <array>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

constexpr float kThick = 0.5F;
constexpr double kSmall_m3 = 8e-9;

/// The milk in pieces of thick milk, connected by faces of cells, that are smaller than kSmall_m3.
double milk_in_small_pieces_m3(const grid::BoxField& share) {
    const grid::BoxShape& shape = share.shape();
    grid::BoxField left = share;
    double sum = 0.0;
    std::vector<std::array<int, 3>> waiting;
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                std::size_t cells = 0;
                double milk = 0.0;
                const auto take = [&](int x, int y, int z) {
                    float& here = left.at(x, y, z);
                    if (here <= kThick) return;
                    ++cells;
                    milk += static_cast<double>(here);
                    here = 0.0F;
                    waiting.push_back({x, y, z});
                };
                take(i, j, k);
                while (!waiting.empty()) {
                    const auto [x, y, z] = waiting.back();
                    waiting.pop_back();
                    take(x - 1, y, z), take(x + 1, y, z);
                    take(x, y - 1, z), take(x, y + 1, z);
                    take(x, y, z - 1), take(x, y, z + 1);
                }
                if (static_cast<double>(cells) * shape.cell_volume_m3() < kSmall_m3) sum += milk;
            }
    return sum * shape.cell_volume_m3();
}

TEST(MilkPieces, AreFewAndLarge) {
    core::ThreadPool pool;
    const TeaSettings settings;
    MilkTea tea(settings);
    MilkDensities densities(pool);
    const MilkDensitySettings density = even_density(settings);
    for (const double time_s : {0.8, 1.8, 5.0, 9.0}) {
        while (tea.time_s() < time_s - 1e-6)
            tea.step(pool);
        double undissolved_m3 = 0.0;
        for (const Parcel& parcel : tea.parcels())
            undissolved_m3 += static_cast<double>(parcel.volume_m3);
        const double small_m3 = milk_in_small_pieces_m3(
            densities.make(tea.parcels(), tea.dissolved(), settings.cup, density).dense());
        EXPECT_LT(small_m3, 0.01 * undissolved_m3) << time_s << " s";
        const MilkDensitySettings finest = {384, density.reach_m};
        const grid::BlockField fine =
            densities.make(tea.parcels(), tea.dissolved(), settings.cup, finest);
        EXPECT_LT(fine.samples().size() * sizeof(float), 250'000'000U) << time_s << " s";
        RecordProperty("small_share_at_" + std::to_string(time_s),
                       std::to_string(small_m3 / undissolved_m3));
    }
}

}  // namespace
}  // namespace pastoso::liquid
