// What the words of the trade mean that stand in the window: one sentence each, as docs/glossary.md has
// it.
#pragma once

class QString;
class QWidget;

namespace pastoso::appearance {

enum class Term {
    Resolution,
    Support,
    Tilt,
    Lamp,
    Drying,
    Load,
    Medium,
    Steadying,
    Harmony,
    GamutMask,
    Seen,
    Varnish,
    ColourDifference,
    StandardLights,
    SoftProof
};

/// In the painter's language.
QString explanation(Term term);

/// Shows it where the pointer rests on a widget, or on what stands in it without a hint of its own.
void explain(QWidget* widget, Term term);

}  // namespace pastoso::appearance
