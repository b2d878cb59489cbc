#include "glass/tea_renderer.hpp"

#include "glass/tea_shaders.hpp"

#include <QVector2D>
#include <QVector4D>

namespace pastoso::glass {
namespace {

enum Unit { kShareUnit, kToLampUnit, kToLevelUnit };
constexpr int kDraftSteps = 40, kFullSteps = 80;  ///< of the march through the tea

}  // namespace

void TeaRenderer::initialise(QOpenGLExtraFunctions* gl) {
    gl_ = gl;
    program_ = ray_program(kGlassFragmentShader);
    gl_->glGenVertexArrays(1, &empty_array_);
    for (FieldTexture& field : fields_) {
        gl_->glGenTextures(1, &field.texture);
        field.shape = {};
    }
}

void TeaRenderer::release() {
    program_.reset();
    if (gl_ == nullptr) return;
    gl_->glDeleteVertexArrays(1, &empty_array_);
    for (FieldTexture& field : fields_)
        gl_->glDeleteTextures(1, &field.texture);
    gl_ = nullptr;
}

void TeaRenderer::show(const session::TeaSnapshot& snapshot) {
    settings_ = snapshot.settings;
    stream_m_ = snapshot.stream_m;
    upload(kShareUnit, snapshot.milk_share);
    upload(kToLampUnit, snapshot.to_lamp_m);
    upload(kToLevelUnit, snapshot.to_level_m);
}

void TeaRenderer::upload(int unit, const grid::BoxField& field) {
    FieldTexture& shown = fields_[static_cast<std::size_t>(unit)];
    const grid::BoxShape& shape = field.shape();
    gl_->glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    upload_volume(*gl_, shown.texture, volume_of(field), shape != shown.shape);
    shown.shape = shape;
}

void TeaRenderer::set_glass(const GlassCamera& camera, QSize size, int pass, Quality quality) {
    QOpenGLShaderProgram& glass = *program_;
    const liquid::Cup& cup = settings_.cup;
    set_rays(glass, camera, size, pass);
    glass.setUniformValue("axis_m", QVector2D(cup.axis_m.x, cup.axis_m.y));
    glass.setUniformValue("floor_m", cup.floor_m);
    glass.setUniformValue("floor_radius_m", cup.floor_radius_m);
    glass.setUniformValue("slope", cup.slope);
    glass.setUniformValue("level_m", cup.level_m);
    glass.setUniformValue("wall_m", cup.wall_m);
    glass.setUniformValue("foot_m", cup.foot_m);
    glass.setUniformValue("rim_m", cup.rim_m);
    glass.setUniformValue("box_m", static_cast<float>(settings_.box_m));
    glass.setUniformValue("table_m", trace::Table{}.height_m);
    glass.setUniformValue("march_steps", quality == Quality::Draft ? kDraftSteps : kFullSteps);
    glass.setUniformValue("milk_share", static_cast<GLint>(kShareUnit));
    glass.setUniformValue("to_lamp_m", static_cast<GLint>(kToLampUnit));
    glass.setUniformValue("to_level_m", static_cast<GLint>(kToLevelUnit));
    const glm::vec2 at = stream_m_.value_or(cup.axis_m);
    glass.setUniformValue("stream",
                          QVector4D(at.x, at.y, static_cast<float>(0.55 * settings_.pour_radius_m),
                                    stream_m_ ? 1.0F : 0.0F));
}

void TeaRenderer::draw(QOpenGLFramebufferObject& target, const QRect& part, const GlassCamera& camera,
                       int pass, Quality quality) {
    program_->bind();
    set_glass(camera, target.size(), pass, quality);
    for (std::size_t unit = 0; unit < fields_.size(); ++unit) {
        gl_->glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        gl_->glBindTexture(GL_TEXTURE_3D, fields_[unit].texture);
    }
    draw_rays(*gl_, target, part, pass, empty_array_);
    program_->release();
}

}  // namespace pastoso::glass
