// The evening's finish: lights with the knife, a scumble over the dry relief, a glaze.
#include "evening_parts.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::examples::evening {
namespace {

/// A ribbon of thick paint: the blade lies flat, askew to its way, so that its ends are slanted.
void ribbon(Painter& painter, Point from, Point to, double pressure, int number) {
    const Point middle = 0.5 * (from + to) + Point{0, 0.5 * (chance(number, 430) - 0.3)};
    paint_along(painter, Curve({from, middle, to}), 70 + 60 * chance(number, 431),
                {pressure, 0.1 + 0.2 * chance(number, 432), 0.35 + 0.3 * chance(number, 433)},
                (chance(number, 434) < 0.4 ? 70 : 40) * (chance(number, 435) < 0.5 ? 1 : -1));
}

void light_the_sky(Painter& painter) {
    painter.take("Palette knife 17", 4.5);
    painter.dip(load(mixture("PW6=5 PY35=0.8"), mixture("PW6=6 PY35=0.3"), 0.4, 0.35));
    ribbon(painter, {70, 48.2}, {81, 47.6}, 0.41, 1);
    painter.take("Palette knife 17", 1.8);
    painter.dip(load(mixture("PW6=4 PY35=0.7 PO20=0.12"), mixture("PW6=6 PY35=0.4"), 0.4, 0.35));
    ribbon(painter, {82.5, 46.4}, {104, 47.0}, 0.45, 2);
    ribbon(painter, {63.8, 49.6}, {69.5, 49.3}, 0.45, 3);
}

/// Broken pieces of light, the broader the nearer.
void light_the_water(Painter& painter) {
    for (int i = 0; i < 16; ++i) {
        const double down = std::pow((i + chance(i, 401)) / 16.0, 1.25), y = kShore_y + 1.2 + 28 * down;
        if (i % 3 == 0) {
            painter.take("Palette knife 17", 1.5 + 1.6 * down);
            painter.dip(
                load(mixture(i % 2 == 0 ? "PW6=4 PY35=0.8 PO20=0.06" : "PW6=4 PY35=0.5 PR108=0.14"),
                     mixture("PW6=6 PY35=0.3"), 0.4, 0.35));
        }
        const double half = (0.8 + 4.6 * chance(i, 402) * chance(i, 406)) * (0.7 + 1.0 * down);
        const double x = kSun.x + (2.0 * chance(i, 403) - 1.0) * (2.2 + 8.5 * down * chance(i, 407));
        ribbon(painter, {x - half, y + 0.15}, {x + half, y - 0.15 + 0.3 * chance(i, 404)},
               0.41 + 0.12 * chance(i, 405), 10 + i);
    }
}

/// A punt, and who stands in it, before the light.
void boat(Painter& painter) {
    const auto dark = [&](double size_mm, const std::vector<Point>& points, double pressure) {
        painter.take("Round sable 9", size_mm);
        painter.dip(load(mixture("PBr7-BU PB29=0.9 PR83=0.3"), 0.9));
        paint_along(painter, Curve(points), 50, {pressure, 0.3, 0.35});
    };
    dark(1.6, {{79.6, 63.9}, {83, 65.3}, {89, 65.6}, {94.2, 63.7}}, 0.45);
    dark(1.6, {{81.2, 65.4}, {86, 66.3}, {92.4, 65.3}}, 0.45);
    dark(1.2, {{86.3, 65.0}, {86.5, 62.5}, {86.3, 60.2}}, 0.5);
    dark(0.9, {{86.3, 61.4}, {87.3, 62.2}, {88.2, 61.6}}, 0.35);
    dark(1.0, {{86.3, 59.9}, {86.45, 59.6}, {86.5, 59.4}}, 0.5);
    painter.take("Filbert 14", 2.4);
    painter.dip(load(mixture("PBr7-BU PB29 PR83=0.2 PW6=0.2"), 0.4));
    for (int i = 0; i < 3; ++i) {
        const double y = 67.4 + 1.9 * i, half = (5.2 - 1.1 * i) * (0.7 + 0.5 * chance(i, 441)),
                     x = 87 + 2.4 * (chance(i, 442) - 0.5);
        paint_along(painter, Curve({{x - half, y}, {x, y + 0.3}, {x + half, y - 0.1}}), 120,
                    {0.26 - 0.04 * i, 0.3, 0.5});
    }
}

/// Where the light touches the boat, and the one red of the picture.
void accents(Painter& painter) {
    painter.take("Detail round 3", 0.9);
    painter.dip(load(mixture("PR108 PR254=0.4"), 0.7));
    paint_along(painter, Curve({{86.0, 59.3}, {86.4, 59.0}, {86.8, 59.2}}), 20, {0.4, 0.3, 0.3});
    painter.take("Detail round 3", 0.7);
    painter.dip(load(mixture("PW6=4 PY35=0.6 PO20=0.2"), 0.6));
    paint_along(painter, Curve({{79.8, 63.3}, {83, 64.5}, {85.6, 64.8}}), 60, {0.32, 0.3, 0.5});
    paint_along(painter, Curve({{85.7, 61.6}, {85.8, 63.6}}), 40, {0.28, 0.3, 0.5});
}

/// The highest lights once more, clean above the glaze.
void restate_the_lights(Painter& painter) {
    painter.use_medium("linseed oil");
    painter.take("Round sable 9", 2.6);
    painter.dip(load(mixture("PW6=5 PY35=0.5 PO20=0.02"), 1.0));
    painter.stroke(0.2, [](double u) {
        const double turn = 7.0 * u, radius = 0.9 * (1.0 - 0.7 * u);
        return Touch{kSun.x - 0.8 + radius * std::cos(turn), kSun.y - 0.4 + radius * std::sin(turn),
                     pressure_at({0.45, 0.1, 0.2}, u)};
    });
    painter.use_medium("heavy-body oil");
    const Point lights[] = {{73.4, 57.6}, {77.0, 60.8}, {74.6, 66.4}, {72.2, 74.0}};
    const double halves[] = {1.6, 1.0, 2.4, 1.4};
    for (int i = 0; i < 4; ++i) {
        painter.take("Palette knife 17", 1.4 + 0.4 * i);
        painter.dip(load(mixture("PW6=5 PY35=0.5 PO20=0.05"), 0.3));
        ribbon(painter, lights[i] - Point{halves[i], 0}, lights[i] + Point{halves[i], -0.15}, 0.42,
               51 + i);
    }
}

/// Tufts along the near bank, and some light on them.
void grass(Painter& painter) {
    painter.take("Fan 26", 6);
    for (int i = 0; i < 30; ++i) {
        if (i % 3 == 0) {
            painter.wipe();
            painter.dip(load(mixture(i < 15 ? "PBr7-BU PB29=0.6 PG18=0.3" : "PBr7-BS PY43=0.9 PG18=0.4"),
                             mixture("PG18=0.6 PBr7-BS PY43=0.3"), 0.35, 0.4));
        }
        const double x = 48 * chance(i, 443), y = 75 + 0.3 * x + 8 * chance(i, 444),
                     lean = 2 * (chance(i, 445) - 0.5);
        paint_along(painter, Curve({{x, y}, {x + 0.3 * lean, y - 1.8}, {x + lean, y - 3.5}}), 110,
                    {0.22 + 0.16 * chance(i, 446), 0.15, 0.6});
    }
}

/// Stalks before the water, thin and fluid.
void reeds(Painter& painter) {
    painter.take("Rigger 2", 0.7);
    for (int i = 0; i < 34; ++i) {
        if (i % 3 == 0) {
            painter.wipe();
            painter.dip(
                load(mixture(chance(i, 411) > 0.7 ? "PBr7-BS PY43=0.7 PG18=0.3" : "PBr7-BU PB29=0.8"),
                     mixture("PBr7-BU PG18=0.4"), 0.3, 0.9));
        }
        const double x = 3 + 46 * chance(i, 412) * chance(i, 413) + (i % 4 == 0 ? 14 : 0),
                     y = 79 + 0.22 * x + 4 * chance(i, 414);
        const double high = 8 + 11 * chance(i, 415), lean = 9 * (chance(i, 416) - 0.35);
        paint_along(painter, Curve({{x, y}, {x + 0.25 * lean, y - 0.55 * high}, {x + lean, y - high}}),
                    190, {0.3 + 0.2 * chance(i, 417), 0.1, 0.6});
    }
}

}  // namespace

void set_lights_with_the_knife(Painter& painter) {
    painter.use_medium("heavy-body oil");
    light_the_sky(painter);
    light_the_water(painter);
    boat(painter);
    accents(painter);
    painter.use_medium("linseed oil");
    grass(painter);
    reeds(painter);
}

void scumble(Painter& painter) {
    painter.use_medium("heavy-body oil");
    painter.take("Dry scumbler 22", 14);
    for (int i = 0; i < 8; ++i) {
        painter.wipe();
        painter.dip(
            load(mixture(i % 3 == 2 ? "PW6=3 PB29=0.4 PR83=0.2" : "PW6=3 PR108=0.22 PY43=0.7"), 0.2));
        const double u = (i + chance(i, 421)) / 8.0, half = 6 + 9 * chance(i, 423);
        const bool upper = i % 2 == 0;
        const double x = upper ? 72 + 44 * u : 82 + 38 * u,
                     y = (upper ? 19 - 9 * u : 30.5 - 5 * u) + 3 * (chance(i, 422) - 0.3);
        paint_along(painter,
                    Curve({{x - half, y + 1.5}, {x, y - 1.5 * chance(i, 424)}, {x + half, y - 1.5}}),
                    180, {0.2 + 0.1 * chance(i, 425), 0.2, 0.5});
    }
    painter.take("Dry scumbler 22", 9);
    for (int i = 0; i < 5; ++i) {
        painter.wipe();
        painter.dip(load(mixture("PW6=2 PB29=0.5 PR83=0.1"), 0.2));
        const double x = 100 + 14 * (chance(i, 426) - 0.5), y = 66 + 4.6 * i,
                     half = 7 + 6 * chance(i, 427);
        paint_along(painter, Curve({{x - half, y}, {x, y + 0.4}, {x + half, y}}), 160,
                    {0.2 + 0.08 * chance(i, 428), 0.2, 0.5});
    }
    painter.dry_now();
}

void glaze(Painter& painter) {
    painter.use_medium("alkyd gel");
    painter.take("Soft glazing flat 16", 14);
    for (int i = 0; i < 7; ++i) {
        painter.wipe();
        painter.dip(load(mixture("PY74=0.5 PR83", i == 0 ? 0.05 : 0.11), 0.8));
        const double y = 37 + 7 * i, drift = 2.5 * (chance(i, 429) - 0.5),
                     from = 36 + 16 * chance(i, 436);
        const double to = y > kShore_y ? 98 + 14 * chance(i, 439) : 128;
        paint_along(painter, Curve({{from, y - drift}, {80, y + drift}, {to, y}}), 260,
                    {0.25, 0.35, 0.35});
    }
    painter.wait(0.4);
    painter.dry_now();
    restate_the_lights(painter);
}

}  // namespace pastoso::examples::evening
