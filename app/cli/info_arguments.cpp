#include "cli/arguments.hpp"
#include "cli/option.hpp"

namespace pastoso::cli {

void add_info(CLI::App& program, InfoOptions& options) {
    CLI::App& command = *program.add_subcommand(
        "info",
        "Describe a painting, a recording or an image, paints and colours, or the program itself");
    add_texts(command, "ABOUT", options.about,
              "A file; or \"paints\"; \"paint NAME\"; \"closest COLOUR\" for the recipe of a colour, "
              "out of the box or out of the paints named after it; \"palette FILE.gpl\". Without: "
              "version, brushes, pigments, media and supports")
        ->type_name("");
    command.footer(
        "Example:\n  pastoso-cli info strokes.json\n  pastoso-cli info paint PB29\n"
        "  pastoso-cli info closest \"#7a5c3e\" PW6 PY43 PBr7-BU PB29");
}

}  // namespace pastoso::cli
