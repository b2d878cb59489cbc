// A small board to paint samples on, apart from any painting on the easel.
#pragma once

#include "document/painting.hpp"
#include "pigment/image.hpp"

#include <functional>
#include <string>
#include <vector>

namespace pastoso::document {

/// Places on it go from (0, 0), top left, to (1, 1).
class SampleBoard {
  public:
    struct Size {
        double width_mm = 40.0;
        int width_px = 84, height_px = 30;  ///< of its picture
        double cell_px = 1.0;               ///< side of a cell of its paint, at least 1
    };
    /// `cancelled` is asked at every tick; once it is true, nothing moves any more.
    SampleBoard(const Size& size, const std::string& support, core::ThreadPool& pool,
                std::function<bool()> cancelled = {});

    void take(const brush::Preset& preset);
    /// A bundled tool as wide as that share of the board.
    void take(const std::string& name, double width);
    void use_medium(const std::string& name);
    void load(const PaintRecipe& paint);
    void load(const LoadPaint& load);

    /// A movement of some seconds during which paint time passes; `at` gives place, pressure and so on
    /// at a share of it.
    void move(double seconds, const std::function<brush::PenSample(double share)>& at);
    /// Drops or dabs with the pen held still.
    void touch(const brush::PenSample& place);

    /// With an even film of wet paint, what a closed line goes around, in millimetres from the top left.
    void fill(std::vector<CanvasPoint> outline, const PaintRecipe& paint, double thickness_mm);
    void dry();
    void tilt(double tilt_deg, double seconds);

    /// Empty where it was cancelled.
    pigment::Image8 picture() const;

    double width_mm() const { return size_.width_mm; }
    double cell_mm() const { return size_.cell_px * size_.width_mm / size_.width_px; }
    /// Height over width.
    double aspect() const { return static_cast<double>(size_.height_px) / size_.width_px; }

  private:
    bool stopped() const { return cancelled_ && cancelled_(); }

    Size size_;
    core::ThreadPool& pool_;
    const std::function<bool()> cancelled_;
    Painting painting_;
    double now_s_ = 0.0;
};

/// So much of one pigment to so much white; of no pigment, that white alone.
PaintRecipe tinted(const std::string& pigment, double white = 0.0);

/// From nothing up to 1, and back to nothing at the end: of a share of a stroke.
double rise_and_fall(double share);

/// A straight band with round ends `width` of the board wide, from left to right: an even film of that
/// paint of the medium in use.
void lay_band(SampleBoard& board, double y, double width, const PaintRecipe& paint);

}  // namespace pastoso::document
