#include "start/canvas_choices.hpp"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

namespace pastoso::start {
namespace {

/// So many cells are painted fluently on a common machine.
constexpr double kCells = 1.5e6;
constexpr double kCoarsest_px_per_mm = 3.0, kFinest_px_per_mm = 8.0;

/// Makes tr() find these words.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(CanvasChoices)
};

}  // namespace

std::vector<CanvasSize> canvas_sizes() {
    return {
        {Words::tr("Small study"), 150.0, 100.0},      {QStringLiteral("A5"), 210.0, 148.0},
        {QStringLiteral("A4"), 297.0, 210.0},          {QStringLiteral("A3"), 420.0, 297.0},
        {Words::tr("Square"), 200.0, 200.0},           {Words::tr("Small canvas"), 240.0, 180.0},
        {Words::tr("Large canvas"), 400.0, 300.0},     {Words::tr("Screen, HD"), 480.0, 270.0, 4.0},
        {Words::tr("Screen, QHD"), 512.0, 288.0, 5.0},
    };
}

double sensible_px_per_mm(double width_mm, double height_mm) {
    const double fitting = std::floor(std::sqrt(kCells / (width_mm * height_mm)));
    return std::clamp(fitting, kCoarsest_px_per_mm, kFinest_px_per_mm);
}

document::CanvasSettings canvas_of(const CanvasSize& size, bool upright, const std::string& support) {
    document::CanvasSettings canvas;
    canvas.width_mm = upright ? size.shorter_mm : size.longer_mm;
    canvas.height_mm = upright ? size.longer_mm : size.shorter_mm;
    canvas.px_per_mm =
        size.px_per_mm > 0.0 ? size.px_per_mm : sensible_px_per_mm(canvas.width_mm, canvas.height_mm);
    canvas.support = support;
    return canvas;
}

QString size_words(const document::CanvasSettings& canvas) {
    return Words::tr("%1 × %2 mm").arg(canvas.width_mm).arg(canvas.height_mm);
}

}  // namespace pastoso::start
