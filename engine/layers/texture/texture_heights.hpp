// The heights of each texture: functions of millimetres on the canvas, as means over cells.
#pragma once

#include "grid/shape.hpp"
#include "layers/texture/texture.hpp"

#include <vector>

namespace pastoso::layers {

/// Means over the cells of a rectangle, row by row, in mm, 0 or more.
using CellHeights = std::vector<float>;

/// A mean is taken over so many places along each side of a cell: edges of grains and of passes are
/// steep.
inline constexpr int kLeastTextureSamples = 4;
inline constexpr int kMostTextureSamples = 16;

/// Grains finer than this share of a cell are there as their mean thickness alone.
inline constexpr double kFinestGrain_cells = 0.125;

/// Of binder, 0.2 of a grain's diameter, up to 1.27 of it. Four places along a grain are sampled, or as
/// many as there may be.
CellHeights sand_heights(const SandTexture& sand, const grid::Rect& cells, double cell_mm);

/// 0.04 to 1 of `height_mm`. Eight places from ridge to ridge are sampled, or as many as there may be.
CellHeights knifed_heights(const KnifedTexture& knifed, const grid::Rect& cells, double cell_mm);

/// Means of the picture's brightness, its encoded values weighed as in Rec. 709, by area
/// (picture_means.hpp); 0 beside it.
CellHeights pressed_heights(const PressedTexture& pressed, const grid::Rect& cells, double cell_mm);

}  // namespace pastoso::layers
