// Thixotropy: paint that is worked gets thinner, and stiffens again at rest
// (docs/decisions/0061-thixotropy.md).
//
// The structure number lambda of a cell is 1 where its paint has rested and 0 where it is worked all
// through. With theta, T and gamma_b the medium's structure share, recovery time and breakdown strain,
// and gamma' the rate of shear, Moore's law (Trans. Brit. Ceram. Soc. 58, 1959) and Houska's (thesis,
// Prague 1981) are
//
//     d lambda/dt = (1 - lambda) / T - gamma' lambda / gamma_b,
//     tau_y = tau_y0 (1 - theta (1 - lambda)),    nu = nu_0 (1 - theta (1 - lambda)).
//
// The paint carries its worked part, b = h (1 - lambda).
#pragma once

#include "core/thread_pool.hpp"
#include "grid/tiled_field.hpp"

#include <cstdint>

namespace pastoso::film {

struct FilmState;

/// The tiles are there only where paint was worked lately: paint that has rested costs nothing.
struct WorkedPaint {
    WorkedPaint() = default;
    explicit WorkedPaint(grid::Shape canvas) : thickness(canvas) {}

    bool is_in(int tile) const { return !thickness.is_background(tile); }
    bool is_anywhere() const;
    bool holds_any(int tile) const;
    /// Sets a tile, to nothing unless one of its cells is worked.
    void replace(int tile, grid::TileBlock<std::int32_t> worked);
    /// Whether it is followed from now on; if not, all paint counts as rested.
    void follow(bool followed);

    bool is_followed = false;                  ///< tools work the paint that they touch
    grid::TiledField<std::int32_t> thickness;  ///< b, quanta, 0..h
};

/// Lets paint rest for `seconds`: b falls by exp(-seconds / T). What is left of less than a 16384th of
/// the cell's paint is lost.
void recover(FilmState& state, double seconds, core::ThreadPool& pool);

}  // namespace pastoso::film
