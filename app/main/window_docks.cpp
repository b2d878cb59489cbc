// The panels that stand beside MainWindow's canvas, each in a dock of its own.

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "main/main_window.hpp"
#include "panels/colour_panel.hpp"
#include "panels/curves_panel.hpp"
#include "panels/guides_panel.hpp"
#include "panels/layer_panel.hpp"
#include "panels/load_panel.hpp"
#include "panels/tracing_panel.hpp"
#include "pigment/gpl.hpp"

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QVBoxLayout>

namespace pastoso::main {

using commands::Command;

/// What does not fit into the window is scrolled to.
QDockWidget* MainWindow::add_dock(Command command, const QString& name, const QString& title,
                                  QWidget* content) {
    content->layout()->setContentsMargins(10, 8, 10, 8);
    auto* scrolled = new QScrollArea;
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setFocusPolicy(Qt::NoFocus);  // a click beside the controls leaves the keys to the canvas
    scrolled->setWidgetResizable(true);
    scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolled->setWidget(content);
    scrolled->setMinimumWidth(content->minimumSizeHint().width() +
                              scrolled->verticalScrollBar()->sizeHint().width());
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(scrolled);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    docks_[command] = dock;
    commands_.on(command, [dock, content](bool) {
        dock->show();
        dock->raise();
        if (QWidget* first = content->nextInFocusChain()) first->setFocus(Qt::TabFocusReason);
    });
    return dock;
}

void MainWindow::make_docks() {
    const auto action = [this](Command command) { return commands_.action(command); };
    commands_.action(Command::TopUpBrush)->setIconText(tr("Top up"));
    commands_.action(Command::BlotBrush)->setIconText(tr("Blot"));
    commands_.action(Command::SwapPaints)->setIconText(tr("Swap"));
    commands_.action(Command::PickPaint)->setIconText(tr("Pick paint"));
    commands_.action(Command::PickColour)->setIconText(tr("Pick colour"));
    commands_.action(Command::MirrorSymmetry)->setIconText(tr("Left, right"));
    commands_.action(Command::MirrorLevel)->setIconText(tr("Above, below"));
    commands_.action(Command::Ruler)->setIconText(tr("Along the last stroke"));
    commands_.action(Command::Ellipse)->setIconText(tr("On the canvas"));
    load_ = new panels::LoadPanel({action(Command::ReloadBrush), action(Command::TopUpBrush),
                                   action(Command::BlotBrush), action(Command::CleanBrush)},
                                  action(Command::SwapPaints));
    curves_ = new panels::CurvesPanel;
    auto* tool = new QWidget;
    auto* column = new QVBoxLayout(tool);
    column->setSpacing(12);
    column->addWidget(load_);
    column->addWidget(curves_);
    column->addStretch(1);
    colours_ = new panels::ColourPanel({action(Command::PickPaint), action(Command::PickColour)});
    guides_ = new panels::GuidesPanel({action(Command::MirrorSymmetry), action(Command::MirrorLevel),
                                       action(Command::Ruler), action(Command::Ellipse),
                                       action(Command::GuideHandles), action(Command::RemoveGuides)});
    commands_.action(Command::TracePicture)->setIconText(tr("Choose..."));
    commands_.action(Command::RemoveTracing)->setIconText(tr("Take away"));
    commands_.action(Command::ShowTracing)->setIconText(tr("Below the paint"));
    commands_.action(Command::FitTracing)->setIconText(tr("Fit"));
    tracing_ = new panels::TracingPanel({action(Command::TracePicture), action(Command::RemoveTracing)},
                                        {action(Command::ShowTracing), action(Command::FitTracing)});
    setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    QDockWidget* first = add_dock(Command::ToolPanel, QStringLiteral("tool_panel"), tr("Tool"), tool);
    tabifyDockWidget(
        first, add_dock(Command::ColourPanel, QStringLiteral("colour_panel"), tr("Colour"), colours_));
    tabifyDockWidget(
        first, add_dock(Command::GuidesPanel, QStringLiteral("guides_panel"), tr("Guides"), guides_));
    QDockWidget* layers = add_dock(Command::LayersPanel, QStringLiteral("layers_panel"), tr("Layers"),
                                   layers_ = make_layer_panel());
    tabifyDockWidget(layers, add_dock(Command::TracingPanel, QStringLiteral("tracing_panel"),
                                      tr("Tracing"), tracing_));
    layers->raise();
    first->raise();
    // As narrow as what they hold allows: the canvas gets the rest.
    resizeDocks({first}, {1}, Qt::Horizontal);
}

void MainWindow::connect_docks() {
    connect(load_, &panels::LoadPanel::dip_chosen, this, [this](const tools::Dip& dip) {
        easel_->set_dip(dip);
        load_->show_hand(easel_->hand());
    });
    connect(colours_, &panels::ColourPanel::paint_chosen, this, &MainWindow::choose_paint);
    connect(colours_, &panels::ColourPanel::refused, this, &MainWindow::report);
    connect(colours_, &panels::ColourPanel::palette_wanted, this, [this] {
        const QString path =
            QFileDialog::getOpenFileName(this, tr("Open a palette"), QString(), tr("Palettes (*.gpl)"));
        if (!path.isEmpty()) open_palette(path);
    });
}

void MainWindow::open_palette(const QString& path) {
    try {
        const std::string file = path.toStdString();
        colours_->show_palette(pigment::parse_gpl(core::read_text_file(file), file));
    } catch (const core::InputError& error) {
        report(QString::fromUtf8(error.what()));
    }
}

}  // namespace pastoso::main
