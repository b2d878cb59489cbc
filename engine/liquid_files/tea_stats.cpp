#include "liquid_files/tea_stats.hpp"

namespace pastoso::liquid_files {

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
