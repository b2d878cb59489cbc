// Writes the example recordings anew: pastoso-make-examples FOLDER.
#include "core/error.hpp"
#include "recordings/recording_json.hpp"
#include "scenes.hpp"

#include <cstdio>
#include <filesystem>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: pastoso-make-examples FOLDER\n", stderr);
        return 2;
    }
    try {
        const std::filesystem::path folder = argv[1];
        pastoso::recordings::write_recording_json(folder / "evening.json",
                                                  pastoso::examples::evening_by_a_river());
        pastoso::recordings::write_recording_json(folder / "palette.json", pastoso::examples::palette());
        pastoso::recordings::write_recording_json(folder / "poppies.json", pastoso::examples::poppies());
        pastoso::recordings::write_recording_json(folder / "sampler.json", pastoso::examples::sampler());
        pastoso::recordings::write_recording_json(folder / "sheet.json", pastoso::examples::sheet());
        pastoso::recordings::write_recording_json(folder / "still-life.json",
                                                  pastoso::examples::still_life());
        pastoso::recordings::write_recording_json(folder / "surf.json", pastoso::examples::surf());
    } catch (const pastoso::core::InputError& error) {
        std::fprintf(stderr, "pastoso-make-examples: %s\n", error.what());
        return 1;
    }
    return 0;
}
