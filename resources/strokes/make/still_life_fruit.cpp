#include "still_life_parts.hpp"
#include "still_life_things.hpp"

#include <algorithm>

namespace pastoso::examples {
namespace {

/// Big strokes first, smaller ones to model the form, small ones along its outline.
void fruit(Painter& painter, const Area& area, const Tones& tones, double size_mm, unsigned seed) {
    const Paints paints = half_mixed(tones);
    paint_area(painter, area, paints,
               {.brush = "Filbert 14",
                .size_mm = size_mm,
                .spacing_mm = 0.5 * size_mm,
                .length_mm = 1.5 * size_mm,
                .inset_mm = 0.3 * size_mm,
                .press = {0.4, 0.12, 0.15},
                .speed_mm_s = 240,
                .fill = 0.75,
                .scatter_deg = 8,
                .seed = seed});
    paint_area(painter, area, paints,
               {.brush = "Filbert 14",
                .size_mm = 0.62 * size_mm,
                .spacing_mm = 0.55 * size_mm,
                .length_mm = size_mm,
                .inset_mm = 0.2 * size_mm,
                .press = {0.3, 0.15, 0.25},
                .speed_mm_s = 200,
                .scatter_deg = 18,
                .scatter_tone = 0.1,
                .share_painted = 0.7,
                .seed = seed + 1});
    paint_area(painter, along_its_outline(area), paints,
               {.brush = "Filbert 14",
                .size_mm = 0.42 * size_mm,
                .spacing_mm = 0.4 * size_mm,
                .length_mm = 1.2 * size_mm,
                .inset_mm = 0.12 * size_mm,
                .press = {0.3, 0.15, 0.2},
                .speed_mm_s = 200,
                .strokes_per_dip = 4,
                .scatter_deg = 4,
                .most_depth_mm = 0.38 * size_mm,
                .seed = seed + 2});
}

void stem(Painter& painter, const Curve& curve) {
    painter.take("Round sable 9", 3.5);
    painter.dip(load(mixture("PBr7-BU PB29=0.4"), mixture("PBr7-BS PY43=0.5"), 0.3));
    paint_along(painter, curve, 90, {0.45, 0.1, 0.1});
}

/// What of a pear stands above the front of the bowl.
Area above_the_bowl(const Turned& pear) {
    Area area = area_of(pear);
    area.depth_mm = [&pear](Point at) { return std::min(depth_mm(pear, at), -bowl_depth_mm(at)); };
    return area;
}

/// A warm cheek where the light on the ripe pear turns into shadow.
void blush(Painter& painter) {
    Area cheek = area_of(kRipePear);
    cheek.depth_mm = [](Point at) { return std::min(depth_mm(kRipePear, at), 66.0 - at.y); };
    const document::LoadPaint red =
        load(mixture("PR108 PO20=0.8 PY43=0.5"), mixture("PY43 PO20=0.3"), 0.4);
    paint_area(painter, cheek, {red},
               {.brush = "Filbert 14",
                .size_mm = 5,
                .spacing_mm = 3.4,
                .length_mm = 8,
                .inset_mm = 1.2,
                .press = {0.2, 0.2, 0.35},
                .speed_mm_s = 160,
                .fill = 0.4,
                .strokes_per_dip = 4,
                .least_tone = 0.3,
                .most_tone = 0.62,
                .share_painted = 0.55,
                .seed = 57});
}

void leaf(Painter& painter) {
    painter.take("Filbert 14", 6);
    painter.dip(load(mixture("PG7=0.25 PG17 PBr7-BU=0.4"), mixture("PG36=0.3 PY35"), 0.35, 0.9));
    const Curve curve({{79.5, 22.5}, {88, 17.5}, {98, 19.5}});
    painter.stroke(0.3, [&](double u) {
        const Point at = curve.at(u);
        const double press = 0.5 * smooth_step(0.0, 0.3, u) * (1.0 - smooth_step(0.45, 1.0, u));
        return Touch{at.x, at.y, press, 95};
    });
}

}  // namespace

void paint_pears(Painter& painter) {
    fruit(painter, above_the_bowl(kGreenPear), kGreenPearTones, 8.5, 41);
    fruit(painter, above_the_bowl(kRipePear), kRipePearTones, 8.5, 51);
    blush(painter);
    stem(painter, Curve({{79.2, 27.5}, {78.6, 21}, {82, 16}}));
    stem(painter, Curve({{123.6, 31.5}, {125.4, 26}, {130, 22.5}}));
    leaf(painter);
}

void paint_lemon_and_apple(Painter& painter) {
    fruit(painter, area_of(kLemon), kLemonTones, 7.5, 71);
    fruit(painter, area_of(kApple), kAppleTones, 8, 81);
    stem(painter, Curve({{142, 85.5}, {142.6, 81}, {145.5, 78}}));
}

}  // namespace pastoso::examples
