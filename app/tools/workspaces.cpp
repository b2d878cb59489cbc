#include "tools/workspaces.hpp"

#include "core/check.hpp"
#include "tools/memory_file.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::tools {
namespace {

using files::Json;
using files::JsonPlace;

constexpr int kVersion = 1;

/// As wide as its names need in every language; the well needs room to mix in.
constexpr int kToolsBreadth_px = 252, kWellBreadth_px = 380;

PanelArrangement arrangement(PanelSide left, PanelSide right) {
    return {.sides = {std::move(left), std::move(right), PanelSide{}, PanelSide{}}, .floating = {}};
}

PanelTabs alone(const char* panel, int length_px) {
    return {.panels = {panel}, .raised = 0, .length_px = length_px};
}

PanelArrangement sketch() {
    return arrangement({.tabs = {alone("brushes_panel", 400), alone("paints_panel", 200)},
                        .breadth_px = kToolsBreadth_px},
                       {});
}

/// On a screen 800 pixels high six tools, twelve tubes and all of the easel are seen.
std::vector<PanelTabs> tools_paints_and_easel() {
    return {alone("brushes_panel", 378), alone("paints_panel", 141), alone("easel_panel", 171)};
}

/// The tool, its colour and its paint need more than a few layers do.
PanelArrangement oil() {
    return arrangement(
        {.tabs = tools_paints_and_easel(), .breadth_px = kToolsBreadth_px},
        {.tabs = {{.panels = {"tool_panel", "colour_panel", "physics_panel", "light_panel"},
                   .raised = 0,
                   .length_px = 500},
                  {.panels = {"layers_panel", "history_panel", "navigator_panel"},
                   .raised = 0,
                   .length_px = 300}}});
}

PanelArrangement at_home() {
    return arrangement(
        {.tabs = tools_paints_and_easel()},
        {.tabs = {
             alone("well_panel", 400),
             {.panels = {"tool_panel", "colour_panel", "physics_panel", "guides_panel", "light_panel"}},
             {.panels = {"layers_panel", "tracing_panel", "references_panel", "history_panel",
                         "navigator_panel", "recorder_panel", "messages_panel"}}}});
}

PanelArrangement mixing() {
    return arrangement({.tabs = {alone("brushes_panel", 300), alone("paints_panel", 300)},
                        .breadth_px = kToolsBreadth_px},
                       {.tabs = {alone("well_panel", 400),
                                 {.panels = {"colour_panel", "physics_panel", "tool_panel"},
                                  .raised = 0,
                                  .length_px = 300}},
                        .breadth_px = kWellBreadth_px});
}

PanelArrangement finishing() {
    return arrangement(
        {}, {.tabs = {{.panels = {"light_panel", "navigator_panel"}, .raised = 0, .length_px = 400},
                      {.panels = {"layers_panel", "recorder_panel", "history_panel"},
                       .raised = 0,
                       .length_px = 400}}});
}

constexpr const char* kNames[] = {"sketch", "oil", "mixing", "export"};

Workspace read_shipped(const JsonPlace& place) {
    const std::string text = place.text();
    const auto found =
        std::ranges::find(kNames, text, [](const char* name) { return std::string(name); });
    if (found == std::end(kNames))
        place.fail("\"%1\" is not one of %2.", text, "sketch, oil, mixing, export");
    return static_cast<Workspace>(found - std::begin(kNames));
}

/// {"shipped": "oil"}, {"own": "Portraits"} or {}
Json in_use_json(const Workspaces& workspaces) {
    Json json = Json::object();
    if (!workspaces.in_use.empty())
        json["own"] = workspaces.in_use;
    else if (workspaces.shipped)
        json["shipped"] = kNames[static_cast<std::size_t>(*workspaces.shipped)];
    return json;
}

void read_in_use(const JsonPlace& place, Workspaces& workspaces) {
    place.allow_only({"own", "shipped"});
    workspaces.shipped.reset();
    if (const auto shipped = place.optional_entry("shipped"))
        workspaces.shipped = read_shipped(*shipped);
    const auto own = place.optional_entry("own");
    if (!own) return;
    const OwnWorkspace* found = find_own(workspaces, own->text());
    if (found == nullptr) own->fail("there is no \"%1\".", own->text());
    use(*found, workspaces);
}

OwnWorkspace read_own(const JsonPlace& place) {
    place.allow_only({"name", "panels"});
    return {place.entry("name").text(), read_arrangement(place.entry("panels"))};
}

OwnWorkspace& own_in_use(Workspaces& workspaces) {
    const auto found = std::ranges::find(workspaces.own, workspaces.in_use, &OwnWorkspace::name);
    PASTOSO_CHECK(found != workspaces.own.end());
    return *found;
}

}  // namespace

const PanelArrangement& arrangement_of(Workspace workspace) {
    static const std::array kShipped = {sketch(), oil(), mixing(), finishing()};
    return kShipped[static_cast<std::size_t>(workspace)];
}

const PanelArrangement& panels_at_home() {
    static const PanelArrangement kHome = at_home();
    return kHome;
}

const OwnWorkspace* find_own(const Workspaces& workspaces, const std::string& name) {
    const auto found = std::ranges::find(workspaces.own, name, &OwnWorkspace::name);
    return found == workspaces.own.end() ? nullptr : &*found;
}

const PanelArrangement& arrangement_in_use(const Workspaces& workspaces) {
    const OwnWorkspace* own = find_own(workspaces, workspaces.in_use);
    return own != nullptr ? own->panels : arrangement_of(workspaces.shipped.value_or(Workspace::Oil));
}

void use(Workspace shipped, Workspaces& workspaces) {
    workspaces.shipped = shipped;
    workspaces.in_use.clear();
}

void use(const OwnWorkspace& own, Workspaces& workspaces) {
    workspaces.shipped.reset();
    workspaces.in_use = own.name;
}

void keep(const std::string& name, PanelArrangement panels, Workspaces& workspaces) {
    std::erase_if(workspaces.own, [&name](const OwnWorkspace& own) { return own.name == name; });
    workspaces.own.push_back({name, std::move(panels)});
    use(workspaces.own.back(), workspaces);
}

void rename_in_use(const std::string& name, Workspaces& workspaces) {
    PanelArrangement panels = own_in_use(workspaces).panels;
    if (name != workspaces.in_use) remove_in_use(workspaces);
    keep(name, std::move(panels), workspaces);
}

void remove_in_use(Workspaces& workspaces) {
    const std::string name = own_in_use(workspaces).name;
    std::erase_if(workspaces.own, [&name](const OwnWorkspace& own) { return own.name == name; });
    workspaces.in_use.clear();
}

Workspaces read_workspaces(const std::filesystem::path& file) {
    Workspaces workspaces;
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only({"version", "left_handed", "in_use", "own"});
        workspaces.left_handed = root.entry("left_handed").boolean();
        const JsonPlace own = root.entry("own");
        for (std::size_t i = 0; i < own.size(); ++i) {
            OwnWorkspace read = read_own(own.element(i));
            if (find_own(workspaces, read.name) != nullptr)
                own.element(i).entry("name").fail("\"%1\" is there twice.", read.name);
            workspaces.own.push_back(std::move(read));
        }
        read_in_use(root.entry("in_use"), workspaces);
    });
    return workspaces;
}

void write_workspaces(const Workspaces& workspaces, const std::filesystem::path& file) {
    Json own = Json::array();
    for (const OwnWorkspace& one : workspaces.own)
        own.push_back({{"name", one.name}, {"panels", arrangement_json(one.panels)}});
    write_memory({{"version", kVersion},
                  {"left_handed", workspaces.left_handed},
                  {"in_use", in_use_json(workspaces)},
                  {"own", std::move(own)}},
                 file);
}

}  // namespace pastoso::tools
