#include "glass/tea_renderer.hpp"

#include "glass/ray_shaders.hpp"
#include "glass/tea_shader.hpp"
#include "liquid/tea/jug_shape.hpp"
#include "liquid/tea/stream_mesh.hpp"
#include "trace/tea_scene.hpp"

#include <algorithm>

#include <QVector2D>
#include <QVector4D>
#include <glm/geometric.hpp>

namespace pastoso::glass {
namespace {

enum Unit { kShareUnit, kToLampUnit, kToLevelUnit, kLightUnit };
constexpr int kDraftSteps = 40, kFullSteps = 80;  ///< of the march through the tea

/// In which a stream with its jug lies.
QVector4D ball_around(const liquid::MilkStream& stream, const liquid::Cup& cup) {
    const liquid::JugPlace jug = liquid::jug_place(stream, cup);
    const liquid::TurnedPoint& bottom = liquid::jug_profile().back();
    const glm::vec3 low(stream.at_m, stream.low_m), high = jug.mouth_m + bottom.z_m * jug.axis;
    float widest_m = stream.lip_radius_m;
    for (const liquid::TurnedPoint& point : liquid::jug_profile())
        widest_m = std::max(widest_m, point.radius_m);
    const glm::vec3 middle = 0.5F * (low + high);
    return {middle.x, middle.y, middle.z, 0.5F * glm::distance(low, high) + widest_m};
}

}  // namespace

void TeaRenderer::initialise(QOpenGLExtraFunctions* gl) {
    gl_ = gl;
    program_ = ray_program(QByteArray(kCupShader) + kTeaShader);
    light_program_ = graphics::shader_program(kRayVertexShader,
                                              QByteArray(kLightShader) + kCupShader + kTeaLightShader);
    gl_->glGenVertexArrays(1, &empty_array_);
    gl_->glGenFramebuffers(1, &light_target_);
    for (FieldTexture& field : fields_) {
        gl_->glGenTextures(1, &field.texture);
        field.shape = {};
    }
}

void TeaRenderer::release() {
    program_.reset();
    light_program_.reset();
    if (gl_ == nullptr) return;
    gl_->glDeleteVertexArrays(1, &empty_array_);
    gl_->glDeleteFramebuffers(1, &light_target_);
    for (FieldTexture& field : fields_)
        gl_->glDeleteTextures(1, &field.texture);
    gl_ = nullptr;
}

void TeaRenderer::show(const session::TeaSnapshot& snapshot) {
    cup_ = snapshot.cup();
    box_m_ = static_cast<float>(snapshot.settings.box_m);
    streams_ = snapshot.seen.pour.streams;
    milk_low_m_ = snapshot.milk_low_m;
    milk_high_m_ = snapshot.milk_high_m;
    upload(kShareUnit, snapshot.milk_share);
    upload(kToLampUnit, snapshot.to_lamp_m);
    upload(kToLevelUnit, snapshot.to_level_m);
    light_tea(snapshot.to_lamp_m.shape());
}

void TeaRenderer::upload(int unit, const grid::BoxField& field) {
    FieldTexture& shown = fields_[static_cast<std::size_t>(unit)];
    const grid::BoxShape& shape = field.shape();
    gl_->glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    upload_volume(*gl_, shown.texture, volume_of(field), shape != shown.shape);
    shown.shape = shape;
}

void TeaRenderer::bind_field(int unit) {
    gl_->glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl_->glBindTexture(GL_TEXTURE_3D, fields_[static_cast<std::size_t>(unit)].texture);
}

void TeaRenderer::set_cup(QOpenGLShaderProgram& program) const {
    program.setUniformValue("axis_m", QVector2D(cup_.axis_m.x, cup_.axis_m.y));
    program.setUniformValue("floor_m", cup_.floor_m);
    program.setUniformValue("floor_radius_m", cup_.floor_radius_m);
    program.setUniformValue("slope", cup_.slope);
    program.setUniformValue("level_m", cup_.level_m);
    program.setUniformValue("wall_m", cup_.wall_m);
    program.setUniformValue("foot_m", cup_.foot_m);
    program.setUniformValue("rim_m", cup_.rim_m);
    program.setUniformValue("box_m", box_m_);
}

/// Layer by layer, once for each moment: every ray that comes by finds it.
void TeaRenderer::light_tea(const grid::BoxShape& cells) {
    FieldTexture& light = fields_[kLightUnit];
    bind_field(kLightUnit);
    if (cells != light.shape) {
        gl_->glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA16F, cells.nx, cells.ny, cells.nz, 0, GL_RGBA,
                          GL_FLOAT, nullptr);
        set_interpolation(*gl_);
        light.shape = cells;
    }
    light_program_->bind();
    set_cup(*light_program_);
    for (const int unit : {kToLampUnit, kToLevelUnit})
        bind_field(unit);
    light_program_->setUniformValue("to_lamp_m", static_cast<GLint>(kToLampUnit));
    light_program_->setUniformValue("to_level_m", static_cast<GLint>(kToLevelUnit));
    gl_->glBindFramebuffer(GL_FRAMEBUFFER, light_target_);
    gl_->glViewport(0, 0, cells.nx, cells.ny);
    gl_->glDisable(GL_DEPTH_TEST);
    gl_->glDisable(GL_BLEND);
    gl_->glBindVertexArray(empty_array_);
    for (int layer = 0; layer < cells.nz; ++layer) {
        gl_->glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, light.texture, 0, layer);
        light_program_->setUniformValue(
            "layer", (static_cast<float>(layer) + 0.5F) / static_cast<float>(cells.nz));
        gl_->glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl_->glBindVertexArray(0);
    light_program_->release();
}

void TeaRenderer::set_glass(const GlassCamera& camera, QSize size, int pass, Quality quality) {
    QOpenGLShaderProgram& glass = *program_;
    set_rays(glass, camera, size, pass);
    set_cup(glass);
    glass.setUniformValue("table_m", trace::Table{}.height_m);
    glass.setUniformValue("march_steps", quality == Quality::Draft ? kDraftSteps : kFullSteps);
    glass.setUniformValue("milk_low_m", vector(milk_low_m_));
    glass.setUniformValue("milk_high_m", vector(milk_high_m_));
    glass.setUniformValue("milk_share", static_cast<GLint>(kShareUnit));
    glass.setUniformValue("light_in_tea", static_cast<GLint>(kLightUnit));
    set_stream(glass);
}

/// Of two streams the hand's.
void TeaRenderer::set_stream(QOpenGLShaderProgram& program) const {
    const bool flows = !streams_.empty();
    const liquid::MilkStream stream = flows ? streams_.back() : liquid::MilkStream{};
    const trace::LevelDent dent = flows ? trace::stream_dent(stream, cup_.level_m) : trace::LevelDent{};
    program.setUniformValue("stream_at_m", QVector2D(stream.at_m.x, stream.at_m.y));
    program.setUniformValue("stream_lip_m", stream.lip_m);
    program.setUniformValue("stream_high_m", stream.high_m);
    program.setUniformValue("stream_low_m", stream.low_m);
    program.setUniformValue("stream_lip_m_s", stream.lip_speed_m_s);
    program.setUniformValue("stream_lip_radius_m", stream.lip_radius_m);
    program.setUniformValue("stream_end_height", liquid::kStreamEndHeight);
    program.setUniformValue("gravity_m_s2", static_cast<float>(liquid::kFreeFall_m_s2));
    program.setUniformValue("dent_m", dent.depth_m);
    program.setUniformValue("dent_radius_m", dent.radius_m);
    set_jug(program, flows && liquid::is_held(stream) ? &stream : nullptr);
    program.setUniformValue("pour_ball", flows ? ball_around(stream, cup_) : QVector4D());
}

/// Null: of none.
void TeaRenderer::set_jug(QOpenGLShaderProgram& program, const liquid::MilkStream* stream) const {
    std::vector<QVector4D> profile;
    if (stream != nullptr)
        for (const liquid::TurnedPoint& point : liquid::jug_profile())
            profile.emplace_back(point.radius_m, point.z_m, point.normal.x, point.normal.y);
    program.setUniformValue("jug_points", static_cast<GLint>(profile.size()));
    if (stream == nullptr) return;
    const liquid::JugPlace jug = liquid::jug_place(*stream, cup_);
    program.setUniformValueArray("jug_profile", profile.data(), static_cast<int>(profile.size()));
    program.setUniformValue("jug_mouth_m", vector(jug.mouth_m));
    program.setUniformValue("jug_axis", vector(jug.axis));
    program.setUniformValue("jug_colour", vector(trace::kJugReflectance));
    program.setUniformValue("jug_milk", QVector2D(liquid::kJugMilkRadius_m, liquid::kJugMilkDepth_m));
}

void TeaRenderer::draw(QOpenGLFramebufferObject& target, const QRect& part, const GlassCamera& camera,
                       int pass, Quality quality) {
    program_->bind();
    set_glass(camera, target.size(), pass, quality);
    for (const int unit : {kShareUnit, kLightUnit})
        bind_field(unit);
    draw_rays(*gl_, target, part, pass, empty_array_);
    program_->release();
}

}  // namespace pastoso::glass
