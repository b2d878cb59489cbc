// The subcommands as the command line has them: their options, and what help says of them.
#pragma once

#include "cli/options.hpp"

namespace CLI {
class App;
}

namespace pastoso::cli {

// Each adds its subcommand to the program; what is parsed goes to `options`, which outlive it.

void add_replay(CLI::App& program, ReplayOptions& options);
void add_sheet(CLI::App& program, ReplayOptions& options);
void add_export(CLI::App& program, ExportOptions& options);
void add_convert(CLI::App& program, ConvertOptions& options);
void add_timelapse(CLI::App& program, TimelapseOptions& options);
void add_recover(CLI::App& program, RecoverOptions& options);
void add_thumbnail(CLI::App& program, ThumbnailOptions& options);
void add_simulate(CLI::App& program, SimulateOptions& options);
void add_validate(CLI::App& program, ValidateOptions& options);
void add_tea(CLI::App& program, TeaOptions& options, TeaRenderOptions& render);
void add_tank(CLI::App& program, TankOptions& options);
void add_info(CLI::App& program, InfoOptions& options);

}  // namespace pastoso::cli
