#include "cli/shared_arguments.hpp"

#include <CLI/CLI.hpp>

namespace pastoso::cli {

void add_picture_options(CLI::App& command, recordings::PictureOptions& options) {
    command
        .add_option("--light", options.light,
                    "The light that pictures are seen in: D65, D50, A, LED, or a CSV file of "
                    "wavelength_nm,power; the paint is the same")
        ->type_name("LIGHT")
        ->capture_default_str();
    command
        .add_option("--profile", options.profile,
                    "The colours of pictures: srgb, display-p3, or an ICC profile to convert them to; "
                    "it is embedded")
        ->type_name("PROFILE")
        ->capture_default_str();
    command
        .add_option("--depth", options.depth_bits,
                    "Bits of a channel in .png and .tif: 8 or 16; 32 for linear light in .tif")
        ->type_name("BITS")
        ->capture_default_str()
        ->check(CLI::IsMember({8, 16, 32}));
    command.add_option("--quality", options.quality, "Of .jpg and .webp: 1 small to 100 fine")
        ->type_name("Q")
        ->capture_default_str()
        ->check(CLI::Range(1, 100));
}

void add_scale_option(CLI::App& command, double& scale) {
    command.add_option("--scale", scale, "Pixels per cell of every picture")
        ->type_name("S")
        ->capture_default_str()
        ->check(CLI::Range(0.0625, 16.0));
}

void add_threads_option(CLI::App& command, int& threads) {
    command.add_option("--threads", threads, "Threads to use; 0: one per processor")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(0, 256));
}

void add_stats_option(CLI::App& command, std::string& path) {
    command.add_option("--stats", path, "Write times and counts as one JSON object")->type_name("FILE");
}

void add_quiet_flag(CLI::App& command, bool& quiet) {
    command.add_flag("-q,--quiet", quiet, "Show no progress");
}

void add_time_options(CLI::App& command, double& seconds, double& fps) {
    command.add_option("--seconds", seconds, "How long to watch")
        ->type_name("S")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 1e5));
    command.add_option("--fps", fps, "Frames a second")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1.0, 1000.0));
}

void add_checkpoint_option(CLI::App& command, double& seconds) {
    command
        .add_option("--checkpoint", seconds,
                    "Keep the state to go on from with the frames, after so many seconds of work; it is "
                    "kept at the end in any case")
        ->type_name("S")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 1e6));
}

void add_frame_file_options(CLI::App& command, FrameFileOptions& options,
                            const std::vector<std::string>& formats, const std::string& meaning) {
    command.add_option("--format", options.format, meaning)
        ->type_name("NAME")
        ->capture_default_str()
        ->check(CLI::IsMember(formats));
    command.add_option("--size", options.size, "Pixels of a picture")
        ->type_name("WxH")
        ->capture_default_str();
    command.add_option("--samples", options.samples, "Ways of light followed for a pixel")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 1 << 20));
    command.add_option("--every", options.every, "Make a file of every so many frames")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000000));
}

}  // namespace pastoso::cli
