// When somebody looks at a film changes nothing about it: the length of a step comes from the motion.
#include "film/laboratory/simulation.hpp"

#include <cmath>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::film {
namespace {

constexpr double kSeconds = 12.0;

struct Spreading {
    const char* medium;
    Form form;
    double thickness_mm;
    grid::Shape shape;
    double cell_mm = 0.25;
};
void PrintTo(const Spreading& film, std::ostream* out) {
    *out << film.thickness_mm << " mm of " << film.medium;
}

Scene scene_of(const Spreading& film) {
    Scene scene;
    scene.shape = film.shape;
    scene.cell_mm = film.cell_mm;
    scene.film = {{.form = film.form, .thickness_mm = film.thickness_mm}};
    scene.medium = find_medium(film.medium);
    scene.gravity = tilted_gravity(0.0);
    scene.solver.edge_x = scene.solver.edge_y = Edge::Wall;
    scene.solver.scheme = Scheme::LargeStep;
    return scene;
}

double energy_J(const Simulation& film) {
    const Measures measures = film.measures();
    return measures.kinetic_energy_J + measures.gravity_energy_J + measures.surface_energy_J;
}

struct Course {
    std::vector<double> thickness_mm;
    std::vector<double> energy_J;  ///< at every row
};
Course run(const Spreading& film, double row_s) {
    core::ThreadPool pool(1);
    Simulation simulation(scene_of(film), pool);
    Course result{{}, {energy_J(simulation)}};
    for (int row = 1; row <= static_cast<int>(std::lround(kSeconds / row_s)); ++row) {
        simulation.advance_to(row * row_s);
        result.energy_J.push_back(energy_J(simulation));
    }
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x)
            result.thickness_mm.push_back(thickness_mm(simulation.film().thickness.at(x, y)));
    return result;
}

/// Mean difference over the mean thickness.
double difference(const Course& a, const Course& b) {
    double different = 0.0, all = 0.0;
    for (std::size_t cell = 0; cell < a.thickness_mm.size(); ++cell) {
        different += std::abs(a.thickness_mm[cell] - b.thickness_mm[cell]);
        all += b.thickness_mm[cell];
    }
    return different / all;
}

double largest_rise(const Course& run) {
    double rise = 0.0;
    for (std::size_t row = 1; row < run.energy_J.size(); ++row)
        rise = std::max(rise, run.energy_J[row] - run.energy_J[row - 1]);
    return rise / (run.energy_J.front() - run.energy_J.back());
}

class SpreadingFilm : public testing::TestWithParam<Spreading> {};

TEST_P(SpreadingFilm, DoesNotDependOnTheRowsWritten) {
    const Course often = run(GetParam(), 1.0 / 60.0);
    for (const double row_s : {0.1, 0.4, 3.0}) {
        const Course seldom = run(GetParam(), row_s);
        EXPECT_LE(difference(seldom, often), 0.01) << "rows every " << row_s << " s";
        EXPECT_LE(largest_rise(seldom), 1e-3) << "rows every " << row_s << " s";
    }
    EXPECT_LE(largest_rise(often), 1e-3);
}

const Box kBlock{{13, 0, 23, 1}};
INSTANTIATE_TEST_SUITE_P(
    Films, SpreadingFilm,
    testing::Values(Spreading{"fluid acrylic", kBlock, 6.0, {144, 4}},
                    Spreading{"house paint", kBlock, 3.0, {144, 4}},
                    Spreading{"heavy-body oil", kBlock, 7.0, {144, 4}},
                    Spreading{"stand oil", SphericalCap{{8.3, 7.9}, 4.4}, 2.5, {63, 66}},
                    Spreading{"linseed oil", Cosine{3.1, 31.0, 0.0}, 0.9, {70, 66}, 0.2},
                    Spreading{"house paint", WhiteNoise{7}, 1.1, {48, 48}},
                    Spreading{"linseed oil", Box{{4, 4, 9, 9}}, 1.0, {70, 66}, 0.2}));

}  // namespace
}  // namespace pastoso::film
