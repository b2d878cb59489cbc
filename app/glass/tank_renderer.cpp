#include "glass/tank_renderer.hpp"

#include "glass/tank_shader.hpp"
#include "trace/tank_scene.hpp"

#include <algorithm>

namespace pastoso::glass {
namespace {

constexpr int kLevelUnit = 0, kSolidsUnit = 1, kMilkUnit = 2;
constexpr int kDraftSteps = 60, kFullSteps = 140;  ///< of a ray between two surfaces

}  // namespace

void TankRenderer::initialise(QOpenGLExtraFunctions* gl) {
    gl_ = gl;
    program_ = ray_program(kTankShader);
    gl_->glGenVertexArrays(1, &empty_array_);
    for (GLuint* texture : {&level_, &solids_, &milk_})
        gl_->glGenTextures(1, texture);
    snapshot_.reset();
}

void TankRenderer::release() {
    program_.reset();
    if (gl_ == nullptr) return;
    gl_->glDeleteVertexArrays(1, &empty_array_);
    for (GLuint* texture : {&level_, &solids_, &milk_})
        gl_->glDeleteTextures(1, texture);
    gl_ = nullptr;
}

void TankRenderer::upload_level(bool anew) {
    const liquid::SampledField& level_m = snapshot_->far_m;
    const liquid::Lattice& lattice = level_m.lattice();
    upload_volume(
        *gl_, level_,
        {level_m.row(0, 0), lattice.nx, lattice.ny, lattice.nz, level_m.stride_y(), level_m.stride_z()},
        anew);
}

/// At the same points as the level: the middles of the cells, and of those around the box.
void TankRenderer::upload_solids(const tank::Domain& domain) {
    has_solids_ = domain.has_solids();
    const grid::BoxShape& shape = domain.shape();
    upload_volume(*gl_, solids_,
                  {domain.distance_m().row(-1, -1) - 1, shape.nx + 2, shape.ny + 2, shape.nz + 2,
                   shape.stride_y(), shape.stride_z()},
                  true);
}

void TankRenderer::show(std::shared_ptr<const session::TankSnapshot> snapshot) {
    const bool anew = snapshot_ == nullptr || snapshot_->place != snapshot->place;
    snapshot_ = std::move(snapshot);
    gl_->glActiveTexture(GL_TEXTURE0 + kLevelUnit);
    upload_level(anew);
    if (anew) upload_solids(*snapshot_->place->domain);
    const grid::BoxField& milk = snapshot_->seen.milk;
    upload_volume(*gl_, milk_, volume_of(milk), anew);
    has_milk_ = std::ranges::any_of(milk.values(), [](float share) { return share > 0.0F; });
}

void TankRenderer::draw(QOpenGLFramebufferObject& target, const QRect& part, const GlassCamera& camera,
                        int pass, Quality quality) {
    const tank::TankScene& scene = snapshot_->place->scene;
    program_->bind();
    set_rays(*program_, camera, target.size(), pass);
    program_->setUniformValue("size_m", vector(scene.size_m()));
    program_->setUniformValue("cells", vector(glm::vec3(scene.cells)));
    program_->setUniformValue("cell_m", static_cast<float>(scene.cell_m));
    program_->setUniformValue("wall_m", trace::tank_wall_m(snapshot_->seen.milk.shape()));
    program_->setUniformValue("unit_m", session::longest_side_m(scene));
    program_->setUniformValue("rest_m", session::rest_level_m(*snapshot_));
    program_->setUniformValue("liquid_per_m",
                              vector(trace::tank_absorption_per_m(snapshot_->seen.milk.shape())));
    program_->setUniformValue("has_milk", has_milk_);
    program_->setUniformValue("has_solids", has_solids_);
    program_->setUniformValue("most_steps", quality == Quality::Draft ? kDraftSteps : kFullSteps);
    program_->setUniformValue("level", kLevelUnit);
    program_->setUniformValue("solids", kSolidsUnit);
    program_->setUniformValue("milk_share", kMilkUnit);
    const std::pair<int, GLuint> textures[] = {
        {kMilkUnit, milk_}, {kSolidsUnit, solids_}, {kLevelUnit, level_}};
    for (const auto& [unit, texture] : textures) {
        gl_->glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        gl_->glBindTexture(GL_TEXTURE_3D, texture);
    }
    draw_rays(*gl_, target, part, pass, empty_array_);
    program_->release();
}

}  // namespace pastoso::glass
