// Files that are dragged onto the window from elsewhere.
#pragma once

#include "main/studio.hpp"

#include <QObject>
#include <QPoint>
#include <QStringList>

namespace pastoso::main {

class NewWindow;
class PictureLayers;
class ProjectFiles;
class ReferenceCommands;
class TracingCommands;

/// A painting or a recording is put up, and of several each other one in a window of its own; of
/// pictures the painter says what becomes of them, once for all that are dropped together.
class DroppedFiles : public QObject {
    Q_OBJECT
  public:
    DroppedFiles(Studio& studio, ProjectFiles& files, PictureLayers& pictures, TracingCommands& tracing,
                 ReferenceCommands& references, NewWindow& new_window);

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    void take(const QStringList& paths, const QPoint& screen_place);
    void put_up(const QString& path);
    void ask_about(const QStringList& pictures, const QPoint& screen_place);

    Studio& studio_;
    ProjectFiles& files_;
    PictureLayers& pictures_;
    TracingCommands& tracing_;
    ReferenceCommands& references_;
    NewWindow& new_window_;
};

}  // namespace pastoso::main
