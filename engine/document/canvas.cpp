#include "document/canvas.hpp"

#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/units.hpp"
#include "document/cloth.hpp"
#include "film/state.hpp"
#include "layers/extent.hpp"
#include "layers/turning.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <utility>

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

void check_between(const core::Message& what, double value, double least, double most,
                   const char* unit) {
    if (value >= least && value <= most) return;
    throw core::InputError("The %1 of the canvas is %2 %3, but must lie between %4 and %5.", what, value,
                           unit, least, most);
}

int cells_along(double side_mm, double px_per_mm) {
    return std::max(1, static_cast<int>(std::lround(side_mm * px_per_mm)));
}

/// So that 6.3 is 6.3, whatever it is a product of.
double in_millionths(double value) {
    return std::round(1e6 * value) / 1e6;
}

core::Message size_of(const CanvasSettings& settings) {
    return core::message("A canvas of %1 x %2 mm at %3 px/mm", settings.width_mm, settings.height_mm,
                         settings.px_per_mm);
}

std::string gib_text(std::size_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f GiB", static_cast<double>(bytes) / kBytesPerGiB);
    return text;
}

layers::Place middle_mm(const CanvasSettings& settings) {
    const grid::Shape shape = canvas_shape(settings);
    return {0.5 * shape.width / settings.px_per_mm, 0.5 * shape.height / settings.px_per_mm};
}

/// Of the size that a canvas has after everything on it has been turned.
CanvasSettings sized_for(const RotateCanvas& rotate, const CanvasSettings& settings) {
    if (rotate.keeps_size) return settings;
    const double angle = core::radians(rotate.turn_deg);
    const double cosine = std::abs(std::cos(angle)), sine = std::abs(std::sin(angle));
    const double width_mm = in_millionths(cosine * settings.width_mm + sine * settings.height_mm);
    const double height_mm = in_millionths(sine * settings.width_mm + cosine * settings.height_mm);
    return resized({0.5 * (settings.width_mm - width_mm), 0.5 * (settings.height_mm - height_mm),
                    width_mm, height_mm},
                   settings);
}

film::SupportHeights resized_support(const BareCanvas& bare, const CanvasSettings& wanted,
                                     const grid::Extent& extent, core::ThreadPool& pool) {
    if (wanted.support == "image") return layers::widened(bare.support_mm, extent);
    return heights_of_cloth(wanted, pool, film::form_of(bare.support_mm));
}

}  // namespace

void check_canvas(const CanvasSettings& settings) {
    check_between(core::message("width"), settings.width_mm, kMinCanvasSide_mm, kMaxCanvasSide_mm, "mm");
    check_between(core::message("height"), settings.height_mm, kMinCanvasSide_mm, kMaxCanvasSide_mm,
                  "mm");
    check_between(core::message("resolution"), settings.px_per_mm, kMinPxPerMm, kMaxPxPerMm, "px/mm");
    check_between(core::message("support relief"), settings.support_relief_mm, 0.0, 20.0, "mm");
    const DrawnOut cloth = drawn_out(settings.support_map);
    check_between(core::message("width of the cloth's threads"), 100.0 * cloth.least,
                  100.0 / kMostDrawnOut, 100.0 * kMostDrawnOut, "%");
    check_between(core::message("width of the cloth's threads"), 100.0 * cloth.most,
                  100.0 / kMostDrawnOut, 100.0 * kMostDrawnOut, "%");
    check_between(core::message("place on the cloth in x"), settings.support_x_mm, -kMaxClothPlace_mm,
                  kMaxClothPlace_mm, "mm");
    check_between(core::message("place on the cloth in y"), settings.support_y_mm, -kMaxClothPlace_mm,
                  kMaxClothPlace_mm, "mm");
    const grid::Shape shape = canvas_shape(settings);
    if (std::max(shape.width, shape.height) > kMaxCellsPerSide) {
        throw core::InputError("%1 would have %2 x %3 pixels; at most %4 a side are possible.",
                               size_of(settings), shape.width, shape.height, kMaxCellsPerSide);
    }
}

grid::Shape canvas_shape(const CanvasSettings& settings) {
    return {cells_along(settings.width_mm, settings.px_per_mm),
            cells_along(settings.height_mm, settings.px_per_mm)};
}

grid::Extent extent_of(const ResizeCanvas& resize, const CanvasSettings& settings) {
    return {canvas_shape(resized(resize, settings)), cells_from_origin(resize.x_mm, settings.px_per_mm),
            cells_from_origin(resize.y_mm, settings.px_per_mm)};
}

CanvasSettings resized(const ResizeCanvas& resize, CanvasSettings settings) {
    settings.width_mm = resize.width_mm;
    settings.height_mm = resize.height_mm;
    settings.support_x_mm += on_whole_cells(resize.x_mm, settings.px_per_mm);
    settings.support_y_mm += on_whole_cells(resize.y_mm, settings.px_per_mm);
    check_canvas(settings);
    return settings;
}

ResizedCanvas resized_canvas(const ResizeCanvas& resize, std::shared_ptr<const BareCanvas> before,
                             core::ThreadPool& pool) {
    BareCanvas after{.settings = resized(resize, before->settings), .support_mm = {}};
    check_canvas_fits(after.settings, core::available_memory_bytes());
    after.support_mm =
        resized_support(*before, after.settings, extent_of(resize, before->settings), pool);
    after.drawn_out_x = before->drawn_out_x;
    after.drawn_out_y = before->drawn_out_y;
    after.rotated_deg = before->rotated_deg;
    return {resize, std::move(before), std::make_shared<const BareCanvas>(std::move(after))};
}

CanvasSettings turned(const core::Orientation& turn, CanvasSettings settings) {
    settings = with_turned_cloth(turn, settings);
    if (turn.swaps_sides()) std::swap(settings.width_mm, settings.height_mm);
    check_canvas(settings);
    return settings;
}

BareCanvas turned(const core::Orientation& turn, const BareCanvas& bare, core::ThreadPool& pool) {
    BareCanvas after = bare;
    after.settings = turned(turn, bare.settings);
    after.support_mm = after.settings.support_map == ClothMap{}
                           ? layers::turned(bare.support_mm, turn, pool)
                           : heights_of_cloth(after.settings, pool, film::form_of(bare.support_mm));
    if (turn.swaps_sides()) std::swap(after.drawn_out_x, after.drawn_out_y);
    return after;
}

CanvasSettings scaled(const ScaleCanvas& scale, CanvasSettings settings) {
    settings.width_mm = in_millionths(scale.scale_x * settings.width_mm);
    settings.height_mm = in_millionths(scale.scale_y * settings.height_mm);
    settings.px_per_mm = in_millionths(scale.finer * settings.px_per_mm);
    settings = with_drawn_out_cloth(scale.scale_x, scale.scale_y, settings);
    check_canvas(settings);
    return settings;
}

layers::Resampling resampling_of(const ScaleCanvas& scale, const CanvasSettings& before) {
    const CanvasSettings after = scaled(scale, before);
    return {.map = {scale.finer * scale.scale_x, 0.0, 0.0, 0.0, scale.finer * scale.scale_y, 0.0},
            .shape = canvas_shape(after),
            .cell_mm = 1.0 / after.px_per_mm,
            .beyond = layers::Beyond::GoesOn};
}

BareCanvas scaled(const ScaleCanvas& scale, const BareCanvas& bare, core::ThreadPool& pool) {
    BareCanvas after{.settings = scaled(scale, bare.settings),
                     .support_mm = {},
                     .drawn_out_x = scale.scale_x * bare.drawn_out_x,
                     .drawn_out_y = scale.scale_y * bare.drawn_out_y,
                     .rotated_deg = bare.rotated_deg};
    check_canvas_fits(after.settings, core::available_memory_bytes());
    after.support_mm =
        after.settings.support == "image"
            ? layers::resampled(bare.support_mm, resampling_of(scale, bare.settings), pool)
            : heights_of_cloth(after.settings, pool, film::form_of(bare.support_mm));
    return after;
}

CanvasSettings rotated(const RotateCanvas& rotate, CanvasSettings settings) {
    const CanvasSettings sized = sized_for(rotate, settings);
    if (settings.support == "image") return sized;
    const layers::Place before_mm = middle_mm(settings), after_mm = middle_mm(sized);
    settings.width_mm = sized.width_mm;
    settings.height_mm = sized.height_mm;
    settings = with_rotated_cloth(rotate.turn_deg, before_mm, after_mm, settings);
    check_canvas(settings);
    return settings;
}

layers::Rotation rotation_of(const RotateCanvas& rotate, const CanvasSettings& before) {
    return {rotate.turn_deg, middle_mm(before), middle_mm(rotated(rotate, before))};
}

layers::Resampling resampling_of(const RotateCanvas& rotate, const CanvasSettings& before) {
    const double cell_mm = 1.0 / before.px_per_mm;
    return {.map = layers::in_cells(rotation_of(rotate, before), cell_mm),
            .shape = canvas_shape(rotated(rotate, before)),
            .cell_mm = cell_mm};
}

BareCanvas rotated(const RotateCanvas& rotate, const BareCanvas& bare, core::ThreadPool& pool) {
    BareCanvas after{.settings = rotated(rotate, bare.settings),
                     .support_mm = bare.support_mm,
                     .drawn_out_x = bare.drawn_out_x,
                     .drawn_out_y = bare.drawn_out_y,
                     .rotated_deg = bare.rotated_deg + rotate.turn_deg};
    check_canvas_fits(after.settings, core::available_memory_bytes());
    if (after.settings.support == "image")
        after.support_mm =
            layers::resampled(bare.support_mm, resampling_of(rotate, bare.settings), pool);
    else
        after.support_mm = heights_of_cloth(after.settings, pool, film::form_of(bare.support_mm));
    return after;
}

std::size_t estimated_bytes(const grid::Shape& shape) {
    return static_cast<std::size_t>(shape.tile_count()) * grid::kTileCells * kBytesPerCell;
}

void check_canvas_fits(const CanvasSettings& settings, std::size_t available_bytes) {
    check_canvas(settings);
    const std::size_t needed = estimated_bytes(canvas_shape(settings));
    if (needed <= available_bytes) return;
    throw core::InputError("%1 needs about %2; %3 of memory are free.", size_of(settings),
                           gib_text(needed), gib_text(available_bytes));
}

}  // namespace pastoso::document
