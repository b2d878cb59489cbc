// Draws a moment of a tank with OpenGL 3.3.
#pragma once

#include "session/tank_session.hpp"
#include "tea/ray_program.hpp"

#include <memory>

namespace pastoso::tea {

/// All calls need the current context that initialise() was called in.
class TankRenderer {
  public:
    /// Throws core::InputError when the driver refuses the program.
    void initialise(QOpenGLExtraFunctions* gl);
    void release();

    /// What draw() shows from now on.
    void show(std::shared_ptr<const session::TankMoment> moment);

    /// As draw_rays().
    void draw(QOpenGLFramebufferObject& target, const QRect& part, const TeaCamera& camera, int pass,
              Quality quality);

  private:
    void upload_level(bool anew);
    void upload_solids(const tank::Room& room);

    QOpenGLExtraFunctions* gl_ = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> program_;
    GLuint empty_array_ = 0, level_ = 0, solids_ = 0, milk_ = 0;
    std::shared_ptr<const session::TankMoment> moment_;
    bool has_milk_ = false, has_solids_ = false;
};

}  // namespace pastoso::tea
