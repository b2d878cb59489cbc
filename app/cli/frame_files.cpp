#include "cli/frame_files.hpp"

#include "cli/interrupt.hpp"
#include "cli/stopwatch.hpp"
#include "cli/usage_error.hpp"
#include "core/check.hpp"
#include "core/error.hpp"
#include "core/looking.hpp"
#include "liquid_files/traced_picture.hpp"
#include "trace/tracer.hpp"

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

void stop_where(files::ExportStatus status) {
    if (status == files::ExportStatus::Stopped) throw Interrupted{};
}

liquid_files::PbrtSyntax syntax_of(int version) {
    if (version == 4) return liquid_files::PbrtSyntax::V4;
    return version == 3 ? liquid_files::PbrtSyntax::V3 : liquid_files::PbrtSyntax::V2;
}

}  // namespace

FrameFiles::Kind FrameFiles::kind_of(const std::string& format) {
    if (format == kSceneFormat) return Kind::Scene;
    if (format == kVolumeFormat) return Kind::Volume;
    return liquid_files::is_mesh_path("surface." + format) ? Kind::Mesh : Kind::Picture;
}

FrameFiles::FrameFiles(fs::path folder, std::string name, const FrameFileOptions& options,
                       core::ThreadPool& pool)
    : folder_(std::move(folder)),
      name_(std::move(name)),
      options_(options),
      pool_(pool),
      kind_(kind_of(options.format)),
      mesh_{name_, syntax_of(options.pbrt_syntax)} {
    const Size size = parse_size(options.size);
    width_px_ = size.width_px;
    height_px_ = size.height_px;
    if (kind_ == Kind::Volume && !liquid_files::has_openvdb())
        throw UsageError("--format vdb: this program was built without OpenVDB.");
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw core::InputError("%1: cannot be made (%2).", folder_.string(), error.message());
    if (kind_ == Kind::Picture) liquid_files::check_traced_path(path_of(1));
}

bool FrameFiles::is_wanted(int frame) const {
    return frame % options_.every == 0 && !core::is_there(path_of(frame));
}

fs::path FrameFiles::path_of(int frame) const {
    char digits[16];
    std::snprintf(digits, sizeof digits, "%04d", frame);
    if (kind_ == Kind::Scene) return folder_ / ("scene_" + std::string(digits) + ".pbrt");
    return folder_ / (name_ + "_" + digits + "." + options_.format);
}

void FrameFiles::write_mesh(int frame, const liquid::TriangleMesh& mesh) {
    PASTOSO_CHECK(kind_ == Kind::Mesh);
    costs_.io_s +=
        seconds_of([&] { stop_where(liquid_files::export_mesh(path_of(frame), mesh, mesh_, go_on)); });
    ++costs_.frames;
}

void FrameFiles::write_picture(int frame, const trace::Scene& scene) {
    PASTOSO_CHECK(kind_ == Kind::Picture);
    trace::TraceSettings settings;
    settings.width = width_px_;
    settings.height = height_px_;
    trace::PathTracer tracer(scene, settings, pool_);
    costs_.trace_s += seconds_of([&] {
        if (!tracer.add_samples(options_.samples, [] { return is_interrupted(); })) throw Interrupted{};
    });
    trace::Picture picture;
    costs_.denoise_s += seconds_of([&] { picture = tracer.denoised(); });
    costs_.io_s += seconds_of([&] { liquid_files::write_traced_picture(path_of(frame), picture); });
    ++costs_.frames;
}

void FrameFiles::write_scene(int frame, liquid_files::PbrtScene scene) {
    PASTOSO_CHECK(kind_ == Kind::Scene);
    scene.syntax = mesh_.syntax;
    if (scene.syntax != liquid_files::PbrtSyntax::V4) scene.dissolved = nullptr;
    scene.width = width_px_;
    scene.height = height_px_;
    scene.samples = options_.samples;
    costs_.io_s +=
        seconds_of([&] { stop_where(liquid_files::export_pbrt_scene(path_of(frame), scene, go_on)); });
    ++costs_.frames;
}

void FrameFiles::write_volume(int frame, const liquid_files::VdbFields& fields) {
    PASTOSO_CHECK(kind_ == Kind::Volume);
    costs_.io_s += seconds_of([&] { liquid_files::export_vdb(path_of(frame), fields); });
    ++costs_.frames;
}

}  // namespace pastoso::cli
