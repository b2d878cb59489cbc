#include "io/tea_cache.hpp"

#include "core/check.hpp"
#include "core/text_file.hpp"
#include "io/json_place.hpp"

#include <charconv>
#include <cstdio>

namespace pastoso::io {
namespace {

constexpr const char* kFormat = "pastoso-tea-cache";
constexpr int kVersion = 1, kMostFrames = 1'000'000;
constexpr double kLeastFps = 1.0, kMostFps = 1000.0;
constexpr std::size_t kMostIndexBytes = std::size_t{16} << 20;

std::filesystem::path index_path(const std::filesystem::path& folder) {
    return folder / "tea.json";
}

std::string hash_text(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

std::uint64_t read_hash(const JsonPlace& place) {
    const std::string text = place.text();
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value, 16);
    if (text.size() != 16 || fault != std::errc() || stop != end)
        place.fail("expected sixteen hexadecimal digits.");
    return value;
}

}  // namespace

void write_tea_index(const std::filesystem::path& folder, const TeaCacheIndex& index) {
    PASTOSO_CHECK(index.fps >= kLeastFps && index.fps <= kMostFps);
    PASTOSO_CHECK(index.count >= 0 && index.count <= kMostFrames);
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    Json json;
    json["format"] = kFormat;
    json["version"] = kVersion;
    json["scene_hash"] = hash_text(index.scene_hash);
    json["fps"] = index.fps;
    json["count"] = index.count;
    json["scene"] = index.scene;
    core::write_text_file(index_path(folder), json.dump(2) + "\n");
}

TeaCacheIndex read_tea_index(const std::filesystem::path& folder) {
    const std::string file = index_path(folder).string();
    const Json json = parse_json(core::read_text_file(file, kMostIndexBytes), file);
    const JsonPlace place(json, file);
    if (place.entry("format").text() != kFormat)
        place.entry("format").fail(std::string("expected \"") + kFormat + "\".");
    place.entry("version").integer(kVersion, kVersion);
    place.allow_only({"format", "version", "scene_hash", "fps", "count", "scene"});
    TeaCacheIndex index;
    index.scene = place.entry("scene").text();
    index.scene_hash = read_hash(place.entry("scene_hash"));
    index.fps = place.entry("fps").number();
    if (!(index.fps >= kLeastFps && index.fps <= kMostFps))
        place.entry("fps").fail("expected a number from 1 to 1000.");
    index.count = static_cast<int>(place.entry("count").integer(0, kMostFrames));
    return index;
}

std::filesystem::path tea_frame_path(const std::filesystem::path& folder, int frame) {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%06d.tea", frame);
    return folder / name;
}

std::vector<bool> whole_tea_frames(const std::filesystem::path& folder, const TeaCacheIndex& index) {
    std::vector<bool> whole;
    for (int frame = 1; frame <= index.count; ++frame)
        whole.push_back(is_whole_tea_frame(tea_frame_path(folder, frame), index.scene_hash));
    return whole;
}

}  // namespace pastoso::io
