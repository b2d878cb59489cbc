// Draws a moment of the glass of tea.
#pragma once

#include "glass/liquid_renderer.hpp"
#include "session/tea_session.hpp"

#include <array>
#include <memory>
#include <vector>

namespace pastoso::glass {

class TeaRenderer : public LiquidRenderer {
  public:
    void initialise(QOpenGLExtraFunctions* gl) override;
    void release() override;

    /// What draw() shows from now on.
    void show(const session::TeaSnapshot& snapshot);

    void draw(QOpenGLFramebufferObject& target, const QRect& part, const GlassCamera& camera, int pass,
              Quality quality) override;

  private:
    /// A field as a texture, in the unit of its number.
    struct FieldTexture {
        GLuint texture = 0;
        grid::BoxShape shape;
    };

    void upload(int unit, const grid::BoxField& field);
    void bind_field(int unit);
    void set_cup(QOpenGLShaderProgram& program) const;
    void set_stream(QOpenGLShaderProgram& program) const;
    void set_jug(QOpenGLShaderProgram& program, const liquid::MilkStream* stream) const;
    void light_tea(const grid::BoxShape& cells);
    void set_glass(const GlassCamera& camera, QSize size, int pass, Quality quality);

    QOpenGLExtraFunctions* gl_ = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> program_, light_program_;
    GLuint empty_array_ = 0, light_target_ = 0;
    /// The milk's share, its depths to the lamp and the level, and the light that arrives.
    std::array<FieldTexture, 4> fields_;
    liquid::Cup cup_;  ///< filled as it is seen
    float box_m_ = 0.1F;
    std::vector<liquid::MilkStream> streams_;
    glm::vec3 milk_low_m_{0.0F}, milk_high_m_{0.0F};
};

}  // namespace pastoso::glass
