// The evening wet in wet: clouds, edges that are lost and found, reflections.
#include "evening_parts.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::examples::evening {
namespace {

/// A short stroke about a point, a little bowed.
void dab(Painter& painter, Point at, double half_mm, double turn_rad, double pressure) {
    const Point out{half_mm * std::cos(turn_rad), half_mm * std::sin(turn_rad)};
    paint_along(painter, Curve({at - out, at + 0.3 * Point{-out.y, out.x}, at + out}), 100,
                {pressure, 0.2, 0.5});
}

/// A cloud about the line between two points: its dark body, then the light from below.
void cloud(Painter& painter, Point from, Point to, double size_mm, const char* body, const char* lit,
           int number) {
    const auto scatter = [&](const char* paint, const char* other, int count, double lower,
                             unsigned kind) {
        painter.take("Filbert 14", size_mm);
        painter.dip(load(mixture(paint), mixture(other), 0.3, 0.6));
        for (int i = 0; i < count; ++i) {
            const int draw = 40 * number + i;
            const double u = chance(draw, kind), thick = std::sin(3.14 * (0.1 + 0.8 * u));
            const Point at = from + u * (to - from) +
                             Point{0, (lower + 1.1 * (chance(draw, kind + 1) - 0.5)) * size_mm * thick};
            const double slope =
                std::atan2(to.y - from.y, to.x - from.x) + 0.35 * (chance(draw, kind + 2) - 0.5);
            dab(painter, at, size_mm * (0.7 + 0.9 * chance(draw, kind + 3)), slope,
                0.2 + 0.14 * chance(draw, kind + 4));
        }
    };
    scatter(body, lit, 6, -0.2, 331);
    scatter(lit, body, 3, 0.5, 341);
    painter.take("Blender 28", 1.6 * size_mm);
    const Point bow{0, -0.12 * length(to - from)};
    paint_along(painter, Curve({from, 0.5 * (from + to) + 0.5 * bow, to}), 260, {0.16, 0.3, 0.5});
}

void clouds(Painter& painter) {
    const char* const rose = "PW6=2.6 PR108=0.3 PY43=0.6 PR83=0.12";
    const char* const gold = "PW6=3 PO20=0.3 PY43=0.6";
    cloud(painter, {62, 19}, {116, 6}, 6, "PB29 PW6=0.8 PBr7-BS=0.8 PR83=0.2", rose, 1);
    cloud(painter, {84, 28}, {124, 23}, 4.6, "PB29=0.8 PW6=0.9 PBr7-BS=0.7 PR83=0.3", rose, 2);
    cloud(painter, {63, 30}, {82, 29}, 3, "PB29=0.6 PW6=1.3 PBr7-BS=0.5 PR83=0.3", gold, 3);
    cloud(painter, {92, 37}, {118, 35}, 2.6, "PB29=0.4 PW6=1.1 PBr7-BS=0.5 PR83=0.4", gold, 4);
    cloud(painter, {2, 10}, {24, 3}, 5, "PB29 PW6=0.9 PBr7-BS=0.6 PR83=0.1", rose, 5);
}

/// Leaves over the outline, dark into the wet sky.
void break_the_edges(Painter& painter) {
    painter.take("Fan 26", 6);
    int strokes = 0;
    for (int i = 0; i < 520; ++i) {
        const Point at{50 * chance(i, 351), 6 + 48 * chance(i, 352)};
        const double depth = crowns_mm(at);
        if (depth < 0.2 || depth > 2.6) continue;
        if (strokes++ % 3 == 0) {
            painter.wipe();
            painter.dip(load(mixture("PB29=0.8 PBr7-BU=1.2 PG18=0.4"),
                             mixture("PBr7-BS PG18=0.5 PB29=0.3"), 0.3, 0.4));
        }
        dab(painter, at, 0.5 + 1.0 * chance(i, 354), 3.1 * chance(i, 353), 0.2 + 0.2 * chance(i, 355));
    }
}

/// A poplar from foot to head: upright strokes, narrow at both ends.
void poplar(Painter& painter, double x, double head_y, double half_width_mm, int number) {
    painter.take("Filbert 14", 2.1);
    painter.dip(load(mixture("PB29=0.7 PBr7-BU=1.2 PG18=0.4"), 0.7));
    paint_along(painter, Curve({{x, kShore_y}, {x + 0.2, 0.5 * (kShore_y + head_y)}, {x, head_y + 1}}),
                160, {0.4, 0.1, 0.5});
    constexpr int kStrokes = 44;
    for (int i = 0; i < kStrokes; ++i) {
        const int draw = 100 * number + i;
        if (i % 2 == 0) {
            painter.wipe();
            painter.dip(load(mixture("PB29=0.7 PBr7-BU=1.2 PG18=0.4"),
                             mixture("PBr7-BS PG18=0.5 PB29=0.25"), 0.2 + 0.3 * chance(draw, 380), 0.6));
        }
        const double up = (i + chance(draw, 381)) / kStrokes,
                     wide = std::pow(std::sin(3.14159 * std::min(1.0, 0.12 + 0.9 * up)), 0.7);
        const double start = x + half_width_mm * wide * (2.0 * chance(draw, 382) - 1.0);
        const double y = kShore_y + (head_y - kShore_y) * 0.9 * up, high = 3.0 + 3.5 * chance(draw, 383);
        const double end = x + 0.5 * (start - x) + 0.5 * (chance(draw, 384) - 0.5);
        paint_along(painter,
                    Curve({{start, y}, {0.5 * (start + end) + 0.3, y - 0.5 * high}, {end, y - high}}),
                    140, {0.28 + 0.14 * chance(draw, 385), 0.15, 0.6});
    }
}

/// Warm light catches the leaves that face the sun, cool light those that face the sky.
void light_the_leaves(Painter& painter) {
    painter.take("Fan 26", 5);
    int strokes = 0;
    for (int i = 0; i < 520; ++i) {
        const Point at{2 + 50 * chance(i, 365), 10 + 43 * chance(i, 366)};
        const double depth = trees_mm(at), side = depth - trees_mm(at + Point{3.0, 0.6});
        if (depth < 0.5 || depth > 8.0 || side < 0.6 || chance(i, 367) > 0.55) continue;
        if (strokes++ % 3 == 0) {
            painter.wipe();
            const bool warm = at.x + 14 * chance(i, 368) > 40;
            painter.dip(load(mixture(warm ? "PBr7-BS PY43=0.35 PG18=0.6 PB29=0.15"
                                          : "PG18=0.9 PY43=0.3 PBr7-BS=0.7 PB29=0.6"),
                             mixture(warm && at.x > 42 ? "PY43 PBr7-BS=0.7 PG18=0.2"
                                                       : "PBr7-BS=0.8 PG18=0.7 PB29=0.2"),
                             0.35, 0.6));
        }
        dab(painter, at, 0.5 + 1.0 * chance(i, 369), -1.3 + 1.5 * chance(i, 370),
            0.2 + 0.2 * chance(i, 371));
    }
}

/// Level strokes that narrow downwards.
void mirror_the_poplars(Painter& painter) {
    painter.take("Filbert 14", 2.0);
    for (int i = 0; i < 34; ++i) {
        if (i % 4 == 0) {
            painter.wipe();
            painter.dip(load(mixture("PB29=0.8 PBr7-BU PBr7-BS=0.3"), 0.5));
        }
        const bool tall = i < 21;
        const double down = tall ? i / 21.0 : (i - 21) / 13.0;
        const double y = kShore_y + 1.2 + (tall ? 24 : 14) * down + chance(i, 390);
        const double x = (tall ? 52.5 : 59.5) + 2.2 * (chance(i, 391) - 0.5),
                     half = (tall ? 3.4 : 2.4) * (1.1 - down) * (0.6 + 0.8 * chance(i, 392));
        paint_along(painter, Curve({{x - half, y}, {x, y + 0.3}, {x + half, y}}), 140,
                    {0.24 + 0.12 * chance(i, 393), 0.25, 0.4});
    }
}

/// The water's edge is lost here and found there, and a soft brush lays the reflections level.
void level_the_water(Painter& painter) {
    for (int i = 0; i < 13; ++i) {
        painter.take("Blender 28", 5 + 3 * chance(i, 375));
        const double y = kShore_y + 1.5 + 27 * chance(i, 376), half = 6 + 9 * chance(i, 377);
        const double x = i < 8 ? 34 + 26 * chance(i, 378) : 120 * chance(i, 378);
        paint_along(painter, Curve({{x - half, y}, {x, y + 0.3}, {x + half, y}}), 260,
                    {0.18 + 0.06 * chance(i, 379), 0.3, 0.5});
    }
}

}  // namespace

void paint_wet_in_wet(Painter& painter) {
    painter.use_medium("linseed oil");
    clouds(painter);
    break_the_edges(painter);
    painter.use_medium("heavy-body oil");
    poplar(painter, 52.5, 11, 2.6, 1);
    poplar(painter, 59.5, 28, 1.8, 2);
    painter.use_medium("linseed oil");
    light_the_leaves(painter);
    level_the_water(painter);
    mirror_the_poplars(painter);
}

}  // namespace pastoso::examples::evening
