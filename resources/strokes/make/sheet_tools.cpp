// Knives, combs, rags, drops and air of the reference sheet.
#include "core/units.hpp"
#include "sheet_parts.hpp"

#include <cmath>
#include <string>

namespace pastoso::examples {
namespace {

/// A thick ground of one paint to work in.
void thick(Painter& painter, const Field& field, double y_mm, double width_mm, const char* paint) {
    painter.take("Impasto flat 18", width_mm);
    painter.dip(load(mixture(paint), 1.1));
    paint_along(painter, Curve({field.at(7, y_mm), field.at(61, y_mm)}), 50, {0.4, 0.05, 0.05});
}

/// A ground that a pad takes up.
void thin(Painter& painter, const Field& field, double y_mm, double width_mm, const char* paint) {
    painter.take("Flat bristle 20", width_mm);
    painter.dip(load(mixture(paint), 0.8));
    paint_along(painter, Curve({field.at(7, y_mm), field.at(61, y_mm)}), 60, {0.42, 0.05, 0.05});
}

void two_bands(Painter& painter, const Field& field) {
    thick(painter, field, 15.5, 12, "PR108");
    thick(painter, field, 28, 12, "PW6 PY43=0.12");
}

void knives(Painter& painter) {
    const Field knife(2, 3), spread(3, 3), scrape(4, 3), diamond(5, 3), lift(0, 4);
    const char* slabs[] = {"PG18 PW6=0.5", "PB28 PW6=0.8", "PW6 PY43=0.08", "PY43 PO20=0.3"};
    for (int i = 0; i < 4; ++i) {
        painter.take("Palette knife 17", 13);
        painter.dip(load(mixture(slabs[i]), mixture("PW6"), 0.25, 0.8));
        const Point from = knife.at(9.0 + 12.0 * i, i % 2 == 0 ? 17 : 28);
        paint_held(painter, Curve({from, from + Point{8, 1}, from + Point{17, -1}}), 30,
                   {0.4, 0.06, 0.2}, 86);
    }
    painter.take("Spreading knife 40", 22);
    painter.dip(load(mixture("PO20 PW6=0.4"), mixture("PW6"), 0.4, 0.9));
    paint_held(painter, Curve({spread.at(10, 23), spread.at(58, 22)}), 35, {0.4, 0.06, 0.1}, 84);
    two_bands(painter, scrape);
    painter.take("Scraper 30", 12);
    paint_held(painter, Curve({scrape.at(14, 21), scrape.at(56, 23)}), 40, {0.8, 0.04, 0.04}, 90);
    const char* colours[] = {"PY35 PW6=0.4", "PO20 PW6=0.2", "PR254 PO20=0.5", "PV19 PW6=0.4"};
    painter.take("Diamond knife 9");
    for (int i = 0; i < 8; ++i) {
        painter.wipe();
        painter.dip(load(mixture(colours[i % 4]), mixture("PW6"), 0.3, 0.6));
        const Point from = diamond.at(8.0 + 14.0 * (i % 4), 14.0 + 12.0 * (i / 4));
        paint_held(painter, Curve({from, from + Point{5, 1}, from + Point{10, 3}}), 30,
                   {0.35, 0.06, 0.25}, 80);
    }
    thick(painter, lift, 22, 18, "PW6 PB36=0.3");
    painter.take("Lifting knife 14");
    for (int i = 0; i < 4; ++i)
        paint_held(painter, Curve({lift.at(12.0 + 13 * i, 27), lift.at(17.0 + 13 * i, 18)}), 60,
                   {0.4, 0.1, 0.5}, 25);
}

void combs_and_pads(Painter& painter) {
    const Field comb(1, 4), rag(2, 4), bud(3, 4), blot(4, 4), finger(5, 4);
    thick(painter, comb, 22, 22, "PB15:3 PW6=2");
    painter.take("Comb 25", 18);
    paint_along(painter, Curve({comb.at(9, 22), comb.at(24, 19), comb.at(40, 25), comb.at(60, 21)}), 40,
                {0.6, 0.05, 0.05});
    const Field fine(2, 6);
    thick(painter, fine, 22, 22, "PY35 PW6=0.6");
    painter.take("Fine comb 18", 14);
    paint_along(painter, Curve({fine.at(10, 25), fine.at(24, 18), fine.at(42, 26), fine.at(60, 19)}), 40,
                {0.6, 0.05, 0.05});
    thin(painter, rag, 22, 22, "PR101");
    painter.take("Rag 35", 12);
    paint_along(painter, Curve({rag.at(15, 27), rag.at(26, 18), rag.at(38, 26), rag.at(52, 18)}), 60,
                {0.6, 0.1, 0.1});
    thin(painter, bud, 22, 22, "PG18");
    painter.take("Cotton bud 6", 5);
    paint_along(painter, Curve({bud.at(10, 28), bud.at(18, 16), bud.at(26, 28), bud.at(34, 16)}), 40,
                {0.7, 0.1, 0.1});
    painter.take("Eraser 15", 9);
    paint_along(painter, Curve({bud.at(46, 15), bud.at(52, 29)}), 40, {0.9, 0.1, 0.1});
    thin(painter, blot, 22, 22, "PV19 PW6=0.2");
    painter.take("Blotting pad 40", 11);
    for (int i = 0; i < 3; ++i) {
        const Point at = blot.at(16.0 + 17.0 * i, 20);
        painter.stroke(0.3, [&](double u) {
            return Touch{at.x, at.y + 4.0 * u, std::sin(core::kPi * u)};
        });
    }
    two_bands(painter, finger);
    painter.take("Fingertip 12", 10);
    for (int i = 0; i < 3; ++i)
        paint_along(painter, Curve({finger.at(16.0 + 16 * i, 12), finger.at(20.0 + 16 * i, 32)}), 50,
                    {0.5, 0.1, 0.15});
}

/// A tool that is held still, or drawn slowly, for a while.
void hold(Painter& painter, Point from, Point to, double seconds, double pressure,
          double tilt_x_deg = 0.0) {
    painter.stroke(seconds, [&](double u) {
        const Point at = from + u * (to - from);
        return Touch{at.x, at.y, pressure, 0.0, tilt_x_deg};
    });
}

void drops(Painter& painter) {
    const Field dropper(0, 5), spray(1, 5), airbrush(2, 5), spatter(3, 5), pour(4, 5);
    painter.use_medium("fluid acrylic");
    painter.take("Dropper");
    painter.dip(load(mixture("PR254 PR122=0.5")));
    for (int i = 0; i < 6; ++i)
        hold(painter, dropper.at(10.0 + 9.5 * i, 16.0 + 3.0 * (i % 2)),
             dropper.at(10.0 + 9.5 * i, 16.0 + 3.0 * (i % 2)), 0.05, 1.0);
    painter.wipe();
    painter.dip(load(mixture("PW6")));
    for (int i = 0; i < 5; ++i)
        hold(painter, dropper.at(15.0 + 9.5 * i, 28.0), dropper.at(15.0 + 9.5 * i, 28.0), 0.05, 1.0);
    painter.take("Spray can 35", 18);
    painter.dip(load(mixture("PB28")));
    hold(painter, spray.at(14, 23), spray.at(54, 23), 2.0, 0.8);
    painter.take("Airbrush 7", 5);
    painter.dip(load(mixture("PBk9")));
    painter.stroke(2.5, [&](double u) {
        const Point at = airbrush.at(8.0 + 52.0 * u, 22.0 + 8.0 * std::sin(9.0 * u));
        return Touch{at.x, at.y, 0.3 + 0.7 * u};
    });
    painter.take("Spatter 45", 20);
    painter.dip(load(mixture("PR101"), mixture("PY43"), 0.5));
    hold(painter, spatter.at(0, 26), spatter.at(42, 18), 0.3, 1.0);
    painter.take("Pouring bottle");
    painter.dip(load(mixture("PG7 PW6=0.3")));
    painter.stroke(0.8, [&](double u) {
        const Point at = pour.at(10.0 + 48.0 * u, 21.0 + 7.0 * std::sin(12.0 * u));
        return Touch{at.x, at.y, 0.5};
    });
}

/// Blows wet paint along for `length_mm`, upwards and `angle_deg` to the right of it.
void blow(Painter& painter, Point from, double angle_deg, double length_mm, double seconds) {
    const double angle = core::radians(angle_deg);
    const Point way{std::sin(angle), -std::cos(angle)};
    painter.stroke(seconds, [&](double u) {
        const Point at = from + u * length_mm * way;
        return Touch{at.x, at.y, 0.85 - 0.35 * u * u, 0.0, 50.0 * way.x, 50.0 * way.y};
    });
}

/// A puddle at the foot of the field, blown up into a trunk and that into branches.
void straw(Painter& painter, const Field& field) {
    painter.use_medium("house paint");
    painter.take("Pouring bottle", 4);
    painter.dip(load(mixture("PB29 PB15:3=0.4 PBk9=0.15")));
    hold(painter, field.at(31, 32.5), field.at(37, 32.5), 0.22, 0.8);
    painter.take("Straw 8", 3.6);
    for (const double angle_deg : {-66.0, 66.0, -34.0, 34.0, 3.0})
        blow(painter, field.at(34 + 0.05 * angle_deg, 32), angle_deg, 22, 0.7);
    painter.take("Straw 8", 2.8);
    for (const double side : {-1.0, 1.0}) {
        blow(painter, field.at(34 + 7 * side, 25), -4 * side, 10, 0.35);
        blow(painter, field.at(34 + 11 * side, 29.5), 34 * side, 11, 0.35);
    }
}

/// Three stripes of poured paint, blown into each other.
void air_blower(Painter& painter, const Field& field) {
    painter.use_medium("fluid acrylic");
    const char* colours[] = {"PB15:3 PW6=0.3", "PW6", "PR122 PW6=0.1"};
    for (int i = 0; i < 3; ++i) {
        painter.take("Pouring bottle", 5);
        painter.dip(load(mixture(colours[i])));
        hold(painter, field.at(13, 14.5 + 6.0 * i), field.at(41, 14.5 + 6.0 * i), 0.6, 0.8);
    }
    painter.take("Air blower 40", 16);
    for (int i = 0; i < 2; ++i)
        hold(painter, field.at(20.0 + 14.0 * i, 14.0), field.at(34.0 + 14.0 * i, 27.0), 0.6, 0.8, 35.0);
    painter.use_medium("heavy-body oil");
}

void thinner_brush(Painter& painter, const Field& field) {
    thick(painter, field, 22, 18, "PBr7-BS PO20=0.3");
    painter.use_medium("thinner");
    painter.take("Thinner brush 16", 10);
    painter.dip(load(mixture("")));
    paint_along(painter, Curve({field.at(14, 26), field.at(34, 17), field.at(56, 27)}), 120,
                {0.45, 0.06, 0.06});
    painter.use_medium("heavy-body oil");
}

}  // namespace

void paint_sheet_tools(Painter& painter) {
    knives(painter);
    combs_and_pads(painter);
}

void paint_sheet_fluids(Painter& painter) {
    thinner_brush(painter, Field(0, 6));
    painter.dry_now();
    straw(painter, Field(5, 5));
    painter.dry_now();
    air_blower(painter, Field(3, 6));
    painter.dry_now();
    paint_sheet_marbling(painter);
    painter.dry_now();
    drops(painter);
    painter.wait(0.3);
    painter.use_medium("heavy-body oil");
}

}  // namespace pastoso::examples
