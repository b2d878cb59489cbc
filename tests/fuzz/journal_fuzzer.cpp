// Journals of any bytes: refused in a sentence, or read to runs of actions that are in order. The first
// byte chooses whether the rest is a whole file, or the content of a frame, whose checksum stops the
// fuzzer otherwise.
#include "core/check.hpp"
#include "core/error.hpp"
#include "journal/frames.hpp"
#include "journal/journal_file.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace pastoso::journal {
namespace {

constexpr std::uint8_t kKinds = 6;

void check_order(const Run& run) {
    std::int64_t tick = 0;
    for (const document::Event& event : run.recording.events) {
        PASTOSO_CHECK_OP(event.tick, >=, tick);
        tick = event.tick;
    }
    PASTOSO_CHECK_OP(run.recording.end_tick, >=, tick);
}

void try_journal(const std::string& file) {
    try {
        const JournalContent content = parse_journal(std::as_bytes(std::span(file)), "file");
        for (const Run& run : content.runs)
            check_order(run);
    } catch (const core::InputError& error) {
        PASTOSO_CHECK(std::string_view(error.what()).starts_with("file"));
    }
}

}  // namespace
}  // namespace pastoso::journal

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace pastoso::journal;
    if (size == 0) return 0;
    const std::string rest(reinterpret_cast<const char*>(data + 1), size - 1);
    const std::uint8_t kind = data[0] % kKinds;
    if (kind == 0 || rest.size() > kMostFrameBytes) {
        try_journal(rest);
        return 0;
    }
    const std::string frame = framed(static_cast<FrameKind>(kind), rest);
    try_journal(frame + frame);
    return 0;
}
