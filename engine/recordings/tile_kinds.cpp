#include "recordings/tile_kinds.hpp"

#include "packing/tile_values.hpp"
#include "recordings/activity_record.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

namespace pastoso::recordings {
namespace {

using document::SurfaceState;
using grid::kTileCells;
using grid::TiledField;
using packing::decoded_values;
using packing::encode_values;
using packing::kChannels;
using packing::tile_bytes;

/// Faster than any paint runs: a fall over five metres ends with a tenth of it.
constexpr float kFastest_mm_s = 1e5F;
/// Higher than a support with all dried paint on it: a metre.
constexpr float kHighest_mm = 1000.0F;
/// Far above the pressure of the strongest jet on the smallest cells.
constexpr float kStrongestPressure_mm2_s2 = 1e9F;
/// In 65535ths: the whitest paint has 0.9955, and rounding adds a little with every stratum.
constexpr int kMostReflected = 65500;
constexpr double kAllLight = 1.0 + 1.0 / 256.0;
constexpr std::int32_t kMostSoluble_quanta = std::int32_t{1} << 30;

bool is_within(float value, float least, float most) {
    return value >= least && value <= most;
}

/// A field of the film: where it is, what its numbers are, and between which bounds they lie.
struct Thickness {
    using Value = std::int32_t;
    static auto& of(auto& surface) { return surface.film.thickness; }
    static bool is_possible(Value quanta) { return quanta >= 0 && quanta <= film::kMaxThickness_quanta; }
    static constexpr auto kWhat = core::Pattern<0>("a thickness");
};
struct SmoothThickness : Thickness {
    static constexpr bool kSmooth = true;
};
struct Paint {
    using Value = film::PaintCell;
    static auto& of(auto& surface) { return surface.film.paint; }
    static auto& amount(auto& surface) { return surface.film.thickness; }
    static bool is_possible(const Value& cell) {
        return std::all_of(cell.begin(), cell.end(), [](std::int32_t channel) { return channel >= 0; });
    }
    static constexpr auto kWhat = core::Pattern<0>("an amount of paint");
};
/// That the lower stratum is no more than the whole is looked at when both are there.
struct LowerThickness : SmoothThickness {
    static auto& of(auto& surface) { return surface.film.lower.thickness; }
};
struct LowerPaint : Paint {
    static auto& of(auto& surface) { return surface.film.lower.paint; }
    static auto& amount(auto& surface) { return surface.film.lower.thickness; }
};
struct WorkedThickness : Thickness {
    static auto& of(auto& surface) { return surface.film.worked.thickness; }
    static auto& amount(auto& surface) { return surface.film.thickness; }
};
struct Media : Paint {
    static auto& of(auto& surface) { return surface.film.media.foreign; }
    static constexpr auto kWhat = core::Pattern<0>("an amount of a medium");
};
struct VelocityX {
    using Value = float;
    static auto& of(auto& surface) { return surface.film.velocity_x; }
    static bool is_possible(Value speed) { return is_within(speed, -kFastest_mm_s, kFastest_mm_s); }
    static constexpr auto kWhat = core::Pattern<0>("a velocity");
};
struct VelocityY : VelocityX {
    static auto& of(auto& surface) { return surface.film.velocity_y; }
};
struct Support {
    using Value = float;
    static auto& of(auto& surface) { return surface.film.support_mm; }
    static bool is_possible(Value height) { return is_within(height, -kHighest_mm, kHighest_mm); }
    static constexpr auto kWhat = core::Pattern<0>("a height of the support");
};
struct SolubleThickness {
    using Value = std::int32_t;
    static auto& of(auto& surface) { return surface.film.strata.soluble_thickness; }
    static bool is_possible(Value quanta) { return quanta >= 0 && quanta <= kMostSoluble_quanta; }
    static constexpr auto kWhat = core::Pattern<0>("a thickness of dry paint");
};
struct SolublePigment {
    using Value = film::PigmentCell;
    static auto& of(auto& surface) { return surface.film.strata.soluble_pigment; }
    static auto& amount(auto& surface) { return surface.film.strata.soluble_thickness; }
    static bool is_possible(const Value& cell) {
        return std::all_of(cell.begin(), cell.end(), [](std::int32_t channel) { return channel >= 0; });
    }
    static constexpr auto kWhat = core::Pattern<0>("an amount of dry pigment");
};
struct Optics {
    using Value = film::StrataOptics;
    static auto& of(auto& surface) { return surface.film.strata.optics; }
    /// Over a ground that absorbs nothing, R + T^2 / (1 - Q) comes back. A layer by itself may give
    /// more, R + T, as those of half-transparent pictures do (pigment::laid_in_part).
    static bool is_possible(const Value& strata) {
        for (int band = 0; band < pigment::kBands; ++band) {
            if (std::max(strata[band], strata[2 * pigment::kBands + band]) > kMostReflected)
                return false;
            const auto layer = film::optics_of(strata, band);
            const double passed = layer.transmittance;
            if (layer.reflectance + passed * passed / (1.0 - layer.reverse) > kAllLight) return false;
        }
        return true;
    }
    static constexpr auto kWhat = core::Pattern<0>("strata that give more light than they get");
};
struct Uppermost {
    using Value = film::PigmentMixture;
    static auto& of(auto& surface) { return surface.film.strata.uppermost; }
    static bool is_possible(const Value&) { return true; }
    static constexpr auto kWhat = core::Pattern<0>("a mixture");
};

/// Cells beyond the canvas, in the tiles on its edges, mean nothing: what is impossible there is put to
/// nothing. On the canvas it is an error.
template <class Value, class IsPossible>
core::Message checked(Value* values, const grid::Shape& shape, int tile, core::Pattern<0> what,
                      const IsPossible& is_possible) {
    const grid::Rect inside = shape.tile_cells(tile);
    for (int cell = 0; cell < kTileCells; ++cell) {
        if (is_possible(values[cell])) continue;
        const int x = cell % grid::kTileSize, y = cell / grid::kTileSize;
        if (x < inside.width() && y < inside.height())
            return core::message("cell (%1, %2) holds %3 that cannot be.", inside.x0 + x, inside.y0 + y,
                                 core::message(what));
        values[cell] = Value{};
    }
    return {};
}

/// Hands a block to `take` when all of it is possible; what is refused is not used at all. Returns what
/// is wrong.
template <class Value, class IsPossible, class Take>
core::Message take_checked(grid::TileBlock<Value> block, const grid::Shape& shape, int tile,
                           core::Pattern<0> what, const IsPossible& is_possible, const Take& take) {
    core::Message fault = checked(block.write(), shape, tile, what, is_possible);
    if (fault.empty()) take(std::move(block));
    return fault;
}

template <class Field>
constexpr bool kIsAmount = requires(SurfaceState& surface) {
    Field::amount(surface);
};

template <class Field>
constexpr bool kIsSmooth = requires {
    Field::kSmooth;
};

template <class Field>
packing::Expectation expectation(const SurfaceState& surface, int tile) {
    if constexpr (kIsAmount<Field>)
        return {.amount = Field::amount(surface).read(tile), .smooth = false};
    else
        return {.amount = nullptr, .smooth = kIsSmooth<Field>};
}

template <class Field>
std::vector<int> written_tiles(const SurfaceSource& source) {
    const auto& field = Field::of(source.surface);
    std::vector<int> tiles;
    for (int tile = 0; tile < field.tile_count(); ++tile)
        if (!field.is_background(tile)) tiles.push_back(tile);
    return tiles;
}

bool holds_paint(const film::FilmState& film, int tile) {
    return !film.thickness.is_background(tile) || !film.paint.is_background(tile) ||
           !film.strata.optics.is_background(tile) || !film.strata.soluble_thickness.is_background(tile);
}

/// The support below paint is always written: it must not change with the version of the program.
std::vector<int> own_support_tiles(const SurfaceSource& source) {
    const film::FilmState& film = source.surface.film;
    std::vector<int> tiles = written_tiles<Support>(source);
    if (source.bare_support_mm != nullptr) {
        std::erase_if(tiles, [&](int tile) {
            return film.support_mm.shares_tile(*source.bare_support_mm, tile) &&
                   !holds_paint(film, tile);
        });
    }
    return tiles;
}

template <class Field>
void encode_field(const SurfaceSource& source, int tile, std::byte* out) {
    encode_values(Field::of(source.surface).read(tile), expectation<Field>(source.surface, tile), out);
}

template <class Field>
core::Message decode_field(const std::byte* in, int tile, SurfaceTarget& target) {
    using Value = typename Field::Value;
    return take_checked(
        decoded_values<Value>(in, expectation<Field>(target.surface, tile)), target.surface.film.shape,
        tile, Field::kWhat, [](const Value& value) { return Field::is_possible(value); },
        [&](auto block) { Field::of(target.surface).replace(tile, std::move(block)); });
}

template <class Field>
constexpr TileKind field_kind(const char* name) {
    return {name,
            tile_bytes(kChannels<typename Field::Value>),
            kIsAmount<Field> ? 1 : 0,
            &written_tiles<Field>,
            &encode_field<Field>,
            &decode_field<Field>};
}

void encode_support(const SurfaceSource& source, int tile, std::byte* out) {
    std::vector<float> heights_mm(kTileCells);
    Support::of(source.surface).read(tile).copy(0, kTileCells, heights_mm.data());
    encode_values(heights_mm.data(), {}, out);
}

core::Message decode_support(const std::byte* in, int tile, SurfaceTarget& target) {
    return take_checked(decoded_values<float>(in, {}), target.surface.film.shape, tile, Support::kWhat,
                        &Support::is_possible, [&](auto heights_mm) {
                            Support::of(target.surface)
                                .replace(tile, film::HeightBlock::smallest_of(std::move(heights_mm)));
                        });
}

bool is_reflectance(const pigment::Bands& bands) {
    return std::all_of(bands.begin(), bands.end(),
                       [](float share) { return is_within(share, 0.0F, 0.999F); });
}

grid::TileBlock<film::StrataOptics> hiding_strata(const grid::TileBlock<pigment::Bands>& ground) {
    auto optics = grid::TileBlock<film::StrataOptics>::filled(film::kClearStrata);
    for (int cell = 0; cell < kTileCells; ++cell) {
        for (int band = 0; band < pigment::kBands; ++band) {
            const float reflectance = ground.read()[cell][band];
            film::set_optics(band, {reflectance, 0.0F, reflectance}, optics.write()[cell]);
        }
    }
    return optics;
}

/// Of format 1: the reflectance of strata and support together. What lay below is not known apart, so it
/// is hidden for good.
core::Message decode_ground(const std::byte* in, int tile, SurfaceTarget& target) {
    return take_checked(decoded_values<pigment::Bands>(in, {}), target.surface.film.shape, tile,
                        core::Pattern<0>("a reflectance"), &is_reflectance, [&](const auto& ground) {
                            target.surface.film.strata.optics.replace(tile, hiding_strata(ground));
                        });
}

std::vector<int> no_tiles(const SurfaceSource&) {
    return {};
}

/// Of files of older versions.
constexpr TileKind read_only(TileKind kind) {
    kind.tiles = &no_tiles;
    kind.encode = nullptr;
    return kind;
}

constexpr TileKind ground_kind() {
    return {.name = "ground",
            .bytes = tile_bytes(pigment::kBands),
            .phase = 0,
            .tiles = &no_tiles,
            .encode = nullptr,
            .decode = &decode_ground};
}

constexpr TileKind support_kind() {
    return {"support", tile_bytes(1), 0, &own_support_tiles, &encode_support, &decode_support};
}

/// The place of a tile in a list in ascending order of tiles; it is there.
template <class Listed>
const Listed& listed(const std::vector<Listed>& list, int tile) {
    return *std::lower_bound(list.begin(), list.end(), tile,
                             [](const Listed& one, int wanted) { return one.tile < wanted; });
}

std::vector<int> awake_tiles(const SurfaceSource& source) {
    std::vector<int> tiles;
    for (const auto& awake : source.surface.solver.awake)
        tiles.push_back(awake.tile);
    return tiles;
}

void encode_awake(const SurfaceSource& source, int tile, std::byte* out) {
    const ActivityRecord record = activity_record(listed(source.surface.solver.awake, tile).activity);
    std::memcpy(out, record.data(), sizeof record);
}

core::Message decode_awake(const std::byte* in, int tile, SurfaceTarget& target) {
    ActivityRecord record;
    std::memcpy(record.data(), in, sizeof record);
    const film::TileActivity activity = activity_of(record);
    if (!is_possible(activity)) return core::message("tile %1 moves as no paint can.", tile);
    target.surface.solver.awake[target.awake_at[tile]].activity = activity;
    return {};
}

std::vector<int> window_tiles(const SurfaceSource& source) {
    std::vector<int> tiles;
    for (const auto& awake : source.surface.solver.awake)
        if (awake.window_start) tiles.push_back(awake.tile);
    return tiles;
}

void encode_window(const SurfaceSource& source, int tile, std::byte* out) {
    encode_values(listed(source.surface.solver.awake, tile).window_start.read(), {}, out);
}

core::Message decode_window(const std::byte* in, int tile, SurfaceTarget& target) {
    if (target.awake_at[tile] < 0)
        return core::message("tile %1 sleeps, and yet its motion is followed.", tile);
    auto& window_start = target.surface.solver.awake[target.awake_at[tile]].window_start;
    return take_checked(decoded_values<std::int32_t>(in, {}), target.surface.film.shape, tile,
                        Thickness::kWhat, &Thickness::is_possible,
                        [&](auto block) { window_start = std::move(block); });
}

std::vector<int> pressure_tiles(const SurfaceSource& source) {
    std::vector<int> tiles;
    for (const auto& known : source.surface.solver.pressures)
        tiles.push_back(known.tile);
    return tiles;
}

void encode_pressure(const SurfaceSource& source, int tile, std::byte* out) {
    encode_values(listed(source.surface.solver.pressures, tile).pressure_mm2_s2.read(), {}, out);
}

core::Message decode_pressure(const std::byte* in, int tile, SurfaceTarget& target) {
    auto& pressure = target.surface.solver.pressures[target.pressure_at[tile]].pressure_mm2_s2;
    return take_checked(
        decoded_values<float>(in, {}), target.surface.film.shape, tile, core::Pattern<0>("a pressure"),
        [](float value) {
            return is_within(value, -kStrongestPressure_mm2_s2, kStrongestPressure_mm2_s2);
        },
        [&](auto block) { pressure = std::move(block); });
}

}  // namespace

std::span<const TileKind> tile_kinds() {
    static constexpr std::array kKinds = {
        field_kind<SmoothThickness>("depth"),
        read_only(field_kind<Thickness>("thickness")),
        field_kind<Paint>("paint"),
        field_kind<LowerThickness>("lower_depth"),
        field_kind<LowerPaint>("lower_paint"),
        field_kind<WorkedThickness>("worked"),
        field_kind<Media>("media"),
        field_kind<VelocityX>("velocity_x"),
        field_kind<VelocityY>("velocity_y"),
        support_kind(),
        field_kind<SolubleThickness>("soluble_thickness"),
        field_kind<SolublePigment>("soluble_pigment"),
        field_kind<Optics>("optics"),
        ground_kind(),
        field_kind<Uppermost>("uppermost"),
        TileKind{"awake", sizeof(ActivityRecord), 0, &awake_tiles, &encode_awake, &decode_awake},
        TileKind{"window", tile_bytes(1), 0, &window_tiles, &encode_window, &decode_window},
        TileKind{"pressure", tile_bytes(1), 0, &pressure_tiles, &encode_pressure, &decode_pressure},
    };
    return kKinds;
}

}  // namespace pastoso::recordings
