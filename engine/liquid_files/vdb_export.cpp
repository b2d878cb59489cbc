// The only file that knows OpenVDB; it takes ten seconds to compile.
#include "liquid_files/vdb_export.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/output_file.hpp"

#include <openvdb/openvdb.h>
#include <sstream>

namespace pastoso::liquid_files {
namespace {

using grid::BoxField;
using grid::BoxShape;

bool is_there(const BoxField* field) {
    return field != nullptr && field->shape().nx > 0;
}

template <class Grid, class ValueOf>
typename Grid::Ptr make_grid(const char* name, const BoxShape& shape, const ValueOf& value_of) {
    const auto cell_m = static_cast<double>(shape.cell_m);
    auto made = Grid::create();
    made->setName(name);
    auto transform = openvdb::math::Transform::createLinearTransform(cell_m);
    transform->postTranslate(openvdb::Vec3d(0.5 * cell_m));
    made->setTransform(transform);
    made->setGridClass(openvdb::GRID_FOG_VOLUME);
    auto accessor = made->getAccessor();
    const auto background = made->background();
    for (int i = 0; i < shape.nx; ++i)
        for (int j = 0; j < shape.ny; ++j)
            for (int k = 0; k < shape.nz; ++k) {
                const auto value = value_of(i, j, k);
                if (value != background) accessor.setValue({i, j, k}, value);
            }
    return made;
}

openvdb::GridPtrVec grids_of(const VdbFields& fields) {
    openvdb::GridPtrVec grids;
    const auto add = [&](const char* name, const BoxField* field) {
        if (!is_there(field)) return;
        grids.push_back(make_grid<openvdb::FloatGrid>(
            name, field->shape(), [&](int i, int j, int k) { return field->at(i, j, k); }));
    };
    add("density", fields.density);
    add("temperature", fields.temperature);
    const auto [u, v, w] = fields.velocity_m_s;
    if (is_there(u)) {
        PASTOSO_CHECK(is_there(v) && is_there(w));
        auto velocity = make_grid<openvdb::Vec3SGrid>("velocity", u->shape(), [&](int i, int j, int k) {
            return openvdb::Vec3s(0.5F * (u->at(i, j, k) + u->at(i + 1, j, k)),
                                  0.5F * (v->at(i, j, k) + v->at(i, j + 1, k)),
                                  0.5F * (w->at(i, j, k) + w->at(i, j, k + 1)));
        });
        velocity->setVectorType(openvdb::VEC_CONTRAVARIANT_RELATIVE);
        grids.push_back(velocity);
    }
    return grids;
}

/// OpenVDB's own file swallows errors of the disk.
class VolumeFile : openvdb::io::Archive {
  public:
    /// As openvdb::io::File writes them: programs may read one grid alone.
    std::string bytes_of(const openvdb::GridPtrVec& grids) const {
        constexpr bool kSeekable = true;
        std::ostringstream file(std::ios::binary);
        write(file, grids, kSeekable);
        return std::move(file).str();
    }
};

}  // namespace

bool has_openvdb() {
    return true;
}

void export_vdb(const std::filesystem::path& path, const VdbFields& fields) {
    if (core::lower_case(path.extension().string()) != ".vdb")
        throw core::InputError("%1: a volume is saved as .vdb; this name ends otherwise.",
                               path.string());
    openvdb::initialize();
    const openvdb::GridPtrVec grids = grids_of(fields);
    core::write_aside(path, [&](core::OutputFile& file) { file.append(VolumeFile().bytes_of(grids)); });
}

}  // namespace pastoso::liquid_files
