#include "main/program/findable_controls.hpp"

#include "commands/command_words.hpp"
#include "core/check.hpp"
#include "panels/paint/paint_panel.hpp"
#include "panels/paint/tube_menu.hpp"
#include "panels/parts/fold.hpp"
#include "panels/pen/brush_panel.hpp"

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QScrollArea>
#include <QTimer>

namespace pastoso::main {
namespace {

using commands::Command;

struct Control {
    Command panel;     ///< that shows it
    const char* name;  ///< of the widget
    const char* words;
    const char* hint;
    const char* synonyms;
    bool pressed = false;
};

constexpr Control kControls[] = {
    {Command::ColourPanel, "harmony", QT_TRANSLATE_NOOP("FindableControls", "Harmony"),
     QT_TRANSLATE_NOOP("FindableControls", "Marks for hues that go together, on the colour wheel"),
     QT_TRANSLATE_NOOP("FindableControls",
                       "complementary, analogous, triad, tetrad, colour scheme, color scheme")},
    {Command::ColourPanel, "mask_shape", QT_TRANSLATE_NOOP("FindableControls", "Gamut mask"),
     QT_TRANSLATE_NOOP("FindableControls", "A shape on the colour wheel to choose within"),
     QT_TRANSLATE_NOOP("FindableControls", "limited palette, color mask")},
    {Command::ColourPanel, "keep_paint", QT_TRANSLATE_NOOP("FindableControls", "Keep on your palette"),
     QT_TRANSLATE_NOOP("FindableControls", "Lay the paint in hand out on your palette"),
     QT_TRANSLATE_NOOP("FindableControls", "swatch, add colour, add color"), true},
    {Command::ColourPanel, "save_palette", QT_TRANSLATE_NOOP("FindableControls", "Save the palette"),
     QT_TRANSLATE_NOOP("FindableControls",
                       "The colours of your palette for GIMP, Krita or Inkscape, as a .gpl file"),
     QT_TRANSLATE_NOOP("FindableControls", "gpl, swatches, export palette"), true},
    {Command::ColourPanel, "open_palette", QT_TRANSLATE_NOOP("FindableControls", "Open a palette"),
     QT_TRANSLATE_NOOP("FindableControls", "Colours of GIMP, Krita or Inkscape, from a .gpl file"),
     QT_TRANSLATE_NOOP("FindableControls", "gpl, swatches, import palette"), true},
    {Command::ColourPanel, "palette_of_picture",
     QT_TRANSLATE_NOOP("FindableControls", "Palette from a picture"),
     QT_TRANSLATE_NOOP("FindableControls", "Finds the colours that a picture is made of"),
     QT_TRANSLATE_NOOP("FindableControls", "extract, palette from image"), true},
    {Command::ColourPanel, "keep_mix", QT_TRANSLATE_NOOP("FindableControls", "Keep as a mix"),
     QT_TRANSLATE_NOOP("FindableControls",
                       "Keep the paint in hand as a recipe of tubes, under a name of your own"),
     QT_TRANSLATE_NOOP("FindableControls", "recipe, save colour, save color"), true},
    {Command::PaintsPanel, "tube_sets", QT_TRANSLATE_NOOP("FindableControls", "Sets of tubes"),
     QT_TRANSLATE_NOOP("FindableControls", "Which tubes are shown: all of them, or a set of yours"),
     QT_TRANSLATE_NOOP("FindableControls", "tube sets, palette of tubes")},
    {Command::BrushesPanel, "brush_folder", QT_TRANSLATE_NOOP("FindableControls", "Tags of tools"),
     QT_TRANSLATE_NOOP("FindableControls", "Which tools are listed: a family, favourites or a tag"),
     QT_TRANSLATE_NOOP("FindableControls", "tagged, collections, brush sets")},
    {Command::GuidesPanel, "guide_strength", QT_TRANSLATE_NOOP("FindableControls", "Snapping strength"),
     QT_TRANSLATE_NOOP("FindableControls", "How far the guide draws the brush from where your hand is"),
     QT_TRANSLATE_NOOP("FindableControls", "magnetic, assistant strength")},
};

QString translated(const char* words) {
    return QCoreApplication::translate("FindableControls", words);
}

QString panel_name(Command panel) {
    return commands::plain_words(commands::text_of(panel).words);
}

void unfold_around(const QWidget& control) {
    for (QWidget* around = control.parentWidget(); around != nullptr; around = around->parentWidget())
        if (auto* fold = qobject_cast<panels::Fold*>(around)) fold->open(true);
}

/// Up and down alone.
void scroll_to(QWidget& control) {
    constexpr int kAround_px = 50;
    for (QWidget* around = control.parentWidget(); around != nullptr; around = around->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(around))
            area->ensureWidgetVisible(&control, 0, kAround_px);
}

dialogs::Offer offer_of(const Control& control, const QDockWidget& dock, QAction* show_panel) {
    auto* widget = dock.findChild<QWidget*>(QLatin1String(control.name));
    PASTOSO_CHECK(widget != nullptr);
    auto* button = control.pressed ? qobject_cast<QAbstractButton*>(widget) : nullptr;
    const auto take = [show_panel, widget, button] {
        show_panel->trigger();
        unfold_around(*widget);
        // Later: what was unfolded has its place then, and the list of commands is closed.
        QTimer::singleShot(0, widget, [widget, button] {
            scroll_to(*widget);
            widget->setFocus(Qt::TabFocusReason);
            if (button != nullptr) button->click();
        });
    };
    return {translated(control.words),    panel_name(control.panel),
            translated(control.hint),     take,
            translated(control.synonyms), show_panel->isEnabled() && widget->isEnabled()};
}

dialogs::Offer last_palette(panels::PaintPanel& panel) {
    return {
        translated(QT_TRANSLATE_NOOP("FindableControls", "Squeeze out the last painting's palette")),
        panel_name(Command::PaintsPanel),
        translated(QT_TRANSLATE_NOOP(
            "FindableControls", "The paints and mixtures of the earlier well, onto the mixing well")),
        [&panel] { Q_EMIT panel.sets().last_palette_wanted(); },
        translated(QT_TRANSLATE_NOOP("FindableControls", "restore palette, palette of before"))};
}

dialogs::Offer new_tag(panels::BrushPanel& panel) {
    return {translated(QT_TRANSLATE_NOOP("FindableControls", "New tag for the tool in hand")),
            panel_name(Command::BrushesPanel),
            translated(QT_TRANSLATE_NOOP("FindableControls",
                                         "A word of your own under which the tool is listed")),
            // Later: it asks for a name, and the list of commands is still closing.
            [&panel] { QTimer::singleShot(0, &panel, &panels::BrushPanel::want_tag); },
            translated(QT_TRANSLATE_NOOP("FindableControls", "add tag, label"))};
}

}  // namespace

void add_controls(std::vector<dialogs::Offer>& offers, const commands::CommandRegistry& commands,
                  const PanelSet& panels) {
    for (const Control& control : kControls)
        offers.push_back(
            offer_of(control, *panels.docks.at(control.panel), commands.action(control.panel)));
    offers.push_back(last_palette(*panels.paints));
    offers.push_back(new_tag(*panels.brushes));
}

}  // namespace pastoso::main
