// The tank of liquid in place of the canvas.
#pragma once

#include "glass/tank_page.hpp"
#include "main/liquids/glass_mode.hpp"
#include "main/liquids/tank_recorder.hpp"
#include "session/tank_session.hpp"

namespace pastoso::main {

class TankMode : public GlassMode {
    Q_OBJECT
  public:
    TankMode(Studio& studio, PictureLayers& pictures, CanvasPlace& place);

    session::TankSession& session() override { return *session_; }
    glass::TankPage& page() override { return *page_; }

    /// As GlassChooser::chosen(); what cannot be opened is told.
    void choose(const QString& key);
    /// Another tank: the name of one that comes with the program, or a file. Throws core::InputError.
    void open_scene(const QString& path_or_name);

    /// The surfaces of all moments that are kept into FOLDER/liquid_0001.obj and so on, as
    /// export_mesh().
    void export_all(const QString& folder);

    /// From now on every moment goes into the folder, until the command is given again, the tank is left
    /// or a file cannot be written.
    void record(Recorded what, const QString& folder);

    const TankRecorder& recorder() const { return *recorder_; }

    /// A ball of liquid falls there from the top.
    void drop_ball(const glm::vec2& at_m);

  Q_SIGNALS:
    void tea_wanted();

  private:
    static GlassWords words();

    void make_ready() override;
    void put_away() override;
    MeshWriter mesh_writer() const override;
    session::LiquidPictureOrder picture_order() const override;

    void connect_commands();
    void connect_wind();
    void make_page();
    void begin_session();
    void show_published();
    void show_tank(const session::TankStatus& status);
    void use_wind(const session::TankWind& wind);
    void turn_wind(double by_deg);
    void blow_harder(double by_m_s);
    void ask_open();
    void ask_export_all();
    void ask_record(Recorded what);
    void show_recorded();

    glass::TankPage* page_ = nullptr;
    std::unique_ptr<session::TankSession> session_;
    std::unique_ptr<TankRecorder> recorder_;  ///< as long as the session
    tank::TankScene scene_;                   ///< as it begins
    QString key_;                             ///< of the chooser
    session::TankWind wind_;
    int shown_glass_ = 0;
};

}  // namespace pastoso::main
