#include "document/canvas.hpp"

#include "core/error.hpp"
#include "document/number_text.hpp"
#include "film/state.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

namespace pastoso::document {
namespace {

constexpr double kBytesPerGiB = 1024.0 * 1024.0 * 1024.0;

/// One set of the film's fields.
constexpr std::size_t kFilmBytesPerCell =
    sizeof(std::int32_t) + sizeof(film::PaintCell) + 3 * sizeof(float);

/// What lies dry below it; snapshots share most of it.
constexpr std::size_t kStrataBytesPerCell =
    sizeof(std::int32_t) + sizeof(film::PigmentCell) + sizeof(pigment::Bands);

/// The film twice (the live one and a snapshot of it), the solver's old and new velocities, and the
/// picture with its interpolated surface.
constexpr std::size_t kBytesPerCell = 2 * kFilmBytesPerCell + kStrataBytesPerCell + 16 + 48;

void check_between(const char* what, double value, double least, double most, const char* unit) {
    if (value >= least && value <= most) return;
    throw core::InputError(std::string("The ") + what + " of the canvas is " + number_text(value) +
                           unit + ", but must lie between " + number_text(least) + " and " +
                           number_text(most) + ".");
}

int cells_along(double side_mm, double px_per_mm) {
    return std::max(1, static_cast<int>(std::lround(side_mm * px_per_mm)));
}

std::string size_text(const CanvasSettings& settings) {
    return "A canvas of " + number_text(settings.width_mm) + " x " + number_text(settings.height_mm) +
           " mm at " + number_text(settings.px_per_mm) + " px/mm";
}

std::string gib_text(std::size_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f GiB", static_cast<double>(bytes) / kBytesPerGiB);
    return text;
}

}  // namespace

void check_canvas(const CanvasSettings& settings) {
    check_between("width", settings.width_mm, kMinCanvasSide_mm, kMaxCanvasSide_mm, " mm");
    check_between("height", settings.height_mm, kMinCanvasSide_mm, kMaxCanvasSide_mm, " mm");
    check_between("resolution", settings.px_per_mm, kMinPxPerMm, kMaxPxPerMm, " px/mm");
    check_between("support relief", settings.support_relief_mm, 0.0, 20.0, " mm");
    const grid::Shape shape = canvas_shape(settings);
    if (std::max(shape.width, shape.height) > kMaxCellsPerSide) {
        throw core::InputError(size_text(settings) + " would have " + std::to_string(shape.width) +
                               " x " + std::to_string(shape.height) + " cells; at most " +
                               std::to_string(kMaxCellsPerSide) + " a side are possible.");
    }
}

grid::Shape canvas_shape(const CanvasSettings& settings) {
    return {cells_along(settings.width_mm, settings.px_per_mm),
            cells_along(settings.height_mm, settings.px_per_mm)};
}

std::size_t estimated_bytes(const grid::Shape& shape) {
    return static_cast<std::size_t>(shape.tile_count()) * grid::kTileCells * kBytesPerCell;
}

std::size_t available_memory_bytes() {
    std::ifstream stream("/proc/meminfo");
    std::string key;
    std::size_t kibibytes = 0;
    std::string unit;
    while (stream >> key >> kibibytes) {
        if (key == "MemAvailable:") return kibibytes * 1024;
        std::getline(stream, unit);
    }
    return SIZE_MAX;
}

void check_canvas_fits(const CanvasSettings& settings, std::size_t available_bytes) {
    check_canvas(settings);
    const std::size_t needed = estimated_bytes(canvas_shape(settings));
    if (needed <= available_bytes) return;
    throw core::InputError(size_text(settings) + " needs about " + gib_text(needed) + "; " +
                           gib_text(available_bytes) + " of memory are free.");
}

}  // namespace pastoso::document
