// The window: puts its parts together. Each part has a header of its own and works on what they share,
// the Studio.
#pragma once

#include "commands/exporter.hpp"
#include "commands/project_saver.hpp"
#include "main/panel_set.hpp"
#include "main/program/kept_preferences.hpp"
#include "main/studio.hpp"
#include "tools/export_settings.hpp"

#include <filesystem>
#include <memory>

#include <QMainWindow>

namespace pastoso::main {

class TankMode;
class TeaMode;

class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    /// Throws core::InputError when there can be no such canvas. What is painted is kept on the disk as
    /// it happens, to be recovered, unless `keeps_journal` says otherwise. What of the preferences holds
    /// for the whole program is in use already.
    explicit MainWindow(const document::CanvasSettings& canvas, bool keeps_journal = true,
                        const KeptPreferences& preferences = kept_preferences());
    ~MainWindow() override;

    /// Puts up another canvas with the same tools. Throws core::InputError and keeps the old one when it
    /// cannot.
    void new_canvas(const document::CanvasSettings& canvas);

    /// Puts up the painting in a project file, as it was; a file of any other name as open_picture()
    /// does. Throws core::InputError and keeps the old one when it cannot.
    void open_painting(const QString& path);

    /// Puts up a new canvas with a picture or the layers of an OpenRaster file as dry paint, which has
    /// no file yet. Throws core::InputError and keeps the old painting when it cannot.
    void open_picture(const QString& path);

    /// Puts a picture onto the canvas as a layer of dry paint, in the middle and as large as it fits.
    /// Throws core::InputError when it is none.
    void paint_picture(const QString& path);

    /// Lays a picture below the paint to be traced, in the middle and as large as it fits. Throws
    /// core::InputError when it is none.
    void trace_picture(const QString& path);

    /// Writes the painting to a project file, in the background. From now on that is its file.
    void save_painting(const QString& path);

    /// Puts up a painting that a program left unfinished; its journal then goes. Throws core::InputError
    /// and keeps both the old painting and the journal when it cannot.
    void recover_painting(const std::filesystem::path& journal);

    /// Asks what to do with unfinished paintings, if there are any.
    void offer_recovery();

    /// Shows the start page over the canvas.
    void show_start_page();

    /// What meets the painter at the start: the page, or unfinished paintings alone where the painter
    /// does not want it.
    void welcome();

    /// Puts up the recording's canvas and paints on it what was recorded.
    void replay(const document::Recording& recording);

    session::PaintSession& session() { return studio_.session(); }
    tools::Easel& easel() { return studio_.easel(); }
    view::CanvasView& canvas() { return studio_.canvas(); }
    view::CanvasView& well() { return studio_.well(); }
    commands::CommandRegistry& commands() { return studio_.commands(); }
    commands::Exporter& exporter();
    commands::ProjectSaver& project_saver();

    /// As the parts say of them: Exporting, LightChoice, PaintMemory.
    void export_painting(const tools::ExportSettings& settings, const std::filesystem::path& path);
    void use_light(const QString& name_or_path);
    void use_space(pigment::WorkingSpace space);
    void open_palette(const QString& path);

    /// The glass of tea that can stand in place of the canvas.
    TeaMode& tea();
    /// The tank that can.
    TankMode& tank();

    /// As Studio::measure().
    void measure(std::shared_ptr<session::FrameTimes> times);

  protected:
    void closeEvent(QCloseEvent* event) override;

  private:
    struct Parts;

    Studio studio_;
    const PanelSet panels_;
    std::unique_ptr<Parts> parts_;
};

}  // namespace pastoso::main
