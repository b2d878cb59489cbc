#include "liquid_files/tank_json.hpp"

#include "core/text_file.hpp"
#include "files/bundled_files.hpp"
#include "files/number_table.hpp"
#include "liquid_files/mesh_import.hpp"

#include <map>
#include <utility>

namespace pastoso::liquid_files {
namespace {

using tank::Drain;
using tank::Jet;
using tank::LiquidBody;
using tank::Method;
using tank::TankScene;
using tank::Wind;

constexpr const char* kBundled = "tank";  ///< the folder of resources

struct MethodName {
    const char* name;
    Method method;
};
constexpr MethodName kMethods[] = {{"particles", Method::Particles},
                                   {"level_set", Method::LevelSet},
                                   {"upwind_level_set", Method::UpwindLevelSet},
                                   {"particle_level_set", Method::ParticleLevelSet}};

template <class Object>
struct ObjectNumber {
    const char* key;
    double Object::*value;
};
constexpr ObjectNumber<Jet> kJetTimes[] = {{"from_s", &Jet::from_s}, {"until_s", &Jet::until_s}};
constexpr ObjectNumber<Drain> kDrainTimes[] = {{"from_s", &Drain::from_s}, {"until_s", &Drain::until_s}};
constexpr ObjectNumber<Wind> kWindNumbers[] = {{"speed_m_s", &Wind::speed_m_s},
                                               {"direction_deg", &Wind::direction_deg},
                                               {"drag_per_s", &Wind::drag_per_s},
                                               {"from_s", &Wind::from_s},
                                               {"until_s", &Wind::until_s}};

constexpr files::FileFormat kFormat{"pastoso-tank", core::Pattern<0>("a scene of a glass tank"),
                                    core::Pattern<0>("tank format"), kTankFormatVersion};

Method read_method(const files::JsonPlace& place) {
    const std::string name = place.text();
    for (const MethodName& known : kMethods)
        if (name == known.name) return known.method;
    place.fail(
        R"("%1" is none of "particles", "level_set", "upwind_level_set" and "particle_level_set".)",
        name);
}

glm::ivec3 read_cells(const files::JsonPlace& place) {
    if (place.size() != 3) place.fail("expected three whole numbers, found %1.", place.size());
    glm::ivec3 cells;
    for (const int axis : {0, 1, 2})
        cells[axis] = static_cast<int>(place.element(static_cast<std::size_t>(axis))
                                           .integer(tank::kMinTankCells, tank::kMaxTankCells));
    return cells;
}

/// What a body of liquid and a jet have in common.
template <class Body>
void read_liquid(const files::JsonPlace& place, const MeshOfFile& mesh_of, Body& body) {
    body.shape = read_shape(place.entry("shape"), mesh_of);
    if (const auto velocity = place.optional_entry("velocity_m_s"))
        body.velocity_m_s = read_vector(*velocity);
    if (const auto milk = place.optional_entry("milk")) body.milk = static_cast<float>(milk->number());
}

LiquidBody read_body(const files::JsonPlace& place, const MeshOfFile& mesh_of) {
    place.allow_only({"shape", "velocity_m_s", "milk"});
    LiquidBody body;
    read_liquid(place, mesh_of, body);
    return body;
}

Jet read_jet(const files::JsonPlace& place, const MeshOfFile& mesh_of) {
    place.allow_only({"shape", "velocity_m_s", "milk", "from_s", "until_s"});
    Jet jet;
    read_liquid(place, mesh_of, jet);
    files::read_numbers(place, kJetTimes, jet);
    return jet;
}

Drain read_drain(const files::JsonPlace& place, const MeshOfFile& mesh_of) {
    place.allow_only({"shape", "from_s", "until_s"});
    Drain drain;
    drain.shape = read_shape(place.entry("shape"), mesh_of);
    files::read_numbers(place, kDrainTimes, drain);
    return drain;
}

Wind read_wind(const files::JsonPlace& place) {
    std::vector<std::string_view> keys;
    files::add_keys(keys, kWindNumbers);
    place.allow_only(keys);
    Wind wind;
    files::read_numbers(place, kWindNumbers, wind);
    return wind;
}

/// A list of whatever `read` reads; none where it is missing.
template <class Item>
void read_list(const files::JsonPlace& scene, const char* key, const MeshOfFile& mesh_of,
               Item (*read)(const files::JsonPlace&, const MeshOfFile&), std::vector<Item>& items) {
    const auto list = scene.optional_entry(key);
    for (std::size_t i = 0; list && i < list->size(); ++i)
        items.push_back(read(list->element(i), mesh_of));
}

template <class Body>
files::Json liquid_to_json(const Body& body) {
    return {{"shape", shape_to_json(body.shape)},
            {"velocity_m_s", vector_to_json(body.velocity_m_s)},
            {"milk", float_to_json(body.milk)}};
}

files::Json jet_to_json(const Jet& jet) {
    files::Json json = liquid_to_json(jet);
    files::write_numbers(json, kJetTimes, jet);
    return json;
}

files::Json drain_to_json(const Drain& drain) {
    files::Json json = {{"shape", shape_to_json(drain.shape)}};
    files::write_numbers(json, kDrainTimes, drain);
    return json;
}

template <class Item>
files::Json list_to_json(const std::vector<Item>& items, files::Json (*write)(const Item&)) {
    files::Json list = files::Json::array();
    for (const Item& item : items)
        list.push_back(write(item));
    return list;
}

}  // namespace

MeshOfFile meshes_in(const std::filesystem::path& folder) {
    std::map<std::string, std::shared_ptr<const liquid::TriangleMesh>> known;
    return [folder, known](const std::string& file) mutable {
        auto& mesh = known[file];
        if (!mesh) mesh = std::make_shared<const liquid::TriangleMesh>(import_mesh(folder / file));
        return mesh;
    };
}

TankScene tank_from_json(std::string_view text, const std::string& name, const MeshOfFile& mesh_of) {
    const files::Json json = files::parse_json(text, name);
    const files::JsonPlace place(json, name);
    files::check_format(place, kFormat);
    std::vector<std::string_view> keys = {"format",  "version", "name", "cells",  "method", "seed",
                                          "liquids", "solids",  "jets", "drains", "wind"};
    files::add_keys(keys, tank::tank_numbers());
    place.allow_only(keys);

    TankScene scene;
    if (const auto entry = place.optional_entry("name")) scene.name = entry->text();
    if (const auto entry = place.optional_entry("cells")) scene.cells = read_cells(*entry);
    if (const auto entry = place.optional_entry("method")) scene.method = read_method(*entry);
    if (const auto entry = place.optional_entry("seed"))
        scene.seed = static_cast<std::uint32_t>(entry->integer(0, UINT32_MAX));
    files::read_numbers(place, tank::tank_numbers(), scene);
    read_list(place, "liquids", mesh_of, read_body, scene.liquids);
    read_list(place, "solids", mesh_of, read_shape, scene.solids);
    read_list(place, "jets", mesh_of, read_jet, scene.jets);
    read_list(place, "drains", mesh_of, read_drain, scene.drains);
    if (const auto entry = place.optional_entry("wind")) scene.wind = read_wind(*entry);
    place.guard([&] { tank::check_tank(scene); });
    return scene;
}

std::vector<std::string> tank_method_names() {
    std::vector<std::string> names;
    for (const MethodName& known : kMethods)
        names.emplace_back(known.name);
    return names;
}

std::vector<std::string> bundled_tank_names() {
    return files::bundled_names(kBundled);
}

TankScene read_tank(const std::string& path_or_name) {
    const std::filesystem::path path = files::scene_path(path_or_name, kBundled);
    return tank_from_json(core::read_text_file(path), path.string(), meshes_in(path.parent_path()));
}

std::string tank_to_json(const TankScene& scene) {
    files::Json json = {{"format", kFormat.name},
                        {"version", kTankFormatVersion},
                        {"name", scene.name},
                        {"cells", {scene.cells.x, scene.cells.y, scene.cells.z}},
                        {"seed", scene.seed}};
    for (const MethodName& known : kMethods)
        if (known.method == scene.method) json["method"] = known.name;
    files::write_numbers(json, tank::tank_numbers(), scene);
    json["liquids"] = list_to_json<LiquidBody>(scene.liquids, liquid_to_json);
    json["solids"] = list_to_json<tank::Shape>(scene.solids, shape_to_json);
    json["jets"] = list_to_json<Jet>(scene.jets, jet_to_json);
    json["drains"] = list_to_json<Drain>(scene.drains, drain_to_json);
    files::write_numbers(json["wind"], kWindNumbers, scene.wind);
    return json.dump(2) + "\n";
}

}  // namespace pastoso::liquid_files
