#include "main/files/dropped_files.hpp"

#include "main/files/picture_files.hpp"
#include "main/files/project_files.hpp"
#include "main/layers/picture_layers.hpp"
#include "main/layers/tracing_commands.hpp"
#include "main/references/reference_commands.hpp"

#include <QDropEvent>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMimeData>
#include <QUrl>

namespace pastoso::main {
namespace {

/// Of the first file; empty where there is none on this machine.
QString dragged_file(const QDropEvent& event) {
    for (const QUrl& url : event.mimeData()->urls())
        if (url.isLocalFile()) return url.toLocalFile();
    return {};
}

bool is_picture(const QString& ending) {
    return picture_endings().split(QLatin1Char(' ')).contains(QStringLiteral("*.") + ending);
}

}  // namespace

DroppedFiles::DroppedFiles(Studio& studio, ProjectFiles& files, PictureLayers& pictures,
                           TracingCommands& tracing, ReferenceCommands& references)
    : studio_(studio), files_(files), pictures_(pictures), tracing_(tracing), references_(references) {
    studio_.window().setAcceptDrops(true);
    studio_.window().installEventFilter(this);
}

/// Questions come once the drag is over: whoever drags waits for its end.
bool DroppedFiles::eventFilter(QObject* object, QEvent* event) {
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
        return QObject::eventFilter(object, event);
    auto& drag = static_cast<QDropEvent&>(*event);
    const QString path = dragged_file(drag);
    if (path.isEmpty()) return QObject::eventFilter(object, event);
    drag.setDropAction(Qt::CopyAction);
    drag.accept();
    if (event->type() == QEvent::Drop) {
        const QPoint place = studio_.window().mapToGlobal(drag.position().toPoint());
        QMetaObject::invokeMethod(
            this, [this, path, place] { take(path, place); }, Qt::QueuedConnection);
    }
    return true;
}

void DroppedFiles::take(const QString& path, const QPoint& screen_place) {
    const QString ending = QFileInfo(path).suffix().toLower();
    studio_.window().activateWindow();
    if (ending == QStringLiteral("pastoso") || ending == QStringLiteral("ora"))
        files_.ask_to_open(path);
    else if (ending == QStringLiteral("json"))
        files_.ask_to_watch(path.toStdString());
    else if (is_picture(ending))
        ask_about_picture(path, screen_place);
    else
        studio_.report(
            tr("%1 is no painting and no picture that can be opened.").arg(QFileInfo(path).fileName()));
}

void DroppedFiles::ask_about_picture(const QString& path, const QPoint& screen_place) {
    auto* menu = new QMenu(&studio_.window());
    menu->setObjectName(QStringLiteral("dropped_picture"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto add = [&](const QString& words, const std::function<void()>& work) {
        menu->addAction(words, this, work);
    };
    add(tr("Put it on a &layer, as dry paint"), [this, path] { pictures_.paint_picture(path); });
    add(tr("&Trace it, below the paint"), [this, path] { tracing_.trace_picture(path); });
    add(tr("&Keep it beside the canvas, as a reference"),
        [this, path] { references_.add_files({path}); });
    add(tr("&New canvas made of it"), [this, path] { files_.ask_to_open(path); });
    menu->addSeparator();
    menu->addAction(tr("Leave it"));
    menu->popup(screen_place);
}

}  // namespace pastoso::main
