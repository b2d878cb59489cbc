// The glass of milk tea in place of the canvas: it comes and goes, and the painting waits.
#pragma once

#include "main/background_export.hpp"
#include "main/canvas_place.hpp"
#include "session/tea_session.hpp"

#include <memory>

#include <QObject>

namespace pastoso::tea {
class TeaPage;
class LiquidPictureDialog;
}  // namespace pastoso::tea

namespace pastoso::main {

class PictureLayers;

class TeaMode : public QObject {
    Q_OBJECT
  public:
    TeaMode(Studio& studio, PictureLayers& pictures, CanvasPlace& place);
    ~TeaMode() override;

    bool active() const { return active_; }

    void enter();
    void leave();

    /// There are none before the first enter().
    session::TeaSession& session() { return *session_; }
    tea::TeaPage& page() { return *page_; }

    /// Another glass with the numbers of a file, and the numbers of this one into a file. Throw
    /// core::InputError.
    void open_scene(const QString& path);
    void save_scene(const QString& path) const;

    /// Writes the milk's surface as it is seen now, in the background; how it ends is told.
    void export_mesh(const QString& path);
    bool exporting() const { return export_.busy(); }

    /// Where a picture is rendered; it is made when it is first wanted.
    tea::LiquidPictureDialog& picture();

  Q_SIGNALS:
    /// Something else shall be in the glass, as GlassChooser::chosen().
    void other_wanted(const QString& key);

  private:
    void connect_commands();
    void connect_force();
    void make_page();
    void put_away();
    void show_published();
    void use_force(const session::TeaForce& force);
    void move_axis(double right, double away);
    void ask_open();
    void ask_save();
    void ask_export();
    void try_to(const QString& title, const std::function<void()>& what);

    Studio& studio_;
    PictureLayers& pictures_;
    CanvasPlace& place_;
    tea::TeaPage* page_ = nullptr;
    tea::LiquidPictureDialog* picture_ = nullptr;
    std::unique_ptr<session::TeaSession> session_;
    session::TeaForce force_;
    bool active_ = false, paused_ = false;
    BackgroundExport export_;
};

}  // namespace pastoso::main
