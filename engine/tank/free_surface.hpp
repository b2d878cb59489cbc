// The pressure that makes a liquid below a free surface incompressible: air is at pressure 0 where the
// surface is (ghost fluid: Gibou, Fedkiw, Cheng and Kang, J. Comput. Phys. 176, 2002; Enright, Nguyen,
// Gibou and Fedkiw, FEDSM 2003), solids are cut cells.
//
// In each cell of liquid
//     sum over its faces of w u = growth cell,    u -= grad p,
// with w the open share of a face. Between liquid a and air b the surface lies at the share
// theta = phi_a / (phi_a - phi_b) of the way, so that the gradient there is p_a / theta.
#pragma once

#include "liquid/pressure/conjugate_gradients.hpp"
#include "tank/domain.hpp"

#include <utility>

namespace pastoso::tank {

/// The surface is kept so far from the middle of a cell, as a share of the way to the next: without a
/// bound the equations would be stiff.
inline constexpr float kLeastTheta = 0.1F;

class FreeSurface {
  public:
    explicit FreeSurface(const Domain& domain,
                         const liquid::Kernels& kernels = core::kernels<liquid::Kernels>());

    /// The signed distance from the surface in metres, negative in the liquid, at cells' middles. Who
    /// changes it calls update().
    grid::BoxField& level_m() { return level_m_; }
    const grid::BoxField& level_m() const { return level_m_; }

    /// Says where the liquid is: cells with level_m < 0 that are not shut. `rows` must hold all cells of
    /// liquid and those around them; the level must be known there, one cell deep within solids too.
    void update(const liquid::RowRanges& rows, core::ThreadPool& pool);

    /// Makes the velocity free of divergence in the liquid, but for `growth` (share of a cell's volume
    /// that shall appear in it, divided by the time step and times the cell size: m/s; may be null).
    liquid::SolveResult project(liquid::VelocityField& velocity, const grid::BoxField* growth_m_s,
                                const liquid::SolveLimits& limits, core::ThreadPool& pool);

    /// Hulls of the cells of liquid, and whether a cell is one.
    const liquid::RowRanges& rows() const { return rows_; }
    bool is_liquid(int i, int j, int k) const { return liquid_.at(i, j, k) > 0.0F; }
    const grid::BoxField& liquid() const { return liquid_; }  ///< 1 in cells of liquid, 0 in others
    long liquid_cells() const { return liquid_cells_; }
    /// The open faces beside cells of liquid.
    liquid::Region region() const;
    /// p dt / (rho cell), in m/s.
    const grid::BoxField& pressure() const { return pressure_; }
    /// Where the next solution begins; of the domain's shape.
    void set_pressure(grid::BoxField pressure) { pressure_ = std::move(pressure); }

  private:
    void clear(core::ThreadPool& pool);
    void build_row(int j, int k);
    float divergence(const liquid::VelocityField& velocity, int i, int j, int k) const;
    void subtract_gradient(int axis, int j, int k, liquid::VelocityField& velocity) const;

    const Domain* domain_;
    liquid::ConjugateGradients solver_;
    liquid::CellMatrix matrix_;
    liquid::RowRanges near_rows_, rows_;  ///< those of update(), and what of them is liquid
    grid::BoxField level_m_, liquid_, pressure_, source_;
    long liquid_cells_ = 0;
};

}  // namespace pastoso::tank
