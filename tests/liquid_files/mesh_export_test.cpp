#include "liquid_files/mesh_export.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/temporary_folder.hpp"
#include "files/triangle_readers.hpp"

#include <limits>
#include <sstream>

#include <gmock/gmock.h>

namespace pastoso::liquid_files {
namespace {

using document::error_of;
using liquid::TriangleMesh;
using testing::ElementsAre;
using testing::HasSubstr;
using Path = std::filesystem::path;

const files::KeepGoing kToTheEnd = [](double) { return true; };

/// A tetrahedron of 1/6 x 2 x 3 x 4 m3; its normals are no more than directions from its corner.
TriangleMesh tetrahedron() {
    return {{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}},
            {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TriangleMesh without_normals(TriangleMesh mesh) {
    mesh.normals.clear();
    return mesh;
}

class MeshExportTest : public files::TemporaryFolder {
  protected:
    std::string written(const char* name, const TriangleMesh& mesh,
                        const MeshExportOptions& options = {}) {
        EXPECT_EQ(export_mesh(folder / name, mesh, options, kToTheEnd), files::ExportStatus::Written);
        return core::read_text_file(folder / name);
    }
};

TEST_F(MeshExportTest, EveryFormatHoldsTheMeshTheRightWayOut) {
    const TriangleMesh mesh = tetrahedron();
    const TriangleMesh ply = files::read_ply(written("a.ply", mesh));
    EXPECT_EQ(ply.positions_m, mesh.positions_m);
    EXPECT_EQ(ply.normals, mesh.normals);
    EXPECT_EQ(ply.triangles, mesh.triangles);
    EXPECT_DOUBLE_EQ(liquid::volume_m3(ply), 4.0);
    EXPECT_DOUBLE_EQ(liquid::volume_m3(files::read_stl(written("a.stl", mesh))), 4.0);
    // Turned to y up, not mirrored: the volume stays positive.
    const TriangleMesh obj = files::read_obj(written("a.OBJ", mesh));
    EXPECT_EQ(obj.positions_m[2], glm::vec3(0, 0, -3));
    EXPECT_EQ(obj.positions_m[3], glm::vec3(0, 4, 0));
    EXPECT_EQ(obj.normals[3], glm::vec3(0, 1, 0));
    EXPECT_EQ(obj.triangles, mesh.triangles);
    EXPECT_DOUBLE_EQ(liquid::volume_m3(obj), 4.0);
}

TEST_F(MeshExportTest, ATinyMeshHasTheseBytes) {
    const TriangleMesh mesh{
        {{0, 0, 0}, {0.5F, 0, 0}, {0, 0.25F, 2}}, {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, {{0, 1, 2}}};
    EXPECT_EQ(written("a.obj", mesh),
              "# Pastoso milk, metres\n"
              "v 0 0 -0\nvn 0 1 -0\nv 0.5 0 -0\nvn 0 0 -1\nv 0 2 -0.25\nvn 1 0 -0\n"
              "f 1//1 2//2 3//3\n");
    EXPECT_THAT(written("b.obj", without_normals(mesh)), HasSubstr("\nf 1 2 3\n"));
    const std::string ply = written("a.ply", mesh, {"glass", PbrtSyntax::V4});
    const std::string header =
        "ply\nformat binary_little_endian 1.0\ncomment Pastoso glass, metres\nelement vertex 3\n"
        "property float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    EXPECT_EQ(ply.substr(0, header.size()), header);
    EXPECT_EQ(ply.size(), header.size() + 3 * 24 + 13);
    EXPECT_EQ(ply.substr(ply.size() - 13), std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13));
    EXPECT_THAT(written("a.stl", mesh), testing::StartsWith("Pastoso milk, binary STL, metres  "));
}

TEST_F(MeshExportTest, PbrtShapesAreWrittenInEachSyntax) {
    const TriangleMesh mesh{
        {{0, 0, 0}, {0.5F, 0, 0}, {0, 0.1F, 2}}, {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, {{0, 1, 2}}};
    for (const PbrtSyntax syntax : {PbrtSyntax::V4, PbrtSyntax::V3, PbrtSyntax::V2}) {
        std::istringstream text(written("a.pbrt", mesh, {"milk", syntax}));
        std::string line;
        std::getline(text, line);
        EXPECT_EQ(line, "# Pastoso milk, metres, z up");
        std::vector<std::string> tokens;
        for (std::string word; text >> word;)
            tokens.push_back(word);
        EXPECT_THAT(
            tokens,
            ElementsAre("Shape", "\"trianglemesh\"",                                               //
                        syntax == PbrtSyntax::V4 ? "\"point3" : "\"point", "P\"", "[",             //
                        "0", "0", "0", "0.5", "0", "0", "0", "0.1", "2", "]",                      //
                        "\"normal", "N\"", "[", "0", "0", "1", "0", "1", "0", "1", "0", "0", "]",  //
                        "\"integer", "indices\"", "[", "0", "1", "2", "]"));
    }
    EXPECT_THAT(written("b.pbrt", without_normals(mesh)), testing::Not(HasSubstr("normal")));
}

TEST_F(MeshExportTest, AnEmptyMeshMakesAValidFile) {
    EXPECT_TRUE(files::read_ply(written("a.ply", {})).empty());
    EXPECT_TRUE(files::read_stl(written("a.stl", {})).empty());
    EXPECT_EQ(written("a.obj", {}), "# Pastoso milk, metres\n");
    EXPECT_EQ(written("a.pbrt", {}), "# Pastoso milk, metres, z up\n");
}

TEST_F(MeshExportTest, RefusesWhatIsNotFiniteAndLeavesTheOldFile) {
    core::write_text_file(folder / "a.obj", "old");
    TriangleMesh mesh = tetrahedron();
    mesh.positions_m[2].y = std::numeric_limits<float>::infinity();
    const auto refusal = [&](const char* name) {
        return error_of([&] { export_mesh(folder / name, mesh, {}, kToTheEnd); });
    };
    EXPECT_THAT(refusal("a.obj"), HasSubstr("a.obj: the position of vertex 2 is not finite"));
    mesh = tetrahedron();
    mesh.normals[3].x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(refusal("a.obj"), HasSubstr("a.obj: the normal of vertex 3 is not finite"));
    EXPECT_THAT(refusal("a.3ds"), HasSubstr("a.3ds: a surface is saved as .obj, .ply, .stl or .pbrt"));
    EXPECT_EQ(core::read_text_file(folder / "a.obj"), "old");
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(MeshExportTest, AStoppedExportLeavesTheOldFile) {
    TriangleMesh mesh;
    mesh.positions_m.assign(100'000, {0.1F, 0.2F, 0.3F});
    for (const char* name : {"a.obj", "a.ply", "a.pbrt"}) {
        core::write_text_file(folder / name, "old");
        mesh.triangles.assign(100'000, {0, 1, 2});
        EXPECT_EQ(export_mesh(folder / name, mesh, {}, [](double) { return false; }),
                  files::ExportStatus::Stopped);
        EXPECT_EQ(core::read_text_file(folder / name), "old");
    }
    EXPECT_EQ(files_in_folder(), 3U);
}

}  // namespace
}  // namespace pastoso::liquid_files
