#include "panels/pen/preset_choices.hpp"

#include <QtGlobal>

namespace pastoso::panels {
namespace {

using brush::Preset;

/// In the order of brush::TipShape.
constexpr const char* kShapes[] = {QT_TR_NOOP("round"),    QT_TR_NOOP("flat"),  QT_TR_NOOP("filbert"),
                                   QT_TR_NOOP("fan"),      QT_TR_NOOP("knife"), QT_TR_NOOP("comb"),
                                   QT_TR_NOOP("soft pad"), QT_TR_NOOP("nib")};
constexpr const char* kDips[] = {QT_TR_NOOP("used as it is"), QT_TR_NOOP("dipped in paint")};
constexpr const char* kAbsorbs[] = {QT_TR_NOOP("stays on the tool"), QT_TR_NOOP("is thrown away")};
/// In the order of brush::JitterSeed.
constexpr const char* kJitter[] = {QT_TR_NOOP("another in each stroke"), QT_TR_NOOP("always the same")};

constexpr PresetChoice kChoices[] = {
    {"tip", "tip_shape", QT_TR_NOOP("Shape"), QT_TR_NOOP("How the elements of the tip are arranged."),
     kShapes, true, [](const Preset& preset) { return static_cast<int>(preset.tip.shape); },
     [](Preset& preset, int place) { preset.tip.shape = static_cast<brush::TipShape>(place); }},
    {"paint", "paint_dips", QT_TR_NOOP("Before use"),
     QT_TR_NOOP("A brush is dipped; a rag or a comb is used as it is."), kDips, true,
     [](const Preset& preset) { return preset.dips ? 1 : 0; },
     [](Preset& preset, int place) { preset.dips = place == 1; }},
    {"exchange", "exchange_absorbs", QT_TR_NOOP("What it takes"),
     QT_TR_NOOP("A rag throws away what it takes up; it never comes back."), kAbsorbs, true,
     [](const Preset& preset) { return preset.exchange.absorbs ? 1 : 0; },
     [](Preset& preset, int place) { preset.exchange.absorbs = place == 1; }},
    {"stroke", "stroke_jitter_seed", QT_TR_NOOP("Chance"),
     QT_TR_NOOP("Small random differences, such as where drops fall."), kJitter, false,
     [](const Preset& preset) { return static_cast<int>(preset.stroke.jitter_seed); },
     [](Preset& preset, int place) {
         preset.stroke.jitter_seed = static_cast<brush::JitterSeed>(place);
     }}};

}  // namespace

std::span<const PresetChoice> preset_choices() {
    return kChoices;
}

}  // namespace pastoso::panels
