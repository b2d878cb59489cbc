// The numbers of the paint in every cell of a tile and around it, where paints of several media lie
// there.
#pragma once

#include "film/explicit/tile_step.hpp"
#include "film/state.hpp"

namespace pastoso::film {

/// Fills block.numbers from the shares of the media that the film has (cell/wet_media.hpp). Cells
/// without paint get those of their tile's own medium.
void gather_numbers(const FilmState& state, const HaloMap& columns, const HaloMap& rows, int tile_x,
                    HaloBlock& block);

/// The same of one number alone, which is `of_all` where the step's paint is of one medium.
void gather_number(const FilmState& state, const HaloMap& columns, const HaloMap& rows, int tile_x,
                   double FilmNumbers::*number, float of_all, const StepConstants& step,
                   BlockArray<float>& out);

/// The amounts of all media but that of the tile in and around it, as its paint channels would be
/// gathered (concentration_block.hpp): how much of them leaves with a quantum of thickness. False where
/// all paint near is the tile's own.
bool gather_media(const FilmState& state, const HaloMap& columns, const HaloMap& rows, int tile,
                  float* concentrations);

}  // namespace pastoso::film
