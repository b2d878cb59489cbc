// All milk in the tea as one share of the volume at each place: what has dissolved, and the parcels
// spread out. Milk that flow has drawn out thin has no surface, but a share it has.
#pragma once

#include "core/thread_pool.hpp"
#include "grid/block_field.hpp"
#include "liquid/flow/row_ranges.hpp"
#include "liquid/flow/walls.hpp"
#include "liquid/tea/counting_order.hpp"
#include "liquid/tea/parcel_kernel.hpp"
#include "liquid/tea/tea_settings.hpp"
#include "liquid/vessel/cup.hpp"

#include <optional>
#include <span>
#include <vector>

namespace pastoso::liquid {

struct MilkDensitySettings {
    int cells = 256;          ///< along each side of the box, 8 to 384
    float reach_m = 0.0007F;  ///< of a parcel as poured; at most kMostReach_cells
};
inline constexpr float kMostReach_cells = 3.5F;

/// At most 256 cells a side, at which the tea's parcels, where they lie side by side, make an even body.
MilkDensitySettings even_density(const TeaSettings& settings);

/// Keeps its working memory from one frame to the next.
class MilkDensities {
  public:
    explicit MilkDensities(core::ThreadPool& pool) : pool_(pool) {}

    /// On the lattice of the wanted cells, at the middles of those that lie in the tea:
    ///     rho = sum over parcels of V K(x - p) / sum of K over those cells + s c,
    /// V what is narrow of a parcel and K its kernel (parcel_kernel.hpp), c the dissolved share between
    /// the middles of its cells and s, near 1, what makes its sum right: the sum of rho is the milk's
    /// volume, to rounding. What is wide of a parcel, all of it once it has widened by half of the
    /// variance that cells of `dissolved` give to milk, is among c, shared by the eight cells around it.
    /// A parcel whose kernel lies outside the tea gives to the cell around it. Above 1 where parcels
    /// overlap. The same bits on any number of threads and any instruction set.
    grid::BlockField make(std::span<const Parcel> parcels, const grid::BoxField& dissolved,
                          const Cup& cup, const MilkDensitySettings& settings = {});

  private:
    void set_tea(const grid::BoxShape& flow, const Cup& cup);
    void set_lattice(int cells);
    void sort_into_slabs(std::span<const Parcel> parcels);
    ParcelKernel kernel_of(const Parcel& parcel) const;
    void part_wide(std::span<const Parcel> parcels, float reach_m);
    void add_wide(std::span<const Parcel> parcels);
    void weigh(std::span<const Parcel> parcels);
    std::vector<char> blocks_reached(std::span<const Parcel> parcels) const;
    double lay_dissolved(int slab, grid::BlockField& density) const;
    void add_parcels(std::span<const Parcel> parcels, int slab, std::vector<float>& layers) const;
    void finish(std::span<const Parcel> parcels, float scale, int slab, std::vector<float>& layers,
                grid::BlockField& density) const;

    core::ThreadPool& pool_;
    Cup cup_, flow_cup_;
    std::optional<Walls> walls_;  ///< of the flow
    grid::BoxField dissolved_;    ///< and wide parcels, continued into the walls
    grid::BoxShape shape_;        ///< of the density
    RowRanges in_tea_;
    float reach_cells_ = 0.0F;
    CountingOrder order_;  ///< of the parcels by slabs
    int slabs_reached_ = 0;      ///< by a parcel, beyond its own
    std::vector<float> wide_;    ///< part of each parcel, 0 to 1
    std::vector<float> scales_;  ///< of each parcel's kernel
};

}  // namespace pastoso::liquid
