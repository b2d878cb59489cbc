// An evening by a river, step by step: ground, wash, blocking in, wet in wet, knife, scumble, glaze.
#include "core/random.hpp"
#include "evening_parts.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::examples {
namespace evening {
namespace {

/// How deep a point lies in an upright ellipse, about.
double ellipse_mm(Point at, Point middle, double half_width, double half_height) {
    const double x = (at.x - middle.x) / half_width, y = (at.y - middle.y) / half_height;
    return (1.0 - std::hypot(x, y)) * std::min(half_width, half_height);
}

}  // namespace

double chance(int number, unsigned kind) {
    return core::uniform_noise(static_cast<std::uint32_t>(number), kind);
}

double bell(double at, double middle, double width) {
    return std::exp(-std::pow((at - middle) / width, 2));
}

double on_canvas_mm(Point at) {
    return 8.0 + std::min({at.x, kWidth_mm - at.x, at.y, kHeight_mm - at.y});
}

double crowns_mm(Point at) {
    const double ragged = 0.9 * std::sin(at.x * 0.9 + at.y * 0.5) * std::sin(at.y * 0.8 - at.x * 0.3);
    const double crowns = std::max({ellipse_mm(at, {27, 20}, 12, 13), ellipse_mm(at, {15, 28}, 12, 11),
                                    ellipse_mm(at, {36, 34}, 11, 11), ellipse_mm(at, {3, 38}, 13, 17),
                                    ellipse_mm(at, {42, 47}, 8, 8.5), ellipse_mm(at, {18, 46}, 24, 13)});
    return std::min(crowns + ragged, kShore_y + 0.5 - at.y);
}

double trees_mm(Point at) {
    const double poplars =
        std::max(ellipse_mm(at, {52.5, 34}, 3.2, 23), ellipse_mm(at, {59.5, 42}, 2.3, 14));
    return std::max(crowns_mm(at), std::min(poplars, kShore_y + 0.5 - at.y));
}

double mirrored_trees_mm(Point at) {
    const double below = at.y - kShore_y, sway = 1.2 * std::sin(1.9 * at.y) * smooth_step(0, 14, below);
    return std::min(trees_mm({at.x + sway, kShore_y - 1.06 * below}), below + 2.5);
}

double far_bank_mm(Point at) {
    const double height = 4.2 + 0.9 * std::sin(at.x / 6.3) + 0.5 * std::sin(at.x / 2.7) +
                          10.5 * bell(at.x, 122, 16) - 1.6 * bell(at.x, kSun.x, 9);
    return std::min(at.y - (kShore_y - height), kShore_y + 0.6 - at.y);
}

double near_bank_mm(Point at) {
    return at.y - (74.0 + 0.19 * at.x + 1.6 * std::sin(at.x / 8.0) + 0.004 * at.x * at.x);
}

double glow(Point at) {
    const Point from{0.6 * (at.x - kSun.x), 1.25 * (at.y - kSun.y)};
    return 0.98 * std::exp(-std::pow(length(from) / 23.0, 1.05));
}

std::vector<document::LoadPaint> half_mixed(const std::vector<const char*>& tones, double share) {
    std::vector<document::LoadPaint> paints;
    for (std::size_t i = 0; i < tones.size(); ++i)
        paints.push_back(
            load(mixture(tones[i]), mixture(tones[i + 1 < tones.size() ? i + 1 : i - 1]), share));
    return paints;
}

}  // namespace evening

document::Recording evening_by_a_river() {
    document::CanvasSettings canvas;
    canvas.width_mm = evening::kWidth_mm;
    canvas.height_mm = evening::kHeight_mm;
    canvas.px_per_mm = 6;
    canvas.support = "medium linen";
    Painter painter(canvas);
    int steps = 0;
    const auto end_step = [&] { painter.wait_until(++steps * kEveningStep_s); };
    evening::tone_the_ground(painter);
    end_step();
    evening::draw_with_a_wash(painter);
    end_step();
    evening::block_in(painter);
    end_step();
    evening::paint_wet_in_wet(painter);
    end_step();
    evening::set_lights_with_the_knife(painter);
    end_step();
    painter.dry_now();
    evening::scumble(painter);
    end_step();
    evening::glaze(painter);
    painter.take("Filbert 14", 6);
    painter.dip(load(mixture("PW6=4 PY35=0.5 PO20=0.1")));
    end_step();
    return painter.finish(0.0);
}

}  // namespace pastoso::examples
