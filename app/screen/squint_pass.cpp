#include "screen/squint_pass.hpp"

#include "graphics/finish_shader.hpp"
#include "graphics/graphics_fault.hpp"
#include "screen/squint.hpp"

#include <QPoint>

namespace pastoso::screen {
namespace {

// The numbers are those of squint.hpp and of the curve of sRGB (pigment/colour.hpp).
const char* const kSquintGather = R"(#version 330 core
uniform sampler2D picture;
uniform int side;
out vec4 colour;

vec3 decode_srgb(vec3 encoded) {
    return mix(encoded / 12.92, pow((encoded + 0.055) / 1.055, vec3(2.4)), greaterThan(encoded, vec3(0.04045)));
}

void main() {
    ivec2 last = textureSize(picture, 0) - 1;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            vec4 here = texelFetch(picture, min(side * ivec2(gl_FragCoord.xy) + ivec2(x, y), last), 0);
            sum += vec4(decode_srgb(here.rgb), here.a);
        }
    colour = sum / float(side * side);
}
)";

const char* const kSquintBlur = R"(#version 330 core
uniform sampler2D picture;
uniform ivec2 along;
uniform float weights[32];
uniform int reach;
uniform float contrast;  // 0: light is left as light
out vec4 colour;

vec3 encode_srgb(vec3 light) {
    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, greaterThan(light, vec3(0.0031308)));
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(picture, 0) - 1;
    vec4 sum = weights[0] * texelFetch(picture, here, 0);
    for (int i = 1; i <= reach; ++i)
        sum += weights[i] * (texelFetch(picture, clamp(here - i * along, ivec2(0), last), 0) +
                             texelFetch(picture, clamp(here + i * along, ivec2(0), last), 0));
    colour = contrast > 0.0 ? vec4(0.5 + contrast * (encode_srgb(sum.rgb) - 0.5), sum.a) : sum;
}
)";

const char* const kSquintSpread = R"(#version 330 core
uniform sampler2D picture;
uniform int side;
out vec4 colour;
void main() {
    colour = texture(picture, gl_FragCoord.xy / (float(side) * vec2(textureSize(picture, 0))));
}
)";

int squares_of(int pixels) {
    return (pixels + kSquintSquare_px - 1) / kSquintSquare_px;
}

std::unique_ptr<QOpenGLFramebufferObject> target_of(const QSize& size, GLenum format) {
    return std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::NoAttachment,
                                                      GL_TEXTURE_2D, format);
}

}  // namespace

void SquintPass::initialise(QOpenGLExtraFunctions* gl) {
    gl_ = gl;
    gl_->glGenVertexArrays(1, &vertex_array_);
}

void SquintPass::release() {
    for (Program* program : {&gather_, &blur_, &spread_})
        program->reset();
    for (Target* target : {&squares_, &spare_, &picture_})
        target->reset();
    if (gl_ != nullptr) gl_->glDeleteVertexArrays(1, &vertex_array_);
    vertex_array_ = 0;
}

void SquintPass::prepare(const QSize& size) {
    if (gather_ == nullptr) {
        gather_ = graphics::shader_program(graphics::kCoveringVertexShader, kSquintGather);
        blur_ = graphics::shader_program(graphics::kCoveringVertexShader, kSquintBlur);
        spread_ = graphics::shader_program(graphics::kCoveringVertexShader, kSquintSpread);
    }
    if (picture_ != nullptr && picture_->size() == size) return;
    const QSize squares(squares_of(size.width()), squares_of(size.height()));
    squares_ = target_of(squares, GL_RGBA16F);
    spare_ = target_of(squares, GL_RGBA16F);
    picture_ = target_of(size, GL_RGBA16);
}

/// The program is bound already.
void SquintPass::draw(QOpenGLShaderProgram& program, GLuint texture, QOpenGLFramebufferObject& target) {
    target.bind();
    gl_->glViewport(0, 0, target.width(), target.height());
    gl_->glDisable(GL_BLEND);
    gl_->glDisable(GL_DEPTH_TEST);
    gl_->glActiveTexture(GL_TEXTURE0);
    gl_->glBindTexture(GL_TEXTURE_2D, texture);
    program.setUniformValue("picture", 0);
    gl_->glBindVertexArray(vertex_array_);
    gl_->glDrawArrays(GL_TRIANGLES, 0, 3);
    gl_->glBindVertexArray(0);
    program.release();
}

void SquintPass::blur(GLuint squares, const QPoint& step, double blur_px, bool encodes, Target& target) {
    const std::vector<float> weights = squint_weights(blur_px);
    blur_->bind();
    gl_->glUniform2i(blur_->uniformLocation("along"), step.x(), step.y());
    blur_->setUniformValueArray("weights", weights.data(), static_cast<int>(weights.size()), 1);
    blur_->setUniformValue("reach", static_cast<int>(weights.size()) - 1);
    blur_->setUniformValue("contrast", encodes ? static_cast<float>(kSquintContrast) : 0.0F);
    draw(*blur_, squares, *target);
}

GLuint SquintPass::squinted(GLuint picture, const QSize& size, double blur_px) {
    prepare(size);
    gather_->bind();
    gather_->setUniformValue("side", kSquintSquare_px);
    draw(*gather_, picture, *squares_);
    blur(squares_->texture(), QPoint(1, 0), blur_px, false, spare_);
    blur(spare_->texture(), QPoint(0, 1), blur_px, true, squares_);
    spread_->bind();
    spread_->setUniformValue("side", kSquintSquare_px);
    gl_->glBindTexture(GL_TEXTURE_2D, squares_->texture());
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl_->glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    for (const GLenum edge : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        gl_->glTexParameteri(GL_TEXTURE_2D, edge, GL_CLAMP_TO_EDGE);
    draw(*spread_, squares_->texture(), *picture_);
    return picture_->texture();
}

}  // namespace pastoso::screen
