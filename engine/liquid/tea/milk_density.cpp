#include "liquid/tea/milk_density.hpp"

#include "core/check.hpp"
#include "liquid/tea/between.hpp"
#include "liquid/tea/milk_jug.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>

namespace pastoso::liquid {
namespace {

/// A slab is a layer of blocks; parcels reach no farther than the next one.
constexpr int kSide = grid::BlockField::kSide;
/// Cells along the cube around what a parcel reaches.
constexpr int kKernelRow = 8;
static_assert(2.0F * kMostReach_cells < kKernelRow && kMostReach_cells < kSide);
constexpr int kLeastCells = 8, kMostCells = 384;
/// The reach of an even body, in distances of its parcels.
constexpr double kEvenReach = 1.75;
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

/// A parcel's kernel in the cells around it.
class Kernel {
  public:
    Kernel(const glm::vec3& place, float reach_cells)
        : first_(glm::ceil(place - reach_cells)), per_reach2_(1.0F / (reach_cells * reach_cells)) {
        const glm::vec3 offset = glm::vec3(first_) - place;
        for (int n = 0; n < kKernelRow; ++n)
            for (int axis = 0; axis < 3; ++axis) {
                const float away = offset[axis] + static_cast<float>(n);
                away2_[axis][n] = away * away * per_reach2_;
            }
    }

    const glm::ivec3& first() const { return first_; }

    /// (1 - r^2)^2 or 0 along a row. False where all of it is 0.
    bool row(int y, int z, std::array<float, kKernelRow>& weights) const {
        const float left = 1.0F - away2_[1][y] - away2_[2][z];
        if (left <= 0.0F) return false;
        for (int x = 0; x < kKernelRow; ++x) {
            const float within = std::max(left - away2_[0][x], 0.0F);
            weights[x] = within * within;
        }
        return true;
    }

  private:
    glm::ivec3 first_;
    float per_reach2_;
    std::array<std::array<float, kKernelRow>, 3> away2_;
};

/// Where a row of a kernel lies in the tea, in samples of the kernel.
RowRange kernel_range(const RowRange& tea, int first) {
    return {std::max(tea.begin - first, 0), std::min(tea.end - first, kKernelRow)};
}

/// Calls visit(j, k, range, weights) for the rows of a kernel that lie in the tea.
template <class Visit>
void for_kernel_rows(const Kernel& kernel, const grid::BoxShape& shape, const RowRanges& in_tea,
                     const Visit& visit) {
    std::array<float, kKernelRow> weights;
    for (int z = 0; z < kKernelRow; ++z) {
        const int k = kernel.first().z + z;
        if (k < 0 || k >= shape.nz) continue;
        for (int y = 0; y < kKernelRow; ++y) {
            const int j = kernel.first().y + y;
            if (j < 0 || j >= shape.ny || !kernel.row(y, z, weights)) continue;
            const RowRange range = kernel_range(in_tea.at(j, k), kernel.first().x);
            if (!range.empty()) visit(j, k, range, weights);
        }
    }
}

/// In a fixed order, whatever the width of registers.
float kernel_sum(const Kernel& kernel, const grid::BoxShape& shape, const RowRanges& in_tea) {
    std::array<float, kKernelRow> sums{};
    for_kernel_rows(kernel, shape, in_tea,
                    [&](int, int, const RowRange& range, const std::array<float, kKernelRow>& weights) {
                        for (int x = range.begin; x < range.end; ++x)
                            sums[x] += weights[x];
                    });
    return std::accumulate(sums.begin(), sums.end(), 0.0F);
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
    const auto parcel_m3 = static_cast<double>(milk_per_parcel_m3(settings));
    const double reach_m = kEvenReach * std::cbrt(parcel_m3);
    const MilkDensitySettings finest;
    const double cells = std::clamp(static_cast<double>(kMostReach_cells) * settings.box_m / reach_m,
                                    static_cast<double>(kLeastCells), static_cast<double>(finest.cells));
    return {static_cast<int>(cells), static_cast<float>(reach_m)};
}

void MilkDensities::set_tea(const grid::BoxShape& flow, const Cup& cup) {
    if (walls_ && walls_->shape() == flow && cup_ == cup) return;
    cup_ = cup;
    walls_.emplace(flow, [cup](const glm::vec3& point_m) { return tea_distance_m(cup, point_m); });
    shape_ = {};
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

void MilkDensities::sort_into_slabs(std::span<const Parcel> parcels) {
    const int slabs = grid::BlockField::block_counts(shape_).z;
    const auto slab_of = [&](const Parcel& parcel) {
        return static_cast<std::size_t>(nearest_cell(place_of(parcel, shape_), shape_).z / kSide);
    };
    order_ = CountingOrder(parcels, static_cast<std::size_t>(slabs), slab_of);
}

std::vector<char> MilkDensities::blocks_reached(std::span<const Parcel> parcels) const {
    const glm::ivec3 blocks = grid::BlockField::block_counts(shape_);
    std::vector<char> marks(static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z, 0);
    for (const Parcel& parcel : parcels) {
        const glm::vec3 place = place_of(parcel, shape_);
        mark(glm::floor(place - reach_cells_), glm::ceil(place + reach_cells_), blocks, marks);
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

/// Spreads the parcels that reach into a slab over its layers of cells.
void MilkDensities::add_parcels(std::span<const Parcel> parcels, int slab,
                                std::vector<float>& layers) const {
    const int slabs = static_cast<int>(order_.groups()), k0 = slab * kSide;
    const auto cell_m3 = static_cast<float>(shape_.cell_volume_m3());
    const auto layer_row = [&](int j, int k) {
        return layers.data() + static_cast<std::size_t>((k - k0) * shape_.ny + j) * shape_.nx;
    };
    for (const std::uint32_t number :
         order_.groups_between(std::max(slab - 1, 0), std::min(slab + 2, slabs))) {
        const Parcel& parcel = parcels[number];
        const glm::vec3 place = place_of(parcel, shape_);
        if (place.z + reach_cells_ < static_cast<float>(k0) ||
            place.z - reach_cells_ > static_cast<float>(k0 + kSide - 1))
            continue;
        const Kernel kernel(place, reach_cells_);
        const float sum = kernel_sum(kernel, shape_, in_tea_), share = parcel.volume_m3 / cell_m3;
        if (sum <= 0.0F) {
            const glm::ivec3 cell = nearest_cell(place, shape_);
            if (cell.z / kSide == slab) layer_row(cell.y, cell.z)[cell.x] += share;
            continue;
        }
        const float scale = share / sum;
        for_kernel_rows(
            kernel, shape_, in_tea_,
            [&](int j, int k, const RowRange& range, const std::array<float, kKernelRow>& weights) {
                if (k < k0 || k >= k0 + kSide) return;
                float* cells = layer_row(j, k) + kernel.first().x;
                for (int x = range.begin; x < range.end; ++x)
                    cells[x] += scale * weights[x];
            });
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
    reach_cells_ = std::clamp(settings.reach_m / shape_.cell_m, kLeastReach_cells, kMostReach_cells);
    dissolved_ = dissolved;
    walls_->extrapolate(dissolved_, Location::Cell, pool_);
    sort_into_slabs(parcels);
    grid::BlockField density(shape_, blocks_reached(parcels));
    const auto slabs = static_cast<std::size_t>(density.blocks().z);
    std::vector<double> sums(slabs);
    pool_.run(slabs, [&](std::size_t slab, int) {
        sums[slab] = lay_dissolved(static_cast<int>(slab), density);
    });
    const double laid_m3 = std::accumulate(sums.begin(), sums.end(), 0.0);
    const double dissolved_m3 = sum_of_open(dissolved, walls_->open_cells());
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
