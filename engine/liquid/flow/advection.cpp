#include "liquid/flow/advection.hpp"

#include "core/check.hpp"
#include "liquid/flow/slices.hpp"

namespace pastoso::liquid {
namespace {

/// How far beyond the rows the way back may read the velocity.
constexpr int kCentreMargin_cells = 3;

std::array<grid::BoxField, 3> three_fields(const grid::BoxShape& shape) {
    return {grid::BoxField(shape), grid::BoxField(shape), grid::BoxField(shape)};
}
std::array<const float*, 3> first_samples(const std::array<grid::BoxField, 3>& fields) {
    return {fields[0].row(0, 0), fields[1].row(0, 0), fields[2].row(0, 0)};
}

}  // namespace

Advection::RowsAround::RowsAround(const grid::BoxShape& shape)
    : shape_(shape),
      rows_y_(shape.ny + 2),
      rows_(static_cast<std::size_t>(rows_y_) * static_cast<std::size_t>(shape.nz + 2)) {}

void Advection::RowsAround::include(RowRange range, int j, int k) {
    if (range.empty() || j < -1 || j > shape_.ny || k < -1 || k > shape_.nz) return;
    range = {std::max(range.begin, -1), std::min(range.end, shape_.nx + 1)};
    RowRange& row = at(j, k);
    row = row.empty() ? range : RowRange{std::min(row.begin, range.begin), std::max(row.end, range.end)};
}

Advection::Advection(const grid::BoxShape& shape, const std::array<RowRanges, 4>& rows, Edges edges,
                     const Kernels& kernels, WaysOf ways_of)
    : shape_(shape),
      rows_(rows),
      edges_(edges),
      ways_of_(ways_of),
      kernels_(&kernels),
      centres_(three_fields(shape)),
      ways_(three_fields(shape)),
      centre_rows_(shape),
      way_rows_(shape) {
    compute_rows();
}

void Advection::set_rows(const std::array<RowRanges, 4>& rows) {
    rows_ = rows;
    compute_rows();
}

/// Ways are needed of all cells beside samples, and the velocity some cells around those.
void Advection::compute_rows() {
    way_rows_ = centre_rows_ = RowsAround(shape_);
    for (int k = 0; k <= shape_.nz; ++k)
        for (int j = 0; j <= shape_.ny; ++j)
            for (const Location location :
                 {Location::FaceX, Location::FaceY, Location::FaceZ, Location::Cell}) {
                const RowRange row = rows_[static_cast<std::size_t>(location)].at(j, k);
                if (row.empty()) continue;
                const int before = location == Location::FaceX ? 1 : 0;
                way_rows_.include({row.begin - before, row.end}, j, k);
                if (location == Location::FaceY) way_rows_.include(row, j - 1, k);
                if (location == Location::FaceZ) way_rows_.include(row, j, k - 1);
            }
    for (int k = -1; k <= shape_.nz; ++k)
        for (int j = -1; j <= shape_.ny; ++j) {
            const RowRange row = way_rows_.at(j, k);
            if (row.empty()) continue;
            const RowRange wide = {row.begin - kCentreMargin_cells, row.end + kCentreMargin_cells};
            for (int near_k = k - kCentreMargin_cells; near_k <= k + kCentreMargin_cells; ++near_k)
                for (int near_j = j - kCentreMargin_cells; near_j <= j + kCentreMargin_cells; ++near_j)
                    centre_rows_.include(wide, near_j, near_k);
        }
}

void Advection::follow(const VelocityField& velocity, core::ThreadPool& pool) {
    PASTOSO_CHECK(velocity.shape() == shape_);
    traced_s_ = -1.0F;
    for_slices(pool, -1, shape_.nz + 1, [&](int k) {
        for (int j = -1; j <= shape_.ny; ++j) {
            const RowRange row = centre_rows_.at(j, k);
            const FaceRows faces = face_rows(velocity, row.begin, j, k);
            const std::array out = {centres_[0].row(j, k) + row.begin, centres_[1].row(j, k) + row.begin,
                                    centres_[2].row(j, k) + row.begin};
            kernels_->centre_velocity(faces, row.end - row.begin, out.data());
        }
    });
}

AdvectionView Advection::view(float dt_s) const {
    const auto centres = first_samples(centres_), ways = first_samples(ways_);
    const std::ptrdiff_t first = shape_.index(0, 0, 0);
    return {
        {centres[0], centres[1], centres[2]},
        {ways[0], ways[1], ways[2]},
        ways_of_ == WaysOf::Cells,
        shape_.stride_y(),
        shape_.stride_z(),
        -first,
        static_cast<std::ptrdiff_t>(shape_.sample_count()) - first,
        {static_cast<float>(shape_.nx), static_cast<float>(shape_.ny), static_cast<float>(shape_.nz)},
        dt_s / shape_.cell_m,
        edges_};
}

void Advection::trace_row(const AdvectionView& flow, RowRange row, int j, int k, Location location) {
    kernels_->trace_row(flow, {row.begin,
                               row.end,
                               j,
                               k,
                               static_cast<int>(location),
                               {ways_[0].row(j, k), ways_[1].row(j, k), ways_[2].row(j, k)}});
}

void Advection::trace_cells(float dt_s, core::ThreadPool& pool) {
    if (traced_s_ == dt_s) return;
    const AdvectionView flow = view(dt_s);
    for_slices(pool, -1, shape_.nz + 1, [&](int k) {
        for (int j = -1; j <= shape_.ny; ++j)
            trace_row(flow, way_rows_.at(j, k), j, k, Location::Cell);
    });
    traced_s_ = dt_s;
}

void Advection::trace_samples(Location location, float dt_s, core::ThreadPool& pool) {
    const AdvectionView flow = view(dt_s);
    const auto counts = sample_counts(shape_, location);
    for_slices(pool, 0, counts[2], [&](int k) {
        for (int j = 0; j < counts[1]; ++j)
            trace_row(flow, rows_[static_cast<std::size_t>(location)].at(j, k), j, k, location);
    });
}

void Advection::advect(std::span<const AdvectedPair> fields, Location location, float dt_s,
                       Interpolation interpolation, core::ThreadPool& pool) {
    PASTOSO_CHECK_OP(fields.size(), <=, kMaxFieldsTogether);
    if (ways_of_ == WaysOf::Cells)
        trace_cells(dt_s, pool);
    else
        trace_samples(location, dt_s, pool);
    const AdvectionView flow = view(dt_s);
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
            kernels_->advect_row(flow, row);
        }
    });
}

namespace {

constexpr std::size_t kCarriedAtOnce = 256;

void carry_block(std::span<glm::vec3> points_m, const CarryView& view, float cell_m,
                 const Kernels& kernels) {
    alignas(64) std::array<std::array<float, kCarriedAtOnce>, 3> cells;
    // Whole groups are carried: what is beyond the points lies in the corner.
    const std::size_t count =
        (points_m.size() + kPointsTogether - 1) / kPointsTogether * kPointsTogether;
    for (std::size_t axis = 0; axis < 3; ++axis)
        std::fill_n(cells[axis].begin() + static_cast<std::ptrdiff_t>(points_m.size()),
                    count - points_m.size(), 0.0F);
    for (std::size_t p = 0; p < points_m.size(); ++p) {
        const glm::vec3 at = points_m[p] / cell_m;
        cells[0][p] = at.x;
        cells[1][p] = at.y;
        cells[2][p] = at.z;
    }
    kernels.carry_points(view, {{cells[0].data(), cells[1].data(), cells[2].data()}},
                         static_cast<int>(count));
    for (std::size_t p = 0; p < points_m.size(); ++p)
        points_m[p] = glm::vec3(cells[0][p], cells[1][p], cells[2][p]) * cell_m;
}

CarryView carry_view(const VelocityField& velocity, float dt_s, Edges edges,
                     Interpolation interpolation) {
    const grid::BoxShape& shape = velocity.shape();
    return {{velocity.x.row(0, 0), velocity.y.row(0, 0), velocity.z.row(0, 0)},
            shape.stride_y(),
            shape.stride_z(),
            {static_cast<float>(shape.nx), static_cast<float>(shape.ny), static_cast<float>(shape.nz)},
            dt_s / shape.cell_m,
            edges,
            interpolation};
}

}  // namespace

void carry_points(std::span<glm::vec3> points_m, const VelocityField& velocity, float dt_s, Edges edges,
                  Interpolation interpolation, core::ThreadPool& pool, const Kernels& kernels) {
    const CarryView view = carry_view(velocity, dt_s, edges, interpolation);
    pool.run((points_m.size() + kCarriedAtOnce - 1) / kCarriedAtOnce, [&](std::size_t block, int) {
        const std::size_t begin = block * kCarriedAtOnce;
        carry_block(points_m.subspan(begin, std::min(kCarriedAtOnce, points_m.size() - begin)), view,
                    velocity.shape().cell_m, kernels);
    });
}

void carry_points(std::span<glm::vec3> points_m, const VelocityField& velocity, float dt_s, Edges edges,
                  Interpolation interpolation, const Kernels& kernels) {
    const CarryView view = carry_view(velocity, dt_s, edges, interpolation);
    for (; !points_m.empty(); points_m = points_m.subspan(std::min(kCarriedAtOnce, points_m.size())))
        carry_block(points_m.first(std::min(kCarriedAtOnce, points_m.size())), view,
                    velocity.shape().cell_m, kernels);
}

}  // namespace pastoso::liquid
