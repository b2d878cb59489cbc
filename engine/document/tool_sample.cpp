#include "document/tool_sample.hpp"

#include "brush/droplets.hpp"
#include "brush/preset_fields.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::document {
namespace {

using brush::PenSample;
using brush::Preset;
using brush::TipShape;
using brush::ToolKind;

/// Keeps what is just as small as it may be above that in its rounding.
constexpr double kJustLess = 0.999;

/// What is seen, in widths of the mark, from top to bottom and from side to side; and at least, from top
/// to bottom.
constexpr double kSeenHeights = 1.6, kSeenWidths = 4.0, kLeastSeen_mm = 6.4;

ToolMark mark_of_contact(const Preset& preset) {
    constexpr double kThinFilm_mm = 0.06, kShortRun_mm = 70.0, kFine_mm = 4.0;
    if (!preset.dips || preset.tip.shape == TipShape::Knife) return ToolMark::OverWet;
    if (preset.paint.coat > 0.0) return ToolMark::OnWeave;
    if (preset.paint.film_mm < kThinFilm_mm) return ToolMark::OverDry;
    if (preset.paint.run_mm < kShortRun_mm) return ToolMark::Dabs;
    return preset.tip.width_mm < kFine_mm ? ToolMark::Lines : ToolMark::Wave;
}

/// Of the pen along a stroke from nothing to nothing.
double swelling(double share) {
    const double swell = std::sin(core::kPi * share);
    return (0.15 + 0.85 * swell * swell) * rise_and_fall(share);
}

/// A wave across the board.
struct Wave {
    double periods = 1.0;
    double height = 0.12;  ///< of the board
    double pressure = 0.8;
};

/// The width of the tip across the way.
PenSample along(const Wave& wave, const SampleBoard& board, double share) {
    constexpr double kFrom = 0.08, kWay = 0.84;
    const double turns = 2.0 * core::kPi * wave.periods;
    const double slope = -wave.height * board.aspect() * turns * std::cos(turns * share) / kWay;
    return {.x_mm = kFrom + kWay * share,
            .y_mm = 0.5 - wave.height * std::sin(turns * share),
            .pressure = wave.pressure * swelling(share),
            .rotation_deg = 90.0 + core::degrees(std::atan(slope))};
}

/// A long one takes somewhat longer.
void paint_wave(SampleBoard& board, const Wave& wave = {}) {
    const double seconds = std::clamp(0.29 / board.aspect(), 0.8, 1.2);
    board.move(seconds, [&](double share) { return along(wave, board, share); });
}

/// One above the other.
void two_bands(SampleBoard& board) {
    const double width = 0.68 * board.aspect();
    lay_band(board, 0.32, width, tinted("PR108"));
    lay_band(board, 0.68, width, tinted("PW6"));
}

void dry_ground(SampleBoard& board) {
    board.use_medium("fluid acrylic");
    lay_band(board, 0.5, 1.2 * board.aspect(), tinted("PB29"));
    board.dry();
}

void dab(SampleBoard& board) {
    constexpr int kDabs = 5;
    for (int i = 0; i < kDabs; ++i) {
        const double share = (i + 0.5) / kDabs;
        board.touch({.x_mm = 0.04 + 0.92 * share,
                     .y_mm = i % 2 == 0 ? 0.34 : 0.66,
                     .pressure = 0.2 + 0.7 * share});
    }
}

void drip(SampleBoard& board) {
    for (const double x : {0.2, 0.5, 0.8})
        board.touch({.x_mm = x, .y_mm = 0.5, .pressure = 1.0});
}

void blow(SampleBoard& board) {
    board.move(0.5, [](double share) {
        return PenSample{.x_mm = 0.28 + 0.3 * share, .y_mm = 0.5, .pressure = 0.5, .tilt_x_deg = 40.0};
    });
}

/// What lies there before the tool comes.
void prepare(SampleBoard& board, ToolMark mark) {
    if (mark == ToolMark::OverWet) two_bands(board);
    if (mark == ToolMark::OverDry) dry_ground(board);
    if (mark != ToolMark::Blow) return;
    board.use_medium("ink glaze");
    lay_band(board, 0.5, 0.56 * board.aspect(), tinted("PB29"));
}

/// A blade's edge is even along its way: on a board of large cells it takes no shorter steps than shows.
Preset stepping_by_cells(Preset preset, double cell_mm) {
    constexpr double kLeastStepCells = 0.5, kMostStep_mm = 2.0;
    if (preset.tip.shape == TipShape::Knife)
        preset.stroke.min_spacing_mm =
            std::max(preset.stroke.min_spacing_mm, std::min(kLeastStepCells * cell_mm, kMostStep_mm));
    return preset;
}

void dip(SampleBoard& board, const Preset& preset) {
    const bool falls = preset.kind == ToolKind::Droplets;
    board.use_medium(falls ? "fluid acrylic" : "heavy-body oil");
    board.take(preset);
    if (!preset.dips) return;
    LoadPaint load{.paint = tinted("PB28", 0.2)};
    if (!falls) {
        load.second = tinted("PB28", 1.2);
        load.second_share = load.share_variation = 0.4;
    }
    board.load(load);
}

void paint(SampleBoard& board, ToolMark mark) {
    switch (mark) {
        case ToolMark::Wave:
        case ToolMark::OverWet:
        case ToolMark::OverDry:
        case ToolMark::OnWeave:
        case ToolMark::Stream:
            return paint_wave(board);
        case ToolMark::Lines:
            return paint_wave(board, {.periods = 1.5, .height = 0.22, .pressure = 0.3});
        case ToolMark::Dabs:
            return dab(board);
        case ToolMark::Drops:
            return drip(board);
        case ToolMark::Blow:
            return blow(board);
    }
}

}  // namespace

ToolMark mark_of(const Preset& preset) {
    if (preset.kind == ToolKind::Air) return ToolMark::Blow;
    if (preset.kind == ToolKind::Droplets)
        return preset.droplets.touch_mm3 > 0.0 ? ToolMark::Drops : ToolMark::Stream;
    return mark_of_contact(preset);
}

double mark_width_mm(const Preset& preset) {
    constexpr double kPooled_s = 0.1;    // what falls on one place while the tool passes
    constexpr double kLineWidths = 2.5;  // of what a thin line swings over
    if (mark_of(preset) == ToolMark::Lines) return kLineWidths * preset.tip.width_mm;
    if (preset.kind != ToolKind::Droplets) return preset.tip.width_mm;
    const brush::DropletPreset& drops = preset.droplets;
    const double pooled_mm3 = std::max(drops.touch_mm3, kPooled_s * drops.rate_mm3_s);
    return std::max(preset.tip.width_mm, 2.0 * brush::cap_radius_mm(pooled_mm3, drops.steepness));
}

double sample_width_mm(double mark_mm, int width_px, int height_px) {
    const double form = static_cast<double>(width_px) / height_px;
    return std::max(mark_mm * std::max(kSeenHeights * form, kSeenWidths), kLeastSeen_mm * form);
}

pigment::Image8 tool_sample(const Preset& preset, ToolMark mark, const SampleBoard::Size& size,
                            core::ThreadPool& pool, const std::function<bool()>& cancelled) {
    const double shrunk = size.width_px / size.width_mm / size.cell_px / kMinPxPerMm;
    if (shrunk < 1.0) {
        SampleBoard::Size smaller = size;
        smaller.width_mm *= shrunk * kJustLess;
        const Preset tool = brush::resized(preset, preset.tip.width_mm * shrunk * kJustLess);
        return tool_sample(brush::within_ranges(tool), mark, smaller, pool, cancelled);
    }
    const bool has_weave = mark == ToolMark::OverDry || mark == ToolMark::OnWeave;
    SampleBoard board(size, has_weave ? "linen" : "panel", pool, cancelled);
    prepare(board, mark);
    dip(board, stepping_by_cells(preset, board.cell_mm()));
    paint(board, mark);
    return board.picture();
}

}  // namespace pastoso::document
