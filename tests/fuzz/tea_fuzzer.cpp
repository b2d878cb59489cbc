// Scenes of milk tea of any text: refused in a sentence, or read to what is written and read again
// alike.
#include "core/check.hpp"
#include "core/error.hpp"
#include "liquid_files/tea_json.hpp"

#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace pastoso;
    try {
        const liquid::TeaSettings settings =
            liquid_files::tea_from_json({reinterpret_cast<const char*>(data), size}, "file");
        PASTOSO_CHECK(liquid_files::tea_from_json(liquid_files::tea_to_json(settings), "written") ==
                      settings);
    } catch (const core::InputError& error) {
        PASTOSO_CHECK(std::string_view(error.what()).starts_with("file"));
    }
    return 0;
}
