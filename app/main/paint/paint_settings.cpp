#include "main/paint/paint_settings.hpp"

#include "core/text_file.hpp"
#include "core/user_data.hpp"
#include "panels/colour/colour_panel.hpp"
#include "pigment/gpl.hpp"
#include "tools/paint_shelf.hpp"

#include <QFileDialog>
#include <QMainWindow>

namespace pastoso::main {
namespace {

constexpr int kSettling_ms = 1000;

}  // namespace

PaintSettings::PaintSettings(Studio& studio, panels::ColourPanel* colours)
    : studio_(studio), colours_(colours), file_(studio, core::user_data_path("paints.json")) {
    changed_.setSingleShot(true);
    changed_.setInterval(kSettling_ms);
    connect(&changed_, &QTimer::timeout, this, &PaintSettings::write);
    connect(colours_, &panels::ColourPanel::refused, &studio_, &Studio::report);
    connect(colours_, &panels::ColourPanel::palette_wanted, this, &PaintSettings::ask_palette);
}

void PaintSettings::recall() {
    file_.recall([this](const auto& file) { colours_->show_shelf(tools::read_shelf(file)); });
    connect(colours_, &panels::ColourPanel::shelf_changed, &changed_, qOverload<>(&QTimer::start));
}

void PaintSettings::remember() {
    if (changed_.isActive()) write();
}

void PaintSettings::write() {
    changed_.stop();
    file_.remember([this](const auto& file) { tools::write_shelf(colours_->shelf(), file); });
}

void PaintSettings::ask_palette() {
    const QString path = QFileDialog::getOpenFileName(&studio_.window(), tr("Open a palette"), QString(),
                                                      tr("Palettes (*.gpl)"));
    if (!path.isEmpty()) open_palette(path);
}

void PaintSettings::open_palette(const QString& path) {
    studio_.attempt([&] {
        const std::string file = path.toStdString();
        colours_->show_palette(pigment::parse_gpl(core::read_text_file(file), file));
    });
}

}  // namespace pastoso::main
