// What is made of a painting for other programs: a picture, layers, maps or a relief.
#pragma once

#include "document/painting_state.hpp"
#include "recordings/map_export.hpp"
#include "recordings/picture_style.hpp"
#include "recordings/relief_mesh.hpp"
#include "shade/varnish.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace pastoso::recordings {

enum class ExportKind {
    Picture,  ///< picture_export.hpp
    Layers,   ///< layer_export.hpp
    Maps,     ///< map_export.hpp
    Relief,   ///< relief_export.hpp
};

/// One export as it was chosen. What does not concern its kind is not looked at.
struct ExportChoice {
    ExportKind kind = ExportKind::Picture;
    std::filesystem::path path;  ///< of maps, the name of the set
    bool of_well = false;        ///< a picture of the mixing well instead of the canvas
    bool lit = true;             ///< otherwise pictures have the paint's colours without light and shade
    double scale = 1.0;          ///< pixels of a cell, 1/64 to 64
    PictureOptions picture;
    shade::Lighting lighting;
    shade::Varnish varnish;  ///< over what is lit
    ReliefOptions relief;
};

/// The cells that a choice is about: those of the canvas, or of the mixing well.
struct ExportedCells {
    grid::Shape shape;
    double cell_mm = 0.0;
};

/// `canvas` are the cells of the canvas.
ExportedCells exported_cells(const ExportedCells& canvas, const ExportChoice& choice);

/// Columns and rows of the file: pixels, or points of a relief. Throws InputError when that is too large
/// for its format or at all, and for scales and options of reliefs outside their ranges.
grid::Shape export_size(const ExportedCells& canvas, const ExportChoice& choice);

/// Whether it can be written like this, asked before the work that it takes. Throws InputError for a
/// name that does not end as such files do, for what its format does not hold, for lights and profiles
/// that there are not, and when the file cannot be written.
void check_export(const ExportChoice& choice);

struct ExportReport {
    files::ExportStatus status = files::ExportStatus::Written;
    std::vector<std::filesystem::path> files;
    int width_px = 0, height_px = 0;  ///< of pictures, layers and maps
    double width_mm = 0.0, height_mm = 0.0;
    MapHeights heights{};       ///< of maps
    std::size_t triangles = 0;  ///< of reliefs
};

/// Writes it aside: stopped or failed, every file is as it was before. Throws InputError as
/// check_export() does, for a picture or a relief that would be too large, and when writing fails.
ExportReport export_painting(const document::PaintingState& painting, const ExportChoice& choice,
                             core::ThreadPool& pool, const files::KeepGoing& keep_going);

}  // namespace pastoso::recordings
