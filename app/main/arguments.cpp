#include "main/arguments.hpp"

#include "arguments/argument_fault.hpp"
#include "arguments/descriptions.hpp"
#include "core/printable.hpp"
#include "core/version.hpp"

#include <charconv>
#include <cstdio>
#include <string>

#include <CLI/CLI.hpp>

namespace pastoso::main {

namespace {

void complain(const std::string& sentence) {
    std::fprintf(stderr, "pastoso: %s\n", core::printable(sentence).c_str());
}

/// CLI11's own range lets pass what is no number.
std::string delay_problem(const std::string& text) {
    constexpr double kLongest_s = 86400.0;
    double delay_s = 0.0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), delay_s);
    const bool whole = result.ec == std::errc() && result.ptr == text.data() + text.size();
    if (whole && delay_s >= 0.0 && delay_s <= kLongest_s) return {};
    return "\"" + text + "\" is no number from 0 to 86400";
}

}  // namespace

ParsedArguments parse_arguments(int argc, char** argv) {
    ParsedArguments parsed;
    Arguments& arguments = parsed.arguments;
    CLI::App app("Paint with thick wet paint. Without a file, an easel stands ready to paint on.",
                 "pastoso");
    app.set_version_flag("--version", std::string("pastoso ") + core::version());
    arguments::add_descriptions(app, {core::version(), core::version_date()});
    app.add_option(
        "file", arguments.file,
        "A painting (.pastoso) to go on with, a picture to begin with, or a recording (.json) to replay "
        "into the window");
    auto* screenshot = app.add_option("--screenshot", arguments.screenshot,
                                      "Save a picture of the window to this file and leave")
                           ->type_name("FILE");
    app.add_option("--after", arguments.after_s, "Seconds to wait before the screenshot")
        ->type_name("S")
        ->capture_default_str()
        ->check(CLI::Validator(delay_problem, "0 to 86400"))
        ->needs(screenshot);
    app.add_flag("--profile", arguments.profile,
                 "Tell at the end how long strokes took to the painting and to the screen");
    if (const std::string option = arguments::option_without_value(argc, argv); !option.empty()) {
        complain(option + ": no value follows the \"=\" (pastoso --help shows what there is).");
        parsed.exit_status = 2;
        return parsed;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& wanted) {
        parsed.exit_status = app.exit(wanted);
    } catch (const CLI::ParseError& error) {
        complain(arguments::argument_fault(app, error));
        parsed.exit_status = 2;
    }
    return parsed;
}

}  // namespace pastoso::main
