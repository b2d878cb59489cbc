#include "glass/tea_renderer.hpp"

#include "glass/tea_shaders.hpp"

#include <QVector2D>
#include <QVector4D>
#include <glm/geometric.hpp>

namespace pastoso::glass {
namespace {

constexpr int kShareUnit = 0, kLayerUnit = 1;
constexpr int kDraftSteps = 20, kFullSteps = 32;  ///< of the march through the tea

}  // namespace

void TeaRenderer::initialise(QOpenGLExtraFunctions* gl) {
    gl_ = gl;
    milk_program_ = shader_program(kMilkVertexShader, kMilkFragmentShader);
    glass_program_ = ray_program(kGlassFragmentShader);
    gl_->glGenVertexArrays(1, &empty_array_);
    gl_->glGenVertexArrays(1, &milk_array_);
    gl_->glGenBuffers(1, &positions_);
    gl_->glGenBuffers(1, &normals_);
    gl_->glGenBuffers(1, &indices_);
    gl_->glBindVertexArray(milk_array_);
    GLuint index = 0;
    for (const GLuint buffer : {positions_, normals_}) {
        gl_->glBindBuffer(GL_ARRAY_BUFFER, buffer);
        gl_->glEnableVertexAttribArray(index);
        gl_->glVertexAttribPointer(index++, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    }
    gl_->glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    gl_->glBindVertexArray(0);
    gl_->glBindBuffer(GL_ARRAY_BUFFER, 0);
    gl_->glGenTextures(1, &share_);
    share_shape_ = {};
}

void TeaRenderer::release() {
    milk_program_.reset();
    glass_program_.reset();
    milk_layer_.reset();
    if (gl_ == nullptr) return;
    gl_->glDeleteVertexArrays(1, &empty_array_);
    gl_->glDeleteVertexArrays(1, &milk_array_);
    for (GLuint* buffer : {&positions_, &normals_, &indices_})
        gl_->glDeleteBuffers(1, buffer);
    gl_->glDeleteTextures(1, &share_);
    gl_ = nullptr;
}

void TeaRenderer::show(const session::TeaSnapshot& snapshot) {
    settings_ = snapshot.settings;
    stream_m_ = snapshot.stream_m;
    upload_milk(snapshot.milk);
    upload_share(snapshot.seen.dissolved);
    milk_is_drawn_ = false;
}

void TeaRenderer::upload_milk(const liquid::TriangleMesh& milk) {
    const auto upload = [this](GLenum target, GLuint buffer, const auto& values) {
        gl_->glBindBuffer(target, buffer);
        gl_->glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(values[0])),
                          values.data(), GL_STREAM_DRAW);
    };
    gl_->glBindVertexArray(milk_array_);
    upload(GL_ARRAY_BUFFER, positions_, milk.positions_m);
    upload(GL_ARRAY_BUFFER, normals_, milk.normals);
    upload(GL_ELEMENT_ARRAY_BUFFER, indices_, milk.triangles);
    gl_->glBindVertexArray(0);
    gl_->glBindBuffer(GL_ARRAY_BUFFER, 0);
    index_count_ = static_cast<GLsizei>(3 * milk.triangles.size());
}

/// Straight from the field's rows, which are longer than the box.
void TeaRenderer::upload_share(const grid::BoxField& dissolved) {
    const grid::BoxShape& shape = dissolved.shape();
    gl_->glActiveTexture(GL_TEXTURE0 + kShareUnit);
    upload_volume(
        *gl_, share_,
        {dissolved.row(0, 0), shape.nx, shape.ny, shape.nz, shape.stride_y(), shape.stride_z()},
        shape != share_shape_);
    share_shape_ = shape;
}

void TeaRenderer::draw_milk(QSize size, const GlassCamera& camera) {
    if (milk_layer_ == nullptr || milk_layer_->size() != size) {
        QOpenGLFramebufferObjectFormat format;
        format.setInternalTextureFormat(GL_RGBA16F);
        format.setAttachment(QOpenGLFramebufferObject::Depth);
        milk_layer_ = std::make_unique<QOpenGLFramebufferObject>(size, format);
    } else if (milk_is_drawn_ && camera == milk_camera_) {
        return;
    }
    milk_is_drawn_ = true;
    milk_camera_ = camera;
    milk_layer_->bind();
    gl_->glViewport(0, 0, size.width(), size.height());
    gl_->glDisable(GL_BLEND);
    gl_->glEnable(GL_DEPTH_TEST);
    gl_->glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl_->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    milk_program_->bind();
    const float aspect = static_cast<float>(size.width()) / static_cast<float>(size.height());
    milk_program_->setUniformValue("clip_from_m", matrix(camera.clip_from_m(aspect)));
    milk_program_->setUniformValue("eye_m", vector(camera.eye_m()));
    milk_program_->setUniformValue("forward", vector(camera.forward()));
    milk_program_->setUniformValue("focus_m", glm::length(camera.target_m() - camera.eye_m()));
    gl_->glBindVertexArray(milk_array_);
    if (index_count_ > 0) gl_->glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    gl_->glBindVertexArray(0);
    milk_program_->release();
    gl_->glDisable(GL_DEPTH_TEST);
}

void TeaRenderer::set_glass(const GlassCamera& camera, QSize size, int pass, Quality quality) {
    QOpenGLShaderProgram& glass = *glass_program_;
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
    glass.setUniformValue("milk_share", kShareUnit);
    glass.setUniformValue("milk_layer", kLayerUnit);
    const glm::vec2 at = stream_m_.value_or(cup.axis_m);
    glass.setUniformValue("stream",
                          QVector4D(at.x, at.y, static_cast<float>(0.55 * settings_.pour_radius_m),
                                    stream_m_ ? 1.0F : 0.0F));
}

void TeaRenderer::draw(QOpenGLFramebufferObject& target, const QRect& part, const GlassCamera& camera,
                       int pass, Quality quality) {
    const QSize size = target.size();
    draw_milk(size, camera);
    glass_program_->bind();
    set_glass(camera, size, pass, quality);
    gl_->glActiveTexture(GL_TEXTURE0 + kLayerUnit);
    gl_->glBindTexture(GL_TEXTURE_2D, milk_layer_->texture());
    gl_->glActiveTexture(GL_TEXTURE0 + kShareUnit);
    gl_->glBindTexture(GL_TEXTURE_3D, share_);
    draw_rays(*gl_, target, part, pass, empty_array_);
    glass_program_->release();
}

}  // namespace pastoso::glass
