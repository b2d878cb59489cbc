// Draws a moment of the glass of tea.
#pragma once

#include "glass/liquid_renderer.hpp"
#include "session/tea_session.hpp"

#include <memory>

namespace pastoso::glass {

class TeaRenderer : public LiquidRenderer {
  public:
    void initialise(QOpenGLExtraFunctions* gl) override;
    void release() override;

    /// What draw() shows from now on.
    void show(const session::TeaSnapshot& snapshot);

    /// Milk is drawn anew when the camera or the moment is another than before, or all of it when
    /// `target` has another size.
    void draw(QOpenGLFramebufferObject& target, const QRect& part, const GlassCamera& camera, int pass,
              Quality quality) override;

  private:
    void upload_milk(const liquid::TriangleMesh& milk);
    void upload_share(const grid::BoxField& dissolved);
    void draw_milk(QSize size, const GlassCamera& camera);
    void set_glass(const GlassCamera& camera, QSize size, int pass, Quality quality);

    QOpenGLExtraFunctions* gl_ = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> milk_program_, glass_program_;
    std::unique_ptr<QOpenGLFramebufferObject> milk_layer_;
    GLuint milk_array_ = 0, empty_array_ = 0, positions_ = 0, normals_ = 0, indices_ = 0, share_ = 0;
    grid::BoxShape share_shape_;
    GLsizei index_count_ = 0;
    bool milk_is_drawn_ = false;
    GlassCamera milk_camera_;
    liquid::TeaSettings settings_;
    std::optional<glm::vec2> stream_m_;
};

}  // namespace pastoso::glass
