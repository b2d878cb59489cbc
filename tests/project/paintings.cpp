#include "project/paintings.hpp"

#include "core/text_file.hpp"
#include "document/player.hpp"
#include "document/well_session.hpp"
#include "project/project_archive.hpp"

namespace pastoso::project {
namespace {

film::Medium quicker_house_paint() {
    film::Medium medium = film::find_medium("house paint");
    medium.touch_dry_s = 1234.5;
    medium.yield_stress_Pa = 0.1;
    medium.structure_share = 0.4;
    return medium;
}

}  // namespace

document::Recording busy_session() {
    using namespace document;
    Recording recording;
    recording.canvas = small_canvas();
    recording.canvas.width_mm = 60.0;
    auto& events = recording.events;
    std::int64_t tick = 0;
    const auto stroke = [&](Surface surface, double y_mm) {
        const auto start_s = static_cast<double>(tick) * kTick_s;
        for (const Action& action : line_on(surface, start_s, 8, 34, y_mm))
            events.push_back({tick++, action});
    };
    events = {{0, UseMedium{"ink glaze"}},
              {0, SetDrying{{.speed = 5000.0}}},
              {0, TakeBrush{"flat", 8, 1}},
              {0, load_of("PR108")}};
    stroke(Surface::Canvas, 10);
    events.push_back({tick, DryNow{}});
    events.push_back({tick, UseMedium{"house paint", quicker_house_paint()}});
    events.push_back({tick, SetDrying{{.speed = 20.0, .fan = 2.0, .fan_radius_mm = 9.0}}});
    events.push_back({tick, TiltCanvas{60, 80}});
    events.push_back({tick, squeeze_of("PB29", 30, 40)});
    events.push_back({tick, TakeBrush{"round", 9, 7}});
    events.push_back({tick, load_of("PY35", 0.9)});
    stroke(Surface::Well, 40);
    stroke(Surface::Canvas, 14);
    events.push_back({tick, SetStabiliser{{.smoothing_ms = 20.0, .string_mm = 0.5}}});
    events.push_back({tick, SetSymmetry{{.centre_x_mm = 30, .centre_y_mm = 15, .mirror = true}}});
    tick += 20;
    stroke(Surface::Canvas, 20);
    recording.end_tick = tick + 60;
    return recording;
}

std::unique_ptr<document::Painting> played(const document::Recording& recording, std::int64_t tick,
                                           core::ThreadPool& pool) {
    auto painting = std::make_unique<document::Painting>(recording.canvas, pool);
    document::Player player(*painting, recording);
    while (!player.finished() && painting->tick() < tick)
        player.play_tick();
    return painting;
}

Project project_of(const document::Painting& painting, const document::Recording& recording) {
    Project project{painting.state(), recording};
    std::erase_if(project.strokes.events, [&](const auto& event) {
        return event.tick >= painting.tick() && event.tick < recording.end_tick;
    });
    project.strokes.end_tick = painting.tick();
    return project;
}

Project busy_project(core::ThreadPool& pool) {
    constexpr std::int64_t kBetweenStrokes = 85;
    const document::Recording recording = busy_session();
    return project_of(*played(recording, kBetweenStrokes, pool), recording);
}

std::vector<std::byte> bytes_in(const std::filesystem::path& path) {
    const std::string text = core::read_text_file(path);
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

std::vector<std::byte> file_of(const Project& project, const std::filesystem::path& folder,
                               core::ThreadPool& pool) {
    const std::filesystem::path path = folder / "painting.pastoso";
    save_project(path, project, pool);
    std::vector<std::byte> bytes = bytes_in(path);
    std::filesystem::remove(path);
    return bytes;
}

std::vector<std::byte> unseen_file_of(const Project& project, const std::filesystem::path& folder,
                                      core::ThreadPool& pool) {
    const std::filesystem::path path = folder / "painting.pastoso";
    const pigment::LinearImage grey{2, 2, std::vector<float>(12, 0.5F), {}};
    const Pictures pictures{grey, 1.0, {{"Paint", true, pigment::encode_srgb8(grey), {}}}};
    core::write_aside(path, [&](core::OutputFile& file) { write_archive(project, pictures, pool, file); });
    std::vector<std::byte> bytes = bytes_in(path);
    std::filesystem::remove(path);
    return bytes;
}

}  // namespace pastoso::project
