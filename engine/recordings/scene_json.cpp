#include "recordings/scene_json.hpp"

#include "core/text_file.hpp"
#include "files/bundled_files.hpp"
#include "recordings/scene_json_parts.hpp"

#include <algorithm>
#include <set>

namespace pastoso::recordings {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBundled = "scenes";  ///< the folder of resources

constexpr std::size_t kMaxFileBytes = std::size_t{16} << 20;

constexpr files::FileFormat kFormat{"pastoso-scene", core::Pattern<0>("a scene"),
                                    core::Pattern<0>("scene format"), kSceneFormatVersion};

/// Names of runs name folders.
std::string read_run_name(const files::JsonPlace& place) {
    const std::string name = place.text();
    const bool plain =
        !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](char letter) {
            return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '-';
        });
    if (!plain) place.fail("a run is named by up to 64 small letters, digits and hyphens.");
    return name;
}

/// Each run is the file without "runs", changed by the run's own entries (RFC 7386).
std::vector<SceneRun> read_runs(const files::JsonPlace& runs, const files::Json& file,
                                const SceneContext& context) {
    if (runs.size() == 0) runs.fail("at least one run is needed.");
    std::vector<SceneRun> all;
    std::set<std::string> names;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const files::JsonPlace place = runs.element(i);
        const std::string name = read_run_name(place.entry("name"));
        if (!names.insert(name).second) place.fail("there is another run \"%1\".", name);
        for (const char* key : {"format", "version", "title", "cell_units", "threads", "runs"}) {
            if (place.optional_entry(key)) place.fail("\"%1\" stands once for the whole file.", key);
        }
        files::Json merged = file, change = place.value();
        merged.erase("runs");
        change.erase("name");
        merged.merge_patch(change);
        const std::string label = runs.file() + ", run \"" + name + "\"";
        all.push_back(read_run(files::JsonPlace(merged, label), context));
        all.back().name = name;
    }
    return all;
}

/// Runs are made by copying, which would run out of stack on a file that nests without end.
void check_nesting(std::string_view text, const std::string& name) {
    constexpr int kDeepest = 32;
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char letter = text[i];
        if (quoted && letter == '\\')
            ++i;
        else if (letter == '"')
            quoted = !quoted;
        else if (!quoted && (letter == '[' || letter == '{'))
            ++depth;
        else if (!quoted && (letter == ']' || letter == '}'))
            --depth;
        if (depth > kDeepest)
            throw core::InputError("%1: lists and objects stand more than %2 deep in each other.", name,
                                   kDeepest);
    }
}

void drop_later(std::vector<double>& times, double seconds) {
    std::erase_if(times, [seconds](double time) { return time > seconds; });
}

}  // namespace

SceneFile scene_from_json(std::string_view text, const std::string& name, const fs::path& folder) {
    check_nesting(text, name);
    const files::Json json = files::parse_json(text, name);
    const files::JsonPlace root(json, name);
    files::check_format(root, kFormat);
    SceneFile file;
    if (const auto title = root.optional_entry("title")) file.title = title->text();
    file.cell_units = flag_or(root, "cell_units", false);
    if (const auto threads = root.optional_entry("threads"))
        file.threads = static_cast<int>(threads->integer(0, 256));
    const SceneContext context{{file.cell_units}, folder};
    if (const auto runs = root.optional_entry("runs"))
        file.runs = read_runs(*runs, json, context);
    else
        file.runs.push_back(read_run(root, context));
    return file;
}

std::vector<std::string> bundled_scene_names() {
    return files::bundled_names(kBundled);
}

SceneFile read_scene(const std::string& path_or_name) {
    const fs::path path = files::scene_path(path_or_name, kBundled);
    return scene_from_json(core::read_text_file(path, kMaxFileBytes), path.string(), path.parent_path());
}

void shorten(SceneRun& run, double seconds) {
    run.scene.duration_s = std::min(run.scene.duration_s, seconds);
    for (auto* times : {&run.output.pictures_at_s, &run.output.heights_at_s, &run.output.profiles_at_s})
        drop_later(*times, seconds);
    if (run.output.magnification && run.output.magnification->at_s > seconds)
        run.output.magnification.reset();
}

}  // namespace pastoso::recordings
