// A window's picture of a canvas, made by the processor.
#pragma once

#include "core/thread_pool.hpp"
#include "screen/canvas_sheet.hpp"
#include "screen/far_picture.hpp"
#include "screen/frame_budget.hpp"
#include "screen/quality.hpp"
#include "screen/raster_scene.hpp"
#include "shade/cell_layers.hpp"
#include "shade/surface.hpp"

#include <optional>
#include <utility>

#include <QImage>
#include <QRegion>

namespace pastoso::screen {

/// Keeps the latest picture: only what differs from it is made again, and what comes into the window.
class RasterPicture {
  public:
    /// Makes it one of this scene. What is no other stays in the quality that it has; what would take
    /// longer than a hand notices is a draft at first. Returns whether any is.
    bool show(const RasterScene& scene, core::ThreadPool& pool);

    /// Whether a part of it is less than it is to be.
    bool is_draft() const { return !draft_.isEmpty(); }

    /// Makes a strip of that part as it is to be: as much as takes as long as a picture may.
    void refine(core::ThreadPool& pool);

    const QImage& image() const { return image_; }

    /// The pixels that are others since this was asked last.
    QRegion take_changed() { return std::exchange(changed_, QRegion()); }

    /// Where the scale of Look::Height ends: as high as the paint has been since that look began.
    double scale_top_mm() const { return scale_top_mm_; }

  private:
    QRegion changed_cells(const RasterScene& scene, const document::Snapshot& seen,
                          const std::vector<int>& tiles);
    void update_layers(const RasterScene& scene, const document::Snapshot& seen, const QRegion& changed,
                       core::ThreadPool& pool);
    QRegion changed_pixels(const RasterScene& scene, const QRegion& changed_cells) const;
    Quality affordable_quality(const QRegion& region) const;
    double work_per_pixel(Quality quality) const;
    double work_of(const QRegion& region, Quality quality) const;
    std::optional<glm::ivec2> way_moved(const RasterScene& scene) const;
    void move_by(const glm::ivec2& pixels);
    bool seen_from_afar() const;
    QRegion known_from_afar(const QRegion& region) const;
    void paint(const QRegion& region, Quality quality, core::ThreadPool& pool);
    void paint_measured(const QRegion& region, Quality quality, core::ThreadPool& pool);
    template <class Paint>
    void with_layers(const CanvasSheet& sheet, const grid::Rect& pixels, core::ThreadPool& pool,
                     const Paint& paint) const;
    void paint_sheet(const QRegion& region, Quality quality, core::ThreadPool& pool);
    void paint_from_afar(const QRegion& region, core::ThreadPool& pool);
    QRect next_strip() const;
    void finish(const QRect& part, const RasterScene& scene, core::ThreadPool& pool);
    void finish_for_squint(core::ThreadPool& pool);
    void measure_heights(const RasterScene& scene, const document::Snapshot& seen,
                         const std::vector<int>& changed, core::ThreadPool& pool);

    TracingGround ground_;
    std::optional<RasterScene> scene_;
    QRegion draft_;
    FrameBudget budget_;
    std::optional<Sight> light_;                      ///< that the layers were made in
    std::shared_ptr<const document::Snapshot> seen_;  ///< its painting on what is traced
    shade::TileRanges ranges_;
    shade::HeightRange range_;
    shade::CellLayers layers_;  ///< of all cells; of none on canvases that are too large for that
    FarPicture far_;            ///< in light_
    double highest_mm_ = 0.0, scale_top_mm_ = 0.1;
    QImage canvas_;  ///< in the window, in 16 bits; what the screen makes of it is in the image
    QImage image_;
    QRegion changed_;  ///< of it
};

}  // namespace pastoso::screen
