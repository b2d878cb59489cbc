// A liquid in place of the canvas: it comes and goes while the painting waits, and pictures of it and
// its surface are taken along. What the modes of the glass of tea and of the tank have in common.
#pragma once

#include "glass/glass_page.hpp"
#include "glass/liquid_picture_dialog.hpp"
#include "liquid_files/mesh_export.hpp"
#include "main/canvas/canvas_place.hpp"
#include "main/files/background_export.hpp"
#include "session/liquid_picture.hpp"

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>

#include <QObject>

namespace pastoso::main {

class PictureLayers;

/// Which mode it is, and the commands that each mode has of its own.
struct GlassCommands {
    commands::Mode mode;
    commands::Command enter, render;
};

/// What a mode calls its liquid.
struct GlassWords {
    QString name;  ///< in the window's title, and of a picture's layer on the canvas
    glass::LiquidPictureWords picture;
    QString export_title, export_file;
    QString exported;  ///< a sentence with %1 for the file
};

class GlassMode : public QObject {
    Q_OBJECT
  public:
    ~GlassMode() override;

    bool active() const { return active_; }
    void enter();
    void leave();

    /// Whether it has been entered: before, there is nothing of the liquid.
    bool ready() const { return ready_; }
    // There are none before that.
    virtual session::LiquidSession& session() = 0;
    virtual glass::GlassPage& page() = 0;

    /// Writes the liquid's surface as it is seen now, in the background; how it ends is told. Throws
    /// core::InputError when the name is none of a surface.
    void export_mesh(const QString& path);
    bool exporting() const { return export_.busy(); }

    /// Where a picture is rendered; it is made when it is first wanted.
    glass::LiquidPictureDialog& picture();

  protected:
    using MeshWriter = std::function<files::ExportStatus(const std::filesystem::path& file,
                                                      const BackgroundExport::Stops& stops)>;

    GlassMode(Studio& studio, PictureLayers& pictures, CanvasPlace& place, const GlassCommands& commands,
              GlassWords words);

    /// Afterwards there are a page and a session.
    virtual void make_ready() = 0;
    virtual void put_away();

    // Of the moment that is seen now; nothing before the first.
    virtual MeshWriter mesh_writer() const = 0;
    virtual session::LiquidPictureOrder picture_order() const = 0;

    Studio& studio() { return studio_; }
    QAction* action(commands::Command command) const { return studio_.commands().action(command); }
    glass::GlassActions page_actions() const;
    BackgroundExport& background() { return export_; }

    /// What a command does while the mode is there.
    void on_here(commands::Command command, std::function<void(bool)> what);

    /// Puts a new page into the window. The arrows do what their commands say while its view has the
    /// keyboard; elsewhere they go from value to value.
    void add_page(std::initializer_list<commands::Command> arrows);

    /// From a pause: what the hand does now is to be seen.
    void go_on();

    /// Tells what was refused since the last call; whether anything was.
    bool tell_refusals();

    /// Whether time passes, and how fast: scrubbing pauses.
    void show_running(const session::LiquidStatus& status);

  private:
    void connect_commands();
    void ask_export();

    Studio& studio_;
    PictureLayers& pictures_;
    CanvasPlace& place_;
    const GlassCommands commands_;
    const GlassWords words_;
    std::unique_ptr<glass::LiquidPictureDialog> picture_;
    bool active_ = false, ready_ = false;
    bool paused_ = false;  ///< as the hand left it
    BackgroundExport export_;
};

}  // namespace pastoso::main
