#include "main/panel_set.hpp"

#include "appearance/shown_names.hpp"
#include "appearance/terms.hpp"
#include "brush/preset.hpp"
#include "main/studio.hpp"
#include "panels/canvas/easel_panel.hpp"
#include "panels/paint/medium_box.hpp"
#include "panels/paint/paint_panel.hpp"
#include "panels/paint/thinning_slider.hpp"
#include "panels/paint/well_panel.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/status_readings.hpp"
#include "panels/parts/tool_bar.hpp"
#include "panels/pen/brush_panel.hpp"
#include "pigment/box.hpp"
#include "pigment/user_pigments.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QScreen>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::main {
namespace {

constexpr int kToolIconSide = 20;

/// The box in its order, then the other tubes, the painter's own, and the medium.
std::vector<panels::PaintEntry> paint_entries() {
    std::vector<panels::PaintEntry> entries;
    const auto add_new = [&](const std::vector<pigment::Pigment>& paints) {
        for (const pigment::Pigment& paint : paints) {
            const auto ci_name = QString::fromStdString(paint.ci_name);
            const bool known = std::any_of(entries.begin(), entries.end(),
                                           [&](const auto& entry) { return entry.pigment == ci_name; });
            if (known) continue;
            entries.push_back({ci_name, appearance::shown_name(paint.name)});
        }
    };
    add_new(pigment::default_box());
    add_new(pigment::bundled_palette());
    add_new(pigment::user_pigments().pigments);
    entries.push_back({QString(), QObject::tr("Clear medium")});
    return entries;
}

panels::MediumBox* make_medium_box() {
    auto* box = new panels::MediumBox;
    box->setAccessibleName(QObject::tr("Kind of paint"));
    box->setToolTip(QObject::tr("How the next paint flows; what lies on the canvas keeps its own way"));
    return box;
}

/// Its entries come later.
QComboBox* make_time_box() {
    auto* box = new QComboBox;
    box->setObjectName(QStringLiteral("time"));
    box->setFocusPolicy(Qt::TabFocus);
    const QString words = QObject::tr(
        "How fast time passes for the paint: 10 × is ten seconds in one. "
        "While you draw a stroke it passes as usual");
    box->setAccessibleName(words);
    box->setToolTip(words);
    return box;
}

panels::ToolBar* make_tool_bar(Studio& studio, const PanelSet& panels) {
    using commands::Command;
    auto* bar = new panels::ToolBar(QObject::tr("Tools"));
    studio.window().addToolBar(bar);
    bar->setObjectName(QStringLiteral("tool_bar"));
    bar->setIconSize(QSize(kToolIconSide, kToolIconSide));
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    const auto add_button = [&](Command command, const QString& words) {
        QAction* action = studio.commands().action(command);
        action->setIconText(words);
        return bar->add_button(action);
    };
    add_button(Command::Undo, QObject::tr("Undo"));
    add_button(Command::Redo, QObject::tr("Redo"));
    bar->addSeparator();
    add_button(Command::ReloadBrush, QObject::tr("Reload"));
    add_button(Command::CleanBrush, QObject::tr("Clean"));
    QToolButton* each = add_button(Command::ReloadEachStroke, QObject::tr("Each stroke"));
    QToolButton* turns = add_button(Command::TurnWithStroke, QObject::tr("Turns"));
    bar->addSeparator();
    QAction* medium = bar->add_word(QObject::tr("Medium "));
    appearance::explain(bar->widgetForAction(medium), appearance::Term::Medium);
    bar->add_box(panels.medium);
    bar->addWidget(panels.thinning);
    QObject::connect(bar, &QToolBar::orientationChanged, panels.thinning,
                     [thinning = panels.thinning](Qt::Orientation orientation) {
                         thinning->set_upright(orientation == Qt::Vertical);
                     });
    add_button(Command::ThinWash, QObject::tr("Wash"));
    bar->addSeparator();
    add_button(Command::Pause, QObject::tr("Pause"));
    bar->add_box(panels.time);
    QToolButton* dry = add_button(Command::DryNow, QObject::tr("Dry now"));
    QToolButton* well = add_button(Command::MixingWell, QObject::tr("Mixing well"));
    bar->addSeparator();
    add_button(Command::SavePainting, QObject::tr("Save"));
    // The icons that tell least come first.
    bar->say({each, turns});
    bar->say({dry, well});
    bar->say(medium);
    return bar;
}

/// Its tools and their thumbnails come later.
panels::BrushPanel* make_brush_panel(const commands::CommandRegistry& commands) {
    using commands::Command;
    std::vector<QAction*> own_actions;
    const auto add_own = [&](Command command, const QString& words) {
        own_actions.push_back(commands.action(command));
        own_actions.back()->setIconText(words);
    };
    add_own(Command::BrushEditor, QObject::tr("Edit"));
    add_own(Command::FavouriteBrush, QObject::tr("Favourite"));
    add_own(Command::SaveBrush, QObject::tr("Save"));
    add_own(Command::RenameBrush, QObject::tr("Rename"));
    add_own(Command::DeleteBrush, QObject::tr("Delete"));
    return new panels::BrushPanel(own_actions);
}

/// The canvas, and what comes to stand in its place.
void add_middle(Studio& studio) {
    auto* middle = new QWidget;
    auto* row = new QHBoxLayout(middle);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(&studio.canvas(), 1);
    studio.window().setCentralWidget(middle);
}

/// Beside the line in which they pass.
QToolButton* make_message_button(Studio& studio) {
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("show_messages"));
    button->setDefaultAction(studio.commands().action(commands::Command::MessagesPanel));
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

QDockWidget* add_well(Studio& studio) {
    using commands::Command;
    const auto action = [&studio](Command command) { return studio.commands().action(command); };
    action(Command::SqueezePaint)->setIconText(QObject::tr("Squeeze"));
    action(Command::CleanWell)->setIconText(QObject::tr("Wipe the well"));
    QDockWidget* dock =
        panels::well_panel(&studio.well(), {action(Command::ReloadBrush), action(Command::CleanBrush)},
                           {action(Command::SqueezePaint), action(Command::CleanWell)});
    studio.window().addDockWidget(Qt::RightDockWidgetArea, dock);
    dock->hide();
    return dock;
}

constexpr QSize kLeast(1280, 800);

/// Where that leaves no place for the desktop's frame, the window fills the screen.
void size_window(QMainWindow& window) {
    constexpr int kFrame_px = 40;
    const QSize screen = window.screen()->availableSize();
    window.resize(first_window_size(screen));
    const bool fits = kLeast.width() <= screen.width() && kLeast.height() + kFrame_px <= screen.height();
    if (!fits) window.setWindowState(window.windowState().setFlag(Qt::WindowMaximized));
}

}  // namespace

QSize first_window_size(const QSize& screen) {
    constexpr double kShare = 0.85;
    constexpr QSize kMost(1920, 1200);
    return (kShare * screen).expandedTo(kLeast).boundedTo(kMost).boundedTo(screen);
}

PanelSet lay_out(Studio& studio) {
    QMainWindow& window = studio.window();
    studio.commands().fill(window.menuBar());
    PanelSet panels;
    panels.medium = make_medium_box();
    panels.thinning = new panels::ThinningSlider(Qt::Horizontal);
    panels.time = make_time_box();
    panels.bar = make_tool_bar(studio, panels);
    panels.brushes = make_brush_panel(studio.commands());
    panels.paints = new panels::PaintPanel(paint_entries());
    panels.stand = new panels::EaselPanel;
    add_middle(studio);
    panels.well = add_well(studio);
    add_docks(studio, panels);
    panels.readings = new panels::StatusReadings;
    window.statusBar()->setSizeGripEnabled(false);
    window.statusBar()->addPermanentWidget(make_message_button(studio));
    window.statusBar()->addPermanentWidget(panels.readings);
    size_window(window);
    studio.canvas().setFocus();
    return panels;
}

}  // namespace pastoso::main
