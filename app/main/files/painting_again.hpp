// Painting the painting again on finer cells, and what becomes of that.
#pragma once

#include "core/worker.hpp"
#include "main/files/background_export.hpp"
#include "main/studio.hpp"
#include "session/repainter.hpp"

#include <memory>
#include <string>

#include <QObject>
#include <QPointer>

namespace pastoso::main {

class LightChoice;
class ProjectFiles;
class RepaintWindow;

class PaintingAgain : public QObject {
    Q_OBJECT
  public:
    PaintingAgain(Studio& studio, ProjectFiles& files, const LightChoice& light);

    /// Null while none is open.
    RepaintWindow* window() const;

    /// In the background: a painting, or a picture of it in the light that it is seen in, as the name
    /// ends.
    void save(std::shared_ptr<const project::Project> painted, const QString& path);
    bool is_saving() const { return saving_.busy(); }

    /// Whether the main window may close as far as this is concerned.
    bool may_stop();
    /// Gives up what is painted.
    void stop();

  private:
    void ask();
    void start(const document::Recording& strokes, const std::string& name);
    void ask_save(const std::shared_ptr<const project::Project>& painted);
    void end_saving(const QString& told, bool is_kept);
    void put_up(const std::shared_ptr<const project::Project>& painted);

    Studio& studio_;
    ProjectFiles& files_;
    const LightChoice& light_;
    BackgroundExport saving_;
    core::Worker<std::unique_ptr<session::Repainter>> ending_;  ///< those whose window is closed
    QPointer<QObject> window_;
};

}  // namespace pastoso::main
