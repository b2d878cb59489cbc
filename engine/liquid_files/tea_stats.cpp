#include "liquid_files/tea_stats.hpp"

#include "core/hash.hpp"

#include <span>

namespace pastoso::liquid_files {

std::uint64_t state_hash(const liquid::MilkTea& tea) {
    core::Hash64 hash;
    hash.add(std::span<const liquid::Parcel>(tea.parcels()));
    hash.add(std::span<const float>(tea.dissolved().values()));
    hash.add(std::span<const float>(tea.coldness().values()));
    return hash.value();
}

void write_stats(const std::filesystem::path& path, const TeaStats& stats) {
    write_run_stats(path, stats,
                    {{"parcels", stats.parcels},
                     {"balls", stats.balls},
                     {"milk_error_rel", stats.milk_error_rel},
                     {"divergence_max", stats.divergence_max},
                     {"surface_error_rel", stats.files.surface_error_rel},
                     {"pile_up_dispersion", stats.pile_up_dispersion},
                     {"pile_up_at_borders", stats.pile_up_at_borders}});
}

}  // namespace pastoso::liquid_files
