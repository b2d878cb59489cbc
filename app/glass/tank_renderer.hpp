// Draws a moment of a tank.
#pragma once

#include "glass/liquid_renderer.hpp"
#include "session/tank_session.hpp"

#include <memory>

namespace pastoso::glass {

class TankRenderer : public LiquidRenderer {
  public:
    void initialise(QOpenGLExtraFunctions* gl) override;
    void release() override;

    /// What draw() shows from now on.
    void show(std::shared_ptr<const session::TankSnapshot> snapshot);

    void draw(QOpenGLFramebufferObject& target, const QRect& part, const GlassCamera& camera, int pass,
              Quality quality) override;

  private:
    void upload_level(bool anew);
    void upload_solids(const tank::Domain& domain);

    QOpenGLExtraFunctions* gl_ = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> program_;
    GLuint empty_array_ = 0, level_ = 0, solids_ = 0, milk_ = 0;
    std::shared_ptr<const session::TankSnapshot> snapshot_;
    bool has_milk_ = false, has_solids_ = false;
};

}  // namespace pastoso::glass
