#include "core/units.hpp"
#include "paths.hpp"
#include "scenes.hpp"

#include <cmath>
#include <string>

namespace pastoso::examples {
namespace {

constexpr double kPi = core::kPi;

/// A wave from (x, y) over `width`, `height` up and down, of `waves` periods.
Curve wave(Point start, double width, double height, double waves) {
    std::vector<Point> points;
    for (int i = 0; i <= 16; ++i) {
        const double u = i / 16.0;
        points.push_back({start.x + width * u, start.y + height * std::sin(2.0 * kPi * waves * u)});
    }
    return Curve(points);
}

Curve straight(Point from, Point to) {
    return Curve({from, to});
}

void loaded_flat(Painter& painter) {
    painter.take("Flat bristle 20", 22);
    document::LoadPaint blue = load(mixture("PB28 PW6=0.15"), mixture("PB28 PW6=1.3"), 0.4);
    painter.dip(blue);
    paint_along(painter, wave({11, 18}, 106, -4.5, 0.9), 80, {0.42, 0.05, 0.05});
}

void dry_flat(Painter& painter) {
    painter.take("Flat bristle 20", 22);
    painter.dip(load(mixture("PR101 PY43"), 0.15));
    paint_along(painter, wave({12, 46.5}, 108, 1.2, 0.8), 80, {0.13, 0.05, 0.2});
}

void wet_crossings(Painter& painter) {
    painter.take("Flat bristle 20", 15);
    painter.dip(load(mixture("PY35 PW6=0.12"), mixture("PY35 PY43=0.3"), 0.3, 0.9));
    paint_along(painter, wave({10, 72}, 68, 1.5, 0.65), 70, {0.5, 0.06, 0.06});
    painter.take("Flat bristle 20", 15);
    painter.dip(load(mixture("PB29 PW6=0.3"), 0.55));
    paint_held(painter, straight({28, 59}, {30, 89}), 45, {0.5, 0.06, 0.1}, 3);
    painter.take("Flat bristle 20", 15);
    painter.dip(load(mixture("PW6"), 0.55));
    paint_held(painter, straight({53, 59}, {55, 89}), 45, {0.5, 0.06, 0.1}, 3);
}

void knife_over_bands(Painter& painter) {
    painter.take("Impasto flat 18", 17);
    painter.dip(load(mixture("PR108"), mixture("PR254 PR83=0.3"), 0.3, 0.95));
    paint_along(painter, straight({88, 66}, {128, 66}), 60, {0.4, 0.06, 0.06});
    painter.take("Impasto flat 18", 17);
    painter.dip(load(mixture("PW6 PY43=0.12"), mixture("PW6 PR101=0.03"), 0.4, 0.95));
    paint_along(painter, straight({88, 83}, {128, 82.5}), 60, {0.4, 0.06, 0.06});
    painter.take("Palette knife 17");
    paint_held(painter, Curve({{97, 74}, {108, 77}, {124, 75.5}}), 30, {0.55, 0.04, 0.04}, 76);
}

/// A thin line that swells to the full width of the tip and closes again.
void round_swell(Painter& painter) {
    painter.take("Round sable 9");
    painter.dip(load(mixture("PBk9 PB29")));
    const Curve curve = wave({137, 17}, 50, 6, 1.1);
    painter.stroke(1.0, [&](double u) {
        const Point at = curve.at(u);
        const double swell = std::sin(kPi * u);
        return Touch{at.x, at.y, 0.06 + 0.76 * swell * swell};
    });
}

void leaning_round(Painter& painter) {
    painter.take("Round sable 9");
    painter.dip(load(mixture("PR122"), mixture("PR122 PW6=0.5"), 0.3));
    const Curve curve = wave({138, 38}, 49, 3, 1.0);
    painter.stroke(0.9, [&](double u) {
        const Point at = curve.at(u);
        return Touch{at.x, at.y, pressure_at({0.45, 0.08, 0.12}, u), 0, 0, 35};
    });
}

void leaves(Painter& painter) {
    painter.take("Round sable 9", 8);
    for (int i = 0; i < 8; ++i) {
        painter.wipe();
        painter.dip(load(mixture("PG7=0.3 PY74"), mixture("PG7=0.5 PBr7-BS=0.5 PY74=0.4"), 0.35));
        const double angle = -1.05 + 0.3 * i;
        const Point foot{142.0 + 6.1 * i, 65};
        const Point tip = foot + Point{13.0 * std::sin(angle) * 0.6, -14.0 * std::cos(angle)};
        const Curve curve = straight(foot, tip);
        painter.stroke(0.25, [&](double u) {
            const Point at = curve.at(u);
            return Touch{at.x, at.y, 0.6 * (1.0 - u) * smooth_step(0.0, 0.18, u)};
        });
    }
}

void filbert_dabs(Painter& painter) {
    const std::string colours[] = {"PW6 PB36=0.25", "PW6 PB36=0.45", "PW6 PR122=0.06", "PW6 PY43=0.3",
                                   "PW6 PO20=0.12"};
    painter.take("Filbert 14");
    for (int i = 0; i < 5; ++i) {
        painter.wipe();
        painter.dip(load(mixture(colours[i]), mixture("PW6"), 0.3, 0.9));
        const Point top{140.0 + 11.2 * i, 74};
        const Curve curve({top, top + Point{0.8, 6}, top + Point{3, 14}});
        painter.stroke(0.35, [&](double u) {
            const Point at = curve.at(u);
            return Touch{at.x, at.y, pressure_at({0.5, 0.2, 0.3}, u), 6, 0, 12};
        });
    }
}

void fan_sweep(Painter& painter) {
    painter.take("Fan 26");
    painter.dip(load(mixture("PG17"), mixture("PG17 PY35=0.8"), 0.35, 0.75));
    paint_along(painter, Curve({{12, 115}, {34, 111}, {58, 111.5}, {80, 115}}), 70, {0.36, 0.06, 0.08});
}

void double_load(Painter& painter) {
    painter.take("Flat bristle 20");
    document::LoadPaint two = load(mixture("PB29 PW6=0.55"));
    two.second = mixture("PW6");
    two.second_share = 0.5;
    two.side_by_side = true;
    painter.dip(two);
    paint_along(painter, wave({97, 111}, 92, 6.5, 0.88), 70, {0.5, 0.06, 0.06}, 180);
}

/// Thick petals, each one short pressed stroke from the middle outwards.
void petals(Painter& painter, Point middle, const std::string& colour, const std::string& heart) {
    painter.take("Impasto flat 18", 4.5);
    for (int i = 0; i < 6; ++i) {
        painter.wipe();
        painter.dip(load(mixture(colour), mixture("PW6"), 0.25, 1.0));
        const double angle = 2.0 * kPi * (i + 0.2) / 6.0;
        const Point outwards{std::cos(angle), std::sin(angle)};
        paint_along(painter, straight(middle + 1.2 * outwards, middle + 5.4 * outwards), 20,
                    {0.5, 0.3, 0.3});
    }
    painter.take("Round sable 9", 4);
    painter.dip(load(mixture(heart), 1.2));
    paint_held(painter, straight(middle - Point{0.4, 0}, middle + Point{0.4, 0}), 5, {0.6, 0.3, 0.3}, 0);
}

/// A thinned dark red over white and black: what lies below shows through and is drawn along.
void glaze_over_bars(Painter& painter) {
    painter.take("Flat bristle 20", 6);
    for (int i = 0; i < 5; ++i) {
        painter.wipe();
        painter.dip(load(mixture(i % 2 == 0 ? "PW6" : "PBr7-BU PB29=0.5"), 0.4));
        paint_held(painter, straight({16.0 + 13.0 * i, 130}, {16.5 + 13.0 * i, 145}), 40,
                   {0.32, 0.1, 0.1}, 0);
    }
    painter.take("Soft glazing flat 16", 8);
    painter.dip(load(mixture("PR83", 0.12)));
    paint_along(painter, straight({9, 138}, {80, 138.5}), 60, {0.22, 0.06, 0.06});
}

void knife_impasto(Painter& painter) {
    const std::string colours[] = {"PY35 PW6=0.4", "PO20 PW6=0.2", "PR254 PO20=0.5"};
    painter.take("Palette knife 17", 12);
    for (int i = 0; i < 3; ++i) {
        painter.wipe();
        painter.dip(load(mixture(colours[i]), mixture("PW6=2 PY35"), 0.4, 0.5));
        const Point from{97.0 + 20.0 * i, 140};
        paint_held(painter, Curve({from, from + Point{7, -2}, from + Point{14, -1}}), 30,
                   {0.3, 0.06, 0.25}, 80);
    }
}

void spiral(Painter& painter) {
    std::vector<Point> points;
    for (int i = 0; i <= 40; ++i) {
        const double angle = 2.0 * kPi * 2.4 * i / 40.0;
        const double radius = 10.5 - 8.5 * i / 40.0;
        points.push_back({176 + radius * std::cos(angle), 135.5 + 0.92 * radius * std::sin(angle)});
    }
    painter.take("Filbert 14", 4.5);
    painter.dip(load(mixture("PV23 PW6=2.5 PR122=0.6"), mixture("PW6=2 PB29=0.4"), 0.35, 1.1));
    paint_along(painter, Curve(points), 50, {0.4, 0.04, 0.1});
}

}  // namespace

document::Recording sampler() {
    document::CanvasSettings canvas;
    canvas.width_mm = 200;
    canvas.height_mm = 150;
    canvas.px_per_mm = 4;
    canvas.support = "linen";
    Painter painter(canvas);
    painter.use_medium("heavy-body oil");
    loaded_flat(painter);
    dry_flat(painter);
    wet_crossings(painter);
    round_swell(painter);
    leaning_round(painter);
    leaves(painter);
    filbert_dabs(painter);
    fan_sweep(painter);
    petals(painter, {86, 103}, "PR254 PR122=0.3", "PY35");
    petals(painter, {83, 119}, "PB29 PW6", "PO20 PY35");
    double_load(painter);
    glaze_over_bars(painter);
    spiral(painter);
    knife_impasto(painter);
    knife_over_bands(painter);
    return painter.finish(1.0);
}

}  // namespace pastoso::examples
