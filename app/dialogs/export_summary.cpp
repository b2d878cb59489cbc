#include "dialogs/export_summary.hpp"

#include "appearance/shown_number.hpp"
#include "core/error.hpp"
#include "core/looking.hpp"
#include "core/memory.hpp"
#include "core/units.hpp"
#include "dialogs/length_box.hpp"
#include "document/canvas.hpp"
#include "files/file_access.hpp"

#include <cmath>

#include <QCoreApplication>

namespace pastoso::dialogs {
namespace {

using tools::ExportForm;
using tools::ExportSettings;
using Path = std::filesystem::path;

QString tr(const char* words, const char* meaning = nullptr, int count = -1) {
    return QCoreApplication::translate("pastoso::dialogs", words, meaning, count);
}

bool is_folder_format(const ExportSettings& settings) {
    return *settings.format().ending == '\0';
}

/// A length in mm without needless digits.
QString length(double mm) {
    return appearance::shown_number(in_hundredths(mm));
}

QString duration(double seconds) {
    if (seconds < 59.95) return tr("%1 s").arg(appearance::shown_number(seconds, 1));
    const auto whole = static_cast<long long>(std::llround(seconds));
    if (whole < 3600) return tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
    return tr("%1 h %2 min").arg(whole / 3600).arg(whole / 60 % 60);
}

QString picture_words(const grid::Shape& size, const recordings::ExportedCells& cells, double scale) {
    return tr("%1 × %2 pixels for %3 × %4 mm, which is %5 pixels per inch.")
        .arg(size.width)
        .arg(size.height)
        .arg(length(cells.shape.width * cells.cell_mm), length(cells.shape.height * cells.cell_mm))
        .arg(std::lround(scale / cells.cell_mm * core::kInch_mm));
}

QString map_words(const grid::Shape& size, const Path& path) {
    const auto files = recordings::map_paths(path);
    return tr("Four files of %1 × %2 pixels, %3 to %4.")
        .arg(size.width)
        .arg(size.height)
        .arg(QString::fromStdString(files.front().filename().string()),
             QString::fromStdString(files.back().filename().string()));
}

QString relief_words(const grid::Shape& size, const recordings::ExportedCells& cells) {
    const double width_mm = cells.shape.width * cells.cell_mm;
    return tr("A solid of %1 × %2 mm; its front has %3 × %4 points, %5 mm apart.")
        .arg(length(width_mm), length(cells.shape.height * cells.cell_mm))
        .arg(size.width)
        .arg(size.height)
        .arg(length(width_mm / (size.width - 1)));
}

QString film_words(const grid::Shape& size, const ExportSubject& subject,
                   const recordings::TimelapseChoice& choice) {
    const double painted_s = static_cast<double>(subject.film.end_tick) * document::kTick_s;
    const std::int64_t frames = recordings::frame_count(subject.film, choice);
    return tr("%1 of painting become %2 of film: %n frame(s) of %3 × %4 pixels.", nullptr,
              static_cast<int>(frames))
        .arg(duration(painted_s), duration(static_cast<double>(frames) / choice.fps))
        .arg(size.width)
        .arg(size.height);
}

/// Asked as io asks it of files.
void check_folder(const Path& folder) {
    const std::string name = folder.filename().string();
    if (!core::is_there(folder)) return files::check_writable(folder);
    if (!core::is_folder(folder))
        throw core::InputError("%1 is a file; numbered pictures go into a folder.", name);
    if (core::is_there(folder / "frame-00001.png"))
        throw core::InputError("The folder %1 holds the frames of another time-lapse; name another one.",
                               name);
    files::check_writable(folder / "frame-00001.png");
}

void check_timelapse(const ExportSubject& subject, const ExportSettings& settings,
                     const recordings::TimelapseChoice& choice) {
    if (!subject.has_strokes)
        throw core::InputError("Nothing has been painted yet that a film could show.");
    recordings::check_timelapse(choice);
    document::check_canvas_fits(film_canvas(subject, settings), core::available_memory_bytes());
    if (is_folder_format(settings)) check_folder(choice.path);
}

void check_path(const Path& path) {
    if (path.empty()) throw core::InputError("The file needs a name.");
    if (!core::is_folder(path.parent_path()))
        throw core::InputError("There is no folder %1.", path.parent_path().string());
}

}  // namespace

document::CanvasSettings film_canvas(const ExportSubject& subject, const ExportSettings& settings) {
    document::CanvasSettings canvas = subject.film.canvas;
    if (settings.film_px_per_mm > 0.0) canvas.px_per_mm = settings.film_px_per_mm;
    return canvas;
}

grid::Shape exported_size(const ExportSubject& subject, const ExportSettings& settings,
                          const Path& path) {
    if (settings.form == ExportForm::Timelapse)
        return recordings::timelapse_size(subject.film.canvas,
                                          tools::timelapse_choice(settings, path, subject.light));
    return recordings::export_size(subject.canvas, tools::export_choice(settings, path, subject.light));
}

QString export_summary(const ExportSubject& subject, const ExportSettings& settings, const Path& path) {
    check_path(path);
    if (settings.form == ExportForm::Timelapse) {
        const recordings::TimelapseChoice choice =
            tools::timelapse_choice(settings, path, subject.light);
        check_timelapse(subject, settings, choice);
        return film_words(exported_size(subject, settings, path), subject, choice);
    }
    const recordings::ExportChoice choice = tools::export_choice(settings, path, subject.light);
    recordings::check_export(choice);
    const grid::Shape size = recordings::export_size(subject.canvas, choice);
    const recordings::ExportedCells cells = recordings::exported_cells(subject.canvas, choice);
    if (settings.form == ExportForm::Relief) return relief_words(size, cells);
    if (settings.form == ExportForm::Maps) return map_words(size, path);
    return picture_words(size, cells, settings.scale);
}

}  // namespace pastoso::dialogs
