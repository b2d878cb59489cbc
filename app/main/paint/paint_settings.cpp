#include "main/paint/paint_settings.hpp"

#include "core/text_file.hpp"
#include "core/user_data.hpp"
#include "files/image.hpp"
#include "layers/picture_means.hpp"
#include "main/files/picture_files.hpp"
#include "panels/colour/colour_panel.hpp"
#include "panels/paint/paint_words.hpp"
#include "tools/paint_shelf.hpp"
#include "tools/picture_colours.hpp"
#include "tools/swatch.hpp"

#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>

namespace pastoso::main {
namespace {

constexpr int kSettling_ms = 1000;

/// A picture's colours are looked for in so many pixels a side at most: fewer than these means are not
/// seen as areas.
constexpr int kLooked_px = 192;

}  // namespace

PaintSettings::PaintSettings(Studio& studio, Loading& loading, panels::ColourPanel* colours)
    : studio_(studio),
      loading_(loading),
      colours_(colours),
      file_(studio, core::user_data_path("paints.json"),
            [](const auto& file) { tools::read_shelf(file); }) {
    changed_.setSingleShot(true);
    changed_.setInterval(kSettling_ms);
    connect(&changed_, &QTimer::timeout, this, &PaintSettings::keep);
    connect(colours_, &panels::ColourPanel::refused, &studio_, &Studio::report);
    connect(colours_, &panels::ColourPanel::palette_wanted, this, &PaintSettings::ask_palette);
    connect(colours_, &panels::ColourPanel::picture_wanted, this, &PaintSettings::ask_picture);
    connect(colours_, &panels::ColourPanel::palette_save_wanted, this, &PaintSettings::ask_save_palette);
    connect(colours_, &panels::ColourPanel::export_wanted, this, &PaintSettings::ask_export);
    connect(colours_, &panels::ColourPanel::import_wanted, this, &PaintSettings::ask_import);
}

void PaintSettings::recall() {
    file_.recall([this](const auto& file) { colours_->show_shelf(tools::read_shelf(file)); });
    connect(colours_, &panels::ColourPanel::shelf_changed, &changed_, qOverload<>(&QTimer::start));
}

void PaintSettings::remember() {
    if (changed_.isActive()) keep();
}

void PaintSettings::keep() {
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

void PaintSettings::ask_picture(int colours) {
    const QString path =
        QFileDialog::getOpenFileName(&studio_.window(), tr("Colours of a picture"), QString(),
                                     tr("Pictures (%1)").arg(picture_endings()));
    if (!path.isEmpty()) open_picture(path, colours);
}

void PaintSettings::open_picture(const QString& path, int colours) {
    const QString name = QFileInfo(path).completeBaseName();
    loading_.begin(tr("Reading %1").arg(QFileInfo(path).fileName()),
                   [this, path, name, colours](const core::Progress&) {
                       pigment::ColourPalette palette{name.toStdString(), {}};
                       const pigment::Picture picture = layers::reduced(
                           files::read_picture(path.toStdString()).picture, kLooked_px, kLooked_px);
                       for (const pigment::Srgb8& colour : tools::picture_colours(picture, colours))
                           palette.colours.push_back({"", colour});
                       return [this, palette] { colours_->show_palette(palette); };
                   });
}

void PaintSettings::ask_save_palette() {
    const QString path = QFileDialog::getSaveFileName(&studio_.window(), tr("Save the palette"),
                                                      tr("my-palette.gpl"), tr("Palettes (*.gpl)"));
    if (!path.isEmpty()) save_palette(path);
}

/// Colours of a screen, as thick paint has them in daylight.
void PaintSettings::save_palette(const QString& path) {
    pigment::ColourPalette palette{QFileInfo(path).completeBaseName().toStdString(), {}};
    for (const document::PaintRecipe& paint : colours_->shelf().kept)
        palette.colours.push_back(
            {panels::recipe_words(paint).toStdString(), tools::screen_colour(paint)});
    for (const tools::NamedPaint& mix : colours_->shelf().mixes)
        palette.colours.push_back({mix.name, tools::screen_colour(mix.paint)});
    write(tr("Save the palette"), path,
          [&](const auto& file) { core::write_text_file(file, pigment::gpl_text(palette)); });
}

void PaintSettings::ask_export() {
    const QString path = QFileDialog::getSaveFileName(
        &studio_.window(), tr("Export my paints"), tr("my-paints.json"), tr("Sets of paints (*.json)"));
    if (!path.isEmpty()) export_paints(path);
}

void PaintSettings::export_paints(const QString& path) {
    write(tr("Export my paints"), path,
          [this](const auto& file) { tools::write_shelf(tools::paint_set(colours_->shelf()), file); });
}

void PaintSettings::ask_import() {
    const QString path = QFileDialog::getOpenFileName(&studio_.window(), tr("Import paints"), QString(),
                                                      tr("Sets of paints (*.json)"));
    if (!path.isEmpty()) import_paints(path);
}

void PaintSettings::import_paints(const QString& path) {
    studio_.attempt(tr("Import paints"), [&] {
        const int added = colours_->add_paints(tools::read_shelf(path.toStdString()));
        studio_.report(added == 0 ? tr("You have all paints of that set already.")
                                  : tr("%n paint(s) added to your own.", nullptr, added));
    });
}

void PaintSettings::write(const QString& what, const QString& path,
                          const std::function<void(const std::filesystem::path&)>& work) {
    studio_.attempt(what, [&] {
        work(path.toStdString());
        studio_.report(tr("Saved %1.").arg(path));
    });
}

}  // namespace pastoso::main
