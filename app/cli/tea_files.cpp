#include "cli/tea_files.hpp"

#include "cli/stopwatch.hpp"
#include "trace/tea_scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::cli {

TeaFiles::TeaFiles(std::filesystem::path folder, const FrameFileOptions& options, const liquid::Cup& cup,
                   core::ThreadPool& pool)
    : files_(std::move(folder), "milk", options, pool), cup_(cup), surfaces_(pool) {}

void TeaFiles::write(int number, const liquid::TeaFrame& frame) {
    using enum FrameFiles::Kind;
    liquid::TriangleMesh milk = surface_of(frame);
    switch (files_.kind()) {
        case Picture:
            return files_.write_picture(number,
                                        trace::tea_scene(cup_, frame.dissolved, std::move(milk)));
        case Mesh:
            return files_.write_mesh(number, milk);
        case Scene:
            return files_.write_scene(number,
                                      {.cup = cup_, .milk = milk, .dissolved = &frame.dissolved});
        case Volume:
            return write_volume(number, frame);
    }
}

liquid::TriangleMesh TeaFiles::surface_of(const liquid::TeaFrame& frame) {
    liquid_files::FrameCosts& costs = files_.costs();
    liquid::MilkSurface surface;
    costs.surface_s +=
        seconds_of([&] { surface = surfaces_.make(frame.parcels, cup_, frame.dissolved.shape()); });
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
