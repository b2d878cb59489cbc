#include "core/units.hpp"
#include "paths.hpp"
#include "scenes.hpp"

#include <cmath>

namespace pastoso::examples {
namespace {

using document::Surface;

Curve line(Point from, Point to) {
    return Curve({from, to});
}

Curve whirl(Point middle, double radius_mm, double turns) {
    std::vector<Point> points;
    const int count = static_cast<int>(12 * turns);
    for (int i = 0; i <= count; ++i) {
        const double angle = 2.0 * core::kPi * turns * i / count;
        const double r = radius_mm * (0.55 + 0.45 * i / count);
        points.push_back(middle + r * Point{std::cos(angle), 0.7 * std::sin(angle)});
    }
    return Curve(points);
}

/// The tubes along the upper edge of the well.
void lay_out(Painter& painter) {
    const char* const tubes[] = {"PW6", "PY35", "PR108", "PBr7-BU", "PB29"};
    for (int i = 0; i < 5; ++i)
        painter.squeeze(mixture(tubes[i]), 12.0 + 24.0 * i, 14.0);
}

/// Yellow and blue side by side, folded into each other until they are half-mixed, and heaped up. Only a
/// knife that is pressed folds; a light one lays.
void mix_green_with_the_knife(Painter& painter) {
    painter.squeeze(mixture("PY35"), 24, 56, 600);
    painter.squeeze(mixture("PB29"), 40, 56, 150);
    painter.turn_to(Surface::Well);
    painter.take("Palette knife 17", 13);
    for (int fold = 0; fold < 3; ++fold) {
        paint_held(painter, line({44, 52}, {21, 53}), 60, {0.65, 0.1, 0.1}, 84);
        paint_held(painter, whirl({28, 57}, 9, 3.0), 90, {0.6, 0.1, 0.1}, 30 + 50 * fold);
        paint_held(painter, line({15, 64}, {32, 58}), 60, {0.6, 0.1, 0.2}, 70);
        paint_held(painter, line({43, 63}, {32, 57}), 60, {0.6, 0.1, 0.2}, 120);
    }
}

/// White drawn out of its dollop, and a touch of red worked into it.
void mix_pink_with_the_brush(Painter& painter) {
    painter.turn_to(Surface::Well);
    painter.take("Filbert 14", 11);
    for (const double x : {10.0, 14.0}) {
        paint_along(painter, Curve({{x, 10}, {x + 4, 22}, {58, 42}, {84, 58}}), 90, {0.5, 0.1, 0.1});
        paint_along(painter, whirl({86, 62}, 8, 1.0), 90, {0.4, 0.05, 0.1});
    }
    paint_along(painter, Curve({{58, 21}, {62, 26}, {80, 56}}), 80, {0.2, 0.1, 0.1});
    paint_along(painter, whirl({86, 62}, 9, 2.5), 90, {0.45, 0.05, 0.1});
}

/// A stroke through the mixture before every stroke on the canvas.
void paint_bands(Painter& painter, const Curve& mixture, const Curve& band) {
    for (int i = 0; i < 3; ++i) {
        painter.turn_to(Surface::Well);
        paint_along(painter, mixture, 60, {0.5, 0.1, 0.1});
        painter.turn_to(Surface::Canvas);
        const Point down{0.0, 12.5 * i};
        paint_along(painter, Curve({band.at(0.0) + down, band.at(0.5) + down, band.at(1.0) + down}), 80,
                    {0.45, 0.06, 0.1});
    }
}

}  // namespace

document::Recording palette() {
    document::CanvasSettings canvas;
    canvas.width_mm = 120;
    canvas.height_mm = 90;
    canvas.px_per_mm = 4;
    Painter painter(canvas);
    painter.use_medium("heavy-body oil");
    lay_out(painter);
    mix_green_with_the_knife(painter);
    painter.take("Flat bristle 20", 13);
    paint_bands(painter, Curve({{20, 65}, {32, 57}, {22, 50}}), Curve({{10, 15}, {58, 11}, {108, 17}}));
    mix_pink_with_the_brush(painter);
    paint_bands(painter, Curve({{78, 58}, {92, 66}, {82, 69}}), Curve({{10, 56}, {60, 52}, {108, 57}}));
    return painter.finish(0.5);
}

}  // namespace pastoso::examples
