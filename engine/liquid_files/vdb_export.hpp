// Fields of the liquid as OpenVDB volumes, where the program was built with it (PASTOSO_WITH_OPENVDB).
#pragma once

#include "grid/box_field.hpp"

#include <array>
#include <filesystem>

namespace pastoso::liquid_files {

/// Fields of one shape; those that are null or empty are left out.
struct VdbFields {
    const grid::BoxField* density = nullptr;      ///< milk, share of the volume
    const grid::BoxField* temperature = nullptr;  ///< of the tea: 1 - coldness is up to the caller
    /// On the faces across x, y, z, in m/s; all three or none. Written as means at the middles of cells.
    std::array<const grid::BoxField*, 3> velocity_m_s{};
};

/// Whether export_vdb() can write.
bool has_openvdb();

/// Writes the grids "density", "temperature" and "velocity" aside: metres, z up, voxel (0, 0, 0) at half
/// a cell. Throws InputError when the program was built without OpenVDB, when the name does not end in
/// .vdb, and when the file cannot be written.
void export_vdb(const std::filesystem::path& path, const VdbFields& fields);

}  // namespace pastoso::liquid_files
