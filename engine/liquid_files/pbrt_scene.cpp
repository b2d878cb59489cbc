#include "liquid_files/pbrt_scene.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "liquid/vessel/cup_mesh.hpp"
#include "liquid_files/pbrt_text.hpp"

#include <cstddef>
#include <string>

namespace pastoso::liquid_files {
namespace {

using std::to_string;

/// Indices of refraction: glass, tea against glass, tea.
constexpr float kGlass = 1.5F, kTeaInGlass = 0.89F, kTea = 1.335F;
constexpr std::array<float, 3> kMilkColour = {0.97F, 0.94F, 0.86F};

std::string numbers(const std::array<float, 3>& values) {
    return pbrt_numbers({values[0], values[1], values[2]});
}

/// What all three syntaxes begin with. PBRT is left-handed: x is mirrored first, so that all else may be
/// as it is.
std::string view_text(const PbrtScene& scene) {
    const char* film = scene.syntax == PbrtSyntax::V4 ? "rgb" : "image";
    std::string text =
        "Scale -1 1 1\n"
        "LookAt 0.13 -0.3 0.15  0.05 0.05 0.045  0 0 1\n"
        "Camera \"perspective\" \"float fov\" [ 24 ]\n";
    text += std::string("Film \"") + film + "\" \"integer xresolution\" [ " + to_string(scene.width) +
            " ] \"integer yresolution\" [ " + to_string(scene.height) +
            " ] \"string filename\" [ \"cup.exr\" ]\n";
    const char* sampler[] = {"zsobol", "halton", "lowdiscrepancy"};
    text += std::string("Sampler \"") + sampler[static_cast<int>(scene.syntax)] +
            "\" \"integer pixelsamples\" [ " + to_string(scene.samples) + " ]\n";
    if (scene.syntax == PbrtSyntax::V2)
        return text +
               "SurfaceIntegrator \"path\" \"integer maxdepth\" [ 20 ]\n"
               "VolumeIntegrator \"emission\" \"float stepsize\" [ 0.002 ]\n";
    return text + "Integrator \"volpath\" \"integer maxdepth\" [ 100 ]\n";
}

std::string light_text(PbrtSyntax syntax) {
    const std::string kind = syntax == PbrtSyntax::V2 ? "color" : "rgb";
    const std::string area = syntax == PbrtSyntax::V2 ? "area" : "diffuse";
    return "LightSource \"infinite\" \"" + kind +
           " L\" [ 0.75 0.78 0.84 ]\n"
           "AttributeBegin\n AreaLightSource \"" +
           area + "\" \"" + kind +
           " L\" [ 15 14.2 13 ]\n Translate -0.5 -0.45 0.8\n"
           " LookAt 0 0 0  -0.55 -0.5 0.85  0 0 1\n Shape \"disk\" \"float radius\" [ 0.33 "
           "]\nAttributeEnd\n";
}

std::string dielectric(PbrtSyntax syntax, float index) {
    if (syntax == PbrtSyntax::V4)
        return "Material \"dielectric\" \"float eta\" [ " + pbrt_numbers({index}) + " ]";
    if (syntax == PbrtSyntax::V3)
        return "Material \"glass\" \"float eta\" [ " + pbrt_numbers({index}) + " ]";
    return "Material \"glass\" \"color Kr\" [ 1 1 1 ] \"color Kt\" [ 1 1 1 ] \"float index\" [ " +
           pbrt_numbers({index}) + " ]";
}

std::string matte(PbrtSyntax syntax, const std::array<float, 3>& colour) {
    const char* words[] = {"\"diffuse\" \"rgb reflectance\"", "\"matte\" \"rgb Kd\"",
                           "\"matte\" \"color Kd\""};
    return std::string("Material ") + words[static_cast<int>(syntax)] + " [ " + numbers(colour) + " ]";
}

std::string table_text(const PbrtScene& scene) {
    const char* point = scene.syntax == PbrtSyntax::V4 ? "point3 P" : "point P";
    return "AttributeBegin\n " + matte(scene.syntax, {0.55F, 0.52F, 0.48F}) +
           "\n Shape \"trianglemesh\" \"" + point +
           "\" [ -1 -1 -0.002  1 -1 -0.002  1 1 -0.002  -1 1 -0.002 ] \"integer indices\" [ 0 1 2 0 2 3 "
           "]\n"
           "AttributeEnd\n";
}

std::string part_text(const std::string& material, bool holds_tea,
                      const std::filesystem::path& included) {
    return "AttributeBegin\n " + material + "\n" + (holds_tea ? " MediumInterface \"tea\" \"\"\n" : "") +
           " Include \"" + included.filename().string() + "\"\nAttributeEnd\n";
}

bool has_dissolved(const PbrtScene& scene) {
    return scene.syntax == PbrtSyntax::V4 && scene.dissolved != nullptr &&
           scene.dissolved->shape().nx > 0;
}

/// The tea without milk: the same everywhere.
std::string clear_tea_text(const PbrtScene& scene) {
    const std::string absorption = numbers(scene.absorption_per_m);
    if (scene.syntax == PbrtSyntax::V2) {
        const liquid::Cup& cup = scene.cup;
        const float radius = cup.inner_radius_m(cup.level_m);
        return "Volume \"homogeneous\" \"color sigma_a\" [ " + absorption +
               " ] \"color sigma_s\" [ 0 0 0 ] \"point p0\" [ " +
               pbrt_numbers({cup.axis_m.x - radius, cup.axis_m.y - radius, cup.floor_m}) +
               " ] \"point p1\" [ " +
               pbrt_numbers({cup.axis_m.x + radius, cup.axis_m.y + radius, cup.level_m}) + " ]\n";
    }
    return "MakeNamedMedium \"tea\" \"string type\" [ \"homogeneous\" ] \"rgb sigma_a\" [ " +
           absorption + " ] \"rgb sigma_s\" [ 0 0 0 ] \"float g\" [ 0 ]\n";
}

/// Tea that absorbs everywhere and scatters where milk is. "uniformgrid" scales both at once.
void add_milky_tea(const PbrtScene& scene, files::PieceWriter& writer) {
    const grid::BoxShape& shape = scene.dissolved->shape();
    const auto side = [&](int cells) { return static_cast<float>(cells) * shape.cell_m; };
    writer.add_text("MakeNamedMedium \"tea\" \"string type\" [ \"rgbgrid\" ] \"integer nx\" [ " +
                    to_string(shape.nx) + " ] \"integer ny\" [ " + to_string(shape.ny) +
                    " ] \"integer nz\" [ " + to_string(shape.nz) +
                    " ]\n \"point3 p0\" [ 0 0 0 ] \"point3 p1\" [ " +
                    pbrt_numbers({side(shape.nx), side(shape.ny), side(shape.nz)}) +
                    " ] \"float g\" [ 0 ] \"float scale\" [ 1 ]\n");
    const auto add_grid = [&](const char* name, const auto& text_of) {
        writer.add_text(std::string(" \"rgb ") + name + "\" [\n");
        for (int k = 0; k < shape.nz; ++k)
            for (int j = 0; j < shape.ny; ++j)
                for (int i = 0; i < shape.nx; ++i) {
                    writer.add_text(text_of(scene.dissolved->at(i, j, k)) + "\n");
                    writer.item_done();
                }
        writer.add_text(" ]\n");
    };
    add_grid("sigma_a", [&](float) { return numbers(scene.absorption_per_m); });
    add_grid("sigma_s", [&](float share) {
        const float scattering = scene.scattering_per_m * (share > 0.0F ? share : 0.0F);
        return pbrt_numbers({scattering, scattering, scattering});
    });
}

files::ExportStatus write_scene(const std::vector<std::filesystem::path>& files, const PbrtScene& scene,
                                const files::KeepGoing& keep_going) {
    const std::size_t cells = has_dissolved(scene)
                                  ? static_cast<std::size_t>(scene.dissolved->shape().nx) *
                                        static_cast<std::size_t>(scene.dissolved->shape().ny) *
                                        static_cast<std::size_t>(scene.dissolved->shape().nz)
                                  : 0;
    const bool has_media = scene.syntax != PbrtSyntax::V2;
    return files::write_in_pieces(files[0], 2 * cells, keep_going, [&](files::PieceWriter& writer) {
        writer.add_text("# Pastoso: milk in a glass of tea; metres, z up\n" + view_text(scene) +
                        "WorldBegin\n" + light_text(scene.syntax));
        if (has_dissolved(scene))
            add_milky_tea(scene, writer);
        else
            writer.add_text(clear_tea_text(scene));
        writer.add_text(table_text(scene) +
                        part_text(dielectric(scene.syntax, kGlass), false, files[1]) +
                        part_text(dielectric(scene.syntax, kTeaInGlass), has_media, files[2]) +
                        part_text(dielectric(scene.syntax, kTea), has_media, files[3]) +
                        part_text(matte(scene.syntax, kMilkColour), false, files[4]));
        if (scene.syntax != PbrtSyntax::V4) writer.add_text("WorldEnd\n");
    });
}

}  // namespace

std::vector<std::filesystem::path> pbrt_scene_files(const std::filesystem::path& path) {
    std::vector<std::filesystem::path> files = {path};
    for (const char* part : {"glass", "tea", "level", "milk"})
        files.push_back(path.parent_path() /
                        (path.stem().string() + "-" + part + path.extension().string()));
    return files;
}

files::ExportStatus export_pbrt_scene(const std::filesystem::path& path, const PbrtScene& scene,
                                      const files::KeepGoing& keep_going) {
    if (core::lower_case(path.extension().string()) != ".pbrt")
        throw core::InputError("%1: a scene is saved as .pbrt; this name ends otherwise.",
                               path.string());
    const std::vector<std::filesystem::path> files = pbrt_scene_files(path);
    const liquid::CupMeshes cup = liquid::cup_meshes(scene.cup);
    const liquid::TriangleMesh* meshes[] = {&cup.glass_air, &cup.tea_glass, &cup.tea_air, &scene.milk};
    const char* names[] = {"glass against air", "tea against glass", "tea against air", "milk"};
    for (std::size_t part = 0; part < 4; ++part) {
        const files::KeepGoing share = [&](double done) {
            return keep_going((static_cast<double>(part) + done) / 5.0);
        };
        if (export_mesh(files[part + 1], *meshes[part], {names[part], scene.syntax}, share) ==
            files::ExportStatus::Stopped)
            return files::ExportStatus::Stopped;
    }
    return write_scene(files, scene, [&](double done) { return keep_going((4.0 + done) / 5.0); });
}

}  // namespace pastoso::liquid_files
