#include "faults/writers.hpp"

#include "cli/run_program.hpp"
#include "core/text_file.hpp"

#include <stdexcept>

namespace pastoso::faults {
namespace {

Writer exported(const std::string& name, const std::string& output, const std::vector<std::string>& more = {}) {
    Writer writer{name, {"export", "IN/small.pastoso", "-o", "OUT/" + output, "-q"}};
    writer.arguments.insert(writer.arguments.end(), more.begin(), more.end());
    return writer;
}

std::vector<Writer> all_exports() {
    std::vector<Writer> exports = {exported("LayersExr", "a.exr", {"--layers"}),
                                   exported("DeepTiff", "a.tif", {"--depth", "32"})};
    for (const std::string format : {"png", "jpg", "tif", "webp", "exr", "stl", "ply", "obj"})
        exports.push_back(exported("Export_" + format, "a." + format));
    for (const std::string format : {"png", "tif", "exr"})
        exports.push_back(exported("Maps_" + format, "a." + format, {"--maps"}));
    return exports;
}

std::vector<Writer> all_frames() {
    std::vector<Writer> frames;
    for (const std::string format : {"png", "exr", "obj", "ply", "stl", "pbrt"}) {
        const std::vector<std::string> options = {"--frames", "OUT", "--format", format, "--size",    "16x12",
                                                  "--every",  "2",   "--samples", "1",   "--threads", "1", "-q"};
        Writer tea{"Tea_" + format, {"tea", "--grid", "12", "--seconds", "0.134", "--checkpoint", "0"}, false};
        Writer tank{"Tank_" + format, {"tank", "IN/tank.json", "--seconds", "0.134", "--checkpoint", "0"}, false};
        for (Writer* writer : {&tea, &tank}) {
            writer->arguments.insert(writer->arguments.end(), options.begin(), options.end());
            frames.push_back(*writer);
        }
    }
    return frames;
}

std::vector<std::string> small(std::vector<std::string> arguments) {
    for (const char* option : {"--canvas", "20x16mm", "--px-per-mm", "2", "--seconds", "0.1", "-q"})
        arguments.emplace_back(option);
    return arguments;
}

std::vector<Writer> make_writers() {
    std::vector<Writer> all = {
        {"Replay", small({"replay", "IN/strokes.dat", "-o", "OUT/a.png", "--well", "OUT/well.png", "--save",
                          "OUT/a.pastoso", "--stats", "OUT/stats.json"})},
        {"ReplayFrames", small({"replay", "IN/strokes.dat", "--frames", "OUT"})},
        {"Convert", {"convert", "IN/picture.png", "-o", "OUT/a.pastoso", "--width-mm", "10", "-q"}},
        {"Timelapse", {"timelapse", "IN/small.pastoso", "-o", "OUT", "--fps", "10", "--speed", "1", "-q"}, false},
        {"Video_mp4", {"timelapse", "IN/small.pastoso", "-o", "OUT/a.mp4", "--fps", "10", "--speed", "1", "-q"}},
        {"Video_mkv", {"timelapse", "IN/small.pastoso", "-o", "OUT/a.mkv", "--fps", "10", "--speed", "1", "-q"}},
        {"Simulate", {"simulate", "IN/slab.json", "-o", "OUT", "--stats", "OUT/stats.json", "-q"}},
        {"TeaCache", {"tea", "--grid", "12", "--seconds", "0.134", "--cache", "OUT", "--threads", "1", "-q"}, false},
    };
    for (const auto& group : {all_exports(), all_frames()})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

void run(const std::vector<std::string>& arguments) {
    const cli::RunResult result = cli::run_cli(arguments);
    if (result.status != 0) throw std::runtime_error("an input cannot be made: " + result.errors);
}

}  // namespace

std::ostream& operator<<(std::ostream& stream, const Writer& writer) {
    return stream << writer.name;
}

const std::vector<Writer>& writers() {
    static const std::vector<Writer> all = make_writers();
    return all;
}

void make_inputs(const std::filesystem::path& folder) {
    std::string strokes = "# seconds x y pressure\n";
    for (int i = 0; i < 10; ++i)
        strokes += "0.0" + std::to_string(i) + " " + std::to_string(5 + i) + " 8 " + (i < 9 ? "0.5" : "0") + "\n";
    core::write_text_file(folder / "strokes.dat", strokes);
    core::write_text_file(folder / "tank.json", R"({"format": "pastoso-tank", "version": 1, "cells": [8, 8, 8],
        "cell_m": 0.125, "liquids": [{"shape": {"block": {"low_m": [-1, -1, -1], "high_m": [0.5, 2, 0.5]}},
                                      "milk": 0.1}]})");
    core::write_text_file(folder / "slab.json", R"({"format": "pastoso-scene", "version": 1, "cell_units": true,
        "size_cells": [12, 8], "edges": "periodic", "paint": {"viscosity_cells2_s": 1},
        "gravity": {"normal_cells_s2": 1, "y_cells_s2": 0.3},
        "film": [{"kind": "slab", "thickness_cells": 2, "pigment": "PR108"}], "duration_s": 2,
        "output": {"series_every_s": 1, "picture_scale": 2, "profiles_along_y_at_x_cells": [6]}})");
    run(small({"replay", (folder / "strokes.dat").string(), "--save", (folder / "small.pastoso").string(), "-o",
               (folder / "picture.png").string()}));
}

}  // namespace pastoso::faults
