#include "cli/arguments.hpp"
#include "cli/option.hpp"
#include "cli/shared_arguments.hpp"

namespace pastoso::cli {

void add_recover(CLI::App& program, RecoverOptions& options) {
    CLI::App& command = *program.add_subcommand(
        "recover", "Bring back paintings that were not saved when the window was stopped");
    add_text(command, "NAME", options.name, "Which one, as --list names it (default: the latest)");
    command.add_flag("--list", options.list, "Show what there is");
    add_text(command, "-o,--output", options.output,
             "Paint it again and keep it as a project file, FILE.pastoso")
        ->type_name("FILE");
    command.add_flag("--discard", options.discard, "Forget it for good");
    command.add_flag("--keep", options.keep, "With -o: leave it to be recovered again");
    add_threads_option(command, options.threads);
    add_quiet_flag(command, options.quiet);
    command.footer("Example:\n  pastoso-cli recover -o recovered.pastoso");
}

}  // namespace pastoso::cli
