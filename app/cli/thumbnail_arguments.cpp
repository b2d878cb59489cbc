#include "cli/arguments.hpp"
#include "cli/option.hpp"

namespace pastoso::cli {

void add_thumbnail(CLI::App& program, ThumbnailOptions& options) {
    CLI::App& command = *program.add_subcommand(
        "thumbnail", "Take the small picture out of a painting, for file managers");
    add_text(command, "PAINTING", options.project, "A painting (.pastoso)")->required();
    add_text(command, "-o,--output", options.output, "The picture, a PNG file whatever its name is")
        ->type_name("FILE")
        ->required();
    add_number(command, "--size", options.longest_px, {1, 4096},
               "Pixels of its longest side, at most; it has no more than 256")
        ->type_name("N")
        ->capture_default_str();
    command.footer("Example:\n  pastoso-cli thumbnail painting.pastoso -o small.png --size 128");
}

}  // namespace pastoso::cli
