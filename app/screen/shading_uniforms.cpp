#include "screen/shading_uniforms.hpp"

#include "screen/uniform_values.hpp"
#include "shade/outline.hpp"
#include "shade/sampling.hpp"
#include "shade/shading_model.hpp"

#include <array>

#include <QVector3D>
#include <glm/matrix.hpp>

namespace pastoso::screen {
namespace {

void set_light(QOpenGLShaderProgram& program, const shade::ShadingConstants& light) {
    program.setUniformValue("to_light", QVector3D(light.light_x, light.light_y, light.light_z));
    program.setUniformValue("half_vector", QVector3D(light.half_x, light.half_y, light.half_z));
    program.setUniformValue("direct", light.direct);
    program.setUniformValue("ambient", light.ambient);
    program.setUniformValue("gloss", light.gloss);
    program.setUniformValue("dry_roughness", light.dry_roughness);
    program.setUniformValue("wet_roughness", light.wet_roughness);
    program.setUniformValue("inverse_softness_per_mm", light.inverse_softness_per_mm);
}

QVector3D colour(const Rgb& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

void set_look(QOpenGLShaderProgram& program, const Scene& scene) {
    if (scene.look == Look::Lit) return;
    program.setUniformValue("scale_top_mm", static_cast<float>(scene.scale_top_mm));
    program.setUniformValue("wet_range_mm", vector({kThinnestWet_mm, kThickestWet_mm}));
    program.setUniformValue("wet_tint", colour(kWetTint));
    program.setUniformValue("full_tint", static_cast<float>(kFullTint));
    program.setUniformValue("grey_share", static_cast<float>(kGreyShare));
    std::array<QVector3D, kHeightSteps> steps;
    for (int step = 0; step < kHeightSteps; ++step)
        steps[step] = colour(kHeightColours[step]);
    program.setUniformValueArray("height_colours", steps.data(), kHeightSteps);
}

}  // namespace

void set_shading_uniforms(QOpenGLShaderProgram& program, const Scene& scene, const Sampling& sampling) {
    const grid::Shape& shape = scene.canvas->shape();
    program.setUniformValue("canvas_cells", vector({shape.width, shape.height}));
    const PageLayout& pages = scene.canvas->pages();
    program.setUniformValue("pages", vector({pages.columns, pages.rows}));
    program.setUniformValue("page_cells", vector({pages.width, pages.height}));
    program.setUniformValue("cell_mm", static_cast<float>(scene.cell_mm));
    program.setUniformValue("origin_px", vector(scene.view.origin_px));
    program.setUniformValue("canvas_from_screen", matrix(glm::transpose(scene.view.axes())));
    program.setUniformValue("px_per_cell", static_cast<float>(scene.view.zoom));
    program.setUniformValue("pixel_size", static_cast<float>(sampling.pixel_size));
    program.setUniformValue("samples_per_side", sampling.samples_per_side);
    program.setUniformValue("outline_strength", shade::outline_strength(scene.view.zoom));
    program.setUniformValue("colour_sharpness", shade::colour_sharpness(scene.view.zoom));
    const std::array<float, 3> weights = pigment::luminance_weights(scene.space);
    program.setUniformValue("luminance_weights", QVector3D(weights[0], weights[1], weights[2]));
    program.setUniformValue("ground", colour(scene.ground));
    set_look(program, scene);
    set_light(program, shade::shading_constants(scene.lighting, scene.cell_mm));
}

}  // namespace pastoso::screen
