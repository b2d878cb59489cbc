#include "project/brush_bundle.hpp"

#include "core/check.hpp"
#include "core/text.hpp"
#include "files/json_place.hpp"
#include "project/zip_file.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace pastoso::project {
namespace {

using files::Json;
using files::JsonPlace;

constexpr const char* kManifest = "manifest.json";
constexpr files::FileFormat kFormat = {"pastoso-brushes", "a bundle of tools", "bundle format", 2};
constexpr std::size_t kMostManifestBytes = 1U << 20, kMostPresetBytes = 1U << 20;

std::string entry_of(std::size_t preset) {
    return "presets/" + std::to_string(preset + 1) + ".json";
}

std::string text_of(const ZipReader& archive, const std::string& entry, std::size_t most_bytes) {
    const Bytes bytes = archive.read(entry, most_bytes);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Manifest {
    std::vector<std::string> presets;  ///< their entries
    std::vector<BundledTag> tags;
};

std::vector<std::string> read_texts(const JsonPlace& list) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < list.size(); ++i)
        texts.push_back(list.element(i).text());
    return texts;
}

void read_tag(const JsonPlace& place, std::vector<BundledTag>& tags) {
    place.allow_only({"name", "tools"});
    const JsonPlace name = place.entry("name");
    BundledTag tag{name.text(), read_texts(place.entry("tools"))};
    if (core::is_blank(tag.name)) name.fail("a tag needs a name.");
    if (std::ranges::find(tags, tag.name, &BundledTag::name) != tags.end())
        name.fail("\"%1\" is there twice.", tag.name);
    tags.push_back(std::move(tag));
}

Manifest read_manifest(const ZipReader& archive) {
    const std::string file = archive.name() + ", " + kManifest;
    const Json json = files::parse_json(text_of(archive, kManifest, kMostManifestBytes), file);
    const JsonPlace root(json, file);
    files::check_format(root, kFormat);
    root.allow_only({"format", "version", "presets", "tags"});
    const JsonPlace list = root.entry("presets");
    if (list.size() > kMostBundledPresets)
        list.fail("there are %1 tools, more than %2.", list.size(), kMostBundledPresets);
    Manifest manifest{read_texts(list), {}};
    const auto tags = root.optional_entry("tags");
    for (std::size_t i = 0; tags && i < tags->size(); ++i)
        read_tag(tags->element(i), manifest.tags);
    return manifest;
}

Json manifest_json(const BrushBundle& bundle) {
    constexpr int kWithoutTags = 1;
    Json entries = Json::array(), tags = Json::array();
    for (std::size_t i = 0; i < bundle.presets.size(); ++i)
        entries.push_back(entry_of(i));
    for (const BundledTag& tag : bundle.tags)
        tags.push_back({{"name", tag.name}, {"tools", tag.tools}});
    Json manifest = {{"format", kFormat.name},
                     {"version", tags.empty() ? kWithoutTags : kFormat.newest},
                     {"presets", std::move(entries)}};
    if (!tags.empty()) manifest["tags"] = std::move(tags);
    return manifest;
}

}  // namespace

void write_brush_bundle(const BrushBundle& bundle, const std::filesystem::path& file) {
    PASTOSO_CHECK(bundle.presets.size() <= kMostBundledPresets);
    ZipWriter archive;
    archive.add(kManifest, manifest_json(bundle).dump(2) + "\n");
    for (std::size_t i = 0; i < bundle.presets.size(); ++i)
        archive.add(entry_of(i), brush::preset_to_json(bundle.presets[i]));
    core::write_aside(file, [&](core::OutputFile& output) { archive.write(output); });
}

BrushBundle read_brush_bundle(const std::filesystem::path& file) {
    const ZipReader archive(file);
    if (!archive.has(kManifest))
        throw core::InputError("%1: is no bundle of tools; it has no %2.", archive.name(), kManifest);
    Manifest manifest = read_manifest(archive);
    BrushBundle bundle{{}, std::move(manifest.tags)};
    std::set<std::string> names;
    for (const std::string& entry : manifest.presets) {
        const brush::Preset& preset = bundle.presets.emplace_back(brush::parse_preset(
            text_of(archive, entry, kMostPresetBytes), archive.name() + ", " + entry));
        if (!names.insert(core::lower_case(preset.name)).second)
            archive.fail(entry, "name is \"%1\", which another tool of the bundle has already.",
                         preset.name);
    }
    return bundle;
}

}  // namespace pastoso::project
