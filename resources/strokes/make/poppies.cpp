// A meadow with poppies below two cypresses, upright: thin ground, thick petals.
#include "area.hpp"
#include "core/random.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::examples {
namespace {

using Paints = std::vector<document::LoadPaint>;

constexpr double kWidth_mm = 100, kHeight_mm = 132, kField_y = 58;

double chance(int number, unsigned which) {
    return core::uniform_noise(static_cast<std::uint32_t>(number), which);
}

/// Strokes may run over the edges.
double on_canvas_mm(Point at) {
    return 8.0 + std::min({at.x, kWidth_mm - at.x, at.y, kHeight_mm - at.y});
}

/// The hills end here.
double hill_y(double x) {
    return 50 - 5 * std::sin(0.4 + x / 23) - 2 * std::sin(x / 9);
}

Paints half_mixed(const std::vector<const char*>& tones) {
    Paints paints;
    for (std::size_t i = 0; i < tones.size(); ++i)
        paints.push_back(
            load(mixture(tones[i]), mixture(tones[i + 1 < tones.size() ? i + 1 : i - 1]), 0.3));
    return paints;
}

void tone_the_ground(Painter& painter) {
    painter.take("Soft glazing flat 16", 30);
    for (int i = 0; i < 6; ++i) {
        painter.dip(load(mixture("PY43 PBr7-BS=0.7 PW6=0.4", 0.3), 0.6));
        const double y = 10.0 + 23.0 * i;
        paint_along(painter, Curve({{-12, y}, {50, y + 2}, {112, y}}), 450, {0.32, 0.03, 0.03});
    }
    painter.dry_now();
}

/// Rolling air, blue above and pale towards the hills.
void paint_sky(Painter& painter) {
    const Area sky{[](Point at) { return std::min(on_canvas_mm(at), hill_y(at.x) + 1 - at.y); },
                   [](Point at) {
                       return Point{1.0, 0.75 * std::sin(at.x / 15 + at.y / 11)};
                   },
                   [](Point at) {
                       const double cloud = std::sin(at.x / 15 + 1.1) + std::sin(at.y / 6.5 + at.x / 31);
                       return 0.1 + 0.62 * at.y / 50 + 0.16 * cloud;
                   }};
    paint_area(painter, sky,
               half_mixed({"PB29 PB28=0.8 PW6=1.5", "PB28 PW6=2.4", "PB36 PB28=0.2 PW6=3.6",
                           "PB36=0.5 PW6=6 PY43=0.2", "PW6=7 PY43=0.35 PR254=0.03"}),
               {.brush = "Flat bristle 20",
                .size_mm = 7,
                .spacing_mm = 5,
                .length_mm = 20,
                .inset_mm = 1.5,
                .press = {0.42, 0.08, 0.12},
                .speed_mm_s = 380,
                .fill = 0.9,
                .strokes_per_dip = 2,
                .scatter_deg = 14,
                .scatter_tone = 0.08,
                .seed = 201});
}

void paint_hills(Painter& painter) {
    const Area hills{
        [](Point at) {
            return std::min({on_canvas_mm(at), at.y - hill_y(at.x) + 0.6, kField_y + 2 - at.y});
        },
        [](Point at) {
            return Point{1.0, -0.25 * std::cos(0.4 + at.x / 23)};
        },
        [](Point at) { return 0.3 + 0.5 * (at.y - hill_y(at.x)) / 10; }};
    paint_area(painter, hills,
               half_mixed({"PB29 PW6=2 PV23=0.04", "PB28=0.8 PG17=0.3 PW6=2.2 PV23=0.02",
                           "PG17 PB28=0.5 PW6=2", "PG17 PY43=0.6 PW6=2"}),
               {.brush = "Filbert 14",
                .size_mm = 4.2,
                .spacing_mm = 3.0,
                .length_mm = 13,
                .inset_mm = 0.6,
                .press = {0.38, 0.1, 0.15},
                .speed_mm_s = 280,
                .strokes_per_dip = 3,
                .scatter_deg = 8,
                .seed = 211});
}

/// The field rises towards the left; its strokes follow.
void paint_field(Painter& painter) {
    const Area field{[](Point at) { return std::min(on_canvas_mm(at), at.y - kField_y); },
                     [](Point at) {
                         const double near = smooth_step(62, 110, at.y);
                         return Point{1.0 - 0.75 * near, -0.16 - 0.9 * near};
                     },
                     [](Point at) {
                         const double far = 1.0 - smooth_step(60, 118, at.y);
                         const double waves = std::sin(at.y / 4.6 + at.x / 27) * std::sin(at.x / 12);
                         return 0.22 + 0.56 * far + 0.22 * waves;
                     }};
    paint_area(painter, field,
               half_mixed({"PG17 PG7=0.06 PBr7-BU=0.5 PB29=0.3", "PG17 PY43=0.35 PG36=0.06",
                           "PG17 PY35=0.7 PW6=0.3", "PY35 PG17=0.45 PY43=0.4 PW6=0.8",
                           "PY35 PY43=0.6 PW6=1.6"}),
               {.brush = "Flat bristle 20",
                .size_mm = 6,
                .spacing_mm = 4.2,
                .length_mm = 15,
                .inset_mm = 0.8,
                .press = {0.42, 0.1, 0.2},
                .speed_mm_s = 330,
                .fill = 0.9,
                .strokes_per_dip = 3,
                .scatter_deg = 20,
                .scatter_tone = 0.1,
                .seed = 221});
}

/// Flames of dark green: strokes that wind up to a point.
void paint_cypress(Painter& painter, double x, double foot_y, double head_y, double half_width) {
    painter.take("Filbert 14", 4.6);
    const int strokes = 30;
    for (int i = 0; i < strokes; ++i) {
        if (i % 3 == 0) {
            painter.wipe();
            painter.dip(load(mixture("PG7=0.2 PBr7-BU PB29=0.7 PG17=0.6"),
                             mixture("PG17 PY43=0.7 PG36=0.06"), 0.15 + 0.3 * chance(i, 231), 0.95));
        }
        const double from = static_cast<double>(i) / strokes;
        const double y = foot_y + (head_y - foot_y) * 0.86 * from;
        const double room = half_width * std::min(1.0, 1.5 * (1.0 - from));
        const double start = x + room * (2.0 * chance(i, 232) - 1.0);
        const double reach = 0.26 * (foot_y - head_y);
        const double end = x + 0.4 * (start - x);
        const double bow = 1.6 * (chance(i, 233) - 0.5);
        paint_along(painter,
                    Curve({{start, y}, {0.5 * (start + end) + bow, y - 0.5 * reach}, {end, y - reach}}),
                    150, {0.4, 0.15, 0.6});
    }
}

void paint_grass(Painter& painter) {
    painter.take("Rigger 2", 1.8);
    for (int i = 0; i < 62; ++i) {
        if (i % 3 == 0) {
            const bool light = chance(i, 241) > 0.45;
            painter.wipe();
            painter.dip(load(mixture(light ? "PY35 PG17=0.3 PW6=0.9" : "PG17 PG7=0.08 PB29=0.3"),
                             mixture(light ? "PW6=2 PY35" : "PG17 PY43=0.6"), 0.35, 1.1));
        }
        const double x = -2 + 104 * chance(i, 242), y = 92 + 42 * chance(i, 243);
        const double high = 7 + 15 * (y - 88) / 44, lean = 7 * (chance(i, 244) - 0.4);
        paint_along(painter, Curve({{x, y}, {x + 0.25 * lean, y - 0.55 * high}, {x + lean, y - high}}),
                    170, {0.42, 0.1, 0.6});
    }
}

/// Four petals round a dark heart, seen from the side the farther they are.
void poppy(Painter& painter, Point at, double radius, int number) {
    const double flat = 0.62;
    painter.take("Filbert 14", std::max(2.4, 0.8 * radius));
    for (int petal = 0; petal < 4; ++petal) {
        const double angle = 0.6 + 1.571 * petal + 0.7 * chance(number, 251);
        const Point out{std::cos(angle), flat * std::sin(angle)};
        const Point across{-out.y, out.x};
        const bool lit = out.y < 0.1;
        painter.wipe();
        painter.dip(load(mixture(lit ? "PR108 PO20=0.5 PW6=0.15" : "PR254 PR108=0.5"),
                         mixture(lit ? "PO20 PR108=0.4 PW6=0.3" : "PR83 PR254"), 0.3, 1.15));
        paint_along(painter,
                    Curve({at + 0.15 * radius * out - 0.5 * radius * across,
                           at + 0.95 * radius * out - 0.25 * radius * across,
                           at + 0.95 * radius * out + 0.3 * radius * across,
                           at + 0.15 * radius * out + 0.5 * radius * across}),
                    22 + 9 * radius, {0.44, 0.15, 0.2});
        paint_along(painter,
                    Curve({at + 0.25 * radius * out, at + 0.5 * radius * out, at + 0.8 * radius * out}),
                    22 + 9 * radius, {0.4, 0.2, 0.3});
    }
    painter.take("Round sable 9", std::max(1.6, 0.36 * radius));
    painter.dip(load(mixture("PBk9 PV23=0.2 PR83=0.3"), 1.0));
    paint_along(painter,
                Curve({at + Point{-0.16 * radius, 0}, at + Point{0, 0.1 * radius},
                       at + Point{0.18 * radius, -0.02 * radius}}),
                25, {0.4, 0.3, 0.3});
}

/// Far ones are single dabs.
void paint_far_poppies(Painter& painter) {
    painter.take("Round bristle 12", 3.0);
    for (int i = 0; i < 46; ++i) {
        if (i % 3 == 0) {
            painter.wipe();
            painter.dip(load(mixture("PR108 PO20=0.25"), mixture("PR254 PW6=0.1"), 0.35, 1.1));
        }
        const double near = chance(i, 261) * chance(i, 262);
        const double y = kField_y + 4 + 34 * near, x = 100 * chance(i, 263), half = 0.5 + 1.5 * near;
        paint_along(painter, Curve({{x - half, y}, {x, y - 0.5 * half}, {x + half, y}}), 40,
                    {0.26 + 0.26 * near, 0.25, 0.3});
    }
}

void paint_near_poppies(Painter& painter) {
    constexpr struct {
        Point at;
        double radius;
    } kFlowers[] = {{{60, 84}, 3.0},  {{22, 87}, 3.3},  {{84, 91}, 3.8},
                    {{41, 93}, 4.2},  {{8, 98}, 4.4},   {{66, 101}, 5.2},
                    {{28, 107}, 6.2}, {{90, 112}, 6.0}, {{53, 117}, 7.6}};
    int number = 0;
    for (const auto& [at, radius] : kFlowers)
        poppy(painter, at, radius, number++);
}

}  // namespace

document::Recording poppies() {
    document::CanvasSettings canvas;
    canvas.width_mm = kWidth_mm;
    canvas.height_mm = kHeight_mm;
    canvas.px_per_mm = 5;
    canvas.support = "linen";
    Painter painter(canvas);
    painter.use_medium("heavy-body oil");
    tone_the_ground(painter);
    paint_sky(painter);
    paint_hills(painter);
    paint_field(painter);
    paint_cypress(painter, 78, 63, 14, 5.0);
    paint_cypress(painter, 88, 62, 30, 3.6);
    paint_far_poppies(painter);
    paint_grass(painter);
    paint_near_poppies(painter);
    painter.take("Filbert 14", 7);
    painter.dip(load(mixture("PR108 PO20=0.4")));
    return painter.finish(1.0);
}

}  // namespace pastoso::examples
