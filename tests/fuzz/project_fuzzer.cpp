// Project files of any bytes: refused in a sentence, or loaded and painted on. The first byte chooses
// how much of a file the fuzzer makes, since the checksums of a whole one stop it early.
#include "core/error.hpp"
#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "project/project.hpp"
#include "project/project_index.hpp"
#include "project/zip_file.hpp"
#include "recordings/tile_kinds.hpp"

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace pastoso::project {
namespace {

enum Mode { kFile, kIndex, kTiles, kFrame, kModes };

core::ThreadPool& pool() {
    static core::ThreadPool threads(1);
    return threads;
}

/// A canvas no larger than that keeps the fuzzer fast.
constexpr int kMostTiles = 64;

void load_and_paint(std::span<const std::byte> bytes) {
    const LoadedProject project = parse_project(bytes, "file", pool());
    if (project.painting.value.film.shape.tile_count() > kMostTiles) return;
    document::Painting painting(project.painting, pool());
    painting.advance_tick();
}

/// A tile of each kind in turn, filled with the bytes again and again.
void decode_tiles(std::span<const std::byte> bytes) {
    if (bytes.empty()) return;
    constexpr grid::Shape kShape{100, 70};
    document::SurfaceState surface{film::FilmState(kShape, 0.25), {}};
    surface.solver.awake.resize(1);
    surface.solver.pressures.resize(1);
    const auto places = static_cast<std::size_t>(kShape.tile_count());
    recordings::SurfaceTarget target{surface, std::vector<int>(places, 0), std::vector<int>(places, 0)};
    for (const recordings::TileKind& kind : recordings::tile_kinds()) {
        Bytes content(kind.bytes);
        for (std::size_t i = 0; i < content.size(); ++i)
            content[i] = bytes[i % bytes.size()];
        for (int tile = 0; tile < kShape.tile_count(); ++tile)
            kind.decode(content.data(), tile, target);
    }
}

void unpack(std::span<const std::byte> bytes) {
    std::uint32_t size = 0;
    if (bytes.size() < sizeof size) return;
    std::memcpy(&size, bytes.data(), sizeof size);
    packing::unpacked(bytes.subspan(sizeof size), size % (1U << 22));
}

void try_bytes(int mode, std::span<const std::byte> bytes) {
    switch (mode) {
        case kFile:
            return load_and_paint(bytes);
        case kIndex:
            index_from_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, "index");
            return;
        case kTiles:
            return decode_tiles(bytes);
        default:
            return unpack(bytes);
    }
}

}  // namespace
}  // namespace pastoso::project

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace pastoso::project;
    if (size == 0) return 0;
    try {
        try_bytes(data[0] % kModes, std::as_bytes(std::span(data + 1, size - 1)));
    } catch (const pastoso::core::InputError&) {
        return 0;
    }
    return 0;
}
