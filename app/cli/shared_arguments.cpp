#include "cli/shared_arguments.hpp"

#include "cli/option.hpp"

namespace pastoso::cli {

void add_picture_options(CLI::App& command, recordings::PictureOptions& options) {
    add_text(command, "--light", options.light,
             "The light that pictures are seen in: D65, D50, A, LED, or a CSV file of "
             "wavelength_nm,power; the paint is the same")
        ->type_name("LIGHT")
        ->capture_default_str();
    add_text(command, "--profile", options.profile,
             "The colours of pictures: srgb, display-p3, or an ICC profile to convert them to; "
             "it is embedded")
        ->type_name("PROFILE")
        ->capture_default_str();
    add_number(command, "--depth", options.depth_bits, {8, 32},
               "Bits of a channel in .png and .tif: 8 or 16; 32 for linear light in .tif")
        ->type_name("BITS")
        ->capture_default_str()
        ->check(CLI::IsMember({8, 16, 32}));
    add_number(command, "--quality", options.quality, {1, 100}, "Of .jpg and .webp: 1 small to 100 fine")
        ->type_name("Q")
        ->capture_default_str();
}

void add_scale_option(CLI::App& command, double& scale) {
    add_number(command, "--scale", scale, {0.0625, 16.0}, "Pixels per cell of every picture")
        ->type_name("S")
        ->capture_default_str();
}

void add_threads_option(CLI::App& command, int& threads) {
    add_number(command, "--threads", threads, {0, 256}, "Threads to use; 0: one per processor")
        ->type_name("N")
        ->capture_default_str();
}

void add_stats_option(CLI::App& command, std::string& path) {
    add_text(command, "--stats", path, "Write times and counts as one JSON object")->type_name("FILE");
}

void add_quiet_flag(CLI::App& command, bool& quiet) {
    command.add_flag("-q,--quiet", quiet, "Show no progress");
}

void add_time_options(CLI::App& command, double& seconds, double& fps) {
    add_number(command, "--seconds", seconds, {0.0, 1e5}, "How long to watch")
        ->type_name("S")
        ->capture_default_str();
    add_number(command, "--fps", fps, {1.0, 1000.0}, "Frames a second")
        ->type_name("N")
        ->capture_default_str();
}

void add_checkpoint_option(CLI::App& command, double& seconds) {
    add_number(command, "--checkpoint", seconds, {0.0, 1e6},
               "Keep the state to go on from with the frames, after so many seconds of work; it is "
               "kept at the end in any case")
        ->type_name("S")
        ->capture_default_str();
}

void add_frame_file_options(CLI::App& command, FrameFileOptions& options,
                            const std::vector<std::string>& formats, const std::string& meaning) {
    add_text(command, "--format", options.format, meaning)
        ->type_name("NAME")
        ->capture_default_str()
        ->check(CLI::IsMember(formats));
    add_text(command, "--size", options.size, "Pixels of a picture")
        ->type_name("WxH")
        ->capture_default_str();
    add_number(command, "--samples", options.samples, {1, 1 << 20},
               "Ways of light followed for a pixel, fewer where it is clean before")
        ->type_name("N")
        ->capture_default_str();
    add_number(command, "--every", options.every, {1, 1000000}, "Make a file of every so many frames")
        ->type_name("N")
        ->capture_default_str();
}

}  // namespace pastoso::cli
