// Options that several subcommands have.
#pragma once

#include "cli/options.hpp"
#include "recordings/picture_style.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pastoso::cli {

void add_picture_options(CLI::App& command, recordings::PictureOptions& options);
void add_scale_option(CLI::App& command, double& scale);
void add_threads_option(CLI::App& command, int& threads);
void add_stats_option(CLI::App& command, std::string& path);
void add_quiet_flag(CLI::App& command, bool& quiet);

/// --seconds and --fps, and --checkpoint, of subcommands that simulate a liquid.
void add_time_options(CLI::App& command, double& seconds, double& fps);
void add_checkpoint_option(CLI::App& command, double& seconds);

/// --format, --size, --samples and --every, of subcommands that make files of frames. `formats` are
/// those there are; `meaning` says what they hold.
void add_frame_file_options(CLI::App& command, FrameFileOptions& options,
                            const std::vector<std::string>& formats, const std::string& meaning);

}  // namespace pastoso::cli
