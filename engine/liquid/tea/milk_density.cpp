#include "liquid/tea/milk_density.hpp"

#include "core/check.hpp"
#include "liquid/tea/between.hpp"
#include "liquid/tea/parcel_cells.hpp"
#include "liquid/tea/parcel_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>

namespace pastoso::liquid {
namespace {

/// A slab is a layer of blocks.
constexpr int kSide = grid::BlockField::kSide;
constexpr int kLeastCells = 8, kMostCells = 384;
/// A kernel less of which lies in the tea is not told from rounding.
constexpr float kLeastSum = 1e-2F;
/// Of the variance that sharing among the flow's cells gives to milk, h^2 / 3: a parcel that has become
/// wider by as much is drawn as dissolved milk is.
constexpr float kWide = 0.5F;
/// What is less in a cell is seen nowhere.
constexpr float kLeastDissolved = 1e-8F;

RowRange tea_row(const Cup& cup, const grid::BoxShape& shape, int j, int k) {
    const auto middle_m = [&](int i) { return (static_cast<float>(i) + 0.5F) * shape.cell_m; };
    const float z_m = middle_m(k), y_m = middle_m(j) - cup.axis_m.y;
    if (z_m < cup.floor_m || z_m > cup.level_m) return {};
    const float radius_m = cup.inner_radius_m(z_m), half2_m2 = radius_m * radius_m - y_m * y_m;
    if (half2_m2 <= 0.0F) return {};
    const float half = std::sqrt(half2_m2) / shape.cell_m, axis = cup.axis_m.x / shape.cell_m - 0.5F;
    return {std::max(0, static_cast<int>(std::ceil(axis - half))),
            std::min(shape.nx, static_cast<int>(std::floor(axis + half)) + 1)};
}

/// Of a parcel on the lattice, in cells of whose middles the first lies at 0.
glm::vec3 place_of(const Parcel& parcel, const grid::BoxShape& shape) {
    return parcel.position_m / shape.cell_m - 0.5F;
}

glm::ivec3 nearest_cell(const glm::vec3& place, const grid::BoxShape& shape) {
    return glm::clamp(glm::ivec3(glm::floor(place + 0.5F)), glm::ivec3(0),
                      glm::ivec3(shape.nx, shape.ny, shape.nz) - 1);
}

RowRange overlap(const RowRange& a, const RowRange& b) {
    return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

/// Calls visit(j, k, row) for the rows of a kernel's cells, in some layers, that lie in the tea.
template <class Visit>
void for_rows_in_tea(const ParcelKernel& kernel, const RowRange& layers, const grid::BoxShape& shape,
                     const RowRanges& in_tea, const Visit& visit) {
    kernel.for_rows(shape.ny, layers, [&](int j, int k, ParcelKernel::Row row) {
        row.cells = overlap(row.cells, in_tea.at(j, k));
        if (!row.cells.empty()) visit(j, k, row);
    });
}

float kernel_sum(const ParcelKernel& kernel, const grid::BoxShape& shape, const RowRanges& in_tea) {
    float sum = 0.0F;
    for_rows_in_tea(kernel, {0, shape.nz}, shape, in_tea,
                    [&](int, int, const ParcelKernel::Row& row) { sum += row.sum(); });
    return sum;
}

/// A row of `field`, interpolated across to row (j, k) of a lattice whose cells are `ratio` of its own,
/// with a ghost at each end.
void rows_between(const grid::BoxField& field, int j, int k, float ratio, std::vector<float>& row) {
    const auto across = [ratio](int cell) {
        return between_middles((static_cast<float>(cell) + 0.5F) * ratio);
    };
    const Between y = across(j), z = across(k);
    const float *low = field.row(y.lower, z.lower), *low_next = field.row(y.lower + 1, z.lower),
                *high = field.row(y.lower, z.lower + 1),
                *high_next = field.row(y.lower + 1, z.lower + 1);
    for (int i = -1; i <= field.shape().nx; ++i) {
        const float lower = low[i] + (low_next[i] - low[i]) * y.part,
                    upper = high[i] + (high_next[i] - high[i]) * y.part;
        row[static_cast<std::size_t>(i + 1)] = lower + (upper - lower) * z.part;
    }
}

double sum_of_open(const grid::BoxField& field, const grid::BoxField& open) {
    const grid::BoxShape& shape = field.shape();
    double sum = 0.0;
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i)
                sum += static_cast<double>(field.at(i, j, k) * open.at(i, j, k));
    return sum * shape.cell_volume_m3();
}

/// The eight cells of the flow whose middles are around a parcel, as far as they are open.
class CellsAround {
  public:
    CellsAround(const Parcel& parcel, const grid::BoxField& open_cells)
        : open_cells_(open_cells),
          place_(parcel.position_m / open_cells.shape().cell_m - 0.5F),
          low_(glm::floor(place_)) {
        for (const int z : {0, 1})
            for (const int y : {0, 1})
                for (const int x : {0, 1})
                    sum_ += weight({x, y, z});
    }
    /// -1 or more.
    static int lowest_layer(const Parcel& parcel, const grid::BoxShape& shape) {
        return static_cast<int>(std::floor(parcel.position_m.z / shape.cell_m - 0.5F));
    }
    bool any() const { return sum_ > 0.0F; }
    /// To those in one layer their share.
    void add(float amount, int layer, grid::BoxField& field) const {
        for (const int y : {0, 1})
            for (const int x : {0, 1})
                field.at(low_.x + x, low_.y + y, layer) +=
                    amount * weight({x, y, layer - low_.z}) / sum_;
    }

  private:
    float weight(const glm::ivec3& corner) const {
        const glm::ivec3 cell = low_ + corner;
        const glm::vec3 near = 1.0F - glm::abs(place_ - glm::vec3(cell));
        return near.x * near.y * near.z * open_cells_.at(cell.x, cell.y, cell.z);
    }

    const grid::BoxField& open_cells_;
    glm::vec3 place_;
    glm::ivec3 low_;
    float sum_ = 0.0F;
};

/// Marks the blocks that keep cells from `low` to `high`.
void mark(const glm::ivec3& low, const glm::ivec3& high, const glm::ivec3& blocks,
          std::vector<char>& marks) {
    const glm::ivec3 from = glm::clamp((low - 1) / kSide, glm::ivec3(0), blocks - 1),
                     to = glm::clamp(high / kSide, glm::ivec3(0), blocks - 1);
    for (int z = from.z; z <= to.z; ++z)
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x)
                marks[static_cast<std::size_t>(x + blocks.x * (y + blocks.y * z))] = 1;
}

}  // namespace

MilkDensitySettings even_density(const TeaSettings& settings) {
    const auto reach_m = static_cast<double>(poured_reach_m(settings));
    const MilkDensitySettings finest;
    const double cells = std::clamp(static_cast<double>(kMostReach_cells) * settings.box_m / reach_m,
                                    static_cast<double>(kLeastCells), static_cast<double>(finest.cells));
    return {static_cast<int>(cells), static_cast<float>(reach_m)};
}

void MilkDensities::set_tea(const grid::BoxShape& flow, const Cup& cup) {
    if (walls_ && walls_->shape() == flow && cup_ == cup) return;
    cup_ = cup;
    shape_ = {};
    const Cup flow_cup = filled_in_cells(cup, flow.cell_m);
    if (walls_ && walls_->shape() == flow && flow_cup == flow_cup_) return;
    flow_cup_ = flow_cup;
    walls_.emplace(flow,
                   [flow_cup](const glm::vec3& point_m) { return tea_distance_m(flow_cup, point_m); });
}

void MilkDensities::set_lattice(int cells) {
    const grid::BoxShape& flow = walls_->shape();
    const float cell_m = flow.cell_m * static_cast<float>(flow.nx) / static_cast<float>(cells);
    const grid::BoxShape shape{cells, cells, cells, cell_m};
    if (shape == shape_) return;
    shape_ = shape;
    in_tea_ = RowRanges(shape);
    for (int k = 0; k < cells; ++k)
        for (int j = 0; j < cells; ++j)
            in_tea_.at(j, k) = tea_row(cup_, shape, j, k);
}

ParcelKernel MilkDensities::kernel_of(const Parcel& parcel) const {
    return {place_of(parcel, shape_), parcel.shape, reach_cells_};
}

void MilkDensities::sort_into_slabs(std::span<const Parcel> parcels) {
    const int slabs = grid::BlockField::block_counts(shape_).z;
    const auto slab_of = [&](const Parcel& parcel) {
        return static_cast<std::size_t>(nearest_cell(place_of(parcel, shape_), shape_).z / kSide);
    };
    order_ = CountingOrder(parcels, static_cast<std::size_t>(slabs), slab_of);
    float reach = 0.0F;
    for (std::size_t i = 0; i < parcels.size(); ++i)
        if (wide_[i] < 1.0F) reach = std::max(reach, kernel_of(parcels[i]).reach().z);
    slabs_reached_ = static_cast<int>(std::ceil(reach / static_cast<float>(kSide)));
}

std::vector<char> MilkDensities::blocks_reached(std::span<const Parcel> parcels) const {
    const glm::ivec3 blocks = grid::BlockField::block_counts(shape_);
    std::vector<char> marks(static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z, 0);
    for (std::size_t i = 0; i < parcels.size(); ++i) {
        if (wide_[i] == 1.0F) continue;
        const ParcelKernel kernel = kernel_of(parcels[i]);
        mark(glm::floor(kernel.place() - kernel.reach()), glm::ceil(kernel.place() + kernel.reach()),
             blocks, marks);
    }
    const grid::BoxShape& flow = dissolved_.shape();
    const float ratio = static_cast<float>(shape_.nx) / static_cast<float>(flow.nx);
    for (int k = 0; k < flow.nz; ++k)
        for (int j = 0; j < flow.ny; ++j)
            for (int i = 0; i < flow.nx; ++i) {
                if (dissolved_.at(i, j, k) < kLeastDissolved) continue;
                const glm::vec3 cell(i, j, k);
                mark(glm::floor((cell - 0.5F) * ratio), glm::ceil((cell + 1.5F) * ratio), blocks, marks);
            }
    return marks;
}

/// Interpolates what has dissolved into the cells of a slab that lie in the tea. Returns their sum.
double MilkDensities::lay_dissolved(int slab, grid::BlockField& density) const {
    const grid::BoxShape& flow = dissolved_.shape();
    const float ratio = static_cast<float>(flow.nx) / static_cast<float>(shape_.nx);
    std::vector<float> row(static_cast<std::size_t>(flow.nx) + 2);
    double sum = 0.0;
    for (int k = slab * kSide; k < std::min(shape_.nz, (slab + 1) * kSide); ++k)
        for (int j = 0; j < shape_.ny; ++j) {
            const RowRange tea = in_tea_.at(j, k);
            if (tea.empty()) continue;
            rows_between(dissolved_, j, k, ratio, row);
            float* block = nullptr;
            for (int i = tea.begin; i < tea.end; ++i) {
                if (i == tea.begin || i % kSide == 0)
                    block = density.block(density.index({i / kSide, j / kSide, slab}));
                if (block == nullptr) continue;
                const Between x = between_middles((static_cast<float>(i) + 0.5F) * ratio);
                const float* lower = row.data() + x.lower + 1;
                const float share = std::max(lower[0] + (lower[1] - lower[0]) * x.part, 0.0F);
                block[grid::BlockField::sample(i % kSide, j % kSide, k % kSide)] = share;
                sum += static_cast<double>(share);
            }
        }
    return sum * shape_.cell_volume_m3();
}

/// The part of each parcel that is so wide that it is spread as dissolved milk is: none of one that has
/// its poured width, or no open cell of the flow around it.
void MilkDensities::part_wide(std::span<const Parcel> parcels, float reach_m) {
    const float cells = reach_m / walls_->shape().cell_m, per_width = cells * cells / (3.0F * kWide);
    wide_.resize(parcels.size());
    for_parcels(pool_, parcels.size(), [&](std::size_t i) {
        const float part = std::min((width(parcels[i].shape) - 1.0F) * per_width, 1.0F);
        const bool is_shared = part > 0.0F && CellsAround(parcels[i], walls_->open_cells()).any();
        wide_[i] = is_shared ? part : 0.0F;
    });
}

/// Adds the wide parts to `dissolved_`, each layer of cells on a thread of its own.
void MilkDensities::add_wide(std::span<const Parcel> parcels) {
    const grid::BoxShape& flow = dissolved_.shape();
    const CountingOrder order(parcels, static_cast<std::size_t>(flow.nz) + 1, [&](const Parcel& parcel) {
        return static_cast<std::size_t>(CellsAround::lowest_layer(parcel, flow) + 1);
    });
    const auto per_m3 = static_cast<float>(1.0 / flow.cell_volume_m3());
    pool_.run(static_cast<std::size_t>(flow.nz), [&](std::size_t k, int) {
        for (const std::uint32_t i : order.groups_between(k, k + 2)) {
            if (wide_[i] == 0.0F) continue;
            const CellsAround cells(parcels[i], walls_->open_cells());
            cells.add(wide_[i] * parcels[i].volume_m3 * per_m3, static_cast<int>(k), dissolved_);
        }
    });
}

/// What a parcel gives to a cell in which its kernel is 1, or 0: it has none in the tea.
void MilkDensities::weigh(std::span<const Parcel> parcels) {
    const auto cell_m3 = static_cast<float>(shape_.cell_volume_m3());
    scales_.resize(parcels.size());
    for_parcels(pool_, parcels.size(), [&](std::size_t i) {
        scales_[i] = 0.0F;
        if (wide_[i] == 1.0F) return;
        const float sum = kernel_sum(kernel_of(parcels[i]), shape_, in_tea_);
        if (sum > kLeastSum) scales_[i] = (1.0F - wide_[i]) * parcels[i].volume_m3 / cell_m3 / sum;
    });
}

/// Spreads the parcels that reach into a slab over its layers of cells.
void MilkDensities::add_parcels(std::span<const Parcel> parcels, int slab,
                                std::vector<float>& layers) const {
    const int slabs = static_cast<int>(order_.groups()), k0 = slab * kSide;
    const RowRange slab_layers = {k0, std::min(k0 + kSide, shape_.nz)};
    const auto cell_m3 = static_cast<float>(shape_.cell_volume_m3());
    const auto layer_row = [&](int j, int k) {
        return layers.data() + static_cast<std::size_t>((k - k0) * shape_.ny + j) * shape_.nx;
    };
    const int first = std::max(slab - slabs_reached_, 0),
              end = std::min(slab + slabs_reached_ + 1, slabs);
    for (const std::uint32_t number : order_.groups_between(first, end)) {
        const Parcel& parcel = parcels[number];
        if (wide_[number] == 1.0F) continue;
        const float scale = scales_[number];
        if (scale == 0.0F) {
            const glm::ivec3 cell = nearest_cell(place_of(parcel, shape_), shape_);
            if (cell.z / kSide == slab)
                layer_row(cell.y, cell.z)[cell.x] += (1.0F - wide_[number]) * parcel.volume_m3 / cell_m3;
            continue;
        }
        const auto add = [&](int j, int k, const ParcelKernel::Row& row) {
            float* cells = layer_row(j, k);
            for (int i = row.cells.begin; i < row.cells.end; ++i)
                cells[i] += scale * row.at(i);
        };
        for_rows_in_tea(kernel_of(parcel), slab_layers, shape_, in_tea_, add);
    }
}

/// A slab's dissolved milk, scaled, and its parcels.
void MilkDensities::finish(std::span<const Parcel> parcels, float scale, int slab,
                           std::vector<float>& layers, grid::BlockField& density) const {
    layers.assign(static_cast<std::size_t>(shape_.nx) * shape_.ny * kSide, 0.0F);
    add_parcels(parcels, slab, layers);
    const glm::ivec3 blocks = density.blocks();
    for (int y = 0; y < blocks.y; ++y)
        for (int x = 0; x < blocks.x; ++x) {
            float* block = density.block(density.index({x, y, slab}));
            if (block == nullptr) continue;
            const int width = std::min(kSide, shape_.nx - x * kSide),
                      depth = std::min(kSide, shape_.ny - y * kSide);
            for (int k = 0; k < kSide; ++k)
                for (int j = 0; j < depth; ++j) {
                    const float* from =
                        layers.data() +
                        static_cast<std::size_t>(k * shape_.ny + y * kSide + j) * shape_.nx + x * kSide;
                    float* to = block + grid::BlockField::sample(0, j, k);
                    for (int i = 0; i < width; ++i)
                        to[i] = to[i] * scale + from[i];
                }
        }
}

grid::BlockField MilkDensities::make(std::span<const Parcel> parcels, const grid::BoxField& dissolved,
                                     const Cup& cup, const MilkDensitySettings& settings) {
    PASTOSO_CHECK(settings.cells >= kLeastCells && settings.cells <= kMostCells);
    set_tea(dissolved.shape(), cup);
    set_lattice(settings.cells);
    reach_cells_ = std::min(settings.reach_m / shape_.cell_m, kMostReach_cells);
    part_wide(parcels, settings.reach_m);
    dissolved_ = dissolved;
    add_wide(parcels);
    const double dissolved_m3 = sum_of_open(dissolved_, walls_->open_cells());
    walls_->extrapolate(dissolved_, Location::Cell, pool_);
    sort_into_slabs(parcels);
    weigh(parcels);
    grid::BlockField density(shape_, blocks_reached(parcels));
    const auto slabs = static_cast<std::size_t>(density.blocks().z);
    std::vector<double> sums(slabs);
    pool_.run(slabs, [&](std::size_t slab, int) {
        sums[slab] = lay_dissolved(static_cast<int>(slab), density);
    });
    const double laid_m3 = std::accumulate(sums.begin(), sums.end(), 0.0);
    const auto scale = laid_m3 > 0.0 ? static_cast<float>(dissolved_m3 / laid_m3) : 0.0F;
    std::vector<std::vector<float>> layers(static_cast<std::size_t>(pool_.thread_count()));
    pool_.run(slabs, [&](std::size_t slab, int worker) {
        finish(parcels, scale, static_cast<int>(slab), layers[static_cast<std::size_t>(worker)],
               density);
    });
    pool_.run(slabs, [&](std::size_t slab, int) {
        density.copy_borders(static_cast<int>(slab), static_cast<int>(slab) + 1);
    });
    return density;
}

}  // namespace pastoso::liquid
