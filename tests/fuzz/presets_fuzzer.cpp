// Presets of any text: refused in a sentence, or a tool that is written and read again alike and draws a
// line.
#include "brush/brush.hpp"
#include "brush/preset.hpp"
#include "brush/stroke.hpp"
#include "core/check.hpp"
#include "core/error.hpp"

#include <cstdint>
#include <string_view>

namespace pastoso::brush {
namespace {

void draw_line(const Preset& preset) {
    film::FilmState film({64, 64}, 0.25);
    Brush brush(preset);
    film::PaintCoefficients paint{};
    paint.fill(2.0F);
    brush.load(paint, 1.0);
    Stroke stroke(brush, film);
    stroke.begin({.x_mm = 7.0, .y_mm = 8.0, .pressure = 0.5});
    stroke.add({.time_s = 0.02, .x_mm = 9.0, .y_mm = 8.5, .pressure = 0.7, .tilt_x_deg = 20.0});
    stroke.pass_time(1.0 / 60.0);
    stroke.end();
}

void try_preset(std::string_view text) {
    const Preset preset = parse_preset(text, "file");
    PASTOSO_CHECK(parse_preset(preset_to_json(preset), "written") == preset);
    draw_line(preset);
}

}  // namespace
}  // namespace pastoso::brush

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        pastoso::brush::try_preset({reinterpret_cast<const char*>(data), size});
    } catch (const pastoso::core::InputError& error) {
        PASTOSO_CHECK(std::string_view(error.what()).starts_with("file"));
    }
    return 0;
}
