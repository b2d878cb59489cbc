// pastoso/index.json: what a project file holds, and where.
#pragma once

#include "document/actions/picture_actions.hpp"
#include "document/actions/reference_actions.hpp"
#include "document/painting_state.hpp"
#include "film/support/support.hpp"
#include "recordings/surface_index.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::project {

inline constexpr int kProjectFormatVersion = 13;

using recordings::PackedEntry;
using recordings::SurfaceIndex;
using recordings::TileEntry;

struct LayerIndex {
    document::Layer layer;  ///< without its film
    std::string picture;    ///< of the OpenRaster layer
    SurfaceIndex surface;
    /// Of the support's tiles that are left out, because its name tells what they are.
    std::optional<std::uint64_t> bare_support_checksum;
};

struct BrushIndex {
    std::uint32_t strokes_begun = 0;
    brush::Gathering gathering{};                        ///< none in formats before 6
    std::optional<film::Consistencies> consistencies{};  ///< formats before 5 do not tell
    std::optional<brush::HeldMedia> media{};             ///< formats before 9 do not tell
    PackedEntry held;
};

/// A reference but for its picture, which is an entry of its own (reference_entry()).
struct ReferenceIndex {
    std::string name;
    document::SetReference set;
};

struct ProjectIndex {
    std::string program;  ///< that wrote it
    std::int64_t tick = 0;
    film::AgeingClock::Pending ageing{};
    document::PaintFlows flows{};
    std::vector<LayerIndex> layers{};  ///< from below; version 1 has one
    std::vector<document::LayerGroup> groups{};
    std::size_t active_layer = 0;
    document::LayerId next_layer = 2;
    document::GroupId next_group = 1;
    std::optional<SurfaceIndex> bare_support{};                  ///< where no name tells what it is
    film::SupportForm support_form = film::SupportForm::Levels;  ///< where a name tells it
    std::optional<SurfaceIndex> well{};
    std::optional<SurfaceIndex> copied{};  ///< of any shape; none in formats before 11
    std::optional<BrushIndex> brush{};
    std::optional<BrushIndex> brush_aside{};  ///< none in formats before 10
    std::optional<PackedEntry> selection{};
    std::optional<PackedEntry> masking{};           ///< none in formats before 12
    std::optional<PackedEntry> masking_tape{};      ///< of them; none in formats before 13
    std::optional<document::SetTracing> tracing{};  ///< where its picture lies in an entry of its own
    std::vector<ReferenceIndex> references{};       ///< from below; none in formats before 12
    document::ReferenceId next_reference = 1;
    PackedEntry strokes{};
};

std::string reference_entry(document::ReferenceId reference);

/// The layers of an index as a stack without films.
document::LayerStack stack_of(const ProjectIndex& index);

std::string index_to_json(const ProjectIndex& index);

/// Reads the same. `name` stands for the index in errors. Throws InputError with the place for anything
/// malformed, out of range, unknown, written by a newer version, or larger than its tiles can be.
ProjectIndex index_from_json(const std::string& text, const std::string& name);

}  // namespace pastoso::project
