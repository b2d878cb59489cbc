// A window's picture of a canvas, made by the processor.
#pragma once

#include "appearance/screen_colours.hpp"
#include "core/thread_pool.hpp"
#include "screen/canvas_presenter.hpp"
#include "screen/quality.hpp"
#include "screen/view_transform.hpp"
#include "shade/cell_layers.hpp"
#include "shade/surface.hpp"

#include <optional>

#include <QImage>
#include <QRegion>

namespace pastoso::screen {

/// What a picture shows.
struct RasterScene {
    Sight sight;
    ViewTransform view;
    QSize window_px;
    Rgb ground{};                      ///< around the canvas, encoded
    appearance::ScreenCube colours{};  ///< that the canvas is shown through
    friend bool operator==(const RasterScene&, const RasterScene&) = default;
};

/// Whether nothing but the paint and the colours of the screen are others.
bool same_place(const RasterScene& a, RasterScene b);

/// Keeps the latest picture: only what differs from it is made again.
class RasterPicture {
  public:
    /// Makes it one of this scene. What is no other stays in the quality that it has.
    void show(const RasterScene& scene, Quality quality, core::ThreadPool& pool);

    /// Whether a part of it is less than it is to be.
    bool is_draft() const { return !draft_.isEmpty(); }

    /// Makes a strip of that part as it is to be: as much as takes some hundredths of a second.
    void refine(core::ThreadPool& pool);

    const QImage& image() const { return image_; }

    /// Where the scale of Look::Height ends: as high as the paint has been since that look began.
    double scale_top_mm() const { return scale_top_mm_; }

  private:
    QRegion changed_cells(const RasterScene& scene, const document::Snapshot& seen,
                          const std::vector<int>& tiles);
    void update_layers(const RasterScene& scene, const document::Snapshot& seen, const QRegion& changed,
                       core::ThreadPool& pool);
    QRegion changed_pixels(const RasterScene& scene, const QRegion& changed_cells) const;
    bool takes_long(const QRegion& region) const;
    void paint(const QRegion& region, Quality quality, core::ThreadPool& pool);
    QRect next_strip() const;
    void finish(const QRect& part, const RasterScene& scene, core::ThreadPool& pool);
    void measure_heights(const RasterScene& scene, const document::Snapshot& seen,
                         const std::vector<int>& changed, core::ThreadPool& pool);

    TracingGround ground_;
    std::optional<RasterScene> scene_;
    QRegion draft_;
    std::optional<Sight> light_;                      ///< that the layers were made in
    std::shared_ptr<const document::Snapshot> seen_;  ///< its painting on what is traced
    shade::TileRanges ranges_;
    shade::HeightRange range_;
    shade::CellLayers layers_;  ///< of all cells; of none on canvases that are too large for that
    double highest_mm_ = 0.0, scale_top_mm_ = 0.1;
    QImage canvas_;  ///< in the window, in 16 bits; what the screen makes of it is in the image
    QImage image_;
};

}  // namespace pastoso::screen
