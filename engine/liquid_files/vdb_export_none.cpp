// Stands in for vdb_export.cpp where OpenVDB is left out.
#include "core/error.hpp"
#include "liquid_files/vdb_export.hpp"

namespace pastoso::liquid_files {

bool has_openvdb() {
    return false;
}

void export_vdb(const std::filesystem::path& path, const VdbFields&) {
    throw core::InputError("%1: cannot be written, since this program was built without OpenVDB.",
                           path.string());
}

}  // namespace pastoso::liquid_files
