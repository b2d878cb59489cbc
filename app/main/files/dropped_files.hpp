// What is dragged onto the window from elsewhere: files, pictures and paint.
#pragma once

#include "main/studio.hpp"

#include <functional>

#include <QImage>
#include <QObject>
#include <QPoint>
#include <QStringList>

class QDropEvent;

namespace pastoso::main {

class Clipboard;
class NewWindow;
class PictureLayers;
class ProjectFiles;
class ReferenceCommands;
class TracingCommands;

/// A painting or a recording is put up, and of several each other one in a window of its own, of many
/// once the painter has agreed; of pictures the painter says what becomes of them, once for all that are
/// dropped together. So it is with one that has no file, such as a browser's. Paint of another window is
/// pasted where it was dropped.
class DroppedFiles : public QObject {
    Q_OBJECT
  public:
    DroppedFiles(Studio& studio, ProjectFiles& files, PictureLayers& pictures, Clipboard& clipboard,
                 TracingCommands& tracing, ReferenceCommands& references, NewWindow& new_window);

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    /// What can become of pictures; a null is not offered.
    struct Uses {
        std::function<void()> layer, trace, reference, canvas;
    };

    void drop(const QDropEvent& event);
    void take(const QStringList& paths, const QPoint& screen_place);
    void take(const QImage& picture, const QPoint& screen_place);
    void put_up_all(QStringList paths, bool first_is_for_here);
    bool wants_windows(int count);
    void put_up(const QString& path);
    Uses uses_of(const QStringList& pictures);
    Uses uses_of(const QImage& picture);
    void ask_about(const Uses& uses, bool one, const QPoint& screen_place);

    Studio& studio_;
    ProjectFiles& files_;
    PictureLayers& pictures_;
    Clipboard& clipboard_;
    TracingCommands& tracing_;
    ReferenceCommands& references_;
    NewWindow& new_window_;
};

}  // namespace pastoso::main
