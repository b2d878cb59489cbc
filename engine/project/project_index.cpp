#include "project/project_index.hpp"

#include "core/number_text.hpp"
#include "files/json_place.hpp"
#include "project/project_layout.hpp"
#include "recordings/action_json.hpp"
#include "recordings/consistency_record.hpp"
#include "recordings/surface_json.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <set>

namespace pastoso::project {
namespace {

using files::Json;
using files::JsonPlace;
using recordings::consistencies_json;
using recordings::held_media_json;
using recordings::kMostPaint;
using recordings::largest_count;
using recordings::packed_json;
using recordings::read_consistencies;
using recordings::read_held_media;
using recordings::read_packed;
using recordings::read_surface;
using recordings::read_totals;
using recordings::surface_json;
using recordings::totals_json;

constexpr std::int64_t kMostCounted = std::numeric_limits<std::int64_t>::max();
constexpr double kMostPaint_mm3 = 1e18;

std::uint64_t read_hex(const JsonPlace& place) {
    const std::string text = place.text();
    std::uint64_t value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    if (text.size() != 16 || fault != std::errc() || end != text.data() + text.size())
        place.fail("expected sixteen hexadecimal digits.");
    return value;
}

PackedEntry read_packed_alone(const JsonPlace& place, std::size_t most_bytes) {
    place.allow_only({"entry", "size", "packed"});
    return read_packed(place, most_bytes);
}

Json contents_json(const brush::Contents& contents) {
    return {{"volume_mm3", contents.volume_mm3}, {"channels", contents.paint}};
}
double read_amount(const JsonPlace& place) {
    const double amount = place.number();
    if (!(std::abs(amount) <= kMostPaint_mm3)) place.fail("expected an amount of paint up to 1e18.");
    return amount;
}

brush::Contents read_contents(const JsonPlace& place) {
    place.allow_only({"volume_mm3", "channels"});
    brush::Contents contents{.volume_mm3 = read_amount(place.entry("volume_mm3"))};
    const JsonPlace list = place.entry("channels");
    if (list.size() != contents.paint.size()) list.fail("expected %1 numbers.", contents.paint.size());
    for (std::size_t k = 0; k < contents.paint.size(); ++k)
        contents.paint[k] = read_amount(list.element(k));
    return contents;
}

/// What a layer or a group is called and how it shows, beside what else there is of it.
Json with_look(Json json, const document::LayerLook& look) {
    json.update(recordings::look_json(look));
    return json;
}

std::uint32_t read_number(const JsonPlace& place) {
    return static_cast<std::uint32_t>(place.integer(0, UINT32_MAX));
}

Json layer_json(const LayerIndex& layer) {
    Json json{
        {"id", layer.layer.id}, {"picture", layer.picture}, {"surface", surface_json(layer.surface)}};
    if (layer.layer.group != 0) json["group"] = layer.layer.group;
    if (layer.bare_support_checksum)
        json["bare_support_checksum"] = core::hex_text(*layer.bare_support_checksum);
    return with_look(std::move(json), layer.layer.look);
}

LayerIndex read_layer(const JsonPlace& place) {
    place.allow_only({"id", "group", "name", "visible", "locked", "bare_locked", "clipped", "opacity",
                      "picture", "surface", "bare_support_checksum"});
    LayerIndex layer{{.id = 1, .look = recordings::read_look(place)},
                     place.entry("picture").text(),
                     read_surface(place.entry("surface")),
                     {}};
    if (const auto id = place.optional_entry("id")) layer.layer.id = read_number(*id);
    if (const auto group = place.optional_entry("group")) layer.layer.group = read_number(*group);
    if (const auto left_out = place.optional_entry("bare_support_checksum"))
        layer.bare_support_checksum = read_hex(*left_out);
    return layer;
}

document::LayerGroup read_group(const JsonPlace& place) {
    place.allow_only({"id", "name", "visible", "locked", "bare_locked", "opacity"});
    return {read_number(place.entry("id")), recordings::read_look(place)};
}

Json stack_json(const ProjectIndex& index) {
    Json json{{"active", index.active_layer},
              {"next_layer", index.next_layer},
              {"next_group", index.next_group},
              {"groups", Json::array()}};
    for (const document::LayerGroup& group : index.groups)
        json["groups"].push_back(with_look(Json{{"id", group.id}}, group.look));
    return json;
}

void read_stack(const JsonPlace& place, ProjectIndex& index) {
    place.allow_only({"active", "next_layer", "next_group", "groups"});
    index.active_layer = read_number(place.entry("active"));
    index.next_layer = read_number(place.entry("next_layer"));
    index.next_group = read_number(place.entry("next_group"));
    const JsonPlace groups = place.entry("groups");
    for (std::size_t i = 0; i < groups.size(); ++i)
        index.groups.push_back(read_group(groups.element(i)));
}

/// Version 1 has no stack: one layer, which is active.
void read_layers(const JsonPlace& root, ProjectIndex& index) {
    const JsonPlace layers = root.entry("layers");
    if (layers.size() < 1 || layers.size() > document::kMostLayers)
        layers.fail("expected 1 to %1 layers.", document::kMostLayers);
    for (std::size_t i = 0; i < layers.size(); ++i)
        index.layers.push_back(read_layer(layers.element(i)));
    if (const auto stack = root.optional_entry("stack")) read_stack(*stack, index);
    layers.guard([&] { document::check_stack(stack_of(index)); });
}

const char* form_name(film::SupportForm form) {
    return form == film::SupportForm::Levels ? "levels" : "fine";
}

/// Versions 1 and 2 know one form.
film::SupportForm read_form(const std::optional<JsonPlace>& place) {
    if (!place || place->text() == "fine") return film::SupportForm::Fine;
    if (place->text() != "levels") place->fail("expected \"levels\" or \"fine\".");
    return film::SupportForm::Levels;
}

Json ageing_json(const film::AgeingClock::Pending& ageing) {
    return {{"drying_s", ageing.drying_s},
            {"drying_ticks", ageing.drying_ticks},
            {"dissolving_s", ageing.dissolving_s}};
}

double read_seconds(const JsonPlace& place) {
    constexpr double kMost_s = 1e6;
    const double seconds = place.number();
    if (!(seconds >= 0.0 && seconds <= kMost_s)) place.fail("expected 0 to a million seconds.");
    return seconds;
}

film::AgeingClock::Pending read_ageing(const JsonPlace& place) {
    place.allow_only({"drying_s", "drying_ticks", "dissolving_s"});
    constexpr int kMostTicks = std::numeric_limits<int>::max() / 2;
    return {read_seconds(place.entry("drying_s")),
            static_cast<int>(place.entry("drying_ticks").integer(0, kMostTicks)),
            read_seconds(place.entry("dissolving_s"))};
}

brush::Gathering read_gathering(const JsonPlace& place) {
    brush::Gathering gathering;
    if (const auto number = place.optional_entry("gatherings"))
        gathering.number = static_cast<std::uint32_t>(number->integer(0, UINT32_MAX));
    if (const auto worn = place.optional_entry("worn_mm")) {
        gathering.worn_mm = worn->number();
        if (!(gathering.worn_mm >= 0.0)) worn->fail("expected 0 or more.");
    }
    return gathering;
}

Json brush_json(const BrushIndex& brush) {
    return {{"strokes_begun", brush.strokes_begun},
            {"gatherings", brush.gathering.number},
            {"worn_mm", brush.gathering.worn_mm},
            {"consistency", consistencies_json(brush.consistencies.value())},
            {"media", held_media_json(brush.media.value())},
            {"held", packed_json(brush.held)}};
}

BrushIndex read_brush(const JsonPlace& place) {
    place.allow_only({"strokes_begun", "gatherings", "worn_mm", "consistency", "media", "held"});
    constexpr std::size_t kMostBristles = 2000;
    BrushIndex brush{static_cast<std::uint32_t>(place.entry("strokes_begun").integer(0, UINT32_MAX)),
                     read_gathering(place),
                     {},
                     {},
                     read_packed_alone(place.entry("held"), kMostBristles * sizeof(brush::Contents))};
    if (const auto told = place.optional_entry("consistency"))
        brush.consistencies = read_consistencies(*told);
    if (const auto media = place.optional_entry("media")) brush.media = read_held_media(*media);
    return brush;
}

Json references_json(const ProjectIndex& index) {
    Json pictures = Json::array();
    for (const ReferenceIndex& reference : index.references)
        pictures.push_back(
            {{"name", reference.name}, {"place", recordings::set_reference_json(reference.set)}});
    return {{"next", index.next_reference}, {"pictures", std::move(pictures)}};
}

ReferenceIndex read_reference(const JsonPlace& place, document::ReferenceId next) {
    place.allow_only({"name", "place"});
    ReferenceIndex reference{place.entry("name").text(),
                             recordings::read_set_reference(place.entry("place"))};
    if (reference.name.size() > document::kMostReferenceName)
        place.entry("name").fail("the name of a reference has %1 bytes, but at most %2 are kept.",
                                 reference.name.size(), document::kMostReferenceName);
    place.entry("place").guard([&] { document::check_action(reference.set); });
    if (reference.set.reference >= next)
        place.entry("place").fail("the number %1 has not been given yet.", reference.set.reference);
    return reference;
}

void read_references(const JsonPlace& place, ProjectIndex& index) {
    place.allow_only({"next", "pictures"});
    index.next_reference = read_number(place.entry("next"));
    const JsonPlace pictures = place.entry("pictures");
    if (pictures.size() > document::kMostReferences)
        pictures.fail("expected at most %1 references.", document::kMostReferences);
    std::set<document::ReferenceId> numbers;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        index.references.push_back(read_reference(pictures.element(i), index.next_reference));
        if (!numbers.insert(index.references.back().set.reference).second)
            pictures.element(i).fail("there are two references %1.",
                                     index.references.back().set.reference);
    }
}

/// Each count fits; their sum over all layers must, too.
void check_sums(const JsonPlace& root, const ProjectIndex& index) {
    double sum = index.well ? largest_count(*index.well) : 0.0;
    if (index.copied) sum += largest_count(*index.copied);
    for (const LayerIndex& layer : index.layers)
        sum += largest_count(layer.surface);
    if (sum > static_cast<double>(kMostPaint))
        root.entry("layers").fail("their paint adds up to more than any canvas holds.");
}

void check_header(const JsonPlace& root) {
    const auto format = root.optional_entry("format");
    if (!format || format->text() != "pastoso-project")
        root.fail(
            "this is no painting of Pastoso; it would begin with \"format\": \"pastoso-project\".");
    const std::int64_t version = root.entry("version").integer(1, INT32_MAX);
    if (version > kProjectFormatVersion) {
        root.fail(
            "this was written by a newer Pastoso (project format %1; this program reads up to %2).",
            version, kProjectFormatVersion);
    }
    root.allow_only({"format",  "version",      "program", "tick",         "ageing",
                     "account", "layers",       "stack",   "bare_support", "support_form",
                     "well",    "copied",       "brush",   "brush_aside",  "selection",
                     "masking", "masking_tape", "tracing", "references",   "strokes"});
}

}  // namespace

std::string reference_entry(document::ReferenceId reference) {
    return kReferenceFolder + std::to_string(reference) + ".png";
}

document::LayerStack stack_of(const ProjectIndex& index) {
    document::LayerStack stack{.layers = {},
                               .groups = index.groups,
                               .active = index.active_layer,
                               .next_layer = index.next_layer,
                               .next_group = index.next_group};
    for (const LayerIndex& layer : index.layers)
        stack.layers.push_back(layer.layer);
    return stack;
}

std::string index_to_json(const ProjectIndex& index) {
    Json layers = Json::array();
    for (const LayerIndex& layer : index.layers)
        layers.push_back(layer_json(layer));
    Json json{{"format", "pastoso-project"},
              {"version", kProjectFormatVersion},
              {"program", index.program},
              {"tick", index.tick},
              {"ageing", ageing_json(index.ageing)},
              {"account",
               {{"taken", contents_json(index.flows.taken)},
                {"wiped", contents_json(index.flows.wiped)},
                {"forgotten_run_off", totals_json(index.flows.forgotten_run_off)}}},
              {"layers", std::move(layers)},
              {"stack", stack_json(index)}};
    if (index.bare_support) json["bare_support"] = surface_json(*index.bare_support);
    if (!index.bare_support) json["support_form"] = form_name(index.support_form);
    if (index.well) json["well"] = surface_json(*index.well);
    if (index.copied) json["copied"] = surface_json(*index.copied);
    if (index.brush) json["brush"] = brush_json(*index.brush);
    if (index.brush_aside) json["brush_aside"] = brush_json(*index.brush_aside);
    if (index.selection) json["selection"] = packed_json(*index.selection);
    if (index.masking) json["masking"] = packed_json(*index.masking);
    if (index.masking_tape) json["masking_tape"] = packed_json(*index.masking_tape);
    if (index.tracing) json["tracing"] = recordings::set_tracing_json(*index.tracing);
    if (index.next_reference > 1) json["references"] = references_json(index);
    json["strokes"] = packed_json(index.strokes);
    // Names of files need not be UTF-8.
    return json.dump(-1, ' ', false, files::Json::error_handler_t::replace) + "\n";
}

ProjectIndex index_from_json(const std::string& text, const std::string& name) {
    const Json json = files::parse_json(text, name);
    const JsonPlace root(json, name);
    check_header(root);
    ProjectIndex index;
    index.program = root.entry("program").text();
    index.tick = root.entry("tick").integer(0, kMostCounted / 2);
    index.ageing = read_ageing(root.entry("ageing"));
    const JsonPlace account = root.entry("account");
    account.allow_only({"taken", "wiped", "forgotten_run_off"});
    index.flows.taken = read_contents(account.entry("taken"));
    index.flows.wiped = read_contents(account.entry("wiped"));
    index.flows.forgotten_run_off = read_totals(account.entry("forgotten_run_off"));
    read_layers(root, index);
    if (const auto bare = root.optional_entry("bare_support")) index.bare_support = read_surface(*bare);
    index.support_form = read_form(root.optional_entry("support_form"));
    if (const auto well = root.optional_entry("well")) index.well = read_surface(*well);
    if (const auto copied = root.optional_entry("copied")) index.copied = read_surface(*copied);
    if (const auto brush = root.optional_entry("brush")) index.brush = read_brush(*brush);
    if (const auto brush = root.optional_entry("brush_aside")) index.brush_aside = read_brush(*brush);
    if (const auto selection = root.optional_entry("selection"))
        index.selection = read_packed_alone(*selection, kMostMaskBytes);
    if (const auto masking = root.optional_entry("masking"))
        index.masking = read_packed_alone(*masking, kMostMaskBytes);
    if (const auto tape = root.optional_entry("masking_tape"))
        index.masking_tape = read_packed_alone(*tape, kMostMaskBytes);
    if (const auto tracing = root.optional_entry("tracing")) {
        index.tracing = recordings::read_set_tracing(*tracing);
        tracing->guard([&] { document::check_action(*index.tracing); });
    }
    if (const auto references = root.optional_entry("references")) read_references(*references, index);
    index.strokes = read_packed_alone(root.entry("strokes"), kMostStrokesBytes);
    check_sums(root, index);
    return index;
}

}  // namespace pastoso::project
