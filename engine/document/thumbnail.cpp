#include "document/thumbnail.hpp"

#include "document/sample_board.hpp"
#include "document/tool_sample.hpp"

namespace pastoso::document {
namespace {

using brush::PenSample;

/// The right half of the board black, and dry.
void black_half(SampleBoard& board) {
    board.use_medium("fluid acrylic");
    board.take("Impasto flat 18", 0.5);
    board.load(tinted("PBk9"));
    board.move(0.8, [](double share) {
        return PenSample{.x_mm = 0.75, .y_mm = -0.3 + 1.6 * share, .pressure = 0.5};
    });
    board.dry();
}

}  // namespace

pigment::Image8 thumbnail(const brush::Preset& preset, int width_px, int height_px,
                          core::ThreadPool& pool) {
    return tool_sample(preset, mark_of(preset),
                       {.width_mm = sample_width_mm(mark_width_mm(preset), width_px, height_px),
                        .width_px = width_px,
                        .height_px = height_px},
                       pool);
}

pigment::Image8 thumbnail(const film::Medium& medium, int width_px, int height_px,
                          core::ThreadPool& pool) {
    constexpr double kSeen_mm = 24.0, kTilt_deg = 80.0, kTilted_s = 8.0;
    const bool clear = medium.solid_fraction == 0.0;
    SampleBoard board({.width_mm = kSeen_mm, .width_px = width_px, .height_px = height_px}, "panel",
                      pool);
    black_half(board);
    board.use_medium(clear ? "linseed oil" : medium.name);
    board.take("Flat bristle 20", 0.25);
    board.load(tinted("PR108"));
    board.move(0.6, [](double share) {
        return PenSample{.x_mm = 0.1 + 0.8 * share,
                         .y_mm = 0.32,
                         .pressure = 0.5 * rise_and_fall(share),
                         .rotation_deg = 90.0};
    });
    board.use_medium(medium.name);
    board.take(brush::find_preset("Dropper"));
    board.load(clear ? PaintRecipe{} : tinted("PR108"));
    for (const double x : {0.3, 0.65})
        board.touch({.x_mm = x, .y_mm = 0.36, .pressure = 1.0});
    board.tilt(kTilt_deg, kTilted_s);
    return board.picture();
}

}  // namespace pastoso::document
