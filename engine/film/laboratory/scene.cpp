#include "film/laboratory/scene.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/units.hpp"
#include "film/laboratory/scene_forms.hpp"
#include "film/support/support_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace pastoso::film {
namespace {

void check_count(const CellValues& cells, const grid::Shape& shape) {
    const std::size_t count =
        static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.height);
    if (cells.values.size() == count) return;
    throw core::InputError("There are %1 values for the %2 x %3 cells of the canvas.",
                           cells.values.size(), shape.width, shape.height);
}

/// The heights of one relief, made for a whole canvas.
struct ReliefMaker {
    grid::Shape shape;
    double cell_mm;
    core::ThreadPool& pool;

    SupportHeights operator()(const BundledRelief& relief) const {
        return named_support(relief.name, shape, cell_mm, relief.relief_mm, pool);
    }
    SupportHeights operator()(const Weave& weave) const {
        return woven_support(shape, cell_mm, weave, pool);
    }
    SupportHeights operator()(const ImageRelief& relief) const {
        const auto lift_mm =
            static_cast<float>(std::floor(relief.low_mm / kSupportQuantum_mm) * kSupportQuantum_mm);
        SupportHeights heights = image_heights(shape, relief.map.grey, relief.map.width,
                                               relief.map.height, relief.high_mm - relief.low_mm);
        for (int tile = 0; tile < heights.tile_count(); ++tile) {
            float* values = heights.write(tile);
            for (int i = 0; i < grid::kTileCells; ++i)
                values[i] += lift_mm;
        }
        return heights;
    }
    SupportHeights operator()(const Ramp& ramp) const {
        const double along_x = ramp.slope * cell_mm * std::cos(core::radians(ramp.direction_deg));
        const double along_y = ramp.slope * cell_mm * std::sin(core::radians(ramp.direction_deg));
        const double lowest =
            std::min(0.0, along_x * shape.width) + std::min(0.0, along_y * shape.height);
        return sampled([&](double x, double y) { return along_x * x + along_y * y - lowest; }, 1);
    }
    SupportHeights operator()(const Bump& bump) const {
        const double exponent = -0.5 * cell_mm * cell_mm / (bump.deviation_mm * bump.deviation_mm);
        const auto height = [&](double x, double y) {
            const double dx = x - bump.centre.x_mm / cell_mm, dy = y - bump.centre.y_mm / cell_mm;
            return bump.height_mm * std::exp(exponent * (dx * dx + dy * dy));
        };
        return sampled(height, 4);
    }

    SupportHeights operator()(const CellHeights& cells) const {
        check_count(cells, shape);
        const float* heights_mm = cells.values.data();
        return sampled_heights({shape}, 1, 1.0, [&](double, std::span<float> row) {
            std::copy_n(heights_mm, row.size(), row.begin());
            heights_mm += row.size();
        });
    }

    /// height(x, y) in mm at a place in cells.
    template <class Height>
    SupportHeights sampled(const Height& height, int samples) const {
        return sampled_heights({shape}, samples, 1.0, [&](double y, std::span<float> heights) {
            for (std::size_t k = 0; k < heights.size(); ++k)
                heights[k] = static_cast<float>(height((static_cast<double>(k) + 0.5) / samples, y));
        });
    }
};

[[noreturn]] void refuse_cell(const core::Message& what, double value, int x, int y, double most) {
    throw core::InputError(
        "%1 is %2 in cell (%3, %4), but must lie between 0 and %5 (cells count from 0 at the upper "
        "left).",
        what, core::number_text(value, 4), x, y, core::number_text(most, 4));
}

/// Adds thickness in mm and what the paint carries, before they are rounded to quanta.
struct Pile {
    double thickness_mm = 0.0;
    std::array<double, kPaintChannels> paint{};
    std::array<double, kMostMedia> media_mm{};

    void add(double added_mm, int medium, const PaintCoefficients& coefficients) {
        thickness_mm += added_mm;
        media_mm[medium] += added_mm;
        for (int k = 0; k < kPaintChannels; ++k)
            paint[k] += added_mm * static_cast<double>(coefficients[k]);
    }
    bool is_coloured() const {
        return std::any_of(paint.begin(), paint.begin() + kPigmentChannels,
                           [](double amount) { return amount > 0.0; });
    }
};

std::int32_t in_quanta(double amount, double quantum) {
    return static_cast<std::int32_t>(std::llround(amount / quantum));
}

/// What of a pile is not of the scene's medium, the first.
MediaCell foreign_media(const Pile& pile, std::int32_t thickness) {
    MediaCell cell{};
    std::int32_t left = thickness;
    for (int k = 1; k < kMostMedia; ++k) {
        cell[k] = std::min(in_quanta(pile.media_mm[k], kThicknessQuantum_mm), left);
        left -= cell[k];
    }
    return cell;
}

void store(const Pile& pile, int x, int y, FilmState& film) {
    if (!(pile.thickness_mm >= 0.0 && pile.thickness_mm <= kMaxThickness_mm))
        refuse_cell(core::message("The thickness of the film"), pile.thickness_mm, x, y,
                    kMaxThickness_mm);
    const std::int32_t thickness = in_quanta(pile.thickness_mm, kThicknessQuantum_mm);
    if (thickness == 0) return;
    film.thickness.set(x, y, thickness);
    if (pile.media_mm[0] < pile.thickness_mm && film.media.are_several())
        film.media.foreign.set(x, y, foreign_media(pile, thickness));
    if (!film.consistencies.are_several() && !pile.is_coloured()) return;
    PaintCell cell;
    for (int k = 0; k < kPaintChannels; ++k)
        cell[k] = in_quanta(pile.paint[k], kPaintQuantum);
    film.paint.set(x, y, cell);
}

/// The media of a scene's paint by their numbers, its own first.
std::vector<FilmNumbers> media_of(const Scene& scene) {
    std::vector<FilmNumbers> media{film_numbers_of(scene.medium)};
    for (const Primitive& primitive : scene.film) {
        const FilmNumbers numbers = film_numbers_of(primitive.medium.value_or(scene.medium));
        if (std::find(media.begin(), media.end(), numbers) == media.end()) media.push_back(numbers);
    }
    if (media.size() > kMostMedia)
        throw core::InputError("The film is of %1 media, but may be of %2 at most.", media.size(),
                               kMostMedia);
    return media;
}

/// A primitive with what is worked out once for all rows.
struct Layer {
    Layer(const Primitive& wanted, const Scene& scene, const std::vector<FilmNumbers>& media)
        : primitive(wanted),
          medium(place_of(wanted.medium.value_or(scene.medium), media)),
          paint(paint_coefficients(wanted.pigment, wanted.medium.value_or(scene.medium))),
          reach(reach_of(wanted.form, scene.shape, scene.cell_mm)),
          width(static_cast<std::size_t>(scene.shape.width)) {
        if (const auto* cells = std::get_if<CellValues>(&wanted.form)) check_count(*cells, scene.shape);
        if (const auto* map = std::get_if<GreyMap>(&wanted.form))
            image_mm =
                image_heights(scene.shape, map->grey, map->width, map->height, wanted.thickness_mm);
    }

    double thickness_in(int x, int y, double cell_mm) const {
        if (const auto* cells = std::get_if<CellValues>(&primitive.form)) {
            const std::size_t cell = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
            return primitive.thickness_mm * static_cast<double>(cells->values[cell]);
        }
        const bool is_image = std::holds_alternative<GreyMap>(primitive.form);
        return is_image ? static_cast<double>(image_mm.at(x, y))
                        : mean_thickness_mm(primitive, x, y, cell_mm);
    }

    static int place_of(const Medium& medium, const std::vector<FilmNumbers>& media) {
        return static_cast<int>(std::find(media.begin(), media.end(), film_numbers_of(medium)) -
                                media.begin());
    }

    const Primitive& primitive;
    int medium;
    PaintCoefficients paint;
    grid::Rect reach;
    std::size_t width;  ///< of the canvas
    SupportHeights image_mm;
};

void pile_up_row(const std::vector<Layer>& layers, int y, double cell_mm, std::vector<Pile>& row) {
    row.assign(row.size(), {});
    for (const Layer& layer : layers) {
        if (y < layer.reach.y0 || y >= layer.reach.y1) continue;
        for (int x = layer.reach.x0; x < layer.reach.x1; ++x)
            row[x].add(layer.thickness_in(x, y, cell_mm), layer.medium, layer.paint);
    }
}

}  // namespace

SupportHeights make_support(const Scene& scene) {
    core::ThreadPool alone(1);
    SupportHeights sum(scene.shape);
    for (const Relief& relief : scene.support) {
        const auto heights = std::visit(ReliefMaker{scene.shape, scene.cell_mm, alone}, relief);
        for (int tile = 0; tile < sum.tile_count(); ++tile) {
            float* total = sum.write(tile);
            const TileHeights added = heights.read(tile);
            for (int i = 0; i < grid::kTileCells; ++i)
                total[i] += added[i];
        }
    }
    for (int y = 0; y < scene.shape.height; ++y) {
        for (int x = 0; x < scene.shape.width; ++x) {
            const double height_mm = sum.at(x, y);
            if (!(height_mm >= 0.0 && height_mm <= kMaxSupport_mm))
                refuse_cell(core::message("The height of the support"), height_mm, x, y, kMaxSupport_mm);
        }
    }
    return sum;
}

FilmState make_film(const Scene& scene) {
    FilmState film(scene.shape, scene.cell_mm);
    film.support_mm = make_support(scene);
    const auto has_own_medium = [](const Primitive& primitive) { return primitive.medium.has_value(); };
    if (std::any_of(scene.film.begin(), scene.film.end(), has_own_medium))
        film.consistencies = Consistencies::several();
    film.media.numbers = media_of(scene);
    std::vector<Layer> layers;
    for (const Primitive& primitive : scene.film)
        layers.emplace_back(primitive, scene, film.media.numbers);
    std::vector<Pile> row(static_cast<std::size_t>(scene.shape.width));
    for (int y = 0; y < scene.shape.height; ++y) {
        pile_up_row(layers, y, scene.cell_mm, row);
        for (int x = 0; x < scene.shape.width; ++x)
            store(row[x], x, y, film);
    }
    return film;
}

}  // namespace pastoso::film
