// The glass of milk tea in place of the canvas.
#pragma once

#include "glass/tea_page.hpp"
#include "main/liquids/glass_mode.hpp"
#include "session/tea_session.hpp"

namespace pastoso::main {

class TeaMode : public GlassMode {
    Q_OBJECT
  public:
    TeaMode(Studio& studio, PictureLayers& pictures, CanvasPlace& place);

    session::TeaSession& session() override { return *session_; }
    glass::TeaPage& page() override { return *page_; }

    /// Another glass with the numbers of a file, or of a scene that comes with the program, into which
    /// its milk is poured; and the numbers of this one into a file. Throw core::InputError.
    void open_scene(const QString& path_or_name);
    void save_scene(const QString& path) const;

  Q_SIGNALS:
    /// Something else shall be in the glass, as GlassChooser::chosen().
    void other_wanted(const QString& key);

  private:
    static GlassWords words();

    void make_ready() override;
    void put_away() override;
    MeshWriter mesh_writer() const override;
    session::LiquidPictureOrder picture_order() const override;

    void connect_commands();
    void connect_force();
    void make_page();
    void show_published();
    void use_force(const session::TeaForce& force);
    void pour_recipe(bool pours);
    void move_axis(double right, double away);
    void try_to_open(const QString& path_or_name);
    void ask_open();
    void ask_save();

    glass::TeaPage* page_ = nullptr;
    std::unique_ptr<session::TeaSession> session_;
    session::TeaForce force_;
};

}  // namespace pastoso::main
