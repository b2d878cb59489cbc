#include "python/film_fields.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <array>
#include <vector>

namespace pastoso::python {
namespace {

using film::FilmState;

void read_thickness(const FilmState& film, int tile, int first, int count, float* out) {
    const std::int32_t* quanta = film.thickness.read(tile) + first;
    for (int i = 0; i < count; ++i)
        out[i] = film::thickness_mm(quanta[i]);
}

void read_support(const FilmState& film, int tile, int first, int count, float* out) {
    film.support_mm.read(tile).copy(first, count, out);
}

void read_surface(const FilmState& film, int tile, int first, int count, float* out) {
    read_support(film, tile, first, count, out);
    const std::int32_t* quanta = film.thickness.read(tile) + first;
    for (int i = 0; i < count; ++i)
        out[i] += film::thickness_mm(quanta[i]);
}

void read_velocity(const FilmState& film, int tile, int first, int count, float* out) {
    const float* x = film.velocity_x.read(tile) + first;
    const float* y = film.velocity_y.read(tile) + first;
    for (int i = 0; i < count; ++i) {
        out[2 * i] = x[i];
        out[2 * i + 1] = y[i];
    }
}

void read_pigment(const FilmState& film, int tile, int first, int count, float* out) {
    const film::PaintCell* cells = film.paint.read(tile) + first;
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < film::kPigmentChannels; ++k)
            *out++ = film::optical_thickness(cells[i][k]);
}

constexpr std::array kFields = {
    FilmField{"thickness", 1, "thickness h of the wet paint, mm", read_thickness},
    FilmField{"support", 1, "height c of the dry surface below the wet paint, mm", read_support},
    FilmField{"surface", 1, "height h + c of the paint's surface, mm", read_surface},
    FilmField{"velocity", 2,
              "velocity of the wet paint, mean over its depth, mm/s: along x at the right face of the "
              "cell, and "
              "along y at its lower face",
              read_velocity},
    FilmField{"pigment", film::kPigmentChannels,
              "optical thickness of the wet paint in the six bands of light, no unit: K h, then S h",
              read_pigment},
};

}  // namespace

std::span<const FilmField> film_fields() {
    return kFields;
}

const FilmField& find_field(const std::string& name) {
    std::vector<std::string> names;
    for (const FilmField& field : kFields) {
        if (name == field.name) return field;
        names.emplace_back(field.name);
    }
    throw core::InputError("there is no field \"%1\" of a film; the fields are %2.", name,
                           core::listed(names));
}

void read_field(const FilmState& film, const FilmField& field, core::ThreadPool& pool, float* out) {
    const grid::Shape& shape = film.shape;
    pool.run(static_cast<std::size_t>(shape.tile_count()), [&](std::size_t index, int) {
        const int tile = static_cast<int>(index);
        const grid::Rect cells = shape.tile_cells(tile);
        for (int y = cells.y0; y < cells.y1; ++y) {
            const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(y) * shape.width + cells.x0;
            field.read(film, tile, grid::Shape::cell_in_tile(cells.x0, y), cells.width(),
                       out + place * field.channels);
        }
    });
}

}  // namespace pastoso::python
