// How MainWindow is laid out: tool bar above, tools on the left, the canvas in the rest.

#include "brush/preset.hpp"
#include "film/medium.hpp"
#include "main/main_window.hpp"
#include "panels/brush_panel.hpp"
#include "panels/easel_panel.hpp"
#include "panels/paint_panel.hpp"
#include "panels/status_readings.hpp"
#include "panels/well_panel.hpp"
#include "pigment/box.hpp"
#include "pigment/user_pigments.hpp"
#include "tools/swatch.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::main {
namespace {

constexpr int kPanelWidth = 232;

QColor colour(const pigment::Srgb8& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

/// The box in its order, then the other tubes, the painter's own, and the medium.
std::vector<panels::PaintEntry> paint_entries() {
    std::vector<panels::PaintEntry> entries;
    const auto add_new = [&](const std::vector<pigment::Pigment>& paints) {
        for (const pigment::Pigment& paint : paints) {
            const auto ci_name = QString::fromStdString(paint.ci_name);
            const bool known = std::any_of(entries.begin(), entries.end(),
                                           [&](const auto& entry) { return entry.pigment == ci_name; });
            if (known) continue;
            const tools::Swatch swatch = tools::swatch(paint.coefficients);
            entries.push_back({ci_name, QString::fromStdString(paint.name), colour(swatch.masstone),
                               colour(swatch.tint)});
        }
    };
    add_new(pigment::default_box());
    add_new(pigment::bundled_palette());
    add_new(pigment::user_pigments().pigments);
    entries.push_back({QString(), QObject::tr("Clear medium"), QColor(232, 230, 224), Qt::white});
    return entries;
}

QComboBox* make_medium_box() {
    auto* box = new QComboBox;
    box->setFocusPolicy(Qt::TabFocus);
    box->setToolTip(QObject::tr("How the next paint flows; what lies on the canvas keeps its own way"));
    for (const film::Medium& medium : film::bundled_media()) {
        box->addItem(QString::fromStdString(medium.name));
        box->setItemData(box->count() - 1, QString::fromStdString(medium.description), Qt::ToolTipRole);
    }
    return box;
}

}  // namespace

void MainWindow::lay_out() {
    commands_.fill(menuBar());
    make_tool_bar();
    make_panels();
    make_well_panel();
    make_docks();
    readings_ = new panels::StatusReadings;
    readings_->show_canvas(session_->canvas());
    statusBar()->setSizeGripEnabled(false);
    statusBar()->addPermanentWidget(readings_);
    resize(1280, 800);
    canvas_->setFocus();
}

void MainWindow::make_tool_bar() {
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tool_bar"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    const auto add_button = [&](commands::Command command, const QString& words) {
        commands_.action(command)->setIconText(words);
        auto* button = new QToolButton;
        button->setDefaultAction(commands_.action(command));
        button->setFocusPolicy(Qt::TabFocus);
        bar->addWidget(button);
    };
    add_button(commands::Command::Undo, tr("Undo"));
    add_button(commands::Command::Redo, tr("Redo"));
    bar->addSeparator();
    add_button(commands::Command::ReloadBrush, tr("Reload"));
    add_button(commands::Command::CleanBrush, tr("Clean"));
    add_button(commands::Command::ReloadEachStroke, tr("Reload each stroke"));
    add_button(commands::Command::TurnWithStroke, tr("Turn with stroke"));
    bar->addSeparator();
    bar->addWidget(new QLabel(tr("Medium ")));
    medium_ = make_medium_box();
    bar->addWidget(medium_);
    add_button(commands::Command::Pause, tr("Pause"));
    add_button(commands::Command::DryNow, tr("Dry now"));
    add_button(commands::Command::MixingWell, tr("Mixing well"));
    bar->addSeparator();
    add_button(commands::Command::SavePainting, tr("Save"));
}

/// Its tools come later, their thumbnails as they come into view.
panels::BrushPanel* MainWindow::make_brush_panel() {
    std::vector<QAction*> own_actions;
    const auto add_own = [&](commands::Command command, const QString& words) {
        own_actions.push_back(commands_.action(command));
        own_actions.back()->setIconText(words);
    };
    add_own(commands::Command::SaveBrush, tr("Save"));
    add_own(commands::Command::RenameBrush, tr("Rename"));
    add_own(commands::Command::DeleteBrush, tr("Delete"));
    auto* panel = new panels::BrushPanel(own_actions);
    const double pixels = devicePixelRatioF();
    const QSize size = panels::kThumbnailSize * pixels;
    thumbnails_ = std::make_unique<session::ThumbnailPainter>(
        size.width(), size.height(),
        [panel, pixels](const std::string& name, const shade::Image8& thumbnail) {
            QImage image = QImage(thumbnail.rgb.data(), thumbnail.width, thumbnail.height,
                                  3 * thumbnail.width, QImage::Format_RGB888)
                               .copy();
            image.setDevicePixelRatio(pixels);
            QMetaObject::invokeMethod(panel, [panel, name = QString::fromStdString(name), image] {
                panel->list().set_thumbnail(name, image);
            });
        });
    connect(panel, &panels::BrushPanel::thumbnail_wanted, this, [this](const QString& name) {
        const auto* entry = brush::find_entry(library_, name.toStdString());
        if (entry != nullptr) thumbnails_->want(entry->preset);
    });
    return panel;
}

void MainWindow::make_panels() {
    brushes_ = make_brush_panel();
    paints_ = new panels::PaintPanel(paint_entries());
    stand_ = new panels::EaselPanel;
    auto* side = new QWidget;
    side->setFixedWidth(kPanelWidth);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(10, 8, 10, 8);
    column->setSpacing(12);
    column->addWidget(brushes_, 1);
    column->addWidget(paints_, 1);
    column->addWidget(stand_);

    auto* middle = new QWidget;
    auto* row = new QHBoxLayout(middle);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(side);
    row->addWidget(canvas_, 1);
    setCentralWidget(middle);
}

void MainWindow::make_well_panel() {
    using commands::Command;
    commands_.action(Command::SqueezePaint)->setIconText(tr("Squeeze"));
    commands_.action(Command::CleanWell)->setIconText(tr("Wipe the well"));
    well_panel_ = panels::well_panel(
        well_, {commands_.action(Command::SqueezePaint), commands_.action(Command::CleanWell)});
    addDockWidget(Qt::RightDockWidgetArea, well_panel_);
    well_panel_->hide();
}

}  // namespace pastoso::main
