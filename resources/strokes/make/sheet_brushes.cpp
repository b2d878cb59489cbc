// The brushes of the reference sheet.
#include "core/units.hpp"
#include "sheet_parts.hpp"

#include <cmath>
#include <string>

namespace pastoso::examples {
namespace {

constexpr double kPi = core::kPi;

/// A gentle wave through the middle of a field.
Curve field_wave(const Field& field, double height_mm, double from_mm = 7.0, double to_mm = 60.0) {
    std::vector<Point> points;
    for (int i = 0; i <= 12; ++i) {
        const double u = i / 12.0;
        points.push_back(
            field.at(from_mm + (to_mm - from_mm) * u, 22.0 + height_mm * std::sin(2.0 * kPi * u)));
    }
    return Curve(points);
}

void flat_wave(Painter& painter, const Field& field, const char* brush, double size_mm,
               const document::LoadPaint& paint, double pressure) {
    painter.take(brush, size_mm);
    painter.dip(paint);
    paint_along(painter, field_wave(field, -3.0), 70, {pressure, 0.05, 0.08});
}

void flats(Painter& painter) {
    flat_wave(painter, Field(0, 0), "Flat bristle 20", 18,
              load(mixture("PB28 PW6=0.15"), mixture("PB28 PW6=1.3"), 0.4), 0.42);
    flat_wave(painter, Field(1, 0), "Bright 12", 0,
              load(mixture("PR108 PO20=0.5"), mixture("PO20"), 0.3), 0.45);
    flat_wave(painter, Field(2, 0), "Filbert 14", 0,
              load(mixture("PG18 PW6=0.3"), mixture("PG18 PY35=0.5"), 0.35), 0.5);
    flat_wave(painter, Field(3, 0), "Large filbert 26", 22,
              load(mixture("PV23 PW6=3"), mixture("PV19 PW6=1.5"), 0.4), 0.45);
    flat_wave(painter, Field(4, 0), "Fan 26", 0,
              load(mixture("PG17"), mixture("PG17 PY35=0.8"), 0.35, 0.8), 0.36);
    flat_wave(painter, Field(5, 0), "Impasto flat 18", 16,
              load(mixture("PW6 PY35=0.4"), mixture("PW6"), 0.4), 0.4);
}

/// A line that swells to the full width of the tip and closes again.
void swell(Painter& painter, const Field& field, double largest_pressure) {
    const Curve curve = field_wave(field, 5.0);
    painter.stroke(0.9, [&](double u) {
        const Point at = curve.at(u);
        const double share = std::sin(kPi * u);
        return Touch{at.x, at.y, 0.05 + largest_pressure * share * share};
    });
}

void script(Painter& painter, const Field& field) {
    std::vector<Point> points;
    for (int i = 0; i <= 72; ++i) {
        const double u = i / 72.0, angle = 2.0 * kPi * 6.0 * u;
        points.push_back(field.at(8.0 + 48.0 * u + 3.5 * std::sin(angle), 22.0 - 7.0 * std::cos(angle)));
    }
    paint_along(painter, Curve(points), 90, {0.35, 0.05, 0.1});
}

void dabs(Painter& painter, const Field& field, int columns, int rows, double pressure) {
    for (int i = 0; i < columns * rows; ++i) {
        const Point at = field.at(9.0 + 50.0 * (i % columns) / (columns - 1.0),
                                  14.0 + 16.0 * (i / columns) / std::max(1.0, rows - 1.0));
        painter.stroke(0.12, [&](double u) {
            return Touch{at.x, at.y, pressure * std::sin(kPi * u), 37.0 * i};
        });
    }
}

void rounds(Painter& painter) {
    painter.take("Round sable 9");
    painter.dip(load(mixture("PBk9 PB29")));
    swell(painter, Field(0, 1), 0.76);
    painter.take("Round bristle 12");
    painter.dip(load(mixture("PR122"), mixture("PR122 PW6=0.6"), 0.35));
    swell(painter, Field(1, 1), 0.6);
    painter.take("Rigger 2");
    painter.dip(load(mixture("PB27")));
    script(painter, Field(2, 1));
    painter.take("Detail round 3");
    painter.dip(load(mixture("PR101")));
    for (int i = 0; i < 7; ++i) {
        const Field field(3, 1);
        const Curve stalk({field.at(12.0 + 7.0 * i, 34.0), field.at(11.0 + 7.5 * i, 24.0),
                           field.at(8.0 + 8.6 * i, 13.0)});
        paint_along(painter, stalk, 60, {0.5, 0.1, 0.8});
    }
    painter.take("Mop 30", 20);
    painter.dip(load(mixture("PB15:3 PW6=3"), mixture("PW6"), 0.3));
    paint_along(painter, field_wave(Field(4, 1), -2.0, 12, 56), 50, {0.45, 0.08, 0.1});
    painter.take("Stippler 15", 9);
    painter.dip(load(mixture("PY43 PBr7-RU=0.3"), mixture("PY43 PW6"), 0.4, 1.1));
    dabs(painter, Field(5, 1), 6, 2, 0.6);
}

}  // namespace

void paint_sheet_brushes(Painter& painter) {
    flats(painter);
    flat_wave(painter, Field(1, 6), "Large flat 40", 23,
              load(mixture("PY43 PW6=0.3"), mixture("PBr7-RU PW6=0.4"), 0.4), 0.4);
    flat_wave(painter, Field(4, 6), "Soft glazing flat 16", 0, load(mixture("PG7", 0.25)), 0.3);
    rounds(painter);
}

}  // namespace pastoso::examples
