#include "liquid_files/pbrt_scene.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/temporary_folder.hpp"
#include "liquid/vessel/cup_mesh.hpp"

#include <algorithm>
#include <sstream>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

namespace pastoso::liquid_files {
namespace {

using document::error_of;
using liquid::TriangleMesh;
using testing::HasSubstr;
using testing::Not;

const files::KeepGoing kToTheEnd = [](double) { return true; };

TriangleMesh tetrahedron() {
    return {{{0.05F, 0.05F, 0.05F}, {0.07F, 0.05F, 0.05F}, {0.05F, 0.07F, 0.05F}, {0.05F, 0.05F, 0.07F}},
            {},
            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// The numbers in the brackets after a parameter.
std::vector<float> numbers_of(const std::string& text, const std::string& parameter) {
    const std::size_t name = text.find("\"" + parameter + "\"");
    EXPECT_NE(name, std::string::npos) << parameter;
    const std::size_t open = text.find('[', name), close = text.find(']', open);
    std::istringstream words(text.substr(open + 1, close - open - 1));
    std::vector<float> numbers;
    for (float number = 0.0F; words >> number;)
        numbers.push_back(number);
    EXPECT_TRUE(words.eof());
    return numbers;
}

std::size_t count_of(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++count;
    return count;
}

class PbrtSceneTest : public files::TemporaryFolder {
  protected:
    std::string written(const PbrtScene& scene) {
        EXPECT_EQ(export_pbrt_scene(folder / "cup.pbrt", scene, kToTheEnd),
                  files::ExportStatus::Written);
        return core::read_text_file(folder / "cup.pbrt");
    }

    liquid::Cup cup;
    TriangleMesh milk = tetrahedron();
};

TEST_F(PbrtSceneTest, VersionFourHoldsTeaWithMilkInIt) {
    grid::BoxField dissolved({4, 3, 2, 0.025F});
    dissolved.at(3, 2, 1) = 0.5F;
    const std::string text = written({cup, milk, &dissolved});
    EXPECT_THAT(text, HasSubstr("\nScale -1 1 1\nLookAt "));
    EXPECT_LT(text.find("Camera"), text.find("WorldBegin"));
    EXPECT_THAT(text, Not(HasSubstr("WorldEnd")));
    EXPECT_EQ(count_of(text, "AttributeBegin"), count_of(text, "AttributeEnd"));
    EXPECT_THAT(
        text, HasSubstr("\"rgbgrid\" ] \"integer nx\" [ 4 ] \"integer ny\" [ 3 ] \"integer nz\" [ 2 ]"));
    const std::vector<float> absorption = numbers_of(text, "rgb sigma_a");
    const std::vector<float> scattering = numbers_of(text, "rgb sigma_s");
    ASSERT_EQ(absorption.size(), 3U * 24U);
    ASSERT_EQ(scattering.size(), 3U * 24U);
    EXPECT_EQ(absorption[3 * 7 + 1], 17.0F);
    // x runs fastest: the last cell is the last one.
    EXPECT_EQ(scattering.back(), 1500.0F);
    EXPECT_EQ(std::count(scattering.begin(), scattering.end(), 0.0F), 3 * 23);
    EXPECT_EQ(numbers_of(text, "point3 p1"), (std::vector<float>{0.1F, 0.075F, 0.05F}));
    // In the order of the glass, of the tea in it, of its surface: normals out of the denser side.
    const std::size_t glass = text.find("\"dielectric\" \"float eta\" [ 1.5 ]");
    const std::size_t tea =
        text.find("\"dielectric\" \"float eta\" [ 0.89 ]\n MediumInterface \"tea\" \"\"");
    const std::size_t level =
        text.find("\"dielectric\" \"float eta\" [ 1.335 ]\n MediumInterface \"tea\" \"\"");
    EXPECT_LT(glass, tea);
    EXPECT_LT(tea, level);
    EXPECT_LT(level, text.find("\"diffuse\" \"rgb reflectance\" [ 0.97 0.94 0.86 ]"));
}

TEST_F(PbrtSceneTest, OlderSyntaxesHaveTheirOwnWords) {
    const std::string third = written({cup, milk, nullptr, PbrtSyntax::V3});
    for (const char* part :
         {"Scale -1 1 1\nLookAt", "Film \"image\"", "Integrator \"volpath\"",
          "MakeNamedMedium \"tea\" \"string type\" [ \"homogeneous\" ] \"rgb sigma_a\" [ 4.5 17 48 ]",
          "Material \"glass\" \"float eta\" [ 1.5 ]", "MediumInterface \"tea\" \"\"",
          "Material \"matte\" \"rgb Kd\"", "WorldEnd\n"})
        EXPECT_THAT(third, HasSubstr(part));
    EXPECT_THAT(third, Not(HasSubstr("point3")));
    EXPECT_THAT(core::read_text_file(folder / "cup-milk.pbrt"), HasSubstr("\"point P\""));
    const std::string second = written({cup, milk, nullptr, PbrtSyntax::V2});
    for (const char* part :
         {"SurfaceIntegrator \"path\"", "VolumeIntegrator", "\"color Kr\" [ 1 1 1 ]",
          "\"float index\" [ 1.5 ]", "Volume \"homogeneous\" \"color sigma_a\" [ 4.5 17 48 ]",
          "Material \"matte\" \"color Kd\"", "WorldEnd\n"})
        EXPECT_THAT(second, HasSubstr(part));
    for (const char* part : {"Medium", "rgb", "\nIntegrator", "point3"})
        EXPECT_THAT(second, Not(HasSubstr(part)));
}

TEST_F(PbrtSceneTest, IncludesWhatIsWrittenBesideIt) {
    for (const PbrtSyntax syntax : {PbrtSyntax::V4, PbrtSyntax::V3, PbrtSyntax::V2}) {
        const std::string text = written({cup, milk, nullptr, syntax});
        EXPECT_EQ(count_of(text, "Include "), 4U);
        for (const char* part : {"cup-glass.pbrt", "cup-tea.pbrt", "cup-level.pbrt", "cup-milk.pbrt"}) {
            EXPECT_THAT(text, HasSubstr(std::string(" Include \"") + part + "\"\n"));
            EXPECT_EQ(count_of(core::read_text_file(folder / part), "Shape \"trianglemesh\""), 1U);
        }
    }
    EXPECT_EQ(files_in_folder(), 5U);
    EXPECT_EQ(pbrt_scene_files(folder / "cup.pbrt").size(), 5U);
}

/// PBRT mirrors the points, takes the cross product of the mirrored triangle's sides and turns it round,
/// because the transform changes the handedness. That must be where the mirrored normals point.
TEST_F(PbrtSceneTest, NormalsPointOutwardsInPbrtsMirroredWorld) {
    written({cup, milk});
    for (const char* part : {"cup-glass.pbrt", "cup-tea.pbrt", "cup-level.pbrt"}) {
        const std::string text = core::read_text_file(folder / part);
        const std::vector<float> points = numbers_of(text, "point3 P"),
                                 normals = numbers_of(text, "normal N"),
                                 indices = numbers_of(text, "integer indices");
        const auto mirrored = [](const std::vector<float>& from, float index) {
            const std::size_t at = 3 * static_cast<std::size_t>(index);
            return glm::vec3(-from.at(at), from.at(at + 1), from.at(at + 2));
        };
        for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
            const glm::vec3 a = mirrored(points, indices[t]), b = mirrored(points, indices[t + 1]),
                            c = mirrored(points, indices[t + 2]);
            const glm::vec3 outwards = -glm::cross(b - a, c - a);
            EXPECT_GT(glm::dot(outwards, mirrored(normals, indices[t])), 0.0F) << part;
        }
    }
}

TEST_F(PbrtSceneTest, WithoutMilkTheSceneIsStillWhole) {
    milk = {};
    EXPECT_EQ(count_of(written({cup, milk}), "Include "), 4U);
    EXPECT_EQ(core::read_text_file(folder / "cup-milk.pbrt"), "# Pastoso milk, metres, z up\n");
}

TEST_F(PbrtSceneTest, AStoppedExportLeavesTheOldScene) {
    core::write_text_file(folder / "cup.pbrt", "old");
    EXPECT_EQ(
        export_pbrt_scene(folder / "cup.pbrt", {cup, milk}, [](double done) { return done < 0.7; }),
        files::ExportStatus::Stopped);
    EXPECT_EQ(core::read_text_file(folder / "cup.pbrt"), "old");
    EXPECT_THAT(error_of([&] {
                    export_pbrt_scene(folder / "cup.obj", {cup, milk}, kToTheEnd);
                }),
                HasSubstr("cup.obj: a scene is saved as .pbrt"));
}

}  // namespace
}  // namespace pastoso::liquid_files
