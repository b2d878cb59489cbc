#include "recordings/tile_kinds.hpp"

#include <cstring>
#include <limits>

#include <gtest/gtest.h>

namespace pastoso::recordings {
namespace {

constexpr grid::Shape kShape{100, 70};

/// What a file with an awake tile is read into.
struct EmptySurface {
    document::SurfaceState surface{film::FilmState(kShape, 0.25), {}};
    SurfaceTarget target{surface, {0, -1, -1, -1}, {0, -1, -1, -1}};

    EmptySurface() {
        surface.solver.awake.resize(1);
        surface.solver.pressures.resize(1);
    }
    bool is_untouched() const {
        const film::FilmState& film = surface.film;
        const film::SolverState::AwakeTile& awake = surface.solver.awake[0];
        return film.thickness.is_background(0) && film.paint.is_background(0) &&
               film.lower.thickness.is_background(0) && film.lower.paint.is_background(0) &&
               film.worked.thickness.is_background(0) && film.media.foreign.is_background(0) &&
               film.velocity_x.is_background(0) && film.velocity_y.is_background(0) &&
               film.support_mm.is_background(0) && film.strata.soluble_thickness.is_background(0) &&
               film.strata.soluble_pigment.is_background(0) && film.strata.optics.is_background(0) &&
               film.strata.uppermost.is_background(0) && !awake.activity.awake && !awake.window_start &&
               !surface.solver.pressures[0].pressure_mm2_s2;
    }
};

/// A tile of numbers that are all the same, as they lie in a file.
std::vector<std::byte> tile_of(const TileKind& kind, std::uint32_t bits) {
    std::vector<std::byte> bytes(kind.bytes);
    for (std::size_t at = 0; at + sizeof bits <= bytes.size(); at += sizeof bits)
        std::memcpy(&bytes[at], &bits, sizeof bits);
    return bytes;
}

TEST(TileKinds, WhatIsRefusedDoesNotReachTheSurface) {
    int refused = 0;
    for (const TileKind& kind : tile_kinds()) {
        for (const std::uint32_t bits :
             {0xFFFFFFFFU, 0x7FC07FC0U, 0x7F7F7F7FU, 0x80808080U, 0xAAAAAAAAU}) {
            EmptySurface read;
            const bool is_refused = !kind.decode(tile_of(kind, bits).data(), 0, read.target).empty();
            EXPECT_EQ(read.is_untouched(), is_refused) << kind.name << " of " << std::hex << bits;
            refused += is_refused ? 1 : 0;
        }
    }
    EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace pastoso::recordings
