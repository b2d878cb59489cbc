// The evening's thin beginnings: a warm ground, a drawing in thin oil, and lights wiped out of it.
#include "evening_parts.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::examples::evening {
namespace {

document::PaintRecipe wash(double strength) {
    return mixture("PBr7-BU PB29=0.35 PBr7-BS=0.6", strength);
}

/// Masses are scrubbed in with a broad bristle brush, this way and that.
void scrub(Painter& painter, const Area& area, double size_mm, double strength, unsigned seed) {
    paint_area(painter, area, {load(wash(strength)), load(wash(1.7 * strength))},
               {.brush = "Flat bristle 20",
                .size_mm = size_mm,
                .spacing_mm = 0.95 * size_mm,
                .length_mm = 2.4 * size_mm,
                .inset_mm = 0.25 * size_mm,
                .press = {0.4, 0.12, 0.3},
                .speed_mm_s = 600,
                .fill = 0.6,
                .strokes_per_dip = 4,
                .scatter_deg = 40,
                .scatter_tone = 0.4,
                .scatter_press = 0.35,
                .scatter_length = 0.4,
                .shuffled = true,
                .seed = seed});
}

void line(Painter& painter, const std::vector<Point>& points, double pressure) {
    painter.dip(load(wash(0.4), 0.5));
    paint_along(painter, Curve(points), 260, {pressure, 0.1, 0.35});
}

void draw_outlines(Painter& painter) {
    painter.take("Round bristle 12", 1.7);
    line(painter, {{-3, kShore_y + 0.6}, {40, kShore_y - 0.2}, {84, kShore_y + 0.3}, {123, kShore_y}},
         0.3);
    line(painter, {{-2, 27}, {6, 19}, {10, 17}, {14, 12.5}, {26, 8.4}, {38, 14}, {43, 26}, {49, 34}},
         0.34);
    line(painter, {{49.5, 55}, {49, 34}, {52.4, 12}, {56, 34}, {56, 55}}, 0.3);
    line(painter, {{58, 54}, {60.4, 29}, {62.6, 54}}, 0.28);
    line(painter, {{64, 51}, {78, 51.5}, {92, 49}, {104, 45}, {113, 41.5}, {123, 40}}, 0.3);
    line(painter, {{-2, 73}, {20, 79}, {44, 86.5}, {62, 95}}, 0.34);
    line(painter, {{80, 65}, {84, 66.6}, {90, 66.6}, {95, 64.6}}, 0.26);
    line(painter, {{86.6, 66}, {86.4, 60.5}}, 0.24);
}

/// A rag lifts the light out of the wash: the sky round the sun, and its path on the water.
void wipe_lights_out(Painter& painter) {
    painter.take("Rag 35", 8);
    paint_along(painter, Curve({{66, 46.5}, {78, 45}, {98, 46}}), 200, {0.6, 0.2, 0.4});
    paint_along(painter, Curve({{70, 40}, {80, 38}, {92, 37}}), 200, {0.5, 0.3, 0.6});
    painter.take("Rag 35", 5);
    for (int i = 0; i < 5; ++i) {
        const double y = 58.5 + 5.5 * i, half = 4.0 + 3.0 * chance(i, 301),
                     x = kSun.x + 5 * (chance(i, 302) - 0.5);
        paint_along(painter, Curve({{x - half, y}, {x, y + 0.4}, {x + half, y - 0.3}}), 160,
                    {0.55, 0.2, 0.4});
    }
}

/// One thin coat, stroke beside stroke; `first_kind` numbers what differs.
void coat(Painter& painter, const document::LoadPaint& paint, double spacing_mm, unsigned first_kind) {
    painter.take("Large flat 40", 28);
    const int count = static_cast<int>(kHeight_mm / spacing_mm) + 1;
    for (int i = 0; i < count; ++i) {
        painter.dip(paint);
        const double y = spacing_mm * (i + 0.3), drift = 7.0 * (chance(i, first_kind) - 0.5);
        std::vector<Point> across = {
            {-16, y - drift}, {38, y + drift}, {84, y - 0.6 * drift}, {136, y + drift}};
        if (i % 2 == 1) std::reverse(across.begin(), across.end());
        paint_along(painter, Curve(across), 900, {0.34 + 0.12 * chance(i, first_kind + 1), 0.03, 0.03});
    }
}

}  // namespace

void tone_the_ground(Painter& painter) {
    painter.use_medium("thin oil");
    coat(painter,
         load(mixture("PBr7-BS PY43=1.6", 0.16), mixture("PBr7-BS PR101=0.2 PY43=0.5", 0.16), 0.4, 0.7),
         19, 303);
    for (int i = 0; i < 7; ++i) {
        const double x = 4 + 19 * i, lean = 30 * (chance(i, 307) - 0.3);
        painter.stroke(0.12, [&](double u) {
            return Touch{x + lean * (0.5 - u), -12 + 114 * u, 0.3, 10 * chance(i, 308)};
        });
    }
    painter.dry_now();
}

void draw_with_a_wash(Painter& painter) {
    painter.use_medium("thin oil");
    coat(painter, load(wash(0.05), 0.5), 18, 305);
    wipe_lights_out(painter);
    painter.dry_now();
    draw_outlines(painter);
    const auto upwards = [](Point at) { return Point{0.5 * std::sin(at.x / 6 + at.y / 9), -1.0}; };
    const auto level = [](Point at) { return Point{1.0, 0.2 * std::sin(at.x / 9)}; };
    const auto even = [](Point) { return 0.5; };
    scrub(painter, {trees_mm, upwards, even}, 6, 0.17, 311);
    scrub(painter, {far_bank_mm, level, even}, 3.2, 0.1, 312);
    scrub(painter, {[](Point at) { return std::min(on_canvas_mm(at), near_bank_mm(at)); }, level, even},
          7, 0.13, 313);
    scrub(painter, {mirrored_trees_mm, level, even}, 6, 0.07, 314);
    painter.dry_now();
}

}  // namespace pastoso::examples::evening
