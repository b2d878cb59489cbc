// The canvases that one click puts up.
#pragma once

#include "document/events.hpp"

#include <string>
#include <vector>

#include <QString>

namespace pastoso::start {

/// A canvas lying on its longer side.
struct CanvasSize {
    QString name;
    double longer_mm = 0.0, shorter_mm = 0.0;
    double px_per_mm = 0.0;  ///< 0: sensible_px_per_mm()
};

std::vector<CanvasSize> canvas_sizes();

/// Whole cells per millimetre, 3 to 8, so that bristles show on a small canvas and a large one stays
/// quick.
double sensible_px_per_mm(double width_mm, double height_mm);

document::CanvasSettings canvas_of(const CanvasSize& size, bool upright, const std::string& support);

/// "297 × 210 mm".
QString size_words(const document::CanvasSettings& canvas);

}  // namespace pastoso::start
