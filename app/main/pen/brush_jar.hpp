// The jar of brushes: the bundled ones and the painter's own, kept, renamed and thrown away.
#pragma once

#include "brush/preset_library.hpp"
#include "main/studio.hpp"
#include "session/thumbnail_painter.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace pastoso::panels {
class BrushPanel;
class CurvesPanel;
}  // namespace pastoso::panels

namespace pastoso::main {

class BrushJar : public QObject {
    Q_OBJECT
  public:
    BrushJar(Studio& studio, panels::BrushPanel* brushes, panels::CurvesPanel* curves);

    /// Where the painter's own are; empty where there is no home.
    static std::filesystem::path folder();

    /// Reads the files and lists what can be taken.
    void read();

    const brush::PresetLibrary& library() const { return library_; }

    /// The tool in hand as it is kept, or itself where it is kept nowhere.
    brush::Preset kept_brush() const;

    /// As a click in the list does. Nothing where there is no such tool.
    void take(const QString& name);

  Q_SIGNALS:
    void renamed(const std::string& before, const std::string& now);

  protected:
    bool eventFilter(QObject* window, QEvent* event) override;

  private:
    void make_thumbnails();
    void reread();
    void list();
    void show(const tools::Hand& hand);
    void take_brush(const QString& name, double width_mm);
    bool own_brush_in_hand() const;
    void save_brush();
    void rename_brush();
    void delete_brush();
    std::optional<QString> asked_name(const QString& title, const QString& name);
    bool confirmed(const QString& question, const QString& action);

    Studio& studio_;
    panels::BrushPanel* brushes_;
    panels::CurvesPanel* curves_;
    std::unique_ptr<session::ThumbnailPainter> thumbnails_;
    brush::PresetLibrary library_;
    QFileSystemWatcher files_;
    QTimer files_changed_;  ///< soon after the files
};

}  // namespace pastoso::main
