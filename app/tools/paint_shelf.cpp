#include "tools/paint_shelf.hpp"

#include "core/text.hpp"
#include "document/actions/actions.hpp"
#include "recordings/paint_json.hpp"
#include "tools/memory_file.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace pastoso::tools {
namespace {

using files::Json;
using files::JsonPlace;

using Paints = std::vector<document::PaintRecipe>;

constexpr int kVersion = 1;

Json paints_json(const Paints& paints) {
    Json list = Json::array();
    for (const document::PaintRecipe& paint : paints)
        list.push_back(recordings::paint_json(paint));
    return list;
}

Paints read_paints(const JsonPlace& place, std::size_t most) {
    if (place.size() > most)
        place.fail("there are %1 paints, but only %2 have room.", place.size(), most);
    Paints paints;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace element = place.element(i);
        paints.push_back(recordings::read_paint(element));
        element.guard([&] { document::check_paint(paints.back()); });
    }
    return paints;
}

Json palette_json(const pigment::ColourPalette& palette) {
    Json colours = Json::array();
    for (const pigment::NamedColour& named : palette.colours)
        colours.push_back(Json::array({pigment::hex_colour(named.colour), named.name}));
    return {{"name", palette.name}, {"colours", std::move(colours)}};
}

pigment::NamedColour read_colour(const JsonPlace& place) {
    if (place.size() != 2)
        place.fail("expected a colour and its name, for example [\"#783c14\", \"Umber\"].");
    const std::string text = place.element(0).text();
    const auto colour = pigment::parse_hex_colour(text);
    if (!colour) place.element(0).fail("\"%1\" is not a colour such as #783c14.", text);
    return {place.element(1).text(), *colour};
}

pigment::ColourPalette read_palette(const JsonPlace& place) {
    place.allow_only({"name", "colours"});
    pigment::ColourPalette palette{place.entry("name").text(), {}};
    const JsonPlace colours = place.entry("colours");
    for (std::size_t i = 0; i < colours.size(); ++i)
        palette.colours.push_back(read_colour(colours.element(i)));
    return palette;
}

Json mixes_json(const std::vector<NamedPaint>& mixes) {
    Json list = Json::array();
    for (const NamedPaint& mix : mixes)
        list.push_back({{"name", mix.name}, {"paint", recordings::paint_json(mix.paint)}});
    return list;
}

NamedPaint read_mix(const JsonPlace& place) {
    place.allow_only({"name", "paint"});
    const JsonPlace paint = place.entry("paint");
    NamedPaint mix{place.entry("name").text(), recordings::read_paint(paint)};
    paint.guard([&] { document::check_paint(mix.paint); });
    return mix;
}

/// Two of one name are told apart by a number.
std::vector<NamedPaint> read_mixes(const JsonPlace& place) {
    if (place.size() > kMostMixes)
        place.fail("there are %1 mixes, but only %2 have room.", place.size(), kMostMixes);
    PaintShelf shelf;
    for (std::size_t i = 0; i < place.size(); ++i)
        if (!keep_mix(read_mix(place.element(i)), shelf))
            place.element(i).entry("name").fail("a mix needs a name.");
    return shelf.mixes;
}

Json puddles_json(const std::vector<document::Puddle>& puddles) {
    Json list = Json::array();
    for (const document::Puddle& puddle : puddles)
        list.push_back({{"paint", recordings::paint_json(puddle.paint)},
                        {"volume_mm3", puddle.volume_mm3},
                        {"x_mm", puddle.x_mm},
                        {"y_mm", puddle.y_mm}});
    return list;
}

/// What can be squeezed out.
document::Puddle read_puddle(const JsonPlace& place) {
    place.allow_only({"paint", "volume_mm3", "x_mm", "y_mm"});
    document::Puddle puddle{recordings::read_paint(place.entry("paint")),
                            place.entry("volume_mm3").number(), place.entry("x_mm").number(),
                            place.entry("y_mm").number()};
    place.guard([&] {
        document::check_action(
            document::SqueezePaint{puddle.paint, puddle.volume_mm3, puddle.x_mm, puddle.y_mm});
    });
    return puddle;
}

std::vector<document::Puddle> read_puddles(const JsonPlace& place) {
    if (place.size() > document::kMostPuddles)
        place.fail("there are %1 puddles, but only %2 have room.", place.size(), document::kMostPuddles);
    std::vector<document::Puddle> puddles;
    for (std::size_t i = 0; i < place.size(); ++i)
        puddles.push_back(read_puddle(place.element(i)));
    return puddles;
}

template <std::size_t kCount>
std::size_t read_name(const JsonPlace& place, const std::array<const char*, kCount>& names) {
    const std::string text = place.text();
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end())
        place.fail("\"%1\" is not one of %2.", text, core::listed({names.begin(), names.end()}));
    return static_cast<std::size_t>(found - names.begin());
}

Json aids_json(const ColourAids& aids) {
    Json json{{"harmony", kHarmonyNames.at(static_cast<std::size_t>(aids.harmony))},
              {"mask", kMaskNames.at(static_cast<std::size_t>(aids.mask.shape))},
              {"turn_deg", aids.mask.turn_deg}};
    for (const glm::dvec2& corner : aids.mask.corners)
        json["corners"].push_back({corner.x, corner.y});
    return json;
}

std::vector<glm::dvec2> read_corners(const JsonPlace& place, MaskShape shape) {
    std::vector<glm::dvec2> corners;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace corner = place.element(i);
        corners.emplace_back(corner.element(0).number(), corner.element(1).number());
    }
    if (!are_corners(corners, shape)) place.fail("these are no corners of that mask.");
    return corners;
}

ColourAids read_aids(const JsonPlace& place) {
    place.allow_only({"harmony", "mask", "turn_deg", "corners"});
    ColourAids aids;
    aids.harmony = static_cast<Harmony>(read_name(place.entry("harmony"), kHarmonyNames));
    aids.mask.shape = static_cast<MaskShape>(read_name(place.entry("mask"), kMaskNames));
    aids.mask.turn_deg = turned_deg(place.entry("turn_deg").number());
    if (const auto corners = place.optional_entry("corners"))
        aids.mask.corners = read_corners(*corners, aids.mask.shape);
    return aids;
}

bool has_mix(const PaintShelf& shelf, const std::string& name) {
    return std::any_of(shelf.mixes.begin(), shelf.mixes.end(),
                       [&](const NamedPaint& mix) { return mix.name == name; });
}

std::string free_name(const PaintShelf& shelf, const std::string& name) {
    std::string free = name;
    for (int number = 2; has_mix(shelf, free); ++number)
        free = name + ' ' + std::to_string(number);
    return free;
}

}  // namespace

void note_recent(const document::PaintRecipe& paint, PaintShelf& shelf) {
    std::erase(shelf.recent, paint);
    shelf.recent.insert(shelf.recent.begin(), paint);
    shelf.recent.resize(std::min(shelf.recent.size(), kMostRecentPaints));
}

bool keep_paint(const document::PaintRecipe& paint, PaintShelf& shelf) {
    if (std::find(shelf.kept.begin(), shelf.kept.end(), paint) != shelf.kept.end()) return true;
    if (shelf.kept.size() >= kMostKeptPaints) return false;
    shelf.kept.push_back(paint);
    return true;
}

bool keep_mix(const NamedPaint& mix, PaintShelf& shelf) {
    if (shelf.mixes.size() >= kMostMixes || core::is_blank(mix.name)) return false;
    shelf.mixes.push_back({free_name(shelf, mix.name), mix.paint});
    return true;
}

bool rename_mix(std::size_t index, const std::string& name, PaintShelf& shelf) {
    if (core::is_blank(name)) return false;
    std::string& own = shelf.mixes.at(index).name;
    own.clear();
    own = free_name(shelf, name);
    return true;
}

PaintShelf paint_set(const PaintShelf& shelf) {
    PaintShelf set;
    set.kept = shelf.kept;
    set.mixes = shelf.mixes;
    return set;
}

int add_paint_set(const PaintShelf& set, PaintShelf& shelf) {
    const std::size_t before = shelf.kept.size() + shelf.mixes.size();
    for (const document::PaintRecipe& paint : set.kept)
        keep_paint(paint, shelf);
    for (const NamedPaint& mix : set.mixes)
        if (std::find(shelf.mixes.begin(), shelf.mixes.end(), mix) == shelf.mixes.end())
            keep_mix(mix, shelf);
    return static_cast<int>(shelf.kept.size() + shelf.mixes.size() - before);
}

PaintShelf read_shelf(const std::filesystem::path& file) {
    PaintShelf shelf;
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only({"version", "recent", "kept", "mixes", "opened", "aids", "puddles"});
        shelf.recent = read_paints(root.entry("recent"), kMostRecentPaints);
        shelf.kept = read_paints(root.entry("kept"), kMostKeptPaints);
        if (const auto mixes = root.optional_entry("mixes")) shelf.mixes = read_mixes(*mixes);
        if (const auto aids = root.optional_entry("aids")) shelf.aids = read_aids(*aids);
        if (const auto puddles = root.optional_entry("puddles")) shelf.puddles = read_puddles(*puddles);
        if (const auto opened = root.optional_entry("opened")) shelf.opened = read_palette(*opened);
    });
    return shelf;
}

void write_shelf(const PaintShelf& shelf, const std::filesystem::path& file) {
    Json root{
        {"version", kVersion}, {"recent", paints_json(shelf.recent)}, {"kept", paints_json(shelf.kept)}};
    if (!shelf.mixes.empty()) root["mixes"] = mixes_json(shelf.mixes);
    if (!(shelf.aids == ColourAids{})) root["aids"] = aids_json(shelf.aids);
    if (!shelf.opened.colours.empty()) root["opened"] = palette_json(shelf.opened);
    if (!shelf.puddles.empty()) root["puddles"] = puddles_json(shelf.puddles);
    write_memory(root, file);
}

}  // namespace pastoso::tools
