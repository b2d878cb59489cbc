// New canvases made of pictures.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "project/project.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace pastoso::project {

/// The longer side of a canvas whose picture says nothing of its size.
inline constexpr double kImportedSide_mm = 300.0;

struct ImportSettings {
    enum class As { Paint, Support };
    As as = As::Paint;
    double px_per_mm = 4.0;          ///< of the canvas
    double width_mm = 0.0;           ///< of the canvas; 0: as the picture says, or kImportedSide_mm
    std::string support = "linen";   ///< below paint
    double support_relief_mm = 0.0;  ///< as in document::CanvasSettings
};

/// The width and height in mm of a canvas for a picture of so many pixels that says it has `said_*`,
/// 0 for nothing, in hundredths. A width that is wished for goes before.
struct CanvasSize {
    double width_mm = 0.0, height_mm = 0.0;
};
CanvasSize canvas_size(int width_px, int height_px, const CanvasSize& said, double wished_width_mm);

/// A picture as a layer of that name, in no more pixels than there are cells below it.
document::PaintPicture paint_of_picture(pigment::Picture picture, std::string name,
                                        const layers::PicturePlace& place, double px_per_mm);

/// In the middle of the canvas, as large as it fits.
layers::PicturePlace fitted_place(int width_px, int height_px, const document::CanvasSettings& canvas);

/// A new canvas with an image of any format on it: as a layer of paint on the support
/// (layers/flat_paint.hpp), or as the heights of the support itself. Throws InputError when the file is
/// no image, or the canvas would be too large.
LoadedProject import_picture(const std::filesystem::path& path, const ImportSettings& settings,
                             core::ThreadPool& pool, const core::Progress& progress = {});

/// Paints pictures and what belongs to them onto a new canvas, whose bare first layer makes way for
/// theirs.
class PictureCanvas {
  public:
    PictureCanvas(const document::CanvasSettings& canvas, core::ThreadPool& pool);

    void apply(const document::Action& action);
    Project take();

  private:
    document::Recording strokes_;
    std::unique_ptr<document::Painting> painting_;
};

}  // namespace pastoso::project
