#include "panels/paint/medium_rows.hpp"

#include <QObject>

namespace pastoso::panels {
namespace {

using film::Medium;

constexpr MediumRow kFlowRows[] = {
    MediumRow{"viscosity", QT_TR_NOOP("Viscosity"),
              QT_TR_NOOP("How slowly it flows: water 1, ink 100, cream 3000, oil from the tube 300000"),
              QT_TR_NOOP(" mm\u00b2/s"), &Medium::viscosity_m2_s, 1e6, 0, true},
    MediumRow{"yield_stress", QT_TR_NOOP("Yield stress"),
              QT_TR_NOOP("What it stands up to before it moves at all: at 0 it runs for ever, at 80 it "
                         "keeps every bristle mark, at 200 it stands in peaks"),
              QT_TR_NOOP(" Pa"), &Medium::yield_stress_Pa, 1.0, 1},
    MediumRow{"flow_index", QT_TR_NOOP("Flow index"),
              QT_TR_NOOP("Below 1 it thins where it is sheared: a brush or a fast run finds it thinner"),
              "", &Medium::flow_index, 1.0, 2},
    MediumRow{"structure_share", QT_TR_NOOP("Loosens by"),
              QT_TR_NOOP("Thixotropy: how much of its stiffness is gone where a tool or a run works it; "
                         "brush marks level a little, and then stand"),
              QT_TR_NOOP(" %"), &Medium::structure_share, 100.0, 0},
    MediumRow{"recovery", QT_TR_NOOP("Stiffens in"),
              QT_TR_NOOP("How long it rests until two thirds of what it lost have come back"),
              QT_TR_NOOP(" s"), &Medium::recovery_s, 1.0, 1, true},
    MediumRow{"breakdown_strain", QT_TR_NOOP("Loosens after"),
              QT_TR_NOOP("How far it has to run before it is loosened, in times its own thickness"), "",
              &Medium::breakdown_strain, 1.0, 1, true},
    MediumRow{"density", QT_TR_NOOP("Density"),
              QT_TR_NOOP("Heavy paint runs faster down a tilted canvas"), QT_TR_NOOP(" kg/m\u00b3"),
              &Medium::density_kg_m3, 1.0, 0}};

constexpr MediumRow kSurfaceRows[] = {
    MediumRow{"surface_tension", QT_TR_NOOP("Surface tension"),
              QT_TR_NOOP("Rounds drips and edges, and draws thin lines into drops"), QT_TR_NOOP(" mN/m"),
              &Medium::surface_tension_N_m, 1e3, 0},
    MediumRow{"advancing_angle", QT_TR_NOOP("Spreads at"),
              QT_TR_NOOP("The edge moves out where it is steeper than this: low numbers wet the canvas "
                         "easily, high ones stand in beads"),
              QT_TR_NOOP("\u00b0"), &Medium::advancing_angle_deg, 1.0, 0},
    MediumRow{"receding_angle", QT_TR_NOOP("Draws back at"),
              QT_TR_NOOP("The edge draws back where it is flatter than this; 0: it stays where it was"),
              QT_TR_NOOP("\u00b0"), &Medium::receding_angle_deg, 1.0, 0},
    MediumRow{"slip", QT_TR_NOOP("Slip"),
              QT_TR_NOOP(
                  "How easily it slides over the canvas, in pixels of the painting: more lets edges run "
                  "on"),
              QT_TR_NOOP(" px"), &Medium::slip_cells, 1.0, 2},
    MediumRow{"alpha_min", QT_TR_NOOP("Front of drips"),
              QT_TR_NOOP("How fast a drip goes at its front, where surface tension holds it back: less "
                         "makes it thicker and rounder there"),
              "", &Medium::alpha_min, 1.0, 2},
    MediumRow{
        "alpha_max", QT_TR_NOOP("Tail of drips"),
        QT_TR_NOOP("How fast a drip follows at its tail, where surface tension draws it along: more "
                   "makes it thinner there"),
        "", &Medium::alpha_max, 1.0, 2}};

constexpr MediumRow kDryingRows[] = {
    MediumRow{"touch_dry", QT_TR_NOOP("Dry after"),
              QT_TR_NOOP("Until a film of the usual thickness can be touched, in still air"),
              QT_TR_NOOP(" min"), &Medium::touch_dry_s, 1.0 / 60.0, 1, true},
    MediumRow{"typical_thickness", QT_TR_NOOP("Usual thickness"),
              QT_TR_NOOP("The film that dries in that time; thicker ones take longer"),
              QT_TR_NOOP(" mm"), &Medium::typical_thickness_mm, 1.0, 2, true},
    MediumRow{"solids", QT_TR_NOOP("Stays when dry"),
              QT_TR_NOOP("How much of the wet thickness is left: oil keeps all, watery paint sinks in"),
              QT_TR_NOOP(" %"), &Medium::solid_fraction, 100.0, 0}};

constexpr MediumRow kColourRows[] = {MediumRow{
    "pigment_share", QT_TR_NOOP("Pigment"),
    QT_TR_NOOP("How much of full-strength paint is in it: paint from the tube 100, a glaze 3 to 6"),
    QT_TR_NOOP(" %"), &Medium::pigment_share, 100.0, 2, true}};

constexpr MediumSection kSections[] = {
    MediumSection{QT_TR_NOOP("Flow"), kFlowRows}, MediumSection{QT_TR_NOOP("Surface"), kSurfaceRows},
    MediumSection{QT_TR_NOOP("Drying"), kDryingRows}, MediumSection{QT_TR_NOOP("Colour"), kColourRows}};

}  // namespace

std::span<const MediumSection> medium_sections() {
    return kSections;
}

}  // namespace pastoso::panels
