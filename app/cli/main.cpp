#include "arguments/argument_fault.hpp"
#include "arguments/descriptions.hpp"
#include "cli/arguments.hpp"
#include "cli/convert.hpp"
#include "cli/export.hpp"
#include "cli/info.hpp"
#include "cli/interrupt.hpp"
#include "cli/options.hpp"
#include "cli/printing.hpp"
#include "cli/recover.hpp"
#include "cli/replay.hpp"
#include "cli/simulate.hpp"
#include "cli/tank.hpp"
#include "cli/tea.hpp"
#include "cli/thumbnail.hpp"
#include "cli/timelapse.hpp"
#include "cli/usage_error.hpp"
#include "cli/validate.hpp"
#include "core/fault.hpp"
#include "core/isa_request.hpp"
#include "core/memory.hpp"
#include "core/text.hpp"
#include "core/version.hpp"

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace pastoso::cli {
namespace {

enum ExitStatus { kDone = 0, kBadInput = 1, kBadUsage = 2 };

/// The first argument is a subcommand, or an option.
void check_subcommand(const CLI::App& app, const std::string& first) {
    if (first.starts_with('-')) return;
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        if (command->check_name(first)) return;
        names.push_back(command->get_name());
    }
    const std::string last = names.back();
    names.pop_back();
    throw UsageError("there is no subcommand \"" + first + "\", only " + core::listed(names) + " and " +
                     last + ".");
}

/// What --help and --version ask for.
int print_help(const CLI::App& app, const CLI::Success& wanted) {
    std::ostringstream text;
    const int status = app.exit(wanted, text);
    print("%s", text.str().c_str());
    return status;
}

int run(int argc, char** argv) {
    ReplayOptions replay, sheet;
    ExportOptions exporting;
    ConvertOptions convert;
    TimelapseOptions timelapse;
    RecoverOptions recover;
    ThumbnailOptions thumbnail;
    SimulateOptions simulate;
    ValidateOptions validate;
    TeaOptions tea;
    TeaRenderOptions tea_render;
    TankOptions tank;
    InfoOptions info;
    if (const std::string option = arguments::option_without_value(argc, argv); !option.empty())
        throw UsageError(option +
                         ": no value follows the \"=\" (pastoso-cli --help shows what there is).");
    CLI::App app("Paints with thick wet paint, without a screen.", "pastoso-cli");
    app.set_version_flag("--version", std::string("pastoso-cli ") + core::version());
    arguments::add_descriptions(app, {core::version(), core::version_date()});
    app.require_subcommand(1);
    add_replay(app, replay);
    add_sheet(app, sheet);
    add_export(app, exporting);
    add_convert(app, convert);
    add_timelapse(app, timelapse);
    add_recover(app, recover);
    add_thumbnail(app, thumbnail);
    add_simulate(app, simulate);
    add_validate(app, validate);
    add_tea(app, tea, tea_render);
    add_tank(app, tank);
    add_info(app, info);
    // Now that there are no more subcommands to which it would be handed down.
    app.footer("Example:\n  pastoso-cli replay strokes.json -o picture.png");
    if (argc > 1) check_subcommand(app, argv[1]);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& wanted) {
        return print_help(app, wanted);
    } catch (const CLI::ParseError& error) {
        throw UsageError(arguments::argument_fault(app, error));
    }
    if (app.got_subcommand("replay"))
        run_replay(replay);
    else if (app.got_subcommand("sheet"))
        run_sheet(std::move(sheet));
    else if (app.got_subcommand("export"))
        run_export(exporting);
    else if (app.got_subcommand("convert"))
        run_convert(convert);
    else if (app.got_subcommand("timelapse"))
        run_timelapse(timelapse);
    else if (app.got_subcommand("recover"))
        run_recover(recover);
    else if (app.got_subcommand("thumbnail"))
        run_thumbnail(thumbnail);
    else if (app.got_subcommand("simulate"))
        run_simulate(simulate);
    else if (app.got_subcommand("validate"))
        run_validate(validate);
    else if (app.got_subcommand("tea"))
        app.get_subcommand("tea")->got_subcommand("render") ? run_tea_render(tea_render) : run_tea(tea);
    else if (app.got_subcommand("tank"))
        run_tank(tank);
    else
        run_info(info);
    return kDone;
}

int fail(const std::string& message, int status) {
    complain(message);
    return status;
}

}  // namespace
}  // namespace pastoso::cli

int main(int argc, char** argv) {
    using namespace pastoso::cli;
    pastoso::core::keep_freed_memory();
    outlive_failed_writes();
    try {
        pastoso::core::check_isa_request();
        const int status = run(argc, argv);
        stop_if_interrupted();
        finish_printing();
        return status;
    } catch (const UsageError& error) {
        return fail(error.what(), kBadUsage);
    } catch (const Interrupted&) {
        return fail("stopped.", interrupted_status());
    } catch (...) {
        return fail(pastoso::core::caught_fault().text(), kBadInput);
    }
}
