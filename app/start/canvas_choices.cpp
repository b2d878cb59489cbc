#include "start/canvas_choices.hpp"

#include "appearance/shown_number.hpp"
#include "document/canvas.hpp"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

namespace pastoso::start {
namespace {

/// So many cells are painted fluently on any machine.
constexpr double kCells = 1.5e6;
constexpr double kCoarsest_px_per_mm = 3.0, kFinest_px_per_mm = 8.0;

constexpr std::size_t kShareOfMemory = 3;

/// The finest that keeps pace and fits into memory.
double finest_px_per_mm(double width_mm, double height_mm, const Machine& machine) {
    document::CanvasSettings canvas{.width_mm = width_mm, .height_mm = height_mm};
    const auto fits = [&](double px_per_mm) {
        canvas.px_per_mm = px_per_mm;
        return document::estimated_bytes(document::canvas_shape(canvas)) <=
               machine.memory_bytes / kShareOfMemory;
    };
    double px_per_mm = std::floor(machine.live_px_per_mm);
    while (px_per_mm > kCoarsest_px_per_mm && !fits(px_per_mm))
        px_per_mm -= 1.0;
    return px_per_mm;
}

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

double sensible_px_per_mm(double width_mm, double height_mm, const Machine& machine) {
    const double fluent = std::floor(std::sqrt(kCells / (width_mm * height_mm)));
    return std::max(std::clamp(fluent, kCoarsest_px_per_mm, kFinest_px_per_mm),
                    finest_px_per_mm(width_mm, height_mm, machine));
}

document::CanvasSettings canvas_of(const CanvasSize& size, bool upright, const std::string& support,
                                   const Machine& machine) {
    document::CanvasSettings canvas;
    canvas.width_mm = upright ? size.shorter_mm : size.longer_mm;
    canvas.height_mm = upright ? size.longer_mm : size.shorter_mm;
    canvas.px_per_mm = size.px_per_mm > 0.0
                           ? size.px_per_mm
                           : sensible_px_per_mm(canvas.width_mm, canvas.height_mm, machine);
    canvas.support = support;
    return canvas;
}

QString size_words(const document::CanvasSettings& canvas) {
    return Words::tr("%1 × %2 mm")
        .arg(appearance::shown_number(canvas.width_mm))
        .arg(appearance::shown_number(canvas.height_mm));
}

}  // namespace pastoso::start
