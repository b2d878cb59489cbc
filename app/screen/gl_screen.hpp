// A canvas drawn by the graphics card: what changed is brought onto it, shaded there and kept.
#pragma once

#include "graphics/graphics_widget.hpp"
#include "screen/canvas_screen.hpp"
#include "screen/gl_overlay.hpp"
#include "screen/outline_squares.hpp"
#include "screen/picture_buffer.hpp"
#include "screen/shading_plan.hpp"
#include "screen/shading_timer.hpp"
#include "screen/texture_upload.hpp"

#include <chrono>
#include <deque>
#include <optional>

#include <QTimer>

namespace pastoso::screen {

class GlScreen : public graphics::GraphicsWidget, public CanvasScreen {
    Q_OBJECT
  public:
    GlScreen(ScreenHost& host, QWidget& parent);
    ~GlScreen() override;

    QWidget& widget() override { return *this; }
    void refresh() override;
    void begin_other_canvas() override;
    void damage_all() override;
    bool finished() const override;
    const document::Snapshot* shown() const override { return shown_.get(); }
    QImage picture() override { return grabFramebuffer(); }
    QOpenGLWidget* opengl() override { return this; }

  protected:
    void make_graphics() override;
    void free_graphics() override;
    void paintGL() override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void draw_frame();
    void finish_picture();
    QSize window_px() const;
    void move_picture(const ViewTransform& from, const QRect& window);
    void ask_presenter();
    void take_presentation(std::chrono::microseconds patience);
    void upload_changes();
    bool begin_upload();
    void note_outlines(const Presentation& done, QRegion& changed);
    void finish_upload(QRegion& changed);
    void drop_textures();
    grid::Rect cells_to_outline(const Sight& sight) const;
    QRegion outlined_region() const;
    void show_heights(const std::vector<LookPatch>& patches, bool begins);
    void shade_job(const ShadingPlan::Job& job);

    ScreenHost& host_;
    CanvasPresenter presenter_;
    std::deque<Presentation> presentations_;  ///< made, and not on their way to the textures yet
    TextureUpload upload_;
    OutlineSquares outlines_;
    CanvasTextures textures_;
    PictureBuffer picture_;
    ShadingTimer timer_;
    GlOverlay overlay_;
    ShadingPlan plan_;
    QTimer cooling_;

    Sight drawn_;                   ///< what the textures hold, while there is shown_
    grid::Rect outlined_;           ///< cells whose outlines they hold
    std::optional<Sight> asked_;    ///< that they will hold when all that was asked for is there
    grid::Rect asked_outlined_;     ///< as well
    bool outdated_ = false;         ///< what is being made is about textures that are no more
    std::optional<Sight> refused_;  ///< of which no presentation could be made
    std::shared_ptr<const document::Snapshot> shown_;
    std::shared_ptr<const document::Snapshot> seen_;  ///< shown_ with what is traced below it
    std::optional<ViewTransform> drawn_from_;         ///< that the picture was shaded from
    double highest_mm_ = 0.0;                         ///< of the paint, while heights are shown
    double scale_top_mm_ = 1.0;
};

}  // namespace pastoso::screen
