// What brushes do: dry, wet in wet, half mixed, over dry paint.
#include "sheet_parts.hpp"

#include <string>

namespace pastoso::examples {
namespace {

void band(Painter& painter, const Field& field, double y_mm, const char* paint, double width_mm,
          double fill = 0.9) {
    painter.take("Flat bristle 20", width_mm);
    painter.dip(load(mixture(paint), fill));
    paint_along(painter, Curve({field.at(6, y_mm), field.at(62, y_mm)}), 70, {0.42, 0.05, 0.05});
}

void dry_brush(Painter& painter, const Field& field) {
    const double fills[] = {0.06, 0.12, 0.3};
    for (int i = 0; i < 3; ++i) {
        painter.take("Flat bristle 20", 9);
        painter.dip(load(mixture("PR101 PY43"), fills[i]));
        paint_along(painter, Curve({field.at(6, 11.5 + 9.5 * i), field.at(62, 11.0 + 9.5 * i)}), 80,
                    {0.14, 0.05, 0.2});
    }
}

void wet_in_wet(Painter& painter, const Field& field) {
    band(painter, field, 22, "PY35 PW6=0.1", 18);
    const char* crossing[] = {"PB29 PW6=0.3", "PW6", "PR122"};
    for (int i = 0; i < 3; ++i) {
        painter.take("Flat bristle 20", 12);
        painter.dip(load(mixture(crossing[i]), 0.55));
        paint_held(painter, Curve({field.at(14.0 + 18 * i, 9), field.at(15.0 + 18 * i, 35)}), 45,
                   {0.5, 0.06, 0.1}, 3);
    }
}

void loads(Painter& painter, const Field& half_mixed, const Field& doubled) {
    painter.take("Flat bristle 20", 19);
    document::LoadPaint mixed = load(mixture("PR254"), mixture("PW6"), 0.5);
    mixed.share_variation = 1.0;
    painter.dip(mixed);
    paint_along(painter, Curve({half_mixed.at(6, 22), half_mixed.at(34, 20), half_mixed.at(62, 23)}), 70,
                {0.45, 0.05, 0.06});
    painter.take("Flat bristle 20", 19);
    document::LoadPaint two = load(mixture("PB29 PW6=0.5"));
    two.second = mixture("PW6");
    two.second_share = 0.5;
    two.side_by_side = true;
    painter.dip(two);
    paint_along(painter,
                Curve({doubled.at(6, 26), doubled.at(22, 19), doubled.at(44, 26), doubled.at(62, 19)}),
                70, {0.5, 0.05, 0.06}, 180);
}

/// A white brush whose one side was dipped in red: laid over, the red comes off first.
void dipped_tip(Painter& painter, const Field& field) {
    painter.take("Flat bristle 20", 18);
    painter.dip(load(mixture("PW6 PY43=0.05"), 0.5));
    document::LoadPaint tip = load(mixture("PR254 PV19=0.3"), 1.1);
    tip.tip_only = true;
    painter.dip(tip);
    paint_along(painter, Curve({field.at(6, 24), field.at(34, 19), field.at(62, 24)}), 70,
                {0.45, 0.05, 0.06});
}

void symmetry(Painter& painter, const Field& field) {
    const Point middle = field.at(34, 22);
    painter.set_symmetry({.centre_x_mm = middle.x, .centre_y_mm = middle.y, .mirror = true, .count = 7});
    painter.take("Round sable 9", 4);
    painter.dip(load(mixture("PV23 PW6=2"), mixture("PR122 PW6=0.5"), 0.4));
    const Curve petal(
        {middle + Point{1.5, -1.0}, middle + Point{2.5, -8.0}, middle + Point{0.6, -14.0}});
    paint_along(painter, petal, 40, {0.45, 0.2, 0.4});
    painter.set_symmetry({});
}

void blend(Painter& painter, const Field& field) {
    band(painter, field, 15.5, "PB28 PW6=0.4", 12, 0.7);
    band(painter, field, 27.5, "PW6 PO20=0.12", 12, 0.7);
    painter.take("Blender 28", 16);
    for (int i = 0; i < 4; ++i) {
        const double x = 30.0 + 8.0 * (i % 4);
        paint_held(painter, Curve({field.at(x, 12), field.at(x + 1, 31)}), 60, {0.3, 0.1, 0.1}, 0);
    }
}

void scumble(Painter& painter, const Field& field) {
    painter.take("Dry scumbler 22");
    painter.dip(load(mixture("PW6 PY43=0.1"), 0.35));
    paint_along(painter, Curve({field.at(8, 22), field.at(60, 22)}), 70, {0.25, 0.06, 0.15});
}

void glazes(Painter& painter, const Field& field) {
    const char* colours[] = {"PR83", "PG7", "PY74"};
    for (int i = 0; i < 3; ++i) {
        painter.take("Soft glazing flat 16", 6.5);
        painter.dip(load(mixture(colours[i], 0.1)));
        paint_along(painter, Curve({field.at(5, 14.0 + 8 * i), field.at(63, 14.0 + 8 * i)}), 60,
                    {0.22, 0.05, 0.05});
    }
}

}  // namespace

void paint_sheet_grounds(Painter& painter) {
    const Field bars(1, 3), ground(0, 3);
    for (int i = 0; i < 5; ++i) {
        painter.take("Flat bristle 20", 7);
        painter.dip(load(mixture(i % 2 == 0 ? "PW6" : "PBr7-BU PB29=0.6"), 0.5));
        paint_held(painter, Curve({bars.at(12.0 + 11 * i, 9), bars.at(12.0 + 11 * i, 35)}), 50,
                   {0.35, 0.08, 0.08}, 0);
    }
    band(painter, ground, 22, "PB29 PBr7-BU", 22);
}

void paint_sheet_effects(Painter& painter) {
    dry_brush(painter, Field(0, 2));
    wet_in_wet(painter, Field(1, 2));
    loads(painter, Field(2, 2), Field(3, 2));
    blend(painter, Field(4, 2));
    dipped_tip(painter, Field(5, 2));
    symmetry(painter, Field(5, 6));
    scumble(painter, Field(0, 3));
    glazes(painter, Field(1, 3));
}

}  // namespace pastoso::examples
