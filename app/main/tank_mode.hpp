// The tank of liquid in place of the canvas.
#pragma once

#include "main/background_export.hpp"
#include "main/canvas_place.hpp"
#include "main/tank_recorder.hpp"
#include "session/tank_session.hpp"

#include <memory>

namespace pastoso::tea {
class LiquidPictureDialog;
class TankPage;
}  // namespace pastoso::tea

namespace pastoso::main {

class PictureLayers;

class TankMode : public QObject {
    Q_OBJECT
  public:
    TankMode(Studio& studio, PictureLayers& pictures, CanvasPlace& place);
    ~TankMode() override;

    bool active() const { return active_; }
    void enter();
    void leave();

    /// There are none before the first enter().
    session::TankSession& session() { return *session_; }
    tea::TankPage& page() { return *page_; }

    /// As GlassChooser::chosen(); what cannot be opened is told.
    void choose(const QString& key);
    /// Another tank: the name of one that comes with the program, or a file. Throws core::InputError.
    void open_scene(const QString& path_or_name);

    /// Writes the liquid's surface as it is seen now, in the background; how it ends is told.
    void export_mesh(const QString& path);
    /// The same of every moment that is kept, into FOLDER/liquid_0001.obj and so on.
    void export_all(const QString& folder);
    bool exporting() const { return export_.busy(); }

    /// From now on every moment goes into the folder, until the command is given again, the tank is left
    /// or a file cannot be written.
    void record(Recorded what, const QString& folder);

    const TankRecorder& recorder() const { return *recorder_; }

    /// Where a picture is rendered; it is made when it is first wanted.
    tea::LiquidPictureDialog& picture();

    /// A ball of liquid falls there from the top.
    void drop_ball(const glm::vec2& at_m);

  Q_SIGNALS:
    void tea_wanted();

  private:
    void connect_commands();
    void connect_exports();
    void connect_wind();
    void on_here(commands::Command command, std::function<void(bool)> what);
    void make_page();
    void begin_session();
    void put_away();
    void show_published();
    void show_tank(const session::TankStatus& status);
    void use_wind(const session::TankWind& wind);
    void turn_wind(double by_deg);
    void blow_harder(double by_m_s);
    void ask_open();
    void ask_export();
    void ask_export_all();
    void ask_record(Recorded what);
    void show_recorded();

    Studio& studio_;
    PictureLayers& pictures_;
    CanvasPlace& place_;
    tea::TankPage* page_ = nullptr;
    tea::LiquidPictureDialog* picture_ = nullptr;
    std::unique_ptr<session::TankSession> session_;
    std::unique_ptr<TankRecorder> recorder_;  ///< as long as the session
    tank::TankScene scene_;                   ///< as it begins
    QString key_;                             ///< of the chooser
    session::TankWind wind_;
    int shown_glass_ = 0;
    bool active_ = false, paused_ = false;
    BackgroundExport export_;
};

}  // namespace pastoso::main
