// A wave that breaks before a low sun: thin far away, thick with foam in front.
#include "area.hpp"
#include "core/random.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::examples {
namespace {

using Paints = std::vector<document::LoadPaint>;

constexpr double kWidth_mm = 180, kHeight_mm = 120, kHorizon_y = 46;
constexpr Point kSun{128, 37};

double bell(double x, double middle, double width) {
    return std::exp(-std::pow((x - middle) / width, 2));
}

/// Strokes may run over the edges.
double on_canvas_mm(Point at) {
    return 8.0 + std::min({at.x, kWidth_mm - at.x, at.y, kHeight_mm - at.y});
}

/// Rises slowly from the left and falls steeply where it breaks.
double crest_y(double x) {
    return 80 - 23 * bell(x, 80, x < 80 ? 62 : 27) + 1.2 * std::sin(x / 8.0);
}
double trough_y(double x) {
    return 96 + 3 * std::sin(x / 26.0) - 6 * smooth_step(110, 180, x);
}

Paints half_mixed(const std::vector<const char*>& tones) {
    Paints paints;
    for (std::size_t i = 0; i < tones.size(); ++i)
        paints.push_back(
            load(mixture(tones[i]), mixture(tones[i + 1 < tones.size() ? i + 1 : i - 1]), 0.3));
    return paints;
}

void tone_the_ground(Painter& painter) {
    painter.take("Soft glazing flat 16", 34);
    for (int i = 0; i < 5; ++i) {
        painter.dip(load(mixture("PBr7-BS PY43=0.6 PW6=0.5", 0.3), 0.6));
        const double y = 10.0 + 25.0 * i;
        paint_along(painter, Curve({{-12, y}, {90, y + 2}, {192, y}}), 500, {0.32, 0.03, 0.03});
    }
    painter.dry_now();
}

/// The strokes of the sky go round the sun.
void paint_sky(Painter& painter) {
    const Area sky{[](Point at) { return std::min(on_canvas_mm(at), kHorizon_y - at.y); },
                   [](Point at) {
                       const Point from = at - kSun;
                       const double near = bell(length(from), 0, 42);
                       return Point{1.0 - near - near * from.y / 16, 0.12 + near * from.x / 16};
                   },
                   [](Point at) {
                       const Point from{at.x - kSun.x, 1.5 * (at.y - kSun.y)};
                       return 0.08 + 0.52 * bell(length(from), 0, 34) + 0.34 * at.y / kHorizon_y +
                              0.04 * std::sin(at.x / 13 + at.y / 6);
                   }};
    paint_area(painter, sky,
               half_mixed({"PB29=1.2 PB28=0.8 PW6=1.5 PV23=0.03", "PB28=1.2 PB29=0.3 PW6=3",
                           "PB36=0.9 PW6=5 PV23=0.015", "PW6=6 PR254=0.12 PY43=0.4 PB36=0.3",
                           "PW6=5 PO20=0.4 PY35=0.4", "PW6=5 PY35=1.2 PO20=0.12"}),
               {.brush = "Flat bristle 20",
                .size_mm = 9,
                .spacing_mm = 6,
                .length_mm = 24,
                .inset_mm = 2.2,
                .press = {0.42, 0.08, 0.12},
                .speed_mm_s = 420,
                .fill = 0.85,
                .strokes_per_dip = 2,
                .scatter_deg = 12,
                .scatter_tone = 0.07,
                .seed = 101});
}

void cloud(Painter& painter, Point middle, double width) {
    const auto band = [&](double dx, double dy, double share, const char* paint, const char* second) {
        painter.take("Filbert 14", 5);
        painter.dip(load(mixture(paint), mixture(second), 0.4, 1.0));
        const double half = 0.5 * share * width;
        paint_along(painter,
                    Curve({{middle.x + dx - half, middle.y + dy + 1.2},
                           {middle.x + dx, middle.y + dy - 1.2},
                           {middle.x + dx + half, middle.y + dy + 0.6}}),
                    200, {0.42, 0.25, 0.35});
    };
    band(0, 2.0, 1.0, "PW6=4 PV23=0.04 PB29=0.2", "PW6=5 PR254=0.1 PY43=0.1");
    band(-0.08 * width, 0, 0.7, "PW6=6 PR254=0.08 PY43=0.15", "PW6=7 PY43=0.2");
    band(0.06 * width, -1.8, 0.4, "PW6=8 PY43=0.2", "PW6=7 PR254=0.05");
}

void paint_sun(Painter& painter) {
    painter.take("Round bristle 12", 6);
    painter.dip(load(mixture("PW6=3 PY35=1.4"), mixture("PW6=5 PY35=0.3"), 0.4, 1.2));
    std::vector<Point> turns;
    for (int i = 0; i <= 24; ++i) {
        const double angle = i * 0.6, radius = 3.4 - 0.13 * i;
        turns.push_back(kSun + radius * Point{std::cos(angle), std::sin(angle)});
    }
    paint_held(painter, Curve(turns), 60, {0.42, 0.1, 0.2}, 0);
}

void paint_far_sea(Painter& painter) {
    const Area sea{[](Point at) {
                       return std::min({on_canvas_mm(at), at.y - kHorizon_y, crest_y(at.x) - at.y});
                   },
                   [](Point at) {
                       return Point{1.0, 0.05 * std::sin(at.x / 9)};
                   },
                   [](Point at) {
                       const double depth = (at.y - kHorizon_y) / 34;
                       return 0.62 - 0.55 * depth + 0.34 * bell(at.x, kSun.x, 15 + 20 * depth) +
                              0.1 * std::sin(at.y * 1.4);
                   }};
    paint_area(painter, sea,
               half_mixed({"PB15:3=0.5 PB29 PBr7-BU=0.4 PW6=0.5", "PB29 PB15:3=0.25 PG18=0.5 PW6=1.4",
                           "PB28 PG18=0.4 PW6=2.4", "PB36 PW6=4 PV23=0.03",
                           "PW6=5 PO20=0.3 PY35=0.3 PV23=0.02"}),
               {.brush = "Flat bristle 20",
                .size_mm = 4.6,
                .spacing_mm = 4.0,
                .length_mm = 20,
                .inset_mm = 1.0,
                .press = {0.4, 0.1, 0.15},
                .speed_mm_s = 380,
                .fill = 0.85,
                .strokes_per_dip = 4,
                .scatter_deg = 3,
                .scatter_tone = 0.14,
                .seed = 111});
}

/// Short and thick, the broader the nearer.
void paint_glitter(Painter& painter) {
    painter.take("Filbert 14", 3.0);
    for (int i = 0; i < 26; ++i) {
        const auto chance = [i](unsigned which) {
            return core::uniform_noise(static_cast<std::uint32_t>(i), 120 + which);
        };
        if (i % 3 == 0) {
            painter.wipe();
            painter.dip(load(mixture("PW6=4 PY35=1.1 PO20=0.12"), mixture("PW6=5 PO20=0.3"), 0.35, 1.1));
        }
        const double y = kHorizon_y + 1.5 + 29.0 * chance(0) * chance(0) + 0.05 * i;
        const double spread = 2.5 + 0.32 * (y - kHorizon_y), half = 1.4 + 0.09 * (y - kHorizon_y);
        const double x = kSun.x + spread * (2.0 * chance(1) - 1.0);
        paint_along(painter, Curve({{x - half, y}, {x, y + 0.3}, {x + half, y - 0.1}}), 80,
                    {0.42, 0.2, 0.3});
    }
}

/// Light shines through the wave where it is thin, below its crest.
void paint_wave(Painter& painter) {
    const Area wave{
        [](Point at) {
            return std::min({on_canvas_mm(at), at.y - crest_y(at.x) + 1, trough_y(at.x) + 2 - at.y});
        },
        [](Point at) {
            const double down = smooth_step(crest_y(at.x) + 3, trough_y(at.x), at.y);
            return Point{0.55 + 0.45 * down, -1.05 + 0.95 * down};
        },
        [](Point at) {
            const double share = (at.y - crest_y(at.x)) / (trough_y(at.x) - crest_y(at.x));
            return 0.95 - 1.05 * share + 0.16 * bell(at.x, 84, 34) +
                   0.12 * std::sin(at.x / 5 + at.y / 4);
        }};
    paint_area(painter, wave,
               half_mixed({"PB15:3=0.6 PB29 PBr7-BU=0.5 PW6=0.3", "PB15:3=0.4 PG7=0.15 PB29=0.5 PW6=0.8",
                           "PG7=0.25 PB36 PW6=1.4", "PG18=0.8 PB36=0.6 PW6=2.2 PY35=0.25",
                           "PG18=0.5 PW6=3 PY35=0.8"}),
               {.brush = "Flat bristle 20",
                .size_mm = 7,
                .spacing_mm = 4.4,
                .length_mm = 20,
                .inset_mm = 1.2,
                .press = {0.44, 0.08, 0.15},
                .speed_mm_s = 360,
                .fill = 0.95,
                .strokes_per_dip = 2,
                .scatter_deg = 12,
                .scatter_tone = 0.1,
                .seed = 131});
}

void paint_shallows(Painter& painter) {
    const Area shallows{[](Point at) { return std::min(on_canvas_mm(at), at.y - trough_y(at.x)); },
                        [](Point at) {
                            return Point{1.0, 0.14 * std::sin(at.x / 17)};
                        },
                        [](Point at) {
                            const double near = (at.y - trough_y(at.x)) / 26;
                            return 0.12 + 0.5 * near + 0.28 * std::sin(at.x / 14 + at.y / 3);
                        }};
    paint_area(painter, shallows,
               half_mixed({"PB29 PG18=0.5 PBr7-BU=0.4 PW6=1.2", "PB36 PG18=0.4 PBr7-BS=0.2 PW6=2.2",
                           "PB36=0.6 PY43=0.4 PW6=4 PV23=0.03", "PW6=4 PY43=0.8 PBr7-BS=0.25",
                           "PW6=5 PY43=0.5 PO20=0.1"}),
               {.brush = "Flat bristle 20",
                .size_mm = 7,
                .spacing_mm = 5,
                .length_mm = 26,
                .inset_mm = 0.8,
                .press = {0.4, 0.1, 0.15},
                .speed_mm_s = 420,
                .fill = 0.85,
                .strokes_per_dip = 3,
                .scatter_deg = 7,
                .scatter_tone = 0.1,
                .seed = 141});
}

/// A stroke of thick white that falls from the crest.
void tongue(Painter& painter, double x, double length_mm, double lean, double pressure) {
    const double y = crest_y(x) - 1.0;
    paint_along(painter,
                Curve({{x, y}, {x + 0.3 * lean, y + 0.35 * length_mm}, {x + lean, y + length_mm}}), 130,
                {pressure, 0.12, 0.45});
}

/// Where the crest has fallen: dabs upon dabs, cool below and warm white above.
void paint_breaking_foam(Painter& painter) {
    painter.take("Round bristle 12", 6);
    for (int i = 0; i < 60; ++i) {
        const auto chance = [i](unsigned which) {
            return core::uniform_noise(static_cast<std::uint32_t>(i), 155 + which);
        };
        const bool above = i >= 30;
        if (i % 4 == 0) {
            painter.wipe();
            painter.dip(above ? load(mixture("PW6"), mixture("PW6=7 PY35=0.3 PO20=0.05"), 0.4, 1.15)
                              : load(mixture("PW6=5 PB36=0.5 PV23=0.02"), mixture("PW6"), 0.35, 1.0));
        }
        const double x = 92 + 80 * chance(0), fall = smooth_step(88, 128, x);
        const double y = crest_y(x) - 2 + (3 + 15 * fall) * chance(1) - (above ? 2.5 : 0);
        const double turn = 6.28 * chance(2), half = 1.2 + 1.4 * chance(3);
        const Point out{half * std::cos(turn), 0.7 * half * std::sin(turn)}, at{x, y};
        paint_along(painter, Curve({at - out, at + 0.4 * Point{-out.y, out.x}, at + out}), 60,
                    {0.36, 0.25, 0.3});
    }
}

/// Thin where the wave still rises, thick where it breaks.
void paint_crest(Painter& painter) {
    painter.take("Impasto flat 18", 6);
    for (int i = 0; i < 34; ++i) {
        const auto chance = [i](unsigned which) {
            return core::uniform_noise(static_cast<std::uint32_t>(i), 150 + which);
        };
        if (i % 2 == 0) {
            painter.wipe();
            painter.dip(load(mixture("PW6"), mixture("PW6=4 PB36=0.7 PV23=0.02"), 0.35, 1.1));
        }
        const double x = 4 + 3.6 * i + 3 * chance(0), high = bell(x, 98, 34);
        tongue(painter, x, 2.5 + 3 * chance(1) + 11 * high * chance(2), 1.5 + 5 * chance(3) + 3 * high,
               0.3 + 0.16 * high);
    }
    paint_breaking_foam(painter);
}

/// Lace of foam on the water in front, and the edge of the last wave on the sand.
void paint_foam(Painter& painter) {
    painter.take("Filbert 14", 3.6);
    for (int i = 0; i < 20; ++i) {
        const auto chance = [i](unsigned which) {
            return core::uniform_noise(static_cast<std::uint32_t>(i), 160 + which);
        };
        if (i % 2 == 0) {
            painter.wipe();
            painter.dip(load(mixture("PW6"), mixture("PW6=6 PB36=0.4"), 0.3, 1.0));
        }
        const double x = -6 + 178 * chance(0), y = trough_y(x) - 3 + 20 * chance(1),
                     long_mm = 8 + 13 * chance(2), bend = 3.4 * (chance(3) - 0.3);
        paint_along(painter,
                    Curve({{x, y}, {x + 0.4 * long_mm, y + bend}, {x + long_mm, y + 0.4 * bend}}), 130,
                    {0.3, 0.2, 0.4});
    }
    painter.take("Impasto flat 18", 4.5);
    for (int i = 0; i < 11; ++i) {
        const double shift = core::uniform_noise(static_cast<std::uint32_t>(i), 166);
        painter.wipe();
        painter.dip(load(mixture("PW6"), mixture("PW6=7 PY43=0.3"), 0.3, 1.1));
        const double x = -6 + 17.0 * i, y = 112 + 2.6 * std::sin(0.75 * i) + 2 * shift;
        paint_along(painter, Curve({{x, y}, {x + 8, y + 1.8 - shift}, {x + 17, y - 0.5}}), 130,
                    {0.46, 0.12, 0.5});
    }
}

/// Drops that the wind takes from the crest.
void paint_spray(Painter& painter) {
    painter.take("Round sable 9", 2.6);
    for (int i = 0; i < 22; ++i) {
        const auto chance = [i](unsigned which) {
            return core::uniform_noise(static_cast<std::uint32_t>(i), 170 + which);
        };
        if (i % 5 == 0) painter.dip(load(mixture("PW6"), 1.0));
        const double x = 66 + 70 * chance(0), y = crest_y(x) - 2 - 9 * chance(1) * bell(x, 96, 34);
        paint_along(painter, Curve({{x, y}, {x + 0.5, y - 0.3}, {x + 0.9, y - 0.7}}), 30,
                    {0.2 + 0.3 * chance(2), 0.3, 0.3});
    }
}

}  // namespace

document::Recording surf() {
    document::CanvasSettings canvas;
    canvas.width_mm = kWidth_mm;
    canvas.height_mm = kHeight_mm;
    canvas.px_per_mm = 4;
    canvas.support = "cotton duck";
    Painter painter(canvas);
    painter.use_medium("heavy-body oil");
    tone_the_ground(painter);
    paint_sky(painter);
    cloud(painter, {42, 20}, 46);
    cloud(painter, {86, 31}, 26);
    cloud(painter, {158, 15}, 34);
    paint_sun(painter);
    paint_far_sea(painter);
    paint_glitter(painter);
    paint_wave(painter);
    paint_shallows(painter);
    paint_crest(painter);
    paint_foam(painter);
    paint_spray(painter);
    painter.take("Filbert 14", 9);
    painter.dip(load(mixture("PW6=4 PY35=0.5 PO20=0.1")));
    return painter.finish(1.0);
}

}  // namespace pastoso::examples
