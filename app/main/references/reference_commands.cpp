#include "main/references/reference_commands.hpp"

#include "appearance/picture_view.hpp"
#include "appearance/shown_message.hpp"
#include "core/error.hpp"
#include "files/image.hpp"
#include "layers/picture_means.hpp"
#include "main/files/picture_files.hpp"
#include "panels/paint/paint_words.hpp"
#include "panels/references/reference_panel.hpp"
#include "panels/references/reference_places.hpp"
#include "panels/references/reference_view.hpp"
#include "tools/colour_paint.hpp"

#include <array>
#include <utility>

#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMainWindow>
#include <QMimeData>
#include <QScreen>

namespace pastoso::main {
namespace {

using commands::Command;

/// Enough to look at closely; the painting's file grows by it, and forty of them fit on the board.
constexpr int kMostSide_px = 2560;

/// As much of a name as the board keeps, in whole letters.
std::string kept_name(QString name) {
    name.truncate(static_cast<qsizetype>(document::kMostReferenceName));
    while (name.toUtf8().size() > static_cast<qsizetype>(document::kMostReferenceName))
        name.chop(1);
    return name.toStdString();
}

document::SharedReferencePicture packed(pigment::Picture picture) {
    document::ReferencePicture kept{layers::reduced(std::move(picture), kMostSide_px, kMostSide_px), {}};
    kept.png = files::png_file(kept.pixels);
    return std::make_shared<const document::ReferencePicture>(std::move(kept));
}

/// A panel that was never laid out would float small, and beside the screen.
void bring_into_view(QDockWidget& floating, const QWidget& canvas) {
    constexpr QSize kSize(360, 300);
    constexpr int kMargin_px = 16;
    const bool seen = QGuiApplication::screenAt(floating.geometry().center()) != nullptr;
    if (seen && floating.height() >= kSize.height() / 2) return;
    floating.resize(kSize);
    floating.move(canvas.mapToGlobal(QPoint(canvas.width() - kSize.width() - kMargin_px, kMargin_px)));
}

}  // namespace

ReferenceCommands::ReferenceCommands(Studio& studio, Loading& loading, panels::ReferencePanel* panel,
                                     QDockWidget* dock)
    : studio_(studio), loading_(loading), panel_(panel), dock_(dock) {
    studio_.commands().on(Command::AddReference, [this](bool) { ask_for_pictures(); });
    studio_.commands().on(Command::FloatReferences, [this](bool floats) {
        dock_->show();
        dock_->setFloating(floats);
        if (floats) bring_into_view(*dock_, studio_.canvas());
        dock_->raise();
    });
    connect(dock_, &QDockWidget::topLevelChanged, studio_.commands().action(Command::FloatReferences),
            &QAction::setChecked);
    listen();
}

void ReferenceCommands::listen() {
    panels::ReferenceView* board = &panel_->board();
    connect(board, &panels::ReferenceView::acted, this,
            [this](const document::Action& action) { studio_.session().post(action); });
    connect(board, &panels::ReferenceView::colour_picked, this, &ReferenceCommands::take_colour);
    connect(board, &panels::ReferenceView::dropped, this,
            [this](const QMimeData& data, const QPointF& middle_mm) { add_dragged(data, middle_mm); });
    connect(board, &panels::ReferenceView::paste_wanted, this, [this] {
        if (const QMimeData* held = QGuiApplication::clipboard()->mimeData())
            add_dragged(*held, std::nullopt);
    });
    const std::array picks = {studio_.commands().action(Command::PickPaint),
                              studio_.commands().action(Command::PickColour)};
    for (const QAction* pick : picks)
        connect(pick, &QAction::toggled, board,
                [board, picks] { board->pick_next(picks[0]->isChecked() || picks[1]->isChecked()); });
    connect(&studio_, &Studio::session_ends, board, &panels::ReferenceView::finish);
    connect(&studio_, &Studio::published, board,
            [board](const auto& painting) { board->show_board(painting->references); });
}

void ReferenceCommands::ask_for_pictures() {
    const QStringList paths =
        QFileDialog::getOpenFileNames(&studio_.window(), tr("Add reference pictures"), {},
                                      tr("Pictures (%1);;All files (*)").arg(picture_endings()));
    if (!paths.isEmpty()) add_files(paths);
}

void ReferenceCommands::add_files(const QStringList& paths, std::optional<QPointF> middle_mm) {
    std::vector<Source> sources;
    for (const QString& path : paths)
        sources.push_back({QFileInfo(path).completeBaseName(),
                           [path] { return files::read_picture(path.toStdString()).picture; }});
    add(QFileInfo(paths.front()).fileName(), std::move(sources), middle_mm);
}

void ReferenceCommands::add_picture(const QImage& image, std::optional<QPointF> middle_mm) {
    add(tr("the picture"), {{tr("Picture"), [image] { return appearance::picture_of(image); }}},
        middle_mm);
}

void ReferenceCommands::add_dragged(const QMimeData& data, std::optional<QPointF> middle_mm) {
    const QStringList paths = local_files(data);
    const auto image = data.hasImage() ? qvariant_cast<QImage>(data.imageData()) : QImage();
    if (!paths.isEmpty())
        add_files(paths, middle_mm);
    else if (!image.isNull())
        add_picture(image, middle_mm);
    else
        studio_.report(tr("There is no picture in it; save it as a file, and drag that here."));
}

/// A file that is no picture keeps no other from the board.
void ReferenceCommands::add(const QString& what, std::vector<Source> sources,
                            std::optional<QPointF> middle_mm) {
    const auto make = [this, sources = std::move(sources), middle_mm](const core::Progress&) {
        std::vector<Packed> pictures;
        std::vector<core::Message> faults;
        for (const Source& source : sources) {
            try {
                pictures.push_back({kept_name(source.name), packed(source.read())});
            } catch (const core::InputError& error) {
                faults.push_back(error.message());
            }
        }
        return [this, pictures, faults, middle_mm] {
            lay(pictures, middle_mm);
            for (const core::Message& fault : faults)
                studio_.report_refusal(appearance::shown_message(fault));
        };
    };
    loading_.begin(tr("Reading %1").arg(what), make);
}

void ReferenceCommands::lay(const std::vector<Packed>& pictures, std::optional<QPointF> middle_mm) {
    QRectF taken_mm = panels::extent_mm(panel_->board().board());
    bool joins = false;
    for (const Packed& packed : pictures) {
        document::Reference laid{.picture = packed.picture};
        const double proportion = panels::proportion_of(laid.picture->pixels);
        laid.place = middle_mm ? panels::place_about(*middle_mm, proportion)
                               : panels::place_beside(taken_mm, proportion);
        taken_mm = middle_mm ? panels::extent_mm(laid) : taken_mm.united(panels::extent_mm(laid));
        middle_mm.reset();
        studio_.session().post(document::LayReference{packed.name, laid.place, laid.picture, joins});
        joins = true;
    }
    dock_->show();
    dock_->raise();
}

void ReferenceCommands::take_colour(const pigment::Srgb8& colour) {
    const document::PaintRecipe paint = tools::recipe_paint(tools::closest_in_box(colour));
    studio_.choose_paint(paint);
    studio_.report(tr("Picked from the reference: %1").arg(panels::share_words(paint)));
    for (const Command command : {Command::PickPaint, Command::PickColour})
        if (studio_.commands().action(command)->isChecked())
            studio_.commands().action(command)->trigger();
}

}  // namespace pastoso::main
