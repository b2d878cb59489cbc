#include "faults/sweep.hpp"

#include "cli/run_program.hpp"
#include "core/resources.hpp"
#include "core/text_file.hpp"
#include "files/json_place.hpp"

#include <algorithm>
#include <cstdlib>
#include <regex>

#include <gtest/gtest.h>

namespace pastoso::faults {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

constexpr const char* kOld = "an old file";

Files files_in(const fs::path& folder) {
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files[entry.path().lexically_relative(folder).string()] = core::read_text_file(entry.path());
    return files;
}

/// TIFF and EXR say when they were written, a tank's table how long its steps took, in the last column.
std::string without_times(const std::string& name, const std::string& text) {
    static const std::regex kDate("\\d{4}:\\d\\d:\\d\\d \\d\\d:\\d\\d:\\d\\d"),
        kLastColumn(",[^,\n]*\n");
    return std::regex_replace(text, name == "series.csv" ? kLastColumn : kDate, "");
}

/// A run's figures in JSON and a tank's checkpoint say how long it took too; the next run shows whether
/// a checkpoint can be read.
bool is_same(const std::string& name, const std::string& one, const std::string& other) {
    if (one == other) return true;
    if (name.ends_with(".tank")) return !one.empty();
    if (files::Json::accept(one)) return files::Json::accept(other);
    return without_times(name, one) == without_times(name, other);
}

/// What fails below the folder of outputs.
class Faults {
  public:
    Faults(const fs::path& folder, const fs::path& count, const std::string& call,
           const std::string& bytes) {
        set("PASTOSO_FAULTS_IN", folder.string());
        set("PASTOSO_FAULTS_COUNT", count.string());
        set("PASTOSO_FAULTS_CALL", call);
        set("PASTOSO_FAULTS_BYTES", bytes);
        set("LD_PRELOAD", (core::program_folder() / "disk-faults.so").string());
    }
    ~Faults() {
        for (const char* name : names_)
            ::unsetenv(name);
    }
    Faults(const Faults&) = delete;
    Faults& operator=(const Faults&) = delete;

  private:
    void set(const char* name, const std::string& value) {
        ::setenv(name, value.c_str(), 1);
        names_.push_back(name);
    }
    std::vector<const char*> names_;
};

}  // namespace

Sweep::Sweep(const Writer& writer, const fs::path& inputs)
    : writer_(writer), inputs_(inputs), outputs_(folder_.path() / "out") {
    fs::create_directory(outputs_);
    const cli::RunResult result = run("0", "");
    EXPECT_EQ(result.status, 0) << writer.name << ": " << result.errors;
    new_ = files_in(outputs_);
    EXPECT_FALSE(new_.empty()) << writer.name;
    calls_ = std::stol(core::read_text_file(folder_.path() / "count"));
    for (const auto& [name, text] : new_)
        bytes_ += static_cast<long>(text.size());
}

void Sweep::fail_call(long call) const {
    SCOPED_TRACE(writer_.name + ", call " + std::to_string(call) + " of " + std::to_string(calls_));
    fail(std::to_string(call), "");
}

void Sweep::fail_behind(long bytes) const {
    SCOPED_TRACE(writer_.name + ", room for " + std::to_string(bytes) + " of " + std::to_string(bytes_) +
                 " bytes");
    fail("0", std::to_string(bytes));
}

void Sweep::fail(const std::string& call, const std::string& bytes) const {
    put_old_files();
    check_sentence(run(call, bytes));
    check_files(false);
    const cli::RunResult again = run("0", "");
    EXPECT_EQ(again.status, 0) << again.errors;
    check_files(true);
    if (writer_.replaces) return;
    const cli::RunResult from_there = run("0", "");
    EXPECT_EQ(from_there.status, 0) << from_there.errors;
    check_files(true);
}

void Sweep::put_old_files() const {
    fs::remove_all(outputs_);
    fs::create_directory(outputs_);
    for (const auto& [name, text] : new_) {
        if (!writer_.replaces) return;
        fs::create_directories((outputs_ / name).parent_path());
        core::write_text_file(outputs_ / name, kOld);
    }
}

cli::RunResult Sweep::run(const std::string& call, const std::string& bytes) const {
    const Faults faults(outputs_, folder_.path() / "count", call, bytes);
    return cli::run_cli(arguments());
}

std::vector<std::string> Sweep::arguments() const {
    std::vector<std::string> arguments = writer_.arguments;
    for (std::string& argument : arguments) {
        if (argument.starts_with("IN/")) argument = inputs_.string() + argument.substr(2);
        if (argument.starts_with("OUT")) argument = outputs_.string() + argument.substr(3);
    }
    return arguments;
}

void Sweep::check_sentence(const cli::RunResult& run) const {
    EXPECT_GT(run.status, 0) << "the fault was not told";
    EXPECT_LT(run.status, 128) << "ended by a signal";
    EXPECT_TRUE(run.errors.starts_with("pastoso-cli: ")) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_EQ(run.errors.find(".part"), std::string::npos) << run.errors;
}

/// A writer that goes on where it was stopped may leave the checkpoint or the table of a part of its
/// way.
void Sweep::check_files(bool new_alone) const {
    for (const auto& [name, text] : files_in(outputs_)) {
        ASSERT_TRUE(new_.contains(name)) << name << " is litter";
        const bool is_old = text == kOld || !writer_.replaces;
        EXPECT_TRUE(is_same(name, text, new_.at(name)) || (is_old && !new_alone))
            << name << (new_alone ? " is not the new file" : " is neither the old file nor the new one");
    }
}

}  // namespace pastoso::faults
