// The panels that stand beside the canvas, each in a dock of its own.

#include "main/panel_set.hpp"
#include "main/studio.hpp"
#include "panels/colour_panel.hpp"
#include "panels/curves_panel.hpp"
#include "panels/guides_panel.hpp"
#include "panels/history_panel.hpp"
#include "panels/layer_panel.hpp"
#include "panels/load_panel.hpp"
#include "panels/medium_panel.hpp"
#include "panels/tracing_panel.hpp"

#include <utility>

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QVBoxLayout>

namespace pastoso::main {

namespace {

using commands::Command;

panels::LayerPanel* make_layer_panel(Studio& studio) {
    const auto action = [&](Command command) { return studio.commands().action(command); };
    return new panels::LayerPanel(
        {action(Command::AddLayer), action(Command::DuplicateLayer), action(Command::GroupLayers),
         action(Command::MergeDown), action(Command::RemoveLayer)},
        {action(Command::RenameLayer), action(Command::ShowLayer), action(Command::LockLayer), nullptr,
         action(Command::AddLayer), action(Command::DuplicateLayer), action(Command::ClearLayer),
         action(Command::RemoveLayer), nullptr, action(Command::MergeDown),
         action(Command::FlattenLayers), action(Command::GroupLayers), action(Command::UngroupLayers)});
}

/// What does not fit into the window is scrolled to.
QDockWidget* add_dock(Studio& studio, PanelSet& panels, Command command, const QString& name,
                      const QString& title, QWidget* content) {
    content->layout()->setContentsMargins(10, 8, 10, 8);
    auto* scrolled = new QScrollArea;
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setFocusPolicy(Qt::NoFocus);  // a click beside the controls leaves the keys to the canvas
    scrolled->setWidgetResizable(true);
    scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolled->setWidget(content);
    scrolled->setMinimumWidth(content->minimumSizeHint().width() +
                              scrolled->verticalScrollBar()->sizeHint().width());
    auto* dock = new QDockWidget(title, &studio.window());
    dock->setObjectName(name);
    dock->setWidget(scrolled);
    studio.window().addDockWidget(Qt::RightDockWidgetArea, dock);
    panels.docks[command] = dock;
    studio.commands().on(command, [dock, content](bool) {
        dock->show();
        dock->raise();
        if (QWidget* first = content->nextInFocusChain()) first->setFocus(Qt::TabFocusReason);
    });
    return dock;
}

}  // namespace

void add_docks(Studio& studio, PanelSet& panels) {
    const auto action = [&](Command command) { return studio.commands().action(command); };
    const auto name_button = [&](Command command, const QString& words) {
        action(command)->setIconText(words);
    };
    name_button(Command::TopUpBrush, QObject::tr("Top up"));
    name_button(Command::BlotBrush, QObject::tr("Blot"));
    name_button(Command::SwapPaints, QObject::tr("Swap"));
    name_button(Command::PickPaint, QObject::tr("Pick paint"));
    name_button(Command::PickColour, QObject::tr("Pick colour"));
    name_button(Command::MirrorSymmetry, QObject::tr("Left, right"));
    name_button(Command::MirrorLevel, QObject::tr("Above, below"));
    name_button(Command::Ruler, QObject::tr("Along the last stroke"));
    name_button(Command::Ellipse, QObject::tr("On the canvas"));
    panels.load = new panels::LoadPanel({action(Command::ReloadBrush), action(Command::TopUpBrush),
                                         action(Command::BlotBrush), action(Command::CleanBrush)},
                                        action(Command::SwapPaints));
    panels.curves = new panels::CurvesPanel;
    auto* tool = new QWidget;
    auto* column = new QVBoxLayout(tool);
    column->setSpacing(12);
    column->addWidget(panels.load);
    column->addWidget(panels.curves);
    column->addStretch(1);
    panels.colours = new panels::ColourPanel({action(Command::PickPaint), action(Command::PickColour)});
    panels.guides = new panels::GuidesPanel(
        {action(Command::MirrorSymmetry), action(Command::MirrorLevel), action(Command::Ruler),
         action(Command::Ellipse), action(Command::GuideHandles), action(Command::RemoveGuides)});
    name_button(Command::TracePicture, QObject::tr("Choose..."));
    name_button(Command::RemoveTracing, QObject::tr("Take away"));
    name_button(Command::ShowTracing, QObject::tr("Below the paint"));
    name_button(Command::FitTracing, QObject::tr("Fit"));
    panels.tracing =
        new panels::TracingPanel({action(Command::TracePicture), action(Command::RemoveTracing)},
                                 {action(Command::ShowTracing), action(Command::FitTracing)});
    QMainWindow& window = studio.window();
    window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    const auto add = [&](Command command, const QString& name, const QString& title, QWidget* content) {
        return add_dock(studio, panels, command, name, title, content);
    };
    QDockWidget* first =
        add(Command::ToolPanel, QStringLiteral("tool_panel"), QObject::tr("Tool"), tool);
    window.tabifyDockWidget(first, add(Command::ColourPanel, QStringLiteral("colour_panel"),
                                       QObject::tr("Colour"), panels.colours));
    window.tabifyDockWidget(
        first, add(Command::PhysicsPanel, QStringLiteral("physics_panel"), QObject::tr("Physics"),
                   panels.physics = new panels::MediumPanel));
    window.tabifyDockWidget(first, add(Command::GuidesPanel, QStringLiteral("guides_panel"),
                                       QObject::tr("Guides"), panels.guides));
    QDockWidget* layers = add(Command::LayersPanel, QStringLiteral("layers_panel"),
                              QObject::tr("Layers"), panels.layers = make_layer_panel(studio));
    window.tabifyDockWidget(layers, add(Command::TracingPanel, QStringLiteral("tracing_panel"),
                                        QObject::tr("Tracing"), panels.tracing));
    window.tabifyDockWidget(
        layers, add(Command::HistoryPanel, QStringLiteral("history_panel"), QObject::tr("History"),
                    panels.history = new panels::HistoryPanel));
    layers->raise();
    first->raise();
    // As narrow as what they hold allows: the canvas gets the rest.
    window.resizeDocks({first}, {1}, Qt::Horizontal);
}

}  // namespace pastoso::main
