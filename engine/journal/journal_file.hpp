// What a journal's file says: the painting's actions as they came, and where a replay may begin.
#pragma once

#include "document/events.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pastoso::journal {

inline constexpr int kJournalFormatVersion = 1;
inline constexpr const char* kStrokesFile = "strokes.journal";

/// How the journal began.
struct Header {
    std::string program{};   ///< the version that wrote it
    std::string painting{};  ///< path of the project file that was opened; empty: a new painting
    std::string start{};     ///< project in the journal's folder; empty: the bare canvas at tick 0
    std::int64_t start_tick = 0;
    bool start_is_saved = true;  ///< nothing would be lost with what is there at the start
};

/// Actions one after the other without a gap. Actions are counted from the journal's beginning.
struct Run {
    std::uint64_t first_event = 0;
    document::Recording recording;
    std::size_t last_frame_at = 0;  ///< in the file

    std::uint64_t end_event() const { return first_event + recording.events.size(); }
};

/// The painting after so many actions, whole in a project file in the journal's folder.
struct Checkpoint {
    std::string file{};
    std::uint64_t events = 0;
    std::int64_t tick = 0;
};

/// The painting after so many actions, saved by the painter.
struct Saved {
    std::string path{};
    std::uint64_t events = 0;
};

struct JournalContent {
    std::optional<Header> header;
    std::vector<Run> runs;  ///< in order; more than one where frames are damaged
    std::vector<Checkpoint> checkpoints;
    std::optional<Saved> saved;             ///< the latest
    std::optional<std::size_t> damaged_at;  ///< in the file
};

/// The frames' bytes. A batch follows `first_event` actions; ticks are counted from `first_tick`, which
/// keeps them small however old the painting is.
std::string header_frame(const Header& header);
std::string strokes_frame(std::uint64_t first_event, std::int64_t first_tick,
                          const document::Recording& batch);
std::string checkpoint_frame(const Checkpoint& checkpoint);
std::string saved_frame(const Saved& saved);

/// Reads what is whole. Throws InputError "NAME, byte N: ..." when a newer version wrote it or a whole
/// frame says what none can, and "NAME: ..." when there is no frame at all.
JournalContent parse_journal(std::span<const std::byte> file, const std::string& name);

}  // namespace pastoso::journal
