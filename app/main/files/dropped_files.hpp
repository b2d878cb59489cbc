// Files that are dragged onto the window from elsewhere.
#pragma once

#include "main/studio.hpp"

#include <QObject>
#include <QPoint>
#include <QString>

namespace pastoso::main {

class PictureLayers;
class ProjectFiles;
class ReferenceCommands;
class TracingCommands;

/// A painting or a recording is put up; of a picture the painter says what becomes of it.
class DroppedFiles : public QObject {
    Q_OBJECT
  public:
    DroppedFiles(Studio& studio, ProjectFiles& files, PictureLayers& pictures, TracingCommands& tracing,
                 ReferenceCommands& references);

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    void take(const QString& path, const QPoint& screen_place);
    void ask_about_picture(const QString& path, const QPoint& screen_place);

    Studio& studio_;
    ProjectFiles& files_;
    PictureLayers& pictures_;
    TracingCommands& tracing_;
    ReferenceCommands& references_;
};

}  // namespace pastoso::main
