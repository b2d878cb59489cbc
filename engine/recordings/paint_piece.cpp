#include "recordings/paint_piece.hpp"

#include "files/json_place.hpp"
#include "packing/packed_bytes.hpp"
#include "recordings/surface_json.hpp"
#include "recordings/tile_entries.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

namespace pastoso::recordings {
namespace {

using files::Json;
using files::JsonPlace;

constexpr files::FileFormat kFormat{"pastoso-paint", core::Pattern<0>("copied paint"),
                                    core::Pattern<0>("format of copied paint"), kPieceFormatVersion};

/// What the head begins with: sooner than a sentence on its JSON, whoever pastes something else is told
/// that.
constexpr std::string_view kMark = R"({"format":"pastoso-paint",)";

/// What one piece adds to the account must leave room for a thousand others.
constexpr double kMostCount = static_cast<double>(kMostPaint / 1024);

/// Packs the tiles of the entries one after the other and tells the entries how long they become.
std::string packed_tiles(const SurfaceSource& source, std::vector<TileEntry>& entries) {
    packing::Packer packer;
    packing::Bytes room;
    std::string frames;
    for (TileEntry& entry : entries) {
        room.resize(entry.packed.size);
        encode_tiles(source, entry, room);
        const packing::Bytes frame = packer.packed(room);
        entry.packed.packed_size = frame.size();
        frames.append(reinterpret_cast<const char*>(frame.data()), frame.size());
    }
    return frames;
}

SurfaceIndex read_head(const JsonPlace& root) {
    files::check_format(root, kFormat);
    root.allow_only({"format", "version", "surface"});
    const JsonPlace place = root.entry("surface");
    SurfaceIndex index = read_surface(place);
    if (!is_possible_cell(index.cell_mm))
        place.entry("cell_mm").fail("no painting has cells of this size.");
    if (largest_count(index) > kMostCount) place.fail("no canvas holds so much paint.");
    return index;
}

/// Throws unless the frames that are told fill the bytes.
std::uint64_t check_sizes(const JsonPlace& root, const SurfaceIndex& index, std::size_t frame_bytes) {
    std::uint64_t packed = 0, unpacked = 0;
    for (const TileEntry& entry : index.entries) {
        packed += entry.packed.packed_size;
        unpacked += entry.packed.size;
    }
    if (packed != frame_bytes)
        root.fail("%1 bytes of paint follow, but there should be %2.", frame_bytes, packed);
    if (unpacked > kMostPiece_bytes) root.fail("there is more paint than is read, 4 GB.");
    return unpacked;
}

void read_phase(int phase, std::string_view frames, const SurfaceIndex& index, SurfaceTarget& target,
                const JsonPlace& root) {
    packing::Unpacker unpacker;
    for (const TileEntry& entry : index.entries) {
        const std::string_view frame = frames.substr(0, entry.packed.packed_size);
        frames.remove_prefix(frame.size());
        if (kind_of(entry).phase != phase) continue;
        root.guard([&] {
            const auto content = unpacker.unpacked(std::as_bytes(std::span(frame)), entry.packed.size);
            const core::Message fault = decode_tiles(content, entry, target);
            if (!fault.empty()) throw core::InputError(fault);
        });
    }
}

}  // namespace

std::string piece_bytes(const film::FilmState& paint) {
    const document::SurfaceState surface{paint, {}};
    const SurfaceSource source{surface};
    SurfaceIndex index = surface_index(surface);
    index.entries = tile_entries(source, "pastoso/piece/");
    const std::string frames = packed_tiles(source, index.entries);
    const Json head{
        {"format", kFormat.name}, {"version", kPieceFormatVersion}, {"surface", surface_json(index)}};
    return head.dump() + "\n" + frames;
}

PaintPiece piece_of(std::string_view bytes, const std::string& name) {
    if (!bytes.starts_with(kMark))
        throw core::InputError("%1: is no paint that was copied in Pastoso.", name);
    const std::string_view head = bytes.substr(0, bytes.find('\n'));
    const Json json = files::parse_json(head, name);
    const JsonPlace root(json, name);
    const SurfaceIndex index = read_head(root);
    const std::string_view frames = bytes.substr(std::min(head.size() + 1, bytes.size()));
    const std::uint64_t unpacked_bytes = check_sizes(root, index, frames.size());
    document::SurfaceState surface = empty_surface(index);
    SurfaceTarget target = target_of(index.entries, surface);
    for (const int phase : {0, 1})
        read_phase(phase, frames, index, target, root);
    const core::Message fault = fault_between_tiles(surface.film);
    if (!fault.empty()) root.fail(fault);
    return {std::make_shared<const film::FilmState>(std::move(surface.film)), unpacked_bytes};
}

}  // namespace pastoso::recordings
