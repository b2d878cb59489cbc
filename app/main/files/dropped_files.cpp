#include "main/files/dropped_files.hpp"

#include "main/files/picture_files.hpp"
#include "main/files/project_files.hpp"
#include "main/layers/picture_layers.hpp"
#include "main/layers/tracing_commands.hpp"
#include "main/program/new_window.hpp"
#include "main/references/reference_commands.hpp"

#include <functional>
#include <utility>

#include <QDropEvent>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMimeData>
#include <QUrl>

namespace pastoso::main {
namespace {

/// Those on this machine.
QStringList dragged_files(const QDropEvent& event) {
    QStringList paths;
    for (const QUrl& url : event.mimeData()->urls())
        if (url.isLocalFile()) paths.push_back(url.toLocalFile());
    return paths;
}

QString ending_of(const QString& path) {
    return QFileInfo(path).suffix().toLower();
}

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

}  // namespace

DroppedFiles::DroppedFiles(Studio& studio, ProjectFiles& files, PictureLayers& pictures,
                           TracingCommands& tracing, ReferenceCommands& references,
                           NewWindow& new_window)
    : studio_(studio),
      files_(files),
      pictures_(pictures),
      tracing_(tracing),
      references_(references),
      new_window_(new_window) {
    studio_.window().setAcceptDrops(true);
    studio_.window().installEventFilter(this);
}

/// Questions come once the drag is over: whoever drags waits for its end.
bool DroppedFiles::eventFilter(QObject* object, QEvent* event) {
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
        return QObject::eventFilter(object, event);
    auto& drag = static_cast<QDropEvent&>(*event);
    const QStringList paths = dragged_files(drag);
    if (paths.isEmpty()) return QObject::eventFilter(object, event);
    drag.setDropAction(Qt::CopyAction);
    drag.accept();
    if (event->type() == QEvent::Drop) {
        const QPoint place = studio_.window().mapToGlobal(drag.position().toPoint());
        QMetaObject::invokeMethod(
            this, [this, paths, place] { take(paths, place); }, Qt::QueuedConnection);
    }
    return true;
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
    bool taken = !pictures.isEmpty();
    for (const QString& path : put_up_files)
        if (std::exchange(taken, true))
            new_window_.open(path);
        else
            put_up(path);
    if (!pictures.isEmpty()) ask_about(pictures, screen_place);
}

void DroppedFiles::put_up(const QString& path) {
    if (is_recording(path))
        files_.ask_to_watch(path.toStdString());
    else
        files_.ask_to_open(path);
}

/// Only one can be traced, or become a canvas.
void DroppedFiles::ask_about(const QStringList& pictures, const QPoint& screen_place) {
    auto* menu = new QMenu(&studio_.window());
    menu->setObjectName(QStringLiteral("dropped_picture"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto add = [&](const QString& words, const std::function<void()>& work) {
        menu->addAction(words, this, work);
    };
    const bool one = pictures.size() == 1;
    add(one ? tr("Put it on a &layer, as dry paint") : tr("Put each on a &layer, as dry paint"),
        [this, pictures] { pictures_.paint_pictures(pictures); });
    if (one)
        add(tr("&Trace it, below the paint"),
            [this, path = pictures.front()] { tracing_.trace_picture(path); });
    add(one ? tr("&Keep it beside the canvas, as a reference")
            : tr("&Keep them beside the canvas, as references"),
        [this, pictures] { references_.add_files(pictures); });
    if (one)
        add(tr("&New canvas made of it"), [this, path = pictures.front()] { files_.ask_to_open(path); });
    menu->addSeparator();
    menu->addAction(one ? tr("Leave it") : tr("Leave them"));
    menu->popup(screen_place);
}

}  // namespace pastoso::main
