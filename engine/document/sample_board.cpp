#include "document/sample_board.hpp"

#include "core/units.hpp"
#include "shade/render.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::document {
namespace {

constexpr double kTouch_s = 0.05;

CanvasSettings canvas_of(const SampleBoard::Size& size, const std::string& support) {
    return {.width_mm = size.width_mm,
            .height_mm = size.width_mm * size.height_px / size.width_px,
            .px_per_mm = size.width_px / size.width_mm / size.cell_px,
            .support = support};
}

}  // namespace

SampleBoard::SampleBoard(const Size& size, const std::string& support, core::ThreadPool& pool,
                         std::function<bool()> cancelled)
    : size_(size),
      pool_(pool),
      cancelled_(std::move(cancelled)),
      painting_(canvas_of(size, support), pool) {
    painting_.set_history_budget(0);
}

void SampleBoard::take(const brush::Preset& preset) {
    painting_.apply(TakeBrush{.preset = preset.name, .definition = preset_to_json(preset)});
}

void SampleBoard::take(const std::string& name, double width) {
    painting_.apply(
        TakeBrush{.preset = name, .size_mm = std::clamp(width * size_.width_mm, 0.5, 200.0)});
}

void SampleBoard::use_medium(const std::string& name) {
    painting_.apply(UseMedium{name});
}

void SampleBoard::load(const PaintRecipe& paint) {
    load(LoadPaint{.paint = paint});
}

void SampleBoard::load(const LoadPaint& load) {
    painting_.apply(load);
}

void SampleBoard::move(double seconds, const std::function<brush::PenSample(double)>& at) {
    const int ticks = std::max(4, static_cast<int>(std::lround(seconds / kTick_s)));
    for (int tick = 0; tick <= ticks && !stopped(); ++tick) {
        brush::PenSample sample = at(static_cast<double>(tick) / ticks);
        sample.x_mm *= size_.width_mm;
        sample.y_mm *= size_.width_mm * aspect();
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

void SampleBoard::touch(const brush::PenSample& place) {
    move(kTouch_s, [&](double) { return place; });
}

void SampleBoard::fill(std::vector<CanvasPoint> outline, const PaintRecipe& paint, double thickness_mm) {
    painting_.apply(SelectArea{std::move(outline)});
    painting_.apply(FillWithPaint{.paint = paint, .thickness_mm = thickness_mm});
    painting_.apply(SelectAll{});
}

void SampleBoard::dry() {
    painting_.apply(DryNow{});
}

void SampleBoard::tilt(double tilt_deg, double seconds) {
    painting_.apply(TiltCanvas{tilt_deg});
    for (double passed_s = 0.0; passed_s < seconds && !stopped(); passed_s += kTick_s)
        painting_.advance_tick();
}

pigment::Image8 SampleBoard::picture() const {
    if (stopped()) return {};
    const Snapshot seen = painting_.snapshot();
    shade::RenderSettings settings;
    settings.scale = size_.cell_px;
    return pigment::encode_srgb8(
        shade::render(seen.film, seen.ground, seen.film.shape.cells(), settings, pool_));
}

PaintRecipe tinted(const std::string& pigment, double white) {
    PaintRecipe paint{.ingredients = {{pigment, 1.0}}};
    if (white > 0.0) paint.ingredients.push_back({"PW6", white});
    return paint;
}

double rise_and_fall(double share) {
    return std::clamp(10.0 * std::min(share, 1.0 - share), 0.0, 1.0);
}

void lay_band(SampleBoard& board, double y, double width, const PaintRecipe& paint) {
    constexpr double kMargin = 0.06, kThickness_mm = 0.4;
    constexpr int kPoints = 16;  // of a round end
    const double radius_mm = 0.5 * width * board.width_mm(), middle_mm = 0.5 * board.width_mm();
    const double reach_mm = (1.0 - 2.0 * kMargin) * middle_mm - radius_mm;
    const double y_mm = y * board.aspect() * board.width_mm();
    std::vector<CanvasPoint> outline;
    for (const double side : {1.0, -1.0})
        for (int i = 0; i <= kPoints; ++i) {
            const double turn = core::kPi * (static_cast<double>(i) / kPoints - 0.5);
            outline.push_back({middle_mm + side * (reach_mm + radius_mm * std::cos(turn)),
                               y_mm + side * radius_mm * std::sin(turn)});
        }
    board.fill(std::move(outline), paint, kThickness_mm);
}

}  // namespace pastoso::document
