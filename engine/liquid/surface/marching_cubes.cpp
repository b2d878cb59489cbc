#include "liquid/surface/marching_cubes.hpp"

#include "core/check.hpp"
#include "liquid/surface/marching_kernels.hpp"

#include <algorithm>
#include <limits>

namespace pastoso::liquid {
namespace {

constexpr float kFarBelow = -1e18F;  // its square is still a float
constexpr int kColumns = 7;

/// What the vertices of a row along one axis are made from.
EdgeRow edge_row(const SampleView& samples, int j, int k, int axis, float iso) {
    const Lattice& lattice = samples.lattice;
    EdgeRow row{};
    row.values = samples.row(j, k);
    row.along = axis == 0 ? 1 : axis == 1 ? samples.stride_y : samples.stride_z;
    for (int end = 0; end < 2; ++end) {
        const int y = j + (axis == 1 ? end : 0), z = k + (axis == 2 ? end : 0);
        row.low_y[end] = y > 0 ? -samples.stride_y : 0;
        row.high_y[end] = y + 1 < lattice.ny ? samples.stride_y : 0;
        row.low_z[end] = z > 0 ? -samples.stride_z : 0;
        row.high_z[end] = z + 1 < lattice.nz ? samples.stride_z : 0;
        row.scale_y[end] = y > 0 && y + 1 < lattice.ny ? 1.0F : 2.0F;
        row.scale_z[end] = z > 0 && z + 1 < lattice.nz ? 1.0F : 2.0F;
    }
    row.axis = axis;
    row.nx = lattice.nx;
    row.iso = iso;
    row.spacing_m = lattice.spacing_m;
    const glm::vec3 start = lattice.point_m(0, j, k);
    for (int a = 0; a < 3; ++a)
        row.origin_m[a] = start[a];
    return row;
}

VertexColumns columns_in(std::vector<float>& scratch, int nx) {
    scratch.resize(static_cast<std::size_t>(kColumns) * static_cast<std::size_t>(nx));
    float* next = scratch.data();
    const auto column = [&] {
        float* taken = next;
        next += nx;
        return taken;
    };
    VertexColumns columns{};
    columns.share = column();
    for (int a = 0; a < 3; ++a) {
        columns.position[a] = column();
        columns.normal[a] = column();
    }
    return columns;
}

void gather_columns(float* const (&columns)[3], int count, glm::vec3* out) {
    for (int n = 0; n < count; ++n)
        out[n] = {columns[0][n], columns[1][n], columns[2][n]};
}

}  // namespace

SampleView MarchingCubes::padded(const SampleView& samples) {
    Lattice lattice = samples.lattice;
    lattice.origin_m = lattice.point_m(-1, -1, -1);
    lattice.nx += 2;
    lattice.ny += 2;
    lattice.nz += 2;
    if (padded_.lattice() != lattice) padded_.assign(lattice, kFarBelow);
    pool_.run(static_cast<std::size_t>(samples.lattice.nz), [&](std::size_t layer, int) {
        const int k = static_cast<int>(layer);
        for (int j = 0; j < samples.lattice.ny; ++j) {
            const float* row = samples.row(j, k);
            std::copy(row, row + samples.lattice.nx, padded_.row(j + 1, k + 1) + 1);
        }
    });
    return padded_.view();
}

void MarchingCubes::mark(const SampleView& samples, float iso, core::Isa isa) {
    const Lattice& lattice = samples.lattice;
    words_ = static_cast<std::size_t>((lattice.nx + 31) / 32 + 1);
    bits_.resize(words_ * row_index(lattice, 0, lattice.nz));
    const auto& kernels = core::kernels<MarchingKernels>(isa);
    pool_.run(static_cast<std::size_t>(lattice.nz), [&](std::size_t layer, int) {
        const int k = static_cast<int>(layer);
        for (int j = 0; j < lattice.ny; ++j)
            kernels.mark(samples.row(j, k), lattice.nx, iso,
                         bits_.data() + words_ * row_index(lattice, j, k));
    });
}

void MarchingCubes::count(const Lattice& lattice, core::Isa isa) {
    counts_.assign(row_index(lattice, 0, lattice.nz), {});
    const auto& kernels = core::kernels<MarchingKernels>(isa);
    const CubeCase* table = cube_table().data();
    pool_.run(static_cast<std::size_t>(lattice.nz), [&](std::size_t layer, int) {
        const int k = static_cast<int>(layer);
        for (int j = 0; j < lattice.ny; ++j) {
            const std::size_t row = row_index(lattice, j, k), above = row_index(lattice, j, k + 1);
            const bool has_y = j + 1 < lattice.ny, has_z = k + 1 < lattice.nz;
            RowCounts& counts = counts_[row];
            counts.x = kernels.count_edges(bits(row), bits(row), lattice.nx);
            if (has_y) counts.y = kernels.count_edges(bits(row), bits(row + 1), lattice.nx);
            if (has_z) counts.z = kernels.count_edges(bits(row), bits(above), lattice.nx);
            if (!has_y || !has_z) continue;
            const CellRowBits cells{{bits(row), bits(row + 1), bits(above), bits(above + 1)},
                                    lattice.nx};
            counts.triangles = kernels.count_triangles(cells, table);
        }
    });
}

void MarchingCubes::allocate(const MarchingOptions& options, TriangleMesh& mesh) {
    std::uint64_t vertices = 0, triangles = 0;
    starts_.resize(counts_.size());
    for (std::size_t row = 0; row < counts_.size(); ++row) {
        starts_[row] = {static_cast<std::uint32_t>(vertices), static_cast<std::uint32_t>(triangles)};
        const RowCounts& counts = counts_[row];
        vertices += std::uint64_t{counts.x} + counts.y + counts.z;
        triangles += counts.triangles;
    }
    PASTOSO_CHECK_OP(vertices, <=, std::numeric_limits<std::uint32_t>::max());
    PASTOSO_CHECK_OP(triangles, <=, std::numeric_limits<std::uint32_t>::max());
    mesh.positions_m.resize(vertices);
    mesh.normals.resize(options.normals ? vertices : 0);
    mesh.triangles.resize(triangles);
}

void MarchingCubes::place_row(const SampleView& samples, int j, int k, float iso,
                              const MarchingOptions& options, Scratch& scratch,
                              TriangleMesh& mesh) const {
    const auto& kernels = core::kernels<MarchingKernels>(options.isa);
    const Lattice& lattice = samples.lattice;
    const std::size_t row = row_index(lattice, j, k);
    const RowCounts& counts = counts_[row];
    const std::uint32_t of_axis[3] = {counts.x, counts.y, counts.z};
    const std::size_t others[3] = {row, row + 1, row_index(lattice, j, k + 1)};
    std::size_t vertex = starts_[row].vertex;
    for (int axis = 0; axis < 3; ++axis) {
        if (of_axis[axis] == 0) continue;
        const VertexColumns columns = columns_in(scratch.numbers, lattice.nx);
        scratch.places.resize(static_cast<std::size_t>(lattice.nx));
        const int count =
            kernels.compute_edges(bits(row), bits(others[axis]), lattice.nx, scratch.places.data());
        kernels.place(edge_row(samples, j, k, axis, iso), scratch.places.data(), count, options.normals,
                      columns);
        gather_columns(columns.position, count, mesh.positions_m.data() + vertex);
        if (options.normals) gather_columns(columns.normal, count, mesh.normals.data() + vertex);
        vertex += static_cast<std::size_t>(count);
    }
}

void MarchingCubes::connect_row(const Lattice& lattice, int j, int k, core::Isa isa,
                                TriangleMesh& mesh) const {
    const std::size_t row = row_index(lattice, j, k), above = row_index(lattice, j, k + 1);
    if (counts_[row].triangles == 0) return;
    const std::size_t rows[4] = {row, row + 1, above, above + 1};
    CellRowBits cells{{}, lattice.nx};
    CellRowVertices vertices{};
    for (int r = 0; r < 4; ++r) {
        cells.row[r] = bits(rows[r]);
        vertices.x[r] = starts_[rows[r]].vertex;
    }
    for (int r = 0; r < 2; ++r) {
        const std::size_t y_row = rows[2 * r], z_row = rows[r];
        vertices.y[r] = starts_[y_row].vertex + counts_[y_row].x;
        vertices.z[r] = starts_[z_row].vertex + counts_[z_row].x + counts_[z_row].y;
    }
    core::kernels<MarchingKernels>(isa).connect(cells, vertices, cube_table().data(),
                                                mesh.triangles[starts_[row].triangle].data());
}

void MarchingCubes::run(const SampleView& given, float iso, const MarchingOptions& options,
                        TriangleMesh& mesh) {
    const SampleView samples = options.border == MeshBorder::Closed ? padded(given) : given;
    const Lattice& lattice = samples.lattice;
    mark(samples, iso, options.isa);
    count(lattice, options.isa);
    allocate(options, mesh);
    scratch_.resize(static_cast<std::size_t>(pool_.thread_count()));
    pool_.run(static_cast<std::size_t>(lattice.nz), [&](std::size_t layer, int worker) {
        const int k = static_cast<int>(layer);
        for (int j = 0; j < lattice.ny; ++j) {
            place_row(samples, j, k, iso, options, scratch_[static_cast<std::size_t>(worker)], mesh);
            connect_row(lattice, j, k, options.isa, mesh);
        }
    });
}

TriangleMesh marching_cubes(const SampleView& samples, float iso, core::ThreadPool& pool,
                            const MarchingOptions& options) {
    TriangleMesh mesh;
    MarchingCubes(pool).run(samples, iso, options, mesh);
    return mesh;
}

}  // namespace pastoso::liquid
