#include "main/liquids/tank_surface_file.hpp"

namespace pastoso::main {

files::ExportStatus write_tank_surface(const session::TankPlace& place, const session::TankSeen& seen,
                                    const std::filesystem::path& file, core::ThreadPool& pool,
                                    const std::function<bool()>& stops) {
    liquid_files::MeshExportOptions options;
    options.what = "liquid";
    return liquid_files::export_mesh(file, session::liquid_surface(place, seen, 0.0F, pool), options,
                           [&stops](double) { return !stops(); });
}

}  // namespace pastoso::main
