#include "liquid_files/frame_index.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/looking.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"
#include "files/json_place.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace pastoso::liquid_files {
namespace {

constexpr int kVersion = 1, kMostFrames = 1'000'000;
constexpr double kLeastFps = 1.0, kMostFps = 1000.0;
constexpr std::size_t kMostIndexBytes = std::size_t{16} << 20;

std::uint64_t read_hash(const files::JsonPlace& place) {
    const std::string text = place.text();
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value, 16);
    if (text.size() != 16 || fault != std::errc() || stop != end)
        place.fail("expected sixteen hexadecimal digits.");
    return value;
}

}  // namespace

FrameIndex index_of(std::string scene, double fps, int count) {
    core::Hash64 hash;
    hash.add(std::as_bytes(std::span(scene)));
    return {std::move(scene), hash.value(), fps, count};
}

void write_frame_index(const std::filesystem::path& folder, const FrameIndexKind& kind,
                       const FrameIndex& index) {
    PASTOSO_CHECK(index.fps >= kLeastFps && index.fps <= kMostFps);
    PASTOSO_CHECK(index.count >= 0 && index.count <= kMostFrames);
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    files::Json json;
    json["format"] = kind.format;
    json["version"] = kVersion;
    json["scene_hash"] = core::hex_text(index.scene_hash);
    json["fps"] = index.fps;
    json["count"] = index.count;
    json["scene"] = index.scene;
    core::write_text_file(folder / kind.file, json.dump(2) + "\n");
}

FrameIndex read_frame_index(const std::filesystem::path& folder, const FrameIndexKind& kind) {
    const std::string file = (folder / kind.file).string();
    const files::Json json = files::parse_json(core::read_text_file(file, kMostIndexBytes), file);
    const files::JsonPlace place(json, file);
    if (place.entry("format").text() != kind.format)
        place.entry("format").fail("expected \"%1\".", kind.format);
    place.entry("version").integer(kVersion, kVersion);
    place.allow_only({"format", "version", "scene_hash", "fps", "count", "scene"});
    FrameIndex index;
    index.scene = place.entry("scene").text();
    index.scene_hash = read_hash(place.entry("scene_hash"));
    index.fps = place.entry("fps").number();
    if (!(index.fps >= kLeastFps && index.fps <= kMostFps))
        place.entry("fps").fail("expected a number from 1 to 1000.");
    index.count = static_cast<int>(place.entry("count").integer(0, kMostFrames));
    return index;
}

FrameIndex keep_frame_index(const std::filesystem::path& folder, const FrameIndexKind& kind,
                            FrameIndex index) {
    if (core::is_there(folder / kind.file)) {
        const FrameIndex there = read_frame_index(folder, kind);
        if (there.scene_hash != index.scene_hash || there.fps != index.fps)
            throw core::InputError("%1: keeps frames of %2; choose another folder.", folder.string(),
                                   core::message(kind.other));
        index.count = std::max(index.count, there.count);
    }
    write_frame_index(folder, kind, index);
    return index;
}

}  // namespace pastoso::liquid_files
