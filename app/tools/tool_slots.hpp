// The tools around the pop-up palette: each has its place for as long as it is used.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

namespace pastoso::tools {

inline constexpr std::size_t kToolSlots = 10;

struct ToolSlot {
    std::string tool;        ///< its name
    std::uint32_t used = 0;  ///< the higher the later; 0: not yet
    friend bool operator==(const ToolSlot&, const ToolSlot&) = default;
};

using ToolSlots = std::array<ToolSlot, kToolSlots>;

/// A few of every kind, for a painter who has used none.
ToolSlots first_tool_slots();

/// The tool is in use: it stays where it is, or takes the place of the one that was not used for the
/// longest time.
void note_use(const std::string& tool, ToolSlots& slots);

/// The first ones where there is no such file. Throws InputError that names the file and the place in it
/// for anything malformed.
ToolSlots read_tool_slots(const std::filesystem::path& file);

/// Written aside, its folder made where there is none. Throws InputError where that cannot be written.
void write_tool_slots(const ToolSlots& slots, const std::filesystem::path& file);

}  // namespace pastoso::tools
