#include "cli/arguments.hpp"
#include "cli/option.hpp"
#include "cli/shared_arguments.hpp"

namespace pastoso::cli {

void add_validate(CLI::App& program, ValidateOptions& options) {
    CLI::App& command = *program.add_subcommand(
        "validate", "Hold the solver of paint against laws that are known exactly");
    add_texts(command, "CASE", options.cases, "Cases to run (default: all; --list names them)")
        ->type_name("");
    command.add_flag("--list", options.list, "Show the cases with their laws, and run none");
    add_text(command, "--scheme", options.scheme, "How time is stepped")
        ->type_name("explicit|large|both")
        ->capture_default_str()
        ->check(CLI::IsMember({"explicit", "large", "both"}));
    command.add_flag("--long", options.with_long, "Runs of minutes, too");
    add_text(command, "-o,--output", options.output,
             "Folder for the table (.csv, .md) and a plot of each case (.svg)")
        ->type_name("DIR");
    add_threads_option(command, options.threads);
    add_quiet_flag(command, options.quiet);
    command.footer(
        "docs/physics.md tells what came out.\n"
        "Example:\n  pastoso-cli validate nusselt-film slope-current -o validation");
}

}  // namespace pastoso::cli
