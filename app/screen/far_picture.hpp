// A canvas as it is seen from afar: pictures of all of it, kept, so that a view costs the pixels of the
// window and not the cells below them.
#pragma once

#include "core/thread_pool.hpp"
#include "grid/shape.hpp"
#include "pigment/image.hpp"
#include "screen/view_transform.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include <QImage>
#include <QRegion>

namespace pastoso::screen {

/// Pixels for each cell of the largest of the pictures; each other one is half as large as that before.
/// They serve views that show no more.
inline constexpr double kFarZoom = 0.25;

/// Far pixels are those of the largest picture. Means of linear light, as those of a pixel's samples
/// are: a smaller picture is the one that the larger would be seen as.
class FarPicture {
  public:
    /// Nothing is known of this canvas.
    void begin(const grid::Shape& canvas);

    /// The picture of these cells is another, and of those whose pixels they have a part in.
    void forget(const QRegion& cells);

    /// As a view from there: so large a canvas has far pixels.
    static ViewTransform view() { return {{0.0, 0.0}, kFarZoom}; }

    /// The far pixels that a part of the window needs, and that are not known.
    QRegion missing(const ViewTransform& view, const QRect& part) const;

    /// Makes these far pixels known.
    void put(const grid::Rect& pixels, const pigment::LinearImage& picture, core::ThreadPool& pool);

    /// Draws a part of the window, of which nothing is missing, into its picture in 16 bits.
    void draw(const ViewTransform& view, const QRect& part, QImage& window,
              core::ThreadPool& pool) const;

  private:
    using Texel = std::array<std::uint16_t, 3>;

    struct Level {
        int width = 0, height = 0;
        std::vector<Texel> texels{};

        const Texel& at(int x, int y) const { return texels[static_cast<std::size_t>(y) * width + x]; }
    };

    static Level half_of(const Level& level);
    void make_levels();
    void reduce(std::size_t level, const grid::Rect& pixels, core::ThreadPool& pool);
    std::size_t level_for(double zoom) const;

    grid::Shape canvas_;
    QRegion known_;
    std::vector<Level> levels_;  ///< none before the first pixel is put
};

}  // namespace pastoso::screen
