// The window: puts session, easel, canvas and panels together and connects them.
#pragma once

#include "commands/command_registry.hpp"
#include "commands/picture_saver.hpp"
#include "document/events.hpp"
#include "session/paint_session.hpp"
#include "session/thumbnail_painter.hpp"
#include "tools/easel.hpp"
#include "view/canvas_view.hpp"

#include <memory>

#include <QMainWindow>

class QComboBox;
class QDockWidget;

namespace pastoso::panels {
class BrushPanel;
class EaselPanel;
class MixPanel;
class PaintPanel;
class StatusReadings;
}  // namespace pastoso::panels

namespace pastoso::main {

class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    /// Throws core::InputError when there can be no such canvas.
    explicit MainWindow(const document::CanvasSettings& canvas);
    ~MainWindow() override;

    /// Puts up another canvas with the same tools. Throws core::InputError and keeps the old one when it
    /// cannot.
    void new_canvas(const document::CanvasSettings& canvas);

    /// Puts up the recording's canvas and paints on it what was recorded.
    void replay(const document::Recording& recording);

    session::PaintSession& session() { return *session_; }
    tools::Easel& easel() { return *easel_; }
    view::CanvasView& canvas() { return *canvas_; }
    view::CanvasView& well() { return *well_; }
    commands::CommandRegistry& commands() { return commands_; }
    commands::PictureSaver& saver() { return saver_; }

    void save_picture(const QString& path);

    /// Shows the painting in a bundled light, by name, or in that of a CSV file
    /// (pigment/illuminant.hpp). What is none is told, and the light stays.
    void use_light(const QString& name_or_path);

  protected:
    void closeEvent(QCloseEvent* event) override;

  private:
    void start_session(const document::CanvasSettings& canvas);
    void lay_out();
    void make_tool_bar();
    void make_panels();
    panels::BrushPanel* make_brush_panel();
    void connect_panels();
    void connect_mixing();
    void connect_canvas();
    void connect_commands();
    void connect_file_commands();
    void make_well_panel();
    void connect_well();
    void show_published();
    void show_well(const document::Snapshot& painting);
    void show_hand();
    void set_symmetry(bool mirror, int count);  ///< about the middle of the canvas
    void lay_ruler(bool lies);
    void show_paint(const document::PaintRecipe& paint);
    void show_enabled(const session::Status& status);
    bool may_discard();
    void ask_new_canvas();
    void ask_light();
    void ask_save_picture();
    void ask_save_recording();
    void report(const QString& sentence);

    commands::CommandRegistry commands_;
    commands::PictureSaver saver_;
    std::unique_ptr<tools::Easel> easel_;
    std::unique_ptr<session::PaintSession> session_;
    std::unique_ptr<session::ThumbnailPainter> thumbnails_;
    std::int64_t saved_strokes_ = 0;
    QString light_ = QStringLiteral("D65");
    view::CanvasView* canvas_ = nullptr;
    view::CanvasView* well_ = nullptr;
    std::shared_ptr<const document::Snapshot> shown_well_;
    QDockWidget* well_panel_ = nullptr;
    panels::BrushPanel* brushes_ = nullptr;
    panels::PaintPanel* paints_ = nullptr;
    panels::MixPanel* mixing_ = nullptr;
    document::PaintRecipe picked_, nearest_;  ///< the last picked colour and its closest recipe
    panels::EaselPanel* stand_ = nullptr;
    panels::StatusReadings* readings_ = nullptr;
    QComboBox* medium_ = nullptr;
};

}  // namespace pastoso::main
