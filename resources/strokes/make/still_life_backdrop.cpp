#include "still_life_parts.hpp"
#include "still_life_things.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::examples {
namespace {

/// Small strokes along the outlines of what stands before an area.
void cut_in(Painter& painter, const Area& area, const Paints& paints, unsigned seed) {
    paint_area(painter, along_its_outline(area), paints,
               {.brush = "Flat bristle 20",
                .size_mm = 5,
                .spacing_mm = 3.6,
                .length_mm = 15,
                .inset_mm = 1.7,
                .press = {0.36, 0.1, 0.15},
                .speed_mm_s = 280,
                .fill = 0.75,
                .strokes_per_dip = 4,
                .most_depth_mm = 6.0,
                .seed = seed});
    mend_the_edge(painter, area, paints, seed + 1);
}

/// Light falls on the wall from the left; a little comes back at the right.
double wall_tone(Point at) {
    const double glow = std::exp(-std::pow((at.x - 22) / 46, 2) - std::pow((at.y - 44) / 42, 2));
    const double back = std::exp(-std::pow((at.x - 158) / 22, 2) - std::pow((at.y - 62) / 18, 2));
    return 0.1 + 0.85 * glow + 0.3 * back;
}

/// A fold from `from` to `to`: light on one side and in shadow on the other, as a change of tone.
double fold(Point from, Point to, double height, Point at) {
    const Point axis = 1.0 / length(to - from) * (to - from);
    const double along = dot(at - from, axis) / length(to - from);
    const double aside = dot(at - from, {-axis.y, axis.x});
    const double fade = smooth_step(-0.1, 0.2, along) * (1.0 - smooth_step(0.75, 1.1, along));
    const double light = std::exp(-std::pow((aside - 4.0) / 4.5, 2));
    const double shadow = std::exp(-std::pow((aside + 5.5) / 5.0, 2));
    return height * fade * (light - 1.3 * shadow);
}

double cloth_tone(Point at) {
    const double left = 1.0 - smooth_step(10, 170, at.x);
    const double near = smooth_step(68, 116, at.y);
    const double folds = fold({-14, 80}, {40, 128}, 0.38, at) + fold({54, 92}, {96, 130}, 0.4, at) +
                         fold({106, 108}, {146, 128}, 0.36, at) + fold({-10, 73}, {44, 80}, 0.25, at);
    return std::clamp(0.44 + 0.1 * near + 0.26 * left + folds, 0.0, 0.99);
}

Point cloth_direction(Point at) {
    const double folds = smooth_step(76, 96, at.y) * (1.0 - 0.6 * smooth_step(80, 150, at.x));
    return {1.0, 0.04 + 0.85 * folds};
}

}  // namespace

Area along_its_outline(Area area) {
    area.direction = [depth = area.depth_mm](Point at) { return along_outline(depth, at); };
    return area;
}

void mend_the_edge(Painter& painter, const Area& area, const Paints& paints, unsigned seed) {
    paint_area(painter, along_its_outline(area), paints,
               {.brush = "Filbert 14",
                .size_mm = 3.2,
                .spacing_mm = 2.6,
                .length_mm = 9,
                .inset_mm = 0.3,
                .press = {0.36, 0.1, 0.15},
                .speed_mm_s = 200,
                .fill = 0.75,
                .strokes_per_dip = 6,
                .most_depth_mm = 2.4,
                .seed = seed});
}

void tone_the_ground(Painter& painter) {
    painter.take("Soft glazing flat 16", 30);
    for (int i = 0; i < 6; ++i) {
        painter.dip(
            load(mixture("PY43 PBr7-RU=0.5 PW6=0.5", 0.25), mixture("PBr7-BS PW6=0.4", 0.22), 0.4, 0.5));
        const double y = 8.0 + 21.0 * i;
        std::vector<Point> across = {{-12, y}, {80, y + 2}, {172, y + 1}};
        if (i % 2 == 1) std::reverse(across.begin(), across.end());
        paint_along(painter, Curve(across), 220, {0.32, 0.03, 0.03});
    }
}

void paint_wall(Painter& painter) {
    const Area area{[](Point at) {
                        return std::min({canvas_depth_mm(at), table_edge_y(at.x) + 4.0 - at.y,
                                         free_of_things_mm(at)});
                    },
                    [](Point at) {
                        return Point{1.0, 1.1 - 1.9 * smooth_step(40, 110, at.x)};
                    },
                    wall_tone};
    const Paints paints = half_mixed(kWallTones);
    paint_area(painter, area, paints,
               {.brush = "Flat bristle 20",
                .size_mm = 16,
                .spacing_mm = 9,
                .length_mm = 34,
                .inset_mm = 4.6,
                .press = {0.42, 0.08, 0.12},
                .speed_mm_s = 350,
                .fill = 0.85,
                .scatter_deg = 26,
                .scatter_tone = 0.1,
                .seed = 11});
    cut_in(painter, area, paints, 13);
    paint_area(painter, area, paints,
               {.brush = "Flat bristle 20",
                .size_mm = 9,
                .spacing_mm = 10,
                .length_mm = 16,
                .inset_mm = 3,
                .press = {0.3, 0.1, 0.2},
                .speed_mm_s = 300,
                .fill = 0.7,
                .scatter_deg = 40,
                .scatter_tone = 0.14,
                .share_painted = 0.5,
                .seed = 12});
}

void paint_cloth(Painter& painter) {
    const Area area{[](Point at) {
                        return std::min({canvas_depth_mm(at), at.y - table_edge_y(at.x) + 1.5,
                                         free_of_things_mm(at)});
                    },
                    cloth_direction, cloth_tone};
    const Paints paints = half_mixed(kClothTones);
    paint_area(painter, area, paints,
               {.brush = "Flat bristle 20",
                .size_mm = 10,
                .spacing_mm = 6,
                .length_mm = 22,
                .inset_mm = 2.6,
                .press = {0.42, 0.08, 0.12},
                .speed_mm_s = 320,
                .fill = 0.85,
                .scatter_deg = 8,
                .scatter_tone = 0.05,
                .seed = 21});
    cut_in(painter, area, paints, 23);
}

void paint_cast_shadows(Painter& painter) {
    const Area area{[](Point at) {
                        return std::min({cast_shadow_depth_mm(at), free_of_things_mm(at),
                                         at.y - table_edge_y(at.x)});
                    },
                    [](Point) {
                        return Point{1.0, 0.08};
                    },
                    [](Point at) { return 0.95 - 0.3 * std::min(cast_shadow_depth_mm(at), 3.0); }};
    paint_area(painter, area, half_mixed({kContactShadow, kClothTones[0], kClothTones[1]}),
               {.brush = "Filbert 14",
                .size_mm = 7,
                .spacing_mm = 2.9,
                .length_mm = 18,
                .inset_mm = 0.6,
                .press = {0.34, 0.12, 0.25},
                .speed_mm_s = 220,
                .strokes_per_dip = 3,
                .scatter_deg = 4,
                .seed = 27});
}

}  // namespace pastoso::examples
