#include "document/thumbnail.hpp"

#include "core/units.hpp"
#include "document/painting.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace pastoso::document {
namespace {

using brush::PenSample;
using brush::Preset;
using brush::ToolKind;

/// How much of the canvas is seen across, in widths of the tip, and at least.
constexpr double kSeen_widths = 4.0, kLeastSeen_mm = 18.0;

/// Paints on a board of its own, in units of the board: (0, 0) to (1, 1).
class Board {
  public:
    Board(double width_mm, int width_px, int height_px, core::ThreadPool& pool)
        : width_mm_(width_mm),
          height_mm_(width_mm_ * height_px / width_px),
          painting_({.width_mm = width_mm_,
                     .height_mm = height_mm_,
                     .px_per_mm = width_px / width_mm_,
                     .support = "panel"},
                    pool) {
        painting_.set_history_budget(0);
    }

    void take(const Preset& preset) {
        painting_.apply(TakeBrush{.preset = preset.name, .definition = preset_to_json(preset)});
    }
    void take(const std::string& name, double width_mm) {
        painting_.apply(TakeBrush{.preset = name, .size_mm = std::clamp(width_mm, 0.5, 200.0)});
    }
    void use_medium(const std::string& name) { painting_.apply(UseMedium{name}); }
    void load(const std::string& pigment, double white) {
        PaintRecipe paint{.ingredients = {{pigment, 1.0}}};
        if (white > 0.0) paint.ingredients.push_back({"PW6", white});
        painting_.apply(LoadPaint{.paint = paint});
    }
    void load_clear() { painting_.apply(LoadPaint{}); }
    void load_two() {
        painting_.apply(LoadPaint{.paint = {.ingredients = {{"PB28", 1.0}, {"PW6", 0.2}}},
                                  .second = {.ingredients = {{"PB28", 1.0}, {"PW6", 1.2}}},
                                  .second_share = 0.4,
                                  .share_variation = 0.4});
    }

    /// A movement of some seconds during which paint time passes; `at` gives place and pressure.
    void move(double seconds, const std::function<PenSample(double)>& at) {
        const int ticks = std::max(4, static_cast<int>(std::lround(seconds / kTick_s)));
        for (int tick = 0; tick <= ticks; ++tick) {
            PenSample sample = at(static_cast<double>(tick) / ticks);
            sample.x_mm *= width_mm_;
            sample.y_mm *= height_mm_;
            sample.time_s = now_s_;
            if (tick == 0)
                painting_.apply(PenDown{sample});
            else
                painting_.apply(PenMove{sample});
            painting_.advance_tick();
            now_s_ += kTick_s;
        }
        painting_.apply(PenUp{});
    }

    void dry() { painting_.apply(DryNow{}); }
    void tilt(double tilt_deg, double seconds) {
        painting_.apply(TiltCanvas{tilt_deg});
        for (double passed_s = 0.0; passed_s < seconds; passed_s += kTick_s)
            painting_.advance_tick();
    }

    pigment::Image8 picture(core::ThreadPool& pool) const {
        const Snapshot seen = painting_.snapshot();
        return pigment::encode_srgb8(
            shade::render(seen.film, seen.ground, seen.film.shape.cells(), {}, pool));
    }

    double width_mm() const { return width_mm_; }

  private:
    double width_mm_, height_mm_;
    Painting painting_;
    double now_s_ = 0.0;
};

double rise_and_fall(double u) {
    return std::clamp(10.0 * std::min(u, 1.0 - u), 0.0, 1.0);
}

/// Along a gentle wave across the board, the width of the tip across the way.
PenSample wave(double u, double pressure) {
    const double slope = -0.5 * std::cos(2.0 * core::kPi * u);
    return {.x_mm = 0.1 + 0.8 * u,
            .y_mm = 0.5 - 0.12 * std::sin(2.0 * core::kPi * u),
            .pressure = pressure * rise_and_fall(u),
            .rotation_deg = 90.0 + core::degrees(std::atan(slope))};
}

void straight_band(Board& board, double y, const std::string& pigment, double white, double width_mm) {
    board.take("Impasto flat 18", width_mm);
    board.load(pigment, white);
    board.move(0.6, [&](double u) {
        return PenSample{.x_mm = 0.06 + 0.88 * u,
                         .y_mm = y,
                         .pressure = 0.4 * rise_and_fall(u),
                         .rotation_deg = 90.0};
    });
}

/// Two bands of wet paint one above the other.
void wet_ground(Board& board) {
    straight_band(board, 0.32, "PR108", 0.0, 0.24 * board.width_mm());
    straight_band(board, 0.68, "PW6", 0.0, 0.24 * board.width_mm());
}

void drops(Board& board, const Preset& preset) {
    board.use_medium("fluid acrylic");
    board.take(preset);
    board.load("PB28", 0.2);
    if (preset.droplets.touch_mm3 == 0.0) {
        board.move(0.8, [](double u) { return wave(u, 0.8); });
        return;
    }
    for (const double x : {0.2, 0.5, 0.8})
        board.move(0.05, [&](double) { return PenSample{.x_mm = x, .y_mm = 0.5, .pressure = 1.0}; });
}

void air(Board& board, const Preset& preset) {
    board.use_medium("ink glaze");
    straight_band(board, 0.5, "PB29", 0.0, 0.2 * board.width_mm());
    board.take(preset);
    board.move(0.5, [](double u) {
        return PenSample{.x_mm = 0.28 + 0.3 * u, .y_mm = 0.5, .pressure = 0.5, .tilt_x_deg = 40.0};
    });
}

void contact(Board& board, const Preset& preset) {
    if (!preset.dips) wet_ground(board);
    board.use_medium("heavy-body oil");
    board.take(preset);
    if (preset.dips) board.load_two();
    board.move(0.8, [](double u) { return wave(u, 0.5); });
}

/// The right half of the board black, and dry.
void black_half(Board& board) {
    board.use_medium("fluid acrylic");
    board.take("Impasto flat 18", 0.5 * board.width_mm());
    board.load("PBk9", 0.0);
    board.move(
        0.8, [](double u) { return PenSample{.x_mm = 0.75, .y_mm = -0.3 + 1.6 * u, .pressure = 0.5}; });
    board.dry();
}

}  // namespace

pigment::Image8 thumbnail(const brush::Preset& preset, int width_px, int height_px,
                          core::ThreadPool& pool) {
    const double seen_mm = std::max(kSeen_widths * preset.tip.width_mm, kLeastSeen_mm);
    Board board(seen_mm, width_px, height_px, pool);
    switch (preset.kind) {
        case ToolKind::Contact:
            contact(board, preset);
            break;
        case ToolKind::Droplets:
            drops(board, preset);
            break;
        case ToolKind::Air:
            air(board, preset);
            break;
    }
    return board.picture(pool);
}

pigment::Image8 thumbnail(const film::Medium& medium, int width_px, int height_px,
                          core::ThreadPool& pool) {
    constexpr double kSeen_mm = 24.0, kTilt_deg = 80.0, kTilted_s = 8.0;
    const bool clear = medium.solid_fraction == 0.0;
    Board board(kSeen_mm, width_px, height_px, pool);
    black_half(board);
    board.use_medium(clear ? "linseed oil" : medium.name);
    board.take("Flat bristle 20", 0.25 * kSeen_mm);
    board.load("PR108", 0.0);
    board.move(0.6, [](double u) {
        return PenSample{.x_mm = 0.1 + 0.8 * u,
                         .y_mm = 0.32,
                         .pressure = 0.5 * rise_and_fall(u),
                         .rotation_deg = 90.0};
    });
    board.use_medium(medium.name);
    board.take(brush::find_preset("Dropper"));
    if (clear)
        board.load_clear();
    else
        board.load("PR108", 0.0);
    for (const double x : {0.3, 0.65})
        board.move(0.05, [&](double) { return PenSample{.x_mm = x, .y_mm = 0.36, .pressure = 1.0}; });
    board.tilt(kTilt_deg, kTilted_s);
    return board.picture(pool);
}

}  // namespace pastoso::document
