// Paints one stroke, lets the paint run for two seconds, and writes a picture of it: paint FILE.png
#include "core/error.hpp"
#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "document/player.hpp"
#include "files/image.hpp"
#include "recordings/canvas_support.hpp"
#include "recordings/recording_text.hpp"
#include "shade/render.hpp"

#include <cstdio>
#include <string>

namespace {

using namespace pastoso;

/// Seconds, mm, mm and pressure.
std::string pen_trace() {
    std::string lines;
    for (int i = 0; i <= 60; ++i)
        lines += std::to_string(0.01 * i) + " " + std::to_string(10 + 0.5 * i) + " 15 0.6\n";
    return lines;
}

document::Recording recording() {
    recordings::TraceSetup setup;
    setup.canvas.width_mm = 50.0;
    setup.canvas.height_mm = 30.0;
    setup.medium = "heavy-body oil";
    setup.brush.preset = "Flat bristle 20";
    setup.brush.size_mm = 8.0;
    setup.paints = {{.ingredients = {{.pigment = "PB29", .parts = 1.0}}}};
    return recordings::recording_from_trace(recordings::parse_pen_trace(pen_trace(), "stroke"), setup);
}

void paint(const char* file) {
    core::ThreadPool pool;
    const document::Recording strokes = recording();
    const auto painting = recordings::make_painting(strokes.canvas, pool);
    document::Player player(*painting, strokes);
    while (!player.finished())
        player.play_tick();
    const film::FilmState& film = painting->film();
    files::write_image(file, pigment::encode_srgb8(shade::render(film, document::kPrimedGround,
                                                                 film.shape.cells(), {}, pool)));
    std::printf("%s: %d x %d pixels\n", file, film.shape.width, film.shape.height);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    try {
        paint(argv[1]);
    } catch (const core::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
