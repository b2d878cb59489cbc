#include "main/files/dropped_files.hpp"

#include "appearance/picture_view.hpp"
#include "main/files/picture_files.hpp"
#include "main/files/project_files.hpp"
#include "main/layers/clipboard.hpp"
#include "main/layers/copied_mime.hpp"
#include "main/layers/picture_layers.hpp"
#include "main/layers/tracing_commands.hpp"
#include "main/program/new_window.hpp"
#include "main/references/reference_commands.hpp"

#include <functional>
#include <optional>
#include <utility>

#include <QDropEvent>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>

namespace pastoso::main {
namespace {

QString ending_of(const QString& path) {
    return QFileInfo(path).suffix().toLower();
}

/// More are opened by mistake, and each takes memory and threads.
constexpr int kFewWindows = 5;

bool is_recording(const QString& path) {
    return ending_of(path) == QStringLiteral("json");
}

bool is_put_up(const QString& path) {
    const QString ending = ending_of(path);
    return ending == QStringLiteral("pastoso") || ending == QStringLiteral("ora") || is_recording(path);
}

bool is_picture(const QString& path) {
    return picture_endings().split(QLatin1Char(' ')).contains(QStringLiteral("*.") + ending_of(path));
}

/// Where that is on the canvas; nothing beside it.
std::optional<glm::dvec2> place_on(const view::CanvasView& canvas, const QPoint& screen_place) {
    const QPoint position = canvas.mapFromGlobal(screen_place);
    if (!canvas.rect().contains(position)) return {};
    return canvas.canvas_mm(position);
}

/// From elsewhere: what this program drags belongs where it is from.
bool can_take(const QDropEvent& event) {
    const QMimeData& data = *event.mimeData();
    return event.source() == nullptr &&
           (data.hasFormat(kPaintFormat) || data.hasImage() || !local_files(data).isEmpty());
}

}  // namespace

DroppedFiles::DroppedFiles(Studio& studio, ProjectFiles& files, PictureLayers& pictures,
                           Clipboard& clipboard, TracingCommands& tracing, ReferenceCommands& references,
                           NewWindow& new_window)
    : studio_(studio),
      files_(files),
      pictures_(pictures),
      clipboard_(clipboard),
      tracing_(tracing),
      references_(references),
      new_window_(new_window) {
    studio_.window().setAcceptDrops(true);
    studio_.window().installEventFilter(this);
}

bool DroppedFiles::eventFilter(QObject* object, QEvent* event) {
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
        return QObject::eventFilter(object, event);
    auto& drag = static_cast<QDropEvent&>(*event);
    if (!can_take(drag)) return QObject::eventFilter(object, event);
    drag.setDropAction(Qt::CopyAction);
    drag.accept();
    if (event->type() == QEvent::Drop) drop(drag);
    return true;
}

/// Questions come once the drag is over: whoever drags waits for its end.
void DroppedFiles::drop(const QDropEvent& event) {
    const QMimeData& data = *event.mimeData();
    const QPoint place = studio_.window().mapToGlobal(event.position().toPoint());
    const QStringList paths = local_files(data);
    const auto later = [this](const std::function<void()>& work) {
        QMetaObject::invokeMethod(this, work, Qt::QueuedConnection);
    };
    if (data.hasFormat(kPaintFormat))
        clipboard_.paste_dragged(data, place_on(studio_.canvas(), place));
    else if (!paths.isEmpty())
        later([this, paths, place] { take(paths, place); });
    else if (const auto image = qvariant_cast<QImage>(data.imageData()); !image.isNull())
        later([this, image, place] { take(image, place); });
    else
        studio_.report(tr("There is no picture in it that can be read."));
}

void DroppedFiles::take(const QImage& picture, const QPoint& screen_place) {
    studio_.window().activateWindow();
    ask_about(uses_of(picture), true, screen_place);
}

/// Pictures are for the canvas that they were dropped on: where there are any, it stays.
void DroppedFiles::take(const QStringList& paths, const QPoint& screen_place) {
    studio_.window().activateWindow();
    QStringList put_up_files, pictures;
    for (const QString& path : paths) {
        if (is_put_up(path))
            put_up_files.push_back(path);
        else if (is_picture(path))
            pictures.push_back(path);
        else
            studio_.report(tr("%1 is no painting and no picture that can be opened.")
                               .arg(QFileInfo(path).fileName()));
    }
    put_up_all(put_up_files, pictures.isEmpty());
    if (!pictures.isEmpty()) ask_about(uses_of(pictures), pictures.size() == 1, screen_place);
}

void DroppedFiles::put_up_all(QStringList paths, bool first_is_for_here) {
    const QString here = first_is_for_here && !paths.isEmpty() ? paths.takeFirst() : QString();
    const bool all_wanted = paths.size() <= kFewWindows || wants_windows(static_cast<int>(paths.size()));
    if (!here.isEmpty()) put_up(here);
    if (!all_wanted) return;
    for (const QString& path : paths)
        new_window_.open(path);
}

bool DroppedFiles::wants_windows(int count) {
    QMessageBox question(
        QMessageBox::Question, tr("Pastoso"),
        tr("Each of the other files opens in a window of its own. Open %1 more windows?").arg(count),
        QMessageBox::Cancel, &studio_.window());
    QPushButton* open = question.addButton(tr("Open them"), QMessageBox::AcceptRole);
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    return question.clickedButton() == open;
}

void DroppedFiles::put_up(const QString& path) {
    if (is_recording(path))
        files_.ask_to_watch(path.toStdString());
    else
        files_.ask_to_open(path);
}

/// Only one can be traced, or become a canvas.
DroppedFiles::Uses DroppedFiles::uses_of(const QStringList& pictures) {
    Uses uses{.layer = [this, pictures] { pictures_.paint_pictures(pictures); },
              .trace = {},
              .reference = [this, pictures] { references_.add_files(pictures); },
              .canvas = {}};
    if (pictures.size() > 1) return uses;
    uses.trace = [this, path = pictures.front()] { tracing_.trace_picture(path); };
    uses.canvas = [this, path = pictures.front()] { files_.ask_to_open(path); };
    return uses;
}

DroppedFiles::Uses DroppedFiles::uses_of(const QImage& picture) {
    return {
        .layer = [this,
                  picture] { pictures_.paint_picture(appearance::picture_of(picture), tr("Picture")); },
        .trace = [this, picture] { tracing_.trace_picture(appearance::picture_of(picture)); },
        .reference = [this, picture] { references_.add_picture(picture); },
        .canvas = {}};
}

void DroppedFiles::ask_about(const Uses& uses, bool one, const QPoint& screen_place) {
    auto* menu = new QMenu(&studio_.window());
    menu->setObjectName(QStringLiteral("dropped_picture"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto add = [&](const QString& words, const std::function<void()>& work) {
        if (work) menu->addAction(words, this, work);
    };
    add(one ? tr("Put it on a &layer, as dry paint") : tr("Put each on a &layer, as dry paint"),
        uses.layer);
    add(tr("&Trace it, below the paint"), uses.trace);
    add(one ? tr("&Keep it beside the canvas, as a reference")
            : tr("&Keep them beside the canvas, as references"),
        uses.reference);
    add(tr("&New canvas made of it"), uses.canvas);
    menu->addSeparator();
    menu->addAction(one ? tr("Leave it") : tr("Leave them"));
    menu->popup(screen_place);
}

}  // namespace pastoso::main
