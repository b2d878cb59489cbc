// The evening's body of paint: the large masses, thin in the dark and thicker in the light.
#include "evening_parts.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::examples::evening {
namespace {

/// From the deep blue above to the light at the sun.
const std::vector<const char*> kSky = {"PB29 PW6=1.0 PBr7-BS=0.5",
                                       "PB29 PW6=1.5 PBr7-BS=0.6",
                                       "PB29=0.8 PW6=1.9 PBr7-BS=0.55 PR83=0.12",
                                       "PB29=0.5 PW6=2.2 PBr7-BS=0.45 PR83=0.22",
                                       "PW6=2.6 PB29=0.22 PR83=0.26 PY43=0.5 PBr7-BS=0.2",
                                       "PW6=2.8 PY43=0.8 PR108=0.16 PB29=0.06",
                                       "PW6=3 PY35=0.5 PR108=0.14 PY43=0.45",
                                       "PW6=3.5 PY35=0.75 PO20=0.12",
                                       "PW6=5 PY35=0.7"};

/// Air that streams away from the sun.
Point air(Point at) {
    const Point from = at - kSun;
    const double wave = 0.3 * std::sin(at.x / 16 + at.y / 8);
    const double away = 0.6 * smooth_step(8, 45, length(from));
    return {1.0, wave + away * from.y / (10.0 + std::abs(from.x))};
}

Handling broad(const char* brush, double size_mm, unsigned seed) {
    return {.brush = brush,
            .size_mm = size_mm,
            .spacing_mm = 0.7 * size_mm,
            .length_mm = 2.4 * size_mm,
            .inset_mm = 0.12 * size_mm,
            .press = {0.4, 0.1, 0.25},
            .speed_mm_s = 900,
            .fill = 0.6,
            .strokes_per_dip = 2,
            .scatter_deg = 16,
            .scatter_tone = 0.06,
            .scatter_press = 0.25,
            .scatter_length = 0.4,
            .shuffled = true,
            .seed = seed};
}

void block_in_sky(Painter& painter) {
    const Area sky{[](Point at) {
                       return std::min({on_canvas_mm(at), 0.4 - crowns_mm(at), 1.0 - far_bank_mm(at),
                                        kShore_y - 1 - at.y});
                   },
                   air,
                   [](Point at) {
                       return 0.03 + glow(at) +
                              0.07 * std::sin(at.x / 11 + at.y / 4.5) * smooth_step(46, 20, at.y);
                   }};
    Handling large = broad("Flat bristle 20", 10, 321);
    large.least_tone = -1;
    large.most_tone = 0.6;
    paint_area(painter, sky, half_mixed(kSky), large);
    Handling small = broad("Filbert 14", 6, 326);
    small.least_tone = 0.5;
    small.scatter_deg = 9;
    small.fill = 0.75;
    paint_area(painter, sky, half_mixed(kSky), small);
}

/// As light as the sky that it mirrors, or a little darker, and dark under the trees.
double water_tone(Point at) {
    const double below = at.y - kShore_y;
    const double spread = 1.5 - 0.012 * below;
    const double path = 0.5 * bell(at.x, kSun.x + 2.5 * std::sin(at.y / 3.0), 4.5 + 0.2 * below);
    const double sky =
        0.2 + 0.55 * glow({kSun.x + (at.x - kSun.x) * spread, kShore_y - 0.9 * below}) - 0.006 * below;
    return (sky + path) * smooth_step(2.5, -1.0, mirrored_trees_mm(at));
}

void block_in_water(Painter& painter) {
    const Area water{
        [](Point at) {
            return std::min({on_canvas_mm(at), at.y - kShore_y - 0.4, 1.5 - near_bank_mm(at)});
        },
        [](Point at) {
            return Point{1.0, 0.05 * std::sin(at.x / 8 + at.y)};
        },
        water_tone};
    Handling handling = broad("Flat bristle 20", 6, 322);
    handling.length_mm = 17;
    handling.spacing_mm = 4.1;
    handling.inset_mm = 0.4;
    handling.scatter_deg = 3;
    handling.scatter_tone = 0.09;
    paint_area(
        painter, water,
        half_mixed({"PB29=0.6 PBr7-BU=1.1 PG18=0.3", "PB29=0.9 PBr7-BU PBr7-BS=0.3 PW6=0.25",
                    "PB29 PW6=0.9 PBr7-BS=0.7", "PB29=0.8 PW6=1.4 PBr7-BS=0.6 PR83=0.08",
                    "PB29=0.5 PW6=2 PBr7-BS=0.5 PR83=0.18",
                    "PW6=2.4 PB29=0.24 PR83=0.24 PY43=0.5 PBr7-BS=0.2",
                    "PW6=2.6 PY43=0.8 PR108=0.18 PB29=0.08", "PW6=3 PY35=0.5 PR108=0.14 PY43=0.4"}),
        handling);
}

/// Thin: the wash stays to be felt.
void block_in_trees(Painter& painter) {
    const Area trees{crowns_mm,
                     [](Point at) {
                         const Point from = at - Point{24, 56};
                         return Point{0.7 * from.x / 20 + 0.3 * std::sin(at.y / 4), -1.0};
                     },
                     [](Point at) {
                         return 0.2 + 0.3 * smooth_step(22, 48, at.x) +
                                0.3 * std::sin(at.x / 4.1) * std::sin(at.y / 5);
                     }};
    Handling handling = broad("Filbert 14", 6.5, 323);
    handling.length_mm = 10;
    handling.spacing_mm = 4;
    handling.inset_mm = 0.8;
    handling.scatter_deg = 42;
    handling.scatter_tone = 0.14;
    handling.fill = 0.25;
    handling.strokes_per_dip = 3;
    paint_area(painter, trees,
               half_mixed({"PB29=0.9 PBr7-BU=1.3 PG18=0.3", "PBr7-BU PB29=0.5 PG18=0.6",
                           "PBr7-BS PG18=0.7 PB29=0.35"},
                          0.2),
               handling);
}

void block_in_far_bank(Painter& painter) {
    const Area far{[](Point at) { return std::min(far_bank_mm(at), 0.8 - crowns_mm(at)); },
                   [](Point at) {
                       return Point{1.0, -0.15 * smooth_step(88, 112, at.x)};
                   },
                   [](Point at) { return 0.08 + 0.9 * bell(at.x, kSun.x, 17); }};
    Handling handling = broad("Filbert 14", 3.2, 324);
    handling.inset_mm = 0.8;
    paint_area(painter, far,
               half_mixed({"PB29 PBr7-BS=0.9 PW6=0.35", "PB29=0.8 PBr7-BS PR83=0.25 PW6=0.6",
                           "PBr7-BS PR83=0.35 PB29=0.3 PY43=0.5 PW6=0.5"}),
               handling);
}

void block_in_near_bank(Painter& painter) {
    const Area near{
        [](Point at) { return std::min(on_canvas_mm(at), near_bank_mm(at)); },
        [](Point at) {
            return Point{1.0, 0.24 + 0.3 * std::sin(at.x / 5)};
        },
        [](Point at) { return 0.75 - 0.06 * near_bank_mm(at) + 0.2 * std::sin(at.x / 4 + at.y); }};
    Handling handling = broad("Filbert 14", 6, 325);
    handling.least_tone = -1;
    handling.most_tone = 2;
    handling.scatter_deg = 26;
    paint_area(painter, near,
               half_mixed({"PBr7-BU PB29=0.8", "PBr7-BU PG18=0.4 PB29=0.3 PY43=0.3",
                           "PBr7-BS PG18=0.5 PY43=0.7"}),
               handling);
}

}  // namespace

void block_in(Painter& painter) {
    painter.use_medium("linseed oil");
    block_in_trees(painter);
    block_in_near_bank(painter);
    block_in_sky(painter);
    block_in_far_bank(painter);
    block_in_water(painter);
}

}  // namespace pastoso::examples::evening
