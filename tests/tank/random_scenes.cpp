#include "random_scenes.hpp"

#include "tank_cases.hpp"

#include <cmath>
#include <span>

namespace pastoso::tank::cases {
namespace {

/// The next numbers of a seed.
class Draw {
  public:
    explicit Draw(std::uint32_t seed) : seed_(seed) {}

    float number(float least, float most) {
        return least + (most - least) * core::uniform_noise(n_++, seed_);
    }
    bool happens(float share) { return number(0, 1) < share; }
    glm::vec3 place() {
        const float x = number(0, 1), y = number(0, 1), z = number(0, 1);
        return {x, y, z};
    }
    Shape shape();

  private:
    std::uint32_t seed_, n_ = 0;
};

Shape Draw::shape() {
    const glm::vec3 at = place(), other = place();
    switch (static_cast<int>(number(0.0F, 3.999F))) {
        case 0:
            return {Sphere{at, number(0.05F, 0.4F)}};
        case 1:
            return {Block{at, at + 0.1F + 0.7F * other}};
        case 2:
            return {Cylinder{at, other + glm::vec3(0.0F, 0.0F, 0.01F), number(0.05F, 0.3F)}};
        default:
            return {Torus{at, other - 0.5F, number(0.15F, 0.3F), number(0.03F, 0.12F)}};
    }
}

testing::AssertionResult all_finite(std::span<const float> values, const char* name) {
    for (std::size_t n = 0; n < values.size(); ++n)
        if (!std::isfinite(values[n]))
            return testing::AssertionFailure() << name << " " << n << " is " << values[n];
    return testing::AssertionSuccess();
}

}  // namespace

TankScene random_scene(std::uint32_t seed) {
    Draw draw(seed);
    TankScene scene = dam(12, glm::vec3(0.0F));
    scene.liquids.clear();
    scene.method = static_cast<Method>(static_cast<int>(draw.number(0.0F, 3.999F)));
    const int bodies = static_cast<int>(draw.number(1, 4)), solids = static_cast<int>(draw.number(0, 3));
    for (int body = 0; body < bodies; ++body) {
        const Shape shape = draw.shape();
        const glm::vec3 velocity_m_s = 4.0F * (draw.place() - 0.5F);
        scene.liquids.push_back({shape, velocity_m_s, draw.number(0, 1)});
    }
    for (int solid = 0; solid < solids; ++solid)
        scene.solids.push_back(draw.shape());
    if (draw.happens(0.3F)) {
        const Shape shape = draw.shape();
        scene.jets.push_back({shape, 10.0F * (draw.place() - 0.5F), 0.5F, 0.0, 0.3});
    }
    if (draw.happens(0.3F)) scene.drains.push_back({draw.shape(), 0.1, 1e9});
    if (draw.happens(0.5F)) {
        scene.wind.speed_m_s = static_cast<double>(draw.number(0, 20));
        scene.wind.direction_deg = static_cast<double>(draw.number(0, 360));
    }
    if (draw.happens(0.3F)) scene.viscosity_m2_s = static_cast<double>(draw.number(0, 1));
    if (draw.happens(0.3F)) scene.confinement = 0.3;
    scene.seed = seed;
    return scene;
}

testing::AssertionResult is_sound(const LiquidTank& tank, core::ThreadPool& pool) {
    const glm::vec3 size_m = tank.scene().size_m();
    for (const Particle& particle : tank.particles())
        for (const int axis : liquid::kAxes) {
            const float at_m = particle.position_m[axis], u_m_s = particle.velocity_m_s[axis];
            if (!(at_m >= 0.0F && at_m <= size_m[axis]) || !std::isfinite(u_m_s))
                return testing::AssertionFailure() << "a particle at " << at_m << " m along axis "
                                                   << axis << " with " << u_m_s << " m/s";
        }
    for (const int axis : liquid::kAxes)
        if (const auto finite = all_finite(tank.velocity().along(axis).values(), "velocity"); !finite)
            return finite;
    const TankFrame frame = tank.frame(1, pool);
    if (const auto finite = all_finite(
            {frame.level_m.row(0, 0), frame.level_m.row(0, frame.level_m.lattice().nz)}, "level");
        !finite)
        return finite;
    return all_finite(frame.milk.values(), "milk");
}

void run_random_scenes(std::uint32_t first_seed, std::uint32_t count) {
    core::ThreadPool pool(2);
    for (std::uint32_t seed = first_seed; seed < first_seed + count; ++seed) {
        LiquidTank tank(random_scene(seed));
        for (int step = 0; step < 12; ++step)
            tank.step(0.1, pool);
        ASSERT_TRUE(is_sound(tank, pool)) << "seed " << seed;
    }
}

}  // namespace pastoso::tank::cases
