#include "still_life_parts.hpp"

namespace pastoso::examples {
namespace {

void contact_shadow(Painter& painter, const Curve& curve) {
    painter.take("Round sable 9", 4);
    painter.dip(load(mixture(kContactShadow), 0.8));
    paint_along(painter, curve, 120, {0.4, 0.3, 0.4});
}

void highlight(Painter& painter, const std::string& paint, Point from, Point to, double pressure) {
    painter.wipe();
    painter.dip(load(mixture(paint), 1.2));
    paint_along(painter, Curve({from, 0.5 * (from + to), to}), 45, {pressure, 0.2, 0.3});
}

}  // namespace

void paint_contact_shadows(Painter& painter) {
    contact_shadow(painter, Curve({{30, 105.2}, {44, 107.0}, {57, 103}}));
    contact_shadow(painter, Curve({{82, 101.8}, {99, 103.2}, {117, 101.8}}));
    contact_shadow(painter, Curve({{135, 107}, {143.5, 109}, {152, 106}}));
}

/// The blade is laid on with the palette knife.
void paint_kitchen_knife(Painter& painter) {
    contact_shadow(painter, Curve({{61, 113.5}, {78, 117}, {96, 119}}));
    painter.take("Palette knife 17", 5);
    painter.dip(load(mixture("PW6=3 PB29=0.3 PBr7-BU=0.35"), mixture("PW6=5 PB36=0.5"), 0.45, 0.5));
    paint_along(painter, Curve({{62, 110.5}, {74, 113}, {86, 115}}), 70, {0.3, 0.35, 0.06});
    painter.take("Round sable 9", 5);
    painter.dip(load(mixture("PBr7-BU PR83=0.4 PB29=0.3"), mixture("PBr7-BS PY43=0.3"), 0.3));
    paint_along(painter, Curve({{86.5, 115.2}, {95, 116.2}, {105, 116.8}}), 90, {0.5, 0.06, 0.06});
    painter.take("Round sable 9", 2.5);
    painter.dip(load(mixture("PW6")));
    paint_along(painter, Curve({{65, 109.8}, {74, 111.9}, {83, 113.4}}), 90, {0.3, 0.3, 0.3});
    painter.wipe();
    painter.dip(load(mixture("PBr7-BS PY43=0.6 PW6=0.8"), 0.7));
    paint_along(painter, Curve({{89, 114.4}, {95, 115.1}, {103, 115.5}}), 90, {0.22, 0.3, 0.4});
}

void paint_highlights(Painter& painter) {
    painter.take("Round sable 9", 4.5);
    highlight(painter, "PW6=4 PY74=0.5", {73.5, 54}, {72.3, 60}, 0.5);
    highlight(painter, "PW6=4 PY74=0.4", {76.3, 36.5}, {75.2, 40.5}, 0.34);
    highlight(painter, "PW6=4 PY35=0.5", {108, 55.5}, {106.8, 61}, 0.5);
    highlight(painter, "PW6=4 PY35=0.4", {119, 39.5}, {118, 43}, 0.32);
    highlight(painter, "PW6=4 PY74=0.3", {34, 89.6}, {41, 87.4}, 0.48);
    highlight(painter, "PW6=4 PR108=0.12", {136.6, 88.5}, {134.8, 93}, 0.5);
    highlight(painter, "PW6", {70.5, 78.5}, {74.5, 86}, 0.5);
    highlight(painter, "PW6", {64, 69.5}, {70, 71.8}, 0.42);
}

}  // namespace pastoso::examples
