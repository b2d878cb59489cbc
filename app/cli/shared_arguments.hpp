// Options that several subcommands have.
#pragma once

#include "io/picture_style.hpp"

namespace CLI {
class App;
}

namespace pastoso::cli {

void add_picture_options(CLI::App& command, io::PictureOptions& options);
void add_scale_option(CLI::App& command, double& scale);
void add_threads_option(CLI::App& command, int& threads);

}  // namespace pastoso::cli
