#include "brush/studio.hpp"

#include "brush/stroke.hpp"
#include "film/support/support.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pastoso::brush::studio {
namespace {

grid::Shape shape_of(double width_mm, double height_mm, double px_per_mm) {
    return {static_cast<int>(std::lround(width_mm * px_per_mm)),
            static_cast<int>(std::lround(height_mm * px_per_mm))};
}

double ramp(double t) {
    const double x = std::clamp(t, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

std::vector<double> block_means(const film::FilmState& film, double block_mm) {
    const int cells = static_cast<int>(std::lround(block_mm / film.cell_mm));
    std::vector<double> means;
    for (int y = 0; y + cells <= film.shape.height; y += cells) {
        for (int x = 0; x + cells <= film.shape.width; x += cells) {
            means.push_back(mean_thickness_mm(film, {x, y, x + cells, y + cells}));
        }
    }
    return means;
}

}  // namespace

film::FilmState linen(double width_mm, double height_mm, double px_per_mm) {
    film::FilmState film = smooth(width_mm, height_mm, px_per_mm);
    core::ThreadPool pool(1);
    film.support_mm = film::woven_support(film.shape, film.cell_mm, film::Weave{}, pool);
    return film;
}

film::FilmState smooth(double width_mm, double height_mm, double px_per_mm) {
    return {shape_of(width_mm, height_mm, px_per_mm), 1.0 / px_per_mm};
}

void cover(film::FilmState& film, double thickness_mm, const film::PaintCoefficients& paint) {
    cover(film, film.shape.cells(), thickness_mm, paint);
}

void cover(film::FilmState& film, const grid::Rect& cells, double thickness_mm,
           const film::PaintCoefficients& paint) {
    film::PaintCell pigment{};
    for (int k = 0; k < film::kPaintChannels; ++k) {
        pigment[k] = static_cast<std::int32_t>(thickness_mm * paint[k] / film::kPaintQuantum);
    }
    const auto quanta = static_cast<std::int32_t>(thickness_mm / film::kThicknessQuantum_mm);
    for (int y = cells.y0; y < cells.y1; ++y) {
        for (int x = cells.x0; x < cells.x1; ++x) {
            film.thickness.set(x, y, quanta);
            film.paint.set(x, y, pigment);
        }
    }
}

void lay_over(film::FilmState& film, double thickness_mm, const film::PaintCoefficients& paint) {
    const film::FilmState below = film;
    cover(film, thickness_mm, paint);
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x) {
            const film::LowerCell lower{below.thickness.at(x, y), below.paint.at(x, y)};
            if (lower.thickness == 0) continue;
            film::PaintCell whole = film.paint.at(x, y);
            for (int k = 0; k < film::kPaintChannels; ++k)
                whole[k] += lower.paint[k];
            film.thickness.set(x, y, film.thickness.at(x, y) + lower.thickness);
            film.paint.set(x, y, whole);
            film.lower.thickness.set(x, y, lower.thickness);
            film.lower.paint.set(x, y, lower.paint);
        }
}

film::PaintCoefficients dark_paint() {
    return {900.0F, 600.0F, 300.0F, 150.0F, 75.0F, 40.0F, 20.0F, 15.0F,
            12.0F,  10.0F,  8.0F,   6.0F,   12.6F, 80.0F, 0.9F,  80.0F};
}

film::PaintCoefficients light_paint() {
    return {0.0032F, 0.004F, 0.005F, 0.01F,  0.1F, 1.0F, 200.0F, 190.0F,
            180.0F,  170.0F, 160.0F, 150.0F, 4.6F, 0.1F, 0.2F,   1.0F};
}

Preset linear(const Preset& preset) {
    Preset result = preset;
    result.dynamics.clear();
    return result;
}

Preset flat_preset(double width_mm, int bristles) {
    Preset preset;
    preset.name = "flat";
    preset.tip = {.shape = TipShape::Flat,
                  .width_mm = width_mm,
                  .thickness_mm = 0.24 * width_mm,
                  .length_mm = 1.1 * width_mm,
                  .bristles = bristles};
    return preset;
}

Preset round_preset(double width_mm) {
    Preset preset;
    preset.name = "round";
    preset.tip = {.shape = TipShape::Round,
                  .width_mm = width_mm,
                  .thickness_mm = width_mm,
                  .length_mm = 2.6 * width_mm,
                  .point_mm = 0.75 * width_mm};
    preset.flex.splay = 0.5;
    preset.flex.descend = 0.5;
    preset.paint.film_mm = 0.16;
    preset.paint.run_mm = 140.0;
    return preset;
}

double fade(double t) {
    return ramp(t / 0.06) * ramp((1.0 - t) / 0.06);
}

Movement line(double x0_mm, double y0_mm, double x1_mm, double y1_mm, double pressure,
              double rotation_deg) {
    return [=](double t) {
        return PenSample{.x_mm = x0_mm + t * (x1_mm - x0_mm),
                         .y_mm = y0_mm + t * (y1_mm - y0_mm),
                         .pressure = pressure * fade(t),
                         .rotation_deg = rotation_deg};
    };
}

void paint(Brush& brush, film::FilmState& film, const Movement& movement, double rate_Hz,
           double duration_s) {
    Stroke stroke(brush, film);
    paint(stroke, movement, rate_Hz, duration_s);
}

void paint(Stroke& stroke, const Movement& movement, double rate_Hz, double duration_s) {
    const auto count = static_cast<int>(std::lround(rate_Hz * duration_s));
    for (int i = 0; i <= count; ++i) {
        const double t = static_cast<double>(i) / count;
        PenSample sample = movement(t);
        sample.time_s = t * duration_s;
        if (i == 0)
            stroke.begin(sample);
        else
            stroke.add(sample);
    }
    stroke.end();
}

Contents contents(const film::FilmState& film) {
    const film::Totals totals = film::totals(film);
    const double area_mm2 = film.cell_mm * film.cell_mm;
    Contents result;
    result.volume_mm3 = film::volume_mm3(totals.thickness, film.cell_mm);
    for (int k = 0; k < film::kPaintChannels; ++k) {
        result.paint[k] = static_cast<double>(totals.paint[k]) * film::kPaintQuantum * area_mm2;
    }
    return result;
}

double balance_error(const Contents& a, const Contents& b) {
    double error = std::abs(a.volume_mm3 / b.volume_mm3 - 1.0);
    for (int k = 0; k < film::kPaintChannels; ++k) {
        error = std::max(error, std::abs(a.paint[k] / b.paint[k] - 1.0));
    }
    return error;
}

double volume_mm3(const film::FilmState& film) {
    return contents(film).volume_mm3;
}

double thickness_mm(const film::FilmState& film, int x, int y) {
    return film::thickness_mm(film.thickness.at(x, y));
}

double mean_thickness_mm(const film::FilmState& film, const grid::Rect& cells) {
    double sum = 0.0;
    for (int y = cells.y0; y < cells.y1; ++y) {
        for (int x = cells.x0; x < cells.x1; ++x)
            sum += thickness_mm(film, x, y);
    }
    return sum / cells.width() / cells.height();
}

double highest_mm(const film::FilmState& film, const grid::Rect& cells) {
    double highest = 0.0;
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x)
            highest = std::max(highest, thickness_mm(film, x, y));
    return highest;
}

double coverage(const film::FilmState& film, const grid::Rect& cells) {
    int covered = 0;
    for (int y = cells.y0; y < cells.y1; ++y) {
        for (int x = cells.x0; x < cells.x1; ++x)
            covered += thickness_mm(film, x, y) > 0.01 ? 1 : 0;
    }
    return static_cast<double>(covered) / cells.width() / cells.height();
}

grid::Rect cells_of(const film::FilmState& film, double x0_mm, double y0_mm, double x1_mm,
                    double y1_mm) {
    const auto cell = [&](double place_mm) {
        return static_cast<int>(std::lround(place_mm / film.cell_mm));
    };
    return {cell(x0_mm), cell(y0_mm), cell(x1_mm), cell(y1_mm)};
}

double relative_difference(const film::FilmState& a, const film::FilmState& b, double block_mm) {
    const std::vector<double> means_a = block_means(a, block_mm), means_b = block_means(b, block_mm);
    double difference = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < means_a.size(); ++i) {
        difference += std::abs(means_a[i] - means_b[i]);
        sum += means_a[i];
    }
    return difference / sum;
}

}  // namespace pastoso::brush::studio
