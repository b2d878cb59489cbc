// The surface of a tank's liquid as a file of triangles.
#pragma once

#include "liquid_files/mesh_export.hpp"
#include "session/tank_session.hpp"

#include <filesystem>
#include <functional>

namespace pastoso::main {

/// Of one moment, with what the liquid fills. Throws as liquid_files::export_mesh() does.
files::ExportStatus write_tank_surface(const session::TankPlace& place, const session::TankSeen& seen,
                                    const std::filesystem::path& file, core::ThreadPool& pool,
                                    const std::function<bool()>& stops);

}  // namespace pastoso::main
