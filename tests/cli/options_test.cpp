// Every option of every subcommand, as its help lists it, and what it may not be given.
#include "cli/help_page.hpp"
#include "cli/run_program.hpp"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// What stands for texts in help; whatever else an option takes is a number.
const std::set<std::string> kTexts = {"FILE",
                                      "DIR",
                                      "DIR|FILE",
                                      "NAME",
                                      "PAINT",
                                      "PROFILE",
                                      "LIGHT",
                                      "WxHmm",
                                      "WxH",
                                      "A-B",
                                      "medium|surface",
                                      "paint|support",
                                      "explicit|large|both"};

/// What the program says to this value, given as two words or as one. What it must have stands before.
RunResult run_with(const Words& command, const Words& value) {
    Words words = command;
    if (command.front() == "convert")
        words.insert(words.end(), {"a.png", "b.pastoso"});
    else if (command.back() != "recover" && command.back() != "tea" && command.back() != "sheet")
        words.emplace_back("none");
    words.insert(words.end(), value.begin(), value.end());
    return run_cli(words);
}

void expect_refusal(const RunResult& run, const Words& command, const std::string& option,
                    const std::string& value) {
    EXPECT_EQ(run.status, 2) << command.back() << " " << option << " " << value << ": " << run.errors;
    EXPECT_EQ(run.output, "");
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_THAT(run.errors, AllOf(HasSubstr(option), HasSubstr(value))) << command.back();
}

TEST(CliOptions, NumbersAreFiniteAndWithinTheirRange) {
    int numbers = 0;
    for (const Words& command : commands()) {
        for (const Option& option : options_of(command)) {
            if (option.type.empty() || kTexts.count(option.type) > 0) continue;
            ++numbers;
            for (const std::string value : {"nan", "inf", "-inf", "1e400", "1e308", ""})
                expect_refusal(run_with(command, {option.name, value}), command, option.name,
                               "\"" + value + "\"");
            expect_refusal(run_with(command, {option.name + "=nan"}), command, option.name, "\"nan\"");
        }
    }
    // As many as there were when this was written: that they are found at all.
    EXPECT_GE(numbers, 50);
}

TEST(CliOptions, AnEqualsSignDoesNotTakeTheNextWord) {
    for (const Words& command : commands())
        for (const Option& option : options_of(command))
            expect_refusal(run_with(command, {option.name + "=", "word"}), command, option.name,
                           "no value follows the \"=\"");
}

TEST(CliOptions, TextsAreNotEmpty) {
    for (const Words& command : commands())
        for (const Option& option : options_of(command))
            if (kTexts.count(option.type) > 0)
                expect_refusal(run_with(command, {option.name, ""}), command, option.name, "\"\"");
}

TEST(CliOptions, NumbersWithinTextsAreFiniteToo) {
    for (const std::string size : {"nanx20", "20xinf", "1e400x20mm"})
        expect_refusal(run_cli({"replay", "none", "--canvas", size}), {"replay"}, "--canvas", size);
    for (const std::string paint : {"PB29=nan", "PB29@inf"})
        expect_refusal(run_cli({"replay", "none", "--paint", paint}), {"replay"}, "--paint", paint);
    for (const std::string size : {"nanx20", "99999999999x5", "1e2x5"})
        expect_refusal(run_cli({"tea", "--frames", "none", "--size", size}), {"tea"}, "--size", size);
}

}  // namespace
}  // namespace pastoso::cli
