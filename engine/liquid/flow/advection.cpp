#include "liquid/flow/advection.hpp"

#include "core/check.hpp"
#include "liquid/flow/slices.hpp"

namespace pastoso::liquid {
namespace {

/// How far beyond the rows the way back may read the velocity.
constexpr int kCentreMargin_cells = 3;

}  // namespace

Advection::Advection(const grid::BoxShape& shape, const std::array<RowRanges, 4>& rows, Edges edges,
                     const Kernels& kernels)
    : shape_(shape),
      rows_(rows),
      edges_(edges),
      kernels_(&kernels),
      centres_(4 * shape.sample_count(), 0.0F),
      centre_rows_(static_cast<std::size_t>(shape.ny + 2) * static_cast<std::size_t>(shape.nz + 2)) {
    compute_centre_rows();
}

void Advection::set_rows(const std::array<RowRanges, 4>& rows) {
    rows_ = rows;
    centre_rows_.assign(centre_rows_.size(), RowRange{});
    compute_centre_rows();
}

void Advection::compute_centre_rows() {
    const RowRanges& cells = rows_[static_cast<std::size_t>(Location::Cell)];
    for (int k = 0; k < shape_.nz; ++k)
        for (int j = 0; j < shape_.ny; ++j) {
            const RowRange row = cells.at(j, k);
            if (row.empty()) continue;
            const int begin = std::max(row.begin - kCentreMargin_cells, -1);
            const int end = std::min(row.end + kCentreMargin_cells, shape_.nx + 1);
            for (int near_k = std::max(k - kCentreMargin_cells, -1);
                 near_k <= std::min(k + kCentreMargin_cells, shape_.nz); ++near_k)
                for (int near_j = std::max(j - kCentreMargin_cells, -1);
                     near_j <= std::min(j + kCentreMargin_cells, shape_.ny); ++near_j) {
                    RowRange& near = centre_row(near_j, near_k);
                    near = near.empty() ? RowRange{begin, end}
                                        : RowRange{std::min(near.begin, begin), std::max(near.end, end)};
                }
        }
}

void Advection::follow(const VelocityField& velocity, core::ThreadPool& pool) {
    PASTOSO_CHECK(velocity.shape() == shape_);
    for_slices(pool, -1, shape_.nz + 1, [&](int k) {
        for (int j = -1; j <= shape_.ny; ++j) {
            const RowRange row = centre_row(j, k);
            const FaceRows faces = {velocity.x.row(j, k) + row.begin, velocity.y.row(j, k) + row.begin,
                                    velocity.z.row(j, k) + row.begin, shape_.stride_y(),
                                    shape_.stride_z()};
            kernels_->centre_velocity(faces, row.end - row.begin,
                                      centres_.data() + 4 * shape_.index(row.begin, j, k));
        }
    });
}

void Advection::advect(std::span<const AdvectedPair> fields, Location location, float dt_s,
                       Interpolation interpolation, core::ThreadPool& pool) const {
    PASTOSO_CHECK_OP(fields.size(), <=, kMaxFieldsTogether);
    const AdvectionView view = {
        centres_.data() + 4 * shape_.index(0, 0, 0),
        shape_.stride_y(),
        shape_.stride_z(),
        {static_cast<float>(shape_.nx), static_cast<float>(shape_.ny), static_cast<float>(shape_.nz)},
        dt_s / shape_.cell_m,
        edges_};
    const RowRanges& rows = rows_[static_cast<std::size_t>(location)];
    const auto counts = sample_counts(shape_, location);
    for_slices(pool, 0, counts[2], [&](int k) {
        for (int j = 0; j < counts[1]; ++j) {
            const RowRange range = rows.at(j, k);
            if (range.empty()) continue;
            AdvectedRow row = {range.begin,
                               range.end,
                               j,
                               k,
                               static_cast<int>(location),
                               interpolation,
                               static_cast<int>(fields.size()),
                               {}};
            for (std::size_t f = 0; f < fields.size(); ++f)
                row.fields[f] = {fields[f].from->row(0, 0), fields[f].to->row(j, k)};
            kernels_->advect_row(view, row);
        }
    });
}

void carry_points(std::span<glm::vec3> points_m, const VelocityField& velocity, float dt_s, Edges edges,
                  Interpolation interpolation, core::ThreadPool& pool, const Kernels& kernels) {
    const grid::BoxShape& shape = velocity.shape();
    const CarryView view = {
        {velocity.x.row(0, 0), velocity.y.row(0, 0), velocity.z.row(0, 0)},
        shape.stride_y(),
        shape.stride_z(),
        {static_cast<float>(shape.nx), static_cast<float>(shape.ny), static_cast<float>(shape.nz)},
        dt_s / shape.cell_m,
        edges,
        interpolation};
    constexpr std::size_t kBlock = 256;
    pool.run((points_m.size() + kBlock - 1) / kBlock, [&](std::size_t block, int) {
        const auto part =
            points_m.subspan(block * kBlock, std::min(kBlock, points_m.size() - block * kBlock));
        alignas(16) std::array<float, 4 * kBlock> cells;
        for (std::size_t p = 0; p < part.size(); ++p) {
            const glm::vec3 at = part[p] / shape.cell_m;
            cells[4 * p] = at.x;
            cells[4 * p + 1] = at.y;
            cells[4 * p + 2] = at.z;
            cells[4 * p + 3] = 0.0F;
        }
        kernels.carry_points(view, cells.data(), static_cast<int>(part.size()));
        for (std::size_t p = 0; p < part.size(); ++p)
            part[p] = glm::vec3(cells[4 * p], cells[4 * p + 1], cells[4 * p + 2]) * shape.cell_m;
    });
}

}  // namespace pastoso::liquid
