#include "main/arguments.hpp"

#include "arguments/argument_fault.hpp"

#include <cstdio>

#include <CLI/CLI.hpp>

namespace pastoso::main {

ParsedArguments parse_arguments(int argc, char** argv) {
    ParsedArguments parsed;
    Arguments& arguments = parsed.arguments;
    CLI::App app("Paint with thick wet paint. Without a file, an easel stands ready to paint on.",
                 "pastoso");
    app.set_version_flag("--version", "pastoso " PASTOSO_VERSION);
    app.add_option(
        "file", arguments.file,
        "A painting (.pastoso) to go on with, or a recording (.json) to replay into the window");
    auto* screenshot = app.add_option("--screenshot", arguments.screenshot,
                                      "Save a picture of the window to this file and leave");
    app.add_option("--after", arguments.after_s, "Seconds to wait before the screenshot")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 86400.0))
        ->needs(screenshot);
    app.add_flag("--profile", arguments.profile,
                 "Tell at the end how long strokes took to the painting and to the screen");
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& wanted) {
        parsed.exit_status = app.exit(wanted);
    } catch (const CLI::ParseError& error) {
        std::fprintf(stderr, "pastoso: %s\n", arguments::argument_fault(app, error).c_str());
        parsed.exit_status = 2;
    }
    return parsed;
}

}  // namespace pastoso::main
