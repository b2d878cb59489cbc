#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/temporary_folder.hpp"
#include "files/triangle_readers.hpp"
#include "recordings/relief_export.hpp"
#include "shade/canvas.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

namespace pastoso::recordings {
namespace {

using document::error_of;
using testing::HasSubstr;
using Point = std::array<float, 3>;
using Path = std::filesystem::path;

const files::KeepGoing kToTheEnd = [](double) { return true; };

/// Triangles as a slicer has them: by the places of their corners.
struct Solid {
    std::vector<std::array<Point, 3>> triangles;

    /// By the divergence theorem; > 0 when the triangles look outwards.
    double volume_mm3() const {
        double six_times = 0.0;
        for (const auto& [a, b, c] : triangles) {
            six_times += static_cast<double>(a[0]) *
                             (static_cast<double>(b[1]) * c[2] - static_cast<double>(b[2]) * c[1]) +
                         static_cast<double>(a[1]) *
                             (static_cast<double>(b[2]) * c[0] - static_cast<double>(b[0]) * c[2]) +
                         static_cast<double>(a[2]) *
                             (static_cast<double>(b[0]) * c[1] - static_cast<double>(b[1]) * c[0]);
        }
        return six_times / 6.0;
    }
};

/// Whether each edge belongs to two triangles that run along it in opposite directions.
bool is_watertight(const Solid& solid) {
    std::map<std::pair<Point, Point>, int> edges;
    for (const auto& corners : solid.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            ++edges[{corners[k], corners[(k + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        if (count != 1 || back == edges.end() || edge.first == edge.second) return false;
    }
    return true;
}

Solid solid_of(const liquid::TriangleMesh& mesh) {
    const auto point = [&](std::uint32_t vertex) {
        const glm::vec3& at = mesh.positions_m.at(vertex);
        return Point{at.x, at.y, at.z};
    };
    Solid solid;
    for (const auto& [a, b, c] : mesh.triangles)
        solid.triangles.push_back({point(a), point(b), point(c)});
    return solid;
}

Solid solid_in_stl(const Path& path) {
    const liquid::TriangleMesh mesh = files::read_stl(core::read_text_file(path));
    for (const glm::vec3& normal : mesh.normals)
        EXPECT_NEAR(glm::dot(normal, normal), 1.0, 1e-5);
    return solid_of(mesh);
}

class ReliefTest : public files::TemporaryFolder {
  protected:
    core::ThreadPool pool{2};
};

/// sum (c + h) cell^2 over the canvas.
double volume_of(const film::FilmState& film) {
    double sum_mm = 0.0;
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x)
            sum_mm += film.support_mm.at(x, y) + film::thickness_mm(film.thickness.at(x, y));
    return sum_mm * film.cell_mm * film.cell_mm;
}

/// A broad heap of paint that ends before the edges.
film::FilmState heap(int width, int height) {
    film::FilmState film({width, height}, 0.25);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double dx = (x + 0.5) / width - 0.5, dy = (y + 0.5) / height - 0.5;
            const double d2 = dx * dx + dy * dy;
            if (d2 < 0.16)
                test::set_paint(film, x, y, 3.0 * (1 - d2 / 0.16) * (1 - d2 / 0.16), test::kRed);
        }
    }
    return film;
}

TEST_F(ReliefTest, EveryFormatHoldsTheSameClosedSolid) {
    const film::FilmState film = test::random_canvas({23, 14}, 5);
    const Relief relief = relief_of(film, {1.5, 2.0, 0.3}, pool);
    const Path stl = folder / "a.stl", ply = folder / "a.PLY", obj = folder / "a.obj";
    for (const Path& path : {stl, ply, obj})
        ASSERT_EQ(export_relief(path, relief, kToTheEnd), files::ExportStatus::Written);
    const Solid solid = solid_in_stl(stl);
    EXPECT_EQ(solid.triangles.size(), relief.triangle_count());
    EXPECT_TRUE(is_watertight(solid));
    EXPECT_EQ(solid_of(files::read_ply(core::read_text_file(ply))).triangles, solid.triangles);
    EXPECT_EQ(solid_of(files::read_obj(core::read_text_file(obj))).triangles, solid.triangles);
}

TEST_F(ReliefTest, TheSmallestGridsAreClosedToo) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 5}, {4, 1}, {3, 2}}) {
        const film::FilmState film({width, height}, 0.5);
        const Relief relief = relief_of(film, {2.0, 1.0, 0.0}, pool);
        const Path path = folder / "a.stl";
        export_relief(path, relief, kToTheEnd);
        const Solid solid = solid_in_stl(path);
        EXPECT_TRUE(is_watertight(solid)) << width << " x " << height;
        // Flat: floats are exact here.
        EXPECT_DOUBLE_EQ(solid.volume_mm3(), 2.0 * 0.25 * width * height);
    }
}

TEST_F(ReliefTest, TheVolumeIsThatOfPaintSupportAndBase) {
    const film::FilmState film = heap(120, 80);
    const double area_mm2 = 30.0 * 20.0, paint_mm3 = volume_of(film);
    for (const double resolution_mm : {0.125, 0.25, 0.5}) {
        for (const double exaggeration : {1.0, 3.0}) {
            const Relief relief = relief_of(film, {2.0, exaggeration, resolution_mm}, pool);
            export_relief(folder / "a.stl", relief, kToTheEnd);
            // The heap is smooth on the scale of the vertices: trapezia miss h'' step^2 / 12, below
            // 1e-3 of it at half a millimetre; the clamped feet of the spline are less.
            EXPECT_NEAR(solid_in_stl(folder / "a.stl").volume_mm3(),
                        2.0 * area_mm2 + exaggeration * paint_mm3, 2e-3 * exaggeration * paint_mm3)
                << resolution_mm;
        }
    }
}

TEST_F(ReliefTest, LengthsAreMillimetresAndTheUpperEdgeLiesUp) {
    film::FilmState film({40, 20}, 0.25);
    for (int y = 4; y < 8; ++y) {
        for (int x = 4; x < 8; ++x) {
            const bool inside = x > 4 && x < 7 && y > 4 && y < 7;
            test::set_paint(film, x, y, inside ? 1.0 : 0.5, test::kBlue);
        }
    }
    const Relief relief = relief_of(film, {2.0, 1.0, 0.25}, pool);
    EXPECT_EQ(relief.columns, 41);
    EXPECT_EQ(relief.rows, 21);
    EXPECT_EQ(relief.vertex(0), (Point{0.0F, 5.0F, 2.0F}));
    EXPECT_EQ(relief.vertex(relief.vertex_count() - 1), (Point{5.0F, 2.5F, 0.0F}));
    const auto highest = std::max_element(relief.z_mm.begin(), relief.z_mm.end());
    const Point top = relief.vertex(static_cast<std::size_t>(highest - relief.z_mm.begin()));
    EXPECT_EQ(top[0], 1.5F);
    EXPECT_EQ(top[1], 3.5F);
    EXPECT_NEAR(top[2], 3.0, 0.2);  // the top lies above the means of the cells around it
}

TEST_F(ReliefTest, AStoppedExportLeavesTheOldFile) {
    core::write_text_file(folder / "a.obj", "old");
    const Relief relief = relief_of(heap(200, 200), {}, pool);
    EXPECT_EQ(export_relief(folder / "a.obj", relief, [](double) { return false; }),
              files::ExportStatus::Stopped);
    EXPECT_EQ(core::read_text_file(folder / "a.obj"), "old");
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(ReliefTest, SamplingIsToldAndCanBeStopped) {
    const film::FilmState film = heap(200, 200);
    // Four bands.
    const ReliefOptions fine{2.0, 1.0, 50.0 / 3000.0};
    std::vector<double> shares;
    const std::optional<Relief> whole = relief_of(film, fine, pool, [&](double done) {
        shares.push_back(done);
        return true;
    });
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->z_mm, relief_of(film, fine, pool).z_mm);
    EXPECT_GE(shares.size(), 4U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1.0);
    int asked = 0;
    EXPECT_FALSE(relief_of(film, fine, pool, [&](double) { return ++asked < 3; }));
    EXPECT_EQ(asked, 3);
}

TEST_F(ReliefTest, RefusesWhatCannotBePrinted) {
    const film::FilmState film({4000, 4000}, 0.25);
    const auto refusal = [&](const ReliefOptions& options) {
        return error_of([&] { relief_of(film, options, pool); });
    };
    EXPECT_EQ(refusal({0.0, 1.0, 0.0}),
              "The relief's base in mm is 0, outside the range from 0.1 to 100.");
    EXPECT_THAT(refusal({2.0, -1.0, 0.0}), HasSubstr("The relief's exaggeration is -1"));
    EXPECT_THAT(refusal({2.0, 1.0, 50.0}), HasSubstr("The relief's resolution in mm is 50"));
    EXPECT_THAT(refusal({2.0, 1.0, 0.1}), HasSubstr("A relief of 10001 x 10001 points is more than"));
    EXPECT_THAT(error_of([&] { export_relief(folder / "a.3mf", {}, kToTheEnd); }),
                HasSubstr("a.3mf: a relief is saved as .stl, .ply or .obj; this name ends otherwise."));
}

}  // namespace
}  // namespace pastoso::recordings
