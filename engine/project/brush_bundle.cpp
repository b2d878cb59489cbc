#include "project/brush_bundle.hpp"

#include "core/check.hpp"
#include "core/text.hpp"
#include "files/json_place.hpp"
#include "project/zip_file.hpp"

#include <set>
#include <string>

namespace pastoso::project {
namespace {

using files::Json;
using files::JsonPlace;

constexpr const char* kManifest = "manifest.json";
constexpr files::FileFormat kFormat = {"pastoso-brushes", "a bundle of tools", "bundle format", 1};
constexpr std::size_t kMostManifestBytes = 1U << 20, kMostPresetBytes = 1U << 20;

std::string text_of(const ZipReader& archive, const std::string& entry, std::size_t most_bytes) {
    const Bytes bytes = archive.read(entry, most_bytes);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<std::string> read_manifest(const ZipReader& archive) {
    const std::string file = archive.name() + ", " + kManifest;
    const Json json = files::parse_json(text_of(archive, kManifest, kMostManifestBytes), file);
    const JsonPlace root(json, file);
    files::check_format(root, kFormat);
    root.allow_only({"format", "version", "presets"});
    const JsonPlace list = root.entry("presets");
    if (list.size() > kMostBundledPresets)
        list.fail("there are %1 tools, more than %2.", list.size(), kMostBundledPresets);
    std::vector<std::string> entries;
    for (std::size_t i = 0; i < list.size(); ++i)
        entries.push_back(list.element(i).text());
    return entries;
}

}  // namespace

void write_brush_bundle(const std::vector<brush::Preset>& presets, const std::filesystem::path& file) {
    PASTOSO_CHECK(presets.size() <= kMostBundledPresets);
    ZipWriter archive;
    Json entries = Json::array();
    for (std::size_t i = 0; i < presets.size(); ++i)
        entries.push_back("presets/" + std::to_string(i + 1) + ".json");
    const Json manifest = {{"format", kFormat.name}, {"version", kFormat.newest}, {"presets", entries}};
    archive.add(kManifest, manifest.dump(2) + "\n");
    for (std::size_t i = 0; i < presets.size(); ++i)
        archive.add(entries[i].get<std::string>(), brush::preset_to_json(presets[i]));
    core::write_aside(file, [&](core::OutputFile& output) { archive.write(output); });
}

std::vector<brush::Preset> read_brush_bundle(const std::filesystem::path& file) {
    const ZipReader archive(file);
    if (!archive.has(kManifest))
        throw core::InputError("%1: is no bundle of tools; it has no %2.", archive.name(), kManifest);
    std::vector<brush::Preset> presets;
    std::set<std::string> names;
    for (const std::string& entry : read_manifest(archive)) {
        presets.push_back(brush::parse_preset(text_of(archive, entry, kMostPresetBytes),
                                              archive.name() + ", " + entry));
        if (!names.insert(core::lower_case(presets.back().name)).second)
            archive.fail(entry, "name is \"%1\", which another tool of the bundle has already.",
                         presets.back().name);
    }
    return presets;
}

}  // namespace pastoso::project
