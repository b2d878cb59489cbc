#include "cli/tea_files.hpp"

#include "cli/interrupt.hpp"
#include "cli/stopwatch.hpp"
#include "cli/usage_error.hpp"
#include "core/check.hpp"
#include "core/error.hpp"
#include "io/pbrt_scene.hpp"
#include "io/traced_picture.hpp"
#include "io/vdb_export.hpp"
#include "trace/tea_scene.hpp"
#include "trace/tracer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace pastoso::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSceneFormat = "pbrt-scene";
constexpr const char* kVolumeFormat = "vdb";
constexpr int kMostPixels = 16384;  ///< a side, as the tracer has it

struct Size {
    int width_px = 0, height_px = 0;
};

Size parse_size(const std::string& text) {
    Size size;
    int read = 0;
    const bool two_numbers =
        std::sscanf(text.c_str(), "%5dx%5d%n", &size.width_px, &size.height_px, &read) == 2 &&
        static_cast<std::size_t>(read) == text.size();
    const auto fits = [](int side) { return side >= 1 && side <= kMostPixels; };
    if (!two_numbers || !fits(size.width_px) || !fits(size.height_px)) {
        throw UsageError("--size: \"" + text + "\" is not a size such as 800x800, of 1 to " +
                         std::to_string(kMostPixels) + " pixels a side.");
    }
    return size;
}

bool go_on(double) {
    return !is_interrupted();
}

io::PbrtSyntax syntax_of(int version) {
    if (version == 4) return io::PbrtSyntax::V4;
    return version == 3 ? io::PbrtSyntax::V3 : io::PbrtSyntax::V2;
}

}  // namespace

TeaFiles::Kind TeaFiles::kind_of(const std::string& format) {
    if (format == kSceneFormat) return Kind::Scene;
    if (format == kVolumeFormat) return Kind::Volume;
    return io::is_mesh_path("milk." + format) ? Kind::Mesh : Kind::Picture;
}

TeaFiles::TeaFiles(fs::path folder, const TeaPictureOptions& options, const liquid::Cup& cup,
                   core::ThreadPool& pool)
    : folder_(std::move(folder)),
      options_(options),
      cup_(cup),
      pool_(pool),
      surfaces_(pool),
      kind_(kind_of(options.format)) {
    const Size size = parse_size(options.size);
    width_px_ = size.width_px;
    height_px_ = size.height_px;
    mesh_.syntax = syntax_of(options.pbrt_syntax);
    if (kind_ == Kind::Volume && !io::has_openvdb())
        throw UsageError("--format vdb: this program was built without OpenVDB.");
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw core::InputError(folder_.string() + ": cannot be made (" + error.message() + ").");
    if (kind_ == Kind::Picture) io::check_traced_path(path_of(1));
}

bool TeaFiles::is_wanted(int frame) const {
    std::error_code ignored;
    return frame % options_.every == 0 && !fs::exists(path_of(frame), ignored);
}

fs::path TeaFiles::path_of(int frame) const {
    char digits[16];
    std::snprintf(digits, sizeof digits, "%04d", frame);
    if (kind_ == Kind::Scene) return folder_ / ("scene_" + std::string(digits) + ".pbrt");
    return folder_ / ("milk_" + std::string(digits) + "." + options_.format);
}

void TeaFiles::write(int number, const liquid::TeaFrame& frame) {
    liquid::MilkSurface surface;
    stats_.surface_s +=
        seconds_of([&] { surface = surfaces_.make(frame.parcels, cup_, frame.dissolved.shape()); });
    stats_.triangles = static_cast<std::int64_t>(surface.mesh.triangles.size());
    stats_.surface_error_rel = std::max(stats_.surface_error_rel, std::abs(surface.volume_error()));
    const fs::path path = path_of(number);
    if (kind_ == Kind::Picture)
        write_picture(path, trace::tea_scene(cup_, frame.dissolved, std::move(surface.mesh)));
    else if (kind_ == Kind::Scene)
        write_scene(path, frame, surface.mesh);
    else if (kind_ == Kind::Volume)
        write_volume(path, frame);
    else
        write_mesh(path, surface.mesh);
    ++stats_.frames;
}

void TeaFiles::write_surface(int number, const liquid::TriangleMesh& surface) {
    PASTOSO_CHECK(kind_ == Kind::Mesh);
    stats_.triangles = static_cast<std::int64_t>(surface.triangles.size());
    write_mesh(path_of(number), surface);
    ++stats_.frames;
}

void TeaFiles::add_to(io::TeaStats& stats) const {
    stats.surface_s += stats_.surface_s;
    stats.trace_s += stats_.trace_s;
    stats.denoise_s += stats_.denoise_s;
    stats.io_s += stats_.io_s;
    stats.frames += stats_.frames;
    stats.triangles = stats_.triangles;
    stats.surface_error_rel = stats_.surface_error_rel;
}

void TeaFiles::write_mesh(const fs::path& path, const liquid::TriangleMesh& mesh) {
    io::ExportStatus status{};
    stats_.io_s += seconds_of([&] { status = io::export_mesh(path, mesh, mesh_, go_on); });
    if (status == io::ExportStatus::Stopped) throw Interrupted{};
}

void TeaFiles::write_scene(const fs::path& path, const liquid::TeaFrame& frame,
                           const liquid::TriangleMesh& milk) {
    io::PbrtScene scene{.cup = cup_, .milk = milk};
    if (mesh_.syntax == io::PbrtSyntax::V4) scene.dissolved = &frame.dissolved;
    scene.syntax = mesh_.syntax;
    scene.width = width_px_;
    scene.height = height_px_;
    scene.samples = options_.samples;
    io::ExportStatus status{};
    stats_.io_s += seconds_of([&] { status = io::export_pbrt_scene(path, scene, go_on); });
    if (status == io::ExportStatus::Stopped) throw Interrupted{};
}

void TeaFiles::write_volume(const fs::path& path, const liquid::TeaFrame& frame) {
    grid::BoxField temperature = frame.coldness;
    for (float& value : temperature.values())
        value = 1.0F - value;
    stats_.io_s += seconds_of(
        [&] { io::export_vdb(path, {.density = &frame.dissolved, .temperature = &temperature}); });
}

void TeaFiles::write_picture(const fs::path& path, const trace::Scene& scene) {
    trace::TraceSettings settings;
    settings.width = width_px_;
    settings.height = height_px_;
    trace::TeaTracer tracer(scene, settings, pool_);
    stats_.trace_s += seconds_of([&] {
        if (!tracer.add_samples(options_.samples, [] { return is_interrupted(); })) throw Interrupted{};
    });
    trace::Picture picture;
    stats_.denoise_s += seconds_of([&] { picture = tracer.denoised(); });
    stats_.io_s += seconds_of([&] { io::write_traced_picture(path, picture); });
}

}  // namespace pastoso::cli
