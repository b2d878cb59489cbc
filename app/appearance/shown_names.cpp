#include "appearance/shown_names.hpp"

#include <QCoreApplication>

namespace pastoso::appearance {
namespace {

constexpr const char* kNames[] = {
    // resources/brushes; the number is the width in mm
    QT_TR_NOOP("Air blower 40"),
    QT_TR_NOOP("Airbrush 7"),
    QT_TR_NOOP("Blender 28"),
    QT_TR_NOOP("Blotting pad 40"),
    QT_TR_NOOP("Bright 12"),
    QT_TR_NOOP("Calligraphy nib 3"),
    QT_TR_NOOP("Charcoal 8"),
    QT_TR_NOOP("Comb 25"),
    QT_TR_NOOP("Cotton bud 6"),
    QT_TR_NOOP("Detail round 3"),
    QT_TR_NOOP("Diamond knife 9"),
    QT_TR_NOOP("Dropper"),
    QT_TR_NOOP("Dry scumbler 22"),
    QT_TR_NOOP("Eraser 15"),
    QT_TR_NOOP("Fan 26"),
    QT_TR_NOOP("Filbert 14"),
    QT_TR_NOOP("Fine comb 18"),
    QT_TR_NOOP("Fingertip 12"),
    QT_TR_NOOP("Flat bristle 20"),
    QT_TR_NOOP("Impasto flat 18"),
    QT_TR_NOOP("Large filbert 26"),
    QT_TR_NOOP("Large flat 40"),
    QT_TR_NOOP("Lifting knife 14"),
    QT_TR_NOOP("Marbling comb 80"),
    QT_TR_NOOP("Mop 30"),
    QT_TR_NOOP("Oil pastel 10"),
    QT_TR_NOOP("Palette knife 17"),
    QT_TR_NOOP("Pouring bottle"),
    QT_TR_NOOP("Rag 35"),
    QT_TR_NOOP("Rigger 2"),
    QT_TR_NOOP("Roller 50"),
    QT_TR_NOOP("Round bristle 12"),
    QT_TR_NOOP("Round sable 9"),
    QT_TR_NOOP("Ruling pen 1"),
    QT_TR_NOOP("Scraper 30"),
    QT_TR_NOOP("Soft glazing flat 16"),
    QT_TR_NOOP("Spatter 45"),
    QT_TR_NOOP("Sponge 45"),
    QT_TR_NOOP("Spray can 35"),
    QT_TR_NOOP("Spreading knife 40"),
    QT_TR_NOOP("Squeegee 120"),
    QT_TR_NOOP("Stippler 15"),
    QT_TR_NOOP("Straw 8"),
    QT_TR_NOOP("Thinner brush 16"),

    // engine/brush/preset_fields.cpp
    QT_TR_NOOP("Width of the tip."),
    QT_TR_NOOP("Thickness of the tip; a round one is as thick as it is wide."),
    QT_TR_NOOP("Length of the free hairs."),
    QT_TR_NOOP("How much shorter the outermost hairs are; at most the length."),
    QT_TR_NOOP("Elements that the tip is made of."),
    QT_TR_NOOP("Fine streaks within one element."),
    QT_TR_NOOP("Makes one piece differ from the next."),
    QT_TR_NOOP("Width of a comb's tooth, in distances of its teeth."),
    QT_TR_NOOP("Depth of a sponge's pores."),
    QT_TR_NOOP("Way round a roller, after which its mark comes again; 0: it does not roll."),
    QT_TR_NOOP("How far a bent hair trails behind the hand."),
    QT_TR_NOOP("How far the hairs spread at full pressure."),
    QT_TR_NOOP("How long the hairs trail after a turn."),
    QT_TR_NOOP("Way of the ferrule at full pressure, in hair lengths."),
    QT_TR_NOOP("How much a lean lowers one side."),
    QT_TR_NOOP("How steeply hairs follow the weave down: little gives dry brush."),
    QT_TR_NOOP("0: every hair for itself, 1: one stiff edge."),
    QT_TR_NOOP("How far wet paint carries it in a light hand, off the ground."),
    QT_TR_NOOP("Wet film that a full brush leaves."),
    QT_TR_NOOP("Stroke that a full load lasts."),
    QT_TR_NOOP("Ridges between bristles, in films."),
    QT_TR_NOOP("Streaks of single hairs, in films."),
    QT_TR_NOOP("Difference from bristle to bristle."),
    QT_TR_NOOP("How far each dip gathers the hairs anew; 0: never."),
    QT_TR_NOOP("Extra film along the edges, in films."),
    QT_TR_NOOP("Extra film where the stroke starts."),
    QT_TR_NOOP("Share of the load that stays on lifting."),
    QT_TR_NOOP("Depth that hanging paint bridges, in films."),
    QT_TR_NOOP("0: levels the hollows that it reaches, 1: coats the grain alone."),
    QT_TR_NOOP("Share of the paint in the way that is taken up."),
    QT_TR_NOOP("How fast it mixes with the paint below."),
    QT_TR_NOOP("Exchange between neighbouring hairs."),
    QT_TR_NOOP("How far a fast stroke drags paint along and ploughs it aside."),
    QT_TR_NOOP("Fill above which paint is pushed out sideways."),
    QT_TR_NOOP("Step, in radii of an element."),
    QT_TR_NOOP("Least step."),
    QT_TR_NOOP("Time over which the hand is steadied."),
    QT_TR_NOOP("Length of the string that pulls the tip."),
    QT_TR_NOOP("Mean volume of a drop."),
    QT_TR_NOOP("How much drops differ."),
    QT_TR_NOOP("Paint let go while the pen is down."),
    QT_TR_NOOP("A drop let go when the pen comes down."),
    QT_TR_NOOP("What the bottle holds."),
    QT_TR_NOOP("Height over radius of a drop that has landed."),
    QT_TR_NOOP("0: evenly over the width, 1: thickest in the middle."),
    QT_TR_NOOP("Time that drops fly on with the speed of the tip."),
    QT_TR_NOOP("Pressure in the middle of the jet."),

    // resources/pigments
    QT_TR_NOOP("Titanium white"),
    QT_TR_NOOP("Zinc white"),
    QT_TR_NOOP("Cadmium yellow"),
    QT_TR_NOOP("Hansa yellow medium"),
    QT_TR_NOOP("Diarylide (Indian) yellow"),
    QT_TR_NOOP("Yellow ochre"),
    QT_TR_NOOP("Cadmium orange"),
    QT_TR_NOOP("Pyrrole orange"),
    QT_TR_NOOP("Cadmium red light"),
    QT_TR_NOOP("Pyrrole red"),
    QT_TR_NOOP("Red oxide (Venetian red)"),
    QT_TR_NOOP("Alizarin crimson"),
    QT_TR_NOOP("Quinacridone rose"),
    QT_TR_NOOP("Quinacridone magenta"),
    QT_TR_NOOP("Dioxazine violet"),
    QT_TR_NOOP("Ultramarine blue"),
    QT_TR_NOOP("Cobalt blue"),
    QT_TR_NOOP("Cerulean blue"),
    QT_TR_NOOP("Phthalo blue GS"),
    QT_TR_NOOP("Prussian blue"),
    QT_TR_NOOP("Phthalo green BS"),
    QT_TR_NOOP("Phthalo green YS"),
    QT_TR_NOOP("Viridian"),
    QT_TR_NOOP("Chromium oxide green"),
    QT_TR_NOOP("Burnt sienna"),
    QT_TR_NOOP("Raw umber"),
    QT_TR_NOOP("Burnt umber"),
    QT_TR_NOOP("Ivory (bone) black"),
    QT_TR_NOOP("Carbon black"),

    // resources/media.json
    QT_TR_NOOP("Oils"),
    QT_TR_NOOP("Acrylics and others"),
    QT_TR_NOOP("wax paste"),
    QT_TR_NOOP(
        "Oil with cold wax, short and dull: it breaks off sharply at the edge and keeps every cut "
        "of the knife."),
    QT_TR_NOOP("alkyd gel"),
    QT_TR_NOOP("A clear gel with a little paint: transparent, stands as the brush left it, and dries "
               "overnight."),
    QT_TR_NOOP("linseed oil"),
    QT_TR_NOOP(
        "Paint let down with linseed oil, long and buttery: brush marks soften, and thick passages "
        "sag slowly."),
    QT_TR_NOOP("stand oil"),
    QT_TR_NOOP("Paint in thickened oil, smooth as enamel: brush marks flow out, and it runs in slow, "
               "round tears."),
    QT_TR_NOOP("thin oil"),
    QT_TR_NOOP(
        "Oil thinned with turpentine for the first lay-in: streaky, it settles into the weave and "
        "runs when tilted."),
    QT_TR_NOOP("heavy-body oil"),
    QT_TR_NOOP("Stiff, buttery oil straight from the tube: every bristle mark and every peak stays "
               "where you put it."),
    QT_TR_NOOP("soft-body acrylic"),
    QT_TR_NOOP("Creamy paint that keeps soft brush marks, and slumps slowly where you lay it on thick."),
    QT_TR_NOOP("fluid acrylic"),
    QT_TR_NOOP(
        "Pours like cream: brush marks level out, and thick passages sag and run on a tilted canvas."),
    QT_TR_NOOP("house paint"),
    QT_TR_NOOP(
        "Glossy enamel from the tin: it levels at once, drips freely and leaves long rounded tears."),
    QT_TR_NOOP("ink glaze"),
    QT_TR_NOOP("Thin as ink: a transparent film that settles into the weave and runs wherever the "
               "canvas leans."),
    QT_TR_NOOP("thinner"),
    QT_TR_NOOP(
        "Clear thinner: loosens wet paint that it meets, lifts dried ink, and leaves nothing behind."),

    // the layer that a new painting begins with
    QT_TR_NOOP("Paint"),
};

}  // namespace

/// Qt gives back what it has no translation for.
QString shown_name(std::string_view name) {
    return shown_name(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
}

QString shown_name(const QString& name) {
    return QCoreApplication::translate("pastoso::appearance", name.toUtf8().constData());
}

QString shown_title(std::string_view name) {
    QString title = shown_name(name);
    if (!title.isEmpty()) title[0] = title[0].toUpper();
    return title;
}

std::span<const char* const> translated_names() {
    return kNames;
}

}  // namespace pastoso::appearance
