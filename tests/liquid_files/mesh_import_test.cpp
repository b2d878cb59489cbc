#include "liquid_files/mesh_import.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/temporary_folder.hpp"
#include "liquid_files/mesh_export.hpp"
#include "tank/meshes.hpp"

#include <cstring>
#include <limits>

#include <gmock/gmock.h>

namespace pastoso::liquid_files {
namespace {

using document::error_of;
using liquid::TriangleMesh;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// With numbers that are no short decimals, and with normals.
TriangleMesh uneven_ball() {
    TriangleMesh mesh = tank::test::sphere_mesh({}, 1.0F, 2);
    mesh.normals = mesh.positions_m;
    for (glm::vec3& position : mesh.positions_m)
        position = 0.123F * position + glm::vec3(1e-7F, 1.0F / 3.0F, -1234.567F);
    return mesh;
}

class MeshImportTest : public files::TemporaryFolder {
  protected:
    TriangleMesh there_and_back(const char* name, const TriangleMesh& mesh) {
        EXPECT_EQ(export_mesh(folder / name, mesh, {}, [](double) { return true; }),
                  files::ExportStatus::Written);
        return import_mesh(folder / name);
    }
};

TEST_F(MeshImportTest, ObjComesBackAsItWasWritten) {
    TriangleMesh mesh = uneven_ball();
    EXPECT_EQ(there_and_back("a.obj", mesh), mesh);
    mesh.normals.clear();
    EXPECT_EQ(there_and_back("b.OBJ", mesh), mesh);
    EXPECT_EQ(there_and_back("c.obj", {}), TriangleMesh{});
}

TEST_F(MeshImportTest, StlComesBackWithItsCornersJoined) {
    const TriangleMesh mesh = uneven_ball(), back = there_and_back("a.Stl", mesh);
    EXPECT_THAT(back.normals, IsEmpty());
    EXPECT_EQ(back.positions_m.size(), mesh.positions_m.size());
    ASSERT_EQ(back.triangles.size(), mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(back.positions_m[back.triangles[i][c]], mesh.positions_m[mesh.triangles[i][c]]);
    EXPECT_EQ(there_and_back("b.stl", {}), TriangleMesh{});
}

TEST_F(MeshImportTest, OtherFilesAreRefused) {
    const auto refusal = [&](const char* name) { return error_of([&] { import_mesh(folder / name); }); };
    EXPECT_THAT(refusal("a.ply"), HasSubstr("a.ply: a mesh is read from .obj or .stl"));
    EXPECT_THAT(refusal("a.obj"), HasSubstr("a.obj: cannot be opened"));
    EXPECT_THAT(refusal("a.OBJ"), HasSubstr("a.OBJ: cannot be opened"));
    EXPECT_THAT(refusal("obj"), HasSubstr("obj: a mesh is read from .obj or .stl"));
}

TriangleMesh obj(const std::string& text) {
    return mesh_from_obj(text, "file");
}

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 0 -1\nv 0 0 -1\n";

TEST(ObjImport, TurnsYUpToZUp) {
    EXPECT_THAT(obj(kSquare).positions_m, ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0),
                                                      glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)));
    EXPECT_THAT(obj("v 1 2 3").positions_m, ElementsAre(glm::vec3(1, -3, 2)));
}

TEST(ObjImport, ReadsEveryWayToWriteACorner) {
    const Triangles square = {{0, 1, 2}, {0, 2, 3}};
    for (const char* face : {"f 1 2 3 4", "f 1/7 2/8 3/9 4/1", "f -4 -3 -2 -1", "f 1 -3 3 -1",
                             "f 1/1/1 2//2 3/9/3 4/1/-1", "f -4/-1/-4 2//2 3//3 4//4"}) {
        const TriangleMesh mesh = obj(std::string(kSquare) +
                                      "vn 0 0 1\nvn 0 1 0\nvn 1 0 0\nvn 0 0 -1\nvt 0 0\n" + face + "\n");
        EXPECT_EQ(mesh.triangles, square) << face;
        EXPECT_EQ(mesh.normals.empty(), std::strstr(face, "//") == nullptr) << face;
    }
}

TEST(ObjImport, PassesOverTheRestAndLineEnds) {
    const TriangleMesh mesh = obj(
        "# a comment\r\nmtllib a.mtl\r\n\r\no body\r\ng one two\r\ns off\r\nusemtl glass\r\n"
        "\tv\t0 +0 0 1.0\r\nv 1e0 .0 -0 0.5 0.5 0.5\r\nv 1 0 -1.\r\nvt 0 0\r\nl 1 2\r\nf  1  2\t3 \r");
    EXPECT_THAT(mesh.triangles, ElementsAre(std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(mesh.positions_m.size(), 3U);
    EXPECT_EQ(obj("").triangles.size(), 0U);
}

TEST(ObjImport, KeepsNormalsThatBelongToTheirPositionsOnly) {
    const std::string two = std::string(kSquare) + "vn 0 1 0\nvn 0 1 0\nvn 0 1 0\nvn 0 1 0\n";
    EXPECT_EQ(obj(two + "f 1//1 2//2 3//3 4//4").normals.size(), 4U);
    EXPECT_THAT(obj(two + "f 1//1 2//2 3//3 4//3").normals, IsEmpty());
    EXPECT_THAT(obj(two + "f 1//1 2//2 3//3\nf 1 3 4").normals, IsEmpty());
    EXPECT_THAT(obj(std::string(kSquare) + "vn 0 1 0\nf 1//1 2//1 3//1").normals, IsEmpty());
    EXPECT_THAT(obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 9\nvn 0 0 9\nvn 0 0 9\nf 1//1 2//2 3//3").normals,
                IsEmpty());
}

TEST(ObjImport, LeavesOutWhatIsNoMoreThanALine) {
    EXPECT_EQ(obj(std::string(kSquare) + "f 1 2 2 3\nf 1 1 2").triangles, (Triangles{{0, 1, 2}}));
}

std::string obj_fault(const std::string& text) {
    return error_of([&] { obj(text); });
}

TEST(ObjImport, FaultsAreNamedWithTheirLines) {
    EXPECT_EQ(obj_fault("v 0 0"), "file, line 1: a number is missing.");
    EXPECT_EQ(obj_fault("\nv 0 zero 0"), "file, line 2: \"zero\" is no number.");
    EXPECT_EQ(obj_fault("v 0 nan 0"), "file, line 1: \"nan\" is not finite in single precision.");
    EXPECT_EQ(obj_fault("v 0 1e39 0"), "file, line 1: \"1e39\" is not finite in single precision.");
    EXPECT_EQ(obj_fault("v 0 1e999 0"), "file, line 1: \"1e999\" is no number.");
    EXPECT_EQ(obj_fault("v 0 1x 0"), "file, line 1: \"1x\" is no number.");
    EXPECT_EQ(obj_fault("v 0 \x01\xff 0"), "file, line 1: \"\?\?\" is no number.");
    EXPECT_EQ(obj_fault("v " + std::string(100, 'a')),
              "file, line 1: \"" + std::string(40, 'a') + "...\" is no number.");
    const std::string square = kSquare;
    EXPECT_EQ(obj_fault(square + "f 1 2"), "file, line 5: a face has 2 corners, not three or more.");
    EXPECT_EQ(obj_fault(square + "f 1 2 5"),
              "file, line 5: \"5\" names position 5, but 4 were given until here.");
    EXPECT_EQ(obj_fault(square + "f 1 2 0"),
              "file, line 5: \"0\" names position 0, but 4 were given until here.");
    EXPECT_EQ(obj_fault(square + "f 1 2 -5"),
              "file, line 5: \"-5\" names position -5, but 4 were given until here.");
    EXPECT_EQ(obj_fault(square + "f 1//1 2 3"),
              "file, line 5: \"1//1\" names normal 1, but 0 were given until here.");
    EXPECT_EQ(obj_fault(square + "f 1 2 3.5"), "file, line 5: \"3.5\" is no corner of a face.");
    EXPECT_EQ(obj_fault(square + "f 1// 2 3"), "file, line 5: \"1//\" is no corner of a face.");
    EXPECT_THAT(obj_fault(square + "f 1 2 99999999999999999999"), HasSubstr("is no corner of a face"));
    EXPECT_THAT(obj_fault(square + "f 1 2 4294967297"), HasSubstr("names position 4294967297"));
}

TEST(ObjImport, TooManyTrianglesAreRefused) {
    // A fan around the square, two bytes a triangle.
    std::string text = std::string(kSquare) + "f";
    for (std::size_t corner = 0; corner < kMostMeshTriangles + 3; ++corner)
        text += corner % 2 == 0 ? " 1" : " 2";
    EXPECT_THAT(mesh_from_obj(text, "file").triangles, IsEmpty());
    text = std::string(kSquare) + "f 1";
    for (std::size_t corner = 0; corner < kMostMeshTriangles + 2; ++corner)
        text += corner % 2 == 0 ? " 2" : " 3";
    EXPECT_THAT(obj_fault(text), HasSubstr("line 5: there are more than 10000000 triangles"));
}

template <class Value>
void put(std::string& bytes, std::size_t at, Value value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// A tetrahedron in binary STL.
std::string tetrahedron_stl(const char* head = "any words") {
    const std::array<glm::vec3, 4> corners = {{{0, 0, 0}, {1, 0, 0}, {-0.0F, 1, 0}, {0, -0.0F, 1}}};
    const Triangles triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    std::string bytes(84 + 50 * triangles.size(), '\0');
    std::memcpy(bytes.data(), head, std::strlen(head));
    put(bytes, 80, static_cast<std::uint32_t>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c)
            put(bytes, 84 + 50 * t + 12 + 12 * c, corners[triangles[t][c]]);
    return bytes;
}

std::string stl_fault(const std::string& bytes) {
    return error_of([&] { mesh_from_stl(bytes, "file"); });
}

TEST(StlImport, ReadsBytes) {
    // Some programs begin the head as a text would.
    for (const char* head : {"any words", "solid as a rock"}) {
        const TriangleMesh mesh = mesh_from_stl(tetrahedron_stl(head), "file");
        EXPECT_EQ(mesh.positions_m.size(), 4U);
        EXPECT_EQ(mesh.triangles.size(), 4U);
        EXPECT_DOUBLE_EQ(liquid::volume_m3(mesh), 1.0 / 6.0);
    }
}

TEST(StlImport, FaultsInBytesAreNamedWithTheirPlace) {
    EXPECT_EQ(stl_fault(""), "file, byte 0: the file ends here, within the head of an STL file.");
    EXPECT_EQ(stl_fault(std::string(83, 'x')),
              "file, byte 83: the file ends here, within the head of an STL file.");
    std::string bytes = tetrahedron_stl();
    EXPECT_EQ(stl_fault(bytes.substr(0, 283)),
              "file, byte 80: 4 triangles take 284 bytes, but the file has 283.");
    EXPECT_EQ(stl_fault(bytes + "x"),
              "file, byte 80: 4 triangles take 284 bytes, but the file has 285.");
    put(bytes, 80, std::uint32_t{0xffffffff});
    EXPECT_EQ(stl_fault(bytes),
              "file, byte 80: 4294967295 triangles take 214748364834 bytes, but the file has 284.");
    bytes = tetrahedron_stl();
    put(bytes, 84 + 2 * 50 + 12 + 12 + 4, std::numeric_limits<float>::infinity());
    EXPECT_EQ(stl_fault(bytes), "file, byte 208: a corner of triangle 2 is not finite (inf).");
}

constexpr const char* kText =
    "solid a body\n"
    "  facet normal 0 0 -1\n    outer loop\n"
    "      vertex 0 0 0\n      vertex 0 1 0\n      vertex 1 0 0\n    endloop\n  endfacet\n"
    "FACET NORMAL 0 0 0\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\nVERTEX 1 0 0\r\nVERTEX 0 0 1\r\nENDLOOP\r\n"
    "ENDFACET\r\nfacet normal nan nan nan\nouter loop\nvertex 1 0 0\nvertex 1 0 0\nvertex 0 0 1\n"
    "endloop\nendfacet\nendsolid a body\n";

TEST(StlImport, ReadsText) {
    const TriangleMesh mesh = mesh_from_stl(kText, "file");
    EXPECT_THAT(mesh.positions_m, ElementsAre(glm::vec3(0, 0, 0), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0),
                                              glm::vec3(0, 0, 1)));
    // The third one is no more than a line.
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(StlImport, FaultsInTextAreNamedWithTheirLine) {
    const std::string text = kText;
    EXPECT_EQ(stl_fault("solid\nvertex 0 0 0"), "file, line 2: a corner stands outside of a loop.");
    EXPECT_EQ(stl_fault("solid\nouter loop\nvertex 0 inf 0"),
              "file, line 3: \"inf\" is not finite in single precision.");
    EXPECT_EQ(stl_fault("solid\nouter loop\nvertex 0 0"), "file, line 3: a number is missing.");
    EXPECT_EQ(stl_fault("solid\nouter loop\nvertex 0 0 0\nendloop"),
              "file, line 4: a loop ends that has no three corners.");
    EXPECT_EQ(stl_fault("solid\nouter loop\nouter loop"),
              "file, line 3: a loop begins within another one.");
    EXPECT_EQ(stl_fault("solid\nouter loop\nvertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3"),
              "file, line 6: a triangle has more than three corners.");
    EXPECT_EQ(stl_fault("solid\nouter loop\nendsolid"),
              "file, line 3: \"endloop\" is missing before \"endsolid\".");
    EXPECT_EQ(stl_fault("solid\nfacets"), "file, line 2: \"facets\" does not belong in an STL file.");
    EXPECT_EQ(stl_fault("solid\nendsolid\nouter loop\nvertex 1 2 3"),
              "file, line 4: the file ends here, before \"endsolid\".");
    // Wherever a text ends too early, that is noticed.
    for (std::size_t end = 5; end + 12 < text.size(); end += 7)
        EXPECT_NE(stl_fault(text.substr(0, end)), "") << end;
}

}  // namespace
}  // namespace pastoso::liquid_files
