#include "still_life_parts.hpp"
#include "still_life_things.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::examples {
namespace {

/// An arc of an ellipse as wide as `half_width` and as high as the opening; `side` 1 in front, -1
/// behind.
Curve arc(double half_width, double y, double reach, double side) {
    std::vector<Point> points;
    for (int i = 0; i <= 10; ++i) {
        const double x = reach * (0.2 * i - 1.0);
        points.push_back(
            {kRim.x + half_width * x, y + side * kRimHalfHeight_mm * std::sqrt(1.0 - x * x)});
    }
    return Curve(points);
}

void inside_of_the_bowl(Painter& painter) {
    const Area area{[](Point at) {
                        const double pears = std::max(depth_mm(kGreenPear, at), depth_mm(kRipePear, at));
                        return std::min(opening_depth_mm(at), 2.0 * kTuckedUnder_mm - pears);
                    },
                    [](Point) {
                        return Point{1.0, 0.02};
                    },
                    [](Point at) { return 0.1 + 0.5 * smooth_step(80, 140, at.x); }};
    paint_area(painter, area, half_mixed({kBowlTones[0], kBowlTones[0], kBowlTones[1], kBowlTones[2]}),
               {.brush = "Filbert 14",
                .size_mm = 4.5,
                .spacing_mm = 1.9,
                .length_mm = 10,
                .inset_mm = 0.3,
                .press = {0.36, 0.1, 0.1},
                .speed_mm_s = 200,
                .strokes_per_dip = 5,
                .scatter_deg = 4,
                .seed = 31});
}

void back_of_the_rim(Painter& painter) {
    painter.take("Round sable 9", 3);
    painter.dip(load(mixture("PW6=3 PB28=0.5 PBr7-BU=0.1"), mixture("PW6=6 PY43=0.2"), 0.4, 1.1));
    paint_along(painter, arc(kRimHalfWidth_mm, kRim.y, 0.96, -1), 150, {0.36, 0.05, 0.05});
}

/// From white on the left to deep blue on the right, with some light thrown back at the edge.
double bowl_tone(Point at) {
    const double aside = (at.x - kRim.x) / (kRimHalfWidth_mm - 0.6 * (at.y - kRim.y));
    const double turn =
        0.97 - 0.85 * smooth_step(-0.75, 0.8, aside) + 0.14 * smooth_step(0.75, 1.0, aside);
    return std::clamp(turn - 0.2 * smooth_step(76, 102, at.y), 0.0, 0.99);
}

void front_of_the_bowl(Painter& painter) {
    const Area front{bowl_depth_mm,
                     [](Point at) {
                         const Point round = parallel(kBowl, at);
                         return Point{round.x, -round.y};
                     },
                     bowl_tone};
    const Paints paints = half_mixed(kBowlTones);
    paint_area(painter, front, paints,
               {.brush = "Flat bristle 20",
                .size_mm = 8,
                .spacing_mm = 4.6,
                .length_mm = 18,
                .inset_mm = 2.6,
                .press = {0.42, 0.1, 0.12},
                .speed_mm_s = 220,
                .fill = 0.85,
                .scatter_deg = 6,
                .seed = 61});
    paint_area(painter, along_its_outline(front), paints,
               {.brush = "Filbert 14",
                .size_mm = 4.5,
                .spacing_mm = 2.8,
                .length_mm = 12,
                .inset_mm = 0.8,
                .press = {0.32, 0.1, 0.12},
                .speed_mm_s = 200,
                .strokes_per_dip = 4,
                .most_depth_mm = 4.5,
                .seed = 62});
    mend_the_edge(painter, front, paints, 63);
}

void bands_and_rim(Painter& painter) {
    painter.take("Round sable 9", 4.5);
    painter.dip(load(mixture("PB29 PB28=0.6"), mixture("PB28 PW6=0.4"), 0.3));
    paint_along(painter, arc(35.5, 75.0, 0.9, 1), 140, {0.5, 0.08, 0.1});
    painter.wipe();
    painter.dip(load(mixture("PB29 PB28=0.6")));
    paint_along(painter, arc(33.0, 79.5, 0.86, 1), 140, {0.22, 0.08, 0.1});
    painter.take("Filbert 14", 3.6);
    painter.dip(load(mixture("PW6=6 PY43=0.2"), mixture("PW6=4 PB28=0.3"), 0.25, 1.1));
    paint_along(painter, arc(38.4, 66.3, 0.97, 1), 110, {0.5, 0.05, 0.08});
}

}  // namespace

void paint_bowl_inside(Painter& painter) {
    inside_of_the_bowl(painter);
    back_of_the_rim(painter);
}

void paint_bowl_front(Painter& painter) {
    front_of_the_bowl(painter);
    bands_and_rim(painter);
}

}  // namespace pastoso::examples
