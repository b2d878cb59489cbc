#include "document/film_tiles.hpp"

#include "packing/packed_bytes.hpp"
#include "packing/tile_values.hpp"

#include <algorithm>
#include <atomic>
#include <future>

namespace pastoso::document {
namespace {

using film::FilmState;
using film::HeightBlock;
using grid::kTileCells;
using grid::TileBlock;
using packing::Bytes;

/// What the values of a field are in proportion to, cell by cell (packing::TileCodec).
struct NoAmount {
    static const std::int32_t* of(const FilmState&, int) { return nullptr; }
};
struct WetThickness {
    static const std::int32_t* of(const FilmState& film, int tile) { return film.thickness.read(tile); }
};
struct LowerThickness {
    static const std::int32_t* of(const FilmState& film, int tile) {
        return film.lower.thickness.read(tile);
    }
};
struct SolubleThickness {
    static const std::int32_t* of(const FilmState& film, int tile) {
        return film.strata.soluble_thickness.read(tile);
    }
};

/// Calls visit(amount, field, ...) with each field of all that have the fields of a film; thicknesses
/// come before what is in proportion to them.
template <class Visit, class... Films>
void for_each_field(const Visit& visit, Films&&... films) {
    visit(NoAmount{}, films.thickness...);
    visit(WetThickness{}, films.paint...);
    visit(NoAmount{}, films.lower.thickness...);
    visit(LowerThickness{}, films.lower.paint...);
    visit(WetThickness{}, films.worked.thickness...);
    visit(WetThickness{}, films.media.foreign...);
    visit(NoAmount{}, films.velocity_x...);
    visit(NoAmount{}, films.velocity_y...);
    visit(NoAmount{}, films.support_mm...);
    visit(NoAmount{}, films.strata.soluble_thickness...);
    visit(SolubleThickness{}, films.strata.soluble_pigment...);
    visit(NoAmount{}, films.strata.optics...);
    visit(NoAmount{}, films.strata.uppermost...);
}

template <class Block, class Field>
void collect(const Field& older, const Field& newer, TileSet<Block>& set) {
    for (int tile = 0; tile < older.tile_count(); ++tile) {
        const bool is_background = older.is_background(tile);
        if (is_background ? newer.is_background(tile) : older.shares_tile(newer, tile)) continue;
        set.tiles.push_back(tile);
        set.blocks.push_back(is_background ? Block{} : older.block(tile));
    }
}

template <class Value>
std::size_t bytes_of(const TileBlock<Value>& block) {
    return block ? kTileCells * sizeof(Value) : 0;
}
/// As floats: a file that is opened may give in levels what were floats before.
std::size_t bytes_of(const HeightBlock& block) {
    return block ? kTileCells * sizeof(float) : 0;
}
template <class Block>
std::size_t bytes_of(const TileSet<Block>& set) {
    std::size_t sum = 0;
    for (const Block& block : set.blocks)
        sum += bytes_of(block);
    return sum;
}

template <class Block, class Field>
void put(const TileSet<Block>& set, Field& field) {
    for (std::size_t i = 0; i < set.tiles.size(); ++i) {
        if (set.blocks[i])
            field.replace(set.tiles[i], set.blocks[i]);
        else
            field.reset(set.tiles[i]);
    }
}

FilmSums sums_of(const FilmState& film) {
    return {film.strata.fixed, film.strata.evaporated, film.consistencies, film.media.numbers,
            film.media.own};
}

void put(const FilmSums& sums, FilmState& film) {
    film.strata.fixed = sums.fixed;
    film.strata.evaporated = sums.evaporated;
    film.consistencies = sums.consistencies;
    film.media.numbers = sums.media;
    film.media.own = sums.own_media;
}

/// What a tile is packed with: large memory that is asked for again and again costs more than packing.
struct Bench {
    packing::Packer packer;
    Bytes room;

    template <class Value>
    Bytes packed(const TileBlock<Value>& block, const std::int32_t* amount) {
        if (!block) return {};
        room.resize(packing::tile_bytes(packing::kChannels<Value>));
        packing::encode_values(block.read(), {amount}, room.data());
        return packer.packed(room);
    }
    Bytes packed(const HeightBlock& block, const std::int32_t* amount) {
        return block ? packed(film::copied_heights(block.read()), amount) : Bytes{};
    }
};

template <class Value>
TileBlock<Value> unpacked(packing::Unpacker& unpacker, const Bytes& frame, const std::int32_t* amount,
                          const grid::TiledField<Value>&) {
    const auto content = unpacker.unpacked(frame, packing::tile_bytes(packing::kChannels<Value>));
    return packing::decoded_values<Value>(content.data(), {amount});
}
HeightBlock unpacked(packing::Unpacker& unpacker, const Bytes& frame, const std::int32_t* amount,
                     const film::SupportHeights&) {
    return packing::decoded_values<float>(unpacker.unpacked(frame, packing::tile_bytes(1)).data(),
                                          {amount});
}

/// Unpacks a tile of a field if it is in the set. Different tiles may be put at the same time.
template <class Amount, class Field>
void put_tile(const TileSet<Bytes>& set, int tile, Amount amount, packing::Unpacker& unpacker,
              const FilmState& film, Field& field) {
    const auto found = std::lower_bound(set.tiles.begin(), set.tiles.end(), tile);
    if (found == set.tiles.end() || *found != tile) return;
    const Bytes& frame = set.blocks[static_cast<std::size_t>(found - set.tiles.begin())];
    if (frame.empty())
        field.reset(tile);
    else
        field.replace(tile, unpacked(unpacker, frame, amount.of(film, tile), field));
}

std::vector<int> tiles_of_any(const std::vector<TileSet<Bytes>>& fields) {
    std::vector<int> tiles;
    for (const TileSet<Bytes>& field : fields)
        tiles.insert(tiles.end(), field.tiles.begin(), field.tiles.end());
    std::sort(tiles.begin(), tiles.end());
    tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
    return tiles;
}

template <class Block>
void add(int tile, Block block, TileSet<Block>& set) {
    set.tiles.push_back(tile);
    set.blocks.push_back(std::move(block));
}

/// Whether a tile is kept beside its values, as the canvas has it.
template <class Value>
bool keep_levels(int, const TileBlock<Value>&, TileSet<HeightBlock>&) {
    return false;
}
bool keep_levels(int tile, const HeightBlock& block, TileSet<HeightBlock>& levels) {
    if (block.in_levels()) add(tile, block, levels);
    return block.in_levels();
}

}  // namespace

FilmTiles::FilmTiles(const FilmState& older, const FilmState& newer) : sums(sums_of(older)) {
    PASTOSO_CHECK(older.shape == newer.shape);
    for_each_field([](auto, auto& set, const auto& from, const auto& to) { collect(from, to, set); },
                   *this, older, newer);
}

std::size_t FilmTiles::bytes() const {
    std::size_t sum = 0;
    for_each_field([&](auto, const auto& set) { sum += bytes_of(set); }, *this);
    return sum;
}

void FilmTiles::put_into(FilmState& film) const {
    for_each_field([](auto, const auto& set, auto& field) { put(set, field); }, *this, film);
    put(sums, film);
}

PackedFilmTiles::PackedFilmTiles(const FilmTiles& tiles, const FilmState& older,
                                 const std::function<void()>& rest)
    : sums_(tiles.sums) {
    Bench bench;
    for_each_field(
        [&](auto amount, const auto& set) {
            TileSet<Bytes>& field = fields_.emplace_back();
            for (std::size_t i = 0; i < set.tiles.size(); ++i) {
                rest();
                const int tile = set.tiles[i];
                Bytes frame = bench.packed(set.blocks[i], amount.of(older, tile));
                bytes_ += frame.size();
                if (!keep_levels(tile, set.blocks[i], levels_)) add(tile, std::move(frame), field);
            }
        },
        tiles);
}

/// All fields of a tile by one thread, since some are in proportion to others.
void PackedFilmTiles::put_into(FilmState& film) const {
    const std::vector<int> tiles = tiles_of_any(fields_);
    std::atomic<std::size_t> next = 0;
    const auto put_tiles = [&] {
        packing::Unpacker unpacker;
        for (std::size_t i = next++; i < tiles.size(); i = next++) {
            auto set = fields_.begin();
            for_each_field(
                [&](auto amount, auto& field) {
                    put_tile(*set++, tiles[i], amount, unpacker, film, field);
                },
                film);
        }
    };
    auto others = std::async(std::launch::async, put_tiles);
    put_tiles();
    others.get();
    put(levels_, film.support_mm);
    put(sums_, film);
}

}  // namespace pastoso::document
