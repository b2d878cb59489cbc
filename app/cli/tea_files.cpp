#include "cli/tea_files.hpp"

#include "cli/stopwatch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::cli {

TeaFiles::TeaFiles(std::filesystem::path folder, const FrameFileOptions& options,
                   const liquid::TeaSettings& settings, trace::MilkBody body, core::ThreadPool& pool)
    : files_(std::move(folder), "milk", options, pool),
      settings_(settings),
      body_(body),
      densities_(pool),
      surfaces_(pool) {}

void TeaFiles::write(int number, const liquid::TeaFrame& frame) {
    using enum FrameFiles::Kind;
    switch (files_.kind()) {
        case Picture:
            return files_.write_picture(number, scene_of(frame));
        case Mesh:
            return files_.write_mesh(number, surface_of(frame));
        case Scene: {
            const liquid::TriangleMesh milk = surface_of(frame);
            return files_.write_scene(
                number, {.cup = cup_in(frame), .milk = milk, .dissolved = &frame.dissolved});
        }
        case Volume:
            return write_volume(number, frame);
    }
}

trace::Scene TeaFiles::scene_of(const liquid::TeaFrame& frame) {
    const liquid::Cup& cup = settings_.cup;
    if (body_ == trace::MilkBody::Surface)
        return trace::tea_scene(cup, frame.pour, grid::BlockField(frame.dissolved), surface_of(frame));
    grid::BlockField share;
    files_.costs().surface_s += seconds_of([&] {
        share = densities_.make(frame.parcels, frame.dissolved, cup_in(frame),
                                liquid::even_density(settings_));
    });
    return trace::tea_scene(cup, frame.pour, std::move(share));
}

liquid::Cup TeaFiles::cup_in(const liquid::TeaFrame& frame) const {
    return liquid::cup_in(frame.pour, settings_.cup);
}

liquid::TriangleMesh TeaFiles::surface_of(const liquid::TeaFrame& frame) {
    liquid_files::FrameCosts& costs = files_.costs();
    liquid::MilkSurface surface;
    costs.surface_s += seconds_of(
        [&] { surface = surfaces_.make(frame.parcels, cup_in(frame), frame.dissolved.shape()); });
    costs.triangles = static_cast<std::int64_t>(surface.mesh.triangles.size());
    costs.surface_error_rel = std::max(costs.surface_error_rel, std::abs(surface.volume_error()));
    return std::move(surface.mesh);
}

void TeaFiles::write_volume(int number, const liquid::TeaFrame& frame) {
    grid::BoxField temperature = frame.coldness;
    for (float& value : temperature.values())
        value = 1.0F - value;
    files_.write_volume(number, {.density = &frame.dissolved, .temperature = &temperature});
}

}  // namespace pastoso::cli
