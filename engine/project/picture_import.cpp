#include "project/picture_import.hpp"

#include "document/canvas.hpp"
#include "files/image.hpp"
#include "layers/picture_means.hpp"
#include "recordings/canvas_support.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::project {
namespace {

document::CanvasSettings canvas_of(const ImportSettings& settings, const CanvasSize& size) {
    document::CanvasSettings canvas;
    canvas.width_mm = size.width_mm;
    canvas.height_mm = size.height_mm;
    canvas.px_per_mm = settings.px_per_mm;
    canvas.support = settings.support;
    canvas.support_relief_mm = settings.support_relief_mm;
    document::check_canvas(canvas);
    return canvas;
}

LoadedProject finished(PictureCanvas& canvas) {
    LoadedProject project;
    static_cast<Project&>(project) = canvas.take();
    return project;
}

/// Files keep resolutions in steps.
double rounded(double length_mm) {
    return std::round(100.0 * length_mm) / 100.0;
}

int cells_of(double length_mm, double px_per_mm) {
    return static_cast<int>(std::clamp(std::ceil(length_mm * px_per_mm - 1e-6), 1.0,
                                       static_cast<double>(pigment::kMostPictureSide_px)));
}

}  // namespace

CanvasSize canvas_size(int width_px, int height_px, const CanvasSize& said, double wished_width_mm) {
    if (wished_width_mm > 0.0) {
        const double shape = said.width_mm > 0.0 ? said.height_mm / said.width_mm
                                                 : static_cast<double>(height_px) / width_px;
        return {wished_width_mm, rounded(wished_width_mm * shape)};
    }
    if (said.width_mm > 0.0) return {rounded(said.width_mm), rounded(said.height_mm)};
    const double mm_per_px = kImportedSide_mm / std::max(width_px, height_px);
    return {rounded(width_px * mm_per_px), rounded(height_px * mm_per_px)};
}

document::PaintPicture paint_of_picture(pigment::Picture picture, std::string name,
                                        const layers::PicturePlace& place, double px_per_mm) {
    auto small = std::make_shared<pigment::Picture>(layers::reduced(
        std::move(picture), cells_of(place.width_mm, px_per_mm), cells_of(place.height_mm, px_per_mm)));
    return {std::move(name), place, std::move(small)};
}

layers::PicturePlace fitted_place(int width_px, int height_px, const document::CanvasSettings& canvas) {
    const double mm_per_px = std::min(canvas.width_mm / width_px, canvas.height_mm / height_px);
    layers::PicturePlace place{0.0, 0.0, width_px * mm_per_px, height_px * mm_per_px};
    place.x_mm = 0.5 * (canvas.width_mm - place.width_mm);
    place.y_mm = 0.5 * (canvas.height_mm - place.height_mm);
    return place;
}

PictureCanvas::PictureCanvas(const document::CanvasSettings& canvas, core::ThreadPool& pool)
    : strokes_{canvas, {}, 0}, painting_(recordings::make_painting(canvas, pool)) {
    painting_->set_history_budget(0);
}

void PictureCanvas::apply(const document::Action& action) {
    painting_->apply(action);
    strokes_.events.push_back({0, action});
}

Project PictureCanvas::take() {
    return {painting_->state(), std::move(strokes_)};
}

LoadedProject import_picture(const std::filesystem::path& path, const ImportSettings& settings,
                             core::ThreadPool& pool, const core::Progress& progress) {
    constexpr double kRead = 0.4, kCanvas = 0.6;  // of the whole, about
    const auto tell = [&](double done) {
        if (progress) progress(done);
    };
    files::StoredPicture stored = files::read_picture(path);
    tell(kRead);
    const CanvasSize size = canvas_size(stored.picture.width, stored.picture.height,
                                        {stored.width_mm, stored.height_mm}, settings.width_mm);
    document::CanvasSettings wanted = canvas_of(settings, size);
    if (settings.as == ImportSettings::As::Support) {
        wanted.support = "image";
        wanted.support_image = path.string();
        PictureCanvas canvas(wanted, pool);
        return finished(canvas);
    }
    PictureCanvas canvas(wanted, pool);
    tell(kCanvas);
    canvas.apply(paint_of_picture(std::move(stored.picture), path.stem().string(),
                                  {0.0, 0.0, size.width_mm, size.height_mm}, settings.px_per_mm));
    canvas.apply(document::RemoveLayer{1});
    return finished(canvas);
}

}  // namespace pastoso::project
