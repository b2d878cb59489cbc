#include "main/program/findable.hpp"

#include "main/program/findable_controls.hpp"
#include "panels/colour/colour_panel.hpp"
#include "panels/paint/medium_box.hpp"
#include "panels/paint/paint_panel.hpp"
#include "panels/pen/brush_panel.hpp"

#include <QCoreApplication>

namespace pastoso::main {
namespace {

/// Makes tr() find these words.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(Findable)
};

void add_tools(std::vector<dialogs::Offer>& offers, panels::BrushPanel& panel) {
    for (const panels::BrushEntry& entry : panel.brushes())
        if (entry.fault.isEmpty())
            offers.push_back({panels::shown_name(entry), entry.family, Words::tr("Take this tool in hand"),
                              [&panel, entry] { panel.take(entry); }});
}

void add_paints(std::vector<dialogs::Offer>& offers, panels::PaintPanel& panel) {
    for (const panels::PaintEntry& entry : panel.paints())
        offers.push_back({entry.name, Words::tr("Paint"), Words::tr("Choose this paint"),
                          [&panel, entry] { panel.choose(entry.pigment); }});
}

void add_mixes(std::vector<dialogs::Offer>& offers, panels::ColourPanel& panel) {
    for (const tools::NamedPaint& mix : panel.shelf().mixes)
        offers.push_back({QString::fromStdString(mix.name), Words::tr("Your mix"),
                          Words::tr("Choose this paint"),
                          [&panel, paint = mix.paint] { panel.choose(paint); }});
}

void add_media(std::vector<dialogs::Offer>& offers, panels::MediumBox& box) {
    for (const QString& name : box.media())
        offers.push_back({box.shown_medium(name), Words::tr("Medium"), box.sentence(name),
                          [&box, name] { box.choose(name); }});
}

}  // namespace

std::vector<dialogs::Offer> findable(const commands::CommandRegistry& commands, const PanelSet& panels) {
    std::vector<dialogs::Offer> offers;
    add_tools(offers, *panels.brushes);
    add_paints(offers, *panels.paints);
    add_mixes(offers, *panels.colours);
    add_media(offers, *panels.medium);
    add_controls(offers, commands, panels);
    return offers;
}

}  // namespace pastoso::main
