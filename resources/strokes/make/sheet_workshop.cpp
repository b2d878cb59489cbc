// Pens, sticks, sponges, rollers and combs for marbling of the reference sheet.
#include "core/units.hpp"
#include "sheet_parts.hpp"

#include <cmath>

namespace pastoso::examples {
namespace {

/// Loops of a broad nib that is held at 45 degrees: thick down the one diagonal, thin along the other.
void nib(Painter& painter, const Field& field) {
    painter.take("Calligraphy nib 3", 3.4);
    painter.dip(load(mixture("PR101 PV19=0.4")));
    constexpr int kPoints = 80;
    std::vector<Point> loops;
    for (int i = 0; i <= kPoints; ++i) {
        const double angle = 2.0 * core::kPi * 3.5 * i / kPoints;
        loops.push_back(
            field.at(10.0 + 20.0 * i / kPoints - 3.6 * std::cos(angle), 21.5 - 7.5 * std::sin(angle)));
    }
    paint_held(painter, Curve(loops), 50, {0.6, 0.02, 0.02}, 45);
}

/// Lines that grow thicker.
void ruling_pen(Painter& painter, const Field& field) {
    painter.take("Ruling pen 1");
    painter.dip(load(mixture("PBk9 PB29=0.4")));
    for (int i = 0; i < 6; ++i) {
        const double y = 12.5 + 3.7 * i;
        paint_along(painter, Curve({field.at(40, y), field.at(62, y)}), 50,
                    {0.1 + 0.14 * i, 0.02, 0.02});
    }
}

/// Lightly over the ridges of the weave, and once with all the weight.
void charcoal(Painter& painter, const Field& field) {
    painter.take("Charcoal 8");
    painter.dip(load(mixture("PBk9")));
    for (int i = 0; i < 3; ++i)
        paint_along(painter, Curve({field.at(7, 13.5 + 5.5 * i), field.at(31, 12.0 + 5.5 * i)}), 70,
                    {0.12 + 0.1 * i, 0.05, 0.05});
    painter.take("Charcoal 8", 3);
    painter.dip(load(mixture("PBk9")));
    paint_along(painter, Curve({field.at(8, 33), field.at(16, 28), field.at(24, 32), field.at(31, 26)}),
                70, {0.9, 0.1, 0.3});
}

void oil_pastel(Painter& painter, const Field& field) {
    const char* colours[] = {"PY35 PW6=0.3", "PO20", "PR254 PO20=0.2", "PV23 PW6=1.5"};
    for (int i = 0; i < 4; ++i) {
        painter.take("Oil pastel 10", 5.5);
        painter.dip(load(mixture(colours[i])));
        paint_along(painter, Curve({field.at(38, 13.0 + 5.8 * i), field.at(62, 12.0 + 5.8 * i)}), 70,
                    {0.35 + 0.1 * i, 0.05, 0.05});
    }
}

void sponge(Painter& painter, const Field& field) {
    const char* colours[] = {"PG18 PY35=0.8", "PG17 PB29=0.1", "PY35 PG18=0.3 PW6=0.4"};
    for (int i = 0; i < 3; ++i) {
        painter.take("Sponge 45", 17);
        painter.dip(load(mixture(colours[i]), 0.5));
        for (int j = 0; j < 3; ++j) {
            const Point at = field.at(12.0 + 7.0 * i + 14.0 * j, 18.0 + 7.0 * ((i + j) % 2));
            painter.stroke(0.2, [&](double u) {
                return Touch{at.x, at.y, 0.55 * std::sin(core::kPi * u), 50.0 * (i + 3 * j)};
            });
        }
    }
}

void roller(Painter& painter, const Field& field) {
    painter.take("Roller 50", 20);
    painter.dip(load(mixture("PB15:3 PW6=1.2"), mixture("PG7 PW6=1.5"), 0.4));
    paint_along(painter, Curve({field.at(7, 22), field.at(61, 22)}), 60, {0.5, 0.02, 0.02});
}

/// Drawn across stripes, of which it takes some along.
void squeegee(Painter& painter, const Field& field) {
    const char* stripes[] = {"PY35", "PR254 PO20=0.4", "PW6", "PB29 PW6=0.2"};
    for (int i = 0; i < 4; ++i) {
        painter.take("Impasto flat 18", 7);
        painter.dip(load(mixture(stripes[i]), 0.9));
        paint_along(painter, Curve({field.at(10.0 + 8.0 * i, 10), field.at(10.0 + 8.0 * i, 34)}), 50,
                    {0.4, 0.05, 0.05});
    }
    painter.take("Squeegee 120", 20);
    paint_held(painter, Curve({field.at(8, 22), field.at(62, 22)}), 40, {0.35, 0.04, 0.04}, 90);
}

}  // namespace

void paint_sheet_workshop(Painter& painter) {
    nib(painter, Field(0, 7));
    ruling_pen(painter, Field(0, 7));
    charcoal(painter, Field(1, 7));
    oil_pastel(painter, Field(1, 7));
    sponge(painter, Field(2, 7));
    roller(painter, Field(3, 7));
    squeegee(painter, Field(4, 7));
}

void paint_sheet_marbling(Painter& painter) {
    const Field field(5, 7);
    painter.use_medium("fluid acrylic");
    const char* stripes[] = {"PB29", "PW6", "PR122", "PW6", "PB15:3 PW6=0.4", "PW6"};
    for (int i = 0; i < 6; ++i) {
        painter.take("Pouring bottle", 4);
        painter.dip(load(mixture(stripes[i])));
        const double y = 12.0 + 4.0 * i;
        painter.stroke(0.5, [&](double u) {
            const Point at = field.at(10.0 + 48.0 * u, y);
            return Touch{at.x, at.y, 0.6};
        });
    }
    painter.take("Marbling comb 80", 44);
    for (const bool down : {true, false}) {
        const Point from = field.at(down ? 34 : 36.5, down ? 9 : 35),
                    to = field.at(down ? 34 : 36.5, down ? 35 : 9);
        paint_held(painter, Curve({from, to}), 40, {0.8, 0.02, 0.02}, 0);
    }
    painter.use_medium("heavy-body oil");
}

}  // namespace pastoso::examples
