// The canvases that one click puts up.
#pragma once

#include "document/events.hpp"

#include <cstddef>
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

/// On what the painting is done.
struct Machine {
    double live_px_per_mm = 4.0;   ///< the finest cells that keep pace with the hand
    std::size_t memory_bytes = 0;  ///< that is free
};

/// Whole cells per millimetre, 3 to 8, so that bristles show on a small canvas and a large one stays
/// quick; or more, where the machine keeps pace with them and the canvas fits into a third of its
/// memory.
double sensible_px_per_mm(double width_mm, double height_mm, const Machine& machine);

document::CanvasSettings canvas_of(const CanvasSize& size, bool upright, const std::string& support,
                                   const Machine& machine);

/// "297 × 210 mm".
QString size_words(const document::CanvasSettings& canvas);

}  // namespace pastoso::start
