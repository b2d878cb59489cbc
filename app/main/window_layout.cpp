// How MainWindow is laid out: tool bar above, tools on the left, the canvas in the rest.

#include "brush/preset.hpp"
#include "film/medium.hpp"
#include "main/main_window.hpp"
#include "panels/brush_panel.hpp"
#include "panels/easel_panel.hpp"
#include "panels/mix_panel.hpp"
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

/// The heading that a tool stands under, and its place among the headings.
struct Family {
    int rank;
    QString heading;
};

/// Bristles first, then what is stiff, then what is soft.
Family family_of(const brush::Preset& preset) {
    if (preset.kind == brush::ToolKind::Droplets) return {3, QObject::tr("Drops and sprays")};
    if (preset.kind == brush::ToolKind::Air) return {4, QObject::tr("Air")};
    switch (preset.tip.shape) {
        case brush::TipShape::Knife:
        case brush::TipShape::Comb:
            return {1, QObject::tr("Knives and combs")};
        case brush::TipShape::Pad:
            return {2, QObject::tr("Rags and fingers")};
        default:
            return {0, QObject::tr("Brushes")};
    }
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
    box->setFocusPolicy(Qt::NoFocus);
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
    readings_ = new panels::StatusReadings;
    readings_->show_canvas(session_->canvas());
    statusBar()->setSizeGripEnabled(false);
    statusBar()->addPermanentWidget(readings_);
    resize(1280, 800);
}

void MainWindow::make_tool_bar() {
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    const auto add_button = [&](commands::Command command, const QString& words) {
        commands_.action(command)->setIconText(words);
        auto* button = new QToolButton;
        button->setDefaultAction(commands_.action(command));
        button->setFocusPolicy(Qt::NoFocus);
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
    add_button(commands::Command::SavePicture, tr("Save picture"));
}

/// Tools by family, and their thumbnails as they come into view.
panels::BrushPanel* MainWindow::make_brush_panel() {
    std::vector<brush::Preset> presets = brush::bundled_presets();
    std::stable_sort(presets.begin(), presets.end(),
                     [](const auto& a, const auto& b) { return family_of(a).rank < family_of(b).rank; });
    std::vector<panels::BrushEntry> entries;
    for (const brush::Preset& preset : presets)
        entries.push_back(
            {QString::fromStdString(preset.name), family_of(preset).heading, preset.tip.width_mm});
    auto* panel = new panels::BrushPanel(std::move(entries));
    const double pixels = devicePixelRatioF();
    const QSize size = panels::kThumbnailSize * pixels;
    thumbnails_ = std::make_unique<session::ThumbnailPainter>(
        std::move(presets), size.width(), size.height(),
        [panel, pixels](std::size_t entry, const shade::Image8& thumbnail) {
            QImage image = QImage(thumbnail.rgb.data(), thumbnail.width, thumbnail.height,
                                  3 * thumbnail.width, QImage::Format_RGB888)
                               .copy();
            image.setDevicePixelRatio(pixels);
            QMetaObject::invokeMethod(panel, [panel, entry, image] {
                panel->list().set_thumbnail(static_cast<int>(entry), image);
            });
        });
    connect(&panel->list(), &panels::BrushList::thumbnail_wanted, this,
            [this](int entry) { thumbnails_->want(static_cast<std::size_t>(entry)); });
    return panel;
}

void MainWindow::make_panels() {
    brushes_ = make_brush_panel();
    paints_ = new panels::PaintPanel(paint_entries());
    mixing_ = new panels::MixPanel;
    stand_ = new panels::EaselPanel;
    auto* side = new QWidget;
    side->setFixedWidth(kPanelWidth);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(10, 8, 10, 8);
    column->setSpacing(12);
    column->addWidget(brushes_, 1);
    column->addWidget(paints_, 1);
    column->addWidget(mixing_);
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
