#include "tools/paint_shelf.hpp"

#include "document/actions/actions.hpp"
#include "recordings/paint_json.hpp"
#include "tools/memory_file.hpp"

#include <algorithm>
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

PaintShelf read_shelf(const std::filesystem::path& file) {
    PaintShelf shelf;
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only({"version", "recent", "kept", "opened"});
        shelf.recent = read_paints(root.entry("recent"), kMostRecentPaints);
        shelf.kept = read_paints(root.entry("kept"), kMostKeptPaints);
        if (const auto opened = root.optional_entry("opened")) shelf.opened = read_palette(*opened);
    });
    return shelf;
}

void write_shelf(const PaintShelf& shelf, const std::filesystem::path& file) {
    Json root{
        {"version", kVersion}, {"recent", paints_json(shelf.recent)}, {"kept", paints_json(shelf.kept)}};
    if (!shelf.opened.colours.empty()) root["opened"] = palette_json(shelf.opened);
    write_memory(root, file);
}

}  // namespace pastoso::tools
