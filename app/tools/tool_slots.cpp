#include "tools/tool_slots.hpp"

#include "tools/memory_file.hpp"

#include <algorithm>
#include <limits>

namespace pastoso::tools {
namespace {

using files::Json;
using files::JsonPlace;

constexpr int kVersion = 1;
constexpr std::uint32_t kMostUses = std::numeric_limits<std::int32_t>::max();

bool earlier(const ToolSlot& a, const ToolSlot& b) {
    return a.used < b.used;
}

}  // namespace

ToolSlots first_tool_slots() {
    constexpr std::array<const char*, kToolSlots> kTools = {
        "Flat bristle 20", "Filbert 14", "Round sable 9",    "Rigger 2", "Fan 26",
        "Mop 30",          "Rag 35",     "Palette knife 17", "Dropper",  "Spray can 35"};
    ToolSlots slots;
    for (std::size_t i = 0; i < kToolSlots; ++i)
        slots[i].tool = kTools[i];
    return slots;
}

/// Of several that were not used yet the last one goes first.
void note_use(const std::string& tool, ToolSlots& slots) {
    const auto has_it = [&](const ToolSlot& slot) { return slot.tool == tool; };
    const std::uint32_t latest = std::max_element(slots.begin(), slots.end(), earlier)->used;
    auto found = std::find_if(slots.begin(), slots.end(), has_it);
    if (found == slots.end()) found = std::min_element(slots.rbegin(), slots.rend(), earlier).base() - 1;
    *found = {tool, std::min(latest + 1, kMostUses)};
}

ToolSlots read_tool_slots(const std::filesystem::path& file) {
    ToolSlots slots = first_tool_slots();
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only({"version", "tools"});
        const JsonPlace tools = root.entry("tools");
        if (tools.size() != kToolSlots)
            tools.fail("there are %1 tools instead of %2.", tools.size(), kToolSlots);
        for (std::size_t i = 0; i < kToolSlots; ++i) {
            const JsonPlace slot = tools.element(i);
            slot.allow_only({"tool", "used"});
            slots[i] = {slot.entry("tool").text(),
                        static_cast<std::uint32_t>(slot.entry("used").integer(0, kMostUses))};
        }
    });
    return slots;
}

void write_tool_slots(const ToolSlots& slots, const std::filesystem::path& file) {
    Json tools = Json::array();
    for (const ToolSlot& slot : slots)
        tools.push_back({{"tool", slot.tool}, {"used", slot.used}});
    write_memory({{"version", kVersion}, {"tools", std::move(tools)}}, file);
}

}  // namespace pastoso::tools
