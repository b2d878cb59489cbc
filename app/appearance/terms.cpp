#include "appearance/terms.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <iterator>

#include <QCoreApplication>
#include <QWidget>

namespace pastoso::appearance {
namespace {

struct Explained {
    Term term;
    const char* sentence;
};

constexpr Explained kTerms[] = {
    {Term::Resolution,
     QT_TR_NOOP(
         "How many squares of the paint's grid lie side by side in a millimetre, and pixels in the "
         "saved picture: more show finer hairs, and need more memory and time")},
    {Term::Support,
     QT_TR_NOOP("What paint lies on, bare: linen, jute, cotton duck, a panel or a height image")},
    {Term::Tilt, QT_TR_NOOP("How steeply the canvas stands, and where down is: wet paint runs there")},
    {Term::Lamp,
     QT_TR_NOOP("Where the lamp stands that lights the painting: a low one shows the relief, the "
                "heights of paint and canvas")},
    {Term::Drying, QT_TR_NOOP("How many times as fast as by the clock wet paint becomes dry paint")},
    {Term::Load,
     QT_TR_NOOP("What the brush holds from side to side of its tip, and how full it is of what it "
                "can hold")},
    {Term::Medium,
     QT_TR_NOOP("What pigment is mixed with: it decides how stiff the paint is, how far it "
                "levels and how soon it dries")},
    {Term::Steadying, QT_TR_NOOP("How a trembling hand is steadied, besides the brush's own smoothing")},
    {Term::Harmony, QT_TR_NOOP("Hues that go together by their places on the wheel")},
    {Term::GamutMask, QT_TR_NOOP("A shape on the disc of hues that choosing on the wheel keeps to")},
    {Term::Seen,
     QT_TR_NOOP("The light that the painting is seen in: the same paint has other colours in "
                "another one")},
    {Term::Varnish,
     QT_TR_NOOP("A clear coat over the whole painting that is looked through, and changes no "
                "paint")},
    {Term::ColourDifference,
     QT_TR_NOOP(
         "ΔE is how far two colours differ to the eye: 1 is seen side by side, 2 to 3 at a second "
         "look")},
    {Term::StandardLights,
     QT_TR_NOOP("D65, D50 and A are the lights that colours are measured in everywhere: daylight, the "
                "light of print booths, and a light bulb")},
    {Term::SoftProof,
     QT_TR_NOOP("A soft proof shows on the screen how the painting would be printed; the gamut warning "
                "shows what this printer cannot print")},
};

}  // namespace

QString explanation(Term term) {
    const auto found = std::ranges::find(kTerms, term, &Explained::term);
    PASTOSO_CHECK(found != std::end(kTerms));
    return QCoreApplication::translate("pastoso::appearance", found->sentence);
}

void explain(QWidget* widget, Term term) {
    widget->setToolTip(explanation(term));
}

}  // namespace pastoso::appearance
