// Recordings of any text: refused in a sentence, or read to what is written and read again alike.
#include "core/check.hpp"
#include "core/error.hpp"
#include "recordings/recording_json.hpp"
#include "recordings/recording_text.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace pastoso::recordings {
namespace {

void try_recording(std::string_view text, Names names) {
    try {
        const document::Recording recording = recording_from_json(text, "file", names);
        const std::string again = recording_to_json(recording);
        PASTOSO_CHECK(recording_from_json(again, "written", names) == recording);
    } catch (const core::InputError& error) {
        PASTOSO_CHECK(std::string_view(error.what()).starts_with("file"));
    }
}

void try_trace(std::string_view text) {
    try {
        const PenTrace trace = parse_pen_trace(text, "file");
        PASTOSO_CHECK(!fitted(trace, 300.0, 200.0, 20.0).strokes.empty());
    } catch (const core::InputError& error) {
        PASTOSO_CHECK(std::string_view(error.what()).starts_with("file"));
    }
}

}  // namespace
}  // namespace pastoso::recordings

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace pastoso::recordings;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try_recording(text, Names::MustBeKnown);
    try_recording(text, Names::MayBeUnknown);
    try_trace(text);
    return 0;
}
